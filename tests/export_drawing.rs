//! Drawings of houses against numbers found in other ways: sections of single blocks, cells of the plan, slow twins.

use std::path::PathBuf;

use houscaper::brief::read_brief;
use houscaper::envelope::{CubeTile, Fabric};
use houscaper::export::Scene;
use houscaper::export::dossier::house_scene;
use houscaper::export::drawing::*;
use houscaper::export::plots::svg_to_png;
use houscaper::score::{Details, Evaluator, Paths, Tiling};
use houscaper::voxels::{Direction, FacadeOpening, House, Label, Storey, samples};

fn evaluator(tileset: &str) -> Evaluator {
    let home = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let configs = home.join("configs");
    let brief =
        read_brief(&std::fs::read(configs.join("starter.json")).expect("a shipped brief"), "starter").expect("a brief");
    let paths = Paths {
        brief: configs.clone(),
        tileset: home.join("tilesets/architectural"),
        linear: home.join("tilesets/linear"),
        configs,
    };
    let mut evaluator = Evaluator::load(brief, &paths).expect("its books");
    evaluator.tiling = Tiling::load(&home.join("tilesets").join(tileset), &evaluator.books).expect("a shipped tileset");
    evaluator
}

/// A sample with its details and what `house.glb` shows of it.
struct Built {
    name: &'static str,
    house: House,
    details: Details,
    fabric: Option<Fabric>,
    scene: Scene,
}

impl Built {
    fn new(evaluator: &Evaluator, name: &'static str) -> Built {
        let mut houses = samples::gallery();
        houses.extend(samples::all());
        let house = houses.into_iter().find(|(n, _)| *n == name).expect("a sample").1;
        let details = evaluator.details(&house, &Default::default());
        let fabric = evaluator.tiling.fabric(&house, &details.reading);
        let scene = house_scene(name, &house, &details, evaluator, fabric.as_ref()).expect("solids");
        Built { name, house, details, fabric, scene }
    }

    fn subject(&self) -> Subject<'_> {
        Subject::new(self.name, &self.house, &self.details.reading, &self.scene).expect("geometry")
    }

    fn files(&self) -> Vec<(String, String)> {
        house_drawings(self.name, &self.house, &self.details.reading, &self.scene)
    }
}

/// One storey, two with a stair, flat and pitched roofs, setbacks.
const HOUSES: [&str; 6] = ["box", "villa", "gable", "l_gable", "terrace", "court"];

fn all(tileset: &str) -> Vec<Built> {
    let evaluator = evaluator(tileset);
    HOUSES.iter().map(|name| Built::new(&evaluator, name)).collect()
}

/// Area of the part of a block at height `z` µm over the cube's origin, µm2: where its lower plane is at most and its upper above `z`.
fn block_section(plan: &[[i32; 2]], bottom: &[i32], top: &[i32], z: f64) -> f64 {
    let mut points: Vec<[f64; 4]> =
        (0..plan.len()).map(|i| [plan[i][0], plan[i][1], bottom[i], top[i]].map(f64::from)).collect();
    for (height, sign) in [(2, 1.0), (3, -1.0)] {
        let inside = |p: &[f64; 4]| sign * (z - p[height]);
        let mut kept = Vec::new();
        for i in 0..points.len() {
            let (p, q) = (points[i], points[(i + 1) % points.len()]);
            let (a, b) = (inside(&p), inside(&q));
            if a >= 0.0 {
                kept.push(p);
            }
            if (a < 0.0) != (b < 0.0) {
                let t = a / (a - b);
                kept.push([0, 1, 2, 3].map(|k| p[k] + t * (q[k] - p[k])));
            }
        }
        points = kept;
    }
    let n = points.len();
    (0..n).map(|i| (points[i], points[(i + 1) % n])).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>() / 2.0
}

