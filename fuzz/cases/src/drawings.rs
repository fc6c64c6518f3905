//! Targets that build maps from coordinates.

use arbitrary::Unstructured;
use std::collections::BTreeSet;
use twinedge::program::choose::Choose;
use twinedge::validate::Rule;
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_geometry::predicates::{Meeting, in_range, meeting, on_segment};
use twinedge_layers::io::ReadError as TextError;
use twinedge_layers::io::geojson::{self, Documents, Part};
use twinedge_layers::{Format, ReadError, ReadOptions, format_of, read_for_map};
use twinedge_map::{BuildError, Builder, Feature, Noding, PlanarMap, Shape};

/// The largest number of segments that are compared pair by pair.
const FEW: usize = 200;

/// A coordinate: mostly of a small grid, where points coincide and segments cross; otherwise close to it, or any bits.
fn coordinate(source: &mut Unstructured<'_>) -> f64 {
    let grid = Choose::choose(source, 8) as f64;
    match Choose::choose(source, 16) {
        0 => f64::from_bits(source.arbitrary().unwrap_or_default()),
        1 => grid.next_up(),
        2 => grid.next_down(),
        3 => grid / 3.0,
        4 => -grid,
        5 => grid * 2.0_f64.powi(495),
        6 => grid * 2.0_f64.powi(-399),
        7 => grid * 1e9,
        _ => grid,
    }
}

fn point(source: &mut Unstructured<'_>) -> Point {
    Point::new(coordinate(source), coordinate(source))
}

fn chain(source: &mut Unstructured<'_>) -> Vec<Point> {
    (0..Choose::choose(source, 7)).map(|_| point(source)).collect()
}

fn shape(source: &mut Unstructured<'_>) -> Shape {
    match Choose::choose(source, 4) {
        0 => Shape::Polygon((0..Choose::choose(source, 3)).map(|_| chain(source)).collect()),
        1 => Shape::Point(point(source)),
        _ => Shape::Line(chain(source)),
    }
}

/// Passes rings, lines and points of any coordinates to the builder. The map is valid, or G4 is named as broken if and
/// only if two segments clash; or an error names the coordinate at fault.
///
/// # Panics
/// If the builder or the validator errs.
pub fn segments(bytes: &[u8]) {
    let mut source = Unstructured::new(bytes);
    let mut builder = Builder::new();
    let mut taken = Vec::new();
    while !source.is_empty() && taken.len() < 60 {
        let shapes = (0..=Choose::choose(&mut source, 2)).map(|_| shape(&mut source)).collect();
        let feature = Feature { shapes, ..Feature::default() };
        if takes(&mut builder, &feature) {
            taken.push(feature);
        }
    }
    built(builder, &taken);
}

/// Nodes rings, lines and points of any coordinates. Snapped, they make a valid map, or an error names a coordinate out
/// of reach. Cut exactly, they make a valid map of the same points, or cross where there is no point.
///
/// # Panics
/// If the noder or the validator errs.
pub fn noding(bytes: &[u8]) {
    let mut source = Unstructured::new(bytes);
    let snap = match Choose::choose(&mut source, 4) {
        0 => Snap::Size(1.0),
        1 => Snap::Size((Choose::choose(&mut source, 60) as f64 - 30.0).exp2()),
        _ => Snap::Auto,
    };
    let mut builder = Builder::new();
    let mut taken = Vec::new();
    while !source.is_empty() && taken.len() < 60 {
        let feature = Feature { shapes: vec![shape(&mut source)], ..Feature::default() };
        if takes(&mut builder, &feature) {
            taken.push(feature);
        }
    }
    let mut again = Builder::new();
    for feature in &taken {
        assert!(takes(&mut again, feature));
    }

    match builder.build_with(Noding::Snap(snap)) {
        Ok(map) => {
            let report = map.validate();
            assert!(map.is_plane() && report.is_valid(), "{snap:?} {taken:?}\n{report}");
        }
        Err(BuildError::OutOfReach { x, y }) => {
            let Snap::Size(cell) = snap else { panic!("nothing is out of reach of the finest grid: {taken:?}") };
            assert!(x.abs().max(y.abs()) >= cell * 2.0_f64.powi(53), "({x}, {y}) is in reach of {cell}");
        }
        Err(error) => panic!("{snap:?} {taken:?}: {error}"),
    }
    match again.build_with(Noding::Exact) {
        Ok(map) => {
            let report = map.validate();
            assert!(map.is_plane() && report.is_valid(), "{taken:?}\n{report}");
            assert_eq!(map.dcel().vertex_count(), drawn(&taken).0.len(), "{taken:?}");
        }
        Err(BuildError::Crossing { one: [a, b], other: [c, d], .. }) => {
            assert_eq!(meeting(a, b, c, d), Meeting::Cross, "{taken:?}");
        }
        Err(error) => panic!("{taken:?}: {error}"),
    }
}

