//! A house priced by hand, to the cent; parts and whole; ranges; what a typical house costs.

use std::path::PathBuf;

use houscaper::envelope::{EnvelopeAreas, Surface};
use houscaper::export::tables::bom_csv;
use houscaper::price::{Books, QuoteHead, RateTable, bill, cost, quote, quote_html};
use houscaper::quantities::{FrameGroup, FrameMaterial, FrameQuantity, Takeoff};

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn books() -> Result<(Books, RateTable), Box<dyn std::error::Error>> {
    let books = Books::load(&PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("configs"))?;
    let rates = books.rates()?;
    Ok((books, rates))
}

fn areas(list: &[(Surface, f64)]) -> EnvelopeAreas {
    let mut areas = EnvelopeAreas::default();
    list.iter().for_each(|&(surface, m2)| areas.area_m2[surface as usize] = m2);
    areas
}

fn timber(group: FrameGroup, volume_m3: f64) -> FrameQuantity {
    let (material, length_m) = (FrameMaterial::C24, volume_m3 / 0.0072);
    FrameQuantity { group, material, section: 0, length_m, volume_m3, mass_kg: 420.0 * volume_m3 }
}

/// One room of 3.6 x 3.6 m, one storey, flat roof, three windows, a door, a steel beam.
fn single_bay() -> Result<Takeoff, Box<dyn std::error::Error>> {
    let skin = areas(&[
        (Surface::Wall, 36.0),
        (Surface::Band, 2.0),
        (Surface::Plinth, 4.0),
        (Surface::Window, 7.29),
        (Surface::Door, 1.944),
        (Surface::Deck, 12.96),
        (Surface::Ground, 12.96),
    ]);
    let mut takeoff = Takeoff::new(&skin, 0.0)?;
    takeoff.add_window(1.8, 1.62)?;
    takeoff.add_window(1.8, 1.62)?;
    takeoff.add_window(0.9, 1.62)?;
    takeoff.add_doors(1);
    takeoff.add_perimeter(14.4)?;
    let beam = FrameQuantity {
        group: FrameGroup::Beam,
        material: FrameMaterial::S355,
        section: 1,
        length_m: 3.6,
        volume_m3: 100.0 / 7850.0,
        mass_kg: 100.0,
    };
    takeoff.add_frame(&[timber(FrameGroup::Wall, 1.2), timber(FrameGroup::Floor, 0.8), beam])?;
    Ok(takeoff)
}

/// Two storeys of 6.3 x 6.3 m outside, 60 m2 net, hipped roof, timber frame.
fn two_storey() -> Result<Takeoff, Box<dyn std::error::Error>> {
    let skin = areas(&[
        (Surface::Wall, 135.0),
        (Surface::Band, 13.6),
        (Surface::Plinth, 6.8),
        (Surface::Window, 11.664),
        (Surface::Door, 1.944),
        (Surface::PitchedRoof, 46.0),
        (Surface::Ground, 39.69),
    ]);
    let mut takeoff = Takeoff::new(&skin, 0.0)?;
    for _ in 0..4 {
        takeoff.add_window(1.8, 1.62)?;
    }
    takeoff.add_doors(1);
    takeoff.add_stairs(1);
    [28.0, 32.0].into_iter().try_for_each(|m2| takeoff.add_floor(m2))?;
    takeoff.add_railing(5.4)?;
    takeoff.add_perimeter(25.2)?;
    takeoff.add_frame(&[
        timber(FrameGroup::Wall, 2.4),
        timber(FrameGroup::Floor, 1.6),
        timber(FrameGroup::Roof, 0.8),
    ])?;
    Ok(takeoff)
}

fn section(index: u16) -> String {
    ["60x120", "SHS100x100x5"][usize::from(index)].into()
}

