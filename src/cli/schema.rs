//! `houscaper schema`: the JSON Schema of a file format.

use houscaper::brief::Brief;
use houscaper::structure::member::member_schema;
use houscaper::tiles::tileset_schema;

use super::args::{Format, Schema};
use super::failure::{Blame, Outcome};
use super::output::say;

pub fn run(args: Schema) -> Outcome {
    let schema = match args.format {
        Format::Brief => Brief::json_schema(),
        Format::Tileset => tileset_schema(),
        Format::Member => member_schema(),
    };
    say!("{}", serde_json::to_string_pretty(&schema).run()?);
    Ok(())
}
