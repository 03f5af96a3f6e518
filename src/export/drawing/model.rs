//! The house as drawings need it: pieces of one material with what they are, their faces told apart by plane.

use rustc_hash::FxHashMap;

use crate::export::{Grain, Scene};
use crate::tiles::Component;

/// What a piece is on a drawing: decides pens and fills.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// Outermost stratum: cladding, render, covering, membrane.
    Shell,
    /// Insulated stratum and the structure's zone in it.
    Insulation,
    /// Linings, boards of floors and ceilings.
    Lining,
    /// Joists' zone of floors.
    Joists,
    /// Slab and perimeter beam.
    Concrete,
    /// Frames, reveals, sills, fascias, gutters, copings: small parts.
    Detail,
    /// Panes of windows.
    Glass,
    /// Door leaves with their handles.
    Leaf,
    /// Railings.
    Rail,
    /// Panes of railings, which are seen through.
    RailGlass,
    /// Treads, strings and landings.
    Stair,
    /// The skin of a set of surfaces: closed only together with the other pieces of it.
    Skin,
}

/// Everything of one material.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Name in files.
    pub name: String,
    /// What it is.
    pub kind: Kind,
    /// Colour in linear light.
    pub rgb: [f64; 3],
    /// Pattern in elevations.
    pub grain: Grain,
    /// Corners, m.
    pub vertices: Vec<[f64; 3]>,
    /// Counter-clockwise from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Number of the plane face of each triangle, counted through all pieces.
    pub face: Vec<u32>,
}

/// A house to be drawn.
#[derive(Clone, Debug, Default)]
pub struct Model {
    /// In the order of the scene.
    pub pieces: Vec<Piece>,
    /// Piece and outward normal of each plane face.
    pub faces: Vec<(u32, [f64; 3])>,
}

impl Model {
    /// What is seen of a scene of `house.glb`.
    pub fn new(scene: &Scene) -> Model {
        let mut model = Model::default();
        for part in scene.seen() {
            let Some(look) = scene.materials.get(part.material) else { continue };
            let component = part.extras.get("component").and_then(|c| c.as_str());
            let component = component.and_then(|c| Component::ALL.iter().find(|k| k.name() == c));
            let kind = match component {
                Some(&component) => kind(component),
                None if part.name == "frame" => Kind::Detail,
                None if part.name == "window" => Kind::Glass,
                None => Kind::Skin,
            };
            let [r, g, b, _] = look.rgba;
            let mut piece = Piece {
                name: part.name.clone(),
                kind,
                rgb: [r, g, b],
                grain: look.grain,
                vertices: part.vertices.clone(),
                triangles: Vec::with_capacity(part.triangles.len()),
                face: Vec::with_capacity(part.triangles.len()),
            };
            model.add_faces(&mut piece, &part.triangles);
            model.pieces.push(piece);
        }
        model
    }

    /// Numbers the faces of a piece: triangles of one plane share a number, whether they touch or not.
    fn add_faces(&mut self, piece: &mut Piece, triangles: &[[u32; 3]]) {
        let number = self.pieces.len() as u32;
        let mut known: FxHashMap<[i64; 4], u32> = FxHashMap::default();
        for &triangle in triangles {
            let [a, b, c] = triangle.map(|v| piece.vertices[v as usize]);
            let Some(normal) = normal(a, b, c) else { continue };
            let offset: f64 = (0..3).map(|i| normal[i] * a[i]).sum();
            let [x, y, z] = normal.map(|n| (n * 2e3).round() as i64);
            let next = self.faces.len() as u32;
            let face = *known.entry([x, y, z, (offset * 2e3).round() as i64]).or_insert(next);
            if face == next {
                self.faces.push((number, normal));
            }
            piece.triangles.push(triangle);
            piece.face.push(face);
        }
    }

    /// Lowest and highest coordinates of the pieces that `which` picks, m; `None` when there are none.
    pub fn bounds(&self, which: impl Fn(&Piece) -> bool) -> Option<[[f64; 3]; 2]> {
        let mut points = self.pieces.iter().filter(|p| which(p)).flat_map(|p| &p.vertices);
        let first = *points.next()?;
        Some(points.fold([first; 2], |[low, high], p| {
            [[0, 1, 2].map(|a| low[a].min(p[a])), [0, 1, 2].map(|a| high[a].max(p[a]))]
        }))
    }

    /// The piece of a face.
    pub fn piece_of(&self, face: u32) -> Option<&Piece> {
        self.faces.get(face as usize).map(|(piece, _)| &self.pieces[*piece as usize])
    }
}

/// The unit normal of a triangle; `None` without area.
pub fn normal(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> Option<[f64; 3]> {
    let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length > 1e-12).then(|| n.map(|x| x / length))
}

fn kind(component: Component) -> Kind {
    use Component as C;
    match component {
        C::Cladding | C::Band | C::RoofCovering | C::FlatMembrane | C::PlinthRender | C::Paving | C::DeckBoards => {
            Kind::Shell
        }
        C::WallInsulation
        | C::RoofInsulation
        | C::FlatInsulation
        | C::SoffitInsulation
        | C::GroundInsulation
        | C::PlinthInsulation => Kind::Insulation,
        C::WallLining | C::RoofLining | C::FloorBoards | C::Ceiling | C::SoffitBoards => Kind::Lining,
        C::FloorStructure => Kind::Joists,
        C::GroundSlab | C::PerimeterBeam => Kind::Concrete,
        C::Fascia | C::Gutter | C::Coping | C::WindowFrame | C::DoorFrame | C::Reveal | C::Sill => Kind::Detail,
        C::Glass => Kind::Glass,
        C::DoorLeaf | C::Handle => Kind::Leaf,
        C::RailingRail => Kind::Rail,
        C::RailingGlass => Kind::RailGlass,
        C::StairTread | C::StairString => Kind::Stair,
    }
}
