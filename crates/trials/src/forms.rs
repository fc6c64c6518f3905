//! Every form in which a structure can keep a map, and a map brought into each.
//!
//! There are 112 distinct forms: two surfaces, with or without open boundaries, and the stored parts, which may depend on
//! others. A map that is valid in one form breaks rules in another, for example because it lists holes although faces have none.
//! [`projections`] rewrites a planar subdivision with every part so that it is valid in any of them.

use twinedge::validate::{BoundaryPlace, Expectation, FaceRow, Link, Part, Parts, Start, Surface, Table, View};

/// One form: the claims about a structure, and its stored parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Form {
    /// The claims.
    pub expectation: Expectation,
    /// The stored parts that the expectation [examines](Expectation::looks_at).
    pub parts: Parts,
}

impl Form {
    /// Returns the form of a structure with these parts and this expectation.
    #[must_use]
    pub const fn new(expectation: Expectation, parts: Parts) -> Self {
        Self { expectation, parts: expectation.looks_at(parts) }
    }

    const fn has(&self, part: Part) -> bool {
        self.parts.has(part)
    }

    /// Returns true if containment (T1, T2) is checked.
    #[must_use]
    pub fn has_containment(&self) -> bool {
        self.has(Part::Holes) && self.expectation.surface_kind() == Surface::Plane
    }
}

/// Returns every distinct form once: plane or surface, closed or open, with and without each part.
///
/// ```
/// use twinedge::validate::{Expectation, Parts};
/// use twinedge_trials::forms::{Form, forms};
/// let all = forms();
/// assert_eq!(all.len(), 112);
/// assert!(all.contains(&Form::new(Expectation::plane(), Parts::ALL)));
/// assert!(all.contains(&Form::new(Expectation::surface().open(), Parts::ALL)));
/// ```
#[must_use]
pub fn forms() -> Vec<Form> {
    let mut all = Vec::new();
    for surface in [Expectation::plane(), Expectation::surface()] {
        for expectation in [surface, surface.open()] {
            for lacks in 0..1_u32 << Part::ALL.len() {
                let lacking = Part::ALL.iter().enumerate().filter(|(bit, _)| lacks >> bit & 1 == 1);
                let parts = lacking.fold(Parts::ALL, |parts, (_, part)| parts.without(*part));
                let form = Form::new(expectation, parts);
                if !all.contains(&form) {
                    all.push(form);
                }
            }
        }
    }
    all
}

/// Returns the same planar subdivision as a structure of this form keeps it. O(n) for n rows and list entries.
///
/// The given table has every part, and boundary components that name their faces. Parts not in the form are nil or vacant.
///
/// - Without boundary components, half-edges name their face, and faces the half-edges and isolated vertices where their
///   boundary components start.
/// - Without holes, each cycle bounds a face of its own, and isolated vertices lie in none.
/// - Without unbounded face, so does each cycle that bounds the unbounded face, and isolated vertices there.
///
/// ```
/// use twinedge_trials::forms::{Form, projected};
/// use twinedge::validate::{Collect, Expectation, Parts, Table, validate};
/// // An edge between two vertices.
/// let edge: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// assert!(validate(&edge, &Expectation::plane(), Collect::All).is_valid());
/// // On a sphere its one face has an outer boundary component like any other.
/// let sphere = Expectation::surface();
/// assert!(!validate(&edge, &sphere, Collect::All).is_valid());
/// let projected = projected(&edge, &Form::new(sphere, Parts::ALL));
/// assert!(validate(&projected, &sphere, Collect::All).is_valid());
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
#[must_use]
pub fn projected(table: &Table, form: &Form) -> Table {
    let mut table = Table { parts: form.parts, ..table.clone() };
    if form.has(Part::Faces) {
        for f in 0..table.faces.len() {
            let is_unbounded = table.is_face(f) && table.outer(f).is_none();
            if !form.has(Part::Holes) || is_unbounded && !form.has(Part::UnboundedFace) {
                unlist_inner(&mut table, f);
                if is_unbounded {
                    table.faces[f] = None;
                }
            }
        }
        if !form.has(Part::BoundaryComponents) {
            drop_boundaries(&mut table);
        } else if !form.has(Part::Places) {
            table.boundaries.iter_mut().flatten().for_each(|row| row.place = None);
        }
    } else {
        table.boundaries.clear();
        table.faces.clear();
        table.half_edges.iter_mut().flatten().for_each(|row| (row.boundary, row.face) = (None, None));
        table.vertices.iter_mut().flatten().for_each(|row| row.isolated = None);
    }
    if !form.has(Part::Prev) {
        table.half_edges.iter_mut().flatten().for_each(|row| row.prev = None);
    }
    if !form.has(Part::Leaving) {
        table.vertices.iter_mut().flatten().for_each(|row| row.leaving = None);
    }
    table
}

