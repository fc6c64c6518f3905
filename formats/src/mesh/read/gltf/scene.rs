//! The nodes of a scene, and what they do to places.

use super::super::error::{Cause, Failure, Position};
use super::document::{Document, Node};

/// An affine map: the images of the unit vectors, and of the origin.
#[derive(Clone, Copy)]
pub(super) struct Transform([[f64; 3]; 4]);

impl Transform {
    const IDENTITY: Self = Self([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0; 3]]);

    /// The place to which a place is moved.
    pub(super) fn of(&self, place: [f64; 3]) -> [f64; 3] {
        let [turned, origin] = [self.turned(place), self.0[3]];
        [0, 1, 2].map(|i| turned[i] + origin[i])
    }

    /// The direction to which a direction is turned.
    fn turned(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [a, b, c, _] = self.0;
        [0, 1, 2].map(|i| a[i] * x + b[i] * y + c[i] * z)
    }

    /// Returns true if right hands become left hands.
    pub(super) fn is_mirror(&self) -> bool {
        let [a, b, c, _] = self.0;
        let cross = |u: [f64; 3], v: [f64; 3]| {
            [0, 1, 2].map(|i| u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3])
        };
        let ab = cross(a, b);
        (0..3).map(|i| ab[i] * c[i]).sum::<f64>() < 0.0
    }

    fn of_node(node: &Node) -> Self {
        if let Some(m) = node.matrix {
            return Self([0, 4, 8, 12].map(|column| [0, 1, 2].map(|row| m[column + row])));
        }
        let [x, y, z, w] = node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]);
        let scale = node.scale.unwrap_or([1.0; 3]);
        let turned = [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)],
            [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)],
            [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)],
        ];
        let [a, b, c] = [0, 1, 2].map(|i| turned[i].map(|part| part * scale[i]));
        Self([a, b, c, node.translation.unwrap_or_default()])
    }

    /// This after another one.
    fn after(&self, inner: &Self) -> Self {
        let [a, b, c, origin] = inner.0;
        Self([self.turned(a), self.turned(b), self.turned(c), self.of(origin)])
    }
}

/// The meshes of the scene, in order, each with what its nodes do to it; all meshes as they are if there are no nodes. O(nodes).
pub(super) fn meshes(document: &Document<'_>) -> Result<Vec<(usize, Transform)>, Failure> {
    let wrong = |text: String| Failure::new(Position::Byte(0), Cause::Document(text.into()));
    if document.nodes.is_empty() {
        return Ok((0..document.meshes.len()).map(|mesh| (mesh, Transform::IDENTITY)).collect());
    }
    let mut is_child = vec![false; document.nodes.len()];
    for child in document.nodes.iter().flat_map(|node| &node.children) {
        *is_child.get_mut(*child).ok_or_else(|| wrong(format!("there is no node {child}")))? = true;
    }
    let number = document.scene.unwrap_or(0);
    let roots = match document.scenes.get(number) {
        Some(scene) => scene.nodes.clone(),
        None if document.scene.is_none() => (0..is_child.len()).filter(|node| !is_child[*node]).collect(),
        None => return Err(wrong(format!("there is no scene {number}"))),
    };
    let mut found = Vec::new();
    let mut is_seen = vec![false; document.nodes.len()];
    let mut pending: Vec<(usize, Transform)> =
        roots.into_iter().rev().map(|node| (node, Transform::IDENTITY)).collect();
    while let Some((number, outer)) = pending.pop() {
        let node = document.nodes.get(number).ok_or_else(|| wrong(format!("there is no node {number}")))?;
        if std::mem::replace(&mut is_seen[number], true) {
            return Err(wrong(format!("node {number} has two parents, or is its own ancestor")));
        }
        let transform = outer.after(&Transform::of_node(node));
        found.extend(node.mesh.map(|mesh| (mesh, transform)));
        pending.extend(node.children.iter().rev().map(|child| (*child, transform)));
    }
    Ok(found)
}