/// Area that a level plane cuts of each component, m2, block by block.
fn areas_by_block(fabric: &Fabric, z_m: f64) -> Vec<f64> {
    let mut areas = vec![0.0; fabric.layers.len()];
    for placed in &fabric.placed {
        let CubeTile::Blocks(blocks) = &fabric.tiles[placed.tile as usize].1 else { panic!("a style has blocks") };
        let block = &blocks[placed.block as usize];
        let z = (z_m - fabric.origin_m[2]) * 1e6 / fabric.scale[2] - fabric.offset_um(placed)[2] as f64;
        areas[placed.layer as usize] += block_section(&block.plan, &block.bottom, &block.top, z) * 1e-12;
    }
    areas
}

#[test]
fn poche_has_the_area_of_the_blocks_cut_one_by_one() {
    let mut compared = 0;
    for tileset in ["architectural", "larch"] {
        for built in all(tileset) {
            let (subject, fabric) = (built.subject(), built.fabric.as_ref().unwrap());
            for storey in &built.details.reading.storeys {
                let z = subject.floor(storey.plate_k) + CUT_M;
                let expected = areas_by_block(fabric, z);
                let cut = cut(&subject.model, &View::plan(), z, |_| true);
                for (layer, want) in fabric.layers.iter().zip(&expected) {
                    let found = cut.areas.iter().filter(|(n, _)| subject.model.pieces[*n].name == layer.name);
                    let found: f64 = found.flat_map(|(_, loops)| loops).map(|l| area(l)).sum();
                    // Exact up to the micrometre to which straight runs are joined, over a hundred metres of outline.
                    assert!((found - want).abs() < 1e-4, "{} {}: {found} {want}", built.name, layer.name);
                    compared += usize::from(*want > 0.0);
                }
            }
        }
    }
    assert!(compared > 60, "{compared} areas compared");
}

#[test]
fn dimensions_are_those_of_the_cells() {
    for built in all("architectural") {
        let files = built.files();
        for storey in &built.details.reading.storeys {
            let svg = &files.iter().find(|f| f.0 == format!("plan-{}.svg", storey.index)).unwrap().1;
            for axis in 0..2 {
                let along: Vec<usize> = storey.plan.iter().map(|c| c[axis]).collect();
                let cells = along.iter().max().unwrap() - along.iter().min().unwrap() + 1;
                let words = format!(">{}<", cells * 900);
                assert!(svg.contains(&words), "{} storey {}: {words}", built.name, storey.index);
            }
            assert!(svg.contains(&format!(">{:.1} m²<", storey.floor_area_m2)));
            let level =
                if storey.plate_k == 0 { "±0.00".into() } else { format!("+{:.2}", 0.54 * storey.plate_k as f64) };
            assert!(svg.contains(&level), "{}: {level}", built.name);
        }
        // The ridge as the highest corner of the covering, from the scene.
        let covering = built.scene.parts.iter().find(|p| p.name == "roof_covering");
        if let Some(part) = covering {
            let top = part.vertices.iter().map(|v| v[2]).fold(f64::MIN, f64::max);
            let words = level(top);
            let drawn = files.iter().filter(|f| f.0.starts_with("elevation") || f.0.starts_with("section"));
            assert!(
                drawn.clone().count() == 5 && drawn.clone().all(|f| f.1.contains(&words)),
                "{}: {words}",
                built.name
            );
        }
    }
}

#[test]
fn every_opening_of_a_storey_is_in_its_plan() {
    for tileset in ["architectural", "surface-2"] {
        for built in all(tileset) {
            let files = built.files();
            for storey in &built.details.reading.storeys {
                let svg = &files[storey.index].1;
                let count = |label: Label| {
                    built
                        .details
                        .reading
                        .openings
                        .iter()
                        .filter(|o| o.storey == storey.index && o.label == label)
                        .count()
                };
                assert_eq!(svg.matches("class=\"door\"").count(), count(Label::Opening), "{} {}", tileset, built.name);
                assert_eq!(svg.matches("class=\"window\"").count(), count(Label::Window), "{} {}", tileset, built.name);
                let stairs = built.house.stairs.iter();
                let stairs = stairs.filter(|s| s.storey == storey.index || s.storey + 1 == storey.index).count();
                assert_eq!(svg.matches("class=\"stair\"").count(), stairs, "{} {}", tileset, built.name);
            }
        }
    }
}

