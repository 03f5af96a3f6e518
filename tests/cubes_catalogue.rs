//! The thesis's catalogue: families, counts, the union of 493, and the counts that contradict each other.

use std::collections::BTreeSet;

use houscaper::cubes::{Grouping, Mask, catalogue, doubts};

#[test]
fn families_have_the_counts_of_the_thesis() {
    let found: Vec<_> = catalogue().iter().map(|f| (f.name, f.tiles, f.configurations)).collect();
    let expected = [
        ("base", 26, 126),
        ("floor frame up", 10, 52),
        ("floor frame down", 15, 66),
        ("foundation frame up", 10, 52),
        ("foundation only", 4, 13),
        ("windows", 10, 52),
        ("openings", 10, 52),
        ("floor to opening", 10, 40),
        ("foundation to opening", 10, 40),
    ];
    assert_eq!(found, expected);
}

#[test]
fn the_union_is_493_different_admissible_configurations() {
    let families = catalogue();
    let all: Vec<_> = families.iter().flat_map(|f| &f.members).collect();
    assert_eq!(all.len(), 493);
    assert_eq!(all.iter().collect::<BTreeSet<_>>().len(), 493, "no configuration lies in two families");
    assert!(all.iter().all(|labels| Mask::of(labels).is_allowed()));
}

#[test]
fn families_are_closed_under_their_symmetries() {
    for family in catalogue() {
        let members: BTreeSet<_> = family.members.iter().collect();
        assert!(family.members.iter().all(|m| members.contains(&Grouping::TurnsAndMirror.class(m))), "{}", family.name);
        assert_eq!(family.representatives().len(), family.tiles);
    }
}

#[test]
fn both_sides_of_each_contradiction_are_counted() {
    let text: Vec<String> =
        doubts().iter().map(|d| format!("{}|{}|{}|{}", d.subject, d.used, d.other, d.reason)).collect();
    for (n, parts) in [
        &["10 tiles, 52 configurations", "12 tiles, 60 configurations"][..],
        &["60 different", "52 without", "72: 9 parts", "12 are counted twice"],
        &["105, with ten", "109, with twelve"],
        &["25 + 10 + 4", "|39|"],
        &["40: slab and storey", "40: slab under", "there are 7"],
        &["493 configurations"],
    ]
    .iter()
    .enumerate()
    {
        for part in *parts {
            assert!(text[n].contains(part), "{} lacks {part}", text[n]);
        }
    }
}
