//! An IFC file in the making: units, contexts, placements, and the relations that are collected while products are written.

use std::collections::{BTreeMap, BTreeSet};

use super::guid::global_id;
use super::record::{Id, Record, Value};
use super::step::Step;

/// A property of a set.
pub(super) struct Property {
    pub name: String,
    pub note: Option<String>,
    pub value: Value,
    pub unit: Option<Id>,
}

impl Property {
    pub fn new(name: &str, value: Value) -> Property {
        Property { name: name.into(), note: None, value, unit: None }
    }

    pub fn label(name: &str, text: &str) -> Property {
        Property::new(name, Value::Text("IFCLABEL", text.into()))
    }

    pub fn note(self, note: &str) -> Property {
        Property { note: Some(note.into()), ..self }
    }

    pub fn unit(self, unit: Option<Id>) -> Property {
        Property { unit, ..self }
    }
}

/// A quantity of a set: class without `IFCQUANTITY`, name, remark, value.
pub(super) struct Quantity {
    pub class: &'static str,
    pub name: String,
    pub note: Option<String>,
    pub value: f64,
}

impl Quantity {
    pub fn new(class: &'static str, name: &str, value: f64) -> Quantity {
        Quantity { class, name: name.into(), note: None, value }
    }
}

/// Everything that entities refer to.
pub(super) struct Model {
    pub step: Step,
    /// Name that all GlobalIds begin with.
    pub house: String,
    pub context: Id,
    pub body: Id,
    pub reference: Id,
    /// Money, where the price book names a currency.
    pub money: Option<Id>,
    /// kgCO2e.
    pub carbon: Id,
    pub units: Id,
    taken: BTreeSet<String>,
    sets: BTreeMap<(String, String), (Vec<Id>, Vec<Id>)>,
    materials: BTreeMap<Id, (String, Vec<Id>)>,
    types: BTreeMap<Id, (String, Vec<Id>)>,
    contained: BTreeMap<Id, (String, Vec<Id>)>,
}

impl Model {
    /// Units, contexts and nothing else.
    pub fn new(house: &str, currency: &str) -> Model {
        let mut step = Step::default();
        let at = step.share(Record::new("IFCCARTESIANPOINT").reals(&[0.0; 3]));
        let origin = step.share(Record::new("IFCAXIS2PLACEMENT3D").id(at).nones(2));
        let context = Record::new("IFCGEOMETRICREPRESENTATIONCONTEXT").none().text("Model").int(3).real(1e-6);
        let context = step.add(context.id(origin).none());
        let mut view = |name: &str| {
            let view = Record::new("IFCGEOMETRICREPRESENTATIONSUBCONTEXT").text(name).text("Model");
            step.add(derived(view, 4).id(context).none().word("MODEL_VIEW").none())
        };
        let (body, reference) = (view("Body"), view("Reference"));
        let (units, money, carbon) = units(&mut step, currency);
        Model {
            step,
            house: house.to_owned(),
            context,
            body,
            reference,
            money,
            carbon,
            units,
            taken: BTreeSet::new(),
            sets: BTreeMap::new(),
            materials: BTreeMap::new(),
            types: BTreeMap::new(),
            contained: BTreeMap::new(),
        }
    }

    /// Begins a rooted entity: its GlobalId follows from the house's name, what kind of thing it is and which; then owner history, name and
    /// description.
    pub fn root(&mut self, entity: &str, key: [&str; 2], name: Option<&str>, note: Option<&str>) -> Record {
        let [kind, which] = key;
        let mut id = global_id(&[&self.house, kind, which]);
        // Names of products are unique; this keeps a file valid even where a set of meshes repeats one.
        for n in 2.. {
            if self.taken.insert(id.clone()) {
                break;
            }
            id = global_id(&[&self.house, kind, which, &n.to_string()]);
        }
        Record::new(entity).text(&id).none().maybe_text(name).maybe_text(note)
    }

