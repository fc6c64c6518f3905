//! Builds a [`Dcel`] from faces, given as lists of vertices.

use super::from_view::{Keys, keys};
use super::gather::{Numbers, Pieces};
use crate::dcel::assemble::Assembly;
use crate::dcel::structure::Dcel;
use crate::numbers::NIL;
use crate::store::{BoundaryStart, RecordKind, VertexLink};
use alloc::vec;
use alloc::vec::Vec;
use thiserror::Error;

/// The error of [`Dcel::from_faces`](crate::dcel::Dcel::from_faces). Faces are numbered from 0, in the given order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Error)]
#[non_exhaustive]
pub enum FacesError {
    /// A face lists a vertex that does not exist.
    #[error("face {face} lists vertex {vertex}, but there are {vertices} vertices, counted from 0")]
    NoSuchVertex {
        /// The face.
        face: usize,
        /// The vertex that it lists.
        vertex: u32,
        /// The number of vertices.
        vertices: usize,
    },
    /// A face lists fewer than three vertices.
    #[error("face {face} lists fewer than three vertices")]
    TooShort {
        /// The face.
        face: usize,
    },
    /// A face lists a vertex twice in a row (the last and the first count as adjacent).
    #[error("face {face} lists vertex {vertex} twice in a row")]
    Loop {
        /// The face.
        face: usize,
        /// The vertex.
        vertex: u32,
    },
    /// Two faces, or one face twice, traverse the same two vertices in the same direction: they overlap, one of them is clockwise, or
    /// three faces share an edge.
    #[error("faces {} and {} both go from vertex {} to vertex {}", .faces[0], .faces[1], .vertices[0], .vertices[1])]
    SameSide {
        /// The faces, in the given order.
        faces: [usize; 2],
        /// The origin and the target.
        vertices: [u32; 2],
    },
    /// Faces meet at a vertex without a connecting edge there, so their order around it is unknown.
    #[error("at vertex {vertex} faces meet that no common edge connects there")]
    SeveralFans {
        /// The vertex.
        vertex: u32,
    },
    /// A component is a closed surface: every side of a face is shared, and nothing remains for the outside.
    #[error("the component of vertex {vertex} is closed: leave out the face that is to be outside")]
    Closed {
        /// Its vertex with the smallest number.
        vertex: u32,
    },
    /// A component has several borders. All but one are holes, which must also be listed as faces.
    #[error("the component of vertex {vertex} has several borders: list the faces that fill its holes")]
    SeveralBorders {
        /// Its vertex with the smallest number.
        vertex: u32,
    },
    /// A component has one border, but lies on a surface that cannot be drawn in the plane.
    #[error("the component of vertex {vertex} has genus {genus}, and a planar subdivision has genus 0")]
    Genus {
        /// Its vertex with the smallest number.
        vertex: u32,
        /// Its genus.
        genus: usize,
    },
    /// There are more records of this kind than a [`Dcel`](crate::dcel::Dcel) can hold.
    #[error("there are more {0} than fit")]
    Full(RecordKind),
}

/// More corners may need more half-edges than there are numbers.
const MOST_CORNERS: usize = 1 << 30;

