//! Canonical forms, compared with published counts of maps and with a search through all correspondences.

use crate::support::erased::validate_plane;
use crate::support::programs::noise;
use crate::support::renumbered::renumbered;
use crate::support::rotations::each_rotation_system;
use crate::support::tables::TEXTBOOK;
use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::{Dcel, HalfEdge, HalfEdgeKey, Side, Split};
use twinedge::program::{FacePick, Op, Program, Runner};
use twinedge::validate::{BoundaryPlace, Expectation, Start, Table, View};
use twinedge_trials::canonical::{Canonizer, Code, isomorphic};
use twinedge_trials::forms::{Form, projected};

/// All maps with one more edge, one of each isomorphism class: a leaf in every corner, an edge between any two corners
/// of a face.
fn grow(maps: &[Dcel]) -> Vec<Dcel> {
    let mut canonizer = Canonizer::new();
    let mut seen = BTreeSet::new();
    let mut grown = Vec::new();
    let mut keep = |map: Dcel| {
        if seen.insert(canonizer.unrooted(&map).unwrap().code) {
            grown.push(map);
        }
    };
    for map in maps {
        let corners: Vec<HalfEdgeKey> = map.half_edges().map(HalfEdge::key).collect();
        if corners.is_empty() {
            let v = map.vertices().next().unwrap().key();
            let mut more = map.clone();
            more.split_vertex(v, v).unwrap();
            keep(more);
            let mut more = map.clone();
            more.connect(v, v, Split::default()).unwrap();
            keep(more);
        }
        for a in &corners {
            let mut more = map.clone();
            more.split_vertex(*a, *a).unwrap();
            keep(more);
            for b in &corners {
                let mut more = map.clone();
                if more.connect(*a, *b, Split::default()).is_ok() {
                    keep(more);
                }
            }
        }
    }
    grown
}

#[test]
fn plane_maps_are_as_many_as_published() {
    let mut map = Dcel::new();
    map.add_isolated_vertex(map.unbounded_face().key()).unwrap();
    let mut maps = vec![map];
    let mut canonizer = Canonizer::new();
    let mut counts = Vec::new();
    for _ in 0..6 {
        let rooted: usize = maps.iter().map(|map| canonizer.unrooted(map).unwrap().rootings).sum();
        counts.push((maps.len(), rooted));
        maps = grow(&maps);
    }
    // OEIS A006384 and A000168.
    assert_eq!(counts, [(1, 1), (2, 2), (4, 9), (14, 54), (57, 378), (312, 2916)]);
}

fn cycles(next: impl Fn(usize) -> usize, n: usize) -> usize {
    let mut seen = vec![false; n];
    let mut count = 0;
    for start in 0..n {
        count += usize::from(!seen[start]);
        let mut h = start;
        while !std::mem::replace(&mut seen[h], true) {
            h = next(h);
        }
    }
    count
}

#[test]
fn rooted_maps_of_every_genus_are_as_many_as_published() {
    // Rooted maps by edges and genus: OEIS A000168, A006300, A006298.
    for (edges, expected) in [(1, vec![2]), (2, vec![9, 1]), (3, vec![54, 20]), (4, vec![378, 307, 21])] {
        let mut canonizer = Canonizer::new();
        let mut codes: BTreeMap<usize, BTreeSet<Code>> = BTreeMap::new();
        let mut rootings: BTreeMap<Code, usize> = BTreeMap::new();
        each_rotation_system(edges, |table| {
            // Connected maps have a form without a root.
            if let Some(unrooted) = canonizer.unrooted(table) {
                let next = |h: usize| table.next(h).unwrap();
                // V - E + cycles = 2 - 2g.
                let genus = (2 + edges - table.vertices.len() - cycles(next, 2 * edges)) / 2;
                codes.entry(genus).or_default().insert(canonizer.rooted(table, 0).unwrap());
                assert_eq!(unrooted.rootings * unrooted.automorphisms, 2 * edges);
                rootings.insert(unrooted.code, unrooted.rootings);
            }
        });
        assert_eq!(codes.values().map(BTreeSet::len).collect::<Vec<_>>(), expected, "{edges} edges");
        assert_eq!(rootings.values().sum::<usize>(), expected.iter().sum::<usize>());
    }
}

/// Tells whether some correspondence of half-edges keeps everything, by trying all.
fn correspond(one: &Dcel, other: &Dcel) -> bool {
    let counts = |map: &Dcel| {
        let isolated = map.vertices().filter(|v| v.isolated().is_some()).count();
        (map.vertex_count(), map.edge_count(), map.boundary_count(), map.face_count(), isolated)
    };
    counts(one) == counts(other) && extend(one, other, &mut BTreeMap::new())
}

/// Tries every image of the first half-edge without one.
fn extend(one: &Dcel, other: &Dcel, images: &mut BTreeMap<usize, usize>) -> bool {
    let Some(first) = one.half_edges().find(|h| !images.contains_key(&h.index())) else {
        return keeps_faces(one, other, images);
    };
    other.half_edges().any(|image| {
        let mut more = images.clone();
        follow(one, other, first.index(), image.index(), &mut more) && extend(one, other, &mut more)
    })
}

