//! Which values count as occupied.

use super::Values;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// How a value is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Comparison {
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
}

const COMPARISONS: [(&str, Comparison); 6] = [
    ("==", Comparison::Equal),
    ("!=", Comparison::NotEqual),
    ("<=", Comparison::LessEqual),
    (">=", Comparison::GreaterEqual),
    ("<", Comparison::Less),
    (">", Comparison::Greater),
];

#[derive(Clone, Copy, Debug, PartialEq)]
enum Operand {
    Bool(bool),
    Number(f64),
}

/// A rule such as `>= 0`, `== True`, `> 0.5` or `!= -1`: the cells that satisfy it are occupied.
///
/// ```
/// use houscaper::voxels::lattice::{Occupancy, Values};
/// let zones: Occupancy = ">= 0".parse()?;
/// assert_eq!(zones.mask(&Values::Number(vec![-1.0, 0.0, 2.0]))?, [false, true, true]);
/// # Ok::<(), houscaper::voxels::lattice::OccupancyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Occupancy {
    comparison: Comparison,
    operand: Operand,
}

/// What is wrong with an occupancy rule.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OccupancyError {
    /// No rule given.
    #[error(
        "no occupancy rule: say which values are occupied, `== True` (boolean envelope), `>= 0` or `!= -1` (zones), or a threshold such as `> 0.5` (field)"
    )]
    Missing,
    /// A rule that does not parse.
    #[error(
        "`{found}` is no occupancy rule: expected one of ==, !=, <, <=, >, >= and a number, True or False, e.g. `>= 0`, `== True`, `> 0.5`, `!= -1`"
    )]
    Parse {
        /// The text.
        found: String,
    },
    /// A rule for the other kind of values.
    #[error("`{rule}` cannot be asked of {values}; use {instead}")]
    Kind {
        /// The rule.
        rule: String,
        /// What the lattice holds.
        values: &'static str,
        /// Rules that fit.
        instead: &'static str,
    },
}

impl Occupancy {
    /// The rule in `text`; an import without one is an error that tells the choices.
    ///
    /// # Errors
    /// No rule, or one that does not parse.
    pub fn require(text: Option<&str>) -> Result<Self, OccupancyError> {
        text.ok_or(OccupancyError::Missing)?.parse()
    }

    /// Which values are occupied, in their order.
    ///
    /// # Errors
    /// Numbers compared with True or False, or the other way round.
    pub fn mask(&self, values: &Values) -> Result<Vec<bool>, OccupancyError> {
        let wrong = |values, instead| OccupancyError::Kind { rule: self.to_string(), values, instead };
        match (values, self.operand) {
            (Values::Bool(v), Operand::Bool(b)) => {
                let equal = self.comparison == Comparison::Equal;
                Ok(v.iter().map(|x| (*x == b) == equal).collect())
            }
            (Values::Number(v), Operand::Number(n)) => Ok(v.iter().map(|x| self.comparison.holds(*x, n)).collect()),
            (Values::Bool(_), Operand::Number(_)) => {
                Err(wrong("a lattice of True and False", "`== True` or `== False`"))
            }
            (Values::Number(_), Operand::Bool(_)) => Err(wrong("a lattice of numbers", "`>= 0`, `!= -1` or `> 0.5`")),
        }
    }
}

impl Comparison {
    fn holds(self, a: f64, b: f64) -> bool {
        match self {
            Comparison::Equal => a == b,
            Comparison::NotEqual => a != b,
            Comparison::Less => a < b,
            Comparison::LessEqual => a <= b,
            Comparison::Greater => a > b,
            Comparison::GreaterEqual => a >= b,
        }
    }
}

impl FromStr for Occupancy {
    type Err = OccupancyError;

    fn from_str(text: &str) -> Result<Self, OccupancyError> {
        let error = || OccupancyError::Parse { found: text.to_string() };
        let trimmed = text.trim();
        let (rest, comparison) =
            COMPARISONS.iter().find_map(|(sign, c)| Some((trimmed.strip_prefix(sign)?, *c))).ok_or_else(error)?;
        let operand = match rest.trim() {
            "True" | "true" => Operand::Bool(true),
            "False" | "false" => Operand::Bool(false),
            number => Operand::Number(number.parse().ok().filter(|n: &f64| n.is_finite()).ok_or_else(error)?),
        };
        let ordered = !matches!(comparison, Comparison::Equal | Comparison::NotEqual);
        if ordered && matches!(operand, Operand::Bool(_)) {
            return Err(error());
        }
        Ok(Occupancy { comparison, operand })
    }
}

impl fmt::Display for Occupancy {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let sign = COMPARISONS.iter().find(|(_, c)| *c == self.comparison).map_or("==", |(sign, _)| sign);
        match self.operand {
            Operand::Bool(true) => write!(f, "{sign} True"),
            Operand::Bool(false) => write!(f, "{sign} False"),
            Operand::Number(n) => write!(f, "{sign} {n}"),
        }
    }
}

impl TryFrom<String> for Occupancy {
    type Error = OccupancyError;

    fn try_from(text: String) -> Result<Self, OccupancyError> {
        text.parse()
    }
}

impl From<Occupancy> for String {
    fn from(rule: Occupancy) -> String {
        rule.to_string()
    }
}
