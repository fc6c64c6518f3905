//! Tests of `issuer`.

use super::Issuer;
use crate::store::keys::{VertexKey, parts};
use quickcheck::quickcheck;
use slotmap::SlotMap;

/// Issues a key for each even step, and retires a live key for each odd step, here and in a `SlotMap`.
fn issues_the_keys_of_slotmap(steps: Vec<u8>) -> bool {
    let (mut map, mut issuer) = (SlotMap::<VertexKey, ()>::with_key(), Issuer::with_room(0, 0));
    let (mut live, mut retired): (Vec<VertexKey>, Vec<VertexKey>) = (Vec::new(), Vec::new());
    steps.into_iter().all(|step| {
        let chosen = usize::from(step / 2).checked_rem(live.len()).filter(|_| step % 2 == 1);
        if let Some(chosen) = chosen {
            let key = live.swap_remove(chosen);
            map.remove(key);
            issuer.retire(parts(key).0);
            retired.push(key);
        } else {
            live.push(map.insert(()));
            issuer.issue();
        }
        let shown = |key: &VertexKey| issuer.generation(parts(*key).0) == parts(*key).1;
        issuer.len() == map.len() && live.iter().all(shown) && !retired.iter().any(shown)
    })
}

quickcheck! {
    fn an_issuer_issues_the_keys_of_slotmap(steps: Vec<u8>) -> bool {
        issues_the_keys_of_slotmap(steps)
    }
}
