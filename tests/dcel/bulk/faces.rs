//! Building from faces: accepted structures have these faces, and refusals have the reason found by a plain count.

use crate::support::programs::check;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};
use twinedge::dcel::{Dcel, FacesError};

type Lists = Vec<Vec<u32>>;

fn refused(vertices: usize, faces: &[&[u32]]) -> FacesError {
    Dcel::from_faces(vertices, faces).unwrap_err()
}

#[test]
fn a_face_that_is_wrong_by_itself_is_named() {
    assert_eq!(refused(3, &[&[0, 1, 2], &[0, 3, 1]]), FacesError::NoSuchVertex { face: 1, vertex: 3, vertices: 3 });
    assert_eq!(refused(3, &[&[0, 1, 2], &[]]), FacesError::TooShort { face: 1 });
    assert_eq!(refused(3, &[&[0, 1]]), FacesError::TooShort { face: 0 });
    assert_eq!(refused(3, &[&[0, 1, 1, 2]]), FacesError::Loop { face: 0, vertex: 1 });
    assert_eq!(refused(3, &[&[2, 0, 1, 2]]), FacesError::Loop { face: 0, vertex: 2 });
    let error = Dcel::from_faces(usize::MAX, [[0, 1, 2]]).unwrap_err();
    assert_eq!(error, FacesError::Full(twinedge::dcel::RecordKind::Vertex));
    assert_eq!(error.to_string(), "there are more vertices than fit");
}

#[test]
fn faces_that_do_not_fit_together_are_named() {
    let same = |faces, vertices| FacesError::SameSide { faces, vertices };
    assert_eq!(refused(4, &[&[0, 1, 2], &[3, 1, 2]]), same([0, 1], [1, 2]));
    assert_eq!(refused(5, &[&[0, 1, 2], &[3, 2, 1], &[1, 2, 4]]), same([0, 2], [1, 2]));
    assert_eq!(refused(5, &[&[0, 1, 2, 0, 1, 3]]), same([0, 0], [0, 1]));
    // Two triangles sharing only a vertex; two tetrahedra sharing a vertex, without a border.
    assert_eq!(refused(5, &[&[0, 1, 2], &[0, 3, 4]]), FacesError::SeveralFans { vertex: 0 });
    let tetrahedron = |[a, b, c, d]: [u32; 4]| [[a, b, c], [a, c, d], [a, d, b], [b, d, c]];
    let two = [tetrahedron([0, 1, 2, 3]), tetrahedron([4, 5, 3, 6])].concat();
    assert_eq!(Dcel::from_faces(7, &two).unwrap_err(), FacesError::SeveralFans { vertex: 3 });
    assert_eq!(Dcel::from_faces(5, tetrahedron([1, 2, 3, 4])).unwrap_err(), FacesError::Closed { vertex: 1 });
    let open = Dcel::from_faces(5, &tetrahedron([1, 2, 3, 4])[1..]).unwrap().0;
    assert_eq!((open.edge_count(), open.unbounded_face().inner_count()), (6, 2));
}

/// A square ring of four quadrilaterals, and a torus of 3 × 3 of them.
#[test]
fn holes_and_handles_are_not_plane() {
    let ring: Lists = (0..4).map(|i| vec![i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4]).collect();
    assert_eq!(Dcel::from_faces(8, &ring).unwrap_err(), FacesError::SeveralBorders { vertex: 0 });
    let at = |x: u32, y: u32| x % 3 + y % 3 * 3 + 1;
    let torus: Lists = (0..9)
        .map(|i| (i % 3, i / 3))
        .map(|(x, y)| vec![at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)])
        .collect();
    assert_eq!(Dcel::from_faces(10, &torus).unwrap_err(), FacesError::Closed { vertex: 1 });
    assert_eq!(Dcel::from_faces(10, &torus[1..]).unwrap_err(), FacesError::Genus { vertex: 1, genus: 1 });
}

/// Finds, by sets and counts, the reason why these faces form no map; the smallest offender first.
fn reason(vertices: usize, faces: &Lists) -> Option<&'static str> {
    let mut sides = BTreeMap::new();
    for (f, face) in faces.iter().enumerate() {
        for (i, v) in face.iter().enumerate() {
            if sides.insert((*v, face[(i + 1) % face.len()]), f).is_some() {
                return Some("SameSide");
            }
        }
    }
    let has = |side: &(u32, u32)| sides.contains_key(side);
    for v in 0..vertices as u32 {
        // Each corner at v, from the previous to the next vertex: chains of corners are fans.
        let mut corners = BTreeMap::new();
        for face in faces {
            for (i, _) in face.iter().enumerate().filter(|(_, at)| **at == v) {
                corners.insert(face[(i + face.len() - 1) % face.len()], face[(i + 1) % face.len()]);
            }
        }
        let mut fans = 0;
        while let Some(first) =
            corners.keys().copied().find(|from| !has(&(v, *from))).or(corners.keys().next().copied())
        {
            fans += 1;
            let mut at = first;
            while let Some(next) = corners.remove(&at) {
                at = next;
            }
        }
        if fans > 1 {
            return Some("SeveralFans");
        }
    }
    let mut piece: Vec<usize> = (0..vertices).collect();
    for (a, b) in sides.keys() {
        let (a, b) = (piece[*a as usize], piece[*b as usize]);
        piece.iter_mut().filter(|p| **p == a || **p == b).for_each(|p| *p = a.min(b));
    }
    for first in (0..vertices).filter(|v| piece[*v] == *v) {
        let of = |v: u32| piece[v as usize] == first;
        let edges: BTreeSet<_> = sides.keys().filter(|(a, _)| of(*a)).map(|(a, b)| (a.min(b), a.max(b))).collect();
        if edges.is_empty() {
            continue;
        }
        let mut border: BTreeMap<u32, u32> =
            sides.keys().filter(|(a, b)| of(*a) && !has(&(*b, *a))).map(|(a, b)| (*b, *a)).collect();
        let mut loops = 0;
        while let Some(mut at) = border.keys().next().copied() {
            loops += 1;
            while let Some(next) = border.remove(&at) {
                at = next;
            }
        }
        let inside = faces.iter().filter(|face| of(face[0])).count();
        let count = piece.iter().filter(|p| **p == first).count();
        match loops {
            0 => return Some("Closed"),
            1 if count + inside + 1 == edges.len() + 2 => {}
            1 => return Some("Genus"),
            _ => return Some("SeveralBorders"),
        }
    }
    None
}