/// Length of `line` (upright or level) that segments cover within 30 mm of it.
fn covered(line: Segment, edges: &[(Weight, Segment)]) -> f64 {
    let axis = usize::from((line[1][1] - line[0][1]).abs() > (line[1][0] - line[0][0]).abs());
    let (low, high) = (line[0][axis].min(line[1][axis]), line[0][axis].max(line[1][axis]));
    let steps = 200;
    let hit = |n: usize| {
        let at = low + (high - low) * (n as f64 + 0.5) / steps as f64;
        edges.iter().any(|(_, [p, q])| {
            (p[1 - axis] - line[0][1 - axis]).abs() < 0.03
                && (q[1 - axis] - line[0][1 - axis]).abs() < 0.03
                && (p[axis].min(q[axis])..=p[axis].max(q[axis])).contains(&at)
        })
    };
    (0..steps).filter(|n| hit(*n)).count() as f64 / steps as f64 * (high - low)
}

/// The rectangle of an opening in the view of its side, from its cells alone.
fn rectangle(subject: &Subject, o: &FacadeOpening) -> [[f64; 2]; 2] {
    let axis = o.along();
    let place = |n: usize| subject.origin[axis] + n as f64 * 0.9;
    let (a, b) = (place(o.cell[axis]), place(o.cell[axis] + o.width));
    let mirrored = matches!(o.facing, Direction::North | Direction::West);
    let (a, b) = if mirrored { (-b, -a) } else { (a, b) };
    let head = subject.origin[2] + (o.k + o.height) as f64 * 0.54 - 0.27;
    [[a, head - o.height as f64 * 0.54], [b, head]]
}

#[test]
fn elevations_show_openings_and_no_seams() {
    let mut seen = 0;
    for name in ["box", "gable", "villa"] {
        let built = Built::new(&evaluator("architectural"), name);
        let subject = built.subject();
        for side in Direction::ALL {
            let edges = seen_edges(&subject, side);
            let own: Vec<&FacadeOpening> = built.details.reading.openings.iter().filter(|o| o.facing == side).collect();
            for o in &own {
                // These houses are convex: nothing stands before an opening. Sills reach out, so jambs and heads are looked for.
                let [[l, b], [r, t]] = rectangle(&subject, o);
                for line in [[[l, b + 0.3], [l, t]], [[r, b + 0.3], [r, t]], [[l, t], [r, t]]] {
                    let length = (line[1][0] - line[0][0]).hypot(line[1][1] - line[0][1]);
                    assert!(covered(line, &edges) > 0.97 * length, "{name} {side:?} {o:?} {line:?}");
                }
                seen += 1;
            }
            // Between openings, away from corners and bands, a wall has no line at all.
            let wall = [subject.ground() + 0.35, 2.5];
            let clear = |u: f64| {
                own.iter().all(|o| {
                    let [[l, _], [r, _]] = rectangle(&subject, o);
                    u < l - 0.1 || u > r + 0.1
                })
            };
            let [low, high] = subject.extent(&View::facing(side));
            for (_, [p, q]) in &edges {
                let middle = [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])];
                let inside = middle[0] > low[0] + 0.5 && middle[0] < high[0] - 0.5;
                let plain = inside && clear(middle[0]) && wall[0] < middle[1] && middle[1] < wall[1];
                assert!(!plain, "{name} {side:?}: a line on a plain wall, {p:?} {q:?}");
            }
        }
    }
    assert!(seen > 10, "{seen} openings");
}

