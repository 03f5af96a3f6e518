//! The command line: parses arguments, calls the library, speaks to people on stderr and to programs on stdout.

mod args;
mod build;
mod check;
mod choices;
mod compare;
mod convert;
mod cubes;
mod enumerate;
mod evaluate;
mod failure;
mod genome;
mod home;
mod improve;
mod input;
mod lines;
mod member;
mod optimize;
mod output;
mod picture;
mod progress;
mod quote;
mod report;
mod schema;
mod solve;
mod space;
mod tileset;
mod vary;
mod worker;

use std::process::ExitCode;

use clap::Parser;

use args::{Cli, Command};
use failure::{Failure, Outcome};

/// Runs the command line: 0 fine, 1 the run failed, 2 the input is wrong or a check found violations.
pub fn run() -> ExitCode {
    let cli = Cli::parse();
    match home::check().and_then(|()| dispatch(cli)) {
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
        Command::Resume(args) => optimize::resume::run(args, json),
        Command::Merge(args) => optimize::merge::run(args, json),
        Command::Build(args) => build::run(args, json),
        Command::Compare(args) => compare::run(args, json),
        Command::Picture(args) => picture::run(args, json),
        Command::Quote(args) => quote::run(args, json),
        Command::Report(args) => report::run(&args, json),
        Command::Check(args) => check::run(args, json),
        Command::Cubes(args) => cubes::run(args),
        Command::Enumerate(args) => enumerate::run(args),
        Command::Evaluate(args) => evaluate::run(args),
        Command::Improve(args) => improve::run(args, json),
        Command::Vary(args) => vary::run(args),
        Command::Solve(args) => solve::run(args, json),
        Command::Member(args) => member::run(*args, json),
        Command::Convert(args) => convert::run(args),
        Command::Tileset(args) => tileset::run(args, json),
        Command::Schema(args) => schema::run(args),
        Command::Worker(args) => worker::run(&args),
    }
}

fn complain(error: &anyhow::Error, code: u8) -> ExitCode {
    // Many errors print their cause themselves: a cause already said is not said again.
    let text = error.chain().fold(String::new(), |text, cause| {
        let cause = cause.to_string();
        match text.is_empty() {
            true => cause,
            false if text.contains(&cause) => text,
            false => format!("{text}: {cause}"),
        }
    });
    eprintln!("error: {text}");
    ExitCode::from(code)
}
