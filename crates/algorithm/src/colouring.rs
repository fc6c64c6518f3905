//! Colours that distinguish neighbours.
//!
//! The features are removed one by one, always one with the fewest neighbours left. In reverse order each gets the smallest
//! colour not used by its already coloured neighbours. If every feature is one face, the graph of neighbours is planar: some
//! feature always has at most five neighbours left, and six colours suffice. Features of several parts may need more.
//!
//! Source: D. W. Matula and L. L. Beck, "Smallest-last ordering and clustering and graph coloring algorithms", Journal of the
//! ACM 30 (1983) 417-427.

use super::claims::features_of;
use std::collections::BTreeSet;
use twinedge_map::PlanarMap;

/// Returns a colour for each feature, by [`FeatureId::index`](twinedge_map::FeatureId::index): numbers from 0, different for two
/// features with a common edge or face. If more than two features claim a face, only the first two count there. O(n log n).
///
/// ```
/// use twinedge_algorithm::colouring::feature_colours;
/// use twinedge_map::{Builder, Shape};
///
/// let square = |x: f64| [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
/// let mut builder = Builder::new();
/// for x in [0.0, 1.0, 2.0] {
///     builder.shape(&Shape::polygon(square(x)))?;
/// }
/// let colours = feature_colours(&builder.build()?);
/// assert!(colours[0] != colours[1] && colours[1] != colours[2]);
/// assert!(colours.iter().all(|colour| *colour < 2));
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[must_use]
pub fn feature_colours(map: &PlanarMap) -> Vec<usize> {
    let count = map.features().count();
    let mut adjacent = vec![Vec::new(); count];
    let mut pairs = Vec::new();
    for face in map.dcel().faces() {
        let here: Vec<usize> = features_of(map, face).take(2).map(|f| f.index()).collect();
        for side in face.neighbours().chain([face]).filter(|_| !here.is_empty()) {
            let there = features_of(map, side).take(2).map(|f| f.index());
            pairs.extend(there.flat_map(|b| here.iter().map(move |a| (*a, b))));
        }
    }
    pairs.retain(|(a, b)| a != b);
    pairs.extend(pairs.clone().into_iter().map(|(a, b)| (b, a)));
    pairs.sort_unstable();
    pairs.dedup();
    for (a, b) in pairs {
        adjacent[a].push(b);
    }

    let mut left: Vec<usize> = adjacent.iter().map(Vec::len).collect();
    let mut queue: BTreeSet<(usize, usize)> = left.iter().copied().zip(0..).collect();
    let mut order = Vec::with_capacity(count);
    while let Some((_, feature)) = queue.pop_first() {
        order.push(feature);
        for other in &adjacent[feature] {
            if queue.remove(&(left[*other], *other)) {
                left[*other] -= 1;
                queue.insert((left[*other], *other));
            }
        }
    }
    let mut colours = vec![None; count];
    for feature in order.into_iter().rev() {
        let taken: BTreeSet<usize> = adjacent[feature].iter().filter_map(|other| colours[*other]).collect();
        colours[feature] = (0..=taken.len()).find(|colour| !taken.contains(colour));
    }
    colours.into_iter().map(Option::unwrap_or_default).collect()
}
