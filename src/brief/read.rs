//! Reading and checking a brief: every mistake is named with its key, what was expected and what to do.

use super::{Brief, Constraint, Keep};

/// Why a brief was refused.
#[derive(Debug, thiserror::Error)]
pub enum BriefError {
    /// Not JSON, an unknown key, or a value of the wrong kind.
    #[error("{file}:{line}:{column}: at `{key}`: {message}")]
    Syntax {
        /// File name.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// Key path.
        key: String,
        /// What serde found and expected.
        message: String,
    },
    /// A value that cannot be.
    #[error("{file}: `{key}` is {found}: expected {expected}; {fix}")]
    Value {
        /// File name.
        file: String,
        /// Key path.
        key: &'static str,
        /// The value found.
        found: String,
        /// What it must be.
        expected: String,
        /// What to change.
        fix: String,
    },
    /// A constraint key that names nothing.
    #[error(
        "{file}: `constraints.{key}`: expected `budget_eur` or an objective with `_max` or `_min`, e.g. `utilisation_max`"
    )]
    Constraint {
        /// File name.
        file: String,
        /// The key.
        key: String,
    },
}

/// The schema id of briefs.
pub const SCHEMA: &str = "houscaper.brief/1";

/// Largest plot side in modules.
pub const MOST_MODULES: usize = 64;

/// Reads and checks a brief.
///
/// # Errors
/// [`BriefError`] names file, key, the value found, what was expected and what to do.
pub fn read_brief(bytes: &[u8], file: &str) -> Result<Brief, BriefError> {
    let mut json = serde_json::Deserializer::from_slice(bytes);
    let brief: Brief = serde_path_to_error::deserialize(&mut json).map_err(|error| {
        let key = error.path().to_string();
        let inner = error.into_inner();
        let (line, column) = (inner.line(), inner.column());
        let full = inner.to_string();
        let message = full.rsplit_once(" at line ").map_or(full.clone(), |(text, _)| text.to_owned());
        BriefError::Syntax { file: file.into(), line, column, key, message }
    })?;
    json.end().map_err(|e| BriefError::Syntax {
        file: file.into(),
        line: e.line(),
        column: e.column(),
        key: ".".into(),
        message: "text after the brief's closing brace".into(),
    })?;
    check(&brief, file)?;
    Ok(brief)
}

struct Checker<'a> {
    file: &'a str,
}

impl Checker<'_> {
    fn require(
        &self,
        good: bool,
        key: &'static str,
        found: impl std::fmt::Debug,
        expected: impl Into<String>,
        fix: impl Into<String>,
    ) -> Result<(), BriefError> {
        if good {
            return Ok(());
        }
        Err(BriefError::Value {
            file: self.file.into(),
            key,
            found: plain(&format!("{found:?}")),
            expected: expected.into(),
            fix: fix.into(),
        })
    }
}

/// A value as the file has it: an optional key is there or missing.
fn plain(debug: &str) -> String {
    match debug.strip_prefix("Some(").and_then(|rest| rest.strip_suffix(')')) {
        Some(inner) => inner.to_owned(),
        None if debug == "None" => "missing".to_owned(),
        None => debug.to_owned(),
    }
}

fn check(brief: &Brief, file: &str) -> Result<(), BriefError> {
    let c = Checker { file };
    c.require(brief.schema == SCHEMA, "schema", &brief.schema, format!("\"{SCHEMA}\""), "correct the schema id")?;
    let plain = |ch: char| ch.is_ascii_alphanumeric() || matches!(ch, '-' | '_' | '.');
    c.require(
        !brief.name.is_empty() && brief.name.chars().all(plain) && !brief.name.starts_with('.'),
        "name",
        &brief.name,
        "letters, digits, `-`, `_` or `.` (it names the run folder)",
        "choose such a name",
    )?;
    check_plot(brief, &c)?;
    check_programme(brief, &c)?;
    check_zones(brief, &c)?;
    c.require(!brief.materials.is_empty(), "materials", &brief.materials, "at least one material", "add e.g. \"C24\"")?;
    let boards = &brief.wall_boards;
    c.require(!boards.is_empty(), "wall_boards", "[]", "at least one of \"one_side\", \"both_sides\"", "add one")?;
    let twice = (1..boards.len()).any(|i| boards[..i].contains(&boards[i]));
    let names: Vec<&str> = boards.iter().map(|b| b.name()).collect();
    c.require(!twice, "wall_boards", names, "each entry once", "remove the second one")?;
    check_site(brief, &c)?;
    c.require(!brief.objectives.is_empty(), "objectives", "[]", "at least one objective", "add e.g. \"price_eur\"")?;
    for (i, goal) in brief.objectives.iter().enumerate() {
        let twice = brief.objectives[..i].iter().any(|g| g.objective == goal.objective);
        c.require(!twice, "objectives", goal.objective.name(), "each objective once", "remove the second one")?;
    }
    c.require(brief.search.evaluations > 0, "search.evaluations", 0, "at least 1", "raise it")?;
    let population = brief.search.population.unwrap_or(100);
    c.require((4..=10_000).contains(&population), "search.population", population, "4 to 10000", "choose such a size")?;
    let sizing = brief.search.sizing;
    c.require((0.0..=1.0).contains(&sizing), "search.sizing", sizing, "a share from 0 to 1", "choose such a share")?;
    check_constraints(brief, file, &c)
}

