//! Reads a view into columns.
//!
//! The view has been validated, but is not trusted: a link that leads nowhere or a cycle that does not close is
//! [`ImportError::Inconsistent`], and no loop is longer than the structure.

use super::error::{ImportError, Outside};
use crate::dcel::assemble::Assembly;
use crate::numbers::NIL;
use crate::store::{BoundaryStart, RecordKind, VertexLink};
use crate::validate::{Expectation, Link, Part, Parts, Start, View};
use alloc::vec;
use alloc::vec::Vec;

/// A vertex that may turn out to be isolated.
const UNKNOWN: VertexLink<u32, u32> = VertexLink::Isolated(NIL);

/// The number in the columns by index in the view; [`NIL`] for vacant slots.
#[derive(Default)]
pub(super) struct Numbers {
    pub(super) vertices: Vec<u32>,
    pub(super) half_edges: Vec<u32>,
    pub(super) boundaries: Vec<u32>,
    pub(super) faces: Vec<u32>,
}

#[derive(Default)]
pub(super) struct Columns {
    vertices: Vec<VertexLink<u32, u32>>,
    origin: Vec<u32>,
    next: Vec<u32>,
    boundary: Vec<u32>,
    starts: Vec<BoundaryStart<u32, u32>>,
    outer: Vec<u32>,
    inner: Vec<(u32, u32)>,
}

impl Columns {
    pub(super) fn assembly(&self) -> Assembly<'_> {
        Assembly {
            vertices: &self.vertices,
            origin: &self.origin,
            next: &self.next,
            boundary: &self.boundary,
            starts: &self.starts,
            outer: &self.outer,
            inner: &self.inner,
        }
    }

    fn add_cycle(&mut self, start: u32) -> Result<u32, ImportError> {
        let b = number(self.starts.len(), RecordKind::Boundary)?;
        self.starts.push(BoundaryStart::HalfEdge(start));
        let mut h = start;
        loop {
            let label = &mut self.boundary[h as usize];
            if *label != NIL {
                // Another cycle runs into this one, or this one is listed already.
                return Err(ImportError::Inconsistent);
            }
            *label = b;
            h = self.next[h as usize];
            if h == start {
                return Ok(b);
            }
        }
    }

    fn add_isolated(&mut self, v: u32) -> Result<u32, ImportError> {
        let b = number(self.starts.len(), RecordKind::Boundary)?;
        self.starts.push(BoundaryStart::Vertex(v));
        self.isolate(v, b)?;
        Ok(b)
    }

    fn isolate(&mut self, v: u32, b: u32) -> Result<(), ImportError> {
        let link = &mut self.vertices[v as usize];
        if *link != UNKNOWN {
            return Err(ImportError::Inconsistent);
        }
        *link = VertexLink::Isolated(b);
        Ok(())
    }
}

/// Checks that a record can have this number.
fn number(count: usize, kind: RecordKind) -> Result<u32, ImportError> {
    u32::try_from(count).ok().filter(|n| *n < NIL).ok_or(ImportError::Full(kind))
}

fn follow(link: Link, numbers: &[u32]) -> Result<u32, ImportError> {
    let found = link.and_then(|i| numbers.get(i)).copied();
    found.filter(|n| *n != NIL).ok_or(ImportError::Inconsistent)
}

fn enumerate(
    slots: usize,
    kind: RecordKind,
    is_live: impl Fn(usize) -> bool,
) -> Result<(Vec<u32>, usize), ImportError> {
    number(slots, kind)?;
    let mut numbers = vec![NIL; slots];
    let mut count = 0;
    for (_, n) in numbers.iter_mut().enumerate().filter(|(i, _)| is_live(*i)) {
        *n = count as u32;
        count += 1;
    }
    Ok((numbers, count))
}

pub(super) struct Gather<'a, V: ?Sized> {
    view: &'a V,
    expectation: Expectation,
    parts: Parts,
    outside: Outside,
    numbers: Numbers,
    columns: Columns,
    /// The index in the view of the future unbounded face.
    unbounded: Option<usize>,
}

