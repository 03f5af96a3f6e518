//! Lines on stdout, and single files: whole or not at all, and never over the input.

use std::fmt::Arguments;
use std::io::Write;
use std::path::{Path, PathBuf};

use anyhow::Context;

use super::failure::{Blame, Failure, bad_input};

/// Refuses an output that is the input, or that lies in a folder which does not exist. Called before any work is done.
pub fn check_target(output: &Path, input: &Path) -> Result<(), Failure> {
    if output.is_dir() {
        return Err(bad_input(format!("{}: is a folder; name a file", output.display())));
    }
    let folder = folder_of(output);
    if !folder.is_dir() {
        return Err(bad_input(format!(
            "{}: the folder {} does not exist; make it first",
            output.display(),
            folder.display()
        )));
    }
    let same = matches!((output.canonicalize(), input.canonicalize()), (Ok(a), Ok(b)) if a == b);
    if same {
        return Err(bad_input(format!("{}: is the input itself; name another output", output.display())));
    }
    Ok(())
}

/// Refuses an output folder that holds anything. Called before any work is done.
pub fn check_folder(out: &Path) -> Result<(), Failure> {
    let taken = out.exists() && out.read_dir().map(|mut d| d.next().is_some()).unwrap_or(true);
    match taken {
        true => Err(bad_input(format!("{}: exists and is not empty; choose another --out", out.display()))),
        false => Ok(()),
    }
}

/// As [`check_target`] for a picture: refuses names that promise another format.
pub fn check_picture(output: &Path, input: &Path) -> Result<(), Failure> {
    let is_png = output.extension().is_some_and(|e| e.eq_ignore_ascii_case("png"));
    if !is_png && !output.is_dir() {
        return Err(bad_input(format!(
            "{}: pictures are written as PNG; name a file ending in .png",
            output.display()
        )));
    }
    check_target(output, input)
}

/// Writes a file into a temporary one beside it and renames that.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let part = path.with_file_name(format!(".{name}.part"));
    let written = std::fs::write(&part, bytes).and_then(|()| std::fs::rename(&part, path));
    if written.is_err() {
        // The first error is the one to report; there may be nothing to remove.
        let _ = std::fs::remove_file(&part);
    }
    written.with_context(|| format!("cannot write {}", path.display())).run()
}

fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_path_buf(),
        _ => PathBuf::from("."),
    }
}

/// Prints a line on stdout; a reader that has gone away (`| head`) ends the program quietly instead of with a panic.
macro_rules! say {
    ($($part:tt)*) => { $crate::cli::output::line(format_args!($($part)*)) };
}
pub(in crate::cli) use say;

/// See [`say`].
pub fn line(text: Arguments) {
    if writeln!(std::io::stdout().lock(), "{text}").is_err() {
        std::process::exit(0);
    }
}
