//! A mesh with arithmetic `next`, so its operators move half-edges, and without stored border half-edges.

use std::collections::BTreeSet;
use twinedge::program::Refusal;
use twinedge::validate::{Part, Parts, View};
use twinedge::view_answers;

/// A bug of the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bug {
    None,
    /// A collapse leaves the opposite vertex with a half-edge of the removed triangle.
    StaleLeaving,
    /// A collapse moves only the triangles on one side of a border.
    ForgetsFan,
    /// An inner edge between two vertices of the border collapses.
    Pinches,
    /// A flip claims success, but does nothing.
    FlipsNothing,
    /// A collapse keeps the target of an inner edge, and the origin on the border.
    KeepsEither,
    /// A collapse makes a new vertex.
    MakesVertex,
    /// A split panics at vertices of degree 6 or more.
    Panics,
}

/// Half-edge `h` belongs to triangle `h / 3`, and `next` leads around it.
#[derive(Clone, Debug)]
pub(crate) struct Triangles {
    target: Vec<usize>,
    twin: Vec<Option<usize>>,
    is_live: Vec<bool>,
    leaving: Vec<Option<usize>>,
    bug: Bug,
}

fn next(h: usize) -> usize {
    h - h % 3 + (h + 1) % 3
}
fn prev(h: usize) -> usize {
    h - h % 3 + (h + 2) % 3
}

impl Triangles {
    pub(crate) fn new(vertices: usize, triangles: &[[usize; 3]], bug: Bug) -> Self {
        let mut mesh = Self { target: vec![], twin: vec![], is_live: vec![], leaving: vec![None; vertices], bug };
        for triangle in triangles {
            let first = mesh.add([triangle[1], triangle[2], triangle[0]]);
            for (h, origin) in (first..).zip(triangle) {
                let twin = (0..first).find(|t| mesh.target[*t] == *origin && mesh.origin_of(*t) == mesh.target[h]);
                mesh.pair(h, twin);
                mesh.leaving[*origin] = Some(h);
            }
        }
        mesh
    }

    fn add(&mut self, targets: [usize; 3]) -> usize {
        self.target.extend(targets);
        self.twin.extend([None; 3]);
        self.is_live.extend([true; 3]);
        self.target.len() - 3
    }

    fn pair(&mut self, h: usize, twin: Option<usize>) {
        self.twin[h] = twin;
        if let Some(twin) = twin {
            self.twin[twin] = Some(h);
        }
    }

    fn origin_of(&self, h: usize) -> usize {
        self.target[prev(h)]
    }