impl Dcel {
    /// Builds the structure with these bounded faces. Each face lists the numbers of its vertices counter-clockwise. The rest of the
    /// plane becomes the unbounded face.
    ///
    /// ```text
    ///   3───────2
    ///   │ 1   ╱ │     [0, 1, 2]     4 vertices, 5 edges, 3 faces
    ///   │   ╱   │     [0, 2, 3]
    ///   │ ╱   0 │
    ///   0───────1
    /// ```
    ///
    /// The faces may form several components, side by side in the unbounded face. Each component has one border: a surrounding face,
    /// or a hole's filling, must also be listed. A vertex that no face lists is isolated, in the unbounded face. Vertices may repeat
    /// in a face, where it contains a dangling edge or a bridge: `[0, 1, 2, 0, 3]` is a triangle with an edge from 0 to 3 inside.
    ///
    /// Without coordinates, faces that are all clockwise go unnoticed: the result is the mirror image.
    ///
    /// | not accepted | instead |
    /// | holes and components inside a face, an unbounded face among the faces, closed surfaces by one of their faces | [`Dcel::from_view`] |
    /// | faces that touch at a vertex only, parallel edges, loops | [`Dcel::from_rotations`] |
    ///
    /// The returned keys are indexed by number of vertex, by number of face, and for half-edges by *corner*: half-edge `i` leaves the
    /// `i`-th vertex of the concatenated lists. Records keep this order; of the two half-edges of an edge, the one with the smaller
    /// number gets the smaller index. The result needs no validation.
    ///
    /// O(n) time and memory for n vertices and corners.
    ///
    /// # Errors
    /// [`FacesError::NoSuchVertex`], [`FacesError::TooShort`] and [`FacesError::Loop`] for the first face that is invalid by itself;
    /// then [`FacesError::SameSide`] and [`FacesError::SeveralFans`]; then [`FacesError::Closed`], [`FacesError::SeveralBorders`] or
    /// [`FacesError::Genus`] for the first invalid component; [`FacesError::Full`].
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, FacesError};
    ///
    /// let (map, keys) = Dcel::from_faces(4, [[0, 1, 2], [0, 2, 3]])?;
    /// assert_eq!((map.vertex_count(), map.edge_count(), map.face_count()), (4, 5, 3));
    /// // Corner 2, the first face from vertex 2 to vertex 0, lies across corner 3.
    /// let diagonal = map.half_edge(keys.half_edge(2).unwrap())?;
    /// assert_eq!(Some(diagonal.twin().key()), keys.half_edge(3));
    /// assert_eq!(Some(diagonal.twin().face().key()), keys.face(1));
    ///
    /// let error = Dcel::from_faces(4, [[0, 1, 2], [0, 3, 2]]).unwrap_err();
    /// assert_eq!(error, FacesError::SameSide { faces: [0, 1], vertices: [2, 0] });
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_faces<F: AsRef<[u32]>>(
        vertices: usize,
        faces: impl IntoIterator<Item = F>,
    ) -> Result<(Self, Keys), FacesError> {
        if vertices >= NIL as usize / 2 {
            return Err(FacesError::Full(RecordKind::Vertex));
        }
        let corners = Corners::read(vertices, faces)?;
        let (numbers, half_edges) = number(corners.join(vertices)?);
        corners.assemble(vertices, numbers, half_edges)
    }
}

struct Corners {
    vertex: Vec<u32>,
    /// By corner: the next corner of the face.
    next: Vec<u32>,
    starts: Vec<u32>,
}

fn with_room(room: usize) -> Vec<u32> {
    let mut column = Vec::new();
    let _ = column.try_reserve_exact(room);
    column
}

impl Corners {
    fn read<F: AsRef<[u32]>>(vertices: usize, faces: impl IntoIterator<Item = F>) -> Result<Self, FacesError> {
        let faces = faces.into_iter();
        // Every face has at least three corners.
        let least = faces.size_hint().0.min(MOST_CORNERS / 3);
        let mut corners = Self { vertex: with_room(3 * least), next: with_room(3 * least), starts: with_room(least) };
        for (face, list) in faces.enumerate() {
            let list = list.as_ref();
            let start = corners.vertex.len();
            if list.len() >= MOST_CORNERS - start {
                return Err(FacesError::Full(RecordKind::Edge));
            }
            let [.., last] = *list else { return Err(FacesError::TooShort { face }) };
            if list.len() < 3 {
                return Err(FacesError::TooShort { face });
            }
            let mut before = last;
            for vertex in list {
                if *vertex as usize >= vertices {
                    return Err(FacesError::NoSuchVertex { face, vertex: *vertex, vertices });
                }
                if *vertex == before {
                    return Err(FacesError::Loop { face, vertex: *vertex });
                }
                before = *vertex;
            }
            let end = start + list.len();
            corners.vertex.extend_from_slice(list);
            corners.next.extend(start as u32 + 1..end as u32);
            corners.next.push(start as u32);
            corners.starts.push(start as u32);
        }
        Ok(corners)
    }

    fn target(&self, corner: u32) -> u32 {
        self.vertex[self.next[corner as usize] as usize]
    }

    fn face_of(&self, corner: u32) -> usize {
        self.starts.partition_point(|start| *start <= corner) - 1
    }

