//! All small triangulations, as lists of triangles, made without half-edges: by exchanging the diagonals of quadrilaterals.

use std::collections::{BTreeMap, BTreeSet};
use twinedge::program::{Call, Corner, Handle, Refusal, Subject};

/// A simple triangulation of the sphere or of a disc: no loops, no two edges between the same vertices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Triangulation {
    /// The number of vertices.
    pub vertices: usize,
    /// The triangles, counter-clockwise, by their vertices.
    pub triangles: Vec<[usize; 3]>,
}

/// The vertex opposite to the left of each directed edge.
type Opposite = BTreeMap<(usize, usize), usize>;

impl Triangulation {
    fn opposite(&self) -> Opposite {
        let sides = self.triangles.iter().flat_map(|&[a, b, c]| [((a, b), c), ((b, c), a), ((c, a), b)]);
        sides.collect()
    }

    /// Returns the directed edges that can be roots of the triangulation: the border edges, or all without a border.
    fn roots(opposite: &Opposite) -> Vec<(usize, usize)> {
        let border = || opposite.keys().copied().filter(|(a, b)| !opposite.contains_key(&(*b, *a)));
        if border().next().is_some() { border().collect() } else { opposite.keys().copied().collect() }
    }

    /// Returns the triangles with the vertices named in the order met from a root: the same for isomorphic ones.
    fn rooted(opposite: &Opposite, root: (usize, usize)) -> Vec<[usize; 3]> {
        let mut names = BTreeMap::from([(root.0, 0), (root.1, 1)]);
        let mut queue = vec![root];
        let mut done = BTreeSet::new();
        let mut code = Vec::new();
        let mut at = 0;
        while let Some((a, b)) = queue.get(at).copied() {
            at += 1;
            let Some(c) = opposite.get(&(a, b)).copied().filter(|_| !done.contains(&(a, b))) else { continue };
            done.extend([(a, b), (b, c), (c, a)]);
            let next = names.len();
            names.entry(c).or_insert(next);
            code.push([a, b, c].map(|v| names[&v]));
            queue.extend([(c, b), (a, c), (b, a)]);
        }
        code
    }

    fn codes(&self) -> BTreeSet<Vec<[usize; 3]>> {
        let opposite = self.opposite();
        Self::roots(&opposite).into_iter().map(|root| Self::rooted(&opposite, root)).collect()
    }

    fn mirrored(&self) -> Self {
        Self { vertices: self.vertices, triangles: self.triangles.iter().map(|&[a, b, c]| [a, c, b]).collect() }
    }

    /// Returns the triangulations with one inner edge exchanged for the other diagonal, unless that edge exists already.
    fn exchanges(&self) -> Vec<Self> {
        let opposite = self.opposite();
        let mut all = Vec::new();
        for ((a, b), c) in &opposite {
            let Some(d) = opposite.get(&(*b, *a)).filter(|_| a < b) else { continue };
            if c == d || opposite.contains_key(&(*c, *d)) || opposite.contains_key(&(*d, *c)) {
                continue;
            }
            let has = |t: &[usize; 3]| t.contains(a) && t.contains(b);
            let mut triangles: Vec<_> = self.triangles.iter().copied().filter(|t| !has(t)).collect();
            triangles.extend([[*d, *c, *a], [*c, *d, *b]]);
            all.push(Self { vertices: self.vertices, triangles });
        }
        all
    }

    /// Returns a fan: `outer` vertices on the border, and `inner` ones put into its last triangle, one after the other.
    fn fan(outer: usize, inner: usize) -> Self {
        let mut triangles: Vec<_> = (2..outer).map(|k| [0, k - 1, k]).collect();
        for v in outer..outer + inner {
            let [a, b, c] = triangles.pop().unwrap_or([0, 1, 2]);
            triangles.extend([[a, b, v], [b, c, v], [c, a, v]]);
        }
        Self { vertices: outer + inner, triangles }
    }
}

#[derive(Debug)]
pub(super) struct All {
    /// One of each class of isomorphic ones; mirror images are different.
    pub(super) maps: Vec<Triangulation>,
    pub(super) rooted: u64,
    /// The number of unrooted ones, with mirror images taken together.
    pub(super) unrooted: u64,
}

/// Returns the triangulations that result from one by exchanging diagonals.
fn all(first: Triangulation) -> All {
    let mut rooted = BTreeSet::new();
    let mut classes = BTreeSet::new();
    let mut maps: Vec<Triangulation> = Vec::new();
    let mut queue = vec![first];
    while let Some(map) = queue.pop() {
        let codes = map.codes();
        let Some(least) = codes.first().filter(|code| !rooted.contains(*code)).cloned() else { continue };
        rooted.extend(codes);
        let mirrored = map.mirrored().codes().pop_first().unwrap_or_default();
        classes.insert(least.min(mirrored));
        queue.extend(map.exchanges());
        maps.push(map);
    }
    All { maps, rooted: rooted.len() as u64, unrooted: classes.len() as u64 }
}

