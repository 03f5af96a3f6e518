//! Where every load comes from: actions, wind zones, arrangements of snow, combinations, and whether reactions balance them.

mod types;

pub use types::{ActionReport, CombinationReport, LoadReport, SnowReport, SumReport, WindReport, ZoneReport};

use super::actions::BaseActions;
use super::cases::{Case, CaseLoads, UNITS, case_name};
use super::combine::{Combination, Duration, PRESSED, WINDS_A_SIDE};
use super::loads::{LoadSettings, ZONE_NAMES, ZONES};
use super::wind::{Wind, slenderness};
use crate::analysis::{Distribution, LoadCase, Model, Solution};
use crate::frame::HouseFrame;

const SIDES: [&str; 4] = ["+x", "+y", "-x", "-y"];

/// What stands in for what, whatever the house.
const STAND_INS: [&str; 12] = [
    "cpe,10 everywhere; no peaks on small areas (cpe,1)",
    "the whole house takes the peak velocity pressure at its top (EN 1991-1-4 7.2.2(1) would allow less below b in houses higher than wide)",
    "roofs that are no rectangles: every distance of a zone counts from the nearest edge of the roof in its own row, e from the whole house",
    "a plateau of a pitched roof takes zones H and I of flat roofs (Table 7.2)",
    "zones L and M of hip roofs (Figure 7.9): L is the strip of e/10 behind the upwind hip, M reaches to e/2 from the upwind eave; as read from secondary drawings of the figure",
    "a slope that leans on a taller wall takes the values of a monopitch roof with a free high edge (Table 7.3)",
    "undersides of projecting floors take the pressure of the wall below them (EN 1991-1-4 7.2.1(3)); eaves do not project in the frame",
    "of the four cases of Table 7.4a (duopitch) three are run: windward slopes sucked with the lee pressed is not",
    "internal pressure +0.2 or -0.3, whichever is worse (7.2.9(6)); windward roofs pressed act with both, sucked roofs with +0.2",
    "one-sided snow (5.3.3) on hip roofs: on their main pair of slopes",
    "snow against a taller part (5.3.6) on a pitched lower roof as if it were level",
    "exceptional snow (annex B), orography, dynamic response and friction of the wind are left out",
];

#[allow(clippy::too_many_arguments, reason = "everything an assessment has made")]
pub(super) fn report(
    frame: &HouseFrame,
    loads: &LoadSettings,
    model: &Model,
    cases: &CaseLoads,
    actions: &BaseActions,
    combinations: &[Combination],
    solution: &Solution,
) -> LoadReport {
    LoadReport {
        actions: action_list(frame, loads),
        wind: (0..4).map(|side| wind(frame, loads, cases, actions, side)).collect(),
        snow: snow(frame, model, cases, &actions.snows),
        combinations: combinations.iter().map(combination).collect(),
        serviceability: serviceability(loads),
        sums: sums(frame, model, cases, solution),
        stand_ins: STAND_INS.to_vec(),
    }
}

