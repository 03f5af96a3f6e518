"""Reads house.ifc files with IfcOpenShell and says what they hold, as one JSON object on stdout.

Usage: python ifc_check.py HOUSE.ifc...   (takeoff.json, parts.json and structure.json are read beside each file where they are there)

Every finding is a sentence in "faults"; a sound file has none. Checked here, against IfcOpenShell's own schema, templates and kernel:
validation with the EXPRESS rules, geometry of every product, volumes, sums of quantities, names, property and quantity templates.
"""
import json
import logging
import math
import os
import sys
import time
from collections import defaultdict

import ifcopenshell
import ifcopenshell.geom
import ifcopenshell.util.element as element
import ifcopenshell.util.pset
import ifcopenshell.util.shape
import ifcopenshell.validate

# Sums of quantities against the take-off, relative to the row: both are sums of the same doubles in another order.
SUM = 1e-6
# Volume of the meshes that IfcOpenShell makes against ours: coordinates are written to the nanometre and its kernel welds at 1e-5 m.
VOLUME = 1e-4
# Steel sections: tabulated areas are rounded to three figures, and round corners are cut into chords by the kernel.
STEEL = 2e-2

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
SPATIAL = ("IfcSite", "IfcBuilding", "IfcBuildingStorey")


class Log(logging.Handler):
    def __init__(self):
        super().__init__()
        self.lines = []

    def emit(self, record):
        self.lines.append(record.getMessage()[:300])


def validation(path):
    handler, logger = Log(), logging.getLogger(path)
    logger.addHandler(handler)
    logger.propagate = False
    # With the file itself its header is checked too.
    ifcopenshell.validate.validate(path, logger, express_rules=True)
    return handler.lines


def quantities(product):
    """{set: {name: (value, note)}}, without what a type says."""
    found = {}
    for relation in getattr(product, "IsDefinedBy", ()):
        definition = relation.RelatingPropertyDefinition
        if definition.is_a("IfcElementQuantity"):
            found[definition.Name] = {q.Name: (q[3], q.Description) for q in definition.Quantities}
    return found


def shape(product, settings, representation=None):
    try:
        if representation is None:
            return ifcopenshell.geom.create_shape(settings, product)
        return ifcopenshell.geom.create_shape(settings, product, representation)
    except RuntimeError as error:
        return str(error)


def beside(path, name):
    other = os.path.join(os.path.dirname(path), name)
    if not os.path.exists(other):
        return None
    with open(other) as file:
        return json.load(file)


def check(path):
    begun = time.time()
    faults, counts = [], defaultdict(int)
    faults += [f"validate: {line}" for line in validation(path)]
    validated = time.time() - begun
    model = ifcopenshell.open(path)
    ids = [root.GlobalId for root in model.by_type("IfcRoot")]
    if len(ids) != len(set(ids)) or any(len(i) != 22 for i in ids):
        faults.append("GlobalIds are not unique or not 22 characters long")
    faults += spatial(model)
    products, volumes, boxes = geometry(model, faults, counts)
    sums, standard = takeoff_sums(model, faults)
    faults += templates(model)
    rows = beside(path, "takeoff.json")
    if rows is not None:
        faults += against_rows(rows, sums, standard, model)
    faults += names(model, beside(path, "parts.json"), beside(path, "structure.json"))
    faults += relations(model)
    return {
        "file": path,
        "bytes": os.path.getsize(path),
        "faults": faults,
        "counts": dict(sorted(counts.items())),
        "validate_s": round(validated, 2),
        "all_s": round(time.time() - begun, 2),
        "volume_m3": round(sum(volumes.values()), 6),
        "bounds_m": [[min(b[0][a] for b in boxes) for a in range(3)], [max(b[1][a] for b in boxes) for a in range(3)]],
        "storeys": [[s.Name, s.Elevation] for s in model.by_type("IfcBuildingStorey")],
        "sums": {item: sums[item] for item in sorted(sums)},
    }