/// Extends a correspondence along `next` and `twin`, up to a contradiction.
fn follow(one: &Dcel, other: &Dcel, h: usize, image: usize, images: &mut BTreeMap<usize, usize>) -> bool {
    if let Some(known) = images.get(&h) {
        return *known == image;
    }
    if images.values().any(|other| *other == image) {
        return false;
    }
    images.insert(h, image);
    let (h, image) = (one.half_edge_at(h).unwrap(), other.half_edge_at(image).unwrap());
    follow(one, other, h.next().index(), image.next().index(), images)
        && follow(one, other, h.twin().index(), image.twin().index(), images)
}

fn keeps_faces(one: &Dcel, other: &Dcel, images: &BTreeMap<usize, usize>) -> bool {
    let mut faces = BTreeMap::from([(one.unbounded_face().index(), other.unbounded_face().index())]);
    for (h, image) in images {
        let (h, image) = (one.half_edge_at(*h).unwrap(), other.half_edge_at(*image).unwrap());
        if *faces.entry(h.face().index()).or_insert(image.face().index()) != image.face().index()
            || h.boundary().is_outer() != image.boundary().is_outer()
        {
            return false;
        }
    }
    let isolated =
        |map: &Dcel, f: usize| map.face_at(f).unwrap().inner().filter(|b| b.isolated_vertex().is_some()).count();
    faces.values().collect::<BTreeSet<_>>().len() == faces.len()
        && faces.iter().all(|(f, image)| isolated(one, *f) == isolated(other, *image))
}

/// A small map, with nesting in about half of the cases.
fn random_map(seed: u64) -> Dcel {
    let mut runner = Runner::new(Dcel::new());
    let add = Op::AddIsolatedVertex { face: FacePick::Unbounded };
    runner.run(&Program(vec![add; 1 + seed as usize % 3]));
    let mut bytes = noise(seed);
    while runner.subject().edge_count() < 1 + seed as usize % 5 {
        runner.step(Op::from_bytes(&mut bytes).unwrap());
    }
    runner.into_subject()
}

/// All maps made by moving one hole or isolated vertex to another face, twice.
fn with_moves(map: &Dcel) -> Vec<Dcel> {
    let mut family = vec![map.clone()];
    for _ in 0..2 {
        let mut moved = Vec::new();
        for map in &family {
            for b in map.boundaries().filter(|b| !b.is_outer()) {
                for f in map.faces() {
                    let mut other = map.clone();
                    if other.move_inner(b.key(), f.key()).is_ok() {
                        moved.push(other);
                    }
                }
            }
        }
        family.extend(moved.into_iter().take(40));
    }
    family
}

#[test]
fn forms_are_equal_exactly_where_some_correspondence_is_found() {
    let has_hole = |map: &Dcel| map.faces().any(|f| !f.is_unbounded() && f.inner_count() > 0);
    let mut canonizer = Canonizer::new();
    let (mut equal, mut different) = (0, 0);
    for seed in 0..60 {
        let maps = with_moves(&random_map(seed));
        let codes: Vec<Code> = maps.iter().map(|map| canonizer.subdivision(map).unwrap()).collect();
        for (i, one) in maps.iter().enumerate() {
            for (j, other) in maps.iter().enumerate().take(i) {
                let same = codes[i] == codes[j];
                assert_eq!(same, correspond(one, other), "seed {seed}, maps {i} and {j}");
                if has_hole(one) {
                    *if same { &mut equal } else { &mut different } += 1;
                }
            }
        }
    }
    assert!(equal > 1000 && different > 1000, "too few pairs with holes to show anything: {equal}, {different}");
}

/// An isomorphic table with its records in other slots, some vacant, with other starts and reversed lists.
fn renamed(map: &Dcel, seed: u64) -> Table {
    let mut table = Table::copy_of(map).expect("a small map fits");
    let next: Vec<_> = (0..table.half_edges.len()).map(|h| table.next(h)).collect();
    for row in table.boundaries.iter_mut().flatten() {
        if let Some(Start::HalfEdge(h)) = &mut row.start {
            *h = next[*h].unwrap();
        }
    }
    for row in table.faces.iter_mut().flatten() {
        row.inner.reverse();
        for (place, b) in row.inner.iter().enumerate() {
            table.boundaries[b.unwrap()].as_mut().unwrap().place = Some(BoundaryPlace::Inner(place));
        }
    }
    let mut bytes = noise(seed);
    let mut shuffle = |n: usize| -> Vec<usize> {
        let mut slots: Vec<(u8, usize)> = bytes.by_ref().take(n + 2).zip(0..).collect();
        slots.sort_unstable();
        slots.into_iter().map(|(_, slot)| slot).collect()
    };
    let counts = [table.vertices.len(), table.half_edges.len(), table.boundaries.len(), table.faces.len()];
    renumbered(&table, &counts.map(&mut shuffle))
}

