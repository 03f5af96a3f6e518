"""Quantities of an IFC file against the rows of its take-off."""
from collections import defaultdict

# Sums of quantities against the take-off, relative to the row: both are sums of the same doubles in another order.
SUM = 1e-6

# The items of the take-off that each standard quantity is the sum of (src/export/ifc/mod.rs).
STANDARD = {
    ("Qto_WallBaseQuantities", "NetSideArea"): ["wall", "wall_both_sides", "floor_band", "parapet"],
    ("Qto_SlabBaseQuantities", "NetArea"): ["inner_floor", "deck", "flat_roof", "ground"],
    ("Qto_RoofBaseQuantities", "NetArea"): ["pitched_roof", "flat_roof", "deck", "inner_floor", "overhang"],
    ("Qto_CoveringBaseQuantities", "NetArea"): ["soffit", "plinth", "deck"],
    ("Qto_WindowBaseQuantities", "Area"): ["window"],
    ("Qto_RailingBaseQuantities", "Length"): ["railing"],
    ("Qto_PipeSegmentBaseQuantities", "Length"): ["gutter"],
    ("Qto_FootingBaseQuantities", "Length"): ["perimeter_beam"],
}
TIMBER = ["frame_c24", "frame_gl24h", "frame_gl28h"]
STEELS = ["frame_s235", "frame_s355"]


def quantities(product):
    """{set: {name: (value, note)}}, without what a type says."""
    found = {}
    for relation in getattr(product, "IsDefinedBy", ()):
        definition = relation.RelatingPropertyDefinition
        if definition.is_a("IfcElementQuantity"):
            found[definition.Name] = {q.Name: (q[3], q.Description) for q in definition.Quantities}
    return found


def takeoff_sums(model, faults):
    """Sums by line of the bill over everything, and the standard quantities by name."""
    sums, standard = defaultdict(float), defaultdict(float)
    for thing in model.by_type("IfcObject"):
        own = quantities(thing)
        shares = defaultdict(float)
        for name, (value, note) in own.get("Houscaper_TakeOff", {}).items():
            item, line = name.split(" ")[0], note.split(":")[0]
            sums[f"{line} {item}"] += value
            shares[item] += value
        for (group, name), items in STANDARD.items():
            if group in own:
                found = own[group].get(name, (0.0, None))[0]
                expected = sum(shares[item] for item in items)
                standard[group, name] += found
                if abs(found - expected) > SUM * max(1.0, abs(expected)):
                    faults.append(f"{thing.Name}: {group}.{name} {found}, its shares sum to {expected}")
        for kind in ("Beam", "Column", "Member"):
            named = own.get(f"Qto_{kind}BaseQuantities")
            if named is None:
                continue
            for items, name in ((TIMBER, "NetVolume"), (STEELS, "NetWeight")):
                for item in items:
                    if item in shares:
                        standard["frame", item] += named[name][0]
                        if abs(named[name][0] - shares[item]) > SUM * shares[item]:
                            faults.append(f"{thing.Name}: {name} {named[name][0]}, take-off {shares[item]}")
    return sums, standard


def against_rows(rows, sums, standard, model):
    faults = []
    named = set()
    by_item = defaultdict(float)
    for row in rows["lines"]:
        key = f"line {row['line']} {row['item']}"
        named.add(key)
        by_item[row["item"]] += row["quantity"]
        if abs(sums.get(key, 0.0) - row["quantity"]) > SUM * max(1.0, abs(row["quantity"])):
            faults.append(f"{key}: quantities sum to {sums.get(key, 0.0)}, the take-off says {row['quantity']}")
    faults += [f"{key}: no such row in the take-off" for key in sums if key not in named]
    # The building holds what no product shows; all else is in the standard quantities.
    rest = defaultdict(float)
    for building in model.by_type("IfcBuilding"):
        for name, (value, _) in quantities(building).get("Houscaper_TakeOff", {}).items():
            rest[name.split(" ")[0]] += value
    for item in TIMBER + STEELS:
        if by_item[item] and abs(standard["frame", item] - by_item[item]) > SUM * by_item[item]:
            faults.append(f"{item}: members sum to {standard['frame', item]}, the take-off says {by_item[item]}")
    items = {item for group in STANDARD.values() for item in group}
    found = sum(value for (group, _), value in standard.items() if group != "frame")
    extra = {row["item"] for row in rows["lines"]} & items
    expected = sum(by_item[item] - rest[item] for item in extra)
    if abs(found - expected) > SUM * expected and not strays(model):
        faults.append(f"standard quantities sum to {found}, the take-off without the building's to {expected}")
    for kind, item in (("IfcDoor", "door"), ("IfcStair", "stair")):
        if len(model.by_type(kind)) + rest[item] != by_item[item]:
            faults.append(f"{len(model.by_type(kind))} {kind}, the take-off counts {by_item[item]}")
    return faults


def strays(model):
    """Shares on products whose class has no standard quantity for them, such as a perimeter beam that only the slab shows."""
    sets = defaultdict(set)
    for (group, _), items in STANDARD.items():
        sets[group] |= set(items)
    covered = {item for items in sets.values() for item in items}
    for product in model.by_type("IfcElement"):
        own = quantities(product)
        held = {name.split(" ")[0] for name in own.get("Houscaper_TakeOff", {})} & covered
        if held - set().union(*(sets[group] for group in own if group in sets), set()):
            return True
    return False
