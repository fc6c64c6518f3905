//! A triangulated disc on a structure of planar maps, triangle by triangle, by the basic operators.

use super::triangulations::Triangulation;
use std::collections::BTreeMap;
use twinedge::program::{Call, Corner, Handle, Refusal, Subject};

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