def spatial(model):
    faults = []
    for kind in ("IfcProject", "IfcSite", "IfcBuilding"):
        if len(model.by_type(kind)) != 1:
            faults.append(f"{len(model.by_type(kind))} {kind}")
    for product in model.by_type("IfcElement"):
        if not product.is_a("IfcOpeningElement") and element.get_container(product, should_get_direct=True) is None:
            faults.append(f"{product.Name} stands in no storey")
    return faults


def geometry(model, faults, counts):
    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    products, volumes, boxes = [], {}, []
    for product in model.by_type("IfcProduct"):
        counts[product.is_a()] += 1
        if product.is_a() in SPATIAL:
            continue
        products.append(product)
        reference = None
        if product.is_a("IfcOpeningElement"):
            (reference,) = product.Representation.Representations
        made = shape(product, settings, reference)
        if isinstance(made, str):
            faults.append(f"{product.Name}: no geometry: {made}")
            continue
        mesh = made.geometry
        if reference is not None:
            if abs(ifcopenshell.util.shape.get_volume(mesh) / quantities(product)["Qto_OpeningElementBaseQuantities"]["Volume"][0] - 1) > VOLUME:
                faults.append(f"{product.Name}: its box has another volume than its quantity")
            continue
        if len(mesh.faces) == 0:
            faults.append(f"{product.Name}: geometry without faces")
            continue
        if not mesh.materials or any(not m.has_transparency and m.diffuse is None for m in mesh.materials):
            faults.append(f"{product.Name}: no colour")
        points = ifcopenshell.util.shape.get_vertices(mesh)
        boxes.append((points.min(axis=0).tolist(), points.max(axis=0).tolist()))
        expected = own_volume(product)
        if expected is None:
            continue
        found = ifcopenshell.util.shape.get_volume(mesh)
        volumes[product.GlobalId] = found
        steel = "Houscaper_Member" in element.get_psets(product) and element.get_psets(product)["Houscaper_Member"]["Material"].startswith("S")
        if abs(found - expected) > max((STEEL if steel else VOLUME) * abs(expected), 1e-6):
            faults.append(f"{product.is_a()} {product.Name}: volume {found:.6f} m3, said to be {expected:.6f}")
    return products, volumes, boxes


def own_volume(product):
    """What the file itself says the volume is; None for what is drawn as a surface."""
    own = quantities(product)
    for kind in ("Beam", "Column", "Member"):
        named = own.get(f"Qto_{kind}BaseQuantities")
        if named:
            return named["NetVolume"][0]
    return element.get_psets(product).get("Houscaper_Part", {}).get("SolidVolume")


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


def templates(model):
    """Every Pset_ and Qto_ is one of IFC4, on a class it is for, and holds nothing but what its template names, in the right type."""
    faults, known = set(), ifcopenshell.util.pset.get_template("IFC4")
    for relation in model.by_type("IfcRelDefinesByProperties"):
        definition = relation.RelatingPropertyDefinition
        if definition.Name.startswith("Houscaper_"):
            continue
        template = known.get_by_name(definition.Name)
        if template is None:
            faults.add(f"{definition.Name}: not a set of IFC4")
            continue
        for thing in relation.RelatedObjects:
            fitting = [t.Name for t in known.get_applicable(thing.is_a())]
            if definition.Name not in fitting:
                faults.add(f"{definition.Name}: not for {thing.is_a()}")
        allowed = {p.Name: p for p in template.HasPropertyTemplates}
        if definition.is_a("IfcElementQuantity"):
            for quantity in definition.Quantities:
                kind = "Q_" + quantity.is_a()[len("IfcQuantity"):].upper()
                if quantity.Name not in allowed or allowed[quantity.Name].TemplateType != kind:
                    faults.add(f"{definition.Name}.{quantity.Name} {quantity.is_a()}: not in the template")
        else:
            for entry in definition.HasProperties:
                kind = entry.NominalValue.is_a()
                if entry.Name not in allowed or allowed[entry.Name].PrimaryMeasureType != kind:
                    faults.add(f"{definition.Name}.{entry.Name} {kind}: not in the template")
    return sorted(faults)


