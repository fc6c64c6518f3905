//! Two sides that draw in separate parts of a map: both fit, for all numberings of vertices and all directions of lines.

use super::Named;
use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::Face;
use twinedge::program::choose::{Choose, Random};
use twinedge_geometry::Point;
use twinedge_map::PlanarMap;
use twinedge_map::diff::{ApplyError, MergeError, Record, merge};

/// Renumbers the vertices, in an order chosen by the source.
fn numbered(map: &mut PlanarMap, by: Named, source: &mut impl Choose) {
    let mut left: Vec<u64> = (1..=map.dcel().vertex_count() as u64).collect();
    let vertices: Vec<_> = map.dcel().vertices().map(|v| v.key()).collect();
    for (v, aside) in vertices.iter().zip(1000_u64..) {
        map.set_value(by.corner, *v, aside).unwrap();
    }
    for v in vertices {
        map.set_value(by.corner, v, left.swap_remove(source.choose(left.len()))).unwrap();
    }
}

/// Draws a segment, in one direction or the other, if possible.
fn segment(map: &mut PlanarMap, from: [f64; 2], to: [f64; 2], source: &mut impl Choose) {
    let [from, to] = if source.choose(2) == 0 { [from, to] } else { [to, from] };
    let _ = map.insert_segment(from, to);
}

/// A square of 8 × 8 with vertices all along it, cut by chords, so that it is connected. Parts inherit each face's owner.
fn base(source: &mut impl Choose) -> (PlanarMap, Named) {
    let mut map = PlanarMap::new();
    let by = Named::of(&mut map);
    let along = |from: [f64; 2], [x, y]: [f64; 2]| {
        (0..8).map(move |i| [from[0] + x * f64::from(i), from[1] + y * f64::from(i)])
    };
    let sides =
        [([0.0, 0.0], [1.0, 0.0]), ([8.0, 0.0], [0.0, 1.0]), ([8.0, 8.0], [-1.0, 0.0]), ([0.0, 8.0], [0.0, -1.0])];
    map.insert_ring(sides.into_iter().flat_map(|(from, by)| along(from, by))).unwrap();
    for _ in 0..source.choose(5) {
        let places: Vec<Point> = map
            .dcel()
            .edges()
            .flat_map(|h| {
                let [p, q] = [h.origin(), h.target()].map(|v| map[v.key()]);
                [p, Point::new(f64::midpoint(p.x, q.x), f64::midpoint(p.y, q.y))]
            })
            .collect();
        let [p, q] = [(); 2].map(|()| places[source.choose(places.len())]);
        segment(&mut map, [p.x, p.y], [q.x, q.y], source);
    }
    let faces: Vec<_> = map.dcel().faces().map(Face::key).collect();
    for (f, number) in faces.into_iter().zip(0..) {
        map.set_value(by.owner, f, format!("owner {number}")).unwrap();
    }
    numbered(&mut map, by, source);
    (map, by)
}

/// Draws to the left or right of the middle. Edges across the middle get no vertices, and faces across it are not merged.
fn side(base: &PlanarMap, is_left: bool, source: &mut impl Choose) -> PlanarMap {
    let is_here = |x: f64| if is_left { x <= 3.5 } else { x >= 4.5 };
    let mut map = base.clone();
    for _ in 0..=source.choose(9) {
        let mut other = map.clone();
        let vertices: Vec<Point> = map.dcel().vertices().map(|v| map[v.key()]).filter(|p| is_here(p.x)).collect();
        let [p, q] = [(); 2].map(|()| match source.choose(3) {
            0 => {
                let [x, y] = [source.choose(8) as f64 / 2.0, source.choose(17) as f64 / 2.0];
                [if is_left { x } else { 8.0 - x }, y]
            }
            _ if vertices.is_empty() => [if is_left { 1.0 } else { 7.0 }, 1.0],
            _ => {
                let p = vertices[source.choose(vertices.len())];
                [p.x, p.y]
            }
        });
        let edited = if source.choose(4) > 0 {
            other.insert_segment(p, q)
        } else {
            let inside = |f: Face<'_>| !f.is_unbounded() && f.half_edges().all(|h| is_here(map[h.origin().key()].x));
            let edges: Vec<_> = map.dcel().edges().filter(|h| inside(h.face()) && inside(h.twin().face())).collect();
            let Some(h) = edges.get(source.choose(edges.len())) else { continue };
            other.remove_edge(h.key())
        };
        let reaches_over = |h| {
            let h = map.dcel().half_edge(h).unwrap();
            [h.origin(), h.target()].iter().any(|v| !is_here(map[v.key()].x))
        };
        if edited.is_ok_and(|edited| {
            edited.edges_split.iter().all(|(old, _)| map.dcel().half_edge(*old).is_err() || !reaches_over(*old))
        }) {
            map = other;
        }
    }
    map
}

/// The owner of the face to the left of each half-edge, by the coordinates of its ends.
fn owners(map: &PlanarMap, by: Named) -> BTreeMap<[[u64; 2]; 2], String> {
    let place = |p: Point| [p.x.to_bits(), p.y.to_bits()];
    let ends = |h: twinedge::dcel::HalfEdge<'_>| [h.origin(), h.target()].map(|v| place(map[v.key()]));
    map.dcel()
        .half_edges()
        .map(|h| (ends(h), map.value(by.owner, h.face().key()).cloned().unwrap_or_default()))
        .collect()
}

