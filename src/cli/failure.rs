//! What ends a command, and with which exit code.

use std::fmt::Display;

/// Why a command ended early.
pub enum Failure {
    /// The input is wrong, or a check found violations: exit code 2.
    Input(anyhow::Error),
    /// The run failed: exit code 1.
    Run(anyhow::Error),
    /// A check found something and has already said so: exit code 2.
    Found,
}

/// What every command returns.
pub type Outcome = Result<(), Failure>;

/// Marks errors as the input's or the run's.
pub trait Blame<T> {
    /// The input is to blame.
    fn input(self) -> Result<T, Failure>;
    /// The run is to blame.
    fn run(self) -> Result<T, Failure>;
}

impl<T, E: Into<anyhow::Error>> Blame<T> for Result<T, E> {
    fn input(self) -> Result<T, Failure> {
        self.map_err(|e| Failure::Input(e.into()))
    }

    fn run(self) -> Result<T, Failure> {
        self.map_err(|e| Failure::Run(e.into()))
    }
}

/// An input error from a sentence.
pub fn bad_input(message: impl Display) -> Failure {
    Failure::Input(anyhow::anyhow!("{message}"))
}
