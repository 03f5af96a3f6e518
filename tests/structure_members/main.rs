//! Members against published examples, tables of sections and identities of the clauses.

mod clauses;
mod published;
mod schema;
mod tables;

use std::path::{Path, PathBuf};

use houscaper::structure::Catalogue;
use houscaper::structure::checks::{Grade, Shape, Steel};

fn catalogue() -> Catalogue {
    Catalogue::load(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs"))).expect("our catalogue")
}

/// A folder of the reference pages beside the project; `None`, said aloud, where they are not.
fn shared(folder: &str) -> Option<PathBuf> {
    let path = std::env::var_os("HOUSCAPER_SHARED").map(PathBuf::from).map(|p| p.join(folder)).filter(|p| p.exists());
    if path.is_none() {
        println!("skipped: HOUSCAPER_SHARED names no folder with {folder}");
    }
    path
}

fn near(what: &str, own: f64, published: f64, tolerance: f64) {
    assert!((own / published - 1.0).abs() <= tolerance, "{what}: {own} against {published} (within {tolerance})");
}

fn steel(fy: f64) -> Steel {
    Steel { e: 210e9, g: 81e9, fy: fy * 1e6, gamma_m0: 1.0, gamma_m1: 1.0 }
}

fn i_shape([h, b, tw, tf, r]: [f64; 5]) -> Shape {
    let [h, b, tw, tf, r] = [h, b, tw, tf, r].map(|mm| mm * 1e-3);
    Shape::I { b, h, tw, tf, r }
}

fn grade(id: &str) -> Grade {
    catalogue().materials.iter().find(|m| m.id == id).and_then(|m| m.timber).expect("timber")
}
