//! The core of an editor of parcels: one is split by a line, a corner that two share is moved, two are merged, and all of it is undone
//! and redone. Each step is validated in its own time.
//!
//! Owners and taxes are attributes of faces. Both parts of a split parcel have its owners, and its tax is shared out by area; a merged parcel
//! has the owners of both, and the sum. Each parcel has a number for good. Undoing brings back what was.
//!
//! ```text
//! cargo run --example editor
//! ```

use std::collections::BTreeSet;
use std::error::Error;
use twinedge::algorithm::area::face_area;
use twinedge::dcel::{Attribute, Faces, Policy};
use twinedge::map::edit::EditError;
use twinedge::map::{History, PlanarMap};
use twinedge::validate::Expectation;
use twinedge::validate::near::{EmbeddingBaseline, validate_embedding_near};

type Outcome<T> = Result<T, Box<dyn Error>>;
type Owners = BTreeSet<&'static str>;

struct Editor {
    history: History,
    baseline: EmbeddingBaseline,
    number: Attribute<Faces, u64>,
    owners: Attribute<Faces, Owners>,
    tax: Attribute<Faces, f64>,
}

impl Editor {
    fn new() -> Outcome<Self> {
        let mut map = PlanarMap::new();
        let number = map.add_attribute(Policy::of_faces().ids(1));
        let owners =
            map.add_attribute(Policy::of_faces().split_copy().merge_with(|kept: Option<Owners>, dropped| {
                match (kept, dropped) {
                    (Some(kept), Some(dropped)) => Ok(Some(&kept | &dropped)),
                    (None, None) => Ok(None),
                    _ => Err("nobody owns what is outside"),
                }
            }));
        let tax = map.add_attribute(Policy::of_faces().split_share().merge_sum());
        let baseline = EmbeddingBaseline::new(&map, &Expectation::plane())?;
        Ok(Self { history: History::new(map), baseline, number, owners, tax })
    }

    fn edit<T>(&mut self, name: &'static str, edit: impl FnOnce(&mut PlanarMap) -> Result<T, EditError>) -> Outcome<T> {
        let edited = self.history.change(name, edit)?;
        validate_embedding_near(&mut self.baseline, self.history.get(), &self.history.written())?;
        Ok(edited)
    }

    fn step(&mut self, step: fn(&mut History) -> bool) -> Outcome<bool> {
        let done = step(&mut self.history);
        validate_embedding_near(&mut self.baseline, self.history.get(), &self.history.written())?;
        Ok(done)
    }

    /// The owners, the area and the tax of each parcel, in the order of their owners.
    fn parcels(&self) -> Outcome<Vec<(String, f64, f64)>> {
        let map = self.history.get();
        let mut parcels = Vec::new();
        for (parcel, owners) in map.values(self.owners).into_iter().flatten() {
            let names = owners.iter().copied().collect::<Vec<_>>().join(" and ");
            parcels.push((names, face_area(map, parcel)?, map.value(self.tax, parcel).copied().unwrap_or_default()));
        }
        parcels.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        Ok(parcels)
    }
}

fn main() -> Outcome<()> {
    let mut editor = Editor::new()?;
    let (number, owners, tax) = (editor.number, editor.owners, editor.tax);
    let parcel = editor.edit("draw a parcel", |map| {
        let parcel = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?;
        map.set_value(owners, parcel.faces_split[0].1, Owners::from(["Ada"]))?;
        map.set_value(tax, parcel.faces_split[0].1, 160.0)?;
        Ok(parcel)
    })?;
    let fence = editor.edit("split it", |map| map.insert_segment([1.0, 0.0], [3.0, 4.0]))?;
    assert_eq!(editor.parcels()?, [("Ada".into(), 8.0, 80.0), ("Ada".into(), 8.0, 80.0)]);
    let sold = fence.faces_split[0].1;
    editor.edit("sell a part", |map| map.set_value(owners, sold, Owners::from(["Bob"])))?;
    let corner = fence.vertices[0];
    editor.edit("move a corner", |map| map.move_vertex(corner, [2.0, -1.0]))?;
    let divided = editor.parcels()?;
    println!("divided: {divided:?}");
    // Ada's part is (2, -1), (4, 0), (4, 4), (3, 4), and Bob's (0, 0), (2, -1), (3, 4), (0, 4).
    assert_eq!(divided, [("Ada".into(), 6.5, 80.0), ("Bob".into(), 11.5, 80.0)]);

    // The policy refuses, and nothing has changed.
    assert!(editor.edit("open to the outside", |map| map.remove_edge(parcel.way[1])).is_err());
    assert_eq!(editor.parcels()?, divided);
    editor.edit("merge the two", |map| map.remove_edge(fence.way[0]))?;
    let merged = editor.parcels()?;
    println!("merged: {merged:?}");
    assert_eq!(merged, [("Ada and Bob".into(), 18.0, 160.0)]);

    println!("undo: {}", editor.history.undo_name().unwrap_or("nothing"));
    assert!(editor.step(History::undo)?);
    assert_eq!(editor.parcels()?, divided);
    while editor.step(History::undo)? {}
    assert_eq!((editor.parcels()?.len(), editor.history.get().dcel().vertex_count()), (0, 0));
    while editor.step(History::redo)? {}
    assert_eq!(editor.parcels()?, merged);
    let map = editor.history.get();
    let [first, second] = [1, 2].map(|parcel| map.find(number, &parcel));
    println!("parcel 1: {:?}, parcel 2: {:?}", first.map(|face| map.value(owners, face)), second);
    // One of both numbers is left, on the face that the merging kept.
    assert_ne!(first.is_some(), second.is_some());
    Ok(())
}
