//! Rules between layers: small layers by hand, and random ones compared with a raster of unit squares.

use quickcheck::{Arbitrary, Gen, QuickCheck};
use std::collections::{BTreeMap, BTreeSet};
use twinedge_algorithm::area::face_area;
use twinedge_coverage::layers::{Deviation, LayerFinding, LayerRule, Parent, check, check_parents, pieces};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::{Builder, Feature, FeatureId, Noding, PlanarMap, Shape};

type Corner = [f64; 2];

fn built(shapes: &[Shape]) -> PlanarMap {
    let mut builder = Builder::new();
    for shape in shapes {
        builder.shape(shape).expect("in range");
    }
    builder.build_with(Noding::Snap(Snap::Auto)).expect("in reach")
}

fn polygon(corners: &[Corner]) -> Shape {
    Shape::polygon(corners.iter().copied())
}

fn rectangle(x: [f64; 2], y: [f64; 2]) -> Shape {
    polygon(&[[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]])
}

fn indices(features: &[FeatureId]) -> Vec<usize> {
    features.iter().map(|one| one.index()).collect()
}

/// Deviation, features, others, area, length.
type Brief = (Deviation, Vec<usize>, Vec<usize>, f64, f64);

fn brief(found: &[LayerFinding]) -> Vec<Brief> {
    let of = |one: &LayerFinding| (one.deviation, indices(&one.features), indices(&one.others), one.area, one.length);
    found.iter().map(of).collect()
}

fn parents(map: &PlanarMap, of: &[usize]) -> Vec<Parent> {
    of.iter().map(|one| map.feature(*one).map_or(Parent::Unknown, Parent::Feature)).collect()
}

/// Four parts, in pairs by their parents, followed by the parents: `0 1 | 2 3` in `4 | 5`, all of height 2.
fn counties() -> Vec<Shape> {
    let of = |x: [f64; 2]| rectangle(x, [0.0, 2.0]);
    vec![of([0.0, 1.0]), of([1.0, 2.0]), of([2.0, 3.0]), of([3.0, 4.0]), of([0.0, 2.0]), of([2.0, 4.0])]
}

fn found(shapes: &[Shape]) -> [Vec<LayerFinding>; 2] {
    let map = built(shapes);
    let complete: Vec<FeatureId> = map.features().skip(4).collect();
    let of_parents = check_parents(&map, &parents(&map, &[4, 4, 5, 5]), &complete).expect("plane");
    [check(&map, 4, &[]).expect("plane"), of_parents]
}

#[test]
fn parts_that_make_up_their_parents_are_accepted() {
    assert_eq!(found(&counties()), [vec![], vec![]]);
}

/// Areas that no part covers, on the left and on the right: the larger one comes first.
#[test]
fn findings_of_a_rule_come_by_size() {
    for (end, areas) in [(0.25, [1.5, 1.0]), (0.75, [1.0, 0.5])] {
        let mut shapes = counties();
        shapes[0] = rectangle([0.0, end], [0.0, 2.0]);
        shapes[3] = rectangle([3.0, 3.5], [0.0, 2.0]);
        let [of_layers, _] = found(&shapes);
        let uncovered = of_layers.iter().filter(|one| one.deviation == Deviation::OnlyThere);
        assert_eq!(uncovered.map(|one| one.area).collect::<Vec<_>>(), areas);
    }
}