fn action_list(frame: &HouseFrame, loads: &LoadSettings) -> Vec<ActionReport> {
    let pitch = frame.pitch_deg;
    let row = |action, value: &[f64], unit, key: &str| ActionReport {
        action,
        value: value.to_vec(),
        unit,
        source: loads.source(key),
    };
    let by = |key: &str| format!("{key}.{}", loads.annex.key());
    let kn = |n: f64| n / 1e3;
    vec![
        row("partial factors Gsup, Ginf, Q", &loads.gamma, "-", &by("gamma")),
        row("Gsup in (6.10a) and alone", &[loads.gamma_a], "-", &by("gamma_g_610a")),
        row("xi in (6.10b)", &[loads.xi], "-", &by("xi")),
        row("static equilibrium: G, W", &loads.equ, "-", "equ"),
        row("psi0 of imposed load, snow, wind", &loads.psi0, "-", &by("psi0")),
        row("psi1 of imposed load, snow, wind", &loads.psi1, "-", &by("psi1")),
        row("psi2 of imposed load, snow, wind", &loads.psi2, "-", &by("psi2")),
        row("imposed load on floors", &[kn(loads.floor)], "kN/m2", &by("floor")),
        row("partitions, with the imposed load", &[kn(loads.partitions)], "kN/m2", "partitions"),
        row("imposed load on stairs", &[kn(loads.stair)], "kN/m2", "stair"),
        row("imposed load on decks", &[kn(loads.deck)], "kN/m2", "deck"),
        row("imposed load in roof spaces", &[kn(loads.attic)], "kN/m2", "attic"),
        row(
            "imposed load on roofs: level, pitched",
            &[kn(loads.roof_load(0.0)), kn(loads.roof_load(pitch))],
            "kN/m2",
            &by("roof"),
        ),
        ActionReport {
            action: "weight of build-ups: wall, band, plinth, window, door, pitched roof, flat roof, deck, soffit, ground, floor, wall boarded on both sides",
            value: loads
                .weights
                .surface_kn_m2
                .iter()
                .copied()
                .chain([loads.weights.floor_kn_m2, loads.weights.wall_both_kn_m2])
                .collect(),
            unit: "kN/m2",
            source: "layers of the build-ups, a m2 each; the mass of the take-off is spread over the frame's areas of its kind, so that all of it is carried; members of the frame by their section and density at 9.81 m/s2".into(),
        },
        ActionReport {
            action: "snow on the ground",
            value: vec![kn(loads.sk)],
            unit: "kN/m2",
            source: "the brief's site; Ce = Ct = 1".into(),
        },
        row("mu1: level, pitched", &[loads.mu1(0.0), loads.mu1(pitch)], "-", "mu1_30"),
        row("mu2 in valleys", &[loads.mu2(pitch)], "-", "mu2"),
        row("roof pitch", &[pitch], "degrees", ""),
        ActionReport {
            action: "basic wind velocity",
            value: vec![loads.vb],
            unit: "m/s",
            source: "the brief's site; EN 1991-1-4 4.2, cdir = cseason = 1".into(),
        },
        row("terrain z0, zmin", &loads.terrain, "m", &format!("terrain.{}", loads.terrain_name)),
        row("air density", &[loads.air_density], "kg/m3", "air_density"),
        row("internal pressure coefficients", &loads.cpi, "-", "cpi"),
        row("height of parapets", &[loads.parapet], "m", "parapet_m"),
        row("limits: l/total deflection, l/variable deflection, H/drift", &loads.limits, "-", "limits"),
        row(
            "floor vibration: Hz, mm/kN, b, damping",
            &[loads.vibration.frequency, loads.vibration.deflection * 1e6, loads.vibration.b, loads.vibration.damping],
            "-",
            "vibration",
        ),
        row("floor boards across the joists", &[loads.vibration.board], "N m2/m", "floor_board"),
    ]
}

fn wind(frame: &HouseFrame, loads: &LoadSettings, cases: &CaseLoads, actions: &BaseActions, side: usize) -> WindReport {
    let wind = Wind::new(frame, loads);
    let (mut areas, mut forces, mut steps) = ([0.0; ZONES], [[0.0; 3]; ZONES], Vec::new());
    for a in &frame.areas {
        let Some(out) = super::cases::normal(a.area, frame.pitch_deg) else { continue };
        // Surface of a slope: plan area over the cosine, which is the length of its normal.
        let surface = a.area_m2 * out.iter().map(|n| n * n).sum::<f64>().sqrt();
        cases.plan.half_modules(frame, a, &mut steps);
        wind.zones(frame, &cases.plan, a, &steps, side, &mut |zone, share| {
            areas[zone] += share * surface;
            let push = wind.cpe[side][zone][0] * wind.pressure * a.area_m2 * share;
            (0..3).for_each(|x| forces[zone][x] -= push * out[x]);
        });
    }
    let zones = (0..ZONES).filter(|&z| areas[z] > 1e-9).map(|z| ZoneReport {
        zone: ZONE_NAMES[z].1,
        clause: ZONE_NAMES[z].0,
        area_m2: areas[z],
        cpe: wind.cpe[side][z],
        force_n: forces[z],
    });
    let least_n = cases.force(frame, None, Case::Wind as usize + side);
    let more = cases.force(frame, None, Case::Pressed as usize + side);
    WindReport {
        from: SIDES[side],
        qp_n_m2: wind.pressure,
        ze_m: frame.size_m[2],
        e_m: wind.gusts[side].e,
        h_over_d: slenderness(frame, side),
        correlation: [loads.correlation(slenderness(frame, side)), actions.overall[WINDS_A_SIDE * side + PRESSED]],
        zones: zones.collect(),
        least_n,
        pressed_n: [0, 1, 2].map(|a| least_n[a] + more[a]),
    }
}

