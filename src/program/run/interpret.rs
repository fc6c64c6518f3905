//! The interpreter: it chooses arguments as a program says, calls, and keeps the lists of handles.

use super::outcome::StepOutcome;
use super::resolve::Resolve;
use super::runner::Runner;
use crate::dcel::{Corner, Side, Turn};
use crate::program::operators::{Call, CallOf, Fit, Op, Program, operators};
use crate::program::subject::{CornerOf, Refusal, Subject};
use alloc::vec::Vec;

macro_rules! define_call {
    ($($variant:ident $method:ident $share:literal {
        changes [$($change:expr),+]
        $($arg:ident: $pick:ty => $handle:ty, $depends:tt;)*
    })*) => {
        impl<K: Subject> Runner<K> {
            /// Resolves the choices of an operator as they are now. Costs as much as [`Runner::step`].
            ///
            /// # Errors
            /// What becomes of the operator if it cannot choose: [`StepOutcome::Skipped`] where there is nothing to choose
            /// from, and [`StepOutcome::Refused`] where the subject refuses a question.
            pub fn resolve(&self, op: Op) -> Result<CallOf<K>, StepOutcome> {
                match op {
                    $(Op::$variant { $($arg),* } => {
                        $(let $arg = $arg.resolve(self, $depends)?;)*
                        Ok(Call::$variant { $($arg),* })
                    })*
                }
            }

            /// Calls, and keeps the lists of handles.
            pub(in crate::program) fn call(&mut self, call: CallOf<K>) -> Result<(), StepOutcome> {
                match call {
                    $(Call::$variant { $($arg),* } => self.$method($($arg),*),)*
                }
            }
        }
    };
}
operators!(define_call);

impl<K: Subject> Runner<K> {
    /// Runs a whole program and tells what became of each operator.
    pub fn run(&mut self, program: &Program) -> Vec<StepOutcome> {
        program.0.iter().map(|op| self.step(*op)).collect()
    }

    /// Runs one operator: chooses its arguments, and calls it.
    ///
    /// O(live elements) beside what the operator itself costs, and O(length²) of the boundary of the face that is split
    /// if some of its inner boundary components are to be chosen.
    pub fn step(&mut self, op: Op) -> StepOutcome {
        self.resolve(op).and_then(|call| self.call(call)).err().unwrap_or(StepOutcome::Applied)
    }

    fn add_isolated_vertex(&mut self, face: K::Face) -> Result<(), StepOutcome> {
        let v = self.subject.add_isolated_vertex(face).map_err(StepOutcome::Refused)?;
        self.isolated.push(v);
        Ok(())
    }

    fn remove_isolated_vertex(&mut self, v: K::Vertex) -> Result<(), StepOutcome> {
        self.subject.remove_isolated_vertex(v).map_err(StepOutcome::Refused)?;
        self.no_longer_isolated(v);
        self.retired_vertices.push(v);
        Ok(())
    }

    #[allow(clippy::needless_pass_by_value, reason = "the arguments of a call are handed over as they are")]
    fn connect(
        &mut self,
        from: CornerOf<K>,
        to: CornerOf<K>,
        new_face: Side,
        inner: Vec<CornerOf<K>>,
    ) -> Result<(), StepOutcome> {
        let n = self.subject.connect(from, to, new_face, &inner).map_err(StepOutcome::Refused)?;
        for corner in [from, to] {
            if let Corner::Isolated(v) = corner {
                self.no_longer_isolated(v);
            }
        }
        self.made_edge(n)
    }

    fn remove_edge(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let ends = self.ends(h);
        let dropped = self.subject.remove_edge(h).map_err(StepOutcome::Refused)?;
        self.retired_faces.extend(dropped);
        self.retire_edge(h);
        // Of a stale handle there are none. If it was not refused, that shows in the outcome.
        for v in ends.into_iter().flatten() {
            self.perhaps_isolated(v);
        }
        Ok(())
    }

    fn split_edge(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let n = self.subject.split_edge(h).map_err(StepOutcome::Refused)?;
        self.made_edge(n)
    }

    fn join_edges(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let following = self.subject.next_of(h).and_then(|next| Ok((next, self.subject.origin_of(next)?)));
        if following == Err(Refusal::Unsupported) {
            // On a border without `next`: which edge is removed cannot be said.
            return Err(StepOutcome::Refused(Refusal::Unsupported));
        }
        self.subject.join_edges(h).map_err(StepOutcome::Refused)?;
        if let Ok((following, v)) = following {
            self.retire_edge(following);
            self.retired_vertices.push(v);
        }
        Ok(())
    }

    fn split_vertex(&mut self, from: CornerOf<K>, to: CornerOf<K>) -> Result<(), StepOutcome> {
        let n = self.subject.split_vertex(from, to).map_err(StepOutcome::Refused)?;
        if let Corner::Isolated(v) = from {
            self.no_longer_isolated(v);
        }
        self.made_edge(n)
    }

    fn contract_edge(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let ends = self.ends(h);
        let dropped = self.subject.contract_edge(h).map_err(StepOutcome::Refused)?;
        self.retire_edge(h);
        self.retired_vertices.push(dropped);
        if let Ok([origin, target]) = ends {
            self.perhaps_isolated(if dropped == origin { target } else { origin });
        }
        Ok(())
    }

    fn flip_edge(&mut self, h: K::HalfEdge, turn: Turn) -> Result<(), StepOutcome> {
        self.subject.flip_edge(h, turn).map_err(StepOutcome::Refused)
    }

    fn move_inner(&mut self, inner: CornerOf<K>, face: K::Face) -> Result<(), StepOutcome> {
        self.subject.move_inner(inner, face).map_err(StepOutcome::Refused)
    }

    /// The ends of an edge, to be asked before it is gone. Where the handle is stale this is refused, but it is for the operator
    /// to say so.
    fn ends(&self, h: K::HalfEdge) -> Result<[K::Vertex; 2], Refusal> {
        let target = self.subject.twin_of(h).and_then(|t| self.subject.origin_of(t));
        Ok([self.subject.origin_of(h)?, target?])
    }

    pub(in crate::program) fn made_edge(&mut self, h: K::HalfEdge) -> Result<(), StepOutcome> {
        let t = self.subject.twin_of(h).map_err(StepOutcome::Refused)?;
        self.half_edges.extend([h, t]);
        Ok(())
    }

    pub(in crate::program) fn retire_edge(&mut self, h: K::HalfEdge) {
        let gone = self.forget_edge(h);
        self.retired_half_edges.extend(gone.into_iter().flatten());
    }

    /// Takes an edge off the list of those there are.
    pub(in crate::program) fn forget_edge(&mut self, h: K::HalfEdge) -> Option<[K::HalfEdge; 2]> {
        let first = self.half_edges.iter().position(|other| *other == h)? & !1;
        let twin = self.half_edges.remove(first + 1);
        Some([self.half_edges.remove(first), twin])
    }

    fn no_longer_isolated(&mut self, v: K::Vertex) {
        self.isolated.retain(|other| *other != v);
    }

    /// Lists a vertex that has just lost an edge among the isolated ones if it was its last.
    fn perhaps_isolated(&mut self, v: K::Vertex) {
        if self.subject.face_of(Corner::Isolated(v)).is_ok() && !self.isolated.contains(&v) {
            self.isolated.push(v);
        }
    }
}
