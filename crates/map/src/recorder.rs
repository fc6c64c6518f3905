//! The log of a map: the interface for undo histories and audits.

use super::index::IndexedEdge;
use super::notes::MapEntry;
use super::planar_map::PlanarMap;
use crate::FeatureId;
use crate::near::{EmbeddingBaseline, validate_embedding_near};
use std::mem;
use twinedge::dcel::extend::{Access, Auditable, LogPlace, Recorder, Rewrite, Way};
use twinedge::dcel::{Dcel, HalfEdge, Vertex};
use twinedge::validate::near::{BaselineError, WriteSet};
use twinedge::validate::{Expectation, Report};

impl Recorder for PlanarMap {
    type Other = MapEntry;

    fn dcel(&self) -> &Dcel {
        &self.dcel
    }

    fn dcel_mut(&mut self, _: Access) -> &mut Dcel {
        &mut self.dcel
    }

    fn log_others(&mut self, on: bool, _: Access) {
        self.note(on);
    }

    fn take_others(&mut self, _: Access) -> Vec<MapEntry> {
        let mut others = self.notes.split_off(0);
        if let Some(attributes) = self.dcel.attributes_mut() {
            others.extend(attributes.take_log().into_iter().map(MapEntry::Value));
        }
        others
    }

    fn rewrite(&mut self, links: Rewrite, others: &mut [MapEntry]) {
        let way = links.way();
        let redrawn = self.index.if_built().is_some().then(|| Redrawn::new(self, &links, others));
        if let (Some(redrawn), Some(index)) = (&redrawn, self.index.if_built()) {
            redrawn.edges_of(&self.dcel).for_each(|h| index.remove_edge(&IndexedEdge::new(h, &self.points)));
            redrawn.isolated_of(&self.dcel).for_each(|v| index.remove_vertex(v.index(), self.points[v.index()]));
        }
        links.apply(&mut self.dcel);
        match way {
            Way::Back => others.iter_mut().rev().for_each(|entry| self.exchange(entry, way)),
            Way::Forth => others.iter_mut().for_each(|entry| self.exchange(entry, way)),
        }
        if let (Some(redrawn), Some(index)) = (&redrawn, self.index.if_built()) {
            redrawn.isolated_of(&self.dcel).for_each(|v| index.add_vertex(v, &self.points));
            redrawn.edges_of(&self.dcel).for_each(|h| index.add_edge(h, &self.points));
        }
    }

    fn add_written(&self, written: &mut WriteSet, others: &[MapEntry]) {
        written.vertices.extend(others.iter().filter_map(MapEntry::vertex));
    }
}

impl Auditable for PlanarMap {
    type Baseline = EmbeddingBaseline;

    fn baseline(&self) -> Result<EmbeddingBaseline, BaselineError> {
        EmbeddingBaseline::new(self, &Expectation::plane())
    }

    fn check_near(&self, baseline: &mut EmbeddingBaseline, written: &WriteSet) -> Result<(), Box<Report>> {
        validate_embedding_near(baseline, self, written)
    }

    fn check(&self) -> Report {
        self.validate()
    }
}

impl PlanarMap {
    /// Turns the log of overwritten data other than links on, clearing it, or off.
    pub(super) fn note(&mut self, on: bool) {
        if on {
            self.notes.begin();
            if let Some(attributes) = self.dcel.attributes_mut() {
                attributes.clear_log();
            }
        } else {
            self.notes.end();
        }
    }

    pub(super) fn begin_logs(&mut self) {
        self.note(true);
        self.dcel.begin_log();
    }

    pub(super) fn end_logs(&mut self) {
        self.note(false);
        self.dcel.end_log();
    }

    /// Returns the records written since `since`, the beginning of the logs, and clears the logs.
    pub(super) fn take_written(&mut self, since: LogPlace) -> WriteSet {
        let mut written = self.dcel.written_since(since);
        written.vertices.extend(self.notes.split_off(0).iter().filter_map(MapEntry::vertex));
        self.begin_logs();
        written
    }

    /// Exchanges the current value and the value of an entry.
    fn exchange(&mut self, entry: &mut MapEntry, way: Way) {
        match entry {
            MapEntry::Point(v, point) => mem::swap(&mut self.points[*v as usize], point),
            MapEntry::OfFace(f, set) => {
                let had = self.features.of_face(*f as usize);
                self.features.put_face(*f as usize, mem::replace(set, had));
            }
            MapEntry::Along(h, set) => {
                let had = self.features.along(*h as usize);
                self.features.put_along(*h as usize, mem::replace(set, had));
            }
            MapEntry::Feature(name) => match way {
                Way::Back => *name = self.names.pop().flatten().map(String::into_boxed_str),
                Way::Forth => self.names.push(name.take().map(String::from)),
            },
            MapEntry::Name(feature, name) => {
                let removed = FeatureId::new(*feature);
                if !self.features.removed.remove(&removed) {
                    self.features.removed.insert(removed);
                }
                let had = self.names[*feature as usize].take();
                self.names[*feature as usize] = mem::replace(name, had.map(String::into_boxed_str)).map(String::from);
            }
            MapEntry::Value(saved) => {
                if let Some(attributes) = self.dcel.attributes_mut() {
                    attributes.exchange(saved);
                }
            }
        }
    }
}

/// Records drawn differently after a change: edges by their even half-edges, and vertices that may be isolated, by index.
struct Redrawn {
    edges: Vec<usize>,
    vertices: Vec<usize>,
}

impl Redrawn {
    /// Collects the records of a change that is about to be undone or redone.
    fn new(map: &PlanarMap, links: &Rewrite, others: &[MapEntry]) -> Self {
        let (mut edges, mut vertices) = links.redrawn(&map.dcel);
        for v in others.iter().filter_map(MapEntry::vertex) {
            vertices.push(v);
            // Edges that are added or removed are already included.
            let rotation = map.dcel.vertex_at(v).into_iter().flat_map(|v| v.rotation());
            edges.extend(rotation.map(|h| h.index() & !1));
        }
        for list in [&mut edges, &mut vertices] {
            list.sort_unstable();
            list.dedup();
        }
        Self { edges, vertices }
    }

    fn edges_of<'a>(&'a self, dcel: &'a Dcel) -> impl Iterator<Item = HalfEdge<'a>> {
        self.edges.iter().filter_map(|h| dcel.half_edge_at(*h))
    }

    /// Returns the vertices that exist and are isolated.
    fn isolated_of<'a>(&'a self, dcel: &'a Dcel) -> impl Iterator<Item = Vertex<'a>> {
        self.vertices.iter().filter_map(|v| dcel.vertex_at(*v)).filter(|v| v.isolated().is_some())
    }
}
