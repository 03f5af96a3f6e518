//! Price, carbon, energy, mass and heat loss of a take-off.
//!
//! Three books, all data under `configs/`: prices ([`PriceBook`], net of overhead and VAT), carbon factors ([`CarbonBook`], fossil A1-A3
//! with biogenic storage apart) and build-ups ([`BuildUps`], layers from which mass, U-value, price and carbon of a square metre follow).
//! [`Books::rates`] compiles them into a [`RateTable`], dense over the items of the take-off, so that [`cost`] is a dot product.
//!
//! What `price_eur` means: envelope, frame, floors, stairs, foundation and openings *in place*, with overhead and profit and with
//! contingency, net of VAT, without design fees and without the completion allowance (services, fit-out, groundworks), which is shown apart.
//! The rates of the book are of work in place, and the place is the factory for what is made there. Each names its hours of work and its
//! waste, so that a bill tells materials, waste and labour apart; [`WorksQuantities`] adds what a factory-made house takes besides:
//! set-up, what practice saves, trucks, crane and crew.
//!
//! An item without price or factor is an error that names item and book. Energy may be unknown (`null`): then the sum is `None` and the
//! items without a value are listed. So may the stages after A1-A3, which [`StageTable`] sums beside the price ([`Stage`]). The price knows no geometry, only quantities.

mod account;
mod bill;
mod book;
mod buildup;
mod carbon;
mod error;
mod figures;
mod price_item;
mod quote;
mod rates;
mod resolved;
mod stages;
mod strata;
mod thermal;
mod uncertainty;
mod works;

pub use account::{CarbonAccount, CarbonFigures, CarbonRow, StageFigure};
pub use bill::{BillLine, bill};
pub use book::{Allowance, PriceBook, Range, Surcharge};
pub use buildup::{BuildUp, BuildUpKind, BuildUps, Layer, Part, PartPrice};
pub use carbon::{CarbonBook, CarbonItem, Stage, StageFactor};
pub use error::PriceError;
pub use figures::{grouped, plain};
pub use price_item::{Evidence, PriceItem, Workplace};
pub use quote::{
    Quote, QuoteAllowance, QuoteHead, QuotePractice, QuoteSurcharge, VALID_DAYS, escape, quote, quote_html,
};
pub use rates::{Books, Cost, Rate, RateTable, cost};
pub use resolved::{Resolved, ResolvedBuildUp, Wasted};
pub use stages::{CarbonMatrix, CarbonSums, StageSum, StageTable};
pub use strata::{BuildUpStratum, StratumMass};
pub use thermal::{ThermalLayer, u_value};
pub use uncertainty::{DRAWS, Draws, PriceMatrix, chance_below, tenths};
pub use works::{WorksLine, WorksQuantities, WorksRates, WorksSettings};
