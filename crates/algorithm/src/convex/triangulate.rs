//! Triangulating faces: from the constrained Delaunay triangulation of `spade` to edges of the map.
//!
//! 1. The vertices and edges of all the faces are passed to `spade` together, the edges as constraints.
//! 2. At each corner of a face, a turn through the triangulation from one side to the other meets the diagonals of that corner,
//!    counter-clockwise. So each end of a diagonal is known with its corner, without a search.
//! 3. The diagonals that connect the boundary components of a face are drawn first, so that every later one splits a face without
//!    inner boundary components.
//! 4. A diagonal is attached next to the edge that precedes it at its corner *when it is drawn*. Removing the diagonals from the
//!    complete lists in reverse order finds this edge.

use super::error::ConvexError;
use rustc_hash::{FxHashMap, FxHashSet};
use spade::handles::{DirectedEdgeHandle, FixedVertexHandle};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _, validate_vertex};
use twinedge::dcel::{Boundary, Corner, Face, FaceKey, HalfEdge, HalfEdgeKey, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_angle, orientation};
use twinedge_map::edit::EditError;
use twinedge_map::{Embedding, NotPlane, PlanarMap};

/// A triangulated face: every edge of the triangles is an edge of the map.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Triangulation {
    /// The face, by its old key, which now belongs to one of the triangles.
    pub face: FaceKey,
    /// A half-edge of the outer boundary of the face.
    pub boundary: HalfEdgeKey,
    /// The diagonals, each by one of its half-edges, in the order of drawing.
    pub diagonals: Vec<HalfEdgeKey>,
    /// The number of triangles.
    pub triangles: usize,
    /// The number of reflex corners of the face; an isolated vertex counts as one.
    pub reflex: usize,
}

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;
type CdtEdge<'a> = DirectedEdgeHandle<'a, Point2<f64>, (), spade::CdtEdge<()>, ()>;

/// Triangulates faces, including their holes, by edges between vertices of each; repetitions have no effect. Returns the
/// triangulation of each face, in order of first mention.
///
/// Every triangle is constrained Delaunay: no vertex of the face that sees it lies inside its circumcircle. Diagonals have no
/// features, and triangles have the features of their face.
///
/// O(n log n) for the n half-edges of the faces, expected: a diagonal walks the shorter of the two cycles that it makes.
///
/// # Errors
/// [`ConvexError`].
pub fn triangulate(
    map: &mut PlanarMap,
    faces: impl IntoIterator<Item = FaceKey>,
) -> Result<Vec<Triangulation>, ConvexError> {
    let mut seen = FxHashSet::default();
    let keys: Vec<FaceKey> = faces.into_iter().filter(|face| seen.insert(*face)).collect();
    let plan = Plan::new(map, &keys)?;
    map.room_for_edges(plan.faces.iter().map(|face| face.diagonals.len()).sum())?;
    plan.draw(map)
}

/// No half-edge or component, in a column.
const NIL: u32 = u32::MAX;

/// The vertices and edges of some faces, numbered for `spade`.
struct Input {
    numbers: FxHashMap<usize, u32>,
    vertices: Vec<VertexKey>,
    points: Vec<Point2<f64>>,
    edges: Vec<[usize; 2]>,
}

