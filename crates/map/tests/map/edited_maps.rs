//! Queries for areas and borders on maps made by random edits, compared with plain computations.

use crate::support::edits::{EvenEdits, SIDE, edited};
use crate::support::oracle::{Plain, Whole, whole};
use quickcheck::{Gen, QuickCheck, Testable};
use std::collections::BTreeMap;
use twinedge::dcel::{Face, FaceKey, HalfEdge};
use twinedge_algorithm::claims::{faces_of, leaks};
use twinedge_algorithm::contour::{Contour, ContourError, of_feature, of_features};
use twinedge_algorithm::neighbours;
use twinedge_algorithm::overlay::{Operand, overlay};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::{Builder, FeatureId, Located, PlanarMap};

/// The scale of query points, which lie between vertices: whole numbers of hundredths.
const SCALE: i128 = 100;

fn check(tests: u64, property: impl Testable) {
    QuickCheck::new().rng(Gen::from_size_and_seed(40, 2027)).tests(tests).quickcheck(property);
}

/// Points everywhere, in hundredths.
fn samples() -> impl Iterator<Item = Whole> {
    let along = || -1..=i128::from(SIDE);
    along().flat_map(move |x| along().map(move |y| [x * SCALE + 37, y * SCALE + 61]))
}

fn float(p: Whole) -> Point {
    let [x, y] = p.map(|c| c as f64 / SCALE as f64);
    Point::new(x, y)
}

fn face_at(plain: &Plain, p: Whole) -> Option<FaceKey> {
    match plain.locate(p, SCALE) {
        Located::Face(face) => Some(face),
        Located::Edge(_) | Located::Vertex(_) => None,
    }
}

fn covers(map: &PlanarMap, face: FaceKey) -> Vec<usize> {
    map.features_of(face).expect("of this map").map(FeatureId::index).collect()
}

/// Returns true if a ring has a point inside, by the edges above it.
fn is_inside(ring: &[Point], p: Whole) -> bool {
    let above = |pair: &[Point]| {
        let [a, b] = [pair[0], pair[1]].map(|end| whole(end).map(|c| c * SCALE));
        let turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        (a[0] < p[0]) != (b[0] < p[0]) && (turn < 0) == (a[0] < b[0])
    };
    ring.windows(2).filter(|pair| above(pair)).count() % 2 == 1
}

fn polygons_around(contour: &Contour, p: Whole) -> usize {
    let inside = |rings: &mut dyn Iterator<Item = &[Point]>| rings.filter(|ring| is_inside(ring, p)).count() == 1;
    contour.polygons.iter().filter(|polygon| inside(&mut polygon.rings())).count()
}

#[test]
fn contours_enclose_the_faces_that_were_claimed() {
    fn property(program: EvenEdits) -> bool {
        let map = edited(&program, 3);
        let plain = Plain::new(&map);
        for feature in map.features() {
            let contour = match of_feature(&map, feature) {
                Ok(contour) => contour,
                Err(error) => {
                    assert!(error == ContourError::Unbounded && leaks(&map, feature));
                    continue;
                }
            };
            let claimed = faces_of(&map, feature);
            for p in samples() {
                let Some(face) = face_at(&plain, p) else { continue };
                assert_eq!(polygons_around(&contour, p), usize::from(claimed.contains(&face)), "{p:?}");
            }
        }
        true
    }
    check(150, property as fn(EvenEdits) -> bool);
}

#[test]
fn borders_are_as_long_as_their_edges() {
    fn property(program: EvenEdits) -> bool {
        let map = edited(&program, 4);
        let length = |h: HalfEdge<'_>| {
            let [a, b] = [h.origin(), h.target()].map(|v| map.position(v.key()).expect("of this map"));
            (a.x - b.x).hypot(a.y - b.y)
        };
        let of = |face: Face<'_>| covers(&map, face.key());
        // For each pair of features, the length of the border of a with b beyond, and of the part where b begins.
        let mut lengths: BTreeMap<(usize, usize), [f64; 2]> = BTreeMap::new();
        for h in map.dcel().half_edges().filter(|h| h.face() != h.twin().face()) {
            let (here, across) = (of(h.face()), of(h.twin().face()));
            for a in here.iter().filter(|a| !across.contains(a)) {
                for b in &across {
                    let [border, shared] = lengths.entry((*a, *b)).or_default();
                    *border += length(h);
                    *shared += if here.contains(b) { 0.0 } else { length(h) };
                }
            }
        }
        for feature in map.features() {
            for other in neighbours::of_feature(&map, feature) {
                let [expected, shared] =
                    lengths.remove(&(feature.index(), other.neighbour.index())).expect("they have a border");
                let steps = other.borders.iter().flat_map(|chain| chain.windows(2));
                let drawn: f64 = steps.map(|pair| (pair[0].x - pair[1].x).hypot(pair[0].y - pair[1].y)).sum();
                assert!((other.length - expected).abs() < 1e-9 && (drawn - expected).abs() < 1e-9);
                assert!((other.shared - shared).abs() < 1e-9);
            }
        }
        assert!(lengths.is_empty(), "{lengths:?}");
        true
    }
    check(150, property as fn(EvenEdits) -> bool);
}

#[test]
fn overlays_lie_where_both_maps_say() {
    fn property(one: EvenEdits, other: EvenEdits) -> bool {
        let maps = [edited(&one, 2), edited(&other, 2)];
        let [left, right] = &maps;
        let both = overlay(left, right, Snap::Auto).expect("small numbers");
        let report = both.map().validate();
        assert!(report.is_valid(), "{report}");
        let plain = maps.each_ref().map(Plain::new);
        for p in samples() {
            // A point off an edge is far from it, compared with rounding.
            let (Some(in_left), Some(in_right)) = (face_at(&plain[0], p), face_at(&plain[1], p)) else { continue };
            let Ok(Located::Face(face)) = both.map().locate(float(p)) else {
                panic!("{p:?} is on no edge of either map")
            };
            assert_eq!(both.face_in(Operand::Left, face), Ok(in_left), "{p:?}");
            assert_eq!(both.face_in(Operand::Right, face), Ok(in_right), "{p:?}");
            let mut expected = covers(left, in_left);
            expected.extend(covers(right, in_right).iter().map(|feature| feature + 2));
            assert_eq!(covers(both.map(), face), expected, "{p:?}");
        }
        true
    }
    check(80, property as fn(EvenEdits, EvenEdits) -> bool);
}

#[test]
fn what_is_written_of_an_edited_map_covers_the_same() {
    fn property(program: EvenEdits) -> bool {
        let map = edited(&program, 3);
        if map.features().any(|feature| leaks(&map, feature)) {
            return true;
        }
        let mut builder = Builder::new();
        for feature in of_features(&map).expect("it is plane") {
            builder.feature(&feature.into()).expect("in range");
        }
        let again = builder.build().expect("fits");
        assert!(again.is_plane());
        let (plain, plain_again) = (Plain::new(&map), Plain::new(&again));
        for p in samples() {
            if let (Some(face), Some(face_again)) = (face_at(&plain, p), face_at(&plain_again, p)) {
                assert_eq!(covers(&again, face_again), covers(&map, face), "{p:?}");
            }
        }
        true
    }
    check(150, property as fn(EvenEdits) -> bool);
}
