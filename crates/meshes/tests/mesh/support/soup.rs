//! Random lists of faces: from scratch, and from a valid mesh with a few faults.

use super::shapes::{grid, mesh, moebius_strip_with_a_seam};
use quickcheck::{Arbitrary, Gen};
use twinedge_meshes::IndexedMesh;

#[derive(Clone, Debug)]
pub(crate) struct Soup {
    pub(crate) points: usize,
    pub(crate) faces: Vec<Vec<u32>>,
}

impl Soup {
    pub(crate) fn mesh(&self) -> IndexedMesh {
        mesh(self.points, &self.faces)
    }
}

fn below(g: &mut Gen, limit: usize) -> usize {
    usize::arbitrary(g) % limit.max(1)
}

fn pure(g: &mut Gen) -> Soup {
    let points = 1 + below(g, 8);
    let faces = (0..below(g, 11)).map(|_| {
        let sides = *g.choose(&[0, 1, 2, 3, 3, 3, 3, 3, 3, 3, 4, 4, 5]).expect("there are some");
        (0..sides).map(|_| below(g, points) as u32).collect()
    });
    let faces = faces.collect();
    Soup { points, faces }
}

/// A triangulated grid or a Möbius strip, with a random number of faults.
fn spoilt(g: &mut Gen) -> Soup {
    let (columns, rows) = (3 + below(g, 3) as u32, 1 + below(g, 3) as u32);
    let (mut points, cells) = grid(columns, rows, bool::arbitrary(g), rows > 2 && bool::arbitrary(g));
    let mut faces: Vec<Vec<u32>> = Vec::new();
    for [a, b, c, d] in cells {
        if below(g, 4) == 0 {
            faces.push(vec![a, b, c, d]);
        } else {
            faces.extend([vec![a, b, c], vec![a, c, d]]);
        }
    }
    if below(g, 8) == 0 {
        (points, faces) = (5, moebius_strip_with_a_seam().map(Vec::from).to_vec());
    }
    for _ in 0..below(g, 4) {
        let f = below(g, faces.len());
        match below(g, 8) {
            0 => faces[f].reverse(),
            1 => faces.push(faces[f].clone()),
            2 => {
                let mut copy = faces[f].clone();
                copy.reverse();
                copy.rotate_left(1);
                faces.push(copy);
            }
            3 => drop(faces.swap_remove(f)),
            4 => {
                let corner = below(g, faces[f].len());
                faces[f][corner] = below(g, points) as u32;
            }
            5 => points += 1,
            6 => faces.push(vec![faces[f][0], faces[f][1], below(g, points) as u32]),
            _ => {
                // Another fan at an existing vertex.
                faces.push(vec![faces[f][0], points as u32, points as u32 + 1]);
                points += 2;
            }
        }
        if faces.is_empty() {
            break;
        }
    }
    Soup { points, faces }
}

impl Arbitrary for Soup {
    fn arbitrary(g: &mut Gen) -> Self {
        if bool::arbitrary(g) { pure(g) } else { spoilt(g) }
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        let this = self.clone();
        Box::new((0..self.faces.len()).map(move |f| {
            let mut smaller = this.clone();
            smaller.faces.remove(f);
            smaller
        }))
    }
}