impl Input {
    fn new(map: &PlanarMap, faces: &[Face<'_>]) -> Result<Self, ConvexError> {
        let mut input =
            Self { numbers: FxHashMap::default(), vertices: Vec::new(), points: Vec::new(), edges: Vec::new() };
        let chosen: FxHashSet<usize> = faces.iter().map(|face| face.index()).collect();
        for face in faces {
            for vertex in face.inner().filter_map(Boundary::isolated_vertex) {
                input.vertex(vertex.index(), vertex.key(), map.point(vertex.index()))?;
            }
            for h in face.half_edges() {
                let (v, w) = (h.origin(), h.target());
                let from = input.vertex(v.index(), v.key(), map.point(v.index()))?;
                // An edge with both sides in these faces appears twice.
                if h.index() < h.twin().index() || !chosen.contains(&h.twin().face().index()) {
                    let to = input.vertex(w.index(), w.key(), map.point(w.index()))?;
                    input.edges.push([from as usize, to as usize]);
                }
            }
        }
        Ok(input)
    }

    fn vertex(&mut self, index: usize, key: VertexKey, Point { x, y }: Point) -> Result<u32, ConvexError> {
        let next = self.points.len() as u32;
        let number = *self.numbers.entry(index).or_insert(next);
        if number == next {
            let point = Point2::new(x, y);
            validate_vertex(&point).map_err(|_| ConvexError::OutOfRange { x, y })?;
            self.points.push(point);
            self.vertices.push(key);
        }
        Ok(number)
    }
}

struct FacePlan {
    face: FaceKey,
    boundary: HalfEdgeKey,
    boundaries: usize,
    reflex: usize,
    /// Each by the number of one of its directed edges in the triangulation, in order.
    diagonals: Vec<u32>,
}

/// The diagonals to draw. The columns are indexed by directed edge of the triangulation.
struct Plan {
    faces: Vec<FacePlan>,
    /// Half-edges of the map, once they exist.
    drawn: Vec<Option<HalfEdgeKey>>,
    /// The directed edge before each one, clockwise, at its corner when it is drawn; nil if the vertex is isolated then.
    before: Vec<u32>,
    /// The directed edge after each one, while all diagonals are present.
    after: Vec<u32>,
    from: Vec<VertexKey>,
    reverse: Vec<u32>,
    /// For a diagonal, the number of the boundary component at whose corner it starts.
    component: Vec<u32>,
}

impl Plan {
    fn new(map: &PlanarMap, keys: &[FaceKey]) -> Result<Self, ConvexError> {
        let dcel = map.dcel();
        let faces = keys.iter().map(|key| dcel.face(*key)).collect::<Result<Vec<_>, _>>()?;
        map.plane().map_err(EditError::from)?;
        if faces.iter().any(|face| face.is_unbounded()) {
            return Err(ConvexError::Unbounded);
        }
        let Input { numbers, vertices, points, edges } = Input::new(map, &faces)?;
        let count = points.len();
        let mut conflicts = false;
        let cdt = Cdt::try_bulk_load_cdt(points, edges, |_| conflicts = true)
            .map_err(|_| EditError::NotPlane(NotPlane::default()))?;
        if conflicts || cdt.num_vertices() != count {
            return Err(EditError::NotPlane(NotPlane::default()).into());
        }
        let number = |e: CdtEdge<'_>| e.fix().index() as u32;
        let mut by_ends: FxHashMap<[u32; 2], CdtEdge<'_>> = FxHashMap::default();
        by_ends.reserve(2 * cdt.num_constraints());
        for e in cdt.directed_edges().filter(|e| e.is_constraint_edge()) {
            by_ends.insert([e.from().index() as u32, e.to().index() as u32], e);
        }
        let constraint = |h: HalfEdge<'_>| {
            let ends = [h.origin(), h.target()].map(|v| numbers[&v.index()]);
            by_ends.get(&ends).copied().ok_or(EditError::NotPlane(NotPlane::default()))
        };

        let directed = cdt.num_directed_edges();
        let mut plan = Self {
            faces: Vec::with_capacity(faces.len()),
            drawn: vec![None; directed],
            before: vec![NIL; directed],
            after: vec![NIL; directed],
            from: cdt.directed_edges().map(|e| vertices[e.from().index()]).collect(),
            reverse: cdt.directed_edges().map(|e| number(e.rev())).collect(),
            component: vec![NIL; directed],
        };
        let mut components = 0;
        for face in faces {
            let boundary = face.outer_half_edge().map(HalfEdge::key).ok_or(ConvexError::Unbounded)?;
            let mut to_draw = FacePlan { face: face.key(), boundary, boundaries: 0, reflex: 0, diagonals: Vec::new() };
            for boundary in face.boundaries() {
                to_draw.boundaries += 1;
                let component = components;
                components += 1;
                if let Some(vertex) = boundary.isolated_vertex() {
                    to_draw.reflex += 1;
                    let vertex = cdt.vertex(FixedVertexHandle::from_index(numbers[&vertex.index()] as usize));
                    let first = vertex.out_edge().ok_or(EditError::NotPlane(NotPlane::default()))?;
                    let last = plan.corner(first, first, component, &mut to_draw)?;
                    // The full turn, including the first edge again.
                    plan.list(number(last), number(first), component, &mut to_draw);
                }
                for h in boundary.half_edges() {
                    to_draw.reflex += usize::from(is_reflex(map, h));
                    let first = constraint(h)?;
                    plan.drawn[number(first) as usize] = Some(h.key());
                    let end = constraint(h.prev())?.rev();
                    plan.corner(first, end, component, &mut to_draw)?;
                }
            }
            if to_draw.boundaries > 1 {
                plan.bridges_first(&mut to_draw.diagonals, components - to_draw.boundaries as u32, components);
            }
            plan.take_out(&to_draw.diagonals)?;
            plan.faces.push(to_draw);
        }
        Ok(plan)
    }

