//! Neighbours: faces or features that share a border, with its course and its length.
//!
//! ```text
//!   ┌───────┬───────┐
//!   │   a   │   b   │     a and b are neighbours, and so are b and c;
//!   └───────┼───────┤     a and c touch: they meet at a vertex only
//!           │   c   │
//!           └───────┘
//! ```
//!
//! Two faces are neighbours if an edge has one of them on each side. The border of a feature with another is the part of its own
//! boundary beyond which the other lies, even if the other also lies on this side:
//!
//! ```text
//!   ┌───────┬─┬───────┐     a and b overlap. The border of a with b is the right side of the overlap, the end of a; that of
//!   │   a   │ab   b   │     b with a is its left side. Along both together, as if each were a border, it would be twice as
//!   │       │ │       │     long. None of it is shared: on no edge does one feature end and the other begin.
//!   └───────┴─┴───────┘
//! ```
//!
//! If nothing overlaps, two features see the same border, each from its side, and all of it is shared.
//!
//! Lengths are planar, in the units of the coordinates: in degrees for longitudes and latitudes.

use super::area::{Sum, face_area};
use super::claims::{faces_of, features_of};
use rustc_hash::FxHashSet;
use std::collections::BTreeMap;
use twinedge::dcel::{Face, FaceKey, HalfEdge, StaleKey, Vertex};
use twinedge_geometry::Point;
use twinedge_map::{Embedding, FeatureId, PlanarMap};

/// A neighbour, with the common border.
#[derive(Clone, Debug, PartialEq)]
pub struct Neighbour<K> {
    /// The neighbour.
    pub neighbour: K,
    /// The border, in maximal chains: each ends where no edge of this border continues it, or several do. A closed chain repeats
    /// its start. The queried face or feature lies to the left.
    pub borders: Vec<Vec<Point>>,
    /// The total length of these chains.
    pub length: f64,
    /// The total length of edges where one ends and the other begins: the full length, unless the two overlap there.
    pub shared: f64,
}

/// Two features with a common border or an overlap.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// The two features, in order.
    pub features: [FeatureId; 2],
    /// The border of the first with the second, as in [`of_feature`]; empty if the second lies inside the first.
    pub border: Neighbour<FeatureId>,
    /// The area that both cover.
    pub overlap: f64,
}

/// Returns the neighbours of a face across its edges, in order of their indices; the unbounded face may be one. An edge with the
/// face on both sides is no border. O(n log n) for its n half-edges.
///
/// # Errors
/// [`StaleKey::Face`].
///
/// ```
/// use twinedge_algorithm::neighbours::of_face;
/// use twinedge_map::{Builder, Shape};
///
/// let square = |x: f64| [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
/// let mut builder = Builder::new();
/// builder.shape(&Shape::polygon(square(0.0)))?;
/// builder.shape(&Shape::polygon(square(1.0)))?;
/// let map = builder.build()?;
/// let left = map.dcel().faces().nth(1).unwrap();
/// let lengths: Vec<f64> = of_face(&map, left.key())?.iter().map(|n| n.length).collect();
/// assert_eq!(lengths, [3.0, 1.0]); // with the unbounded face, with the other square
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn of_face(map: &PlanarMap, key: FaceKey) -> Result<Vec<Neighbour<FaceKey>>, StaleKey> {
    let face = map.dcel().face(key)?;
    let mut borders: BTreeMap<usize, Vec<HalfEdge<'_>>> = BTreeMap::new();
    for h in face.half_edges() {
        let other = h.twin().face();
        if other != face {
            borders.entry(other.index()).or_default().push(h);
        }
    }
    let with = |(_, border): (usize, Vec<HalfEdge<'_>>)| {
        let other = border.first()?.twin().face().key();
        Some(neighbour(map, other, &border))
    };
    Ok(borders.into_iter().filter_map(with).collect())
}

