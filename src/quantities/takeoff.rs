//! The take-off of one house.

use thiserror::Error;

use super::rows::{FoundationEdge, FrameQuantity, NO_FRAME, OpeningSize, RoofEdges};
use super::{Group, Item, Unit, Works};
use crate::envelope::{EnvelopeAreas, Surface};
use crate::voxels::Boards;

const PLATES: usize = 8;
const WINDOW_SIZES: usize = 16;
const FRAME_ROWS: usize = 32;
const SURFACES: usize = Surface::ALL.len();

/// A quantity that cannot be taken off.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum TakeoffError {
    /// A quantity is negative or not a number.
    #[error(
        "take-off of {what}: found {found}, expected a finite quantity of at least 0; check the geometry it was measured from"
    )]
    BadQuantity {
        /// What was measured.
        what: &'static str,
        /// The value found.
        found: f64,
    },
    /// More rows of one kind than a take-off holds.
    #[error("take-off of {what}: more than {limit} different rows; use fewer different {what}")]
    TooMany {
        /// Kind of row.
        what: &'static str,
        /// Rows that fit.
        limit: usize,
    },
    /// More deck is walked on than there is.
    #[error(
        "take-off of decks: {walked} m2 are said to be walked on, but the envelope has {deck} m2 of deck; measure both from the same house"
    )]
    DeckTooLarge {
        /// Area said to be walked on, m2.
        walked: f64,
        /// Deck area of the envelope, m2.
        deck: f64,
    },
}

/// Everything a house is made of, as numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Takeoff {
    area_m2: [f64; SURFACES],
    floor_m2: [f64; PLATES],
    plates: usize,
    windows: [OpeningSize; WINDOW_SIZES],
    window_sizes: usize,
    doors: u32,
    stairs: u32,
    railing_m: f64,
    perimeter_m: f64,
    foundation: FoundationEdge,
    edges: RoofEdges,
    boards: Boards,
    frame: [FrameQuantity; FRAME_ROWS],
    frame_rows: usize,
    works: Works,
}

/// One row of a detailed take-off.
#[derive(Clone, Debug, PartialEq)]
pub struct TakeoffLine {
    /// What it is.
    pub item: Item,
    /// Which part of it: the surface, the plate, the window size, or group and section of members.
    pub description: String,
    /// Measured quantity in the unit of the item.
    pub quantity: f64,
    /// Unit of the quantity.
    pub unit: Unit,
    /// Pieces, where it is counted by piece (windows, doors, stairs), else 0.
    pub pieces: u32,
    /// Mass in kg where the take-off knows it itself (members of the frame).
    pub mass_kg: Option<f64>,
}

impl Takeoff {
    /// Starts a take-off from the areas of the envelope. `walked_deck_m2` of its decks are reached by a door and get a decking; the rest
    /// of the deck area is roof that is not walked on and joins the flat roof.
    ///
    /// # Errors
    /// An area that is negative or not finite, or more walked deck than there is deck.
    pub fn new(envelope: &EnvelopeAreas, walked_deck_m2: f64) -> Result<Takeoff, TakeoffError> {
        for surface in Surface::ALL {
            checked(surface.name(), envelope.area_m2[surface as usize])?;
        }
        let walked = checked("walked deck", walked_deck_m2)?;
        let mut area_m2 = envelope.area_m2;
        let deck = area_m2[Surface::Deck as usize];
        if walked > deck + 1e-9 {
            return Err(TakeoffError::DeckTooLarge { walked, deck });
        }
        let walked = walked.min(deck);
        area_m2[Surface::FlatRoof as usize] += deck - walked;
        area_m2[Surface::Deck as usize] = walked;
        Ok(Takeoff {
            area_m2,
            floor_m2: [0.0; PLATES],
            plates: 0,
            windows: [OpeningSize::default(); WINDOW_SIZES],
            window_sizes: 0,
            doors: 0,
            stairs: 0,
            railing_m: 0.0,
            perimeter_m: 0.0,
            foundation: FoundationEdge::default(),
            edges: RoofEdges::default(),
            boards: Boards::OneSide,
            frame: [NO_FRAME; FRAME_ROWS],
            frame_rows: 0,
            works: Works::default(),
        })
    }

    /// Adds the net m2 of the next inner floor plate, lowest first.
    ///
    /// # Errors
    /// A bad quantity, or more than eight plates.
    pub fn add_floor(&mut self, net_m2: f64) -> Result<(), TakeoffError> {
        let net_m2 = checked("inner floor", net_m2)?;
        let slot = self.floor_m2.get_mut(self.plates);
        *slot.ok_or(TakeoffError::TooMany { what: "floor plates", limit: PLATES })? = net_m2;
        self.plates += 1;
        Ok(())
    }

