//! JSON values to frames and back. Read by hand from `serde_json::Value`, because every message names its key path.

use super::*;
use serde_json::{Map, Value, json};

/// A JSON value with the way to it.
struct At<'a> {
    file: &'a str,
    path: String,
    value: &'a Value,
}

type Result<T> = std::result::Result<T, FrameFileError>;

impl<'a> At<'a> {
    fn error<T>(&self, message: impl Into<String>) -> Result<T> {
        Err(FrameFileError::Json { file: self.file.into(), path: self.path.clone(), message: message.into() })
    }

    fn unexpected<T>(&self, expected: &str) -> Result<T> {
        let mut found = self.value.to_string();
        if found.chars().count() > 60 {
            found = found.chars().take(60).collect::<String>() + " ...";
        }
        let (file, path) = (self.file.into(), self.path.clone());
        Err(FrameFileError::Value { file, path, found, expected: expected.into() })
    }

    /// The object's entries, all of whose keys are known.
    fn object(&self, known: &[&str]) -> Result<&'a Map<String, Value>> {
        let Value::Object(map) = self.value else { return self.unexpected("an object") };
        match map.keys().find(|k| !known.contains(&k.as_str())) {
            Some(key) => self.child(key, self.value).error(format!("unknown key; known are {}", known.join(", "))),
            None => Ok(map),
        }
    }

    fn child(&self, key: &str, value: &'a Value) -> At<'a> {
        let path = if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) };
        At { file: self.file, path, value }
    }

    fn optional(&self, key: &str) -> Option<At<'a>> {
        self.value.get(key).map(|v| self.child(key, v))
    }

    fn required(&self, key: &str) -> Result<At<'a>> {
        match self.optional(key) {
            Some(at) => Ok(at),
            None => self.child(key, self.value).error("missing key"),
        }
    }

    fn items(&self) -> Result<Vec<At<'a>>> {
        let Value::Array(list) = self.value else { return self.unexpected("a list") };
        let item = |(n, value)| At { file: self.file, path: format!("{}[{n}]", self.path), value };
        Ok(list.iter().enumerate().map(item).collect())
    }

    fn list<T>(&self, read: impl Fn(&At<'a>) -> Result<T>) -> Result<Vec<T>> {
        self.items()?.iter().map(read).collect()
    }

    fn number(&self) -> Result<f64> {
        self.value.as_f64().map_or_else(|| self.unexpected("a number"), Ok)
    }

    fn index(&self) -> Result<usize> {
        self.value.as_u64().and_then(|v| usize::try_from(v).ok()).map_or_else(|| self.unexpected("an index from 0"), Ok)
    }

    fn flag(&self) -> Result<bool> {
        match self.value {
            Value::Bool(b) => Ok(*b),
            v if v.as_u64() == Some(0) => Ok(false),
            v if v.as_u64() == Some(1) => Ok(true),
            _ => self.unexpected("0 or 1"),
        }
    }

    fn text(&self) -> Result<String> {
        self.value.as_str().map_or_else(|| self.unexpected("text"), |s| Ok(s.to_owned()))
    }

    fn array<T: Copy + Default, const N: usize>(&self, read: impl Fn(&At<'a>) -> Result<T>) -> Result<[T; N]> {
        let items = self.items()?;
        if items.len() != N {
            return self.unexpected(&format!("{N} values"));
        }
        let mut out = [T::default(); N];
        for (o, item) in out.iter_mut().zip(&items) {
            *o = read(item)?;
        }
        Ok(out)
    }

    fn vector(&self, key: &str) -> Result<[f64; 3]> {
        self.required(key)?.array(At::number)
    }
}

pub(super) fn read(bytes: &[u8], name: &str) -> Result<FrameFile> {
    let value: Value = serde_json::from_slice(bytes).map_err(|e| FrameFileError::Json {
        file: name.into(),
        path: format!("line {} column {}", e.line(), e.column()),
        message: e.to_string(),
    })?;
    let root = At { file: name, path: String::new(), value: &value };
    root.object(&[
        "schema",
        "name",
        "source",
        "units",
        "tolnote",
        "nodes",
        "materials",
        "sections",
        "shear",
        "members",
        "supports",
        "cases",
        "combinations",
        "expected",
    ])?;
    if let Some(schema) = root.optional("schema")
        && schema.value.as_str() != Some(SCHEMA)
    {
        return schema.unexpected(SCHEMA);
    }
    root.optional("tolnote").map(|t| t.text()).transpose()?;
    let text = |key: &str| root.optional(key).map_or(Ok(String::new()), |t| t.text());
    let cases = root.required("cases")?.list(case)?;
    let combinations = match root.optional("combinations") {
        Some(list) => list.list(|c| combination(c, &cases))?,
        None => Vec::new(),
    };
    let expected = root.optional("expected").map_or(Ok(Vec::new()), |e| e.list(expected))?;
    let (name, source, units) = (text("name")?, text("source")?, text("units")?);
    Ok(FrameFile { name, source, units, model: model(&root)?, cases, combinations, expected })
}

fn model(root: &At) -> Result<Model> {
    Ok(Model {
        nodes: root.required("nodes")?.list(|n| n.array(At::number))?,
        materials: root.required("materials")?.list(material)?,
        sections: root.required("sections")?.list(section)?,
        members: root.required("members")?.list(member)?,
        supports: root.required("supports")?.list(|s| {
            s.object(&["node", "fix"])?;
            Ok(Support { node: s.required("node")?.index()?, fix: s.required("fix")?.array(At::flag)? })
        })?,
        shear: root.optional("shear").map_or(Ok(false), |s| s.flag())?,
    })
}

fn material(at: &At) -> Result<Material> {
    at.object(&["name", "source", "units", "tolnote", "E", "G", "rho"])?;
    let rho = at.optional("rho").map_or(Ok(0.0), |r| r.number())?;
    Ok(Material { e: at.required("E")?.number()?, g: at.required("G")?.number()?, rho })
}

fn section(at: &At) -> Result<Section> {
    at.object(&["name", "source", "units", "tolnote", "A", "Iy", "Iz", "J", "Asy", "Asz"])?;
    let number = |key: &str| at.required(key)?.number();
    let shear = |key: &str| at.optional(key).map(|a| a.number()).transpose();
    Ok(Section {
        a: number("A")?,
        iy: number("Iy")?,
        iz: number("Iz")?,
        j: number("J")?,
        asy: shear("Asy")?,
        asz: shear("Asz")?,
    })
}

fn member(at: &At) -> Result<Member> {
    at.object(&["n", "mat", "sec", "ref", "roll", "releases", "stick", "role", "offset"])?;
    // Said for people and drawings: of which stick it is a piece, and where the timber lies beside the axis.
    at.optional("stick").map(|s| s.index()).transpose()?;
    at.optional("role").map(|r| r.text()).transpose()?;
    at.optional("offset").map(|o| o.array::<f64, 3>(At::number)).transpose()?;
    let mut ends = [[false; 6]; 2];
    if let Some(releases) = at.optional("releases") {
        releases.object(&["i", "j"])?;
        for (end, key) in ends.iter_mut().zip(["i", "j"]) {
            *end = releases.optional(key).map_or(Ok([false; 6]), |r| r.array(At::flag))?;
        }
    }
    Ok(Member {
        nodes: at.required("n")?.array(At::index)?,
        material: at.required("mat")?.index()?,
        section: at.required("sec")?.index()?,
        reference: at.optional("ref").map(|r| r.array(At::number)).transpose()?,
        roll: at.optional("roll").map_or(Ok(0.0), |r| r.number())?.to_radians(),
        releases: ends,
    })
}

fn case(at: &At) -> Result<LoadCase> {
    at.object(&["name", "gravity", "nodal", "settle", "member"])?;
    Ok(LoadCase {
        name: at.required("name")?.text()?,
        gravity: at.optional("gravity").map_or(Ok([0.0; 3]), |g| g.array(At::number))?,
        nodal: at.optional("nodal").map_or(Ok(Vec::new()), |l| l.list(nodal))?,
        members: at.optional("member").map_or(Ok(Vec::new()), |l| l.list(member_load))?,
        settlements: at.optional("settle").map_or(Ok(Vec::new()), |l| l.list(settlement))?,
    })
}

fn nodal(at: &At) -> Result<NodalLoad> {
    at.object(&["node", "F"])?;
    Ok(NodalLoad { node: at.required("node")?.index()?, force: at.required("F")?.array(At::number)? })
}

fn settlement(at: &At) -> Result<Settlement> {
    at.object(&["node", "dof", "value"])?;
    let (node, dof) = (at.required("node")?.index()?, at.required("dof")?.index()?);
    Ok(Settlement { node, dof, value: at.required("value")?.number()? })
}

fn member_load(at: &At) -> Result<MemberLoad> {
    let kind = at.required("type")?;
    let distribution = match kind.value.as_str() {
        Some("uniform") => {
            at.object(&["m", "type", "axes", "q"])?;
            Distribution::Uniform { q: at.vector("q")? }
        }
        Some("point") => {
            at.object(&["m", "type", "axes", "P", "x"])?;
            Distribution::Point { p: at.vector("P")?, x: at.required("x")?.number()? }
        }
        Some("linear") => {
            at.object(&["m", "type", "axes", "q1", "q2", "x1", "x2"])?;
            let (x1, x2) = (at.required("x1")?.number()?, at.required("x2")?.number()?);
            Distribution::Linear { q1: at.vector("q1")?, q2: at.vector("q2")?, x1, x2 }
        }
        _ => return kind.unexpected("uniform, point or linear"),
    };
    let axes = at.required("axes")?;
    let axes = match axes.value.as_str() {
        Some("local") => Axes::Local,
        Some("global") => Axes::Global,
        _ => return axes.unexpected("local or global"),
    };
    Ok(MemberLoad { member: at.required("m")?.index()?, axes, distribution })
}

fn combination(at: &At, cases: &[LoadCase]) -> Result<Combination> {
    at.object(&["name", "factors"])?;
    let given = at.required("factors")?;
    let names: Vec<&str> = cases.iter().map(|c| c.name.as_str()).collect();
    let used = given.object(&names)?;
    if let Some(twice) = used.keys().find(|k| names.iter().filter(|n| *n == k).count() > 1) {
        return given.child(twice, given.value).error("two cases have this name; give each case its own");
    }
    let factor = |name: &&str| given.optional(name).map_or(Ok(0.0), |f| f.number());
    Ok(Combination { name: at.required("name")?.text()?, factors: names.iter().map(factor).collect::<Result<_>>()? })
}

fn expected(at: &At) -> Result<Expected> {
    at.object(&["case", "what", "node", "member", "comp", "value", "printed", "tol"])?;
    let what = at.required("what")?;
    let quantity = match what.value.as_str() {
        Some("disp") => Quantity::Displacement { node: at.required("node")?.index()? },
        Some("reac") => Quantity::Reaction { node: at.required("node")?.index()? },
        Some("endf") => Quantity::EndForce { member: at.required("member")?.index()? },
        _ => return what.unexpected("disp, reac or endf"),
    };
    Ok(Expected {
        case: at.required("case")?.index()?,
        quantity,
        component: at.required("comp")?.index()?,
        value: at.required("value")?.number()?,
        tolerance: at.required("tol")?.number()?,
        printed: at.optional("printed").map_or(Ok(String::new()), |p| p.text())?,
    })
}

fn flags(fix: &[bool; 6]) -> Value {
    json!(fix.map(u8::from))
}

fn member_value(m: &Member) -> Value {
    let mut v = json!({"n": m.nodes, "mat": m.material, "sec": m.section});
    if let Some(r) = m.reference {
        v["ref"] = json!(r);
    }
    if m.roll != 0.0 {
        v["roll"] = json!(m.roll.to_degrees());
    }
    if m.releases != [[false; 6]; 2] {
        v["releases"] = json!({"i": flags(&m.releases[0]), "j": flags(&m.releases[1])});
    }
    v
}

fn section_value(s: &Section) -> Value {
    let mut v = json!({"A": s.a, "Iy": s.iy, "Iz": s.iz, "J": s.j});
    for (key, area) in [("Asy", s.asy), ("Asz", s.asz)] {
        if let Some(a) = area {
            v[key] = json!(a);
        }
    }
    v
}

fn member_load_value(l: &MemberLoad) -> Value {
    let axes = match l.axes {
        Axes::Local => "local",
        Axes::Global => "global",
    };
    match l.distribution {
        Distribution::Uniform { q } => json!({"m": l.member, "type": "uniform", "axes": axes, "q": q}),
        Distribution::Point { p, x } => json!({"m": l.member, "type": "point", "axes": axes, "P": p, "x": x}),
        Distribution::Linear { q1, q2, x1, x2 } => {
            json!({"m": l.member, "type": "linear", "axes": axes, "q1": q1, "q2": q2, "x1": x1, "x2": x2})
        }
    }
}

fn case_value(c: &LoadCase) -> Value {
    let mut v = json!({"name": c.name});
    if c.gravity != [0.0; 3] {
        v["gravity"] = json!(c.gravity);
    }
    let lists = [
        ("nodal", c.nodal.iter().map(|l| json!({"node": l.node, "F": l.force})).collect::<Vec<_>>()),
        ("settle", c.settlements.iter().map(|s| json!({"node": s.node, "dof": s.dof, "value": s.value})).collect()),
        ("member", c.members.iter().map(member_load_value).collect()),
    ];
    for (key, list) in lists.into_iter().filter(|(_, list)| !list.is_empty()) {
        v[key] = Value::Array(list);
    }
    v
}

fn expected_value(e: &Expected) -> Value {
    let (what, key, index) = match e.quantity {
        Quantity::Displacement { node } => ("disp", "node", node),
        Quantity::Reaction { node } => ("reac", "node", node),
        Quantity::EndForce { member } => ("endf", "member", member),
    };
    let mut v = json!({"case": e.case, "what": what, "comp": e.component, "value": e.value, "printed": e.printed, "tol": e.tolerance});
    v[key] = json!(index);
    v
}

pub(super) fn write(file: &FrameFile) -> Vec<u8> {
    let mut out = format!("{{\n\"schema\": \"{SCHEMA}\"");
    for (key, text) in [("name", &file.name), ("source", &file.source), ("units", &file.units)] {
        if !text.is_empty() {
            out += &format!(",\n\"{key}\": {}", Value::String(text.clone()));
        }
    }
    let m = &file.model;
    list(&mut out, "nodes", m.nodes.iter().map(|n| json!(n)));
    list(&mut out, "materials", m.materials.iter().map(|m| json!({"E": m.e, "G": m.g, "rho": m.rho})));
    list(&mut out, "sections", m.sections.iter().map(section_value));
    out += &format!(",\n\"shear\": {}", m.shear);
    list(&mut out, "members", m.members.iter().map(member_value));
    list(&mut out, "supports", m.supports.iter().map(|s| json!({"node": s.node, "fix": flags(&s.fix)})));
    list(&mut out, "cases", file.cases.iter().map(case_value));
    if !file.combinations.is_empty() {
        list(&mut out, "combinations", file.combinations.iter().map(|c| combination_value(c, &file.cases)));
    }
    if !file.expected.is_empty() {
        list(&mut out, "expected", file.expected.iter().map(expected_value));
    }
    out += "\n}\n";
    out.into_bytes()
}

fn combination_value(c: &Combination, cases: &[LoadCase]) -> Value {
    let used = cases.iter().zip(&c.factors).filter(|(_, f)| **f != 0.0);
    json!({"name": c.name, "factors": used.map(|(case, f)| (case.name.clone(), json!(f))).collect::<Map<_, _>>()})
}

fn list(out: &mut String, key: &str, items: impl Iterator<Item = Value>) {
    let lines: Vec<String> = items.map(|v| v.to_string()).collect();
    if lines.is_empty() {
        *out += &format!(",\n\"{key}\": []");
    } else {
        *out += &format!(",\n\"{key}\": [\n {}\n]", lines.join(",\n "));
    }
}
