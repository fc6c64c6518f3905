//! Building from rotations: every map can be rebuilt, and every refusal has its cause.

use crate::support::programs::{built, check};
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use twinedge::dcel::{Corner, Dcel, Placement, RotationsError};
use twinedge::program::Program;
use twinedge_trials::canonical::isomorphic;

/// The rotations of a map, each from any of its half-edges, and the placements of its components.
fn system(map: &Dcel, turn: usize) -> (Vec<Vec<u32>>, Vec<Placement>) {
    let edges = map.edges().flat_map(|h| [h.index(), h.twin().index()]);
    let dart: BTreeMap<usize, u32> = edges.zip(0..).collect();
    let vertices: BTreeMap<usize, u32> = map.vertices().map(|v| v.index()).zip(0..).collect();
    let rotations = map
        .vertices()
        .map(|v| {
            let mut rotation: Vec<u32> = v.rotation().map(|h| dart[&h.index()]).collect();
            let turn = turn.checked_rem(rotation.len()).unwrap_or(0);
            rotation.rotate_left(turn);
            rotation
        })
        .collect();
    let placements = map
        .faces()
        .flat_map(|f| f.inner())
        .map(|b| Placement {
            outside: match b.start() {
                Some(h) => Corner::At(dart[&h.index()]),
                None => Corner::Isolated(vertices[&b.isolated_vertex().unwrap().index()]),
            },
            within: b.face().outer_half_edge().map(|h| dart[&h.index()]),
        })
        .collect();
    (rotations, placements)
}

#[test]
fn a_map_comes_back_from_its_rotations() {
    fn law(program: Program, turn: usize) {
        let map: Dcel = built(&program);
        let (rotations, placements) = system(&map, turn);
        let (made, keys) = Dcel::from_rotations(&rotations, &placements).unwrap();
        assert!(made.validate().is_valid());
        assert!(isomorphic(&made, &map));
        for (v, rotation) in rotations.iter().enumerate() {
            let v = made.vertex(keys.vertex(v).unwrap()).unwrap();
            let around: Vec<_> = v.rotation().map(|h| h.index() - 2).collect();
            assert_eq!(around, rotation.iter().map(|dart| *dart as usize).collect::<Vec<_>>());
            assert!(v.rotation().all(|h| keys.half_edge(h.index() - 2) == Some(h.key())));
        }
        assert_eq!(keys.face(0), None);
        // Without placements every component lies in the unbounded face, with the outside at its smallest dart.
        let (apart, keys) = Dcel::from_rotations(&rotations, &[]).unwrap();
        assert!(apart.validate().is_valid());
        assert_eq!(apart.unbounded_face().inner_count(), placements.len());
        if apart.edge_count() > 0 {
            assert!(apart.half_edge(keys.half_edge(0).unwrap()).unwrap().face().is_unbounded());
        }
    }
    check(500, 150, law as fn(Program, usize));
}

/// A placement may name a face by a dart on the outside of another component in it.
#[test]
fn components_lie_beside_those_that_are_named() {
    let triangle = |first: u32| (0..3).map(move |i| vec![first + 2 * i, first + (2 * i + 5) % 6]);
    let rotations: Vec<Vec<u32>> = (0..4).flat_map(|i| triangle(6 * i)).chain([vec![]]).collect();
    let at = |outside, within| Placement { outside: Corner::At(outside), within };
    // The second and the third component lie side by side in the first; the fourth and the vertex lie in the second.
    let island = Placement { outside: Corner::Isolated(12), within: Some(6) };
    let placements = [at(7, Some(13)), at(13, Some(0)), at(1, None), island, at(18, Some(8))];
    let (map, keys) = Dcel::from_rotations(&rotations, &placements).unwrap();
    assert!(map.validate().is_valid());
    let face = |dart| map.half_edge(keys.half_edge(dart).unwrap()).unwrap().face();
    assert!(face(1).is_unbounded() && !face(0).is_unbounded());
    assert_eq!([face(7), face(13)], [face(0); 2]);
    assert_eq!((face(0).inner_count(), face(6).inner_count(), map.unbounded_face().inner_count()), (2, 2, 1));
    assert_eq!(face(18), face(6));
}

fn refused(rotations: &[&[u32]], placements: &[Placement]) -> RotationsError {
    Dcel::from_rotations(rotations, placements).unwrap_err()
}

#[test]
fn darts_that_are_wrong_are_named() {
    assert_eq!(refused(&[&[0], &[2]], &[]), RotationsError::NoSuchDart { vertex: 1, dart: 2, darts: 2 });
    assert_eq!(refused(&[&[0], &[0]], &[]), RotationsError::RepeatedDart { dart: 0, vertices: [0, 1] });
    assert_eq!(refused(&[&[], &[1, 1]], &[]), RotationsError::RepeatedDart { dart: 1, vertices: [1, 1] });
    assert_eq!(refused(&[&[0, 2], &[1]], &[]), RotationsError::Unpaired { dart: 2 });
    assert_eq!(refused(&[&[0]], &[]), RotationsError::Unpaired { dart: 0 });
}