    /// Finds the other corner of each edge; [`NIL`] on the border.
    ///
    /// At each vertex, matches corners leading to smaller-numbered neighbours with corners coming from them, using two arrays over the
    /// vertices. A vertex costs O(degree).
    fn join(&self, vertices: usize) -> Result<Vec<u32>, FacesError> {
        // The corners that lead to each vertex: linked lists in one array.
        let mut arriving = vec![NIL; vertices];
        let mut after = vec![NIL; self.vertex.len()];
        for corner in (0..self.vertex.len() as u32).rev() {
            let target = self.target(corner) as usize;
            after[corner as usize] = arriving[target];
            arriving[target] = corner;
        }
        let mut twins = vec![NIL; self.vertex.len()];
        // By neighbour: the corner coming from it, and the corner leading to it.
        let mut sides = vec![[NIL; 2]; vertices];
        for v in 0..vertices as u32 {
            let some = |corner: u32| (corner != NIL).then_some(corner);
            let around = || core::iter::successors(some(arriving[v as usize]), |corner| some(after[*corner as usize]));
            for from in around() {
                let to = self.next[from as usize];
                for (corner, neighbour, side) in [(from, self.vertex[from as usize], 0), (to, self.target(to), 1)] {
                    if neighbour > v {
                        continue;
                    }
                    let before = core::mem::replace(&mut sides[neighbour as usize][side], corner);
                    if before != NIL {
                        let faces = [before.min(corner), before.max(corner)].map(|corner| self.face_of(corner));
                        let vertices = [self.vertex[corner as usize], self.target(corner)];
                        return Err(FacesError::SameSide { faces, vertices });
                    }
                }
            }
            for from in around() {
                for neighbour in [self.vertex[from as usize], self.target(self.next[from as usize])] {
                    let [from, to] = core::mem::replace(&mut sides[neighbour as usize], [NIL; 2]);
                    if from != NIL && to != NIL {
                        twins[from as usize] = to;
                        twins[to as usize] = from;
                    }
                }
            }
        }
        Ok(twins)
    }

    fn assemble(self, vertex_count: usize, numbers: Vec<u32>, half_edges: usize) -> Result<(Dcel, Keys), FacesError> {
        let faces = self.starts.len();
        let mut origin = vec![NIL; half_edges];
        let mut next = vec![NIL; half_edges];
        let mut boundary = vec![NIL; half_edges];
        let ends = self.starts.iter().skip(1).copied().chain([self.vertex.len() as u32]);
        for ((face, start), end) in (0..).zip(&self.starts).zip(ends) {
            for corner in *start..end {
                let h = numbers[corner as usize] as usize;
                origin[h] = self.vertex[corner as usize];
                next[h] = numbers[self.next[corner as usize] as usize];
                boundary[h] = face;
            }
        }
        let border = self.border(vertex_count, &numbers, &mut origin, &mut next)?;
        let mut leaving = vec![NIL; vertex_count];
        for (h, v) in origin.iter().enumerate().rev() {
            leaving[*v as usize] = h as u32;
        }
        let pieces = Pieces::find(&origin, &next, &leaving);
        if pieces.visited < half_edges {
            return Err(FacesError::SeveralFans { vertex: several_fans(&origin, &next, &leaving) });
        }

        let start_of = |start: &u32| numbers[*start as usize];
        let mut starts: Vec<_> = self.starts.iter().map(start_of).map(BoundaryStart::HalfEdge).collect();
        let mut borders = vec![0_u32; pieces.first.len()];
        for h in border {
            if boundary[h as usize] != NIL {
                continue;
            }
            let b = starts.len() as u32;
            starts.push(BoundaryStart::HalfEdge(h));
            borders[pieces.of[origin[h as usize] as usize] as usize] += 1;
            let mut along = h;
            while boundary[along as usize] == NIL {
                boundary[along as usize] = b;
                along = next[along as usize];
            }
        }
        check_plane(&pieces, &origin, &starts, &borders, &leaving)?;

        let vertices: Vec<_> = (0..)
            .zip(&leaving)
            .map(|(v, leaving)| {
                if *leaving != NIL {
                    return VertexLink::Leaving(*leaving);
                }
                starts.push(BoundaryStart::Vertex(v));
                VertexLink::Isolated(starts.len() as u32 - 1)
            })
            .collect();
        let outer: Vec<u32> = (0..faces as u32).collect();
        let inner: Vec<_> = (faces as u32..starts.len() as u32).map(|b| (0, b)).collect();
        let assembly = Assembly {
            vertices: &vertices,
            origin: &origin,
            next: &next,
            boundary: &boundary,
            starts: &starts,
            outer: &outer,
            inner: &inner,
        };
        // Frees memory for the columns of the store.
        drop((self, leaving, pieces));
        let dcel = assembly.assemble_right().map_err(FacesError::Full)?;
        let numbers = Numbers {
            vertices: (0..vertex_count as u32).collect(),
            half_edges: numbers,
            faces: (1..=faces as u32).collect(),
            ..Numbers::default()
        };
        let keys = keys(&dcel, &numbers);
        Ok((dcel, keys))
    }

