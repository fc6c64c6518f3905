//! Choosing a map, and an operator with its arguments: the part that all harnesses of operators begin with.

use twinedge::program::choose::Choose;
use twinedge::program::{
    Corner, CornerPick, FacePick, HalfEdgePick, InnerPick, Op, OpKind, Runner, SecondPick, Side, Subject, Turn,
    VertexPick,
};

/// The bounds of the maps to choose from.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// The largest number of edges.
    pub edges: usize,
    /// The largest number of components besides the first, each begun as an isolated vertex.
    pub islands: usize,
}

/// The arguments that an operator gets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arguments {
    /// All live handles of the right kind.
    Live,
    /// Also stale handles, and vertices with half-edges where isolated ones are required.
    Any,
}

/// Grows a map from one isolated vertex, by a number of steps up to the bound. Each step adds an edge: a leaf in a
/// corner, or an edge between two corners of a face; or it begins an island in a face.
///
/// Every map of at most `edges` edges and `1 + islands` components arises, and more than once. To see this, remove its
/// edges again, first the edges with a different face on each side, then leaves, until isolated vertices are left: the
/// inverse of each removal is a step. The step moves the contents of the removed edge's face to the new face.
pub fn grow<K: Subject>(runner: &mut Runner<K>, bound: Bound, source: &mut impl Choose) {
    runner.step(Op::AddIsolatedVertex { face: FacePick::Unbounded });
    let mut edges = source.choose(bound.edges + 1);
    let mut islands = source.choose(bound.islands + 1);
    while edges + islands > 0 {
        let island = islands > 0 && (edges == 0 || source.choose(2) == 1);
        if island {
            islands -= 1;
            let face = choose_live_face(runner, source);
            runner.step(Op::AddIsolatedVertex { face });
        } else {
            edges -= 1;
            add_edge(runner, bound, source);
        }
    }
}

fn add_edge<K: Subject>(runner: &mut Runner<K>, bound: Bound, source: &mut impl Choose) {
    let corners = runner.corners().count();
    let first = source.choose(corners);
    let from = nth_corner(runner, first);
    if source.choose(2) == 0 {
        runner.step(Op::SplitVertex { from, to: SecondPick::Any(from) });
        return;
    }
    // The edge from the second corner to the first is the same, but for its sides, which are chosen anyway.
    let face = runner.corners().nth(first).and_then(|corner| runner.subject().face_of(corner).ok());
    let in_face = |corner| runner.subject().face_of(corner).ok() == face;
    let second = source.choose(runner.corners().skip(first).filter(|corner| in_face(*corner)).count());
    let found = (first..).zip(runner.corners().skip(first)).filter(|(_, corner)| in_face(*corner)).nth(second);
    let to = nth_corner(runner, found.map_or(first, |(index, _)| index));
    let new_face = choose_side(source);
    let mask = source.choose(1 << bound.islands) as u16;
    runner.step(Op::Connect { from, to: SecondPick::Any(to), new_face, inner: InnerPick { mask, also: None } });
}

/// Chooses an operator's arguments, each from all candidates. Returns `None` if an argument has no candidate, or if it
/// is an operator of meshes.
///
/// `Connect` may send any of the first `islands` other boundary components of the face to the new one, and with
/// [`Arguments::Any`] some other boundary component instead.
pub fn choose_op<K: Subject>(
    operator: OpKind,
    arguments: Arguments,
    islands: usize,
    runner: &Runner<K>,
    source: &mut impl Choose,
) -> Option<Op> {
    Some(match operator {
        OpKind::AddIsolatedVertex => Op::AddIsolatedVertex { face: choose_face(runner, arguments, source) },
        OpKind::RemoveIsolatedVertex => Op::RemoveIsolatedVertex { vertex: choose_vertex(runner, arguments, source)? },
        OpKind::Connect => {
            let from = choose_corner(runner, arguments, source)?;
            let to = SecondPick::Any(choose_corner(runner, arguments, source)?);
            let new_face = choose_side(source);
            let strange = arguments == Arguments::Any && source.choose(2) == 1;
            let inner = if strange {
                InnerPick { mask: 0, also: Some(choose_corner(runner, arguments, source)?) }
            } else {
                InnerPick { mask: source.choose(1 << islands) as u16, also: None }
            };
            Op::Connect { from, to, new_face, inner }
        }
        OpKind::RemoveEdge => Op::RemoveEdge { half_edge: choose_half_edge(runner, arguments, source)? },
        OpKind::SplitEdge => Op::SplitEdge { half_edge: choose_half_edge(runner, arguments, source)? },
        OpKind::JoinEdges => Op::JoinEdges { half_edge: choose_half_edge(runner, arguments, source)? },
        OpKind::SplitVertex => Op::SplitVertex {
            from: choose_corner(runner, arguments, source)?,
            to: SecondPick::Any(choose_corner(runner, arguments, source)?),
        },
        OpKind::ContractEdge => Op::ContractEdge { half_edge: choose_half_edge(runner, arguments, source)? },
        OpKind::FlipEdge => {
            Op::FlipEdge { half_edge: choose_half_edge(runner, arguments, source)?, turn: choose_turn(source) }
        }
        OpKind::MoveInner => Op::MoveInner {
            inner: choose_corner(runner, arguments, source)?,
            face: choose_face(runner, arguments, source),
        },
        OpKind::MeshFlipEdge | OpKind::MeshSplitEdge | OpKind::MeshSplitFace | OpKind::MeshCollapseEdge => return None,
    })
}

