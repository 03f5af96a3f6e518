//! Take-off: counting, splitting, refusing.

use houscaper::envelope::{EnvelopeAreas, Surface};
use houscaper::quantities::{
    FoundationEdge, FrameGroup, FrameMaterial, FrameQuantity, Group, Item, Takeoff, TakeoffError,
};

fn areas(list: &[(Surface, f64)]) -> EnvelopeAreas {
    let mut areas = EnvelopeAreas::default();
    list.iter().for_each(|&(surface, m2)| areas.area_m2[surface as usize] = m2);
    areas
}

fn member(group: FrameGroup, material: FrameMaterial, volume_m3: f64, mass_kg: f64) -> FrameQuantity {
    FrameQuantity { group, material, section: 3, length_m: 10.0, volume_m3, mass_kg }
}

#[test]
fn items_follow_the_surfaces_and_have_unique_names() {
    for surface in Surface::ALL {
        assert_eq!(Item::of_surface(surface).id(), surface.name());
    }
    for (index, item) in Item::ALL.into_iter().enumerate() {
        assert_eq!(item as usize, index);
        assert_eq!(Item::from_id(item.id()), Some(item));
    }
    for material in FrameMaterial::ALL {
        assert_eq!(FrameMaterial::from_id(material.id()), Some(material));
        assert!(material.item().id().ends_with(&material.id().to_lowercase()));
    }
}

#[test]
fn deck_that_is_not_walked_on_joins_the_flat_roof() -> Result<(), TakeoffError> {
    let skin = areas(&[(Surface::Deck, 20.0), (Surface::FlatRoof, 1.0)]);
    let takeoff = Takeoff::new(&skin, 6.0)?;
    assert_eq!(takeoff.measured()[Item::Deck as usize], 6.0);
    assert_eq!(takeoff.measured()[Item::FlatRoof as usize], 15.0);
    let refused = Takeoff::new(&skin, 20.1);
    assert!(matches!(refused, Err(TakeoffError::DeckTooLarge { .. })), "{refused:?}");
    Ok(())
}

#[test]
fn windows_are_counted_by_size_and_billed_with_a_least_area() -> Result<(), TakeoffError> {
    let mut takeoff = Takeoff::new(&areas(&[(Surface::Window, 7.29)]), 0.0)?;
    for (width, height) in [(1.8, 1.62), (0.9, 1.62), (1.8, 1.62)] {
        takeoff.add_window(width, height)?;
    }
    assert_eq!(takeoff.windows().len(), 2);
    // 2 x 2.916 + 1.458 = 7.29 m2 measured; the small one is billed with 1.5 m2: 7.332 m2.
    assert!((takeoff.measured()[Item::Window as usize] - 7.29).abs() < 1e-12);
    assert!((takeoff.billed(1.5)[Item::Window as usize] - 7.332).abs() < 1e-12);
    assert!(takeoff.window_mismatch_m2().abs() < 1e-12);
    Ok(())
}

#[test]
fn members_are_billed_in_the_unit_of_their_material_and_measured_in_kg() -> Result<(), TakeoffError> {
    let mut takeoff = Takeoff::new(&EnvelopeAreas::default(), 0.0)?;
    let rows = [
        member(FrameGroup::Wall, FrameMaterial::C24, 1.0, 420.0),
        member(FrameGroup::Wall, FrameMaterial::C24, 0.5, 210.0),
        member(FrameGroup::Beam, FrameMaterial::S355, 0.01, 78.5),
    ];
    takeoff.add_frame(&rows)?;
    assert_eq!(takeoff.frame().len(), 2, "equal rows are summed");
    let (billed, measured) = (takeoff.billed(0.0), takeoff.measured());
    assert_eq!([billed[Item::FrameC24 as usize], billed[Item::FrameS355 as usize]], [1.5, 78.5]);
    assert_eq!([measured[Item::FrameC24 as usize], measured[Item::FrameS355 as usize]], [630.0, 78.5]);
    let lines = takeoff.lines(&|section| format!("section {section}"));
    assert_eq!(lines.len(), 2);
    assert!(lines.iter().all(|line| line.item.group() == Group::Frame && line.description.contains("section 3")));
    Ok(())
}

#[test]
fn parts_sum_to_the_whole() -> Result<(), TakeoffError> {
    let mut takeoff =
        Takeoff::new(&areas(&[(Surface::Wall, 80.0), (Surface::Deck, 30.0), (Surface::Window, 9.0)]), 4.0)?;
    [30.0, 28.5].into_iter().try_for_each(|m2| takeoff.add_floor(m2))?;
    takeoff.add_window(1.8, 1.62)?;
    takeoff.add_doors(2);
    takeoff.add_stairs(1);
    takeoff.add_railing(4.5)?;
    takeoff.add_perimeter(25.2)?;
    let mut sums = [0.0; Item::COUNT];
    takeoff.lines(&|_| String::new()).iter().for_each(|line| sums[line.item as usize] += line.quantity);
    assert_eq!(sums, takeoff.measured());
    Ok(())
}

#[test]
fn bad_quantities_are_refused_and_good_ones_are_not() -> Result<(), TakeoffError> {
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(Takeoff::new(&areas(&[(Surface::Wall, bad)]), 0.0).is_err());
        assert!(Takeoff::new(&EnvelopeAreas::default(), 0.0)?.add_railing(bad).is_err());
        assert!(Takeoff::new(&EnvelopeAreas::default(), 0.0)?.add_window(bad, 1.0).is_err());
    }
    let mut takeoff = Takeoff::new(&areas(&[(Surface::Wall, 0.0)]), 0.0)?;
    takeoff.add_railing(0.0)?;
    for plate in 0..8 {
        takeoff.add_floor(f64::from(plate))?;
    }
    assert!(matches!(takeoff.add_floor(1.0), Err(TakeoffError::TooMany { limit: 8, .. })));
    Ok(())
}

/// The edge of a foundation moves quantities, not the areas that lose heat.
#[test]
fn the_edge_of_a_foundation_is_measured_apart() {
    let mut areas = EnvelopeAreas::default();
    areas.area_m2[Surface::Ground as usize] = 10.0;
    areas.area_m2[Surface::Plinth as usize] = 2.0;
    let edge = |plinth_below_m2: f64, without_slab_m2: f64| {
        let mut takeoff = Takeoff::new(&areas, 0.0)?;
        takeoff.set_foundation_edge(FoundationEdge { plinth_below_m2, without_slab_m2 })?;
        Ok::<_, TakeoffError>(takeoff)
    };
    let takeoff = edge(3.0, 4.0).expect("a foundation");
    let measured = takeoff.measured();
    assert_eq!((measured[Item::Plinth as usize], measured[Item::Ground as usize]), (5.0, 6.0));
    assert_eq!(takeoff.billed(0.0)[Item::Ground as usize], 6.0);
    assert_eq!(*takeoff.area_m2(), areas.area_m2, "areas of the envelope stay");
    assert_eq!(edge(0.0, 99.0).expect("a narrow foundation").measured()[Item::Ground as usize], 0.0);
    for (plinth, slab) in [(-1.0, 0.0), (0.0, -1.0), (f64::NAN, 0.0), (0.0, f64::INFINITY)] {
        assert!(matches!(edge(plinth, slab), Err(TakeoffError::BadQuantity { .. })), "{plinth} {slab}");
    }
}
