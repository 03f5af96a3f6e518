//! Boards on walls, decks and roofs: what stiffness and strength they lend the frame in their plane.

/// What sheathing a panel stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum PanelKind {
    /// Wall boards.
    Wall = 0,
    /// Floor deck.
    Deck = 1,
    /// Roof boards.
    Roof = 2,
}

/// In-plane properties of sheathing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheathing {
    /// Shear stiffness G t of the nailed panel, N/m.
    pub shear_n_per_m: f64,
    /// Distance of the nails along the edges, m.
    pub nail_spacing_m: f64,
    /// Short-term design shear flow, N/m.
    pub capacity_n_per_m: f64,
}

/// Sheathing by [`PanelKind`].
///
/// Assumptions. Stiffness: 12 mm OSB/3 has G t = 1.08 GPa x 12 mm = 13 MN/m; nail slip leaves about a fifth, 2.6 MN/m, which on a
/// wall of 2.9 m clear height is 0.9 MN/m per metre of wall (timber-frame practice: 0.8 to 1.0). Decks of 18 mm board take 1.5
/// times that. Capacity (EN 1995-1-1 9.2.4.2, method A): a nail 2.8 x 65 mm through 12 mm OSB/3 into C24 carries 407 N in
/// short-term design (8.2.2 d; a test has every step), 1.2 times that along edges (9.2.4.2(5), 9.2.3.2(4)); at 50 mm
/// along the edges of every board that is 9.7 kN/m. Boards thicker than 12 mm, and the stiffness of closer nails, are not credited.
pub const SHEATHING: [Sheathing; 3] = [
    Sheathing { shear_n_per_m: 2.6e6, nail_spacing_m: 0.050, capacity_n_per_m: 9.7e3 },
    Sheathing { shear_n_per_m: 3.9e6, nail_spacing_m: 0.050, capacity_n_per_m: 9.7e3 },
    Sheathing { shear_n_per_m: 2.6e6, nail_spacing_m: 0.050, capacity_n_per_m: 9.7e3 },
];

/// A brace that has the shear stiffness of a sheathed bay: a x b metres, diagonal d, E A = S d^3 / (a b). Not a priced stick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panel {
    /// What it stands for.
    pub kind: PanelKind,
    /// Ends of the diagonal.
    pub nodes: [u32; 2],
    /// Axial stiffness E A, N.
    pub ea_n: f64,
    /// Axial force at the sheathing's capacity, N: shear flow x length of the diagonal.
    pub capacity_n: f64,
    /// Panels in a row with the same number are one wall: one plane between two levels.
    pub line: u32,
}