/// The nearest face at a place, by trying every triangle.
fn nearest(subject: &Subject, view: &View, [u, v]: [f64; 2]) -> Option<u32> {
    let mut best: Option<(f64, u32)> = None;
    for piece in subject.model.pieces.iter().filter(|p| p.kind != Kind::RailGlass) {
        for (triangle, &face) in piece.triangles.iter().zip(&piece.face) {
            let [a, b, c] = triangle.map(|i| view.see(piece.vertices[i as usize]));
            let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
            let s = ((u - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (v - a[1])) / area;
            let t = ((b[0] - a[0]) * (v - a[1]) - (u - a[0]) * (b[1] - a[1])) / area;
            if area > 1e-12 && s >= 0.0 && t >= 0.0 && s + t <= 1.0 {
                let depth = a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]);
                if best.is_none_or(|(known, _)| depth > known) {
                    best = Some((depth, face));
                }
            }
        }
    }
    best.map(|(_, face)| face)
}

#[test]
fn edges_lie_between_what_rays_meet_on_their_two_sides() {
    let built = Built::new(&evaluator("architectural"), "l_gable");
    let subject = built.subject();
    for side in [Direction::South, Direction::West] {
        let view = View::facing(side);
        let edges = seen_edges(&subject, side);
        let (mut tried, mut wrong) = (0, 0);
        for (_, [p, q]) in edges.iter().filter(|(_, [p, q])| (q[0] - p[0]).hypot(q[1] - p[1]) > 0.1) {
            let d = [q[0] - p[0], q[1] - p[1]];
            let length = d[0].hypot(d[1]);
            for t in [0.21, 0.5, 0.77] {
                let at = [p[0] + t * d[0], p[1] + t * d[1]];
                let off = |s: f64| [at[0] - s * d[1] / length, at[1] + s * d[0] / length];
                // Plates of a few millimetres, as of gutters, lie between the wider pair.
                let differs = |s: f64| nearest(&subject, &view, off(s)) != nearest(&subject, &view, off(-s));
                tried += 1;
                wrong += usize::from(![0.006, 0.002].into_iter().any(differs));
            }
        }
        // At the ends of lines the raster is good to its cell.
        assert!(tried > 90 && wrong * 50 < tried, "{side:?}: {wrong} of {tried}");
    }
}