/// Passes a feature to the builder, which takes it if and only if all coordinates are in range.
fn takes(builder: &mut Builder, feature: &Feature) -> bool {
    let before = builder.summary().clone();
    let all_in_range = points(feature).all(in_range);
    match builder.feature(feature) {
        Ok(_) => {
            assert!(all_in_range, "{feature:?} is out of range");
            true
        }
        Err(BuildError::NotFinite { position, x, y }) => {
            assert!(!x.is_finite() || !y.is_finite(), "{position}: ({x}, {y}) is finite");
            refused(builder, &before, feature, position, (x, y))
        }
        Err(BuildError::OutOfRange { position, x, y }) => {
            assert!(
                x.is_finite() && y.is_finite() && !in_range(Point::new(x, y)),
                "{position}: ({x}, {y}) is in range"
            );
            refused(builder, &before, feature, position, (x, y))
        }
        Err(error) => panic!("{feature:?}: {error}"),
    }
}

/// Checks that a refused feature left nothing behind, and that the named point is the one at that position.
fn refused(
    builder: &Builder,
    before: &twinedge_map::BuildSummary,
    feature: &Feature,
    at: twinedge_map::Position,
    (x, y): (f64, f64),
) -> bool {
    assert_eq!(builder.summary(), before);
    let named = match &feature.shapes[at.shape] {
        Shape::Polygon(rings) => rings[at.ring][at.point],
        Shape::Line(points) => points[at.point],
        Shape::Point(p) => *p,
    };
    assert_eq!((named.x.to_bits(), named.y.to_bits()), (x.to_bits(), y.to_bits()), "{at}");
    false
}

fn points(feature: &Feature) -> impl Iterator<Item = Point> + '_ {
    feature.shapes.iter().flat_map(|shape| match shape {
        Shape::Polygon(rings) => rings.concat(),
        Shape::Line(points) => points.clone(),
        Shape::Point(p) => vec![*p],
    })
}

/// Checks that the map of these features is valid, or breaks G4 and says where, and that it is valid if the features do
/// not clash.
fn built(builder: Builder, features: &[Feature]) {
    let map = match builder.build() {
        Ok(map) => map,
        Err(error) => panic!("no map of {features:?}: {error}"),
    };
    let report = map.validate();
    let broken = |rule| report.outcome(rule).is_some_and(|outcome| outcome.violations > 0);
    assert_eq!(report.is_valid(), map.is_plane(), "{features:?}\n{report}");
    assert_eq!(broken(Rule::G4), !map.is_plane(), "{features:?}\n{report}");
    // Segments that clash can have handles, as rotations go; nesting is then undefined.
    for rule in Rule::ALL.iter().copied().filter(|rule| *rule < Rule::T1 || *rule == Rule::G1) {
        assert!(!broken(rule), "{rule} of {features:?}\n{report}");
    }
    if let Some(plane) = is_plane(features) {
        assert_eq!(map.is_plane(), plane, "{features:?}\n{report}");
    }
    counted(&map, features);
}