    /// Adds one window of the given width and height in m; equal sizes (within 0.1 mm) are counted together.
    ///
    /// # Errors
    /// A bad size, or more than sixteen different sizes.
    pub fn add_window(&mut self, width_m: f64, height_m: f64) -> Result<(), TakeoffError> {
        let (width_m, height_m) = (checked("window width", width_m)?, checked("window height", height_m)?);
        let same = |w: &&mut OpeningSize| (w.width_m - width_m).abs() < 1e-4 && (w.height_m - height_m).abs() < 1e-4;
        if let Some(size) = self.windows[..self.window_sizes].iter_mut().find(same) {
            size.count += 1;
            return Ok(());
        }
        let slot = self.windows.get_mut(self.window_sizes);
        let slot = slot.ok_or(TakeoffError::TooMany { what: "window sizes", limit: WINDOW_SIZES })?;
        *slot = OpeningSize { count: 1, width_m, height_m };
        self.window_sizes += 1;
        Ok(())
    }

    /// Adds outer doors.
    pub fn add_doors(&mut self, count: u32) {
        self.doors += count;
    }

    /// Adds stairs of one storey each.
    pub fn add_stairs(&mut self, count: u32) {
        self.stairs += count;
    }

    /// Adds railing in m: around stair voids and walked decks.
    ///
    /// # Errors
    /// A bad length.
    pub fn add_railing(&mut self, length_m: f64) -> Result<(), TakeoffError> {
        self.railing_m += checked("railing", length_m)?;
        Ok(())
    }

    /// Adds perimeter of the foundation in m.
    ///
    /// # Errors
    /// A bad length.
    pub fn add_perimeter(&mut self, length_m: f64) -> Result<(), TakeoffError> {
        self.perimeter_m += checked("perimeter", length_m)?;
        Ok(())
    }

    /// States how the foundation's edge is built: the plinth goes down with the beam, and the slab ends at it. Areas of the envelope, and
    /// with them the heat loss, stay as they are. At most all of the ground is without slab.
    ///
    /// # Errors
    /// A bad area.
    pub fn set_foundation_edge(&mut self, edge: FoundationEdge) -> Result<(), TakeoffError> {
        checked("plinth below the slab", edge.plinth_below_m2)?;
        let without_slab_m2 = checked("ground under the perimeter beam", edge.without_slab_m2)?;
        let ground_m2 = self.area_m2[Surface::Ground as usize];
        self.foundation = FoundationEdge { without_slab_m2: without_slab_m2.min(ground_m2), ..edge };
        Ok(())
    }

    /// States which sides of the outer walls carry boards: walls boarded on both sides are an item of their own.
    pub fn set_boards(&mut self, boards: Boards) {
        self.boards = boards;
    }

    /// States what making and putting up the house depends on besides its materials; without it nothing is set up, carried or lifted.
    pub fn set_works(&mut self, works: Works) {
        self.works = works;
    }

    /// Parts, connections and lifts.
    pub fn works(&self) -> &Works {
        &self.works
    }

    /// Adds what stands along the edges of the roof.
    ///
    /// # Errors
    /// A bad area or length.
    pub fn add_roof_edges(&mut self, edges: &RoofEdges) -> Result<(), TakeoffError> {
        self.edges.overhang_m2 += checked("overhang", edges.overhang_m2)?;
        self.edges.gutter_m += checked("gutter", edges.gutter_m)?;
        self.edges.parapet_m2 += checked("parapet", edges.parapet_m2)?;
        self.edges.coping_m += checked("coping", edges.coping_m)?;
        Ok(())
    }

    /// Adds members of the frame; rows of equal group, material and section are summed.
    ///
    /// # Errors
    /// A bad quantity, or more than 32 different rows.
    pub fn add_frame(&mut self, rows: &[FrameQuantity]) -> Result<(), TakeoffError> {
        for row in rows {
            checked("frame length", row.length_m)?;
            checked("frame volume", row.volume_m3)?;
            checked("frame mass", row.mass_kg)?;
            let same =
                |f: &&mut FrameQuantity| f.group == row.group && f.material == row.material && f.section == row.section;
            if let Some(sum) = self.frame[..self.frame_rows].iter_mut().find(same) {
                sum.length_m += row.length_m;
                sum.volume_m3 += row.volume_m3;
                sum.mass_kg += row.mass_kg;
                continue;
            }
            let slot = self.frame.get_mut(self.frame_rows);
            *slot.ok_or(TakeoffError::TooMany { what: "frame sections", limit: FRAME_ROWS })? = *row;
            self.frame_rows += 1;
        }
        Ok(())
    }

    /// Areas of the envelope in m2 by surface, decks split as in [`Takeoff::new`].
    pub fn area_m2(&self) -> &[f64; SURFACES] {
        &self.area_m2
    }

