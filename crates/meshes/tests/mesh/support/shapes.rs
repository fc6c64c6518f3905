//! Meshes with known counts.

use twinedge_meshes::IndexedMesh;

/// Points in general position, exact as `f32`, without duplicates.
pub(crate) fn points(count: usize) -> Vec<[f64; 3]> {
    (0..count as u32).map(|i| [f64::from(i), f64::from(i * i % 17) / 4.0, f64::from(i % 5) - 0.5]).collect()
}

pub(crate) fn mesh<F: AsRef<[u32]>>(points_used: usize, faces: impl IntoIterator<Item = F>) -> IndexedMesh {
    IndexedMesh::from_faces(points(points_used), faces).expect("indices in range")
}

pub(crate) const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

pub(crate) const CUBE: [[u32; 4]; 6] =
    [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

pub(crate) const OCTAHEDRON: [[u32; 3]; 8] =
    [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]];

/// Möbius's triangulation of the torus with seven vertices, realized by Császár's polyhedron: i, i+1, i+3 and i, i+3, i+2 modulo 7.
pub(crate) fn seven_vertex_torus() -> Vec<[u32; 3]> {
    (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]).collect()
}

/// Möbius's triangulation of his strip with five vertices: i, i+1, i+2 modulo 5.
pub(crate) fn moebius_strip() -> [[u32; 3]; 5] {
    [0, 1, 2, 3, 4].map(|i| [i, (i + 1) % 5, (i + 2) % 5])
}

/// The Möbius strip, oriented so that the faces agree along every edge but one.
pub(crate) fn moebius_strip_with_a_seam() -> [[u32; 3]; 5] {
    let mut faces = moebius_strip();
    for turned in [1, 3] {
        faces[turned].reverse();
    }
    faces
}

/// A grid of quadrilaterals that is closed in none, one or both directions.
pub(crate) fn grid(columns: u32, rows: u32, around: bool, along: bool) -> (usize, Vec<[u32; 4]>) {
    let (across, up) = (if around { columns } else { columns + 1 }, if along { rows } else { rows + 1 });
    let at = |i: u32, j: u32| (j % up) * across + i % across;
    let cells = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
    let faces = cells.map(|(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]).collect();
    ((across * up) as usize, faces)
}