#[test]
fn placements_that_are_wrong_are_named() {
    let (edge, inside_of) = ([&[0][..], &[1], &[2], &[3], &[]], |within| Some(within));
    let at = |dart, within| Placement { outside: Corner::At(dart), within };
    let no_such = |corner| RotationsError::NoSuchCorner { placement: 0, corner };
    assert_eq!(refused(&edge, &[at(4, None)]), no_such(Corner::At(4)));
    assert_eq!(refused(&edge, &[at(0, inside_of(4))]), no_such(Corner::At(4)));
    for vertex in [0, 5] {
        let placement = Placement { outside: Corner::Isolated(vertex), within: None };
        assert_eq!(refused(&edge, &[placement]), no_such(Corner::Isolated(vertex)));
    }
    let twice = RotationsError::PlacedTwice { placements: [0, 2] };
    assert_eq!(refused(&edge, &[at(0, None), at(2, None), at(1, None)]), twice);
    let itself = |placement| RotationsError::InsideItself { placement };
    assert_eq!(refused(&edge, &[at(2, None), at(0, inside_of(1))]), itself(1));
    assert!(matches!(
        refused(&edge, &[at(2, inside_of(0)), at(0, inside_of(2))]),
        RotationsError::InsideItself { placement: 0 | 1 }
    ));
    // A component inside two components that contain each other does not lie inside itself.
    let island = Placement { outside: Corner::Isolated(4), within: Some(0) };
    let error = refused(&edge, &[island, at(2, inside_of(0)), at(0, inside_of(2))]);
    assert!(matches!(error, RotationsError::InsideItself { placement: 1 | 2 }), "{error}");
}

/// The numbers of planar and non-planar systems.
static PLANE: [AtomicUsize; 2] = [const { AtomicUsize::new(0) }; 2];

/// The darts in any order, cut into rotations anywhere.
#[test]
fn a_system_comes_in_if_it_is_plane() {
    fn law(order: Vec<u8>, cuts: Vec<bool>) {
        let mut darts: Vec<(u8, u32)> = order.into_iter().zip(0..).take(10).collect();
        if darts.len() % 2 == 1 {
            darts.pop();
        }
        darts.sort_unstable();
        let mut rotations = vec![vec![]];
        for ((_, dart), cut) in darts.iter().zip(cuts.into_iter().chain(std::iter::repeat(true))) {
            rotations.last_mut().unwrap().push(*dart);
            if cut {
                rotations.push(vec![]);
            }
        }
        // The genus of all, by counting.
        let vertices = rotations.iter().filter(|rotation| !rotation.is_empty()).count();
        let clockwise = |dart: u32| {
            let rotation = rotations.iter().find(|rotation| rotation.contains(&dart)).unwrap();
            let at = rotation.iter().position(|d| *d == dart).unwrap();
            rotation[(at + rotation.len() - 1) % rotation.len()]
        };
        let of = |dart: u32| rotations.iter().position(|rotation| rotation.contains(&dart)).unwrap();
        let (mut left, mut cycles) = (vec![true; darts.len()], 0);
        while let Some(start) = left.iter().position(|left| *left) {
            cycles += 1;
            let mut dart = start as u32;
            while std::mem::replace(&mut left[dart as usize], false) {
                dart = clockwise(dart ^ 1);
            }
        }
        let mut piece: Vec<usize> = (0..rotations.len()).collect();
        for dart in (0..darts.len() as u32).step_by(2) {
            let (a, b) = (piece[of(dart)], piece[of(dart + 1)]);
            piece.iter_mut().filter(|p| **p == a || **p == b).for_each(|p| *p = a.min(b));
        }
        let pieces = (0..rotations.len()).filter(|v| piece[*v] == *v && !rotations[*v].is_empty()).count();
        let plane = vertices + cycles == darts.len() / 2 + 2 * pieces;
        PLANE[usize::from(!plane)].fetch_add(1, Ordering::Relaxed);
        match Dcel::from_rotations(&rotations, &[]) {
            Ok((map, _)) => {
                assert!(plane, "{rotations:?}");
                assert!(map.validate().is_valid());
                assert_eq!(map.unbounded_face().inner_count(), pieces + rotations.len() - vertices);
            }
            Err(RotationsError::Genus { vertex, genus }) => {
                assert!(!plane && genus > 0 && piece[vertex as usize] == vertex as usize, "{rotations:?}");
            }
            Err(error) => panic!("{error}"),
        }
    }
    check(3000, 12, law as fn(Vec<u8>, Vec<bool>));
    assert!(PLANE.iter().all(|count| count.load(Ordering::Relaxed) > 50), "{PLANE:?}");
}
