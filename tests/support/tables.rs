//! Tables, written down the short way.

use twinedge::validate::{BoundaryRow, FaceRow, HalfEdgeRow, Place, Start, Table, VertexRow};

/// A face in the short way: a half-edge of its outer cycle, and where its inner boundary components start.
pub(crate) type ShortFace<'a> = (Option<usize>, &'a [Start]);

/// A map with this origin and next for each half-edge, the twins being 0 and 1, 2 and 3, … Faces are as listed, and there
/// are boundary components for those who ask for them.
pub(crate) fn map(vertices: usize, half_edges: &[(usize, usize)], faces: &[ShortFace<'_>]) -> Table {
    let mut table = Table {
        vertices: (0..vertices)
            .map(|v| {
                Some(VertexRow { leaving: half_edges.iter().position(|(origin, _)| *origin == v), isolated: None })
            })
            .collect(),
        half_edges: half_edges
            .iter()
            .enumerate()
            .map(|(h, (origin, next))| {
                Some(HalfEdgeRow {
                    origin: Some(*origin),
                    twin: Some(h ^ 1),
                    next: Some(*next),
                    prev: half_edges.iter().position(|(_, next)| *next == h),
                    ..HalfEdgeRow::default()
                })
            })
            .collect(),
        boundaries: vec![],
        faces: faces
            .iter()
            .map(|(outer, inner)| {
                let inner_starts = inner.iter().copied().map(Some).collect();
                Some(FaceRow { outer_half_edge: *outer, inner_starts, ..FaceRow::default() })
            })
            .collect(),
    };
    label_faces(&mut table);
    with_boundary_components(&table)
}

/// Writes each face into the half-edges of the cycles that it lists.
fn label_faces(table: &mut Table) {
    for (f, start) in listed(table).into_iter().map(|(f, _, start)| (f, start)) {
        for h in cycle(table, start) {
            half_edge(table, h).face = Some(f);
        }
    }
}

/// A textbook table with records for its boundary components besides: one for each entry of the list of each face.
pub(crate) fn with_boundary_components(textbook: &Table) -> Table {
    let mut table = textbook.clone();
    for (f, place, start) in listed(textbook) {
        let b = table.boundaries.len();
        table.boundaries.push(Some(BoundaryRow { face: Some(f), start: Some(start), place: Some(place) }));
        let row = table.faces[f].as_mut().unwrap();
        match place {
            Place::Outer => row.outer = Some(b),
            Place::Inner(_) => row.inner.push(Some(b)),
        }
        for h in cycle(textbook, start) {
            half_edge(&mut table, h).boundary = Some(b);
        }
        if let Start::Vertex(v) = start {
            vertex(&mut table, v).isolated = Some(b);
        }
    }
    table
}

/// What the faces of a textbook table list.
fn listed(table: &Table) -> Vec<(usize, Place, Start)> {
    let mut listed = vec![];
    for (f, face) in table.faces.iter().enumerate() {
        let face = face.as_ref().unwrap();
        listed.extend(face.outer_half_edge.map(|h| (f, Place::Outer, Start::HalfEdge(h))));
        listed.extend(face.inner_starts.iter().enumerate().map(|(i, start)| (f, Place::Inner(i), start.unwrap())));
    }
    listed
}

/// The half-edges of the cycle that starts there; none at an isolated vertex.
fn cycle(table: &Table, start: Start) -> Vec<usize> {
    let Start::HalfEdge(start) = start else {
        return vec![];
    };
    let mut cycle = vec![];
    let mut h = start;
    while !cycle.contains(&h) {
        cycle.push(h);
        h = table.half_edges[h].unwrap().next.unwrap();
    }
    cycle
}

/// The row of a half-edge, to change it.
pub(crate) fn half_edge(table: &mut Table, h: usize) -> &mut HalfEdgeRow {
    table.half_edges[h].as_mut().unwrap()
}

/// The row of a vertex, to change it.
pub(crate) fn vertex(table: &mut Table, v: usize) -> &mut VertexRow {
    table.vertices[v].as_mut().unwrap()
}

/// The row of a boundary component, to change it.
pub(crate) fn boundary(table: &mut Table, b: usize) -> &mut BoundaryRow {
    table.boundaries[b].as_mut().unwrap()
}

/// The row of a face, to change it.
pub(crate) fn face(table: &mut Table, f: usize) -> &mut FaceRow {
    table.faces[f].as_mut().unwrap()
}
