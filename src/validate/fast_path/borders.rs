//! The border loops that missing twins would make.

use super::starts::Starts;
use crate::validate::columns::NIL;
use crate::validate::structure::View;
use crate::validate::subject::Extent;
use alloc::vec::Vec;

/// A vertex of each border loop. Where the walks across the vertices have found one half-edge without twin that ends at a vertex
/// of the border, and one that leaves it, these follow one another around.
pub(super) fn loops<V: View + ?Sized>(view: &V, extent: Extent, starts: &mut Starts) -> Option<Vec<u32>> {
    let mut into = core::mem::take(&mut starts.into);
    let mut loops = Vec::new();
    for v in 0..into.len().min(extent.vertices.count()) {
        let mut h = core::mem::replace(&mut into[v], NIL);
        if h == NIL {
            continue;
        }
        loops.try_reserve(1).ok()?;
        loops.push(v as u32);
        while h != NIL {
            let before = view.origin(h as usize)?;
            h = core::mem::replace(into.get_mut(before)?, NIL);
        }
    }
    Some(loops)
}
