//! Counting planar subdivisions without making one, so without operators, canonical forms and validators.
//!
//! A face contains a multiset of components, each with contents in its bounded faces. A subdivision consists of the contents of
//! the unbounded face. Let S(x, y) count the contents of a face by edges and vertices, and T(x, y) one component with contents:
//!
//! ```text
//!   S = Π (1 − xⁱ yʲ)^(−tᵢⱼ)                               multisets (Euler's transform)
//!   T = Σ over connected maps M with an outside:
//!           x^E y^V · 1/|Aut M| · Σ over g in Aut M: Π over cycles c of g on the bounded faces: S(x^|c|, y^|c|)
//!                                                          contents up to symmetry (Pólya's theorem)
//! ```
//!
//! The sum over M comes from all permutations. On n labelled edges, every permutation of the 2n half-edges is the `next` of a
//! map. In the connected plane maps, each cycle in turn is the outside, and each automorphism is found by trying all images of
//! half-edge 0. The sum over all labellings, divided by their number 2ⁿ n!, is the sum over M (Burnside). Each component has a
//! vertex, so fewer vertices are left for its contents, and repeated substitution ends.

use super::genus::{CombinatorialMap, for_each};
use std::collections::BTreeMap;

#[derive(Clone, Debug, PartialEq, Eq)]
struct Series {
    /// The largest exponents of edges and of vertices that are kept.
    edges: usize,
    vertices: usize,
    terms: Vec<u128>,
}

impl Series {
    fn new(edges: usize, vertices: usize) -> Self {
        Self { edges, vertices, terms: vec![0; (edges + 1) * (vertices + 1)] }
    }

    fn one(edges: usize, vertices: usize) -> Self {
        let mut one = Self::new(edges, vertices);
        one.terms[0] = 1;
        one
    }

    fn get(&self, e: usize, v: usize) -> u128 {
        self.terms[e * (self.vertices + 1) + v]
    }

    fn add(&mut self, e: usize, v: usize, term: u128) {
        if e <= self.edges && v <= self.vertices {
            self.terms[e * (self.vertices + 1) + v] += term;
        }
    }

    fn all_terms(&self) -> impl Iterator<Item = (usize, usize, u128)> + '_ {
        let sizes = (0..=self.edges).flat_map(|e| (0..=self.vertices).map(move |v| (e, v)));
        sizes.zip(&self.terms).map(|((e, v), term)| (e, v, *term)).filter(|(_, _, term)| *term > 0)
    }

    fn times(&self, other: &Self) -> Self {
        let mut product = Self::new(self.edges, self.vertices);
        for (e, v, one) in self.all_terms() {
            for (f, w, two) in other.all_terms() {
                product.add(e + f, v + w, one * two);
            }
        }
        product
    }

    /// Returns the series with x and y raised to this power.
    fn stretched(&self, by: usize) -> Self {
        let mut stretched = Self::new(self.edges, self.vertices);
        for (e, v, term) in self.all_terms() {
            stretched.add(e * by, v * by, term);
        }
        stretched
    }

    /// Returns the multisets of the counted things: for each size, each kind in turn, any number of times.
    fn multisets(&self) -> Self {
        let mut sets = Self::one(self.edges, self.vertices);
        for (e, v, kinds) in self.all_terms().filter(|(e, v, _)| (*e, *v) != (0, 0)) {
            // For this many kinds of one size, there are (kinds + k − 1 over k) multisets of k.
            let mut of_this_size = Self::new(self.edges, self.vertices);
            let mut ways = 1;
            for k in 0..=(self.edges + self.vertices) {
                of_this_size.add(e * k, v * k, ways);
                ways = ways * (kinds + k as u128) / (k as u128 + 1);
            }
            sets = sets.times(&of_this_size);
        }
        sets
    }
}

/// Automorphisms of connected plane maps with an outside, summed over all names of half-edges: their numbers by the number of
/// vertices and by the lengths of their cycles on the bounded faces.
type Symmetries = BTreeMap<(usize, Vec<usize>), u128>;

fn symmetries(edges: usize) -> Symmetries {
    let mut sum = Symmetries::new();
    if edges == 0 {
        sum.insert((1, vec![]), 1);
        return sum;
    }
    for_each(2 * edges as u8, &[], |map| {
        let faces = faces(map);
        if !is_connected(map) || map.vertices() + faces.len() != edges + 2 {
            return;
        }
        for automorphism in (0..map.len()).filter_map(|image| automorphism(map, image)) {
            // The image of each face.
            let images: Vec<usize> = faces
                .iter()
                .filter_map(|face| faces.iter().position(|other| other.contains(&automorphism[face[0]])))
                .collect();
            for outside in (0..faces.len()).filter(|f| images[*f] == *f) {
                *sum.entry((map.vertices(), cycle_lengths(&images, outside))).or_default() += 1;
            }
        }
    });
    sum
}

