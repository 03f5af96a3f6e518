//! The command line: parses arguments, calls the library, speaks to people on stderr and to programs on stdout.

mod args;
mod build;

mod failure;
mod home;
mod input;
mod optimize;
mod progress;
mod schema;

use std::process::ExitCode;

use clap::Parser;

use args::{Cli, Command};
use failure::{Failure, Outcome};

/// Runs the command line: 0 fine, 1 the run failed, 2 the input is wrong or a check found violations.
pub fn run() -> ExitCode {
    let cli = Cli::parse();
    match dispatch(cli) {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Found) => ExitCode::from(2),
        Err(Failure::Input(error)) => complain(&error, 2),
        Err(Failure::Run(error)) => complain(&error, 1),
    }
}

fn dispatch(cli: Cli) -> Outcome {
    let json = cli.json;
    match cli.command {
        Command::Optimize(args) => optimize::run(args, json),
        Command::Build(args) => build::run(args, json),
        Command::Schema(args) => schema::run(args),
        _ => Ok(()),
    }
}

fn complain(error: &anyhow::Error, code: u8) -> ExitCode {
    eprintln!("error: {error:#}");
    ExitCode::from(code)
}