    /// Links and lists the half-edges of the border, which have no corner.
    fn border(
        &self,
        vertices: usize,
        numbers: &[u32],
        origin: &mut [u32],
        next: &mut [u32],
    ) -> Result<Vec<u32>, FacesError> {
        let mut leaving_border = vec![NIL; vertices];
        let mut border = Vec::new();
        for (corner, h) in (0..).zip(numbers).filter(|(_, h)| origin[**h as usize ^ 1] == NIL) {
            let vertex = self.target(corner);
            let before = core::mem::replace(&mut leaving_border[vertex as usize], h ^ 1);
            if before != NIL {
                return Err(FacesError::SeveralFans { vertex });
            }
            border.push(h ^ 1);
        }
        for (vertex, h) in self.vertex.iter().zip(numbers).filter(|(_, h)| origin[**h as usize ^ 1] == NIL) {
            // At every vertex the same number of unpaired sides leave and arrive, so each has a successor.
            next[*h as usize ^ 1] = leaving_border[*vertex as usize];
        }
        for h in &border {
            // A border half-edge leaves the same vertex as the successor of its twin.
            origin[*h as usize] = origin[next[*h as usize ^ 1] as usize];
        }
        Ok(border)
    }
}

/// Numbers the half-edges of the corners, the two of an edge adjacent, and counts them including the border.
fn number(mut twins: Vec<u32>) -> (Vec<u32>, usize) {
    /// Marks entries that are already numbers.
    const NUMBER: u32 = 1 << 31;
    let mut count = 0;
    for corner in 0..twins.len() {
        match twins[corner] {
            NIL => {}
            number if number & NUMBER != 0 => {
                twins[corner] = number ^ NUMBER;
                continue;
            }
            twin => twins[twin as usize] = (count + 1) | NUMBER,
        }
        twins[corner] = count;
        count += 2;
    }
    (twins, count as usize)
}

/// A vertex with several rotations: the walk from its leaving half-edge misses some half-edges.
#[cold]
fn several_fans(origin: &[u32], next: &[u32], leaving: &[u32]) -> u32 {
    let mut visited = vec![false; origin.len()];
    for start in leaving.iter().filter(|h| **h != NIL) {
        let mut h = *start;
        while !core::mem::replace(&mut visited[h as usize], true) {
            h = next[h as usize ^ 1];
        }
    }
    visited.iter().position(|visited| !visited).map_or(NIL, |h| origin[h])
}

/// Checks that each component has one border and genus 0. Isolated vertices have no border.
fn check_plane(
    pieces: &Pieces,
    origin: &[u32],
    starts: &[BoundaryStart<u32, u32>],
    borders: &[u32],
    leaving: &[u32],
) -> Result<(), FacesError> {
    let genera = pieces.genera(origin, starts);
    for ((vertex, borders), genus) in pieces.first.iter().copied().zip(borders).zip(genera) {
        if leaving[vertex as usize] == NIL {
            continue;
        }
        match borders {
            0 => return Err(FacesError::Closed { vertex }),
            1 if genus == 0 => {}
            1 => return Err(FacesError::Genus { vertex, genus }),
            _ => return Err(FacesError::SeveralBorders { vertex }),
        }
    }
    Ok(())
}