    /// Areas of the envelope in m2 with the items that they are built as.
    pub fn surfaces(&self) -> impl Iterator<Item = (Item, f64)> + '_ {
        let built_as = |surface: Surface| match (surface, self.boards) {
            (Surface::Wall, Boards::BothSides) => Item::WallBothSides,
            _ => Item::of_surface(surface),
        };
        Surface::ALL.into_iter().map(move |surface| (built_as(surface), self.area_m2[surface as usize]))
    }

    /// Net m2 of the inner floor plates, lowest first.
    pub fn floors_m2(&self) -> &[f64] {
        &self.floor_m2[..self.plates]
    }

    /// Windows by size.
    pub fn windows(&self) -> &[OpeningSize] {
        &self.windows[..self.window_sizes]
    }

    /// Members of the frame by group, material and section.
    pub fn frame(&self) -> &[FrameQuantity] {
        &self.frame[..self.frame_rows]
    }

    /// m2 of window surface of the envelope less the sum of the window sizes: 0 when both describe the same openings.
    pub fn window_mismatch_m2(&self) -> f64 {
        self.area_m2[Surface::Window as usize] - self.window_sum(|w| w.each_m2())
    }

    fn window_sum(&self, each: impl Fn(&OpeningSize) -> f64) -> f64 {
        self.windows().iter().map(|w| f64::from(w.count) * each(w)).sum()
    }

    /// What is there, by item: m2, m, pieces; members of the frame in kg whatever their billing unit.
    pub fn measured(&self) -> [f64; Item::COUNT] {
        let mut q = self.common();
        q[Item::Window as usize] = self.window_sum(OpeningSize::each_m2);
        for row in self.frame() {
            q[row.material.item() as usize] += row.mass_kg;
        }
        q
    }

    /// What is paid for, by item in its billing unit: a window counts at least `window_min_m2`, timber of the frame in m3, steel in kg.
    pub fn billed(&self, window_min_m2: f64) -> [f64; Item::COUNT] {
        let mut q = self.common();
        q[Item::Window as usize] = self.window_sum(|w| w.each_m2().max(window_min_m2));
        for row in self.frame() {
            q[row.material.item() as usize] += row.billed();
        }
        q
    }

    fn common(&self) -> [f64; Item::COUNT] {
        let mut q = [0.0; Item::COUNT];
        q[..SURFACES].copy_from_slice(&self.area_m2);
        q[Item::Plinth as usize] += self.foundation.plinth_below_m2;
        q[Item::Ground as usize] -= self.foundation.without_slab_m2;
        if self.boards == Boards::BothSides {
            q.swap(Item::Wall as usize, Item::WallBothSides as usize);
        }
        q[Item::Door as usize] = f64::from(self.doors);
        q[Item::InnerFloor as usize] = self.floors_m2().iter().sum();
        q[Item::Stair as usize] = f64::from(self.stairs);
        q[Item::Railing as usize] = self.railing_m;
        q[Item::PerimeterBeam as usize] = self.perimeter_m;
        q[Item::Overhang as usize] = self.edges.overhang_m2;
        q[Item::Gutter as usize] = self.edges.gutter_m;
        q[Item::Parapet as usize] = self.edges.parapet_m2;
        q[Item::Coping as usize] = self.edges.coping_m;
        q
    }

    /// The detailed take-off, in the order of a bill; rows with nothing in them are left out. `section_name` names a section index.
    pub fn lines(&self, section_name: &dyn Fn(u16) -> String) -> Vec<TakeoffLine> {
        let mut lines: Vec<TakeoffLine> = Vec::new();
        for group in Group::ALL {
            for item in Item::ALL.into_iter().filter(|item| item.group() == group) {
                self.item_lines(item, section_name, &mut lines);
            }
        }
        lines
    }

    fn item_lines(&self, item: Item, section_name: &dyn Fn(u16) -> String, lines: &mut Vec<TakeoffLine>) {
        let mut push = |description: String, quantity: f64, pieces: u32, mass_kg: Option<f64>| {
            if quantity > 0.0 {
                lines.push(TakeoffLine { item, description, quantity, unit: item.unit(), pieces, mass_kg });
            }
        };
        match item {
            Item::Window => {
                for w in self.windows() {
                    let size = format!("window {:.2} x {:.2} m", w.width_m, w.height_m);
                    push(size, f64::from(w.count) * w.each_m2(), w.count, None);
                }
            }
            Item::InnerFloor => {
                for (plate, &net) in self.floors_m2().iter().enumerate() {
                    push(format!("inner floor, plate {}", plate + 1), net, 0, None);
                }
            }
            _ if item.is_frame() => {
                for row in self.frame().iter().filter(|row| row.material.item() == item) {
                    let (group, length) = (row.group.name(), row.length_m);
                    let text = format!("{group}, {} {}, {length:.1} m", row.material.id(), section_name(row.section));
                    push(text, row.billed(), 0, Some(row.mass_kg));
                }
            }
            Item::Door | Item::Stair => {
                let count = if item == Item::Door { self.doors } else { self.stairs };
                push(item.id().replace('_', " "), f64::from(count), count, None);
            }
            _ => push(item.id().replace('_', " "), self.common()[item as usize], 0, None),
        }
    }
}

fn checked(what: &'static str, found: f64) -> Result<f64, TakeoffError> {
    if found.is_finite() && found >= 0.0 { Ok(found) } else { Err(TakeoffError::BadQuantity { what, found }) }
}
