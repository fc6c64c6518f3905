//! A minimal editor: changes are undone and redone, owners and taxes follow, and ids stay.
//!
//! ```text
//! cargo run -p twinedge-map --example undo_owners_ids
//! ```

use twinedge::dcel::{History, Policy};
use twinedge_map::PlanarMap;
use twinedge_map::edit::EditError;

fn main() -> Result<(), EditError> {
    let mut map = PlanarMap::new();
    // A merged parcel has the id of the larger one.
    let id = map.add_attribute(Policy::of_faces().ids(1).merge_larger());
    let owner = map.add_attribute(Policy::of_faces().split_copy().merge_equal());
    let tax = map.add_attribute(Policy::of_faces().split_share().merge_sum());

    let mut editor = History::new(map);
    editor.change("draw a parcel", |map| {
        let parcel = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?.faces_split[0].1;
        map.set_value(owner, parcel, "Ada")?;
        map.set_value(tax, parcel, 80.0)
    })?;
    let fence = editor.change("divide it", |map| map.insert_segment([1.0, 0.0], [1.0, 4.0]))?;
    let sold = editor.get().find(id, &2).unwrap();
    assert_eq!(editor.get().value(owner, sold), Some(&"Ada"));
    editor.change("sell a part", |map| map.set_value(owner, sold, "Bob"))?;

    // The owners differ, so the policy refuses, and nothing has changed. Once the sale is undone, it accepts.
    assert!(editor.change("merge", |map| map.remove_edge(fence.way[0])).is_err());
    assert_eq!(editor.undo_name(), Some("sell a part"));
    assert!(editor.undo());
    let merged = editor.change("merge", |map| map.remove_edge(fence.way[0]))?.faces_merged[0].0;
    assert_eq!(editor.get().value(tax, merged), Some(&80.0));

    while editor.undo() {}
    assert_eq!(editor.get().dcel().vertex_count(), 0);
    while editor.redo() {}
    println!("parcel {:?} pays {:?}", editor.get().value(id, merged), editor.get().value(tax, merged));
    Ok(())
}
