//! Maps of the world, with the coordinates of their files.

use crate::support::mirrored;
use std::fs::File;
use std::io::BufReader;
use twinedge::validate::{Collect, Expectation, validate};
use twinedge_coverage::{CoverageRule, Limits};
use twinedge_layers::{ReadOptions, read_for_map};
use twinedge_map::Feature;
use twinedge_sphere::{Clash, Cover, Coverage, Drawing, Inside, Place, Subdivision, check};

fn world(name: &str) -> Vec<Feature> {
    let path = format!("{}/../../{name}", env!("CARGO_MANIFEST_DIR"));
    let mut file = BufReader::new(File::open(path).expect("it is there"));
    read_for_map(&mut file, &ReadOptions::default()).expect("it is GeoJSON").0
}

/// Returns the numbers of vertices, edges, components and faces, the clashes, and the findings.
fn judged(features: &[Feature]) -> ([usize; 4], Vec<Clash>, Coverage) {
    let drawing = Drawing::new(features).expect("places");
    assert_eq!(drawing.undrawn(), []);
    let (clashes, map) = Subdivision::new(&drawing);
    let map = map.expect("it can be cut");
    let report = validate(map.dcel(), &Expectation::plane(), Collect::All);
    assert!(report.is_valid(), "{report}");
    assert_eq!((map.out_of_order(), map.misplaced()), (0, 0));
    let counts = report.counts();
    let cover = Cover::new(&map, &drawing, Inside::Smaller);
    let found = check(&cover, &Limits::default());
    let counts = [counts.vertices, counts.edges, counts.components.expect("it is valid"), counts.faces];
    (counts, clashes, found)
}

fn count(found: &Coverage, rule: CoverageRule) -> usize {
    found.findings.iter().filter(|finding| finding.rule == rule).count()
}

/// In the plane, the map has 7,493 vertices and 7,655 edges. On the sphere, each of the two ends of Antarctica's seam along the antimeridian is one
/// place instead of two. The Caspian Sea is the only lake, and has 371,000 to 393,000 km² (Encyclopædia Britannica: 386,400).
#[test]
fn countries_lie_side_by_side_on_the_globe() {
    let features = world("crates/cli/data/world-110m.geojson");
    let (counts, clashes, found) = judged(&features);
    assert_eq!((counts, &clashes[..]), ([7_491, 7_653, 125, 288], &[][..]));
    // Sudan and South Sudan overlap in two places, as in the plane.
    assert_eq!(CoverageRule::ALL.map(|rule| count(&found, rule)), [2, 1, 0, 2, 0, 0, 0]);
    let gap = found.findings.iter().find(|finding| finding.rule == CoverageRule::Gap).expect("there is one");
    assert!((3.71e11..3.93e11).contains(&gap.area), "{}", gap.area);
    assert_eq!(gap.features.len(), 5);
}

/// Antarctica surrounds the pole, and Russia and Fiji cross the antimeridian. Expected areas in km² come from the United Nations' Demographic
/// Yearbook 2012; such coarse borders differ from them.
#[test]
fn countries_at_the_pole_and_across_the_antimeridian_are_ordinary() {
    let features = world("crates/cli/data/world-110m.geojson");
    let drawing = Drawing::new(&features).expect("places");
    let map = Subdivision::new(&drawing).1.expect("it can be cut");
    let cover = Cover::new(&map, &drawing, Inside::Smaller);
    let number =
        |name: &str| features.iter().position(|one| one.name.as_deref() == Some(name)).expect("it is there") as u32;
    for (name, area, part) in [
        ("Russia", 17_098_242.0, 0.02),
        ("Antarctica", 14_000_000.0, 0.15),
        ("Fiji", 18_272.0, 0.1),
        ("Brazil", 8_515_767.0, 0.01),
    ] {
        let found = cover.area_of(number(name)) / 1e6;
        assert!((found / area - 1.0).abs() < part, "{name}: {found}");
    }
    assert_eq!(cover.features_at(Place::SOUTH), [number("Antarctica")]);
    assert_eq!(cover.features_at(Place::NORTH), [0_u32; 0]);
}

/// Two pairs of edges cross, on the map as on the globe. The other map has a vertex at the crossing on the map, which on the globe lies on neither
/// arc.
#[test]
fn edges_that_cross_are_found_and_cut() {
    let (counts, clashes, found) = judged(&world("tests/data/world-110m-crossing.geojson"));
    assert!(clashes.len() == 2 && clashes.iter().all(|clash| matches!(clash, Clash::Cross { .. })), "{clashes:?}");
    assert_eq!(counts, [7_491, 7_653, 125, 288]);
    assert_eq!(count(&found, CoverageRule::Overlap), 2);
}

/// A mirror only changes signs, exactly. Arcs to the north of a component then lie to its south.
#[test]
fn mirrored_globes_have_the_same_faults() {
    let features = world("tests/data/world-110m-crossing.geojson");
    let (counts, clashes, found) = judged(&features);
    for [x, y] in [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
        let (of_mirror, clashes_there, found_there) = judged(&mirrored(&features, x, y));
        assert_eq!((of_mirror, clashes_there.len()), (counts, clashes.len()));
        assert_eq!(found_there.findings.len(), found.findings.len());
        for (one, other) in found.findings.iter().zip(&found_there.findings) {
            assert_eq!((one.rule, &one.features), (other.rule, &other.features));
            assert!((one.area / other.area - 1.0).abs() < 1e-6, "{one:?} {other:?}");
        }
    }
}