/// Distinct points and segments, as the builder must count them. A ring is closed.
fn drawn(features: &[Feature]) -> (BTreeSet<[u64; 2]>, BTreeSet<[[u64; 2]; 2]>) {
    let bits = |p: &Point| [(p.x + 0.0).to_bits(), (p.y + 0.0).to_bits()];
    let (mut vertices, mut segments) = (BTreeSet::new(), BTreeSet::new());
    let mut chain = |points: &[Point], closed: bool| {
        vertices.extend(points.iter().map(bits));
        let closing = points.last().zip(points.first()).filter(|_| closed);
        let sides = points.windows(2).map(|side| (&side[0], &side[1])).chain(closing);
        for (a, b) in sides {
            let mut ends = [bits(a), bits(b)];
            ends.sort_unstable();
            if ends[0] != ends[1] {
                segments.insert(ends);
            }
        }
    };
    for shape in features.iter().flat_map(|feature| &feature.shapes) {
        match shape {
            Shape::Polygon(rings) => rings.iter().for_each(|ring| chain(ring, true)),
            Shape::Line(points) => chain(points, false),
            Shape::Point(p) => chain(&[*p], false),
        }
    }
    (vertices, segments)
}

fn counted(map: &PlanarMap, features: &[Feature]) {
    let (vertices, segments) = drawn(features);
    assert_eq!(map.dcel().vertex_count(), vertices.len(), "{features:?}");
    assert_eq!(map.dcel().edge_count(), segments.len(), "{features:?}");
}

/// Returns true if no two segments clash, pair by pair; `None` if there are too many to compare.
fn is_plane(features: &[Feature]) -> Option<bool> {
    let (vertices, segments) = drawn(features);
    if segments.len() > FEW || vertices.len() > FEW {
        return None;
    }
    let point = |bits: &[u64; 2]| Point::new(f64::from_bits(bits[0]), f64::from_bits(bits[1]));
    let segments: Vec<[Point; 2]> = segments.iter().map(|[a, b]| [point(a), point(b)]).collect();
    let clash = |(i, [a, b]): (usize, &[Point; 2])| {
        segments[..i]
            .iter()
            .any(|[c, d]| !matches!(meeting(*a, *b, *c, *d), Meeting::Disjoint | Meeting::SharedEndpoint))
            || vertices.iter().map(point).any(|p| p != *a && p != *b && on_segment(p, *a, *b))
    };
    Some(!segments.iter().enumerate().any(clash))
}

/// A reader that returns a few bytes at a time.
struct Dripping<'a>(&'a [u8]);

impl std::io::Read for Dripping<'_> {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        let n = into.len().min(self.0.len()).min(3);
        into[..n].copy_from_slice(&self.0[..n]);
        self.0 = &self.0[n..];
        Ok(n)
    }
}

/// Passes any bytes to the reader of GeoJSON, in one piece and in small ones, and its features to the builder.
///
/// # Panics
/// If the pieces make a difference, the reader that cuts features out of the text finds another error than the plain
/// reader, an error names a position outside the input, or the map is not as for [`segments`].
pub fn geojson(bytes: &[u8]) {
    let options = ReadOptions { format: Some(Format::GeoJson), ..ReadOptions::default() };
    if !format_of(bytes, None, &options).is_ok_and(|format| format == Format::GeoJson) {
        return;
    }
    let outcome = read_for_map(&mut { bytes }, &options);
    let again = read_for_map(&mut Dripping(bytes), &options);
    assert_eq!(format!("{outcome:?}"), format!("{again:?}"), "the size of the pieces makes a difference");
    let mut count = 0;
    let plain = geojson::read_parts(bytes, Documents::One, |part| {
        count += usize::from(matches!(part, Part::Feature(_)));
        Ok::<_, TextError>(())
    });
    let mut features = match (outcome, plain) {
        (Ok((features, summary)), Ok(())) => {
            assert_eq!((summary.features, features.len()), (count, count));
            assert_eq!(summary.positions, features.iter().flat_map(points).count());
            features
        }
        (Err(ReadError::Text(error)), Err(plain)) => {
            assert_eq!(error.to_string(), plain.to_string());
            let lines = bytes.split(|byte| *byte == b'\n').count();
            let place = error.place;
            assert!(
                (1..=lines).contains(&place.line) && place.column.is_some_and(|column| column <= bytes.len() + 1),
                "{error}"
            );
            return;
        }
        (outcome, plain) => panic!("{outcome:?}, but {plain:?}"),
    };
    let mut builder = Builder::new();
    features.retain(|feature| takes(&mut builder, feature));
    built(builder, &features);
}
