//! The progress bar of a search.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar with evaluations, rate, front size, hypervolume and time left; silent when stderr is no terminal.
pub struct SearchBar {
    bar: ProgressBar,
}

impl SearchBar {
    /// A bar over `total` evaluations.
    pub fn new(total: u64) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::stderr_with_hz(8));
        let template = "{bar:32} {pos}/{len} evaluations  {per_sec:>10}  {msg}  {eta} left";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.enable_steady_tick(Duration::from_millis(500));
        SearchBar { bar }
    }

    /// Moves the bar.
    pub fn update(&self, evaluations: u64, front: usize, hypervolume: Option<f64>) {
        let hypervolume = hypervolume.map_or("-".to_owned(), |h| format!("{h:.4}"));
        self.bar.set_message(format!("front {front}  hypervolume {hypervolume}"));
        self.bar.set_position(evaluations);
    }

    /// Removes the bar.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// A bar over pieces of work of one kind; silent when stderr is no terminal.
pub struct WorkBar {
    bar: ProgressBar,
}

impl WorkBar {
    /// A bar over `total` pieces called `unit`.
    pub fn new(total: usize, unit: &str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total as u64), ProgressDrawTarget::stderr_with_hz(8));
        if let Ok(style) = ProgressStyle::with_template(&format!("{{bar:32}} {{pos}}/{{len}} {unit}  {{eta}} left")) {
            bar.set_style(style.progress_chars("=> "));
        }
        WorkBar { bar }
    }

    /// One more done.
    pub fn step(&self) {
        self.bar.inc(1);
    }
}

impl Drop for WorkBar {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
