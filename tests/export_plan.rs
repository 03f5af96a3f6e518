//! Storey plans.

use houscaper::export::plan::*;
use houscaper::export::plots::svg_to_png;

#[test]
fn a_plan_shows_walls_windows_door_and_stair() {
    let plan = StoreyPlan {
        title: "Ground storey <52.4 m²>".into(),
        loops: vec![vec![[0.0, 0.0], [9.0, 0.0], [9.0, 3.6], [6.3, 3.6], [6.3, 6.3], [0.0, 6.3]]],
        openings: vec![
            PlanOpening { kind: PlanOpeningKind::Window, from: [0.9, 0.0], to: [3.6, 0.0] },
            PlanOpening { kind: PlanOpeningKind::Window, from: [9.0, 0.9], to: [9.0, 2.7] },
            PlanOpening { kind: PlanOpeningKind::Door, from: [5.4, 0.0], to: [6.3, 0.0] },
        ],
        flights: vec![PlanFlight { from: [0.4, 4.95], to: [5.8, 4.95], width_m: 0.9, treads: 18 }],
        grid_m: 0.9,
        ..StoreyPlan::default()
    };
    let svg = plan_svg(&plan);
    assert_eq!(svg, plan_svg(&plan));
    assert_eq!(svg.matches("class=\"swing\"").count(), 1);
    assert!(svg.contains("&lt;52.4") && svg.contains("width=\"114mm\""));
    let png = svg_to_png(&svg, 2.0).unwrap();
    if let Some(folder) = std::env::var_os("HOUSCAPER_LOOK") {
        std::fs::write(std::path::Path::new(&folder).join("plan.png"), png).expect("folder to look in");
    }
    let broken = StoreyPlan { loops: vec![vec![[f64::NAN; 2]; 4]], grid_m: f64::NAN, ..plan };
    assert!(!plan_svg(&broken).contains("NaN"));
}