    fn live(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.target.len()).filter(|h| self.is_live[*h])
    }

    fn neighbours(&self, v: usize) -> BTreeSet<usize> {
        let ends = self.live().map(|h| [self.origin_of(h), self.target[h]]);
        ends.filter(|ends| ends.contains(&v)).flatten().filter(|u| *u != v).collect()
    }

    fn is_on_border(&self, v: usize) -> bool {
        self.live().any(|h| self.twin[h].is_none() && [self.origin_of(h), self.target[h]].contains(&v))
    }

    fn check(&self, h: usize) -> Result<(), Refusal> {
        if self.is_live.get(h) == Some(&true) { Ok(()) } else { Err(Refusal::Stale) }
    }

    /// `a` and `b` leave the same vertices as before, and two other half-edges form the edge between the opposite vertices.
    pub(crate) fn flip(&mut self, a: usize) -> Result<(), Refusal> {
        self.check(a)?;
        let b = self.twin[a].ok_or(Refusal::Border)?;
        let (after_a, after_b) = (next(a), next(b));
        let (u, v, w, x) = (self.origin_of(a), self.target[a], self.target[after_a], self.target[after_b]);
        if w == x || self.neighbours(w).contains(&x) {
            return Err(Refusal::NotSimple);
        }
        if self.bug == Bug::FlipsNothing {
            return Ok(());
        }
        let (beyond_a, beyond_b) = (self.twin[after_b], self.twin[after_a]);
        (self.target[a], self.target[b]) = (x, w);
        self.pair(a, beyond_a);
        self.pair(b, beyond_b);
        self.pair(after_a, Some(after_b));
        (self.leaving[u], self.leaving[v]) = (Some(a), Some(b));
        Ok(())
    }

    pub(crate) fn split(&mut self, a: usize) -> Result<(), Refusal> {
        self.check(a)?;
        assert!(self.bug != Bug::Panics || self.neighbours(self.target[a]).len() < 6, "a vertex of degree 6");
        let (b, middle) = (self.twin[a], self.leaving.len());
        self.leaving.push(None);
        let new_a = self.split_side(a, middle);
        let new_b = b.map(|b| self.split_side(b, middle));
        self.pair(new_a, b);
        if let Some(new_b) = new_b {
            self.pair(new_b, Some(a));
        }
        self.leaving[middle] = Some(new_a);
        Ok(())
    }

    /// Splits the triangle of `a`, which then ends at the new vertex. Returns the half-edge from there to the old target of `a`.
    fn split_side(&mut self, a: usize, middle: usize) -> usize {
        let (v, w, after) = (self.target[a], self.target[next(a)], next(a));
        let new = self.add([v, w, middle]);
        let beyond = self.twin[after];
        self.target[a] = middle;
        self.pair(new + 1, beyond);
        self.pair(after, Some(new + 2));
        self.leaving[v] = Some(new + 1);
        new
    }

    /// Merges the target into the origin.
    pub(crate) fn collapse(&mut self, a: usize) -> Result<(), Refusal> {
        self.check(a)?;
        let (u, v) = (self.origin_of(a), self.target[a]);
        let sides: Vec<usize> = [Some(a), self.twin[a]].into_iter().flatten().collect();
        let opposite: BTreeSet<usize> = sides.iter().map(|side| self.target[next(*side)]).collect();
        let common: BTreeSet<usize> = self.neighbours(u).intersection(&self.neighbours(v)).copied().collect();
        let is_inner = sides.len() == 2;
        let pinches = is_inner && self.is_on_border(u) && self.is_on_border(v) && self.bug != Bug::Pinches;
        // A triangle with both other sides on the border, and a tetrahedron.
        let is_last = sides.iter().any(|side| match (self.twin[next(*side)], self.twin[prev(*side)]) {
            (None, None) => true,
            (Some(s), Some(t)) => self.target[next(s)] == self.target[next(t)],
            _ => false,
        });
        if common != opposite || pinches || is_last {
            return Err(Refusal::NotSimple);
        }
        if self.bug == Bug::ForgetsFan {
            let mut arriving = Some(a);
            while let Some(h) = arriving {
                self.target[h] = u;
                arriving = self.twin[next(h)].filter(|h| *h != a);
            }
        } else {
            self.target.iter_mut().filter(|target| **target == v).for_each(|target| *target = u);
        }
        for side in sides {
            let (beyond, other, w) = (self.twin[next(side)], self.twin[prev(side)], self.target[next(side)]);
            for (h, twin) in [(beyond, other), (other, beyond)] {
                if let Some(h) = h {
                    self.twin[h] = twin;
                }
            }
            for h in [side, next(side), prev(side)] {
                self.is_live[h] = false;
            }
            if self.bug != Bug::StaleLeaving && self.leaving[w] == Some(prev(side)) {
                self.leaving[w] = beyond.or(other.map(next));
            }
        }
        if self.leaving[u].is_none_or(|h| !self.is_live[h]) {
            let at_u = self.live().find(|h| self.origin_of(*h) == u);
            self.leaving[u] = at_u;
        }
        self.leaving[v] = None;
        match self.bug {
            Bug::KeepsEither if is_inner => self.rename(u, v),
            Bug::MakesVertex => {
                self.leaving.push(None);
                self.rename(u, self.leaving.len() - 1);
            }
            _ => {}
        }
        Ok(())
    }

    fn rename(&mut self, v: usize, now: usize) {
        self.target.iter_mut().filter(|target| **target == v).for_each(|target| *target = now);
        self.leaving.swap(v, now);
    }
}

impl View for Triangles {
    view_answers! { |m|
        parts => Parts::NONE.with(Part::Faces).with(Part::Leaving),
        vertex_slots => m.leaving.len(),
        half_edge_slots => m.target.len(),
        face_slots => m.target.len() / 3,
        is_vertex(v) => m.leaving[v].is_some(),
        is_half_edge(h) => m.is_live[h],
        is_face(f) => m.is_live[3 * f],
        origin(h) => Some(m.origin_of(h)),
        twin(h) => m.twin[h],
        next(h) => Some(next(h)),
        face(h) => Some(h / 3),
        leaving(v) => m.leaving[v],
        outer_half_edge(f) => Some(3 * f),
    }
}
