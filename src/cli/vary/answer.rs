//! What `vary` answers to a line.

use houscaper::score::{Evaluator, SizingGoal};
use houscaper::search::domain::{Domain, Operator};
use houscaper::search::houses::Houses;
use houscaper::search::massing::Design;
use houscaper::search::repair::repair;
use houscaper::voxels::Choice;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Map, Value, json};

use super::request::{Line, Task};
use crate::cli::genome::{self, Written};

/// Draws before a request is given up: as many as the search itself makes for one candidate.
const TRIES: usize = 48;

/// Everything that houses are varied with.
pub struct Workshop<'a> {
    /// Rules, options, books.
    pub evaluator: &'a Evaluator,
    /// The operators.
    pub houses: Houses<'a>,
    /// What sections may be sized for.
    pub goals: &'a [SizingGoal],
}

impl Workshop<'_> {
    /// The answer to a line.
    pub fn answer(&self, line: Line) -> Value {
        let made = line.task.and_then(|task| self.perform(task));
        let mut map = made.unwrap_or_else(|error| {
            Map::from_iter([("error".to_owned(), json!(format!("line {}: {error}", line.number)))])
        });
        map.insert("id".into(), line.id);
        Value::Object(map)
    }

    fn perform(&self, task: Task) -> Result<Map<String, Value>, String> {
        match task {
            Task::Start { seed, stream } => self.start(seed, stream),
            Task::Move { parent, seed, named, steps } => self.moved(&self.parent(parent)?, seed, named, steps),
            Task::Crossover { parents: [a, b], seed } => self.crossed(&self.parent(a)?, &self.parent(b)?, seed),
            Task::Size { parent, goal } => self.sized(&self.parent(parent)?, goal),
            Task::Repair { parent } => self.child(Operator("repair"), &self.parent(parent)?),
            Task::Space => Ok(self.space()),
        }
    }

    /// The genome of a parent, repaired where it is none of the search's.
    fn parent(&self, written: Written) -> Result<Design, String> {
        let (house, choices) = genome::read(written, self.evaluator)?;
        repair(&house, choices, self.houses.space).map_err(|error| error.to_string())
    }

    fn start(&self, seed: u64, stream: u64) -> Result<Map<String, Value>, String> {
        let mut rng = rng(seed, stream);
        let drawn = (0..TRIES).find_map(|_| {
            let design = self.houses.start(&mut rng)?;
            self.child(Operator::START, &design).ok()
        });
        drawn.ok_or_else(|| {
            "no start was found; `houscaper optimize` says which key of the brief stands in the way".into()
        })
    }

    fn moved(
        &self,
        parent: &Design,
        seed: u64,
        named: Option<String>,
        steps: usize,
    ) -> Result<Map<String, Value>, String> {
        let arms = self.houses.arms();
        let moves: Vec<usize> = (0..arms.len()).filter(|&i| arms[i].parents == 1).collect();
        let asked = match &named {
            None => None,
            Some(name) => Some(moves.iter().copied().find(|&i| arms[i].operator.name() == name).ok_or_else(|| {
                let names: Vec<&str> = moves.iter().map(|&i| arms[i].operator.name()).collect();
                format!("move is \"{name}\", expected one of {}", names.join(", "))
            })?),
        };
        let total: f64 = moves.iter().map(|&i| arms[i].weight).sum();
        let draw = |rng: &mut ChaCha8Rng| {
            let mut at = rng.random::<f64>() * total;
            let drawn = moves.iter().copied().find(|&i| {
                at -= arms[i].weight;
                at < 0.0
            });
            asked.or(drawn).unwrap_or(0)
        };
        let mut rng = rng(seed, 0);
        for _ in 0..TRIES {
            let mut made: Option<(Operator, Design)> = None;
            for _ in 0..steps {
                let arm = draw(&mut rng);
                let from = made.as_ref().map_or(parent, |m| &m.1);
                if let Some(next) = self.houses.vary(arm, [from, from], &mut rng) {
                    made = Some((arms[arm].operator, next));
                }
            }
            let child =
                made.filter(|(_, design)| design != parent).map(|(operator, design)| self.child(operator, &design));
            if let Some(Ok(child)) = child {
                return Ok(child);
            }
        }
        Err(format!("no child: {} did not apply in {TRIES} draws", named.as_deref().unwrap_or("moves")))
    }

    fn crossed(&self, a: &Design, b: &Design, seed: u64) -> Result<Map<String, Value>, String> {
        let arms = self.houses.arms();
        let crossovers: Vec<usize> = (0..arms.len()).filter(|&i| arms[i].parents == 2).collect();
        let mut rng = rng(seed, 0);
        let made = (0..TRIES).find_map(|_| {
            let arm = crossovers[rng.random_range(0..crossovers.len().max(1))];
            let design = self.houses.vary(arm, [a, b], &mut rng)?;
            self.child(arms[arm].operator, &design).ok()
        });
        made.ok_or_else(|| format!("no child: the parents did not combine in {TRIES} draws"))
    }

    fn sized(&self, parent: &Design, goal: Option<String>) -> Result<Map<String, Value>, String> {
        let index = match &goal {
            None => 0,
            Some(name) => self.goals.iter().position(|g| g.name() == name).ok_or_else(|| {
                let names: Vec<&str> = self.goals.iter().map(|g| g.name()).collect();
                format!("goal is \"{name}\", expected one of {}", names.join(", "))
            })?,
        };
        let sized = self.houses.polish(parent, &self.houses.express(parent), index);
        let design = sized.ok_or("no child: no other sections pass all checks at less cost")?;
        self.child(Operator::POLISH, &design)
    }

    /// The answer with a child; an error when it breaks a rule that settling does not know.
    fn child(&self, operator: Operator, design: &Design) -> Result<Map<String, Value>, String> {
        let house = self.houses.express(design);
        if let Some(rule) = self.houses.broken_rule(&house) {
            return Err(format!("no child: it would break the rule {rule}"));
        }
        let mut map = genome::write(&house, &design.choices, self.evaluator);
        map.insert("operator".into(), json!(operator.name()));
        Ok(map)
    }

    fn space(&self) -> Map<String, Value> {
        let operators: Vec<Value> = self
            .houses
            .arms()
            .iter()
            .map(|arm| json!({"name": arm.operator.name(), "parents": arm.parents, "weight": arm.weight}))
            .collect();
        let evaluator = self.evaluator;
        let names = |choice: Choice| -> Vec<String> {
            let options = &evaluator.options[choice as usize];
            options.iter().map(|o| evaluator.catalogue.option_name(*o)).collect()
        };
        let choices: Map<String, Value> = Choice::ALL
            .into_iter()
            .map(|choice| {
                let value = match choice {
                    Choice::Wall | Choice::Floor | Choice::Beam | Choice::Roof => json!(names(choice)),
                    Choice::Joists => json!(["x", "y"]),
                    Choice::Boards => json!(evaluator.brief.wall_boards),
                };
                (choice.name().to_owned(), value)
            })
            .collect();
        let space = self.houses.space;
        let [least, most] = [space.least_storeys(), space.most_storeys()];
        Map::from_iter([
            ("shape".to_owned(), json!(space.plot.modules)),
            ("storeys".to_owned(), json!([least, most])),
            ("operators".to_owned(), json!(operators)),
            ("choices".to_owned(), Value::Object(choices)),
            ("goals".to_owned(), json!(self.goals.iter().map(|g| g.name()).collect::<Vec<_>>())),
        ])
    }
}

/// The random numbers of a line: those that the search draws from for the candidate of that stream.
fn rng(seed: u64, stream: u64) -> ChaCha8Rng {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(stream);
    rng
}