impl<'a, V: View + ?Sized> Gather<'a, V> {
    /// Reads a valid view, whose `outside` becomes the unbounded face. O(n).
    pub(super) fn read(
        view: &'a V,
        expectation: Expectation,
        outside: Outside,
    ) -> Result<(Columns, Numbers), ImportError> {
        let (numbers, columns) = (Numbers::default(), Columns::default());
        let parts = expectation.looks_at(view.parts());
        let mut gather = Self { view, expectation, parts, outside, numbers, columns, unbounded: None };
        gather.vertices()?;
        let unpaired = gather.half_edges()?;
        gather.links()?;
        gather.missing_twins(&unpaired)?;
        gather.leaving()?;
        gather.faces()?;
        if parts.has(Part::BoundaryComponents) {
            gather.boundary_records()?;
        } else {
            gather.listed_starts()?;
        }
        gather.borders()?;
        gather.isolated()?;
        Ok((gather.columns, gather.numbers))
    }

    fn vertices(&mut self) -> Result<(), ImportError> {
        let (numbers, count) = enumerate(self.view.vertex_slots(), RecordKind::Vertex, |v| self.view.is_vertex(v))?;
        self.numbers.vertices = numbers;
        self.columns.vertices = vec![UNKNOWN; count];
        Ok(())
    }

    /// Numbers the half-edges, the two of an edge adjacent. Returns those without a twin.
    fn half_edges(&mut self) -> Result<Vec<u32>, ImportError> {
        let slots = self.view.half_edge_slots();
        number(slots, RecordKind::Edge)?;
        let mut numbers = vec![NIL; slots];
        let mut unpaired = Vec::new();
        let mut count = 0;
        for h in 0..slots {
            if numbers[h] != NIL || !self.view.is_half_edge(h) {
                continue;
            }
            number(count + 1, RecordKind::Edge)?;
            numbers[h] = count as u32;
            match self.view.twin(h) {
                Some(t) if numbers.get(t) == Some(&NIL) && self.view.is_half_edge(t) => numbers[t] = count as u32 + 1,
                None if self.expectation.is_open() => unpaired.push(count as u32),
                _ => return Err(ImportError::Inconsistent),
            }
            count += 2;
        }
        self.numbers.half_edges = numbers;
        self.columns.origin = vec![NIL; count];
        self.columns.next = vec![NIL; count];
        self.columns.boundary = vec![NIL; count];
        Ok(unpaired)
    }

    fn links(&mut self) -> Result<(), ImportError> {
        for (h, n) in self.numbers.half_edges.iter().enumerate().filter(|(_, n)| **n != NIL) {
            self.columns.origin[*n as usize] = follow(self.view.origin(h), &self.numbers.vertices)?;
            self.columns.next[*n as usize] = follow(self.view.next(h), &self.numbers.half_edges)?;
        }
        Ok(())
    }

    /// Makes the missing twins. They follow each other along the border, in the opposite direction.
    fn missing_twins(&mut self, unpaired: &[u32]) -> Result<(), ImportError> {
        if unpaired.is_empty() {
            return Ok(());
        }
        let Columns { vertices, origin, next, .. } = &mut self.columns;
        let mut arriving = vec![NIL; vertices.len()];
        for h in unpaired {
            let target = origin[next[*h as usize] as usize];
            origin[*h as usize ^ 1] = target;
            arriving[target as usize] = *h;
        }
        for h in unpaired {
            let before = arriving[origin[*h as usize] as usize];
            if before == NIL {
                return Err(ImportError::Inconsistent);
            }
            next[*h as usize ^ 1] = before ^ 1;
        }
        Ok(())
    }

    /// Sets a leaving half-edge of each vertex, if it has one; a half-edge named by the vertex takes precedence.
    fn leaving(&mut self) -> Result<(), ImportError> {
        for (h, v) in self.columns.origin.iter().enumerate().rev() {
            self.columns.vertices[*v as usize] = VertexLink::Leaving(h as u32);
        }
        if !self.parts.has(Part::Leaving) {
            return Ok(());
        }
        for (v, n) in self.numbers.vertices.iter().enumerate().filter(|(_, n)| **n != NIL) {
            let leaving = self.view.leaving(v);
            if leaving.is_some() {
                let h = follow(leaving, &self.numbers.half_edges)?;
                self.columns.vertices[*n as usize] = VertexLink::Leaving(h);
            }
        }
        Ok(())
    }

