//! The `houscaper` command.
fn main() {}
