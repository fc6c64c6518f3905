//! Tables in a short notation.

use twinedge::validate::{BoundaryPlace, BoundaryRow, FaceRow, HalfEdgeRow, Part, Parts, Start, Table, VertexRow};

/// The parts of textbook tables.
pub(crate) const TEXTBOOK: Parts = Parts::ALL.without(Part::BoundaryComponents);

/// A face in short: a half-edge of its outer cycle, and the starts of its inner boundary components.
pub(crate) type ShortFace<'a> = (Option<usize>, &'a [Start]);

/// A map with this origin and next for each half-edge, where 0 and 1, 2 and 3, … are twins, and with these faces. It
/// has records for boundary components, numbered in the order of the lists.
pub(crate) fn map(vertices: usize, half_edges: &[(usize, usize)], faces: &[ShortFace<'_>]) -> Table {
    with_boundary_components(&textbook_map(vertices, half_edges, faces))
}

/// The map in the form of the textbook, without records for boundary components.
pub(crate) fn textbook_map(vertices: usize, half_edges: &[(usize, usize)], faces: &[ShortFace<'_>]) -> Table {
    let mut table = Table {
        parts: TEXTBOOK,
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
    for (f, _, start) in listed(&table) {
        for h in cycle(&table, start) {
            half_edge(&mut table, h).face = Some(f);
        }
    }
    table
}

/// Two edges between two vertices: half-edges 0 and 3 around the inside, 1 and 2 around the outside.
pub(crate) fn digon() -> Table {
    map(2, &[(0, 3), (1, 2), (0, 1), (1, 0)], &[(None, &[Start::HalfEdge(1)]), (Some(0), &[])])
}

/// One edge from a vertex to itself.
pub(crate) fn one_loop() -> Table {
    map(1, &[(0, 0), (0, 1)], &[(None, &[Start::HalfEdge(1)]), (Some(0), &[])])
}

/// The triangles of a tetrahedron.
pub(crate) const TETRAHEDRON: [[usize; 3]; 4] = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [0, 2, 3]];

/// The triangles of a torus: two for each square of a grid closed in both directions.
pub(crate) fn torus([columns, rows]: [usize; 2]) -> Vec<[usize; 3]> {
    let at = |x: usize, y: usize| x % columns + columns * (y % rows);
    let squares = (0..columns).flat_map(|x| (0..rows).map(move |y| (x, y)));
    let corners = squares.map(|(x, y)| [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]);
    corners.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect()
}

/// Seven vertices, all adjacent: Möbius' torus.
pub(crate) fn k7() -> Table {
    mesh(7, &[0, 1, 2, 3, 4, 5, 6].map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]).concat())
}

/// A mesh of these triangles, each with an outer boundary component. No two share a side in the same direction.
pub(crate) fn mesh(vertices: usize, triangles: &[[usize; 3]]) -> Table {
    with_boundary_components(&textbook_mesh(vertices, triangles))
}

/// The mesh in the form of the textbook.
pub(crate) fn textbook_mesh(vertices: usize, triangles: &[[usize; 3]]) -> Table {
    let sides = |[a, b, c]: [usize; 3]| [(a, b), (b, c), (c, a)];
    let mut pairs: Vec<(usize, usize)> = vec![];
    for (a, b) in triangles.iter().copied().flat_map(sides) {
        if !pairs.contains(&(a, b)) {
            pairs.extend([(a, b), (b, a)]);
        }
    }
    let number = |pair| pairs.iter().position(|p| *p == pair).unwrap();
    let mut half_edges = vec![(0, 0); pairs.len()];
    let mut faces: Vec<ShortFace<'_>> = vec![];
    for triangle in triangles {
        let [ab, bc, ca] = sides(*triangle);
        for (side, next) in [(ab, bc), (bc, ca), (ca, ab)] {
            half_edges[number(side)] = (side.0, number(next));
        }
        faces.push((Some(number(ab)), &[]));
    }
    textbook_map(vertices, &half_edges, &faces)
}

/// Adds records for boundary components to a textbook table: one for each list entry.
pub(crate) fn with_boundary_components(textbook: &Table) -> Table {
    let mut table = Table { parts: Parts::ALL, ..textbook.clone() };
    for half_edge in table.half_edges.iter_mut().flatten() {
        half_edge.face = None;
    }
    table.faces.fill(Some(FaceRow::default()));
    for (f, place, start) in listed(textbook) {
        let b = table.boundaries.len();
        table.boundaries.push(Some(BoundaryRow { face: Some(f), start: Some(start), place: Some(place) }));
        match place {
            BoundaryPlace::Outer => face(&mut table, f).outer = Some(b),
            BoundaryPlace::Inner(_) => face(&mut table, f).inner.push(Some(b)),
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

/// Returns the entries of the lists of the faces of a textbook table.
fn listed(table: &Table) -> Vec<(usize, BoundaryPlace, Start)> {
    let mut listed = vec![];
    for (f, face) in table.faces.iter().enumerate() {
        let face = face.as_ref().unwrap();
        listed.extend(face.outer_half_edge.map(|h| (f, BoundaryPlace::Outer, Start::HalfEdge(h))));
        listed.extend(
            face.inner_starts.iter().enumerate().map(|(i, start)| (f, BoundaryPlace::Inner(i), start.unwrap())),
        );
    }
    listed
}

/// The half-edges of the cycle that starts there; empty for an isolated vertex.
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

/// The mesh without its half-edges that name no face. A vertex keeps its first half-edge.
pub(crate) fn without_border(whole: &Table) -> Table {
    let mut table = whole.clone();
    for h in 0..table.half_edges.len() {
        if let Some(HalfEdgeRow { face: None, twin, .. }) = whole.half_edges[h] {
            table.half_edges[h] = None;
            if let Some(Some(row)) = twin.and_then(|twin| table.half_edges.get_mut(twin)) {
                row.twin = None;
            }
        }
    }
    for v in 0..table.vertices.len() {
        let leaves = |h: &usize| table.half_edges[*h].is_some_and(|row| row.origin == Some(v));
        let leaving = (0..table.half_edges.len()).find(leaves);
        vertex(&mut table, v).leaving = leaving;
    }
    table
}

/// The row of a half-edge, for changing it.
pub(crate) fn half_edge(table: &mut Table, h: usize) -> &mut HalfEdgeRow {
    table.half_edges[h].as_mut().unwrap()
}

/// The row of a vertex, for changing it.
pub(crate) fn vertex(table: &mut Table, v: usize) -> &mut VertexRow {
    table.vertices[v].as_mut().unwrap()
}

/// The row of a boundary component, for changing it.
pub(crate) fn boundary(table: &mut Table, b: usize) -> &mut BoundaryRow {
    table.boundaries[b].as_mut().unwrap()
}

/// The row of a face, for changing it.
pub(crate) fn face(table: &mut Table, f: usize) -> &mut FaceRow {
    table.faces[f].as_mut().unwrap()
}

/// Tables that store less.
pub(crate) trait Without {
    /// Returns the table without this part.
    fn without(&self, part: Part) -> Self;
}

impl Without for Table {
    fn without(&self, part: Part) -> Self {
        Self { parts: self.parts.without(part), ..self.clone() }
    }
}
