//! The core of an editor of parcels: one is split by a line, a corner that two share is moved, two are merged, and all of it is undone
//! and redone. Each step is validated in its own time.
//!
//! Owners are features of the map. So both parts of a split parcel have its owner, and undoing brings owners back. Areas are kept beside
//! the map by face, and those of the faces that a step wrote are computed again.
//!
//! ```text
//! cargo run --example editor
//! ```

use std::collections::{BTreeSet, HashMap};
use std::error::Error;
use twinedge::algorithm::area::face_area;
use twinedge::dcel::{FaceKey, HalfEdgeKey};
use twinedge::map::{FeatureId, History, PlanarMap};
use twinedge::validate::Expectation;
use twinedge::validate::near::{EmbeddingBaseline, validate_embedding_near};

type Outcome<T> = Result<T, Box<dyn Error>>;

struct Editor {
    history: History,
    baseline: EmbeddingBaseline,
    areas: HashMap<FaceKey, f64>,
}

impl Editor {
    fn edit<T>(&mut self, name: &'static str, edit: impl FnOnce(&mut PlanarMap) -> Outcome<T>) -> Outcome<T> {
        let edited = self.history.change(name, edit)?;
        self.follow()?;
        Ok(edited)
    }

    fn step(&mut self, step: fn(&mut History) -> bool) -> Outcome<bool> {
        let done = step(&mut self.history);
        self.follow()?;
        Ok(done)
    }

    /// Validates what the last step wrote, and computes the areas of the faces there.
    fn follow(&mut self) -> Outcome<()> {
        let (map, written) = (self.history.get(), self.history.written());
        validate_embedding_near(&mut self.baseline, map, &written)?;
        let dcel = map.dcel();
        let around = written.vertices.iter().filter_map(|v| dcel.vertex_at(*v)).flat_map(|v| v.rotation());
        let half_edges = written.half_edges.iter().filter_map(|h| dcel.half_edge_at(*h)).chain(around);
        let boundaries = written.boundaries.iter().filter_map(|b| dcel.boundary_at(*b));
        let faces = written.faces.iter().filter_map(|f| dcel.face_at(*f));
        for f in faces.chain(half_edges.map(|h| h.face())).chain(boundaries.map(|b| b.face())) {
            self.areas.insert(f.key(), face_area(map, f.key())?);
        }
        Ok(())
    }

    /// The owners and the area of each parcel, in the order of their owners.
    fn parcels(&self) -> Vec<(String, f64)> {
        let map = self.history.get();
        let owners =
            |f| map.features_of(f).into_iter().flatten().filter_map(|owner| map.name(owner)).collect::<Vec<_>>();
        let faces = map.dcel().faces().filter(|f| !f.is_unbounded()).map(|f| f.key());
        let mut parcels: Vec<_> = faces.map(|f| (owners(f).join(" and "), self.areas[&f])).collect();
        parcels.sort_by(|a, b| a.0.cmp(&b.0));
        parcels
    }
}

/// Removes a fence. What it divided belongs to the owners of both sides.
fn merge(map: &mut PlanarMap, fence: &[HalfEdgeKey]) -> Outcome<()> {
    for h in fence {
        let sides = [map.dcel().half_edge(*h)?, map.dcel().half_edge(*h)?.twin()].map(|h| h.face().key());
        let owners: BTreeSet<FeatureId> = map.features_of(sides[0])?.chain(map.features_of(sides[1])?).collect();
        for (kept, _) in map.remove_edge(*h)?.faces_merged {
            if map.dcel().face(kept)?.is_unbounded() {
                return Err("nobody owns what is outside".into());
            }
            map.set_features_of(kept, owners.iter().copied())?;
        }
    }
    Ok(())
}

fn main() -> Outcome<()> {
    let map = PlanarMap::new();
    let baseline = EmbeddingBaseline::new(&map, &Expectation::plane())?;
    let mut editor = Editor { history: History::new(map), baseline, areas: HashMap::new() };

    let parcel = editor.edit("draw a parcel", |map| {
        let parcel = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?;
        let ada = map.add_feature(Some("Ada".into()));
        map.set_features_of(parcel.faces_split[0].1, [ada])?;
        Ok(parcel)
    })?;
    let fence = editor.edit("split it", |map| Ok(map.insert_segment([1.0, 0.0], [3.0, 4.0])?))?;
    assert_eq!(editor.parcels(), [("Ada".into(), 8.0), ("Ada".into(), 8.0)]);
    editor.edit("sell a part", |map| {
        let bob = map.add_feature(Some("Bob".into()));
        Ok(map.set_features_of(fence.faces_split[0].1, [bob])?)
    })?;
    let corner = fence.vertices[0];
    editor.edit("move a corner", |map| Ok(map.move_vertex(corner, [2.0, -1.0])?))?;
    let divided = editor.parcels();
    println!("divided: {divided:?}");
    // Ada's part is (2, -1), (4, 0), (4, 4), (3, 4), and Bob's (0, 0), (2, -1), (3, 4), (0, 4).
    assert_eq!(divided, [("Ada".into(), 6.5), ("Bob".into(), 11.5)]);

    // An error takes the whole change back, the edge that it removed included.
    assert!(editor.edit("open to the outside", |map| merge(map, &parcel.way[1..2])).is_err());
    assert_eq!(editor.parcels(), divided);
    editor.edit("merge the two", |map| merge(map, &fence.way))?;
    let merged = editor.parcels();
    println!("merged: {merged:?}");
    assert_eq!(merged, [("Ada and Bob".into(), 18.0)]);

    println!("undo: {}", editor.history.undo_name().unwrap_or("nothing"));
    assert!(editor.step(History::undo)?);
    assert_eq!(editor.parcels(), divided);
    while editor.step(History::undo)? {}
    assert_eq!((editor.parcels().len(), editor.history.get().dcel().vertex_count()), (0, 0));
    while editor.step(History::redo)? {}
    assert_eq!(editor.parcels(), merged);
    Ok(())
}