/// Returns the neighbours of a feature beyond its own boundary, in order. O(faces of the map · log + m log n) for m pairs of a
/// half-edge of a face that the feature covers and a feature on the other side.
///
/// Empty for a feature that this map does not have.
///
/// ```
/// use twinedge_algorithm::neighbours::of_feature;
/// use twinedge_map::{Builder, Shape};
///
/// let square = |x: f64| [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
/// let mut builder = Builder::new();
/// let [left, right] = [0.0, 1.0].map(|x| builder.shape(&Shape::polygon(square(x))).unwrap());
/// let map = builder.build()?;
/// let [border] = &of_feature(&map, left)[..] else { unreachable!("there is one neighbour") };
/// assert_eq!((border.neighbour, border.length), (right, 1.0));
/// assert_eq!(border.borders, [[[1.0, 0.0], [1.0, 1.0]].map(Into::into)]);
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[must_use]
pub fn of_feature(map: &PlanarMap, feature: FeatureId) -> Vec<Neighbour<FeatureId>> {
    let mut borders: BTreeMap<FeatureId, Vec<HalfEdge<'_>>> = BTreeMap::new();
    for face in covered(map, feature) {
        for h in face.half_edges() {
            let across = h.twin().face();
            if features_of(map, across).any(|f| f == feature) {
                continue;
            }
            for other in features_of(map, across) {
                borders.entry(other).or_default().push(h);
            }
        }
    }
    borders.into_iter().map(|(other, border)| neighbour_feature(map, other, &border)).collect()
}

/// Returns all pairs of features with a common border or an overlap, in order. O(n log n) for n half-edges, each counted once for
/// each pair of a feature on its side and a feature across it.
///
/// ```
/// use twinedge_algorithm::neighbours::pairs;
/// use twinedge_map::{Builder, Noding, Shape};
///
/// // The second square begins half a unit inside the first one.
/// let square = |x: f64| [[x, 0.0], [x + 9.0, 0.0], [x + 9.0, 9.0], [x, 9.0]];
/// let mut builder = Builder::new();
/// builder.shape(&Shape::polygon(square(0.0)))?;
/// builder.shape(&Shape::polygon(square(8.5)))?;
/// let map = builder.build_with(Noding::Exact)?;
/// let [pair] = &pairs(&map)[..] else { unreachable!("there are two features") };
/// assert_eq!((pair.border.length, pair.border.shared, pair.overlap), (9.0, 0.0, 4.5));
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[must_use]
pub fn pairs(map: &PlanarMap) -> Vec<Pair> {
    let mut found: BTreeMap<[FeatureId; 2], (Vec<HalfEdge<'_>>, Sum)> = BTreeMap::new();
    for face in map.dcel().faces() {
        let here: Vec<FeatureId> = features_of(map, face).collect();
        if here.is_empty() {
            continue;
        }
        let area = if here.len() > 1 { face_area(map, face.key()).unwrap_or_default() } else { 0.0 };
        for (i, one) in here.iter().enumerate() {
            for other in &here[i + 1..] {
                found.entry([*one, *other]).or_default().1.add(area);
            }
        }
        for h in face.half_edges() {
            let across: Vec<FeatureId> = features_of(map, h.twin().face()).collect();
            for one in here.iter().filter(|one| !across.contains(one)) {
                for other in across.iter().filter(|other| *other > one) {
                    found.entry([*one, *other]).or_default().0.push(h);
                }
            }
        }
    }
    let pair = |(features, (border, overlap)): ([FeatureId; 2], (Vec<HalfEdge<'_>>, Sum))| {
        let border = neighbour_feature(map, features[1], &border);
        Pair { features, border, overlap: overlap.value() }
    };
    found.into_iter().map(pair).collect()
}

/// Like [`neighbour`], for a feature: edges with it on both sides are not shared.
fn neighbour_feature(map: &PlanarMap, other: FeatureId, border: &[HalfEdge<'_>]) -> Neighbour<FeatureId> {
    let is_shared = |h: &&HalfEdge<'_>| !features_of(map, h.face()).any(|f| f == other);
    let shared: Sum = border.iter().filter(is_shared).map(|h| length(map, *h)).collect();
    Neighbour { shared: shared.value(), ..neighbour(map, other, border) }
}

/// Returns the features that meet a feature only at vertices, in order. Features that overlap it are not among them. O(faces of
/// the map · log + n log n) for n pairs of a half-edge that leaves one of its vertices and a feature there.
///
/// ```
/// use twinedge_algorithm::neighbours::{of_feature, touching_feature};
/// use twinedge_map::{Builder, Shape};
///
/// // Fields of a chessboard that meet at a corner.
/// let square = |low: f64| [[low, low], [low + 1.0, low], [low + 1.0, low + 1.0], [low, low + 1.0]];
/// let mut builder = Builder::new();
/// let [a1, b2] = [0.0, 1.0].map(|low| builder.shape(&Shape::polygon(square(low))).unwrap());
/// let map = builder.build()?;
/// assert_eq!(touching_feature(&map, a1), [b2]);
/// assert!(of_feature(&map, a1).is_empty());
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[must_use]
pub fn touching_feature(map: &PlanarMap, feature: FeatureId) -> Vec<FeatureId> {
    let faces = covered(map, feature);
    let corners = around(&faces).into_iter().flat_map(Vertex::rotation);
    let mut touching: FxHashSet<FeatureId> = corners.flat_map(|h| features_of(map, h.face())).collect();
    touching.remove(&feature);
    let sides = faces.iter().flat_map(|f| f.half_edges()).flat_map(|h| [h.face(), h.twin().face()]);
    for other in sides.flat_map(|side| features_of(map, side)) {
        touching.remove(&other);
    }
    let mut touching: Vec<_> = touching.into_iter().collect();
    touching.sort_unstable();
    touching
}

fn covered(map: &PlanarMap, feature: FeatureId) -> Vec<Face<'_>> {
    faces_of(map, feature).into_iter().filter_map(|f| map.dcel().face(f).ok()).collect()
}

/// Returns the vertices on the boundaries of faces, each once.
fn around<'a>(faces: &[Face<'a>]) -> Vec<Vertex<'a>> {
    let mut seen = FxHashSet::default();
    faces.iter().flat_map(|f| f.half_edges()).map(HalfEdge::origin).filter(|v| seen.insert(v.index())).collect()
}