#[test]
fn drawings_that_are_apart_fit_whatever_the_numbers_and_directions() {
    let mut source = Random::seeded(2026);
    let (mut cut, mut merged_faces, mut kept) = (0, 0, 0);
    for run in 0..400 {
        let (base, by) = base(&mut source);
        let sides = [true, false].map(|is_left| side(&base, is_left, &mut source));
        let [one, other] = [[0, 1], [1, 0]].map(|[ours, theirs]| {
            merge(&base, &sides[ours], &sides[theirs], &by.ids()).unwrap_or_else(|error| panic!("run {run}: {error}"))
        });
        assert!(one.validate().is_valid());
        assert_eq!(by.told(&one), by.told(&other));
        let count = |map: &PlanarMap| map.dcel().face_count();
        assert_eq!(count(&one) + count(&base), count(&sides[0]) + count(&sides[1]));
        // If each side keeps the owners of existing areas, so does the merge: parts of different faces are not confused.
        let before = owners(&base, by);
        let other = |map: &PlanarMap| {
            let now = owners(map, by);
            before.iter().find(|(h, owner)| now.get(*h).is_some_and(|now| now != *owner)).map(|(h, _)| *h)
        };
        if sides.iter().all(|map| other(map).is_none()) {
            assert_eq!(other(&one), None, "run {run}");
            kept += 1;
        }
        cut += usize::from(sides.iter().all(|map| count(map) > count(&base)));
        merged_faces += usize::from(sides.iter().any(|map| count(map) < count(&base)));
    }
    assert!(cut > 50 && merged_faces > 2 && kept > 200, "{cut} {merged_faces} {kept}");
}

/// Two lines that cut a square into three, in either direction, so that either part keeps the id of the square.
fn three(
    keeps: usize,
    number: impl Fn(u64) -> u64,
    ours: &str,
    theirs: &str,
) -> (Result<PlanarMap, MergeError>, Named) {
    let mut map = PlanarMap::new();
    let by = Named::of(&mut map);
    let around = [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [6.0, 0.0], [6.0, 4.0], [4.0, 4.0], [2.0, 4.0], [0.0, 4.0]];
    let corners = map.insert_ring(around).unwrap().vertices;
    for pass in [1000, 0] {
        for (v, k) in corners.iter().zip(0..8) {
            map.set_value(by.corner, *v, pass + number(k)).unwrap();
        }
    }
    map.set_value(by.owner, by.f(&map, 1), "Ada".to_owned()).unwrap();
    let side = |x: f64, changes: bool, owner: &str| {
        let mut map = map.clone();
        let (kept, made) = map.insert_segment([x, 0.0], [x, 4.0]).unwrap().faces_split[0];
        let id = *map.value(by.parcel, made).unwrap();
        let sold = if changes {
            for (face, id) in [(made, 1000), (kept, id), (made, 1)] {
                map.set_value(by.parcel, face, id).unwrap();
            }
            kept
        } else {
            made
        };
        map.set_value(by.owner, sold, owner.to_owned()).unwrap();
        map
    };
    let [ours, theirs] = [side(2.0, keeps & 1 > 0, ours), side(4.0, keeps & 2 > 0, theirs)];
    let [merged, other] = [merge(&map, &ours, &theirs, &by.ids()), merge(&map, &theirs, &ours, &by.ids())];
    match (&merged, &other) {
        (Ok(merged), Ok(other)) => assert_eq!(by.told(merged), by.told(other)),
        (merged, other) => assert_eq!(merged, other),
    }
    (merged, by)
}

#[test]
fn a_face_that_both_sides_cut_has_three_parts_whichever_keep_its_id() {
    let mut kept = BTreeSet::new();
    for keeps in 0..4 {
        for turn in 0..16 {
            // Around from each vertex, in both directions.
            let number = |k| if turn < 8 { (k + turn) % 8 + 1 } else { (2 * turn - k) % 8 + 1 };
            let (merged, by) = three(keeps, number, "Ada", "Ada");
            let merged = merged.unwrap_or_else(|error| panic!("{keeps}, {turn}: {error}"));
            let told = by.told(&merged);
            assert_eq!(told.faces.keys().collect::<Vec<_>>(), [&0, &1, &2, &3]);
            assert!([1, 2, 3].iter().all(|id| told.faces[id].ends_with("Some(\"Ada\")")));
            let first = merged.dcel().face(by.f(&merged, 1)).unwrap();
            let least = first.half_edges().map(|h| merged[h.origin().key()].x).fold(8.0, f64::min);
            kept.insert(least.to_bits());
        }
    }
    assert_eq!(kept, [0.0_f64, 2.0, 4.0].map(f64::to_bits).into());
}

/// If the left part has the id of the face for one side, and the right part for the other, the part between has it for neither.
#[test]
fn a_face_that_both_sides_sell_in_parts_is_refused_where_nobody_keeps_it() {
    let refused = |ours, theirs| (0..4).filter(|keeps| three(*keeps, |k| k + 1, ours, theirs).0.is_err()).count();
    assert_eq!(refused("Ada", "Ada"), 0);
    assert_eq!([refused("Bob", "Cy"), refused("Bob", "Bob"), refused("Ada", "Bob")], [1; 3]);
    let errors: Vec<_> = (0..4).filter_map(|keeps| three(keeps, |k| k + 1, "Bob", "Cy").0.err()).collect();
    assert_eq!(errors, [MergeError::Together(ApplyError::NotOneFace(Record::Face(1)))]);
}
