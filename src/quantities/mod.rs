//! Take-off: how much of what a house is made of. Areas by surface, floors, openings by size, stairs, railings, the perimeter of the
//! foundation, and the frame by role group, material and section.
//!
//! A [`Takeoff`] is one flat value without strings or maps: it is filled once per house evaluated, and [`Takeoff::measured`] and
//! [`Takeoff::billed`] turn it into dense vectors over [`Item`], so that pricing is a dot product. Strings appear only in [`Takeoff::lines`].
//!
//! Nothing is counted twice: openings are counted by size and never by their share of the envelope; the sticks of the frame are counted
//! here as members, and the build-ups of the price book leave them out.

mod item;
mod origin;
mod rows;
mod takeoff;
mod unit;
mod works;

pub use item::{FrameGroup, FrameMaterial, Group, Item};
pub use origin::{Origin, OriginKind, OriginRow};
pub use rows::{FoundationEdge, FrameQuantity, OpeningSize, RoofEdges};
pub use takeoff::{Takeoff, TakeoffError, TakeoffLine};
pub use unit::Unit;
pub use works::{REPEATS, Works};
