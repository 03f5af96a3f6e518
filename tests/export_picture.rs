//! Pictures of houses: what is seen, and that it is seen the same way each time.

#[path = "common/houses.rs"]
mod houses;

use houscaper::export::picture::{Picture, View, render};
use houscaper::export::{Scene, Showing, from_envelope};
use serde_json::Value;

fn villa() -> Scene {
    from_envelope(&houses::villa(), Showing::default(), Value::Null, |_| Value::Null)
}

/// Writes a picture where `HOUSCAPER_LOOK` points, for a person to look at.
fn show(name: &str, bytes: &[u8]) {
    if let Some(folder) = std::env::var_os("HOUSCAPER_LOOK") {
        std::fs::write(std::path::Path::new(&folder).join(name), bytes).expect("folder to look in");
    }
}

#[test]
fn equal_scenes_give_equal_bytes() {
    let scene = villa();
    let first = render(&scene, &Picture::default()).unwrap();
    let timed = |f: &dyn Fn()| {
        (0..8)
            .map(|_| {
                let t = std::time::Instant::now();
                f();
                t.elapsed()
            })
            .min()
            .unwrap()
    };
    let drawn = timed(&|| drop(render(&scene, &Picture::default()).unwrap()));
    let packed = timed(&|| drop(first.to_png().unwrap()));
    let png = first.to_png().unwrap();
    println!("thumb, best of 8: {drawn:?} + PNG {packed:?}, {} bytes", png.len());
    show("villa_thumb.png", &png);
    assert_eq!(first, render(&villa(), &Picture::default()).unwrap());
    assert_eq!(png, first.to_png().unwrap());
}

#[test]
fn large_and_axonometric_pictures() {
    let started = std::time::Instant::now();
    let large = Picture { size: [1200, 900], samples: 3, ..Picture::default() };
    show("villa.png", &render(&villa(), &large).unwrap().to_png().unwrap());
    println!("1200 x 900, nine samples: {:?}", started.elapsed());
    let view = View { field_deg: None, elevation_deg: 35.0, ..View::default() };
    show("villa_axo.png", &render(&villa(), &Picture { view, ..large }).unwrap().to_png().unwrap());
    let bungalow = from_envelope(&houses::bungalow(), Showing::default(), Value::Null, |_| Value::Null);
    show("bungalow.png", &render(&bungalow, &Picture::default()).unwrap().to_png().unwrap());
}