fn check_plot(brief: &Brief, c: &Checker) -> Result<(), BriefError> {
    let [nx, ny, nz] = brief.plot.modules;
    c.require(
        (3..=MOST_MODULES).contains(&nx) && (3..=MOST_MODULES).contains(&ny) && (7..=MOST_MODULES).contains(&nz),
        "plot.modules",
        brief.plot.modules,
        format!("3 to {MOST_MODULES} modules in x and y, 7 to {MOST_MODULES} in z (foundation, five of room, a plate)"),
        "give the plot in modules, not metres",
    )?;
    let standard = crate::voxels::Module::default().size_m;
    c.require(
        brief.plot.module_m.iter().zip(standard).all(|(a, b)| (a - b).abs() < 1e-9),
        "plot.module_m",
        brief.plot.module_m,
        format!("{standard:?}, the module of the shipped tilesets, in metres"),
        "leave the key out",
    )?;
    if let Some(rows) = &brief.plot.mask {
        let good = rows.len() == ny && rows.iter().all(|r| r.len() == nx && r.bytes().all(|b| b == b'#' || b == b'.'));
        c.require(
            good,
            "plot.mask",
            rows,
            format!("{ny} rows of {nx} characters `#` or `.`"),
            "one row per module of y",
        )?;
    }
    let Some(envelope) = &brief.plot.envelope else { return Ok(()) };
    let scale = envelope.scale.unwrap_or([1.0; 3]);
    c.require(
        scale.iter().all(|s| s.is_finite() && *s > 0.0),
        "plot.envelope.scale",
        scale,
        "three numbers above 0: metres of the house for a unit of the file",
        "e.g. [0.001, 0.001, 0.001] for a file in millimetres",
    )?;
    let origin = envelope.origin.unwrap_or_default();
    let finite = origin.iter().all(|v| v.is_finite());
    c.require(finite, "plot.envelope.origin", origin, "three numbers", "give a point of the file")
}

fn check_zones(brief: &Brief, c: &Checker) -> Result<(), BriefError> {
    let zones = &brief.programme.zones;
    c.require(
        zones.is_empty() || brief.given.as_ref().is_none_or(|g| g.keep != Keep::Labels),
        "programme.zones",
        zones.len(),
        "none beside `given.keep` `labels`: the lattice's values are labels, not zones",
        "remove the zones, or keep `filled` cells of a zoning lattice",
    )?;
    c.require(
        zones.is_empty() || brief.given.is_some(),
        "programme.zones",
        zones.len(),
        "none without `given`: zones are ids of a lattice",
        "add `given.lattice` or remove the zones",
    )?;
    for (n, zone) in zones.iter().enumerate() {
        let [least, most] = zone.area_m2;
        c.require(
            least >= 0.0 && most >= least && most.is_finite() && most > 0.0,
            "programme.zones",
            format!("{{\"zone\": {}, \"area_m2\": {:?}}}", zone.zone, zone.area_m2),
            "area_m2 as [least, most] in m2 with 0 <= least <= most",
            "swap or correct the two numbers",
        )?;
        let new = zone.zone >= 0 && zones[..n].iter().all(|z| z.zone != zone.zone);
        c.require(new, "programme.zones", zone.zone, "ids of 0 or more, each once", "correct the id")?;
    }
    Ok(())
}