/// The vertex (2, 0) of the parts 1 and 2 is moved to (2.5, 0): a triangle of area 0.5 changes sides, and the border of the
/// parents runs along no border of the parts.
#[test]
fn a_moved_vertex_is_found_by_the_rules_about_borders_and_insides() {
    let mut shapes = counties();
    shapes[1] = polygon(&[[1.0, 0.0], [2.5, 0.0], [2.0, 2.0], [1.0, 2.0]]);
    shapes[2] = polygon(&[[2.5, 0.0], [3.0, 0.0], [3.0, 2.0], [2.0, 2.0]]);
    let [of_layers, of_parents] = found(&shapes);
    let around = 0.5 + 2.0 + 4.25_f64.sqrt();
    assert_eq!(
        brief(&of_layers),
        [
            (Deviation::NotWithin, vec![1], vec![4, 5], 0.5, around),
            (Deviation::NoBorder, vec![1], vec![4, 5], 0.0, 2.0)
        ]
    );
    assert_eq!(
        (of_layers[1].at, &of_layers[1].stretches[..]),
        (Point::new(2.0, 1.0), &[[Point::new(2.0, 0.0), Point::new(2.0, 2.0)]][..])
    );
    assert!(of_layers[0].at.x > 2.0 && of_layers[0].at.x < 2.5, "{:?}", of_layers[0].at);
    assert_eq!(
        brief(&of_parents),
        [
            (Deviation::OutsideParent, vec![1], vec![4], 0.5, around),
            (Deviation::ParentNotCovered, vec![], vec![5], 0.5, around)
        ]
    );
}

/// Parts may divide the inside of a parent arbitrarily.
#[test]
fn a_vertex_that_is_moved_inside_a_parent_breaks_nothing() {
    let mut shapes = counties();
    shapes[0] = polygon(&[[0.0, 0.0], [1.5, 0.0], [1.0, 2.0], [0.0, 2.0]]);
    shapes[1] = polygon(&[[1.5, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 2.0]]);
    assert_eq!(found(&shapes), [vec![], vec![]]);
}

#[test]
fn a_part_of_the_wrong_parent_is_found_by_the_rule_about_parents_alone() {
    let map = built(&counties());
    assert_eq!(check(&map, 4, &[]), Ok(vec![]));
    let of = |parents_of: &[usize]| brief(&check_parents(&map, &parents(&map, parents_of), &[]).expect("plane"));
    assert_eq!(
        of(&[4, 5, 5, 5]),
        [
            (Deviation::OutsideParent, vec![1], vec![5], 2.0, 6.0),
            (Deviation::ParentNotCovered, vec![], vec![4], 2.0, 6.0)
        ]
    );
    // A part with an unknown parent also leaves its area open.
    assert_eq!(
        of(&[4, 99, 5, 5]),
        [
            (Deviation::ParentNotCovered, vec![], vec![4], 2.0, 6.0),
            (Deviation::UnknownParent, vec![1], vec![], 2.0, 6.0)
        ]
    );
    // A parent is checked only if it has parts or is declared complete.
    assert_eq!(of(&[4, 4]), []);
    let complete = [map.feature(5).expect("there are six")];
    let all = check_parents(&map, &parents(&map, &[4, 4]), &complete).expect("plane");
    assert_eq!(brief(&all), [(Deviation::ParentNotCovered, vec![], vec![5], 4.0, 8.0)]);
}

/// A gap along a border between parts of one parent, and a missing part.
#[test]
fn gaps_and_parts_that_were_dropped_are_found_with_their_places() {
    let mut shapes = counties();
    shapes[0] = rectangle([0.0, 0.75], [0.0, 2.0]);
    let [of_layers, of_parents] = found(&shapes);
    // The gap lies on the outer border of the parent, above and below.
    let cover = (Deviation::OnlyThere, vec![], vec![4], 0.5, 4.5);
    let border = (Deviation::NoBorder, vec![], vec![4], 0.0, 0.25);
    assert_eq!(brief(&of_layers), [cover, border.clone(), border]);
    assert_eq!(brief(&of_parents), [(Deviation::ParentNotCovered, vec![], vec![4], 0.5, 4.5)]);

    shapes = counties();
    // The feature covers nothing, but still exists.
    shapes[3] = Shape::Polygon(vec![]);
    let [of_layers, of_parents] = found(&shapes);
    assert_eq!(
        brief(&of_layers),
        [(Deviation::OnlyThere, vec![], vec![5], 2.0, 6.0), (Deviation::NoBorder, vec![], vec![5], 0.0, 4.0)]
    );
    assert_eq!(of_layers[0].at, Point::new(3.5, 1.0));
    assert_eq!(brief(&of_parents), [(Deviation::ParentNotCovered, vec![], vec![5], 2.0, 6.0)]);

    shapes = counties();
    shapes[3] = rectangle([3.0, 4.5], [0.0, 2.0]);
    let [of_layers, of_parents] = found(&shapes);
    let beyond = |deviation, others| (deviation, vec![3], others, 1.0, 5.0);
    assert_eq!(
        brief(&of_layers),
        [
            beyond(Deviation::NotWithin, vec![5]),
            beyond(Deviation::OnlyHere, vec![]),
            (Deviation::NoBorder, vec![3], vec![5], 0.0, 2.0)
        ]
    );
    assert_eq!(brief(&of_parents), [beyond(Deviation::OutsideParent, vec![5])]);
}

