//! Differences of maps by ids: applied, merged, saved.

mod apart;
mod applied;
mod merged;

use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::{Attribute, Edges, Face, FaceKey, Faces, HalfEdge, Policy, VertexKey, Vertices};
use twinedge_map::diff::Ids;
use twinedge_map::program::{EditProgram, EditRunner};
use twinedge_map::{FeatureId, PlanarMap};

/// The attributes of the maps of these tests.
#[derive(Clone, Copy)]
struct Named {
    corner: Attribute<Vertices, u64>,
    parcel: Attribute<Faces, u128>,
    height: Attribute<Vertices, f64>,
    owner: Attribute<Faces, String>,
    fence: Attribute<Edges, u32>,
    /// Not compared.
    note: Attribute<Faces, u32>,
}

impl Named {
    fn of(map: &mut PlanarMap) -> Self {
        let next = std::sync::atomic::AtomicU64::new(1);
        let number = move || u128::from(next.fetch_add(1, std::sync::atomic::Ordering::Relaxed));
        let parcel = map.add_attribute(Policy::of_faces().make_with(number).split_make().identified_by(|id| *id));
        map.set_value(parcel, map.dcel().unbounded_face().key(), 0_u128).unwrap();
        Self {
            corner: map.add_attribute(Policy::of_vertices().ids(1)),
            parcel,
            height: map.add_attribute(Policy::of_vertices().make_default().interpolate()),
            owner: map.add_attribute(Policy::of_faces().split_copy()),
            fence: map.add_attribute(Policy::of_edges().split_copy()),
            note: map.add_attribute(Policy::of_faces()),
        }
    }

    fn ids(self) -> Ids {
        Ids::new(self.corner, self.parcel)
            .values("height", self.height, f64::to_string, |text| text.parse().ok())
            .values("owner", self.owner, String::clone, |text| Some(text.into()))
            .values("fence", self.fence, u32::to_string, |text| text.parse().ok())
    }

    fn v(self, map: &PlanarMap, id: u64) -> VertexKey {
        map.find(self.corner, &id).unwrap()
    }

    fn f(self, map: &PlanarMap, id: u128) -> FaceKey {
        map.find(self.parcel, &id).unwrap()
    }

    /// The complete contents of a map, by ids.
    fn told(self, map: &PlanarMap) -> Told {
        let id = |v: VertexKey| *map.value(self.corner, v).unwrap();
        let vertices = map.dcel().vertices().map(|v| {
            let p = map[v.key()];
            (id(v.key()), format!("{p:?} {:?}", map.value(self.height, v.key())))
        });
        let edges = map.dcel().edges().map(|h| {
            let ends = [h.origin(), h.target()].map(|v| id(v.key()));
            let features: Vec<FeatureId> = map.features_along(h.key()).unwrap().collect();
            ((ends[0].min(ends[1]), ends[0].max(ends[1])), format!("{features:?} {:?}", map.value(self.fence, h.key())))
        });
        let faces = map.dcel().faces().map(|f| {
            let around: BTreeSet<_> = f.half_edges().map(|h| (id(h.origin().key()), id(h.target().key()))).collect();
            let isolated: BTreeSet<_> = f.inner().filter_map(|b| b.isolated_vertex()).map(|v| id(v.key())).collect();
            let features: Vec<FeatureId> = map.features_of(f.key()).unwrap().collect();
            let owner = map.value(self.owner, f.key());
            (*map.value(self.parcel, f.key()).unwrap(), format!("{around:?} {isolated:?} {features:?} {owner:?}"))
        });
        Told {
            vertices: vertices.collect(),
            edges: edges.collect(),
            faces: faces.collect(),
            features: map.features().count(),
        }
    }
}

#[derive(Debug, PartialEq)]
struct Told {
    vertices: BTreeMap<u64, String>,
    edges: BTreeMap<(u64, u64), String>,
    faces: BTreeMap<u128, String>,
    features: usize,
}

/// Runs a program, and after each edit assigns values to records chosen by the number of the edit.
fn edited(map: PlanarMap, by: Named, program: &EditProgram) -> PlanarMap {
    let mut runner = EditRunner::new(map);
    for (i, op) in program.0.iter().enumerate() {
        runner.step(op);
        let mut map = runner.into_map();
        let nth = |count: usize| i * 7 % count.max(1);
        let face = map.dcel().faces().map(Face::key).nth(nth(map.dcel().face_count())).unwrap();
        map.set_value(by.owner, face, format!("owner {i}")).unwrap();
        let edge = map.dcel().edges().map(HalfEdge::key).nth(nth(map.dcel().edge_count()));
        if let Some(h) = edge {
            map.set_value(by.fence, h, u32::try_from(i).unwrap()).unwrap();
        }
        runner = EditRunner::new(map);
    }
    runner.into_map()
}

/// Two squares side by side: vertices 1 2 3 4, 5 6, faces 1 and 2.
///
/// ```text
///     4 ── 3 ── 6      y = 4
///     │ 1  │ 2  │
///     1 ── 2 ── 5      y = 0
/// ```
fn two_squares() -> (PlanarMap, Named) {
    let mut map = PlanarMap::new();
    let by = Named::of(&mut map);
    let square = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]).unwrap();
    let [.., b, c, _] = square.vertices[..] else { unreachable!() };
    let [d, e] = [[8.0, 0.0], [8.0, 4.0]].map(|p| map.insert_point(p).unwrap().vertices[0]);
    for (from, to) in [(b, d), (d, e), (e, c)] {
        map.insert_segment(from, to).unwrap();
    }
    map.add_feature(Some("wood".into()));
    assert_eq!(by.told(&map).faces.keys().collect::<Vec<_>>(), [&0, &1, &2]);
    (map, by)
}

fn draw(map: &mut PlanarMap, by: Named, from: u64, to: u64) {
    map.insert_segment(by.v(map, from), by.v(map, to)).unwrap();
}

fn erase(map: &mut PlanarMap, by: Named, from: u64, to: u64) {
    let (from, to) = (by.v(map, from), by.v(map, to));
    let h = map.dcel().vertex(from).unwrap().rotation().find(|h| h.target().key() == to).unwrap().key();
    map.remove_edge(h).unwrap();
}
