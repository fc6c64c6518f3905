//! Programs as Rust source, to be pasted into a regression test.

use super::op::{CornerPick, FacePick, HalfEdgePick, InnerPick, Op, Program, SecondPick, VertexPick};
use super::subject::Corner;
use alloc::format;
use alloc::string::String;

impl Program {
    /// The program as a Rust expression, to be read where `twinedge::program::*` is in scope.
    #[must_use]
    pub fn to_rust(&self) -> String {
        let mut source = String::from("Program(vec![\n");
        for op in &self.0 {
            source.push_str("    ");
            source.push_str(&op.to_rust());
            source.push_str(",\n");
        }
        source + "])"
    }
}

impl Op {
    /// The operator as a Rust expression, to be read where `twinedge::program::*` is in scope.
    #[must_use]
    pub fn to_rust(&self) -> String {
        match *self {
            Self::AddIsolatedVertex { face } => format!("Op::AddIsolatedVertex {{ face: {} }}", of_face(face)),
            Self::RemoveIsolatedVertex { vertex } => {
                format!("Op::RemoveIsolatedVertex {{ vertex: {} }}", of_vertex(vertex))
            }
            Self::Connect { from, to, new_face, inner } => format!(
                "Op::Connect {{ from: {}, to: {}, new_face: Side::{new_face:?}, inner: {} }}",
                of_corner(from),
                of_second(to),
                of_inner(inner)
            ),
            Self::RemoveEdge { half_edge } => format!("Op::RemoveEdge {{ half_edge: {} }}", of_half_edge(half_edge)),
            Self::SplitEdge { half_edge } => format!("Op::SplitEdge {{ half_edge: {} }}", of_half_edge(half_edge)),
            Self::JoinEdges { half_edge } => format!("Op::JoinEdges {{ half_edge: {} }}", of_half_edge(half_edge)),
            Self::SplitVertex { from, to } => {
                format!("Op::SplitVertex {{ from: {}, to: {} }}", of_corner(from), of_second(to))
            }
            Self::ContractEdge { half_edge } => {
                format!("Op::ContractEdge {{ half_edge: {} }}", of_half_edge(half_edge))
            }
            Self::FlipEdge { half_edge, turn } => {
                format!("Op::FlipEdge {{ half_edge: {}, turn: Turn::{turn:?} }}", of_half_edge(half_edge))
            }
            Self::MoveInner { inner, face } => {
                format!("Op::MoveInner {{ inner: {}, face: {} }}", of_corner(inner), of_face(face))
            }
        }
    }
}

fn of_half_edge(pick: HalfEdgePick) -> String {
    format!("HalfEdgePick::{pick:?}")
}

fn of_vertex(pick: VertexPick) -> String {
    format!("VertexPick::{pick:?}")
}

fn of_corner(pick: CornerPick) -> String {
    match pick {
        Corner::At(pick) => format!("Corner::At({})", of_half_edge(pick)),
        Corner::Isolated(pick) => format!("Corner::Isolated({})", of_vertex(pick)),
    }
}

fn of_second(pick: SecondPick) -> String {
    match pick {
        SecondPick::Fitting(k) => format!("SecondPick::Fitting({k})"),
        SecondPick::Any(pick) => format!("SecondPick::Any({})", of_corner(pick)),
    }
}

fn of_face(pick: FacePick) -> String {
    match pick {
        FacePick::Unbounded => String::from("FacePick::Unbounded"),
        FacePick::Of(pick) => format!("FacePick::Of({})", of_corner(pick)),
        FacePick::Retired(k) => format!("FacePick::Retired({k})"),
    }
}

fn of_inner(pick: InnerPick) -> String {
    let also = pick.also.map_or_else(|| String::from("None"), |pick| format!("Some({})", of_corner(pick)));
    format!("InnerPick {{ mask: {}, also: {also} }}", pick.mask)
}
