//! Indices of ids.

use twinedge::validate::adapt::Index;

/// Ids that come twice, or are there, get no second index, and the others follow in the order in which they came.
#[test]
fn an_index_grows_by_what_is_new() {
    let mut index = Index::of(['m', 'b']);
    index.extend(['x', 'd', 'x', 'b', 'a', 'd', 'd']);
    let ids: String = (0..index.len()).map(|i| *index.id(i).unwrap()).collect();
    assert_eq!(ids, "mbxda");
    for (i, id) in ids.chars().enumerate() {
        assert_eq!(index.get(&id), Some(i));
    }
}
