//! Lattices of any values, value by value: between .csv and .npy.

use std::path::Path;

use houscaper::voxels::Module;
use houscaper::voxels::lattice::{Lattice, Values, write_lattice, write_npy};

use super::super::args::Convert;
use super::super::failure::{Failure, Outcome, bad_input};
use super::super::{input, output};

fn is(path: &Path, extension: &str) -> bool {
    path.extension().is_some_and(|e| e == extension)
}

/// The lattice to convert; `None` where what is asked for needs a house or is no such conversion.
pub fn read(args: &Convert) -> Result<Option<Lattice>, Failure> {
    let (from, to) = (&args.input, &args.output);
    let between = is(from, "csv") && is(to, "npy") || is(from, "npy") && is(to, "csv");
    let as_house = args.repair || args.ground || args.import.house || args.import.occupied.is_some();
    let cells = args.cell_modules.is_some() || args.crop.is_some();
    if !between || as_house || cells {
        return Ok(None);
    }
    let import = &args.import;
    if is(from, "csv") && (import.module.is_some() || import.origin.is_some()) {
        return Err(bad_input(format!(
            "{}: says its unit and minbound itself; --module and --origin are for .npy",
            from.display()
        )));
    }
    let read = input::lattice(&input::bytes(from)?, from)?;
    let unit = import.module.unwrap_or(read.unit);
    if unit.iter().any(|s| *s <= 0.0) {
        return Err(bad_input(format!("--module {unit:?}: expected three lengths above 0, in metres")));
    }
    Ok(Some(Lattice { unit, minbound: import.origin.unwrap_or(read.minbound), ..read }))
}

pub fn write(args: &Convert, lattice: &Lattice) -> Outcome {
    let to_npy = is(&args.output, "npy");
    let bytes = if to_npy { write_npy(lattice) } else { write_lattice(lattice) };
    output::write(&args.output, &bytes)?;
    let [nx, ny, nz] = lattice.shape;
    let kind = match lattice.values {
        Values::Bool(_) => "booleans",
        Values::Number(_) => "numbers",
    };
    eprintln!("{}: {nx} x {ny} x {nz} {kind}", args.output.display());
    if to_npy && (lattice.unit != Module::default().size_m || lattice.minbound != [0.0; 3]) {
        eprintln!(
            "note: unit {:?} and minbound {:?} are not stored; --module and --origin say them when the file is read",
            lattice.unit, lattice.minbound
        );
    }
    Ok(())
}