/// Every rate below is the Lazio price divided by 1.265 and printed with four decimals in `prices.json`.
///
/// Build-ups per m2 or m, layer by layer:
/// wall   12.4585 plasterboard + (13.0751 + 1.5 x 2.3083) wool 4.5 cm + 5 battens + 3.0751 barrier + (13.0751 + 15 x 2.3083) wool 18 cm
///        + 18 OSB + 4 membrane + 5 battens + 83.7549 boarding                                     = 195.5257
/// roof   12.4585 + 18 x 22/15 OSB + 3.0751 + (18.9249 + 17 x 3.3913) foam 20 cm + 33.8498 membrane = 152.3604
/// slab   0.15 x 166.5613 concrete + 8 x 1.8103 bars + (18.9249 + 9 x 3.3913) foam 12 cm + 3.0751   =  91.9883
/// beam   0.15 x 166.5613 + 0.6 x 22.5771 forms + 12 x 1.8103                                       =  60.2541
/// plinth 77.0435 + 8 x 3.8498                                                                      = 107.8419
///
/// Lines:
///  1 beam S355        100 kg    x    5.2411 =    524.11
///  2 wall frame C24   1.2 m3    x 2132.0158 =  2,558.42
///  3 floor frame C24  0.8 m3    x 2132.0158 =  1,705.61
///  4 wall             36 m2     x  195.5257 =  7,038.92
///  5 floor band        2 m2     x  195.5257 =    391.05
///  6 flat roof        12.96 m2  x  152.3604 =  1,974.59      all of the deck, because none of it is walked on
///  7 windows 2 x 2.916 m2       x  475.8972 =  2,775.43
///  8 window 1.458, billed 1.5   x  475.8972 =    713.85
///  9 door              1        x 1105.1383 =  1,105.14
/// 10 plinth            4 m2     x  107.8419 =    431.37
/// 11 slab             12.96 m2  x   91.9883 =  1,192.17
/// 12 perimeter beam   14.4 m    x   60.2541 =    867.66
/// subtotal                                    21,278.32
/// overhead and profit 26.5 % of 21,278.32   =  5,638.75
/// contingency          5 %   of 26,917.07   =  1,345.85
/// envelope and frame in place                 28,262.92
/// design               7 %   of 28,262.92   =  1,978.40
/// VAT                 21 %   of 30,241.32   =  6,350.68
/// total                                       36,592.00
#[test]
fn single_bay_house_is_priced_as_by_hand() -> Outcome {
    let (books, rates) = books()?;
    let head = QuoteHead { name: "Single bay".into(), floor_area_m2: 9.0 };
    let quote = quote(&head, &single_bay()?, &books, &section)?;
    let amounts: Vec<f64> = quote.lines.iter().map(|line| line.amount).collect();
    let by_hand =
        [524.11, 2558.42, 1705.61, 7038.92, 391.05, 1974.59, 2775.43, 713.85, 1105.14, 431.37, 1192.17, 867.66];
    assert_eq!(amounts, by_hand);
    assert_eq!(quote.subtotal[1], 21278.32);
    assert_eq!([quote.surcharges[0].amount, quote.surcharges[1].amount], [5638.75, 1345.85]);
    assert_eq!(quote.price_eur[1], 28262.92);
    assert_eq!([quote.further[0].amount, quote.further[1].amount], [1978.40, 6350.68]);
    assert_eq!(quote.total[1], 36592.00);
    // Each of twelve lines and two surcharges is rounded by at most half a cent.
    assert!((cost(&single_bay()?, &rates).price_eur[1] - quote.price_eur[1]).abs() < 0.005 * 14.0 * 1.33);
    Ok(())
}

