//! Time and memory of a solve.

use std::time::{Duration, Instant};

/// Wall time of each phase of the last solve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Phases {
    /// Local axes and member stiffness.
    pub members: Duration,
    /// Idle dofs, minimum degree order of the nodes, equation numbers, pattern.
    pub ordering: Duration,
    /// Member loads, fixed-end forces, right-hand sides.
    pub loads: Duration,
    /// Stiffness of the frame.
    pub assembly: Duration,
    /// Elimination tree, supernodes, row lists.
    pub symbolic: Duration,
    /// Cholesky factor, and the search for mechanisms where a pivot asks for it.
    pub numeric: Duration,
    /// Solves of all cases with refinement, end forces, equilibrium, reactions.
    pub solution: Duration,
}

impl Phases {
    /// Names and times in the order of the work.
    pub fn each(&self) -> [(&'static str, Duration); 7] {
        [
            ("members", self.members),
            ("ordering", self.ordering),
            ("loads", self.loads),
            ("assembly", self.assembly),
            ("symbolic", self.symbolic),
            ("numeric", self.numeric),
            ("solution", self.solution),
        ]
    }

    /// Sum of all phases.
    pub fn total(&self) -> Duration {
        self.each().iter().map(|(_, d)| *d).sum()
    }
}

/// Size of the system of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Size {
    /// Equations.
    pub unknowns: usize,
    /// Stored entries of the lower triangle of the stiffness.
    pub stiffness_entries: usize,
    /// Stored entries of the Cholesky factor, padding of the supernodes included.
    pub factor_entries: usize,
    /// Bytes of stiffness, pattern, factor, its scratch space and right-hand sides; what the members and the results take is
    /// not counted.
    pub bytes: usize,
}

/// A stopwatch.
pub(super) struct Clock(Instant);

impl Clock {
    pub fn start() -> Self {
        Clock(Instant::now())
    }

    /// Time since the start or the last lap.
    pub fn lap(&mut self) -> Duration {
        let now = Instant::now();
        let lap = now - self.0;
        self.0 = now;
        lap
    }
}
