//! Making the index of `FlatGeobuf`, over features in their order.

use super::super::extent::Extent;
use super::super::model::{Geometry, Layer};
use super::tree::Tree;

/// The number of children of a node, also chosen by other writers.
pub(super) const NODE_SIZE: u16 = 16;

/// Returns the boxes around all features; `None` if there are none, or a feature has no position, which an index cannot
/// represent.
pub(super) fn extents(layer: &Layer) -> Option<Vec<Extent>> {
    let all = layer.features.iter().map(|feature| feature.geometry.as_ref().map(extent).filter(Extent::is_known));
    all.collect::<Option<Vec<_>>>().filter(|all| !all.is_empty())
}

fn extent(geometry: &Geometry) -> Extent {
    let mut extent = Extent::NOTHING;
    geometry.shape.visit(&mut |p| extent = extent.with(Extent::new([p.x, p.y, p.x, p.y])));
    extent
}

/// Returns the index of features with these boxes and lengths.
pub(super) fn packed(extents: &[Extent], lengths: impl Iterator<Item = usize>) -> Vec<u8> {
    let tree = Tree::new(extents.len() as u64, NODE_SIZE.into());
    let offsets = lengths.scan(0, |end, length| Some(std::mem::replace(end, *end + length as u64)));
    let mut levels: Vec<Vec<(Extent, u64)>> = vec![extents.iter().copied().zip(offsets).collect()];
    for level in 1..tree.level_count() {
        let below = &levels[level - 1];
        let node = |(place, nodes): (usize, &[(Extent, u64)])| {
            let extent = nodes.iter().fold(Extent::NOTHING, |all, (extent, _)| all.with(*extent));
            (extent, tree.start(level - 1) + (place * usize::from(NODE_SIZE)) as u64)
        };
        levels.push(below.chunks(NODE_SIZE.into()).enumerate().map(node).collect());
    }
    let mut bytes = Vec::new();
    for (Extent { low, high }, offset) in levels.iter().rev().flatten() {
        for number in [low.x, low.y, high.x, high.y] {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend(offset.to_le_bytes());
    }
    bytes
}