    pub fn point(&mut self, at: [f64; 3]) -> Id {
        self.step.share(Record::new("IFCCARTESIANPOINT").reals(&at.map(nano)))
    }

    pub fn direction(&mut self, d: [f64; 3]) -> Id {
        self.step.share(Record::new("IFCDIRECTION").reals(&d.map(|c| (c * 1e12).round() / 1e12)))
    }

    /// Axes at a place: z and x where they are not the world's.
    pub fn axes(&mut self, at: [f64; 3], zx: Option<[[f64; 3]; 2]>) -> Id {
        let point = self.point(at);
        let record = Record::new("IFCAXIS2PLACEMENT3D").id(point);
        let record = match zx {
            Some([z, x]) => {
                let (z, x) = (self.direction(z), self.direction(x));
                record.id(z).id(x)
            }
            None => record.nones(2),
        };
        self.step.share(record)
    }

    /// A place seen from another.
    pub fn placement(&mut self, parent: Option<Id>, at: [f64; 3], zx: Option<[[f64; 3]; 2]>) -> Id {
        let axes = self.axes(at, zx);
        self.step.add(Record::new("IFCLOCALPLACEMENT").maybe_id(parent).id(axes))
    }

    /// The shape of a product from items of one kind.
    pub fn shape(&mut self, context: Id, names: [&str; 2], items: &[Id]) -> Id {
        let shape = Record::new("IFCSHAPEREPRESENTATION").id(context).text(names[0]).text(names[1]).ids(items);
        let shape = self.step.add(shape);
        self.step.add(Record::new("IFCPRODUCTDEFINITIONSHAPE").nones(2).ids(&[shape]))
    }

    /// Gives properties to a thing; equal sets are written once and shared.
    pub fn properties(&mut self, set: &str, on: Id, list: Vec<Property>) {
        if list.is_empty() {
            return;
        }
        let ids: Vec<Id> = list
            .iter()
            .map(|p| {
                let record = Record::new("IFCPROPERTYSINGLEVALUE").text(&p.name).maybe_text(p.note.as_deref());
                self.step.share(record.value(&p.value).maybe_id(p.unit))
            })
            .collect();
        let text = |p: &Property| format!("{} {:?} {:?} {:?}", p.name, p.note, p.value, p.unit.is_some());
        let content: String = list.iter().map(text).collect::<Vec<_>>().join("; ");
        self.sets.entry((set.to_owned(), content)).or_insert_with(|| (ids, Vec::new())).1.push(on);
    }

    /// Gives quantities to a thing; `which` names it.
    pub fn quantities(&mut self, set: &str, which: &str, on: Id, list: &[Quantity]) {
        if list.is_empty() {
            return;
        }
        let ids: Vec<Id> = list
            .iter()
            .map(|q| {
                let record = Record::new(&format!("IFCQUANTITY{}", q.class)).text(&q.name);
                self.step.share(record.maybe_text(q.note.as_deref()).none().real(q.value).none())
            })
            .collect();
        let key = format!("{which}/{set}");
        let record = self.root("IFCELEMENTQUANTITY", ["quantities", &key], Some(set), None);
        let record = record.text("Houscaper take-off").ids(&ids);
        let set = self.step.add(record);
        let relation = self.root("IFCRELDEFINESBYPROPERTIES", ["has quantities", &key], None, None);
        self.step.add(relation.ids(&[on]).id(set));
    }

    /// Notes what a thing is made of, of which type it is, and where it is contained; written by [`Model::relate`].
    pub fn made_of(&mut self, on: Id, material: Id, name: &str) {
        self.materials.entry(material).or_insert_with(|| (name.to_owned(), Vec::new())).1.push(on);
    }

    pub fn of_type(&mut self, on: Id, kind: Id, name: &str) {
        self.types.entry(kind).or_insert_with(|| (name.to_owned(), Vec::new())).1.push(on);
    }