/// Wall, ISO 6946. Surfaces 0.13 and 0.13 (ventilated cladding); plasterboard 0.0125/0.25 = 0.05; OSB 0.015/0.13 = 0.115385.
/// Lower limit: service layer 0.045/(0.925 x 0.035 + 0.075 x 0.13) = 1.068249; stud zone 0.18/(0.9 x 0.035 + 0.1 x 0.13) = 4.044944; sum 5.538578.
/// Upper limit: paths wool-wool 6.853956 (0.8325), wool-timber 3.095714 (0.0925), timber-wool 5.914396 (0.0675), timber-timber 2.156154 (0.0075):
/// 1/R' = 0.121463 + 0.029880 + 0.011413 + 0.003478 = 0.166234, R' = 6.0156. U = 2/(6.0156 + 5.5386) = 0.1731.
#[test]
fn u_values_hold_their_limits_and_the_wall_is_as_by_hand() -> Outcome {
    let (books, _) = books()?;
    for buildup in books.resolve_all()? {
        if let (Some(u), Some(limit)) = (buildup.u_w_m2k, buildup.kind.u_limit()) {
            assert!(u > 0.0 && u <= limit, "{}: U {u} over {limit}", buildup.id);
        }
        println!(
            "{:15} {:6.1} mm {:7.2} kg  U {:6.3?}  {:7.2} {:7.2} {:7.2} EUR  {:6.2} kgCO2e {:7.2} biogenic {:?} MJ",
            buildup.id,
            buildup.thickness_mm,
            buildup.rates.mass_kg,
            buildup.u_w_m2k,
            buildup.rates.price[0],
            buildup.rates.price[1],
            buildup.rates.price[2],
            buildup.rates.gwp[1],
            buildup.rates.biogenic,
            buildup.rates.energy_mj
        );
    }
    let wall = books.buildup(houscaper::quantities::Item::Wall)?;
    assert!((wall.u_w_m2k.unwrap_or(9.9) - 0.1731).abs() < 5e-5);
    assert!((wall.thickness_mm - 300.0).abs() < 1e-9);
    Ok(())
}

/// Wall per m2: board 10.625, wool 0.045 x 0.925 x 30 = 1.249, battens 0.045 x 0.075 x 470 = 1.586, barrier 0.184, wool 0.18 x 0.9 x 30 = 4.860,
/// OSB 9.075, membrane 0.15, battens 0.94, boarding 10.34: 39.009 kg. Studs at 10 % of the stud zone would add 8.46 kg: they are the frame's.
#[test]
fn sticks_of_the_frame_are_in_no_build_up() -> Outcome {
    let (books, _) = books()?;
    let wall = books.buildup(houscaper::quantities::Item::Wall)?;
    assert!((wall.rates.mass_kg - 39.009).abs() < 1e-3, "{}", wall.rates.mass_kg);
    // Boards on both sides: 15 mm of OSB (9.075 kg) for 15 mm of battens and wool (0.529 + 0.416 kg).
    let both = books.buildup(houscaper::quantities::Item::WallBothSides)?;
    let more = [0.015 * 605.0, -0.015 * 0.075 * 470.0, -0.015 * 0.925 * 30.0].iter().sum::<f64>();
    assert!((both.rates.mass_kg - wall.rates.mass_kg - more).abs() < 1e-9, "{}", both.rates.mass_kg);
    // 18 EUR of OSB more, 1.5 cm of wool less.
    assert!((both.rates.price[1] - wall.rates.price[1] - (18.0 - 1.5 * 2.3083)).abs() < 1e-9, "{:?}", both.rates.price);
    assert!((both.thickness_mm - wall.thickness_mm).abs() < 1e-9, "drawn alike");
    let mut zones = 0;
    for layer in books.buildups.buildups().iter().flat_map(|b| &b.layers).filter(|l| l.label.contains(" zone")) {
        let sticks: Vec<_> = layer.parts.iter().filter(|part| part.material == "softwood").collect();
        assert!(!sticks.is_empty() && sticks.iter().all(|part| part.elsewhere.is_some()), "{}", layer.label);
        zones += 1;
    }
    assert_eq!(zones, 7, "stud zones of two walls, rafter zone, joist zones of two roofs and of the floor");
    Ok(())
}