    fn faces(&mut self) -> Result<(), ImportError> {
        let (mut numbers, count) = enumerate(self.view.face_slots(), RecordKind::Face, |f| self.view.is_face(f))?;
        self.unbounded = match self.outside {
            Outside::Given => {
                let outer = |f: &usize| {
                    let by_record = self.parts.has(Part::BoundaryComponents);
                    if by_record { self.view.outer(*f) } else { self.view.outer_half_edge(*f) }
                };
                (0..numbers.len()).find(|f| numbers[*f] != NIL && outer(f).is_none())
            }
            Outside::Face(f) => Some(f),
            Outside::Border => None,
        };
        if let Some(unbounded) = self.unbounded {
            let first = follow(Some(unbounded), &numbers)?;
            // Moves it to the front, and the faces before it back by one.
            numbers.iter_mut().filter(|n| **n < first).for_each(|n| *n += 1);
            numbers[unbounded] = 0;
            self.columns.outer = vec![NIL; count - 1];
        } else {
            number(count, RecordKind::Face)?;
            numbers.iter_mut().filter(|n| **n != NIL).for_each(|n| *n += 1);
            self.columns.outer = vec![NIL; count];
        }
        self.numbers.faces = numbers;
        Ok(())
    }

    /// Reads the boundary components of a view that stores them as records.
    fn boundary_records(&mut self) -> Result<(), ImportError> {
        let (numbers, _) = enumerate(self.view.boundary_slots(), RecordKind::Boundary, |b| self.view.is_boundary(b))?;
        for (b, n) in numbers.iter().enumerate().filter(|(_, n)| **n != NIL) {
            let start = match self.view.boundary_start(b) {
                Some(Start::HalfEdge(h)) => BoundaryStart::HalfEdge(follow(Some(h), &self.numbers.half_edges)?),
                Some(Start::Vertex(v)) => {
                    let v = follow(Some(v), &self.numbers.vertices)?;
                    self.columns.isolate(v, *n)?;
                    BoundaryStart::Vertex(v)
                }
                None => return Err(ImportError::Inconsistent),
            };
            self.columns.starts.push(start);
        }
        for (h, n) in self.numbers.half_edges.iter().enumerate().filter(|(_, n)| **n != NIL) {
            match self.view.boundary(h) {
                // On a border.
                None => {}
                link => self.columns.boundary[*n as usize] = follow(link, &numbers)?,
            }
        }
        for f in 0..self.numbers.faces.len() {
            if self.numbers.faces[f] == NIL {
                continue;
            }
            if let Some(b) = self.view.outer(f) {
                self.list_outer(f, follow(Some(b), &numbers)?);
            }
            for position in 0..self.inner_count(f) {
                let b = follow(self.view.inner(f, position), &numbers)?;
                self.list_inner(f, b)?;
            }
        }
        self.outer_complete()?;
        self.numbers.boundaries = numbers;
        Ok(())
    }

    /// Reads the boundary components of a view whose faces list a half-edge or a vertex of each.
    fn listed_starts(&mut self) -> Result<(), ImportError> {
        for f in 0..self.numbers.faces.len() {
            if self.numbers.faces[f] == NIL {
                continue;
            }
            if let Some(h) = self.view.outer_half_edge(f) {
                let b = self.columns.add_cycle(follow(Some(h), &self.numbers.half_edges)?)?;
                self.list_outer(f, b);
            }
            for position in 0..self.inner_count(f) {
                let b = match self.view.inner_start(f, position) {
                    Some(Start::HalfEdge(h)) => self.columns.add_cycle(follow(Some(h), &self.numbers.half_edges)?)?,
                    Some(Start::Vertex(v)) => self.columns.add_isolated(follow(Some(v), &self.numbers.vertices)?)?,
                    None => return Err(ImportError::Inconsistent),
                };
                self.list_inner(f, b)?;
            }
        }
        self.outer_complete()
    }

    fn inner_count(&self, f: usize) -> usize {
        if self.parts.has(Part::Holes) { self.view.inner_count(f) } else { 0 }
    }

    /// Lists the outer boundary component of a face of the view. For the new unbounded face it becomes an inner one.
    fn list_outer(&mut self, f: usize, b: u32) {
        match (self.numbers.faces[f] as usize).checked_sub(1) {
            Some(bounded) => self.columns.outer[bounded] = b,
            None => self.columns.inner.push((0, b)),
        }
    }

    fn list_inner(&mut self, f: usize, b: u32) -> Result<(), ImportError> {
        // Each boundary component is listed once, so a longer list means that the view changed.
        if self.columns.inner.len() >= self.columns.starts.len() {
            return Err(ImportError::Inconsistent);
        }
        self.columns.inner.push((self.numbers.faces[f], b));
        Ok(())
    }

