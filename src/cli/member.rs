//! `houscaper member`: one member checked on its own.

mod args;
mod expected;
mod file;
mod print;

use anyhow::anyhow;
use houscaper::structure::Catalogue;
use houscaper::structure::member::{MemberReport, check_member};
use serde_json::json;

use super::failure::{Blame, Failure, Outcome};
use super::home;
use super::output::say;
pub use args::Member;
use expected::Expected;

/// Exit code 2 when a member fails or is not assessed, as for every check.
pub fn run(args: Member, as_json: bool) -> Outcome {
    let home = home::find(None).ok_or_else(|| anyhow!("configs/ not found; set HOUSCAPER_HOME")).run()?;
    let catalogue = Catalogue::load(&home.join("configs")).run()?;
    let (members, many) = match &args.file {
        Some(path) => file::read(path)?,
        None => (vec![(args.input(), Expected::default())], false),
    };
    let mut reports: Vec<(MemberReport, Expected)> = Vec::new();
    for (n, (input, expected)) in members.into_iter().enumerate() {
        let place = || match (&args.file, many) {
            (Some(path), true) => format!("{}: member {n}", path.display()),
            (Some(path), false) => path.display().to_string(),
            (None, _) => "member".into(),
        };
        let report = check_member(&input, &catalogue).map_err(|e| Failure::Input(anyhow!("{}: {e}", place())))?;
        reports.push((report, expected));
    }
    if as_json {
        let objects: Vec<_> = reports.iter().map(|(r, e)| object(r, e)).collect();
        match (many, objects.into_iter().next()) {
            (false, Some(one)) => say!("{one}"),
            _ => say!("{}", json!(reports.iter().map(|(r, e)| object(r, e)).collect::<Vec<_>>())),
        }
    } else {
        for (n, (report, expected)) in reports.iter().enumerate() {
            if n > 0 {
                say!("");
            }
            print::report(report, expected, args.brief);
        }
    }
    let fails = |(r, e): &(MemberReport, Expected)| r.verdict != "ok" || !e.compare(r).off.is_empty();
    // A book's example may fail its member: then agreement is the question, not the verdict.
    let wrong = reports.iter().any(|r| if r.1.is_empty() { fails(r) } else { !r.1.compare(&r.0).off.is_empty() });
    if wrong { Err(Failure::Found) } else { Ok(()) }
}

fn object(report: &MemberReport, expected: &Expected) -> serde_json::Value {
    let mut object = json!({"schema": "houscaper.member_result/1"});
    if let (Some(into), serde_json::Value::Object(own)) = (object.as_object_mut(), json!(report)) {
        into.extend(own);
        if !expected.is_empty() {
            let agreement = expected.compare(report);
            into.insert("published".into(), json!({"compared": agreement.compared, "off": agreement.off}));
        }
    }
    object
}
