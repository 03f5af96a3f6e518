//! The Khronos glTF validator.

use std::path::PathBuf;
use std::process::Command;

/// Runs it over files, where node and the validator are there: no errors, no warnings.
pub fn validate(files: &[PathBuf]) {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/tools/validate_glb.mjs");
    let Ok(run) = Command::new("node").arg(script).args(files).output() else {
        return println!("skipped: node is not installed");
    };
    let said = format!("{}{}", String::from_utf8_lossy(&run.stdout), String::from_utf8_lossy(&run.stderr));
    if run.status.code() == Some(3) {
        return println!("skipped: {said}");
    }
    println!("{said}");
    assert!(run.status.success(), "{said}");
}
