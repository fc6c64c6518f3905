//! Neighbours, with their borders and lengths: compared with a slow computation in whole numbers, and on a real map.

use quickcheck::QuickCheck;
use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::{Face, FaceKey, StaleKey};
use twinedge_algorithm::colouring::feature_colours;
use twinedge_algorithm::neighbours::{Neighbour, of_face, of_feature, pairs, touching_feature};
use twinedge_geometry::Point;
use twinedge_map::{Builder, Feature, FeatureId, PlanarMap, Shape};

/// The board has 5 × 5 cells; each is claimed by a set of the features 0, 1, 2, 3, one bit each.
type Board = [[u8; 5]; 5];

type Corner = (i32, i32);

fn at((x, y): Corner) -> Point {
    Point::new(f64::from(x), f64::from(y))
}

fn built(board: &Board) -> (PlanarMap, Vec<FeatureId>) {
    let mut builder = Builder::new();
    let ids = (0..4)
        .map(|feature| {
            let mut shapes = Vec::new();
            for (x, column) in (0..).zip(board) {
                for (y, _) in (0..).zip(column).filter(|(_, set)| **set & 1 << feature != 0) {
                    shapes.push(Shape::polygon([(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)].map(at).to_vec()));
                }
            }
            builder.feature(&Feature { shapes, ..Feature::default() }).expect("in range")
        })
        .collect();
    (builder.build().expect("fits"), ids)
}

/// The features on the cell with this lower left corner.
fn on(board: &Board, (x, y): Corner) -> u8 {
    let cell = |i: i32| usize::try_from(i).ok().filter(|i| *i < 5);
    cell(x).zip(cell(y)).map_or(0, |(x, y)| board[x][y])
}

/// The directed unit edges of the board, each with the cells to its left and right.
fn edges(board: &Board) -> Vec<([Corner; 2], u8, u8)> {
    let mut edges = Vec::new();
    for x in 0..=5 {
        for y in 0..=5 {
            let (up, right) = ([(x, y), (x, y + 1)], [(x, y), (x + 1, y)]);
            let (here, west, south) = (on(board, (x, y)), on(board, (x - 1, y)), on(board, (x, y - 1)));
            edges.push((up, west, here));
            edges.push(([up[1], up[0]], here, west));
            edges.push((right, here, south));
            edges.push(([right[1], right[0]], south, here));
        }
    }
    edges
}

fn bits(p: Point) -> (u64, u64) {
    (p.x.to_bits(), p.y.to_bits())
}

/// Checks the laws of every answer: chains have the stated length, contain all edges once, and cannot be extended.
fn in_order<K>(neighbour: &Neighbour<K>) -> BTreeSet<[(u64, u64); 2]> {
    let steps: Vec<_> = neighbour.borders.iter().flat_map(|chain| chain.windows(2)).collect();
    let length: f64 = steps.iter().map(|s| (s[1].x - s[0].x).hypot(s[1].y - s[0].y)).sum();
    assert!(
        (length - neighbour.length).abs() <= 1e-12 * length && neighbour.borders.iter().all(|chain| chain.len() > 1)
    );
    let mut leaving: BTreeMap<_, usize> = BTreeMap::new();
    let mut arriving: BTreeMap<_, usize> = BTreeMap::new();
    for s in &steps {
        *leaving.entry(bits(s[0])).or_default() += 1;
        *arriving.entry(bits(s[1])).or_default() += 1;
    }
    let goes_on = |p: Point| (leaving.get(&bits(p)), arriving.get(&bits(p))) == (Some(&1), Some(&1));
    for chain in &neighbour.borders {
        let closed = chain.first() == chain.last();
        assert!(chain[1..chain.len() - 1].iter().all(|p| goes_on(*p)));
        assert!(closed || !(goes_on(chain[0]) || goes_on(chain[chain.len() - 1])));
    }
    let different: BTreeSet<_> = steps.iter().map(|s| [bits(s[0]), bits(s[1])]).collect();
    assert_eq!(different.len(), steps.len());
    different
}

fn features_have_the_neighbours_that_one_sees(cells: Vec<u8>) -> bool {
    let mut board = Board::default();
    for (cell, set) in board.iter_mut().flatten().zip(cells) {
        // Mostly one feature, sometimes none or two.
        *cell = [1, 2, 4, 8, 1, 2, 4, 8, 0, 3, 6, 12][usize::from(set % 12)];
    }
    let (map, ids) = built(&board);
    let mut right = true;
    for (a, id) in ids.iter().enumerate() {
        let mut expected: BTreeMap<usize, BTreeSet<[(u64, u64); 2]>> = BTreeMap::new();
        let has = |set: u8, feature: usize| set & 1 << feature != 0;
        for ([p, q], left, other) in edges(&board) {
            for b in (0..4).filter(|b| *b != a && has(left, a) && !has(other, a) && has(other, *b)) {
                expected.entry(b).or_default().insert([bits(at(p)), bits(at(q))]);
            }
        }
        let found = of_feature(&map, *id);
        let borders: BTreeMap<usize, _> = found.iter().map(|n| (n.neighbour.index(), in_order(n))).collect();
        right &= borders == expected && found.is_sorted_by_key(|n| n.neighbour);

        let mut touching = BTreeSet::new();
        for (x, y) in (0..=5).flat_map(|x| (0..=5).map(move |y| (x, y))) {
            let around = [(x, y), (x - 1, y), (x, y - 1), (x - 1, y - 1)].map(|c| on(&board, c));
            if around.iter().any(|set| has(*set, a)) {
                touching.extend((0..4).filter(|b| around.iter().any(|set| has(*set, *b))));
            }
        }
        let overlapping = |b: usize| board.iter().flatten().any(|set| has(*set, a) && has(*set, b));
        touching.retain(|b| *b != a && !expected.contains_key(b) && !overlapping(*b));
        right &= touching_feature(&map, *id).into_iter().map(FeatureId::index).eq(touching);
    }
    // No two faces with an edge between them have the same colour.
    let colours = feature_colours(&map);
    let told_apart = |left: u8, other: u8| {
        let seen = |set: u8| (0..4).filter(move |f| set & 1 << f != 0);
        seen(left).all(|a| seen(other).all(|b| a == b || colours[a] != colours[b]))
    };
    right && edges(&board).iter().all(|(_, left, other)| told_apart(*left, *other)) && colours.iter().all(|c| *c < 4)
}

