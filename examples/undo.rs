//! The core of an editor of parcels: one is split by a line, two are merged, a corner is moved, and all of it is undone and redone.
//! Owners follow, and what was written is validated after each step.
//!
//! ```text
//! cargo run --example undo
//! ```

use std::collections::HashMap;
use std::error::Error;
use twinedge::dcel::FaceKey;
use twinedge::map::edit::{EditError, Edited};
use twinedge::map::{History, PlanarMap};
use twinedge::validate::Expectation;
use twinedge::validate::near::{EmbeddingBaseline, validate_embedding_near};

struct Editor {
    history: History,
    baseline: EmbeddingBaseline,
    /// Of all faces that there are or were: whoever is undone to is still here.
    owners: HashMap<FaceKey, &'static str>,
}

impl Editor {
    fn edit(
        &mut self,
        name: &'static str,
        edit: impl FnOnce(&mut PlanarMap) -> Result<Edited, EditError>,
    ) -> Result<Edited, Box<dyn Error>> {
        let edited = self.history.change(name, edit)?;
        for (kept, made) in &edited.faces_split {
            self.owners.extend(self.owners.get(kept).copied().map(|owner| (*made, owner)));
        }
        self.validate()?;
        Ok(edited)
    }

    fn step(&mut self, step: fn(&mut History) -> bool) -> Result<bool, Box<dyn Error>> {
        let done = step(&mut self.history);
        self.validate()?;
        Ok(done)
    }

    fn validate(&mut self) -> Result<(), Box<dyn Error>> {
        Ok(validate_embedding_near(&mut self.baseline, self.history.get(), &self.history.written())?)
    }

    /// The owners of what there is now.
    fn owned(&self) -> Vec<&'static str> {
        let mut owned: Vec<_> =
            self.history.get().dcel().faces().filter_map(|f| self.owners.get(&f.key()).copied()).collect();
        owned.sort_unstable();
        owned
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let map = PlanarMap::new();
    let baseline = EmbeddingBaseline::new(&map, &Expectation::plane())?;
    let mut editor = Editor { history: History::new(map), baseline, owners: HashMap::new() };
    let parcel =
        editor.edit("draw a parcel", |map| map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]))?;
    editor.owners.insert(parcel.faces_split[0].1, "Ada");
    let fence = editor.edit("split it", |map| map.insert_segment([1.0, 0.0], [3.0, 4.0]))?;
    editor.owners.insert(fence.faces_split[0].1, "Bob");
    editor.edit("move a corner", |map| map.move_vertex(parcel.vertices[1], [5.0, -1.0]).map(|()| Edited::default()))?;
    assert_eq!(editor.owned(), ["Ada", "Bob"]);
    editor.edit("merge the two", |map| map.remove_edge(fence.way[0]))?;
    assert_eq!(editor.owned().len(), 1);

    println!("undo: {}", editor.history.undo_name().unwrap_or("nothing"));
    assert!(editor.step(History::undo)?);
    assert_eq!(editor.owned(), ["Ada", "Bob"]);
    while editor.step(History::undo)? {}
    assert_eq!((editor.owned().len(), editor.history.get().dcel().vertex_count()), (0, 0));
    while editor.step(History::redo)? {}
    assert_eq!(editor.owned().len(), 1);
    println!("redone: the parcel of {} has {} corners", editor.owned()[0], editor.history.get().dcel().vertex_count());
    Ok(())
}
