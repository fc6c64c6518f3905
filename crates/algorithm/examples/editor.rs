//! The core of an editor of parcels: splits a parcel by a line, moves a corner shared by two, merges two, undoes and redoes
//! everything, and saves and loads it. Each step is validated in time proportional to its size.
//!
//! Owners and taxes are attributes of faces. Both parts of a split parcel inherit its owners, and its tax is divided by area; a
//! merged parcel has the owners of both, and the sum. Each parcel has a permanent number. Undoing restores the old values.
//!
//! ```text
//! cargo run -p twinedge-algorithm --example editor
//! ```

use std::error::Error;
use twinedge::dcel::{Attribute, FaceKey, Faces, History, Policy, SecondaryMap};
use twinedge::validate::Expectation;
use twinedge_algorithm::area::face_area;
use twinedge_map::PlanarMap;
use twinedge_map::edit::EditError;
use twinedge_map::near::{EmbeddingBaseline, validate_embedding_near};

type Outcome<T> = Result<T, Box<dyn Error>>;
type Values<T> = SecondaryMap<FaceKey, T>;

struct Editor {
    history: History<PlanarMap>,
    baseline: EmbeddingBaseline,
    number: Attribute<Faces, u64>,
    owners: Attribute<Faces, String>,
    tax: Attribute<Faces, f64>,
}

/// The owners of both parts of a merged parcel.
fn owners() -> Policy<Faces, String> {
    Policy::of_faces().split_copy().merge_with(|kept: Option<String>, dropped| match (kept, dropped) {
        (Some(kept), Some(dropped)) if kept == dropped => Ok(Some(kept)),
        (Some(kept), Some(dropped)) => Ok(Some(format!("{kept} and {dropped}"))),
        (None, None) => Ok(None),
        _ => Err("nobody owns what is outside"),
    })
}

impl Editor {
    /// Takes an existing map and numbers its parcels.
    fn new(mut map: PlanarMap) -> Outcome<Self> {
        let number = map.add_attribute(Policy::of_faces().ids(1));
        let owners = map.add_attribute(owners());
        let tax = map.add_attribute(Policy::of_faces().split_share().merge_sum());
        let baseline = EmbeddingBaseline::new(&map, &Expectation::plane())?;
        Ok(Self { history: History::new(map), baseline, number, owners, tax })
    }

    fn edit<T>(&mut self, name: &'static str, edit: impl FnOnce(&mut PlanarMap) -> Result<T, EditError>) -> Outcome<T> {
        let edited = self.history.change(name, edit)?;
        validate_embedding_near(&mut self.baseline, self.history.get(), &self.history.written())?;
        Ok(edited)
    }

    fn step(&mut self, step: fn(&mut History<PlanarMap>) -> bool) -> Outcome<bool> {
        let done = step(&mut self.history);
        validate_embedding_near(&mut self.baseline, self.history.get(), &self.history.written())?;
        Ok(done)
    }

    /// Returns the owners, the area and the tax of each parcel, sorted by owners.
    fn parcels(&self) -> Outcome<Vec<(String, f64, f64)>> {
        let map = self.history.get();
        let mut parcels = Vec::new();
        for (parcel, owners) in map.values(self.owners).into_iter().flatten() {
            let tax = map.value(self.tax, parcel).copied().unwrap_or_default();
            parcels.push((owners.clone(), face_area(map, parcel)?, tax));
        }
        parcels.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        Ok(parcels)
    }
}

/// Returns the parcels in order, rounded: the cut crosses two sides where there is no exact double.
fn rounded(parcels: Vec<(String, f64, f64)>) -> Vec<(String, f64, f64)> {
    let round = |x: f64| (x * 1e6).round() / 1e6;
    parcels.into_iter().map(|(owners, area, tax)| (owners, round(area), round(tax))).collect()
}

fn main() -> Outcome<()> {
    let mut drawn = PlanarMap::new();
    let parcel = drawn.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?.faces_split[0].1;
    let mut editor = Editor::new(drawn)?;
    let (number, owners, tax) = (editor.number, editor.owners, editor.tax);
    assert_eq!(editor.history.get().find(number, &1), Some(parcel));
    editor.edit("enter the owner", |map| {
        map.set_value(owners, parcel, "Ada")?;
        map.set_value(tax, parcel, 160.0)
    })?;

    // Any line through the parcel, at any slant.
    let cut = editor.edit("split it", |map| map.split_face(parcel, [0.5, -1.0], [0.8, 0.1]))?;
    let (kept, made) = cut.faces_split[0];
    let shares = rounded(editor.parcels()?);
    println!("divided: {shares:?}");
    assert_eq!((shares[0].1 + shares[1].1, shares[0].2 + shares[1].2), (16.0, 160.0));
    assert_eq!(editor.history.get().find(number, &2), Some(made));

    editor.edit("sell a part", |map| map.set_value(owners, made, "Bob"))?;
    editor.edit("move a corner", |map| map.move_vertex(cut.vertices[0], [2.0, -1.0]))?;
    let divided = editor.parcels()?;

    // The policy refuses, and nothing has changed.
    let outside = editor.history.get().dcel().unbounded_face().key();
    assert!(editor.edit("open to the outside", |map| map.merge_faces(made, outside)).is_err());
    assert_eq!(editor.parcels()?, divided);

    // The ends of the fence are vertices of degree 2 then. The moved end is a real corner, the other one is dropped.
    editor.edit("merge the two", |map| {
        let merged = map.merge_faces(kept, made)?;
        let straight = merged.vertices.into_iter().filter(|v| *v != cut.vertices[0]);
        straight.map(|v| map.join_edges(v)).collect::<Result<Vec<_>, EditError>>()
    })?;
    let merged = editor.parcels()?;
    println!("merged: {merged:?}");
    assert_eq!((merged[0].0.as_str(), merged[0].1, merged[0].2.round()), ("Ada and Bob", 18.0, 160.0));
    assert_eq!(editor.history.get().dcel().vertex_count(), 5);

    println!("undo: {}", editor.history.undo_name().unwrap_or("nothing"));
    assert!(editor.step(History::undo)?);
    assert_eq!(editor.parcels()?, divided);
    while editor.step(History::undo)? {}
    assert_eq!((editor.parcels()?.len(), editor.history.get().dcel().vertex_count()), (0, 4));
    while editor.step(History::redo)? {}
    assert_eq!(editor.parcels()?, merged);

    // Saved and loaded: the map, the values by key, and the number of the next parcel.
    let map = editor.history.get();
    let saved = serde_json::to_string(&(map, map.next_id(number), map.values(number), map.values(owners)))?;
    let (mut map, next, numbers, names): (PlanarMap, u64, Values<u64>, Values<String>) = serde_json::from_str(&saved)?;
    let number = map.add_attribute_with(Policy::of_faces().ids(next), numbers);
    let owners = map.add_attribute_with(self::owners(), names);
    let first = map.find(number, &1).ok_or("parcel 1 is lost")?;
    assert_eq!((map.value(owners, first).map(String::as_str), map.next_id(number)), (Some("Ada and Bob"), Some(3)));
    Ok(())
}
