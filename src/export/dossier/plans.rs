//! Storey plans of a house from the contours of its storeys.

use crate::cubes::contours;
use crate::export::plan::{PlanFlight, PlanOpening, PlanOpeningKind, StoreyPlan, plan_svg};
use crate::voxels::{Direction, FacadeOpening, House, Label, Reading, Stair, StairKind};

/// One SVG a storey, lowest first.
pub fn storey_plans(house: &House, reading: &Reading) -> Vec<String> {
    let place = Place::of(house);
    reading
        .storeys
        .iter()
        .map(|storey| {
            let title = format!("{}, {:.1} m² net", storey_name(storey.index), storey.floor_area_m2);
            let openings = reading.openings.iter().filter(|o| o.storey == storey.index).map(|o| place.opening(o));
            let stairs = house.stairs.iter().filter(|s| s.storey == storey.index);
            plan_svg(&StoreyPlan {
                title,
                loops: contours(&storey.plan)
                    .into_iter()
                    .map(|l| l.into_iter().map(|p| place.half(p)).collect())
                    .collect(),
                openings: openings.collect(),
                flights: stairs.flat_map(|s| place.flights(s)).collect(),
                landings: house
                    .stairs
                    .iter()
                    .filter(|s| s.storey == storey.index)
                    .filter_map(|s| place.landing(s))
                    .collect(),
                voids: reading
                    .plates
                    .iter()
                    .filter(|plate| plate.k == storey.plate_k)
                    .flat_map(|plate| contours(&plate.void))
                    .map(|l| l.into_iter().map(|p| place.half(p)).collect())
                    .collect(),
                grid_m: place.module[0],
            })
        })
        .collect()
}

fn storey_name(index: usize) -> String {
    match index {
        0 => "Ground storey".into(),
        n => format!("Storey {n}"),
    }
}

struct Place {
    origin: [f64; 2],
    module: [f64; 2],
}

impl Place {
    fn of(house: &House) -> Self {
        let ([ox, oy, _], [sx, sy, _]) = (house.voxels.origin_m, house.voxels.module.size_m);
        Place { origin: [ox - 0.5 * sx, oy - 0.5 * sy], module: [sx, sy] }
    }

    /// A point in modules from the corner of cell (0, 0).
    fn at(&self, x: f64, y: f64) -> [f64; 2] {
        [self.origin[0] + x * self.module[0], self.origin[1] + y * self.module[1]]
    }

    /// A point in half modules from the centre of cell (0, 0), as contours have it.
    fn half(&self, [x, y]: [i32; 2]) -> [f64; 2] {
        self.at(0.5 + f64::from(x) / 2.0, 0.5 + f64::from(y) / 2.0)
    }

    /// Ends of an opening on the facade line, the outside on the right.
    fn opening(&self, o: &FacadeOpening) -> PlanOpening {
        let [x, y] = o.cell.map(|c| c as f64);
        let w = o.width as f64;
        let (from, to) = match o.facing {
            Direction::South => ([x, y], [x + w, y]),
            Direction::East => ([x + 1.0, y], [x + 1.0, y + w]),
            Direction::North => ([x + w, y + 1.0], [x, y + 1.0]),
            Direction::West => ([x, y + w], [x, y]),
        };
        let kind = if o.label == Label::Opening { PlanOpeningKind::Door } else { PlanOpeningKind::Window };
        PlanOpening { kind, from: self.at(from[0], from[1]), to: self.at(to[0], to[1]) }
    }

    /// The outline of the landing between two flights.
    fn landing(&self, stair: &Stair) -> Option<Vec<[f64; 2]>> {
        let cells = stair.middle_landing();
        let (first, rest) = cells.split_first()?;
        let bound =
            |axis: usize, pick: fn(isize, isize) -> isize| rest.iter().fold(first[axis], |b, c| pick(b, c[axis]));
        let (low, high) =
            ([0, 1].map(|a| bound(a, isize::min) as f64), [0, 1].map(|a| bound(a, isize::max) as f64 + 1.0));
        Some(
            [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]]
                .map(|[x, y]| self.at(x, y))
                .to_vec(),
        )
    }

    fn flights(&self, stair: &Stair) -> Vec<PlanFlight> {
        let cells = stair.flight_cells();
        let runs: Vec<&[[isize; 2]]> = match stair.kind {
            StairKind::Straight => vec![&cells[..]],
            StairKind::UTurn => vec![&cells[..3], &cells[3..]],
        };
        let flight = |run: &[[isize; 2]], direction: Direction| {
            let [dx, dy] = direction.step().map(|d| d as f64 * 0.5);
            let centre = |c: [isize; 2]| [c[0] as f64 + 0.5, c[1] as f64 + 0.5];
            let (a, b) = (centre(run[0]), centre(run[run.len() - 1]));
            let across = usize::from(direction.step()[0] != 0);
            PlanFlight {
                from: self.at(a[0] - dx, a[1] - dy),
                to: self.at(b[0] + dx, b[1] + dy),
                width_m: self.module[across],
                treads: 3 * run.len(),
            }
        };
        runs.iter().enumerate().map(|(n, run)| flight(run, if n == 0 { stair.run } else { stair.run.back() })).collect()
    }
}