    pub fn contain(&mut self, on: Id, storey: Id, name: &str) {
        self.contained.entry(storey).or_insert_with(|| (name.to_owned(), Vec::new())).1.push(on);
    }

    /// Writes the relations collected so far.
    pub fn relate(&mut self) {
        for ((set, content), (ids, on)) in std::mem::take(&mut self.sets) {
            let key = format!("{set} {content}");
            let record = self.root("IFCPROPERTYSET", ["properties", &key], Some(&set), None).ids(&ids);
            let id = self.step.add(record);
            let relation = self.root("IFCRELDEFINESBYPROPERTIES", ["has properties", &key], None, None);
            self.step.add(relation.ids(&on).id(id));
        }
        for (material, (name, on)) in std::mem::take(&mut self.materials) {
            let relation = self.root("IFCRELASSOCIATESMATERIAL", ["made of", &name], None, None);
            self.step.add(relation.ids(&on).id(material));
        }
        for (kind, (name, on)) in std::mem::take(&mut self.types) {
            let relation = self.root("IFCRELDEFINESBYTYPE", ["of type", &name], None, None);
            self.step.add(relation.ids(&on).id(kind));
        }
        for (storey, (name, on)) in std::mem::take(&mut self.contained) {
            let relation = self.root("IFCRELCONTAINEDINSPATIALSTRUCTURE", ["contained in", &name], None, None);
            self.step.add(relation.ids(&on).id(storey));
        }
    }
}

/// Coordinates to the nanometre: sums of modules carry rounding noise in their last bits.
pub(super) fn nano(m: f64) -> f64 {
    (m * 1e9).round() / 1e9
}

/// Attributes that follow from others.
fn derived(record: Record, count: usize) -> Record {
    (0..count).fold(record, |record, _| record.derived())
}

/// The unit assignment, the monetary unit and kgCO2e.
fn units(step: &mut Step, currency: &str) -> (Id, Option<Id>, Id) {
    let mut si = |kind: &str, prefix: Option<&str>, name: &str| {
        let unit = Record::new("IFCSIUNIT").derived().word(kind);
        let unit = match prefix {
            Some(prefix) => unit.word(prefix),
            None => unit.none(),
        };
        step.add(unit.word(name))
    };
    let metre = si("LENGTHUNIT", None, "METRE");
    let mut all = vec![
        metre,
        si("AREAUNIT", None, "SQUARE_METRE"),
        si("VOLUMEUNIT", None, "CUBIC_METRE"),
        si("MASSUNIT", Some("KILO"), "GRAM"),
        si("PLANEANGLEUNIT", None, "RADIAN"),
        si("ENERGYUNIT", None, "JOULE"),
    ];
    let (watt, kelvin) = (si("POWERUNIT", None, "WATT"), si("THERMODYNAMICTEMPERATUREUNIT", None, "KELVIN"));
    all.extend([watt, kelvin]);
    let powers = [(watt, 1), (metre, -2), (kelvin, -1)]
        .map(|(unit, power)| step.add(Record::new("IFCDERIVEDUNITELEMENT").id(unit).int(power)));
    let record = Record::new("IFCDERIVEDUNIT").ids(&powers).word("THERMALTRANSMITTANCEUNIT").none();
    all.push(step.add(record));
    let money = (!currency.is_empty()).then(|| step.add(Record::new("IFCMONETARYUNIT").text(currency)));
    all.extend(money);
    let mass = Record::new("IFCDIMENSIONALEXPONENTS").int(0).int(1);
    let mass = step.add((0..5).fold(mass, |record, _| record.int(0)));
    let carbon = step.add(Record::new("IFCCONTEXTDEPENDENTUNIT").id(mass).word("MASSUNIT").text("kgCO2e"));
    (step.add(Record::new("IFCUNITASSIGNMENT").ids(&all)), money, carbon)
}