fn check_programme(brief: &Brief, c: &Checker) -> Result<(), BriefError> {
    let p = &brief.programme;
    let [least, most] = p.floor_area_m2;
    c.require(
        least >= 0.0 && most >= least && most.is_finite(),
        "programme.floor_area_m2",
        p.floor_area_m2,
        "[least, most] in m2 with 0 <= least <= most",
        "swap or correct the two numbers",
    )?;
    let [low, high] = p.storeys;
    c.require(
        low >= 1 && high >= low,
        "programme.storeys",
        p.storeys,
        "[least, most] with 1 <= least <= most",
        "correct it",
    )?;
    let room = (brief.plot.modules[2] - 1) / crate::voxels::STOREY_MODULES;
    c.require(
        low <= room,
        "programme.storeys",
        p.storeys,
        format!("at most {room} storeys: the plot is {} modules high and a storey takes 6", brief.plot.modules[2]),
        "raise plot.modules[2] to 6 x storeys + 1 or more, or ask for fewer storeys",
    )?;
    let cells = brief.buildable_cells();
    let storeys = high.min(room);
    let reach = cells as f64 * brief.plot.module_m[0] * brief.plot.module_m[1] * storeys as f64;
    c.require(
        least <= reach,
        "programme.floor_area_m2",
        p.floor_area_m2,
        format!(
            "at most {reach:.1} m2: the plot offers {cells} buildable modules on {storeys} storeys, walls included"
        ),
        "enlarge the plot, allow more storeys, or ask for less floor area",
    )?;
    c.require(
        p.entrances_min <= 3,
        "programme.entrances_min",
        p.entrances_min,
        "at most 3 (a storey has at most three doors)",
        "lower it",
    )?;
    let [flat, steepest] = p.roof_rise;
    c.require(
        flat <= steepest && steepest <= 4,
        "programme.roof_rise",
        p.roof_rise,
        "[least, most] modules with least <= most <= 4 (a steeper roof would hold a storey of its own)",
        "e.g. [0, 4] for any roof, [3, 4] for a pitched one",
    )?;
    c.require(
        (1.5..=3.06).contains(&p.clear_height_m),
        "programme.clear_height_m",
        p.clear_height_m,
        "1.5 to 3.06 m (six modules less a slab zone of 180 mm)",
        "choose such a height",
    )?;
    c.require(
        (0.0..=0.35).contains(&p.glazing_ratio_min),
        "programme.glazing_ratio_min",
        p.glazing_ratio_min,
        "0 to 0.35 (rules cap the glazing at 35 % of the floor area)",
        "lower it",
    )
}

fn check_site(brief: &Brief, c: &Checker) -> Result<(), BriefError> {
    let s = &brief.site;
    if let Some(preset) = &s.preset {
        c.require(preset == "thesis", "site.preset", preset, "\"thesis\"", "or give vb0_m_s, terrain and sk_kn_m2")?;
        let alone = s.vb0_m_s.is_none() && s.terrain.is_none() && s.sk_kn_m2.is_none() && s.annex.is_none();
        c.require(alone, "site", "preset with other keys", "either a preset or a site model", "remove one")?;
        let structural = brief.objectives.iter().map(|g| g.objective).chain(brief.limits_named());
        for objective in structural.filter(|o| o.is_structural()) {
            c.require(
                false,
                "site.preset",
                preset,
                format!(
                    "a site model, because the brief asks for {}: the thesis preset gives a yes or no only",
                    objective.name()
                ),
                "give vb0_m_s, terrain and sk_kn_m2, or drop that objective or limit",
            )?;
        }
        return Ok(());
    }
    let vb0 = s.vb0_m_s.unwrap_or(f64::NAN);
    c.require(
        (10.0..=60.0).contains(&vb0),
        "site.vb0_m_s",
        s.vb0_m_s,
        "a basic wind velocity of 10 to 60 m/s",
        "e.g. 27.0",
    )?;
    let terrain = s.terrain.as_deref().unwrap_or("");
    c.require(
        ["0", "I", "II", "III", "IV"].contains(&terrain),
        "site.terrain",
        &s.terrain,
        "\"0\", \"I\", \"II\", \"III\" or \"IV\" (EN 1991-1-4 table 4.1)",
        "e.g. \"II\" for open country",
    )?;
    let snow = s.sk_kn_m2.unwrap_or(f64::NAN);
    c.require(
        (0.0..=10.0).contains(&snow),
        "site.sk_kn_m2",
        s.sk_kn_m2,
        "a ground snow load of 0 to 10 kN/m2",
        "e.g. 0.7",
    )?;
    let annex = s.annex.as_deref().unwrap_or("EN");
    c.require(["EN", "NL"].contains(&annex), "site.annex", &s.annex, "\"EN\" or \"NL\"", "leave it out for EN")
}

