//! Border loops made of missing twins.

use super::starts::Starts;
use crate::validate::columns::NIL;
use crate::validate::structure::View;
use crate::validate::subject::Extent;
use alloc::vec::Vec;

/// Returns a vertex of each border loop. At a vertex of the border, a half-edge without twin that ends there is followed by the
/// one that leaves it.
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