fn faces(map: &CombinatorialMap) -> Vec<Vec<usize>> {
    let next = map.next_column();
    let mut faces: Vec<Vec<usize>> = Vec::new();
    for start in 0..map.len() {
        if !faces.iter().any(|face| face.contains(&start)) {
            let mut face = vec![start];
            let mut h = usize::from(next[start]);
            while h != start {
                face.push(h);
                h = usize::from(next[h]);
            }
            faces.push(face);
        }
    }
    faces
}

fn is_connected(map: &CombinatorialMap) -> bool {
    let mut reached = vec![0];
    let mut done = 0;
    while let Some(h) = reached.get(done).copied() {
        for other in [h ^ 1, usize::from(map.next_column()[h])] {
            if !reached.contains(&other) {
                reached.push(other);
            }
        }
        done += 1;
    }
    reached.len() == map.len()
}

/// Returns the automorphism of a connected map that maps half-edge 0 to `image`, if there is one: by half-edge, its image.
fn automorphism(map: &CombinatorialMap, image: usize) -> Option<Vec<usize>> {
    let next = |h: usize| usize::from(map.next_column()[h]);
    let mut images = vec![usize::MAX; map.len()];
    images[0] = image;
    let mut waiting = vec![0];
    while let Some(h) = waiting.pop() {
        for (from, to) in [(h ^ 1, images[h] ^ 1), (next(h), next(images[h]))] {
            if images[from] == usize::MAX {
                images[from] = to;
                waiting.push(from);
            } else if images[from] != to {
                return None;
            }
        }
    }
    Some(images)
}

/// Returns the lengths of the cycles of a permutation, in order, except for the fixed point `without`.
fn cycle_lengths(images: &[usize], without: usize) -> Vec<usize> {
    let mut lengths = Vec::new();
    let mut seen = vec![false; images.len()];
    seen[without] = true;
    for start in 0..images.len() {
        let mut length = 0;
        let mut i = start;
        while !std::mem::replace(&mut seen[i], true) {
            length += 1;
            i = images[i];
        }
        if length > 0 {
            lengths.push(length);
        }
    }
    lengths.sort_unstable();
    lengths
}

/// Returns the number of planar subdivisions with up to this many edges and vertices, by edges and vertices.
pub(super) fn subdivisions(edges: usize, vertices: usize) -> BTreeMap<(usize, usize), u64> {
    let symmetries: Vec<Symmetries> = (0..=edges).map(symmetries).collect();
    let mut contents = Series::one(edges, vertices);
    for _ in 0..vertices {
        let mut components = Series::new(edges, vertices);
        for (e, symmetries) in symmetries.iter().enumerate() {
            let mut sum = Series::new(edges, vertices);
            for ((v, lengths), count) in symmetries {
                let mut product = Series::new(edges, vertices);
                product.add(e, *v, *count);
                for length in lengths {
                    product = product.times(&contents.stretched(*length));
                }
                product.all_terms().for_each(|(e, v, term)| sum.add(e, v, term));
            }
            let names: u128 = (1..=e as u128).map(|i| 2 * i).product();
            sum.all_terms().for_each(|(e, v, term)| components.add(e, v, term / names));
        }
        contents = components.multisets();
    }
    let sizes = (0..=edges).flat_map(|e| (0..=vertices).map(move |v| (e, v)));
    sizes.map(|(e, v)| ((e, v), contents.get(e, v) as u64)).collect()
}

#[cfg(test)]
mod tests {
    use super::subdivisions;

    #[test]
    fn vertices_and_loops_can_be_counted_by_hand() {
        let counts = subdivisions(2, 3);
        // Isolated vertices.
        assert_eq!((0..=3).map(|v| counts[&(0, v)]).collect::<Vec<_>>(), [1, 1, 1, 1]);
        // A loop; a loop and a vertex inside or outside, or an edge; a loop with two more vertices, or an edge with one.
        assert_eq!((0..=3).map(|v| counts[&(1, v)]).collect::<Vec<_>>(), [0, 1, 3, 4]);
        // Two loops at one vertex: side by side, or one inside the other.
        assert_eq!(counts[&(2, 1)], 2);
    }
}