/// Returns all triangulations of the sphere with this many vertices, 3 or more.
pub(super) fn of_sphere(vertices: usize) -> All {
    let mut first = Triangulation::fan(3, vertices - 3);
    first.triangles.push([0, 2, 1]);
    all(first)
}

/// Returns all triangulations of the disc with these numbers of vertices on the border, 3 or more, and inside.
pub(super) fn of_disc(outer: usize, inner: usize) -> All {
    all(Triangulation::fan(outer, inner))
}

/// Builds a triangulated disc on the empty map. The unbounded face is outside.
///
/// A disc can be shelled from any triangle: there is always another triangle that shares with the earlier ones either one edge
/// and not the third vertex, or two edges (Danaraj and Klee, *Which spheres are shellable?*, 1978).
///
/// # Errors
/// The refusal of the structure; [`Refusal::NotDisc`] if the triangles are no disc.
pub(super) fn build<K: Subject>(subject: &mut K, disc: &Triangulation) -> Result<(), Refusal> {
    let mut edges: BTreeMap<(usize, usize), K::HalfEdge> = BTreeMap::new();
    let mut rest = disc.triangles.clone();
    let [a, b, c] = rest.pop().ok_or(Refusal::NotDisc)?;
    let face = subject.unbounded_face().ok_or(Refusal::NotDisc)?;
    let Some(Handle::Vertex(v)) = subject.apply(Call::AddIsolatedVertex { face })? else {
        return Err(Refusal::Unsupported);
    };
    let ab = subject.make_edge(Call::SplitVertex { from: Corner::Isolated(v), to: Corner::Isolated(v) })?;
    let ba = subject.twin_of(ab)?;
    let bc = subject.make_edge(Call::SplitVertex { from: Corner::At(ba), to: Corner::At(ba) })?;
    let cb = subject.twin_of(bc)?;
    let ca = subject.make_edge(Call::connect(Corner::At(cb), Corner::At(ab)))?;
    for (ends, h) in [((a, b), ab), ((b, c), bc), ((c, a), ca)] {
        edges.insert(ends, h);
        edges.insert((ends.1, ends.0), subject.twin_of(h)?);
    }
    while !rest.is_empty() {
        let has_vertex = |v: usize| edges.keys().any(|(from, _)| *from == v);
        // A triangle xyw whose side xy, and perhaps yw, exists, but no other.
        let turns = |[a, b, c]: [usize; 3]| [[a, b, c], [b, c, a], [c, a, b]];
        let fits = |[x, y, w]: [usize; 3]| {
            let there = [(x, y), (y, w), (w, x)].map(|side| edges.contains_key(&side));
            there == [true, true, false] || (there == [true, false, false] && !has_vertex(w))
        };
        let place = rest.iter().position(|triangle| turns(*triangle).into_iter().any(fits)).ok_or(Refusal::NotDisc)?;
        let [x, y, w] = turns(rest.swap_remove(place)).into_iter().find(|turn| fits(*turn)).ok_or(Refusal::NotDisc)?;
        let xy = edges[&(x, y)];
        if let Some(yw) = edges.get(&(y, w)).copied() {
            let after = subject.next_of(yw)?;
            let wx = subject.make_edge(Call::connect(Corner::At(after), Corner::At(xy)))?;
            edges.insert((w, x), wx);
            edges.insert((x, w), subject.twin_of(wx)?);
        } else {
            let xw = subject.make_edge(Call::SplitVertex { from: Corner::At(xy), to: Corner::At(xy) })?;
            let wx = subject.twin_of(xw)?;
            let after = subject.next_of(xy)?;
            let yw = subject.make_edge(Call::connect(Corner::At(after), Corner::At(wx)))?;
            edges.extend([((x, w), xw), ((w, x), wx), ((y, w), yw), ((w, y), subject.twin_of(yw)?)]);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{of_disc, of_sphere};
    use crate::published::{brown, spheres, tutte};

    #[test]
    fn there_are_as_many_triangulations_as_published() {
        for vertices in 3..=8 {
            let all = of_sphere(vertices);
            assert_eq!((Some(all.unrooted), Some(all.rooted)), (spheres(vertices), tutte(vertices)), "{vertices}");
        }
        for outer in 3..=6 {
            for inner in 0..=7 - outer {
                assert_eq!(Some(of_disc(outer, inner).rooted), brown(outer, inner), "{outer} + {inner}");
            }
        }
    }
}