/// Returns the map [`projected`], and, if open boundaries are legal, each map that results from first taking out one of its
/// faces, or the half-edges of one of its cycles. O(n) tables, O(n²) in all.
///
/// A face or cycle is taken out if the rest is valid: a bounded face without isolated vertices in it, or the unbounded face if
/// that is not stored; a cycle that passes no vertex twice, and is not the outer one of a face with holes.
#[must_use]
pub fn projections(table: &Table, form: &Form) -> Vec<Table> {
    let mut all = vec![projected(table, form)];
    if form.expectation.is_open() {
        if form.has(Part::Faces) {
            let faces = (0..table.faces.len()).filter_map(|f| without_face(table, form.parts, f));
            all.extend(faces.map(|open| projected(&open, form)));
        }
        let cycles = (0..table.boundaries.len()).filter_map(|b| without_cycle(table, b));
        all.extend(cycles.map(|open| projected(&open, form)));
    }
    all
}

/// Gives each inner boundary component of a face a face of its own, as the outer one. Isolated vertices bound none.
fn unlist_inner(table: &mut Table, f: usize) {
    let Some(row) = table.faces.get_mut(f).and_then(Option::as_mut) else { return };
    for b in std::mem::take(&mut row.inner).into_iter().flatten() {
        let alone = table.faces.len();
        let Some(boundary) = table.boundaries.get_mut(b).and_then(Option::as_mut) else { continue };
        if let Some(Start::Vertex(v)) = boundary.start {
            table.boundaries[b] = None;
            if let Some(vertex) = table.vertices.get_mut(v).and_then(Option::as_mut) {
                vertex.isolated = None;
            }
        } else {
            (boundary.face, boundary.place) = (Some(alone), Some(BoundaryPlace::Outer));
            table.faces.push(Some(FaceRow { outer: Some(b), ..FaceRow::default() }));
        }
    }
}

/// Removes the records for boundary components: half-edges name their face instead, and faces the starts of their boundary
/// components.
fn drop_boundaries(table: &mut Table) {
    let boundaries = std::mem::take(&mut table.boundaries);
    let record = |b: Link| boundaries.get(b?).copied().flatten();
    for half_edge in table.half_edges.iter_mut().flatten() {
        half_edge.face = record(half_edge.boundary.take()).and_then(|b| b.face);
    }
    for vertex in table.vertices.iter_mut().flatten() {
        vertex.isolated = None;
    }
    for face in table.faces.iter_mut().flatten() {
        face.outer_half_edge = match record(face.outer.take()).and_then(|b| b.start) {
            Some(Start::HalfEdge(h)) => Some(h),
            _ => None,
        };
        face.inner_starts = std::mem::take(&mut face.inner).into_iter().map(|b| record(b)?.start).collect();
    }
}

/// Returns the table without a face: its half-edges bound none.
fn without_face(table: &Table, parts: Parts, f: usize) -> Option<Table> {
    let row = table.faces.get(f)?.as_ref()?;
    let listed = || row.outer.iter().chain(row.inner.iter().flatten());
    let is_vertex = |b: &usize| matches!(table.boundary_start(*b), Some(Start::Vertex(_)));
    let is_needed = if row.outer.is_none() { parts.has(Part::UnboundedFace) } else { listed().any(is_vertex) };
    if is_needed {
        return None;
    }
    let mut open = table.clone();
    let is_gone = |b: Link| b.is_some_and(|b| listed().any(|other| *other == b));
    open.half_edges.iter_mut().flatten().filter(|h| is_gone(h.boundary)).for_each(|h| h.boundary = None);
    open.vertices.iter_mut().flatten().filter(|v| is_gone(v.isolated)).for_each(|v| v.isolated = None);
    listed().for_each(|b| open.boundaries[*b] = None);
    open.faces[f] = None;
    Some(open)
}

/// Returns the table without the half-edges of one cycle, and without the face that it encloses: the twins of these half-edges
/// then have no twin.
fn without_cycle(table: &Table, b: usize) -> Option<Table> {
    let boundary = table.boundaries.get(b)?.as_ref()?;
    let of_it = |h: usize| table.half_edges[h].as_ref().is_some_and(|row| row.boundary == Some(b));
    let cycle: Vec<usize> = (0..table.half_edges.len()).filter(|h| of_it(*h)).collect();
    let mut vertices: Vec<Link> = cycle.iter().map(|h| table.origin(*h)).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let f = boundary.face?;
    let face = table.faces.get(f)?.as_ref()?;
    let is_outer = face.outer == Some(b);
    if cycle.is_empty() || vertices.len() < cycle.len() || is_outer && !face.inner.is_empty() {
        return None;
    }
    // On a cycle that passes no vertex twice, an edge with both sides on the cycle is the whole component.
    if cycle.iter().any(|h| table.twin(*h).is_some_and(of_it)) {
        return None;
    }
    let mut open = table.clone();
    for h in cycle {
        let twin = table.twin(h)?;
        open.half_edges[twin].as_mut()?.twin = None;
        let vertex = open.vertices[table.origin(h)?].as_mut()?;
        if vertex.leaving == Some(h) {
            vertex.leaving = table.twin(table.prev(h)?);
        }
        open.half_edges[h] = None;
    }
    open.boundaries[b] = None;
    if is_outer {
        open.faces[f] = None;
    } else {
        open.faces[f].as_mut()?.inner.retain(|listed| *listed != Some(b));
        for i in 0..open.inner_count(f) {
            let listed = open.inner(f, i)?;
            open.boundaries[listed].as_mut()?.place = Some(BoundaryPlace::Inner(i));
        }
    }
    Some(open)
}
