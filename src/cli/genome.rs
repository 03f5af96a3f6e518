//! A genome as JSON, as `evaluate --batch --genome` and `vary` read it and `vary` writes it: `shape`, `labels` (x fastest, then y,
//! then z), `stairs` and `choices`.

use houscaper::score::Evaluator;
use houscaper::voxels::{Choice, Choices, House, Label, Stair, VoxelArray, infer_stairs};
use serde::Deserialize;
use serde_json::{Map, Value, json};

/// A genome as a program writes it. Keys beside these are errors.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Written {
    /// Modules along x, y and z: those of the plot.
    pub shape: [usize; 3],
    /// Labels 0 to 5, x fastest, then y, then z.
    pub labels: Vec<u8>,
    /// Stairs as in our voxel files; read from the voids of the plates where they are left out.
    #[serde(default)]
    pub stairs: Option<Vec<Stair>>,
    /// Choices by name; the first option where one is left out.
    #[serde(default)]
    pub choices: Option<Map<String, Value>>,
}

/// The house and its choices.
///
/// # Errors
/// A sentence with the key, what was found and what was expected.
pub fn read(written: Written, evaluator: &Evaluator) -> Result<(House, Choices), String> {
    let plot = evaluator.brief.plot.modules;
    if written.shape != plot {
        return Err(format!("shape is {:?}, expected {plot:?} as in plot.modules of the brief", written.shape));
    }
    let labels = written
        .labels
        .iter()
        .enumerate()
        .map(|(n, &code)| {
            Label::from_code(code).ok_or_else(|| format!("labels[{n}] is {code}, expected a label from 0 to 5"))
        })
        .collect::<Result<Vec<Label>, String>>()?;
    let (found, expected) = (labels.len(), plot.iter().product::<usize>());
    let mut voxels = VoxelArray::from_labels(plot, labels)
        .ok_or_else(|| format!("{found} labels, expected {expected} for shape {plot:?}"))?;
    voxels.module.size_m = evaluator.brief.plot.module_m;
    let stairs = match written.stairs {
        Some(stairs) => inside(stairs, plot)?,
        None => infer_stairs(&voxels),
    };
    let choices = match written.choices {
        Some(choices) => super::choices::read(&choices, evaluator)?,
        None => Choices::default(),
    };
    Ok((House { stairs, ..House::new(voxels) }, choices))
}

fn inside(stairs: Vec<Stair>, [nx, ny, nz]: [usize; 3]) -> Result<Vec<Stair>, String> {
    let outside = stairs.iter().position(|s| s.start[0] >= nx || s.start[1] >= ny || s.storey >= nz);
    match outside {
        Some(n) => Err(format!(
            "stairs[{n}] is in storey {} at {:?}, expected a storey and a start cell inside the plot",
            stairs[n].storey, stairs[n].start
        )),
        None => Ok(stairs),
    }
}

/// The keys of a genome, with choices by name.
pub fn write(house: &House, choices: &Choices, evaluator: &Evaluator) -> Map<String, Value> {
    let labels: Vec<u8> = house.voxels.labels().iter().map(|l| l.code()).collect();
    let mut map = Map::new();
    map.insert("shape".into(), json!(house.voxels.shape()));
    map.insert("labels".into(), json!(labels));
    map.insert("stairs".into(), json!(house.stairs));
    map.insert("choices".into(), choices_json(choices, house.stairs.len() + 1, evaluator));
    map
}

/// Choices by name, as `--choices` reads them; a letter for the joists of each of `plates` plates above ground.
pub fn choices_json(choices: &Choices, plates: usize, evaluator: &Evaluator) -> Value {
    let sections =
        [Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof].into_iter().zip(evaluator.sections(choices));
    let mut map: Map<String, Value> =
        sections.map(|(c, option)| (c.name().to_owned(), json!(evaluator.catalogue.option_name(option)))).collect();
    // Bits beyond the plates are kept: what is read back is the same.
    let bits = 16 - (choices.get(Choice::Joists) as u16).leading_zeros() as usize;
    let axes = (0..plates.clamp(bits, 16)).map(|p| if choices.joists_along_y(p) { 'y' } else { 'x' });
    map.insert(Choice::Joists.name().to_owned(), json!(axes.collect::<String>()));
    map.insert(Choice::Boards.name().to_owned(), json!(evaluator.boards(choices)));
    Value::Object(map)
}