/// The number of occurrences of each reason.
static OUTCOMES: [AtomicUsize; 6] = [const { AtomicUsize::new(0) }; 6];
const REASONS: [&str; 5] = ["SameSide", "SeveralFans", "Closed", "SeveralBorders", "Genus"];

/// Some faces of a grid on a torus, possibly cut open, and of a separate tetrahedron; one may be turned.
fn some_faces(keep: &[bool], open: (bool, bool), turned: u8) -> (usize, Lists) {
    let width = 3 + u32::from(open.0);
    let height = 3 + u32::from(open.1);
    let at = |x: u32, y: u32| x % width + y % height * width;
    let n = width * height;
    let tetrahedron = [[n, n + 1, n + 2], [n, n + 2, n + 3], [n, n + 3, n + 1], [n + 1, n + 3, n + 2]];
    let grid = (0..9).flat_map(|i| {
        let (x, y) = (i % 3, i / 3);
        let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
        if i % 2 == 0 { vec![vec![a, b, c, d]] } else { vec![vec![a, b, c], vec![a, c, d]] }
    });
    let all = tetrahedron.map(|face| face.to_vec()).into_iter().chain(grid);
    let keep = keep.iter().copied().chain(std::iter::repeat(true));
    let mut faces: Lists = all.zip(keep).filter(|(_, keep)| *keep).map(|(face, _)| face).collect();
    if let Some(face) = faces.get_mut(usize::from(turned) * 4) {
        face.reverse();
    }
    (n as usize + 5, faces)
}

#[test]
fn what_comes_in_has_these_faces_and_what_is_refused_breaks_a_rule() {
    fn law(keep: Vec<bool>, few: bool, open: (bool, bool), turned: u8) {
        // All faces, or about half of them.
        let keep: Vec<bool> = keep.iter().enumerate().map(|(i, keep)| *keep || !few && i % 8 != 0).collect();
        let (vertices, faces) = some_faces(&keep, open, turned);
        let expected = reason(vertices, &faces);
        let (map, keys) = match Dcel::from_faces(vertices, &faces) {
            Ok(made) => made,
            Err(error) => {
                let text = format!("{error:?}");
                assert_eq!(Some(text.split(' ').next().unwrap()), expected, "{faces:?}");
                let place = REASONS.iter().position(|reason| Some(*reason) == expected).unwrap();
                OUTCOMES[place].fetch_add(1, Ordering::Relaxed);
                return;
            }
        };
        assert_eq!(expected, None, "{faces:?}");
        OUTCOMES[5].fetch_add(1, Ordering::Relaxed);
        assert!(map.validate().is_valid(), "{:?}", map.validate());
        assert_eq!((map.vertex_count(), map.face_count()), (vertices, faces.len() + 1));
        let mut corner = 0;
        for (f, list) in faces.iter().enumerate() {
            let face = map.face(keys.face(f).unwrap()).unwrap();
            assert_eq!(face.inner_count(), 0);
            let cycle: Vec<_> = face.outer().unwrap().half_edges().map(|h| (h.key(), h.origin().key())).collect();
            let expected: Vec<_> = (corner..)
                .zip(list)
                .map(|(c, v)| (keys.half_edge(c).unwrap(), keys.vertex(*v as usize).unwrap()))
                .collect();
            assert_eq!(cycle, expected);
            corner += list.len();
        }
        // The first corner of an edge has the smaller index.
        for c in 0..corner {
            let h = map.half_edge(keys.half_edge(c).unwrap()).unwrap();
            let other = (0..corner).find(|other| keys.half_edge(*other) == Some(h.twin().key()));
            assert_eq!(h.index() < h.twin().index(), other.is_none_or(|other| c < other));
        }
        assert_eq!(keys.half_edge(corner), None);
    }
    check(20_000, 14, law as fn(Vec<bool>, bool, (bool, bool), u8));
    let outcomes: Vec<_> = OUTCOMES.iter().map(|count| count.load(Ordering::Relaxed)).collect();
    assert!(outcomes.iter().all(|count| *count > 20), "{outcomes:?} of {REASONS:?} and none");
}

#[test]
fn dangling_edges_bridges_and_islands_come_in() {
    let (map, _) = Dcel::from_faces(6, [vec![0, 1, 2, 0, 3, 4, 3]]).unwrap();
    assert!(map.validate().is_valid());
    assert_eq!((map.edge_count(), map.unbounded_face().inner_count()), (5, 2));
    let (map, keys) = Dcel::from_faces(0, Lists::new()).unwrap();
    assert!(map.validate().is_valid());
    assert_eq!((map.vertex_count(), keys.vertex(0)), (0, None));
}