    fn outer_complete(&self) -> Result<(), ImportError> {
        if self.columns.outer.contains(&NIL) { Err(ImportError::Inconsistent) } else { Ok(()) }
    }

    /// Lists the cycles that bound no face so far as boundaries of the unbounded face.
    fn borders(&mut self) -> Result<(), ImportError> {
        for h in 0..self.columns.boundary.len() {
            if self.columns.boundary[h] != NIL {
                continue;
            }
            if self.outside != Outside::Border {
                return Err(ImportError::Border);
            }
            let b = self.columns.add_cycle(h as u32)?;
            self.columns.inner.push((0, b));
        }
        Ok(())
    }

    /// Lists the isolated vertices that lie in no face so far in the unbounded face.
    fn isolated(&mut self) -> Result<(), ImportError> {
        for v in 0..self.columns.vertices.len() {
            if self.columns.vertices[v] == UNKNOWN {
                if self.outside == Outside::Given {
                    return Err(ImportError::Inconsistent);
                }
                let b = self.columns.add_isolated(v as u32)?;
                self.columns.inner.push((0, b));
            }
        }
        Ok(())
    }
}

impl Columns {
    /// Returns the number of inner boundary components that are cycles: in a valid structure, the number of components with
    /// an edge.
    pub(super) fn outside_cycles(&self) -> usize {
        let is_cycle = |b: u32| matches!(self.starts[b as usize], BoundaryStart::HalfEdge(_));
        self.inner.iter().filter(|(_, b)| is_cycle(*b)).count()
    }
}

/// The components of a structure whose half-edges have the numbers `2e` and `2e + 1`.
pub(in crate::dcel) struct Pieces {
    /// By vertex: its component. Components are numbered in the order of their first vertices.
    pub(in crate::dcel) of: Vec<u32>,
    pub(in crate::dcel) first: Vec<u32>,
    /// The number of half-edges visited: smaller than the number of half-edges if a vertex has several rotations.
    pub(super) visited: usize,
}

impl Pieces {
    /// Finds the components from columns: origin and next by half-edge, and a leaving half-edge (or [`NIL`]) by vertex.
    ///
    /// `next` must be a permutation that keeps rule L3, so that every walk around a vertex returns. O(n).
    pub(in crate::dcel) fn find(origin: &[u32], next: &[u32], leaving: &[u32]) -> Self {
        let mut pieces = Self { of: vec![NIL; leaving.len()], first: Vec::new(), visited: 0 };
        let mut queue = Vec::new();
        for v in 0..leaving.len() as u32 {
            if pieces.of[v as usize] != NIL {
                continue;
            }
            let piece = pieces.first.len() as u32;
            pieces.first.push(v);
            pieces.of[v as usize] = piece;
            queue.push(v);
            while let Some(v) = queue.pop() {
                let start = leaving[v as usize];
                let mut h = start;
                while h != NIL {
                    pieces.visited += 1;
                    let target = origin[h as usize ^ 1];
                    if pieces.of[target as usize] == NIL {
                        pieces.of[target as usize] = piece;
                        queue.push(target);
                    }
                    h = next[h as usize ^ 1];
                    if h == start {
                        break;
                    }
                }
            }
        }
        pieces
    }

    /// Returns the genus of each component, given the origins of half-edges and the starts of cycles: `V − E + cycles =
    /// 2 − 2g`, where an isolated vertex has one cycle. O(n).
    pub(super) fn genera(&self, origin: &[u32], starts: &[BoundaryStart<u32, u32>]) -> Vec<usize> {
        let mut edges = vec![0_usize; self.first.len()];
        for v in origin.iter().step_by(2) {
            edges[self.of[*v as usize] as usize] += 1;
        }
        let mut others = vec![0_usize; self.first.len()];
        let vertices = 0..self.of.len() as u32;
        let cycles = starts.iter().filter_map(|start| match start {
            BoundaryStart::HalfEdge(h) => Some(origin[*h as usize]),
            BoundaryStart::Vertex(_) => None,
        });
        for v in vertices.chain(cycles) {
            others[self.of[v as usize] as usize] += 1;
        }
        edges.into_iter().zip(others).map(|(edges, others)| (edges + 2).saturating_sub(others) / 2).collect()
    }
}
