//! C7 mismatch: where borders of two features meet, or two rings of one feature, both have a vertex.
//!
//! ```text
//!   ┌──────┬──────┐
//!   │      │      │      a and b have a common border, and the vertex v is one of a only.
//!   │  a  v○  b   │      A vertex at which borders only touch is missing in the same way.
//!   │      │      │
//!   └──────┴──────┘
//! ```
//!
//! The missing vertices come from the input ([`Builder::unmatched`](twinedge_map::Builder::unmatched)): the map has them once its
//! segments are cut. If two features claim the same area around a vertex, their borders meet because of an overlap, which is C1.

use super::check::CoverageError;
use super::finding::{CoverageRule, Finding, MissingVertex};
use super::region::{first_corner, segment_length};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;
use twinedge::dcel::Vertex;
use twinedge_algorithm::area::Sum;
use twinedge_algorithm::claims::features_of;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_lexicographic;
use twinedge_map::{Embedding, FeatureId, PlanarMap, UnmatchedVertex};

/// Finds violations of C7. Returns one finding for each two features whose borders lack vertices of each other, and for each
/// feature whose border lacks its own vertices, with all missing vertices. `map` is the map of the same input with its segments
/// cut, `unmatched` the result of [`Builder::unmatched`](twinedge_map::Builder::unmatched). Findings with the most missing
/// vertices come first. O(n + k log k) for n vertices and k unmatched ones, plus their rotations.
///
/// ```
/// use twinedge_coverage::{CoverageRule, mismatches};
/// use twinedge_geometry::Point;
/// use twinedge_map::{Builder, Noding, Shape};
///
/// // https://github.com/libgeos/geos/issues/1525: the second polygon lacks the vertex (1, 1).
/// let mut builder = Builder::new();
/// let a = builder.shape(&Shape::polygon([[1.0, 0.0], [1.0, 1.0], [1.0, 3.0], [4.0, 0.0]]))?;
/// let b = builder.shape(&Shape::polygon([[0.0, 4.0], [1.0, 3.0], [1.0, 0.0]]))?;
/// let unmatched = builder.unmatched();
/// let found = mismatches(&builder.build_with(Noding::Exact)?, &unmatched)?;
/// assert_eq!((found.len(), found[0].rule, &found[0].features[..]), (1, CoverageRule::Mismatch, &[a, b][..]));
/// assert_eq!((found[0].missing[0].at, found[0].missing[0].feature), (Point::new(1.0, 1.0), b));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`CoverageError::NotPlane`]: the segments of the map were not cut.
pub fn mismatches(map: &PlanarMap, unmatched: &[UnmatchedVertex]) -> Result<Vec<Finding>, CoverageError> {
    map.plane()?;
    let snapped = |p: Point| map.noding().map_or(p, |noding| noding.snapped(p));
    Ok(by_pairs(apart(map, unmatched, snapped)))
}

/// Returns the unmatched vertices around which the two features do not overlap. `snapped` locates a point on the map.
pub(crate) fn apart(
    map: &PlanarMap,
    unmatched: &[UnmatchedVertex],
    snapped: impl Fn(Point) -> Point,
) -> impl Iterator<Item = UnmatchedVertex> {
    let mut vertices: FxHashMap<(u64, u64), Option<Vertex<'_>>> =
        unmatched.iter().map(|one| (snapped(one.at).hash_key(), None)).collect();
    for vertex in map.dcel().vertices() {
        if let Some(found) = vertices.get_mut(&map.point(vertex.index()).hash_key()) {
            *found = Some(vertex);
        }
    }
    let is_apart = move |one: &UnmatchedVertex| {
        let vertex = vertices.get(&snapped(one.at).hash_key()).copied().flatten();
        !vertex.is_some_and(|vertex| overlap_at(map, vertex, [one.of, one.lacked_by]))
    };
    unmatched.iter().copied().filter(is_apart)
}

pub(crate) fn by_pairs(unmatched: impl IntoIterator<Item = UnmatchedVertex>) -> Vec<Finding> {
    let mut pairs: BTreeMap<[FeatureId; 2], Vec<UnmatchedVertex>> = BTreeMap::new();
    for one in unmatched {
        pairs.entry([one.of.min(one.lacked_by), one.of.max(one.lacked_by)]).or_default().push(one);
    }
    let mut found: Vec<Finding> = pairs.into_iter().map(|(pair, all)| mismatch(pair, &all)).collect();
    found.sort_by_key(|finding| std::cmp::Reverse(finding.missing.len()));
    found
}

/// Returns true if both features claim one of the faces around a vertex.
fn overlap_at(map: &PlanarMap, vertex: Vertex<'_>, pair: [FeatureId; 2]) -> bool {
    vertex.rotation().any(|h| features_of(map, h.face()).filter(|feature| pair.contains(feature)).nth(1).is_some())
}

/// Makes the finding of the missing vertices of two features.
fn mismatch(pair: [FeatureId; 2], all: &[UnmatchedVertex]) -> Finding {
    let mut missing: Vec<MissingVertex> =
        all.iter().map(|one| MissingVertex { at: one.at, feature: one.lacked_by }).collect();
    missing.sort_by(|a, b| compare_lexicographic(a.at, b.at).then(a.feature.cmp(&b.feature)));
    missing.dedup();
    let mut stretches: Vec<[Point; 2]> = all.iter().map(|one| one.segment).collect();
    stretches.sort_by(|a, b| compare_lexicographic(a[0], b[0]).then_with(|| compare_lexicographic(a[1], b[1])));
    stretches.dedup();
    let length: Sum = stretches.iter().map(|stretch| segment_length(*stretch)).collect();
    let mut features = pair.to_vec();
    features.dedup();
    Finding {
        rule: CoverageRule::Mismatch,
        features,
        area: 0.0,
        width: 0.0,
        length: length.value(),
        at: missing.first().map(|one| one.at).unwrap_or_default(),
        corner: first_corner(stretches.iter().flatten().copied()),
        faces: Vec::new(),
        stretches,
        missing,
    }
}
