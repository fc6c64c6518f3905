//! A census of small maps: every one up to a bound, once, grown by the operators.
//!
//! ```
//! use twinedge_trials::census::{Census, Scope};
//! // Connected maps with a distinguished outside, by their number of edges: Liskovets and Walsh, OEIS A103937.
//! let mut counts = [0; 4];
//! for map in Census::new(Scope::Connected { edges: 3 }) {
//!     counts[map.runner.subject().edge_count()] += 1;
//! }
//! assert_eq!(counts, [1, 2, 6, 26]);
//! ```
//!
//! # How
//!
//! Starting with the smallest map, [every operator](every_op) that makes something is applied to every map found, and the result
//! is new if its [canonical form](crate::canonical) is unknown. Missing maps would show, as the numbers are
//! published.
//!
//! All maps are reached. An edge of a connected map can be removed if it separates two faces, or contracted if it does not; the
//! inverses [`split_vertex`](Op::SplitVertex) and [`connect`](Op::Connect) therefore make each map from one with an edge less.
//! Any subdivision results from isolated vertices by [`connect`](Op::Connect) alone.

use crate::canonical::{Canonizer, Code};
use std::collections::{BTreeSet, VecDeque};
use twinedge::dcel::{Corner, Dcel, Side};
use twinedge::program::{
    FacePick, HalfEdgePick, InnerPick, Op, Program, Runner, SecondPick, StepOutcome, VertexPick, every_op,
};

/// The maps of a census.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Scope {
    /// Connected maps, starting with one vertex.
    Connected {
        /// The largest number of edges.
        edges: usize,
    },
    /// All planar subdivisions: with several components or none, nested or side by side, and with isolated vertices.
    Subdivisions {
        /// The largest number of edges.
        edges: usize,
        /// The largest number of vertices.
        vertices: usize,
    },
}

impl Scope {
    /// Returns a program that makes the smallest map. It makes and removes some more records first, so that there are handles of
    /// removed half-edges, vertices and faces.
    #[must_use]
    pub fn start(&self) -> Program {
        let add = Op::AddIsolatedVertex { face: FacePick::Unbounded };
        let vertex = Corner::Isolated(VertexPick::Isolated(0));
        let mut ops = vec![
            add,
            Op::Connect {
                from: vertex,
                to: SecondPick::Any(vertex),
                new_face: Side::Left,
                inner: InnerPick { mask: 0, also: None },
            },
            Op::RemoveEdge { half_edge: HalfEdgePick::Live(0) },
            Op::RemoveIsolatedVertex { vertex: VertexPick::Isolated(0) },
        ];
        if matches!(self, Self::Connected { .. }) {
            ops.push(add);
        }
        Program(ops)
    }

    /// Returns true if the census includes this map. O(1).
    #[must_use]
    pub fn takes_in(&self, map: &Dcel) -> bool {
        match *self {
            // In a valid map, V − E + F = 1 + C.
            Self::Connected { edges } => {
                let (v, e, f) = (map.vertex_count(), map.edge_count(), map.face_count());
                e <= edges && v + f == e + 2
            }
            Self::Subdivisions { edges, vertices } => map.edge_count() <= edges && map.vertex_count() <= vertices,
        }
    }
}

/// A map of a census.
#[derive(Clone, Debug)]
pub struct Discovery {
    /// The map, with its handles.
    pub runner: Runner<Dcel>,
    /// The program that made it.
    pub program: Program,
}

/// The maps of a census, one after the other; the connected ones of [`Scope::Connected`] in order of their edges.
///
/// Time and memory are proportional to the number of maps, which grows about ninefold with each edge.
#[derive(Debug)]
pub struct Census {
    scope: Scope,
    canonizer: Canonizer,
    seen: BTreeSet<Code>,
    waiting: VecDeque<Discovery>,
}

impl Census {
    /// Begins a census.
    #[must_use]
    pub fn new(scope: Scope) -> Self {
        let mut census = Self { scope, canonizer: Canonizer::new(), seen: BTreeSet::new(), waiting: VecDeque::new() };
        let mut runner = Runner::new(Dcel::new());
        let program = scope.start();
        runner.run(&program);
        if scope.takes_in(runner.subject()) {
            census.meet(Discovery { runner, program });
        }
        census
    }

    fn meet(&mut self, found: Discovery) {
        let code = self.canonizer.subdivision(found.runner.subject());
        if code.is_some_and(|code| self.seen.insert(code)) {
            self.waiting.push_back(found);
        }
    }
}

impl Iterator for Census {
    type Item = Discovery;

    fn next(&mut self) -> Option<Discovery> {
        let found = self.waiting.pop_front()?;
        let makes = |op: &Op| matches!(op, Op::AddIsolatedVertex { .. } | Op::Connect { .. } | Op::SplitVertex { .. });
        for op in every_op(&found.runner).into_iter().filter(makes) {
            let mut runner = found.runner.clone();
            if runner.step(op) == StepOutcome::Applied && self.scope.takes_in(runner.subject()) {
                let mut program = found.program.clone();
                program.0.push(op);
                self.meet(Discovery { runner, program });
            }
        }
        Some(found)
    }
}
