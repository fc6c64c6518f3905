//! Tests of `keys`.

use super::{VertexKey, key, parts};
use slotmap::SlotMap;

#[test]
fn slot_and_generation_stand_where_this_crate_looks_for_them() {
    let mut map: SlotMap<VertexKey, ()> = SlotMap::with_key();
    let first = map.insert(());
    let second = map.insert(());
    assert_eq!((parts(first), parts(second)), ((1, 1), (2, 1)));
    map.remove(first);
    let again = map.insert(());
    assert_eq!(parts(again).0, 1);
    assert!(parts(again).1 > 1 && parts(again).1 % 2 == 1);
    assert_eq!(key::<VertexKey>(parts(again).0, parts(again).1), again);
}
