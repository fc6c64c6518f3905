//! Simpler operators of the same kind.

use super::op::{CornerPick, FacePick, HalfEdgePick, InnerPick, Op, SecondPick, VertexPick};
use super::subject::Corner;
use crate::dcel::{Side, Turn};
use alloc::vec;
use alloc::vec::Vec;

impl Op {
    /// The same operator with one argument simplified, in every way there is.
    #[must_use]
    pub fn simpler(self) -> Vec<Self> {
        match self {
            Self::AddIsolatedVertex { face } => map(simpler_face(face), |face| Self::AddIsolatedVertex { face }),
            Self::RemoveIsolatedVertex { vertex } => {
                map(simpler_vertex(vertex), |vertex| Self::RemoveIsolatedVertex { vertex })
            }
            Self::Connect { from, to, new_face, inner } => {
                let sides = if new_face == Side::Right { vec![Side::Left] } else { Vec::new() };
                let mut all = map(simpler_inner(inner), |inner| Self::Connect { from, to, new_face, inner });
                all.extend(map(simpler_corner(from), |from| Self::Connect { from, to, new_face, inner }));
                all.extend(map(simpler_second(to), |to| Self::Connect { from, to, new_face, inner }));
                all.extend(map(sides, |new_face| Self::Connect { from, to, new_face, inner }));
                all
            }
            Self::RemoveEdge { half_edge } => {
                map(simpler_half_edge(half_edge), |half_edge| Self::RemoveEdge { half_edge })
            }
            Self::SplitEdge { half_edge } => {
                map(simpler_half_edge(half_edge), |half_edge| Self::SplitEdge { half_edge })
            }
            Self::JoinEdges { half_edge } => {
                map(simpler_half_edge(half_edge), |half_edge| Self::JoinEdges { half_edge })
            }
            Self::SplitVertex { from, to } => {
                let mut all = map(simpler_corner(from), |from| Self::SplitVertex { from, to });
                all.extend(map(simpler_second(to), |to| Self::SplitVertex { from, to }));
                all
            }
            Self::ContractEdge { half_edge } => {
                map(simpler_half_edge(half_edge), |half_edge| Self::ContractEdge { half_edge })
            }
            Self::FlipEdge { half_edge, turn } => {
                let turns = if turn == Turn::Clockwise { vec![Turn::CounterClockwise] } else { Vec::new() };
                let mut all = map(simpler_half_edge(half_edge), |half_edge| Self::FlipEdge { half_edge, turn });
                all.extend(map(turns, |turn| Self::FlipEdge { half_edge, turn }));
                all
            }
            Self::MoveInner { inner, face } => {
                let mut all = map(simpler_corner(inner), |inner| Self::MoveInner { inner, face });
                all.extend(map(simpler_face(face), |face| Self::MoveInner { inner, face }));
                all
            }
        }
    }
}

fn map<T, U>(all: Vec<T>, f: impl FnMut(T) -> U) -> Vec<U> {
    all.into_iter().map(f).collect()
}

/// Smaller numbers, the smallest first.
fn smaller(k: u16) -> Vec<u16> {
    let mut all = vec![0, k / 2, k.saturating_sub(1)];
    all.dedup();
    all.retain(|smaller| *smaller < k);
    all
}

fn simpler_half_edge(pick: HalfEdgePick) -> Vec<HalfEdgePick> {
    match pick {
        HalfEdgePick::Live(k) => map(smaller(k), HalfEdgePick::Live),
        HalfEdgePick::Retired(k) => {
            let mut all = vec![HalfEdgePick::Live(k)];
            all.extend(map(smaller(k), HalfEdgePick::Retired));
            all
        }
    }
}

fn simpler_vertex(pick: VertexPick) -> Vec<VertexPick> {
    let (k, same): (u16, fn(u16) -> VertexPick) = match pick {
        VertexPick::Isolated(k) => return map(smaller(k), VertexPick::Isolated),
        VertexPick::OriginOf(k) => (k, VertexPick::OriginOf),
        VertexPick::Retired(k) => (k, VertexPick::Retired),
    };
    let mut all = vec![VertexPick::Isolated(k)];
    all.extend(map(smaller(k), same));
    all
}

fn simpler_corner(pick: CornerPick) -> Vec<CornerPick> {
    match pick {
        Corner::At(pick) => map(simpler_half_edge(pick), Corner::At),
        Corner::Isolated(pick) => map(simpler_vertex(pick), Corner::Isolated),
    }
}

fn simpler_second(pick: SecondPick) -> Vec<SecondPick> {
    match pick {
        SecondPick::Fitting(k) => map(smaller(k), SecondPick::Fitting),
        SecondPick::Any(pick) => {
            let mut all = vec![SecondPick::Fitting(0), SecondPick::Fitting(1)];
            all.extend(map(simpler_corner(pick), SecondPick::Any));
            all
        }
    }
}

fn simpler_face(pick: FacePick) -> Vec<FacePick> {
    let mut all = vec![FacePick::Unbounded];
    match pick {
        FacePick::Unbounded => all.clear(),
        FacePick::Of(pick) => all.extend(map(simpler_corner(pick), FacePick::Of)),
        FacePick::Retired(k) => all.extend(map(smaller(k), FacePick::Retired)),
    }
    all
}

fn simpler_inner(inner: InnerPick) -> Vec<InnerPick> {
    let InnerPick { mask, also } = inner;
    let mut all = Vec::new();
    if also.is_some() && mask != 0 {
        all.push(InnerPick::default());
    }
    if let Some(pick) = also {
        all.push(InnerPick { mask, also: None });
        all.extend(map(simpler_corner(pick), |pick| InnerPick { mask, also: Some(pick) }));
    }
    let bits = (0..16).map(|bit| 1 << bit).filter(|bit| mask & bit != 0 && *bit != mask);
    all.extend(
        (mask != 0).then_some(0).into_iter().chain(bits.map(|bit| mask & !bit)).map(|mask| InnerPick { mask, also }),
    );
    all
}
