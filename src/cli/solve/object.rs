//! The answer as one JSON object; its keys are explained by `solve --help` (output.txt).

use houscaper::analysis::file::FrameFile;
use houscaper::analysis::{BucklingAnswer, Extremes, Line, Solution, Status};
use serde_json::{Map, Value, json};

use super::along::{self, FORCES, Place};
use super::numbers::Numbers;
use super::{Cost, word};

/// The whole answer. `stations`: places along every member, 0 for none.
pub fn answer(
    file: &FrameFile,
    cost: &Cost,
    solution: &Solution,
    results: &[Numbers],
    buckling: &[BucklingAnswer],
    stations: usize,
) -> Value {
    let mut cases: Vec<Value> = results.iter().map(|r| case(file, solution, r, stations)).collect();
    for (case, found) in cases.iter_mut().zip(buckling) {
        case["buckling"] = match found {
            BucklingAnswer::Buckles(b) => json!({
                "factor": b.factor, "member": b.member, "x": b.x, "direction": b.direction, "nodes": b.nodes,
            }),
            other => json!({"factor": null, "never": *other == BucklingAnswer::Never}),
        };
    }
    let mut object = json!({
        "status": word(&solution.status),
        "size": size(cost),
        "timing_ms": timing(cost),
        "idle": solution.idle.iter().map(|i| json!({"node": i.node, "direction": i.direction})).collect::<Vec<_>>(),
        "cases": cases,
    });
    if let Some(estimate) = cost.condition {
        let kind = "one-norm of the stiffness scaled to unit diagonal, Hager-Higham estimate";
        object["condition"] = json!({"estimate": estimate, "kind": kind});
    }
    let mechanism = match &solution.status {
        Status::Solved { residual, least_pivot } => {
            object["residual"] = json!(residual);
            object["least_pivot"] = json!(least_pivot);
            return object;
        }
        Status::NearlySingular { residual, weakest, .. } => {
            object["residual"] = json!(residual);
            weakest
        }
        Status::Unstable(mechanism) => mechanism,
        Status::Empty => return object,
    };
    let motions: Vec<_> = mechanism.motions.iter().map(|m| json!({"node": m.node, "direction": m.direction})).collect();
    object["mechanism"] = json!({"message": mechanism.to_string(), "nodes": motions});
    object
}

fn size(cost: &Cost) -> Value {
    let size = cost.size;
    json!({
        "unknowns": size.unknowns,
        "stiffness_entries": size.stiffness_entries,
        "factor_entries": size.factor_entries,
        "bytes": size.bytes,
        "bytes_per_unknown": size.bytes / size.unknowns.max(1),
    })
}

fn timing(cost: &Cost) -> Value {
    let phases = cost.phases;
    let ms = |d: std::time::Duration| json!(d.as_nanos() as f64 * 1e-6);
    let mut map: Map<String, Value> = phases.each().iter().map(|(name, d)| ((*name).to_owned(), ms(*d))).collect();
    map.insert("total".to_owned(), ms(phases.total()));
    Value::Object(map)
}

fn case(file: &FrameFile, solution: &Solution, r: &Numbers, stations: usize) -> Value {
    let ends: Vec<&[f64]> = r.endf.iter().map(|e| e.as_slice()).collect();
    let members = along::extremes(solution, r);
    let mut object = json!({
        "name": r.name,
        "disp": r.disp,
        "reac": r.reac,
        "endf": ends,
        "equilibrium": {"load": r.load.total, "reaction": r.reaction.total, "out_of_balance": r.out_of_balance()},
        "extremes": extremes(r, &members),
    });
    if r.combined {
        let used = file.cases.iter().zip(&r.factors).filter(|(_, f)| **f != 0.0);
        object["combination"] = Value::Object(used.map(|(c, f)| (c.name.clone(), json!(f))).collect());
    }
    if stations > 0 {
        object["along"] = members.iter().enumerate().map(|(m, e)| member(solution, r, m, e, stations)).collect();
    }
    object
}

fn extremes(r: &Numbers, members: &[Extremes]) -> Value {
    let mut map = Map::new();
    for (from, name) in [(0, "displacement"), (3, "rotation")] {
        if let Some(Place { value, index, at }) = along::largest(&r.disp, from) {
            let axis = ["x", "y", "z"][at as usize];
            map.insert(name.to_owned(), json!({"value": value, "node": index, "axis": axis}));
        }
    }
    for (k, name) in FORCES.into_iter().enumerate() {
        if let Some([least, most]) = along::range(members, k) {
            let place = |p: Place| json!({"value": p.value, "member": p.index, "x": p.at});
            map.insert(name.to_owned(), json!({"least": place(least), "most": place(most)}));
        }
    }
    Value::Object(map)
}

fn member(solution: &Solution, r: &Numbers, m: usize, e: &Extremes, stations: usize) -> Value {
    let line = Line::new(solution, &r.factors, m);
    let pieces = stations.max(2) - 1;
    let xs: Vec<f64> = (0..=pieces).map(|k| line.length() * k as f64 / pieces as f64).collect();
    json!({
        "x": xs,
        "forces": xs.iter().map(|&x| line.forces(x)).collect::<Vec<_>>(),
        "deflection": xs.iter().map(|&x| line.deflection(x)).collect::<Vec<_>>(),
        "least": e.least, "least_at": e.least_at, "most": e.most, "most_at": e.most_at,
    })
}
