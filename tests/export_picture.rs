//! Pictures of houses: what is seen, and that it is seen the same way each time.

#[path = "common/houses.rs"]
mod houses;

use houscaper::export::picture::{Picture, View, animated, render, sprites, turntable};
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

#[test]
fn a_turntable_keeps_scale_person_and_ground_and_closes() {
    let picture = Picture { size: [240, 180], ..Picture::of_house([240, 180]) };
    let frames = turntable(&villa(), &picture, 12).unwrap();
    assert_eq!(frames, turntable(&villa(), &picture, 12).unwrap());
    assert_eq!(frames.len(), 12);
    assert!((1..12).all(|n| frames[n] != frames[0]), "every frame is another view");
    // A whole turn ends where it began; half a step more does not.
    let turned = |degrees: f32| {
        let view = View { azimuth_deg: picture.view.azimuth_deg + degrees, ..picture.view };
        render(&villa(), &Picture { view, is_steady: true, ..picture }).unwrap()
    };
    let off = |a: &houscaper::export::picture::Image| {
        let sum: u64 = a.rgb.iter().zip(&frames[0].rgb).map(|(p, q)| u64::from(p.abs_diff(*q))).sum();
        sum as f64 / a.rgb.len() as f64
    };
    assert!(off(&turned(360.0)) < 0.5 && off(&turned(15.0)) > 2.0);
    let bytes = animated(&frames).unwrap();
    show("turntable.png", &bytes);
    let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
    let control = reader.info().animation_control.expect("an animation");
    assert_eq!((control.num_frames, control.num_plays), (12, 0));
    for frame in &frames {
        let mut pixels = vec![0; frame.rgb.len()];
        reader.next_frame(&mut pixels).unwrap();
        assert_eq!(pixels, frame.rgb);
    }
    let sheet = sprites(&frames, 4);
    show("turntable-sheet.png", &sheet.to_png().unwrap());
    assert_eq!(sheet.size, [960, 540]);
    for (n, frame) in frames.iter().enumerate() {
        let at = [n % 4 * 240 + 100, n / 4 * 180 + 90];
        assert_eq!(sheet.get(at), frame.get([100, 90]), "cell {n}");
    }
}
