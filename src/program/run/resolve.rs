//! From what a program chooses by numbers to handles.

use super::outcome::StepOutcome;
use super::runner::Runner;
use crate::dcel::{Corner, Side, Turn};
use crate::program::operators::{CornerPick, FacePick, Fit, HalfEdgePick, InnerPick, SecondPick, VertexPick};
use crate::program::subject::{CornerOf, Refusal, Subject};
use alloc::vec::Vec;

/// An argument of an operator, chosen by numbers.
pub(in crate::program) trait Resolve: Copy {
    /// The arguments on which it depends, if a first corner is such a `C`.
    type Context<C>;
    /// The type that it has in a call.
    type Handle<K: Subject>;

    fn resolve<K: Subject>(
        self,
        runner: &Runner<K>,
        context: Self::Context<CornerOf<K>>,
    ) -> Result<Self::Handle<K>, StepOutcome>;
}

/// The `k`-th of a list that starts again where it ends.
fn nth<T: Copy>(list: &[T], k: u32) -> Result<T, StepOutcome> {
    let position = (k as usize).checked_rem(list.len()).ok_or(StepOutcome::Skipped)?;
    list.get(position).copied().ok_or(StepOutcome::Skipped)
}

impl Resolve for HalfEdgePick {
    type Context<C> = ();
    type Handle<K: Subject> = K::HalfEdge;

    fn resolve<K: Subject>(self, runner: &Runner<K>, (): ()) -> Result<K::HalfEdge, StepOutcome> {
        match self {
            Self::Live(k) => nth(&runner.half_edges, k),
            Self::Retired(k) => nth(&runner.retired_half_edges, k),
        }
    }
}

impl Resolve for VertexPick {
    type Context<C> = ();
    type Handle<K: Subject> = K::Vertex;

    fn resolve<K: Subject>(self, runner: &Runner<K>, (): ()) -> Result<K::Vertex, StepOutcome> {
        match self {
            Self::Isolated(k) => nth(&runner.isolated, k),
            Self::OriginOf(k) => runner.subject.origin_of(nth(&runner.half_edges, k)?).map_err(StepOutcome::Refused),
            Self::Retired(k) => nth(&runner.retired_vertices, k),
        }
    }
}

impl Resolve for CornerPick {
    type Context<C> = ();
    type Handle<K: Subject> = CornerOf<K>;

    fn resolve<K: Subject>(self, runner: &Runner<K>, (): ()) -> Result<CornerOf<K>, StepOutcome> {
        match self {
            Self::At(pick) => pick.resolve(runner, ()).map(Corner::At),
            Self::Isolated(pick) => pick.resolve(runner, ()).map(Corner::Isolated),
        }
    }
}

impl Resolve for FacePick {
    type Context<C> = ();
    type Handle<K: Subject> = K::Face;

    fn resolve<K: Subject>(self, runner: &Runner<K>, (): ()) -> Result<K::Face, StepOutcome> {
        match self {
            Self::Unbounded => runner.subject.unbounded_face().ok_or(StepOutcome::Skipped),
            Self::Of(pick) => runner.subject.face_of(pick.resolve(runner, ())?).map_err(StepOutcome::Refused),
            Self::Retired(k) => nth(&runner.retired_faces, k),
        }
    }
}

impl Resolve for SecondPick {
    type Context<C> = (C, Fit);
    type Handle<K: Subject> = CornerOf<K>;

    fn resolve<K: Subject>(
        self,
        runner: &Runner<K>,
        (first, fit): (CornerOf<K>, Fit),
    ) -> Result<CornerOf<K>, StepOutcome> {
        match self {
            Self::Any(pick) => pick.resolve(runner, ()),
            Self::Fitting(k) => {
                let place = nth(&runner.fitting(first, fit)?, k)?;
                runner.corners().nth(place).ok_or(StepOutcome::Skipped)
            }
        }
    }
}

impl Resolve for InnerPick {
    type Context<C> = C;
    type Handle<K: Subject> = Vec<CornerOf<K>>;

    /// One corner of each boundary component to be named.
    fn resolve<K: Subject>(self, runner: &Runner<K>, from: CornerOf<K>) -> Result<Vec<CornerOf<K>>, StepOutcome> {
        let mut named = Vec::new();
        if self.mask != 0 {
            let face = runner.subject.face_of(from).map_err(StepOutcome::Refused)?;
            let mut seen = Vec::new();
            runner.append_boundary(from, &mut seen);
            let mut count = 0;
            for corner in runner.corners() {
                if runner.subject.face_of(corner).is_ok_and(|f| f == face) && !seen.contains(&corner) {
                    runner.append_boundary(corner, &mut seen);
                    if self.mask >> (count % 16) & 1 == 1 {
                        named.push(corner);
                    }
                    count += 1;
                }
            }
        }
        if let Some(also) = self.also {
            named.push(also.resolve(runner, ())?);
        }
        Ok(named)
    }
}

macro_rules! itself {
    ($($name:ident)*) => {$(
        impl Resolve for $name {
            type Context<C> = ();
            type Handle<K: Subject> = Self;

            fn resolve<K: Subject>(self, _: &Runner<K>, (): ()) -> Result<Self, StepOutcome> {
                Ok(self)
            }
        }
    )*};
}
itself! { Side Turn }

impl<K: Subject> Runner<K> {
    /// The vertex of a corner.
    fn vertex_of(&self, corner: CornerOf<K>) -> Result<K::Vertex, StepOutcome> {
        match corner {
            Corner::At(h) => self.subject.origin_of(h).map_err(StepOutcome::Refused),
            Corner::Isolated(v) => Ok(v),
        }
    }

    /// The places, in [`Runner::corners`], of those that fit a first one.
    pub(super) fn fitting(&self, first: CornerOf<K>, fit: Fit) -> Result<Vec<usize>, StepOutcome> {
        let corners = self.corners().enumerate();
        Ok(match fit {
            Fit::Face if self.subject.face_of(first) == Err(Refusal::Unsupported) => {
                // Without faces, each cycle is one.
                let mut cycle = Vec::new();
                self.append_boundary(first, &mut cycle);
                corners.filter(|(_, corner)| cycle.contains(corner)).map(|(place, _)| place).collect()
            }
            Fit::Face => {
                let face = self.subject.face_of(first).map_err(StepOutcome::Refused)?;
                let same = |corner| self.subject.face_of(corner).is_ok_and(|other| other == face);
                corners.filter(|(_, corner)| same(*corner)).map(|(place, _)| place).collect()
            }
            Fit::Vertex => {
                let vertex = self.vertex_of(first)?;
                let same = |corner| self.vertex_of(corner) == Ok(vertex);
                corners.filter(|(_, corner)| same(*corner)).map(|(place, _)| place).collect()
            }
        })
    }

    /// Appends all corners of one boundary component: no more than there are, even if the subject's cycle never closes.
    fn append_boundary(&self, corner: CornerOf<K>, corners: &mut Vec<CornerOf<K>>) {
        corners.push(corner);
        let Corner::At(start) = corner else { return };
        let mut h = start;
        for _ in 1..self.half_edges.len() {
            match self.subject.next_of(h) {
                Ok(next) if next != start => h = next,
                _ => return,
            }
            corners.push(Corner::At(h));
        }
    }
}
