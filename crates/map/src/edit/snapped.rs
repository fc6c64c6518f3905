//! Drawing a segment that crosses edges, with the crossings rounded to a grid.

use super::at::At;
use super::error::EditError;
use super::outcome::Edited;
use super::plan::{EdgeChange, SnapPlan};
use super::trace::Towards;
use crate::feature_tries::SetId;
use crate::locate::Located;
use crate::planar_map::PlanarMap;
use rustc_hash::FxHashMap;
use twinedge::dcel::{HalfEdgeKey, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::noding::{Snap, node};
use twinedge_geometry::predicates::MIN_COORDINATE;

impl PlanarMap {
    /// Inserts a segment, cutting the edges that it crosses, with all new vertices rounded to a grid.
    ///
    /// ```text
    ///          │                      │
    ///          │    ╱                 │  ╱·
    ///   ·──────┼──╱───·        ·──────┼·────·        The crossings are rounded; so the segment
    ///          │╱             ──►    ╱│              and the edges that it crosses are bent a little.
    ///        ╱ │                  ·╱  │
    /// ```
    ///
    /// The result is the [noding](twinedge_geometry::noding) of the segment together with all edges and vertices of the map, with
    /// its guarantees. The ends move to the nearest grid points. Each crossing becomes a vertex on the grid. The segment and all
    /// edges are bent through each vertex whose pixel they visit. A segment that rounds to one point leaves a vertex. No vertex
    /// of the map moves or changes sides, and [`Edited::way`] stays within about a cell of the segment. Rounding may merge edges
    /// that come to lie on each other and remove slivers of faces between them.
    ///
    /// All vertices of the map must be on the grid. They are if the map was built from the output of noding, with [`Snap::Size`]
    /// of its [`NodingSummary::cell`](twinedge_geometry::noding::NodingSummary::cell), or drawn by this edit alone. (Only nearby
    /// vertices are checked.) [`Snap::Auto`] chooses the grid for the largest coordinate of both, and changes with it.
    ///
    /// Features follow their area: each face is covered by the features of its former face, even where edges coincide. An edge
    /// that replaces several edges has the features of all. Edges bent only through new vertices are
    /// [split](Edited::edges_split), and keep their key and their faces. Other changed edges are [dropped](Edited::edges_dropped)
    /// and [made](Edited::edges_made) anew along their way, temporarily merging and splitting their faces; see
    /// [`Edited::faces_relabelled`].
    ///
    /// O(s log s) for s edges around the faces along the segment and next to bent edges, after the first point is located (see
    /// [`At`]), plus splitting each face. Only edges near the segment or a bent edge are noded. [`Snap::Auto`] adds O(vertices).
    ///
    /// ```
    /// use twinedge_geometry::Point;
    /// use twinedge_geometry::noding::Snap;
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// let grid = Snap::Size(1.0);
    /// map.insert_segment_snapped([0.0, 0.0], [9.0, 3.0], grid)?;
    /// let second = map.insert_segment_snapped([0.0, 4.0], [8.0, 0.0], grid)?;
    /// // They cross at (4.8, 1.6).
    /// assert_eq!((second.edges_split.len(), second.way.len()), (1, 2));
    /// assert_eq!(map.position(second.vertices_made[0])?, Point::new(5.0, 2.0));
    /// assert!(map.validate().is_valid());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NotPlane`]; [`EditError::NotFinite`]; [`EditError::OutOfRange`], also for a grid point;
    /// [`EditError::NoLength`]; [`EditError::NotOnGrid`]; [`EditError::CellSize`]; [`EditError::OutOfReach`];
    /// [`EditError::Operator`] for a stale key or a full map.
    pub fn insert_segment_snapped(
        &mut self,
        from: impl Into<At>,
        to: impl Into<At>,
        snap: Snap,
    ) -> Result<Edited, EditError> {
        self.editable()?;
        let (from, to) = (from.into(), to.into());
        let ends = [self.point_of(from)?, self.point_of(to)?];
        if ends[0] == ends[1] {
            return Err(EditError::NoLength { x: ends[0].x, y: ends[0].y });
        }
        let start = self.place_of(from)?;
        let (region, noded) = self.region(start, ends, self.cell(snap, ends)?)?;
        let mut plan = SnapPlan::new(region, noded)?;
        let through = plan.changes.iter().map(|change| change.chain.len()).sum::<usize>() + plan.way.len();
        self.room_for_drawing(through)?;
        self.atomically(|map| map.apply(&mut plan, start))
    }

    /// Returns a cell's width, independent of the noded part of the map. A requested size is returned; noding rounds it down.
    fn cell(&self, snap: Snap, ends: [Point; 2]) -> Result<f64, EditError> {
        if let Snap::Size(size) = snap {
            return Ok(size);
        }
        let points = self.dcel.vertices().map(|v| self.at(v)).chain(ends);
        let largest = points.fold(0.0, |largest: f64, p| largest.max(p.x.abs()).max(p.y.abs()));
        // The predicates must also be exact on grid points.
        let corner = [Point::new(largest, 0.0)];
        let noded = node(&[], &corner, snap).map_err(|error| EditError::of_noding(error, &[], &corner))?;
        Ok(noded.summary.cell.max(MIN_COORDINATE))
    }

    fn apply(&mut self, plan: &mut SnapPlan, start: Located) -> Result<Edited, EditError> {
        let mut edited = Edited::default();
        let outside = self.features.of_face(self.dcel.unbounded_face().index());
        for change in plan.changes.iter().filter(|change| change.bends) {
            let mut part = plan.region.edges[change.edge].key;
            for number in &change.chain[1..change.chain.len() - 1] {
                let v = self.split(part, plan.points[*number as usize], &mut edited)?;
                plan.vertices.insert(*number, v);
                part = self.dcel.half_edge(part)?.next().key();
            }
        }
        let rerouted: Vec<&EdgeChange> = plan.changes.iter().filter(|change| !change.bends).collect();
        for change in &rerouted {
            self.erase(plan.region.edges[change.edge].key, &mut edited)?;
        }
        let vertices = &mut plan.vertices;
        for change in &rerouted {
            let way = self.draw_noded(&change.chain, &plan.points, vertices, start, &mut edited)?;
            for h in way {
                self.add_along(h, plan.region.edges[change.edge].along, &mut edited)?;
            }
        }
        edited.way = self.draw_noded(&plan.way, &plan.points, vertices, start, &mut edited)?;
        edited.vertices = [plan.way.first(), plan.way.last()].into_iter().flatten().map(|n| vertices[n]).collect();
        if !rerouted.is_empty() {
            self.relabel(plan, outside, &mut edited)?;
        }
        Ok(edited)
    }

    /// Draws a chain of the noded drawing and returns the half-edges along it.
    fn draw_noded(
        &mut self,
        chain: &[u32],
        points: &[Point],
        vertices: &mut FxHashMap<u32, VertexKey>,
        start: Located,
        edited: &mut Edited,
    ) -> Result<Vec<HalfEdgeKey>, EditError> {
        let point = |number: u32| points[number as usize];
        let first = if let Some(first) = chain.iter().position(|number| vertices.contains_key(number)) {
            first
        } else {
            // The chain meets nothing, so all of it lies in the face where the segment starts.
            let v = self.make_in_the_open(point(chain[0]), start, edited)?;
            vertices.insert(chain[0], v);
            0
        };
        // Outwards from the first existing vertex, in both directions: each vertex lies in a corner of the one before.
        let outwards = (0..first).rev().map(|i| [i + 1, i]).chain((first + 1..chain.len()).map(|i| [i - 1, i]));
        let mut way = vec![None; chain.len() - 1];
        for [i, j] in outwards {
            let from = vertices[&chain[i]];
            let to = if let Some(v) = vertices.get(&chain[j]) {
                *v
            } else {
                let v = self.make_beside(from, point(chain[j]), edited)?;
                vertices.insert(chain[j], v);
                v
            };
            let h = self.join(from, to, edited)?;
            way[i.min(j)] = Some(if i < j { h } else { self.dcel.half_edge(h)?.twin().key() });
        }
        Ok(way.into_iter().flatten().collect())
    }

    /// Makes an isolated vertex at a point that a segment from a vertex reaches without meeting anything.
    fn make_beside(&mut self, from: VertexKey, p: Point, edited: &mut Edited) -> Result<VertexKey, EditError> {
        let v = self.dcel.vertex(from)?;
        let face = match self.towards(v, p) {
            Towards::Along(h) | Towards::Corner(h) => Some(h.face()),
            Towards::Isolated => v.isolated().map(|b| b.face()),
        };
        let face = face.unwrap_or(self.dcel.unbounded_face()).key();
        self.make_isolated(p, face, edited)
    }

    /// Makes an isolated vertex at a point inside a face: the face of `start`, unless it no longer exists.
    fn make_in_the_open(&mut self, p: Point, start: Located, edited: &mut Edited) -> Result<VertexKey, EditError> {
        let likely = match start {
            Located::Face(face) => Some(face).filter(|face| self.dcel.face(*face).is_ok()),
            Located::Vertex(_) | Located::Edge(_) => None,
        };
        let place = self.place(p, likely)?;
        self.realise(p, place, edited)
    }

    fn add_along(&mut self, h: HalfEdgeKey, more: SetId, edited: &mut Edited) -> Result<(), EditError> {
        let index = self.dcel.half_edge(h)?.index();
        let had = self.features.along(index);
        let all = self.features.either(had, more);
        if all != had {
            self.cover_edge(index, all);
            edited.edges_relabelled.push(h);
        }
        Ok(())
    }
}