fn length(map: &PlanarMap, h: HalfEdge<'_>) -> f64 {
    let [a, b] = [h.origin(), h.target()].map(|v| map.point(v.index()));
    (b.x - a.x).hypot(b.y - a.y)
}

fn neighbour<K>(map: &PlanarMap, neighbour: K, border: &[HalfEdge<'_>]) -> Neighbour<K> {
    let sum: Sum = border.iter().map(|h| length(map, *h)).collect();
    let length = sum.value();
    Neighbour { neighbour, borders: chains(map, border), length, shared: length }
}

/// Joins a set of half-edges to maximal chains: each ends where none continues it, or several arrive or leave. O(n log n).
#[must_use]
pub fn chains(map: &PlanarMap, border: &[HalfEdge<'_>]) -> Vec<Vec<Point>> {
    // Sorted by start.
    let mut leaving: Vec<(usize, usize)> = border.iter().enumerate().map(|(i, h)| (h.origin().index(), i)).collect();
    leaving.sort_unstable();
    let mut arriving: Vec<usize> = border.iter().map(|h| h.target().index()).collect();
    arriving.sort_unstable();
    let starts_at = |v: usize| {
        let first = leaving.partition_point(|(w, _)| *w < v);
        leaving[first..].iter().take_while(move |(w, _)| *w == v)
    };
    let ends_at = |v: usize| {
        let first = arriving.partition_point(|w| *w < v);
        arriving[first..].iter().take(2).filter(|w| **w == v).count()
    };
    // Returns the only half-edge that leaves a vertex where exactly one arrives.
    let onward = |v: usize| {
        let mut here = starts_at(v);
        let next = here.next().map(|(_, i)| *i);
        next.filter(|_| here.next().is_none() && ends_at(v) == 1)
    };
    let mut taken = vec![false; border.len()];
    let mut found = Vec::new();
    let ends = (0..border.len()).filter(|i| onward(border[*i].origin().index()).is_none());
    // After all chains with ends, the remaining ones are closed, and may start anywhere.
    for start in ends.chain(0..border.len()) {
        let mut chain = Vec::new();
        let mut at = Some(start);
        while let Some(i) = at.filter(|i| !core::mem::replace(&mut taken[*i], true)) {
            if chain.is_empty() {
                chain.push(map.point(border[i].origin().index()));
            }
            let target = border[i].target().index();
            chain.push(map.point(target));
            at = onward(target);
        }
        if !chain.is_empty() {
            found.push(chain);
        }
    }
    found
}