fn snow(frame: &HouseFrame, model: &Model, cases: &CaseLoads, acts: &[bool; 4]) -> Vec<SnowReport> {
    let even = -cases.force(frame, Some(model), Case::Snow as usize)[2];
    let names = [
        (
            "even; the imposed load of roofs (category H) where that is larger",
            "EN 1991-1-3 5.3.2, 5.3.3 case (i); EN 1991-1-1 6.3.4",
        ),
        ("half on slopes towards +x or +y", "EN 1991-1-3 5.3.3 cases (ii), (iii)"),
        ("half on slopes towards -x or -y", "EN 1991-1-3 5.3.3 cases (ii), (iii)"),
        ("drifted into valleys and against taller parts", "EN 1991-1-3 5.3.4, 5.3.6"),
    ];
    (0..4)
        .filter(|&n| acts[n])
        .map(|n| SnowReport {
            arrangement: names[n].0,
            clause: names[n].1,
            weight_n: match n {
                0 => even,
                _ => even - cases.force(frame, None, Case::Snow as usize + n)[2],
            },
        })
        .collect()
}

fn combination(c: &Combination) -> CombinationReport {
    let words = [
        "cpi = +0.2, windward roofs pressed",
        "cpi = -0.3, windward roofs pressed",
        "cpi = +0.2, all roofs sucked",
        "cpi = -0.3, windward roofs and lee pressed",
    ];
    CombinationReport {
        clause: c.clause,
        factors: [c.permanent, c.imposed, c.snow.1, c.wind.map_or(0.0, |w| w.1)],
        snow: (c.snow.1 != 0.0).then_some(c.snow.0),
        wind: c.wind.map(|(n, _)| format!("from {}, {}", SIDES[n / WINDS_A_SIDE], words[n % WINDS_A_SIDE])),
        duration: match c.duration {
            Duration::Permanent => "permanent",
            Duration::Medium => "medium",
            Duration::Short => "short",
        },
    }
}

fn serviceability(loads: &LoadSettings) -> Vec<String> {
    let [total, variable, drift] = loads.limits;
    let [p_q, p_s, _] = loads.psi0;
    let ([f_q, f_s, f_w], [s_q, s_s, s_w]) = (loads.psi1, loads.psi2);
    vec![
        format!(
            "characteristic (EN 1990 6.14b), each variable action leading: G + Q + {p_q} or {p_s} Q; variable part against l/{variable:.0} (cantilevers: twice their length), wind alone against H/{drift:.0} storey drift"
        ),
        format!(
            "final (EN 1995-1-1 2.2.3): characteristic plus creep kdef (G + {s_q} Q + {s_s} S), against l/{total:.0}"
        ),
        format!(
            "frequent (EN 1990 6.15b): G + {f_q} Q or {f_s} S or {f_w} W leading, others at psi2; lower than characteristic, no limit of its own"
        ),
        format!("quasi-permanent (EN 1990 6.16b): G + {s_q} Q + {s_s} S + {s_w} W; enters as creep"),
        "floor vibration (EN 1995-1-1 7.3): weight of the floor alone; joists on rigid supports".into(),
    ]
}

fn sums(frame: &HouseFrame, model: &Model, cases: &CaseLoads, solution: &Solution) -> Vec<SumReport> {
    (0..UNITS)
        .filter_map(|case| {
            let slot = cases.slot(case)?;
            let mut reactions_n = [0.0; 3];
            solution.reactions(slot).iter().for_each(|r| (0..3).for_each(|a| reactions_n[a] += r[a]));
            Some(SumReport { case: case_name(case), loads_n: cases.force(frame, Some(model), case), reactions_n })
        })
        .collect()
}

/// Vertical load of permanent + imposed + even snow, and the reactions to it.
pub(super) fn balance(frame: &HouseFrame, model: &Model, cases: &CaseLoads, solution: &Solution) -> [f64; 2] {
    let mut out = [0.0; 2];
    for case in [Case::Permanent, Case::Imposed, Case::Snow] {
        let Some(slot) = cases.slot(case as usize) else { continue };
        out[0] -= cases.force(frame, Some(model), case as usize)[2];
        out[1] += solution.reactions(slot).iter().map(|r| r[2]).sum::<f64>();
    }
    out
}

/// Sum of a case's loads, with the members' own weight where it acts and `model` is given, N.
pub(super) fn force(frame: &HouseFrame, model: Option<&Model>, case: &LoadCase) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for l in &case.members {
        if let Distribution::Uniform { q } = l.distribution {
            let length = frame.element_length_m(l.member);
            (0..3).for_each(|a| sum[a] += q[a] * length);
        }
    }
    if let Some(model) = model.filter(|_| case.gravity != [0.0; 3]) {
        for (e, m) in model.members.iter().take(frame.elements.len()).enumerate() {
            let mass = model.materials[m.material].rho * model.sections[m.section].a * frame.element_length_m(e);
            (0..3).for_each(|a| sum[a] += case.gravity[a] * mass);
        }
    }
    sum
}