/// ```text
///   2 +-------+-------+    the other layer: P, Q; line 0 runs along their border and on into nothing,
///   1 | P   - | -   Q |    line 1 crosses it, line 2 runs along it
///   0 +-------+-------+
///     0       2       4
/// ```
#[test]
fn lines_run_along_borders() {
    let shapes = [
        Shape::line([[2.0, 2.0], [2.0, 3.0]]),
        Shape::line([[1.0, 1.0], [3.0, 1.0]]),
        Shape::line([[2.0, 2.0], [2.0, 0.0]]),
        rectangle([0.0, 2.0], [0.0, 2.0]),
        rectangle([2.0, 4.0], [0.0, 2.0]),
    ];
    let map = built(&shapes);
    let found = check(&map, 3, &[]).expect("plane");
    assert_eq!(
        brief(&found),
        [
            // No line runs along the perimeter.
            (Deviation::NoBorder, vec![], vec![3], 0.0, 6.0),
            (Deviation::NoBorder, vec![], vec![4], 0.0, 6.0),
            (Deviation::OffBorder, vec![1], vec![3, 4], 0.0, 2.0),
            (Deviation::OffBorder, vec![0], vec![], 0.0, 1.0)
        ]
    );
}

#[test]
fn points_lie_inside_one_feature() {
    let mut builder = Builder::new();
    let point = builder.feature(&Feature::default()).expect("in range");
    let other = builder.shape(&rectangle([0.0, 2.0], [0.0, 2.0])).expect("in range");
    builder.shape(&rectangle([2.0, 4.0], [0.0, 2.0])).expect("in range");
    let map = builder.build_with(Noding::Exact).expect("plane");
    let at = |x: f64, y: f64| check(&map, 1, &[(point, Point::new(x, y))]).expect("plane");
    assert_eq!(at(1.0, 1.0), []);
    for (x, y, others) in [(5.0, 1.0, 0), (2.0, 1.0, 2), (0.0, 1.0, 1), (2.0, 2.0, 2), (0.0, 0.0, 1)] {
        let found = at(x, y);
        let [one] = &found[..] else { panic!("{x} {y}: {found:?}") };
        assert_eq!((one.deviation, one.rule(), one.at), (Deviation::NotInside, LayerRule::Point, Point::new(x, y)));
        assert_eq!((&one.features[..], one.others.len(), one.area), (&[point][..], others, 0.0));
    }
    assert_eq!(at(0.0, 0.0)[0].others, [other]);
    // A point outside the range of a map is not ignored.
    for x in [f64::NAN, f64::INFINITY, 1e300] {
        assert_eq!(at(x, 1.0).iter().map(|one| one.deviation).collect::<Vec<_>>(), [Deviation::NotInside], "{x}");
    }
}

/// If all features belong to the audited layer, the other one is empty.
#[test]
fn more_features_than_there_are_may_be_audited() {
    let map = built(&counties());
    let all = map.features().count();
    let kinds =
        |audited: usize| check(&map, audited, &[]).expect("plane").iter().map(LayerFinding::rule).collect::<Vec<_>>();
    assert!(kinds(all).contains(&LayerRule::Within));
    assert_eq!(kinds(usize::MAX), kinds(all));
    let both = pieces(&map, usize::MAX).expect("plane");
    assert!(both.iter().all(|piece| piece.second.is_none()) && !both.is_empty());
}

