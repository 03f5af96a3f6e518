//! JSON lines in batches: an empty line closes a batch, which is then answered line by line, in parallel and in order.

use std::io::{BufRead, Write};

use anyhow::Context;
use rayon::prelude::*;
use serde_json::Value;

use super::failure::{Blame, Outcome};

/// Answers batches until the input ends; what stands in front of the end is a batch too. `read` gets a line without blanks around
/// it and its number from 1, `answer` what was made of it.
pub fn answer_batches<T: Send>(
    mut lines: impl BufRead,
    mut answers: impl Write,
    read: impl Fn(&[u8], usize) -> T,
    answer: impl Fn(T) -> Value + Sync,
) -> Outcome {
    let mut batch: Vec<T> = Vec::new();
    let mut bytes = Vec::new();
    for number in 1.. {
        bytes.clear();
        let ended = lines.read_until(b'\n', &mut bytes).context("cannot read lines").run()? == 0;
        let line = bytes.trim_ascii();
        if !line.is_empty() {
            batch.push(read(line, number));
            continue;
        }
        let rows: Vec<Value> = std::mem::take(&mut batch).into_par_iter().map(&answer).collect();
        rows.iter()
            .try_for_each(|row| writeln!(answers, "{row}"))
            .and_then(|()| answers.flush())
            .context("cannot write answers")
            .run()?;
        if ended {
            break;
        }
    }
    Ok(())
}