    /// Lists the diagonals between two directed edges that leave a vertex, counter-clockwise. Returns the last one.
    fn corner<'a>(
        &mut self,
        first: CdtEdge<'a>,
        end: CdtEdge<'a>,
        component: u32,
        face: &mut FacePlan,
    ) -> Result<CdtEdge<'a>, EditError> {
        let mut last = first;
        loop {
            let e = last.ccw();
            if e == end {
                return Ok(last);
            }
            // The corner is inside the face, where there are no constraints.
            if e == first || e.is_constraint_edge() {
                return Err(EditError::NotPlane(NotPlane::default()));
            }
            self.list(last.fix().index() as u32, e.fix().index() as u32, component, face);
            last = e;
        }
    }

    /// Lists a diagonal after another edge at its corner.
    fn list(&mut self, last: u32, e: u32, component: u32, face: &mut FacePlan) {
        self.before[e as usize] = last;
        self.after[last as usize] = e;
        self.component[e as usize] = component;
        if self.component[self.reverse[e as usize] as usize] == NIL {
            face.diagonals.push(e);
        }
    }

    /// Moves diagonals that connect all boundary components of a face, numbered from `first` to `end`, to the front.
    fn bridges_first(&self, diagonals: &mut Vec<u32>, first: u32, end: u32) {
        // Each set of connected components is a tree.
        let mut parent: Vec<u32> = (0..end - first).collect();
        let mut root = |mut i: u32, under: Option<u32>| {
            while parent[i as usize] != i {
                let above = parent[parent[i as usize] as usize];
                parent[i as usize] = above;
                i = above;
            }
            if let Some(under) = under {
                parent[i as usize] = under;
            }
            i
        };
        let mut others = Vec::with_capacity(diagonals.len());
        let mut bridges = Vec::new();
        for e in diagonals.drain(..) {
            let [a, b] = [e, self.reverse[e as usize]].map(|e| self.component[e as usize]);
            // A diagonal with only one end is detected when it is removed from the lists.
            if b == NIL || root(a - first, None) == root(b - first, None) {
                others.push(e);
            } else {
                let under = root(b - first, None);
                root(a - first, Some(under));
                bridges.push(e);
            }
        }
        bridges.append(&mut others);
        *diagonals = bridges;
    }

    /// Finds the predecessor of each diagonal when it is drawn, by removing them from the complete lists in reverse order.
    fn take_out(&mut self, diagonals: &[u32]) -> Result<(), EditError> {
        for e in diagonals.iter().rev() {
            for e in [*e, self.reverse[*e as usize]] {
                let (before, after) = (self.before[e as usize], self.after[e as usize]);
                if before == NIL {
                    return Err(EditError::NotPlane(NotPlane::default()));
                }
                if before == e {
                    self.before[e as usize] = NIL;
                    continue;
                }
                self.after[before as usize] = after;
                if after != NIL {
                    self.before[after as usize] = before;
                }
            }
        }
        Ok(())
    }

    fn draw(mut self, map: &mut PlanarMap) -> Result<Vec<Triangulation>, ConvexError> {
        let mut triangulations = Vec::with_capacity(self.faces.len());
        for FacePlan { face, boundary, boundaries, reflex, diagonals } in core::mem::take(&mut self.faces) {
            let mut keys = Vec::with_capacity(diagonals.len());
            for e in diagonals {
                let reverse = self.reverse[e as usize];
                let h = map.connect_corners(self.corner_of(e), self.corner_of(reverse))?;
                self.drawn[e as usize] = Some(h);
                self.drawn[reverse as usize] = Some(map.dcel().half_edge(h)?.twin().key());
                keys.push(h);
            }
            let triangles = keys.len() + 2 - boundaries;
            triangulations.push(Triangulation { face, boundary, diagonals: keys, triangles, reflex });
        }
        Ok(triangulations)
    }

    /// Returns the corner where a directed edge is attached.
    fn corner_of(&self, e: u32) -> Corner {
        let before = self.drawn.get(self.before[e as usize] as usize).copied().flatten();
        before.map_or(Corner::Isolated(self.from[e as usize]), Corner::At)
    }
}

/// Returns true if the corner between the half-edge and the one before it, inside their face, is larger than a straight angle.
fn is_reflex(map: &PlanarMap, h: HalfEdge<'_>) -> bool {
    let [a, v, b] = [h.prev().origin(), h.origin(), h.target()].map(|v| map.point(v.index()));
    match orientation(a, v, b) {
        Orientation::CounterClockwise => false,
        // In the same direction: a full turn, around the end of a dangling edge.
        Orientation::Collinear => compare_angle(v, a, b).is_eq(),
        Orientation::Clockwise => true,
    }
}