#[test]
fn lines_sum_to_the_cost() -> Outcome {
    let (books, rates) = books()?;
    for takeoff in [single_bay()?, two_storey()?] {
        let (lines, whole) = (bill(&takeoff, &books, &section)?, cost(&takeoff, &rates));
        let near = |found: f64, expected: f64| (found - expected).abs() <= 1e-9 * expected.abs().max(1.0);
        assert!(near(lines.iter().map(|l| l.amount_low).sum(), whole.net_eur[0]));
        assert!(near(lines.iter().map(|l| l.amount).sum(), whole.net_eur[1]));
        assert!(near(lines.iter().map(|l| l.amount_high).sum(), whole.net_eur[2]));
        assert!(near(lines.iter().map(|l| l.mass_kg).sum(), whole.mass_kg));
        assert!(near(lines.iter().map(|l| l.gwp_kgco2e).sum(), whole.gwp_fossil[1]));
        assert!(near(lines.iter().map(|l| l.biogenic_kgco2e).sum(), whole.biogenic));
        assert!(near(lines.iter().filter_map(|l| l.energy_mj).sum(), whole.energy_mj.unwrap_or(f64::NAN)));
        assert_eq!(bom_csv(&lines).lines().count(), lines.len() + 1);
    }
    Ok(())
}

/// U A of the single bay: 36 + 2 m2 of wall x 0.173097, 4 x 0.267594 plinth, 7.29 x 1.3 windows, 1.944 x 1.5 door, 12.96 x 0.164649 roof,
/// 12.96 x 0.272941 slab = 6.5777 + 1.0704 + 9.4770 + 2.9160 + 2.1339 + 3.5373 = 25.712 W/K.
#[test]
fn heat_loss_is_the_sum_of_u_times_area() -> Outcome {
    let (_, rates) = books()?;
    assert!((cost(&single_bay()?, &rates).heat_loss_w_per_k - 25.712).abs() < 1e-3);
    Ok(())
}

/// A complete timber house costs 2,000 to 4,000 EUR/m2 (hausjournal.net, timber frame houses, Germany).
#[test]
fn a_typical_complete_house_costs_what_houses_cost() -> Outcome {
    let (books, rates) = books()?;
    let takeoff = two_storey()?;
    let head = QuoteHead { name: "Two storeys <typical>".into(), floor_area_m2: 60.0 };
    let quote = quote(&head, &takeoff, &books, &section)?;
    let per_m2 = quote.complete_house_per_m2.ok_or("no floor area")?;
    println!(
        "{:?}\nprice {:?} complete {:?} per m2 {per_m2:?}",
        cost(&takeoff, &rates),
        quote.price_eur,
        quote.complete_house
    );
    assert!((2000.0..=4000.0).contains(&per_m2[1]), "{per_m2:?}");
    let page = quote_html(&quote);
    assert!(page.contains("Indicative, not an offer.") && page.contains("Two storeys &lt;typical&gt;"));
    let json = serde_json::to_value(&quote)?;
    assert_eq!(json["lines"].as_array().map(Vec::len), Some(quote.lines.len()));
    assert!(json["surcharges"][0]["percentage"] == 26.5 && json["subtotal"].is_array() && json["total"].is_array());
    Ok(())
}

#[test]
fn costing_one_house_takes_less_than_two_microseconds() -> Outcome {
    let (_, rates) = books()?;
    let takeoff = two_storey()?;
    let runs = 100_000;
    let start = std::time::Instant::now();
    let sum: f64 = (0..runs).map(|_| cost(std::hint::black_box(&takeoff), &rates).price_eur[1]).sum();
    let each = start.elapsed().as_secs_f64() / f64::from(runs);
    println!("{:.0} ns a house", each * 1e9);
    assert!(sum > 0.0 && each < 2e-6 * if cfg!(debug_assertions) { 50.0 } else { 5.0 }, "{each} s a house");
    Ok(())
}