pub(crate) fn choose_side(source: &mut impl Choose) -> Side {
    if source.choose(2) == 0 { Side::Left } else { Side::Right }
}

pub(crate) fn choose_turn(source: &mut impl Choose) -> Turn {
    if source.choose(2) == 0 { Turn::CounterClockwise } else { Turn::Clockwise }
}

/// Returns the pick of a corner by its position in [`Runner::corners`].
fn nth_corner<K: Subject>(runner: &Runner<K>, index: usize) -> CornerPick {
    match index.checked_sub(runner.half_edges().len()) {
        None => Corner::At(HalfEdgePick::Live(index as u32)),
        Some(isolated) => Corner::Isolated(VertexPick::Isolated(isolated as u32)),
    }
}

fn choose_half_edge<K: Subject>(
    runner: &Runner<K>,
    arguments: Arguments,
    source: &mut impl Choose,
) -> Option<HalfEdgePick> {
    let live = runner.half_edges().len();
    let stale = if arguments == Arguments::Any { runner.retired_half_edges().len() } else { 0 };
    if live + stale == 0 {
        return None;
    }
    let k = source.choose(live + stale);
    Some(match k.checked_sub(live) {
        None => HalfEdgePick::Live(k as u32),
        Some(k) => HalfEdgePick::Retired(k as u32),
    })
}

fn choose_vertex<K: Subject>(runner: &Runner<K>, arguments: Arguments, source: &mut impl Choose) -> Option<VertexPick> {
    let isolated = runner.isolated().len();
    let (others, stale) = match arguments {
        Arguments::Live => (0, 0),
        Arguments::Any => (runner.half_edges().len(), runner.retired_vertices().len()),
    };
    if isolated + others + stale == 0 {
        return None;
    }
    let k = source.choose(isolated + others + stale);
    Some(match (k.checked_sub(isolated), k.checked_sub(isolated + others)) {
        (None, _) => VertexPick::Isolated(k as u32),
        (Some(k), None) => VertexPick::OriginOf(k as u32),
        (_, Some(k)) => VertexPick::Retired(k as u32),
    })
}

fn choose_corner<K: Subject>(runner: &Runner<K>, arguments: Arguments, source: &mut impl Choose) -> Option<CornerPick> {
    match arguments {
        Arguments::Live => {
            let corners = runner.corners().count();
            (corners > 0).then(|| nth_corner(runner, source.choose(corners)))
        }
        Arguments::Any if source.choose(2) == 0 => choose_half_edge(runner, arguments, source).map(Corner::At),
        Arguments::Any => choose_vertex(runner, arguments, source).map(Corner::Isolated),
    }
}

fn choose_live_face<K: Subject>(runner: &Runner<K>, source: &mut impl Choose) -> FacePick {
    choose_face(runner, Arguments::Live, source)
}

/// A bounded face is named by the first half-edge that bounds it.
fn choose_face<K: Subject>(runner: &Runner<K>, arguments: Arguments, source: &mut impl Choose) -> FacePick {
    let face_of = |h| runner.subject().face_of(Corner::At(h)).ok();
    let unbounded = runner.subject().unbounded_face();
    let is_first = |i: usize| {
        let face = face_of(runner.half_edges()[i]);
        face != unbounded && !runner.half_edges()[..i].iter().any(|h| face_of(*h) == face)
    };
    let bounded = || (0..runner.half_edges().len()).filter(|i| is_first(*i));
    let live = 1 + bounded().count();
    let stale = if arguments == Arguments::Any { runner.retired_faces().len() } else { 0 };
    let k = source.choose(live + stale);
    if let Some(k) = k.checked_sub(live) {
        return FacePick::Retired(k as u32);
    }
    let named = k.checked_sub(1).and_then(|k| bounded().nth(k));
    named.map_or(FacePick::Unbounded, |i| FacePick::Of(Corner::At(HalfEdgePick::Live(i as u32))))
}
