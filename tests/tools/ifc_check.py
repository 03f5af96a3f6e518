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

sys.dont_write_bytecode = True  # the repository stays as it is
from ifc_takeoff import against_rows, quantities, takeoff_sums

# Volume of the meshes that IfcOpenShell makes against ours: coordinates are written to the nanometre and its kernel welds at 1e-5 m.
VOLUME = 1e-4
# Steel sections: tabulated areas are rounded to three figures, and round corners are cut into chords by the kernel.
STEEL = 2e-2

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
        # Where the house has openings a style has drawn it, part by part; surfaces and other sets draw what they draw.
        solid = bool(model.by_type("IfcOpeningElement"))
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
    openings = model.by_type("IfcOpeningElement")
    for opening in openings:
        if opening.VoidsElements[0].RelatingBuildingElement not in walls:
            faults.append(f"{opening.Name}: voids no wall")
    for product in model.by_type("IfcElement"):
        if product.is_a("IfcOpeningElement"):
            continue
        if element.get_material(product) is None:
            faults.append(f"{product.Name}: made of nothing")
        if openings and product.is_a() in ("IfcWindow", "IfcDoor") and not product.FillsVoids:
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
