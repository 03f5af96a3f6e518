//! The welded surface of a house and what its faces are.

/// What a face of the envelope is: decided by the patch's kind and the label of its octant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(usize)]
pub enum Surface {
    /// Outer wall: vertical, base.
    Wall = 0,
    /// Edge of a floor plate in the facade: vertical, floor.
    Band = 1,
    /// Edge of the foundation: vertical, foundation.
    Plinth = 2,
    /// Window: vertical, window.
    Window = 3,
    /// Door: vertical, opening.
    Door = 4,
    /// Sloped roof: upward and inclined, base.
    PitchedRoof = 5,
    /// Flat roof: upward and level, base.
    FlatRoof = 6,
    /// Deck or terrace: upward, floor or foundation.
    Deck = 7,
    /// Underside of a projecting storey: downward, any label but foundation.
    Soffit = 8,
    /// Underside of the foundation: downward, foundation.
    Ground = 9,
}

impl Surface {
    /// All surfaces in storage order.
    pub const ALL: [Surface; 10] = [
        Surface::Wall,
        Surface::Band,
        Surface::Plinth,
        Surface::Window,
        Surface::Door,
        Surface::PitchedRoof,
        Surface::FlatRoof,
        Surface::Deck,
        Surface::Soffit,
        Surface::Ground,
    ];

    /// Name in files: glTF material, OBJ group, take-off line.
    pub fn name(self) -> &'static str {
        match self {
            Surface::Wall => "wall",
            Surface::Band => "floor_band",
            Surface::Plinth => "plinth",
            Surface::Window => "window",
            Surface::Door => "door",
            Surface::PitchedRoof => "pitched_roof",
            Surface::FlatRoof => "flat_roof",
            Surface::Deck => "deck",
            Surface::Soffit => "soffit",
            Surface::Ground => "ground",
        }
    }
}

/// A triangle mesh in metres, z up, faces oriented outwards (counter-clockwise seen from outside).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertex positions in metres.
    pub vertices: Vec<[f64; 3]>,
    /// Three vertex indices each.
    pub triangles: Vec<[u32; 3]>,
    /// What each triangle is, parallel to `triangles`.
    pub surfaces: Vec<Surface>,
}

/// Areas of the envelope in m2 by surface, and the enclosed volume.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnvelopeAreas {
    /// m2, indexed by `Surface as usize`.
    pub area_m2: [f64; 10],
    /// m3 enclosed by the welded surface.
    pub volume_m3: f64,
}

/// The volume enclosed by a closed mesh, m3: the sum of the signed tetrahedra over its triangles, positive when faces point
/// outwards. Taken about the first vertex, so that a far origin costs no digits.
pub fn volume(mesh: &Mesh) -> f64 {
    let Some(&origin) = mesh.vertices.first() else { return 0.0 };
    let at = |i: u32| [0, 1, 2].map(|a| mesh.vertices[i as usize][a] - origin[a]);
    mesh.triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(at);
            let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
            (a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]) / 6.0
        })
        .sum()
}