/// Whether a place is clear floor, from cells, records and the cut areas, each by its own definition.
fn is_clear(built: &Built, subject: &Subject, storey: &Storey, poche: &[Loop], p: [f64; 2]) -> bool {
    let cell = |p: [f64; 2]| [0, 1].map(|a: usize| ((p[a] - subject.origin[a]) / 0.9).floor() as isize);
    // 300 mm from the outside in eight directions: walls run along the grid.
    let inside = [-0.3, 0.0, 0.3]
        .iter()
        .all(|dx| [-0.3, 0.0, 0.3].iter().all(|dy| storey.plan.has(cell([p[0] + dx, p[1] + dy]))));
    let here = cell(p);
    let stair = built.house.stairs.iter().any(|s| {
        (s.storey == storey.index
            && (s.flight_cells().contains(&here) || s.middle_landing().contains(&here) || s.foot() == here))
            || (s.storey + 1 == storey.index && (s.void_cells().contains(&here) || s.head() == here))
    });
    let door = built.details.reading.openings.iter().any(|o| {
        let deep = |n: isize| (0..2).any(|i| o.column(n, -i) == here);
        let facade = [0, 1].map(|a| subject.origin[a] + 0.9 * o.cell[a] as f64);
        let reach = match o.facing {
            Direction::South => p[1] - facade[1],
            Direction::West => p[0] - facade[0],
            Direction::North => facade[1] + 0.9 - p[1],
            Direction::East => facade[0] + 0.9 - p[0],
        };
        o.storey == storey.index && o.label == Label::Opening && (0..o.width as isize).any(deep) && reach < 1.2
    });
    let crossings = poche.iter().flat_map(|l| (0..l.len()).map(move |i| (l[i], l[(i + 1) % l.len()])));
    let hits = crossings
        .filter(|(a, b)| (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
    inside && !stair && !door && hits.count() % 2 == 0
}

#[test]
fn furniture_lies_in_the_clear_area_and_nothing_else_would_fit() {
    let (mut found, mut refused) = (0, 0);
    for built in all("architectural") {
        let subject = built.subject();
        for storey in &built.details.reading.storeys {
            let z = subject.floor(storey.plate_k) + CUT_M;
            let solid = |p: &Piece| !matches!(p.kind, Kind::Stair | Kind::Leaf | Kind::Rail | Kind::RailGlass);
            let cut = cut(&subject.model, &View::plan(), z, solid);
            let poche: Vec<Loop> = cut.areas.into_iter().flat_map(|(_, l)| l).collect();
            let fits = fit(&Free::new(&subject, storey, &poche), Room::Living);
            // The middles of cells of 50 mm: walls, stairs and modules end on their lines.
            let [nx, ny] = storey.plan.size().map(|n| n * 18);
            let middle = |x: usize, y: usize| [0, 1].map(|a| subject.origin[a] + ([x, y][a] as f64 + 0.5) * 0.05);
            let clear: Vec<bool> =
                (0..nx * ny).map(|i| is_clear(&built, &subject, storey, &poche, middle(i % nx, i / nx))).collect();
            let holds = |x: usize, y: usize, n: usize| {
                x + n <= nx && y + n <= ny && (y..y + n).all(|v| (x..x + n).all(|u| clear[u + nx * v]))
            };
            for room in [Room::Living, Room::Bedroom] {
                let n = (room.side_m() / 0.05).round() as usize;
                match fits.iter().find(|f| f.room == room) {
                    Some(fit) => {
                        let [x, y] = [0, 1].map(|a| ((fit.low[a] - subject.origin[a]) / 0.05).round() as usize);
                        assert!(holds(x, y, n), "{} storey {}: {fit:?}", built.name, storey.index);
                        found += 1;
                    }
                    None if fits.is_empty() || room == Room::Living => {
                        let other = (0..ny).flat_map(|y| (0..nx).map(move |x| (x, y))).find(|&(x, y)| holds(x, y, n));
                        assert_eq!(other, None, "{} storey {}: {room:?}", built.name, storey.index);
                        refused += 1;
                    }
                    None => {}
                }
            }
            if let [a, b] = &fits[..] {
                let apart = (0..2).any(|i| {
                    a.low[i] + a.room.side_m() < b.low[i] + 1e-9 || b.low[i] + b.room.side_m() < a.low[i] + 1e-9
                });
                assert!(apart, "{}: the rooms lie beside each other", built.name);
            }
        }
    }
    assert!(found > 5 && refused > 1, "{found} fits, {refused} refusals");
}

#[test]
fn drawings_are_well_formed_to_scale_and_the_same_every_time() {
    for tileset in ["architectural", "larch", "surface-2"] {
        for built in all(tileset) {
            let files = built.files();
            assert_eq!(files, built.files(), "{tileset} {}", built.name);
            assert_eq!(files.len(), built.details.reading.storeys.len() + 5);
            for (file, svg) in &files {
                assert!(!svg.contains("NaN") && !svg.contains("inf "), "{file}");
                let (width, height) = if svg.contains(">A4<") { (297, 210) } else { (420, 297) };
                let head = format!("width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\"");
                assert!(svg.contains(&head), "{file}: {head}");
                let png = svg_to_png(svg, 1.0).expect("well-formed");
                if let Some(folder) = std::env::var_os("HOUSCAPER_LOOK") {
                    let folder = std::path::Path::new(&folder).join(tileset).join(built.name);
                    std::fs::create_dir_all(&folder).unwrap();
                    std::fs::write(folder.join(file), svg).unwrap();
                    let png =
                        if std::env::var_os("HOUSCAPER_LARGE").is_some() { svg_to_png(svg, 3.2).unwrap() } else { png };
                    std::fs::write(folder.join(file.replace(".svg", ".png")), png).unwrap();
                }
            }
        }
    }
}