/// Least and greatest x, and y.
type Box = [[u8; 2]; 2];

/// Parents that cover a square of this size, and their parts: both made by cutting.
const SIZE: u8 = 6;

#[derive(Clone, Debug)]
struct Hierarchy {
    parents: Vec<Box>,
    /// Each part with the number of its parent.
    parts: Vec<(Box, usize)>,
    /// A part, and the change to it.
    planted: (usize, u8),
}

/// Cuts boxes in two, if they are wide enough, a number of times.
fn cut(g: &mut Gen, whole: Box, times: usize) -> Vec<Box> {
    let mut boxes = vec![whole];
    for _ in 0..times {
        let number = usize::arbitrary(g) % boxes.len();
        let axis = usize::from(bool::arbitrary(g));
        let [low, high] = boxes[number][axis];
        if high - low > 1 {
            let at = low + 1 + u8::arbitrary(g) % (high - low - 1);
            let mut rest = boxes[number];
            boxes[number][axis][1] = at;
            rest[axis][0] = at;
            boxes.push(rest);
        }
    }
    boxes
}

impl Arbitrary for Hierarchy {
    fn arbitrary(g: &mut Gen) -> Self {
        let parents = cut(g, [[1, 1 + SIZE]; 2], 3);
        let mut parts = Vec::new();
        for (number, parent) in parents.iter().enumerate() {
            parts.extend(cut(g, *parent, 3).into_iter().map(|part| (part, number)));
        }
        let planted = (usize::arbitrary(g) % parts.len(), u8::arbitrary(g) % 6);
        Self { parents, parts, planted }
    }
}

impl Hierarchy {
    /// Grows or shrinks a side of a part, drops it, or moves it to the next parent.
    fn plant(&mut self) {
        let (number, how) = self.planted;
        let parents = self.parents.len();
        let (part, parent) = &mut self.parts[number];
        match how {
            0 => part[0][1] += 1,
            1 => part[1][0] -= 1,
            2 => part[0][0] += 1,
            3 => part[1][1] -= 1,
            4 => part[1] = [0, 0],
            _ => *parent = (*parent + 1) % parents,
        }
    }

    fn map(&self) -> PlanarMap {
        let shape = |[x, y]: Box| {
            // A box without an inside is a feature without a shape.
            let is_empty = x[0] == x[1] || y[0] == y[1];
            if is_empty { Shape::Polygon(vec![]) } else { rectangle(x.map(f64::from), y.map(f64::from)) }
        };
        let parts = self.parts.iter().map(|(part, _)| *part);
        built(&parts.chain(self.parents.iter().copied()).map(shape).collect::<Vec<_>>())
    }

    /// The total area, or for X3 the total length, of each deviation.
    fn found(&self) -> BTreeMap<Deviation, f64> {
        let map = self.map();
        let count = self.parts.len();
        let complete: Vec<FeatureId> = map.features().skip(count).collect();
        let parents: Vec<Parent> = self.parts.iter().map(|(_, parent)| Parent::Feature(complete[*parent])).collect();
        let mut found = check(&map, count, &[]).expect("plane");
        found.extend(check_parents(&map, &parents, &complete).expect("plane"));
        let mut sums = BTreeMap::new();
        for one in &found {
            *sums.entry(one.deviation).or_default() += if one.faces.is_empty() { one.length } else { one.area };
        }
        sums
    }