def names(model, parts, structure):
    """Marks of parts and numbers of members are there, once each, and nothing else has one."""
    faults = []
    tags = defaultdict(list)
    for product in model.by_type("IfcElement"):
        if not product.is_a("IfcOpeningElement"):
            tags[product.Tag].append(product)
    faults += [f"{tag}: {len(own)} products have this tag" for tag, own in tags.items() if len(own) > 1]
    if parts is not None:
        marked = {part["mark"]: part for part in parts["parts"]}
        for product in model.by_type("IfcElement"):
            said = element.get_psets(product).get("Houscaper_Part", {})
            mark = said.get("PieceMark")
            if mark is None:
                continue
            if mark not in marked or marked[mark]["type"] != said["TypeMark"] or marked[mark]["kind"] != said["PartKind"]:
                faults.append(f"{product.Name}: mark {mark} is another part in parts.json")
            if not product.Name.split(".")[0] == mark:
                faults.append(f"{product.Name}: is called otherwise than its mark {mark}")
        solid = any(element.get_psets(p).get("Houscaper_Part", {}).get("SolidVolume") for p in model.by_type("IfcWall"))
        faults += [f"part {mark} has no product" for mark in marked if solid and mark not in tags]
    if structure is not None and "members" in structure:
        known = {str(m["member"] if "member" in m else m["id"]): m for m in structure["members"]}
        drawn = {p.Tag: p for p in model.by_type("IfcElement") if "Houscaper_Member" in element.get_psets(p)}
        if set(known) != set(drawn):
            faults.append(f"members of structure.json and of the model differ: {sorted(set(known) ^ set(drawn))[:5]}")
        for tag, product in drawn.items():
            said = element.get_psets(product)["Houscaper_Member"]
            if tag in known and (product.Name != f"{said['Role']} {tag}" or known[tag].get("role", said["Role"]) != said["Role"]):
                faults.append(f"{product.Name}: member {tag} has another role in structure.json")
    return faults


def relations(model):
    """Windows and doors fill an opening of a wall that is there; every product is made of something; price and carbon are whole."""
    faults = []
    walls = {wall for wall in model.by_type("IfcWall")}
    # A surface has no thickness to be voided.
    solid = any(element.get_psets(wall).get("Houscaper_Part", {}).get("SolidVolume") for wall in walls)
    for opening in model.by_type("IfcOpeningElement"):
        if opening.VoidsElements[0].RelatingBuildingElement not in walls:
            faults.append(f"{opening.Name}: voids no wall")
    for product in model.by_type("IfcElement"):
        if product.is_a("IfcOpeningElement"):
            continue
        if element.get_material(product) is None:
            faults.append(f"{product.Name}: made of nothing")
        if solid and product.is_a() in ("IfcWindow", "IfcDoor") and not product.FillsVoids:
            faults.append(f"{product.Name}: fills no opening")
    totals = defaultdict(float)
    for product in list(model.by_type("IfcElement")):
        own = element.get_psets(product)
        totals["price"] += own.get("Houscaper_Price", {}).get("Materials", 0.0)
        totals["carbon"] += own.get("Houscaper_Carbon", {}).get("FossilA1A3", 0.0)
        if "Houscaper_Price" in own and not own["Houscaper_Price"].get("PriceBookDate"):
            faults.append(f"{product.Name}: a price without date")
    for building in model.by_type("IfcBuilding"):
        own = element.get_psets(building)
        if "Houscaper_Price" not in own or quantities(building).get("Houscaper_TakeOff"):
            continue
        for key, whole in (("price", own["Houscaper_Price"]["MaterialsOfProducts"]), ("carbon", own["Houscaper_Carbon"]["FossilA1A3"])):
            if not math.isclose(totals[key], whole, rel_tol=1e-9):
                faults.append(f"{key}: products sum to {totals[key]}, the building says {whole}")
    return faults


if __name__ == "__main__":
    results = [check(path) for path in sys.argv[1:]]
    print(json.dumps(results, indent=1))
    sys.exit(1 if any(r["faults"] for r in results) else 0)