fn check_constraints(brief: &Brief, file: &str, c: &Checker) -> Result<(), BriefError> {
    for (key, &limit) in &brief.constraints {
        let constraint = Constraint::parse(key, limit)
            .ok_or_else(|| BriefError::Constraint { file: file.into(), key: key.clone() })?;
        let possible = limit.is_finite() && (!constraint.is_max || limit > 0.0);
        c.require(
            possible,
            "constraints",
            format!("{key} = {limit}"),
            "a limit that some house can keep (every objective is positive)",
            "raise it or remove the constraint",
        )?;
        let opposite = constraint.opposite_key();
        if let Some(&other) = brief.constraints.get(&opposite) {
            let ordered = if constraint.is_max { other <= limit } else { limit <= other };
            c.require(
                ordered,
                "constraints",
                format!("{key} = {limit} with {opposite} = {other}"),
                "a least value not above the largest",
                "change one of the two: together no house can keep them",
            )?;
        }
    }
    let area_max = brief.constraints.get("floor_area_m2_max").copied().unwrap_or(f64::INFINITY);
    c.require(
        area_max >= brief.programme.floor_area_m2[0],
        "constraints",
        format!("floor_area_m2_max = {area_max}"),
        format!("at least the programme's {} m2", brief.programme.floor_area_m2[0]),
        "change the constraint or programme.floor_area_m2",
    )?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const STARTER: &str = include_str!("../../configs/starter.json");

    fn with(change: impl Fn(&mut serde_json::Value)) -> Result<Brief, BriefError> {
        let mut value: serde_json::Value = serde_json::from_str(STARTER).unwrap();
        change(&mut value);
        read_brief(value.to_string().as_bytes(), "b.json")
    }

    fn refusal(change: impl Fn(&mut serde_json::Value)) -> String {
        with(change).unwrap_err().to_string()
    }

    #[test]
    fn the_starter_brief_is_good() {
        assert!(with(|_| ()).is_ok());
    }

    #[test]
    fn an_unknown_key_is_named() {
        let text = refusal(|b| b["plot"]["module_mm"] = 900.into());
        assert!(text.contains("plot") && text.contains("module_mm") && text.contains("b.json:1:"), "{text}");
    }

    #[test]
    fn an_unknown_objective_lists_the_known_ones() {
        let text = refusal(|b| b["objectives"][0] = "price".into());
        assert!(text.contains("unknown objective `price`") || text.contains("expected an objective"), "{text}");
        assert!(text.contains("objectives"), "{text}");
    }

    #[test]
    fn a_plot_too_small_for_the_programme_says_by_how_much() {
        let text = refusal(|b| b["plot"]["modules"] = serde_json::json!([4, 4, 7]));
        assert!(text.contains("programme.floor_area_m2") && text.contains("13.0 m2"), "{text}");
    }

    #[test]
    fn storeys_must_fit_the_height() {
        let text = refusal(|b| b["programme"]["storeys"] = serde_json::json!([3, 3]));
        assert!(text.contains("at most 2 storeys"), "{text}");
    }

    #[test]
    fn constraints_name_objectives_and_can_be_kept_together() {
        assert!(refusal(|b| b["constraints"]["weight_max"] = 3.into()).contains("constraints.weight_max"));
        let clash = refusal(|b| {
            b["constraints"]["mass_kg_max"] = 1000.into();
            b["constraints"]["mass_kg_min"] = 2000.into();
        });
        assert!(clash.contains("together no house can keep them"), "{clash}");
        assert!(with(|b| b["constraints"]["mass_kg_max"] = 100_000.into()).is_ok());
    }

    #[test]
    fn a_site_is_a_preset_or_a_model() {
        let thesis = with(|b| {
            b["site"] = serde_json::json!({"preset": "thesis"});
            b["constraints"] = serde_json::json!({});
        });
        assert!(thesis.is_ok());
        assert!(refusal(|b| b["site"]["preset"] = "thesis".into()).contains("either a preset or a site model"));
        assert!(refusal(|b| b["site"]["terrain"] = "V".into()).contains("site.terrain"));
    }

    #[test]
    fn the_thesis_preset_gives_no_structural_figures() {
        let text = refusal(|b| {
            b["site"] = serde_json::json!({"preset": "thesis"});
            b["objectives"][0] = "utilisation".into();
        });
        assert!(text.contains("site.preset") && text.contains("utilisation"), "{text}");
        assert!(refusal(|b| b["site"]["vb0_m_s"] = 97.into()).contains("`site.vb0_m_s` is 97.0:"));
    }

    #[test]
    fn the_shipped_schema_is_the_types_schema() {
        let shipped: serde_json::Value = serde_json::from_str(include_str!("../../configs/brief.schema.json")).unwrap();
        assert_eq!(shipped, Brief::json_schema(), "run `houscaper schema brief > configs/brief.schema.json`");
    }
}