#[test]
fn forms_do_not_depend_on_names_nor_on_the_kind_of_records() {
    for seed in 0..100 {
        let map = random_map(seed);
        let table = renamed(&map, seed);
        let textbook = projected(&table, &Form::new(Expectation::plane(), TEXTBOOK));
        assert!(validate_plane(&table).is_valid(), "seed {seed}");
        assert!(validate_plane(&textbook).is_valid(), "seed {seed}");
        assert!(isomorphic(&map, &table) && isomorphic(&table, &textbook), "seed {seed}");
    }
}

#[test]
fn a_mirror_image_is_another_map() {
    // A triangle with a path of two edges inside at one vertex and a single edge inside at the next, or vice versa.
    let triangle = |lengths: [usize; 3]| {
        let mut map = Dcel::new();
        let v = map.add_isolated_vertex(map.unbounded_face().key()).unwrap().vertex;
        let a = map.connect(v, v, Split { new_face: Side::Left, inner: &[] }).unwrap().half_edge;
        let b = map.split_edge(a).unwrap().half_edge;
        let c = map.split_edge(b).unwrap().half_edge;
        for (corner, length) in [a, b, c].into_iter().zip(lengths) {
            let mut at = corner;
            for _ in 0..length {
                let leaf = map.split_vertex(at, at).unwrap().half_edge;
                at = map.half_edge(leaf).unwrap().twin().key();
            }
        }
        assert!(map.validate().is_valid());
        map
    };
    assert!(isomorphic(&triangle([0, 1, 2]), &triangle([1, 2, 0])));
    assert!(!isomorphic(&triangle([0, 1, 2]), &triangle([0, 2, 1])));
    let code = |map: &Dcel| Canonizer::new().unrooted(map).unwrap().code;
    assert!(code(&triangle([0, 1, 2])) != code(&triangle([0, 2, 1])));
}

#[test]
fn the_unbounded_face_counts_only_where_it_is_marked() {
    // A triangle with a leaf outside or inside: the same map on the sphere.
    let triangle = |outside: bool| {
        let mut map = Dcel::new();
        let v = map.add_isolated_vertex(map.unbounded_face().key()).unwrap().vertex;
        let side = if outside { Side::Right } else { Side::Left };
        let a = map.connect(v, v, Split { new_face: side, inner: &[] }).unwrap().half_edge;
        let b = map.split_edge(a).unwrap().half_edge;
        map.split_edge(b).unwrap();
        map.split_vertex(a, a).unwrap();
        assert_eq!(map.half_edge(a).unwrap().face().is_unbounded(), outside);
        map
    };
    let (outside, inside) = (triangle(true), triangle(false));
    assert!(!isomorphic(&outside, &inside));
    let mut canonizer = Canonizer::new();
    assert_eq!(canonizer.unrooted(&outside), canonizer.unrooted(&inside));
    let unrooted = canonizer.unrooted(&outside).unwrap();
    assert_eq!((unrooted.automorphisms, unrooted.rootings), (1, 8));
}

#[test]
fn deep_nesting_takes_no_stack() {
    let depth = 20_000;
    let nested = |bottom: usize| {
        let mut map = Dcel::new();
        let mut face = map.unbounded_face().key();
        for _ in 0..depth {
            let v = map.add_isolated_vertex(face).unwrap().vertex;
            face = map.connect(v, v, Split { new_face: Side::Left, inner: &[] }).unwrap().new_face().unwrap();
        }
        for _ in 0..bottom {
            map.add_isolated_vertex(face).unwrap();
        }
        map
    };
    assert!(isomorphic(&nested(1), &nested(1)));
    assert!(!isomorphic(&nested(1), &nested(2)));
}

#[test]
fn what_is_no_subdivision_has_no_form() {
    let mut map = Dcel::new();
    let v = map.add_isolated_vertex(map.unbounded_face().key()).unwrap().vertex;
    map.connect(v, v, Split::default()).unwrap();
    map.add_isolated_vertex(map.unbounded_face().key()).unwrap();
    let good = Table::copy_of(&map).expect("a small map fits");
    let mut canonizer = Canonizer::new();
    assert!(canonizer.subdivision(&good).is_some());
    assert!(canonizer.subdivision(&Table::default()).is_none(), "no unbounded face");
    let live = |h: &usize| good.is_half_edge(*h);
    let h = (0..good.half_edges.len()).find(live).unwrap();
    for link in [None, Some(usize::MAX), Some(h)] {
        let mut bad = good.clone();
        bad.half_edges[h].as_mut().unwrap().twin = link;
        assert!(canonizer.subdivision(&bad).is_none() && canonizer.rooted(&bad, h).is_none(), "twin {link:?}");
    }
    for link in [None, Some(usize::MAX), good.twin(h)] {
        let mut bad = good.clone();
        bad.half_edges[h].as_mut().unwrap().next = link;
        assert!(canonizer.subdivision(&bad).is_none() && canonizer.unrooted(&bad).is_none(), "next {link:?}");
    }
    let f = map.unbounded_face().index();
    for inner in [vec![], vec![None, None], vec![good.inner(f, 0), good.inner(f, 0)], vec![Some(99), good.inner(f, 1)]]
    {
        let mut bad = good.clone();
        bad.faces[f].as_mut().unwrap().inner = inner;
        assert!(canonizer.subdivision(&bad).is_none());
    }
}