    /// The totals of each deviation, by counting unit squares and the sides between them.
    fn counted(&self) -> BTreeMap<Deviation, f64> {
        let covers = |one: &Box, [x, y]: [u8; 2]| one[0][0] <= x && x < one[0][1] && one[1][0] <= y && y < one[1][1];
        let parts = |at| (0..self.parts.len()).filter(|part| covers(&self.parts[*part].0, at)).collect::<BTreeSet<_>>();
        let parents = |at| (0..self.parents.len()).find(|parent| covers(&self.parents[*parent], at));
        let squares = || (0..SIZE + 3).flat_map(|x| (0..SIZE + 3).map(move |y| [x, y]));
        let mut sums: BTreeMap<Deviation, f64> = BTreeMap::new();
        let mut add = |deviation, count: usize| {
            if count > 0 {
                *sums.entry(deviation).or_default() += count as f64;
            }
        };
        for (part, parent) in &self.parts {
            let own: Vec<_> = squares().filter(|at| covers(part, *at)).map(parents).collect();
            let in_one = (0..self.parents.len()).map(|one| own.iter().filter(|of| **of == Some(one)).count()).max();
            add(Deviation::NotWithin, own.len() - in_one.unwrap_or_default());
            add(Deviation::OutsideParent, own.iter().filter(|of| **of != Some(*parent)).count());
        }
        for at in squares() {
            let (here, there) = (parts(at), parents(at));
            add(Deviation::OnlyHere, usize::from(!here.is_empty() && there.is_none()));
            add(Deviation::OnlyThere, usize::from(here.is_empty() && there.is_some()));
            let has_own = here.iter().any(|part| Some(self.parts[*part].1) == there);
            add(Deviation::ParentNotCovered, usize::from(there.is_some() && !has_own));
            for next in [[at[0] + 1, at[1]], [at[0], at[1] + 1]] {
                add(Deviation::NoBorder, usize::from(there != parents(next) && here == parts(next)));
            }
        }
        sums
    }
}

impl Hierarchy {
    /// The area of each piece, by its part and parent, as found and by counting unit squares.
    fn pieces(&self) -> [BTreeMap<[Option<usize>; 2], f64>; 2] {
        let map = self.map();
        let count = self.parts.len();
        let mut found = BTreeMap::new();
        for piece in pieces(&map, count).expect("plane") {
            let pair = [piece.first.map(FeatureId::index), piece.second.map(|one| one.index() - count)];
            let area = piece.faces.iter().map(|face| face_area(&map, *face).expect("of this map")).sum::<f64>();
            assert_eq!(found.insert(pair, area), None);
        }
        let mut counted = BTreeMap::new();
        for at in (0..SIZE + 3).flat_map(|x| (0..SIZE + 3).map(move |y| [x, y])) {
            let covers = |[x, y]: &Box| x[0] <= at[0] && at[0] < x[1] && y[0] <= at[1] && at[1] < y[1];
            let of = |boxes: Vec<Box>| {
                let all: Vec<_> = (0..boxes.len()).filter(|one| covers(&boxes[*one])).map(Some).collect();
                if all.is_empty() { vec![None] } else { all }
            };
            let second = of(self.parents.clone());
            for one in of(self.parts.iter().map(|(part, _)| *part).collect()) {
                for other in second.iter().filter(|other| one.or(**other).is_some()) {
                    *counted.entry([one, *other]).or_default() += 1.0;
                }
            }
        }
        [found, counted]
    }
}

#[test]
fn the_pieces_of_two_layers_have_the_areas_that_are_counted() {
    fn law(mut layers: Hierarchy) {
        layers.plant();
        let [found, counted] = layers.pieces();
        assert_eq!(found, counted);
    }
    QuickCheck::new().tests(200).quickcheck(law as fn(Hierarchy));
}

#[test]
fn parts_made_by_cutting_are_accepted_and_each_deviation_is_found_by_the_rules_concerned() {
    fn law(mut layers: Hierarchy) {
        assert_eq!(layers.found(), BTreeMap::new());
        layers.plant();
        assert_eq!(layers.found(), layers.counted());
        // Only the part of a sole parent can be moved to the next one, which is then the same parent.
        assert!(!layers.found().is_empty() || layers.parents.len() == 1 || layers.planted.1 < 4, "{layers:?}");
    }
    QuickCheck::new().tests(200).quickcheck(law as fn(Hierarchy));
}