#[test]
fn features_agree_with_the_slow_answer() {
    QuickCheck::new().tests(500).quickcheck(features_have_the_neighbours_that_one_sees as fn(Vec<u8>) -> bool);
}

#[test]
fn faces_have_the_neighbours_that_one_sees() {
    // Four quarters of a square, one of them empty, and a square in the first one.
    let square =
        |[x, y]: [f64; 2], side: f64| Shape::polygon([[x, y], [x + side, y], [x + side, y + side], [x, y + side]]);
    let mut builder = Builder::new();
    for shape in [square([0.0, 0.0], 4.0), square([4.0, 0.0], 4.0), square([0.0, 4.0], 4.0), square([1.0, 1.0], 2.0)] {
        builder.shape(&shape).expect("in range");
    }
    // An edge with the same face on both sides.
    builder.segment([0.0, 0.0], [1.0, 1.0]).expect("in range");
    let map = builder.build().expect("fits");
    assert!(map.is_plane());
    let named = |id: usize| {
        let covers = |f: &Face<'_>| map.features_of(f.key()).expect("live").any(|g| g.index() == id);
        map.dcel().faces().filter(covers).map(Face::key).last().expect("it covers one")
    };
    // The inner square is the last face that the first feature covers.
    let [inner, east, north] = [0, 1, 2].map(named);
    let outside = map.dcel().unbounded_face().key();
    let around = map.dcel().half_edges().find(|h| h.face().key() == inner).expect("it has four").twin().face().key();

    let lengths = |face| {
        let found = of_face(&map, face).expect("live");
        found.iter().map(|n| (n.neighbour, n.length, n.borders.len())).collect::<Vec<_>>()
    };
    let sorted = |all: &[(FaceKey, f64, usize)]| {
        let mut all = all.to_vec();
        all.sort_by_key(|(f, ..)| map.dcel().face(*f).expect("live").index());
        all
    };
    assert_eq!(lengths(inner), [(around, 8.0, 1)]);
    assert_eq!(lengths(around), sorted(&[(outside, 8.0, 1), (east, 4.0, 1), (north, 4.0, 1), (inner, 8.0, 1)]));
    assert_eq!(lengths(east), sorted(&[(outside, 12.0, 1), (around, 4.0, 1)]));
    assert_eq!(lengths(outside), sorted(&[(around, 8.0, 1), (east, 12.0, 1), (north, 12.0, 1)]));

    let stale = Builder::new().build().expect("fits").dcel().unbounded_face().key();
    assert_eq!(of_face(&map, stale), Err(StaleKey::Face(stale)));
}

fn world() -> PlanarMap {
    crate::planar::world_maps().next().expect("the first is coarse")
}

#[test]
fn countries_have_the_neighbours_that_they_have() {
    let map = world();
    let named = |name: &str| map.features().find(|f| map.name(*f) == Some(name)).expect("it is on the map");
    let neighbours = |name: &str| {
        let mut names: Vec<&str> = of_feature(&map, named(name)).iter().filter_map(|n| map.name(n.neighbour)).collect();
        names.sort_unstable();
        names
    };
    assert_eq!(neighbours("Switzerland"), ["Austria", "France", "Germany", "Italy"]);
    assert_eq!(neighbours("Lesotho"), ["South Africa"]);
    // The border of an enclave is one closed chain.
    let enclave = of_feature(&map, named("Lesotho"));
    assert_eq!(enclave[0].borders.len(), 1);
    assert_eq!(enclave[0].borders[0].first(), enclave[0].borders[0].last());

    // Neighbours are mutual, along the same edges, seen from both sides. Sudan overlaps two of its neighbours.
    let overlapping: Vec<[FeatureId; 2]> = pairs(&map).iter().filter(|p| p.overlap > 0.0).map(|p| p.features).collect();
    assert!(overlapping.iter().flatten().any(|feature| *feature == named("Sudan")) && overlapping.len() < 8);
    for a in map.features() {
        for border in of_feature(&map, a) {
            let back = of_feature(&map, border.neighbour).into_iter().find(|n| n.neighbour == a).expect("it is mutual");
            assert!((border.shared - back.shared).abs() < 1e-9);
            if overlapping.contains(&[a.min(border.neighbour), a.max(border.neighbour)]) {
                continue;
            }
            assert!((border.shared - border.length).abs() < 1e-9);
            let turned: BTreeSet<_> = in_order(&back).into_iter().map(|[p, q]| [q, p]).collect();
            assert_eq!(in_order(&border), turned);
        }
    }
    // Countries have few neighbours; one colour more than for a plane map with one face each is allowed.
    let colours = feature_colours(&map);
    assert!(colours.iter().all(|colour| *colour <= 6));
}
