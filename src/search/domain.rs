//! What a searcher has to know of a kind of genome: how one begins, how one changes, and what is evaluated of it.

use super::niche::Niche;
use rand_chacha::ChaCha8Rng;
use std::fmt::Debug;

/// What made a design, by the name that tables show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Operator(pub &'static str);

impl Operator {
    /// The generator of starts.
    pub const START: Operator = Operator("start");
    /// A start that takes over what an earlier design has learnt ([`Domain::graft`]).
    pub const GRAFT: Operator = Operator("graft");
    /// [`Domain::polish`]: for houses the sizing of their sections.
    pub const POLISH: Operator = Operator("sizing");

    /// Name in tables.
    pub fn name(self) -> &'static str {
        self.0
    }
}

/// An operator that turns parents into a child.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arm {
    /// Its name, unique among the arms of a domain.
    pub operator: Operator,
    /// Parents it takes: 1 (a move) or 2 (a crossover).
    pub parents: usize,
    /// How often it is drawn among the arms with as many parents before anything is known of its success.
    pub weight: f64,
}

/// A kind of genome with its operators. All methods are pure: what they return depends on their arguments and on the random
/// numbers they draw, never on the order in which they are called.
pub trait Domain: Sync {
    /// What is changed and recombined.
    type Genome: Clone + Debug + PartialEq + Send + Sync;
    /// What is evaluated: the genome written out.
    type Form: Clone + Debug + Send + Sync;

    /// The operators, always the same and in the same order; at least one with a single parent.
    fn arms(&self) -> &[Arm];

    /// A new design; `None` when none was found.
    fn start(&self, rng: &mut ChaCha8Rng) -> Option<Self::Genome>;

    /// A child by arm `arm`, which differs from its parents; `None` when the operator cannot apply. A move sees `parents[0]` only.
    fn vary(&self, arm: usize, parents: [&Self::Genome; 2], rng: &mut ChaCha8Rng) -> Option<Self::Genome>;

    /// Writes a genome out.
    fn express(&self, genome: &Self::Genome) -> Self::Form;

    /// Identity of a design: equal for designs that need not be told apart, else different but for chance.
    fn key(&self, genome: &Self::Genome, form: &Self::Form) -> u128;

    /// The first hard rule that a design breaks.
    fn broken_rule(&self, _form: &Self::Form) -> Option<&'static str> {
        None
    }

    /// Whether `beaten` holds for bounds on the objectives of a design, none of them above what its evaluation would say, and found for
    /// much less than that. False where there is no such bound.
    fn is_beaten(&self, _genome: &Self::Genome, _form: &Self::Form, _beaten: &dyn Fn(&[f64]) -> bool) -> bool {
        false
    }

    /// The kind of a design by what can be seen of it, for quality-diversity; all the same where a domain knows no kinds.
    fn niche(&self, _genome: &Self::Genome) -> Niche {
        Niche::default()
    }

    /// Goals that [`Domain::polish`] knows; 0 when there is nothing to polish.
    fn goals(&self) -> usize {
        0
    }

    /// The same design with its cheap details made best for goal `goal`; `None` where that cannot be done or changes nothing.
    /// It may cost as much as several evaluations, so no design is polished twice for the same goal.
    fn polish(&self, _genome: &Self::Genome, _form: &Self::Form, _goal: usize) -> Option<Self::Genome> {
        None
    }

    /// A start with those details of `donor` that hang little on its shape; `None` where there are none.
    fn graft(&self, _start: &Self::Genome, _donor: &Self::Genome) -> Option<Self::Genome> {
        None
    }
}
