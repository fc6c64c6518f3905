//! The list of harnesses. The bound is in the name: the largest numbers of edges and of components besides the first.
//!
//! The bounds of `unwind` are generous guesses: the longest loops go over the slots of the store, the corners of the
//! map, or (64) the numbers of a canonical form. If one is too small, Kani fails and says so; it never passes for a
//! proof.

use crate::engine::harnesses;
use crate::grow::Bound;
use crate::judges::{Judge, Tables, agrees_with_reference};
use crate::operators::{HandleKind, is_undone, keeps_rules, refuses_stale, refuses_without_a_trace};
#[cfg(not(kani))]
use crate::planted::{Fault, Field, Planted};
use twinedge::dcel::{Dcel, Room};
use twinedge::program::OpKind;
#[cfg(not(kani))]
use twinedge::validate::Rule;

/// Room for the result of one operator on three edges and an island (or two of each).
fn roomy() -> Dcel {
    Dcel::with_limits(Room { vertices: 6, edges: 5, boundaries: 7, faces: 5 })
}

/// Less room than two edges and an island can need, so that operators are refused for lack of room.
fn tight() -> Dcel {
    Dcel::with_limits(Room { vertices: 3, edges: 2, boundaries: 2, faces: 2 })
}

const fn maps(edges: usize, islands: usize) -> Bound {
    Bound { edges, islands }
}

harnesses! {
    add_isolated_vertex_keeps_rules_on_maps_of_3_edges_and_1_island (unwind 32) =
        |subject, source| keeps_rules(OpKind::AddIsolatedVertex, maps(3, 1), subject, source);
        with roomy(),
        but "a rule is broken" with Planted::new(roomy(), Fault::Loses(OpKind::AddIsolatedVertex, Field::Inner));

    remove_isolated_vertex_keeps_rules_on_maps_of_3_edges_and_1_island (unwind 32) =
        |subject, source| keeps_rules(OpKind::RemoveIsolatedVertex, maps(3, 1), subject, source);
        with roomy(),
        but "a rule is broken" with Planted::new(roomy(), Fault::Loses(OpKind::RemoveIsolatedVertex, Field::Inner));

    connect_keeps_rules_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| keeps_rules(OpKind::Connect, maps(2, 1), subject, source);
        with roomy(),
        but "a rule is broken" with Planted::new(roomy(), Fault::Loses(OpKind::Connect, Field::Boundary));

    remove_edge_keeps_rules_on_maps_of_3_edges_and_1_island (unwind 32) =
        |subject, source| keeps_rules(OpKind::RemoveEdge, maps(3, 1), subject, source);
        with roomy(),
        but "a rule is broken" with Planted::new(roomy(), Fault::Loses(OpKind::RemoveEdge, Field::Leaving));

    split_edge_keeps_rules_on_maps_of_3_edges_and_1_island (unwind 32) =
        |subject, source| keeps_rules(OpKind::SplitEdge, maps(3, 1), subject, source);
        with roomy(),
        but "a rule is broken" with Planted::new(roomy(), Fault::Loses(OpKind::SplitEdge, Field::Prev));

    join_edges_keeps_rules_on_maps_of_3_edges_and_1_island (unwind 32) =
        |subject, source| keeps_rules(OpKind::JoinEdges, maps(3, 1), subject, source);
        with roomy(),
        but "a rule is broken" with Planted::new(roomy(), Fault::Loses(OpKind::JoinEdges, Field::Origin));

    split_vertex_keeps_rules_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| keeps_rules(OpKind::SplitVertex, maps(2, 1), subject, source);
        with roomy(),
        but "a rule is broken" with Planted::new(roomy(), Fault::Loses(OpKind::SplitVertex, Field::Next));

    contract_edge_keeps_rules_on_maps_of_3_edges_and_1_island (unwind 32) =
        |subject, source| keeps_rules(OpKind::ContractEdge, maps(3, 1), subject, source);
        with roomy(),
        but "a rule is broken" with Planted::new(roomy(), Fault::Loses(OpKind::ContractEdge, Field::Origin));

    flip_edge_keeps_rules_on_maps_of_3_edges_and_1_island (unwind 32) =
        |subject, source| keeps_rules(OpKind::FlipEdge, maps(3, 1), subject, source);
        with roomy(),
        but "a rule is broken" with Planted::new(roomy(), Fault::Loses(OpKind::FlipEdge, Field::Boundary));

    move_inner_keeps_rules_on_maps_of_2_edges_and_2_islands (unwind 32) =
        |subject, source| keeps_rules(OpKind::MoveInner, maps(2, 2), subject, source);
        with roomy(),
        but "a rule is broken" with Planted::new(roomy(), Fault::Loses(OpKind::MoveInner, Field::Face));

    add_isolated_vertex_is_undone_on_maps_of_3_edges_and_1_island (unwind 64) =
        |subject, source| is_undone(OpKind::AddIsolatedVertex, maps(3, 1), subject, source);
        with roomy(),
        but "is not undone" with Planted::new(roomy(), Fault::Skips(OpKind::RemoveIsolatedVertex, 0));

    remove_isolated_vertex_is_undone_on_maps_of_3_edges_and_1_island (unwind 64) =
        |subject, source| is_undone(OpKind::RemoveIsolatedVertex, maps(3, 1), subject, source);
        with roomy(),
        but "is not undone" with Planted::new(roomy(), Fault::Skips(OpKind::RemoveIsolatedVertex, 0));

    connect_is_undone_on_maps_of_2_edges_and_1_island (unwind 64) =
        |subject, source| is_undone(OpKind::Connect, maps(2, 1), subject, source);
        with roomy(),
        but "is not undone" with Planted::new(roomy(), Fault::Skips(OpKind::RemoveEdge, 0));

    remove_edge_is_undone_on_maps_of_3_edges_and_1_island (unwind 64) =
        |subject, source| is_undone(OpKind::RemoveEdge, maps(3, 1), subject, source);
        with roomy(),
        but "is not undone" with Planted::new(roomy(), Fault::Skips(OpKind::RemoveEdge, 0));

    split_edge_is_undone_on_maps_of_3_edges_and_1_island (unwind 64) =
        |subject, source| is_undone(OpKind::SplitEdge, maps(3, 1), subject, source);
        with roomy(),
        but "is not undone" with Planted::new(roomy(), Fault::Skips(OpKind::JoinEdges, 0));

    join_edges_is_undone_on_maps_of_3_edges_and_1_island (unwind 64) =
        |subject, source| is_undone(OpKind::JoinEdges, maps(3, 1), subject, source);
        with roomy(),
        but "is not undone" with Planted::new(roomy(), Fault::Skips(OpKind::JoinEdges, 0));

    split_vertex_is_undone_on_maps_of_2_edges_and_1_island (unwind 64) =
        |subject, source| is_undone(OpKind::SplitVertex, maps(2, 1), subject, source);
        with roomy(),
        but "is not undone" with Planted::new(roomy(), Fault::Skips(OpKind::ContractEdge, 0));

    contract_edge_is_undone_on_maps_of_3_edges_and_1_island (unwind 64) =
        |subject, source| is_undone(OpKind::ContractEdge, maps(3, 1), subject, source);
        with roomy(),
        but "is not undone" with Planted::new(roomy(), Fault::Skips(OpKind::ContractEdge, 0));

    flip_edge_is_undone_on_maps_of_3_edges_and_1_island (unwind 64) =
        |subject, source| is_undone(OpKind::FlipEdge, maps(3, 1), subject, source);
        with roomy(),
        but "is not undone" with Planted::new(roomy(), Fault::Skips(OpKind::FlipEdge, 1));

    move_inner_is_undone_on_maps_of_2_edges_and_2_islands (unwind 64) =
        |subject, source| is_undone(OpKind::MoveInner, maps(2, 2), subject, source);
        with roomy(),
        but "is not undone" with Planted::new(roomy(), Fault::Skips(OpKind::MoveInner, 1));

    add_isolated_vertex_refuses_without_a_trace_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| refuses_without_a_trace(OpKind::AddIsolatedVertex, maps(2, 1), subject, source);
        with tight(),
        but "a trace is left" with Planted::new(tight(), Fault::LeavesTrace(OpKind::AddIsolatedVertex));

    remove_isolated_vertex_refuses_without_a_trace_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| refuses_without_a_trace(OpKind::RemoveIsolatedVertex, maps(2, 1), subject, source);
        with tight(),
        but "a trace is left" with Planted::new(tight(), Fault::LeavesTrace(OpKind::RemoveIsolatedVertex));

    connect_refuses_without_a_trace_on_maps_of_1_edge_and_1_island (unwind 32) =
        |subject, source| refuses_without_a_trace(OpKind::Connect, maps(1, 1), subject, source);
        with tight(),
        but "a trace is left" with Planted::new(tight(), Fault::LeavesTrace(OpKind::Connect));

    remove_edge_refuses_without_a_trace_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| refuses_without_a_trace(OpKind::RemoveEdge, maps(2, 1), subject, source);
        with tight(),
        but "a trace is left" with Planted::new(tight(), Fault::LeavesTrace(OpKind::RemoveEdge));

    split_edge_refuses_without_a_trace_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| refuses_without_a_trace(OpKind::SplitEdge, maps(2, 1), subject, source);
        with tight(),
        but "a trace is left" with Planted::new(tight(), Fault::LeavesTrace(OpKind::SplitEdge));

    join_edges_refuses_without_a_trace_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| refuses_without_a_trace(OpKind::JoinEdges, maps(2, 1), subject, source);
        with tight(),
        but "a trace is left" with Planted::new(tight(), Fault::LeavesTrace(OpKind::JoinEdges));

    split_vertex_refuses_without_a_trace_on_maps_of_1_edge_and_1_island (unwind 32) =
        |subject, source| refuses_without_a_trace(OpKind::SplitVertex, maps(1, 1), subject, source);
        with tight(),
        but "a trace is left" with Planted::new(tight(), Fault::LeavesTrace(OpKind::SplitVertex));

    contract_edge_refuses_without_a_trace_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| refuses_without_a_trace(OpKind::ContractEdge, maps(2, 1), subject, source);
        with tight(),
        but "a trace is left" with Planted::new(tight(), Fault::LeavesTrace(OpKind::ContractEdge));

    flip_edge_refuses_without_a_trace_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| refuses_without_a_trace(OpKind::FlipEdge, maps(2, 1), subject, source);
        with tight(),
        but "a trace is left" with Planted::new(tight(), Fault::LeavesTrace(OpKind::FlipEdge));

    move_inner_refuses_without_a_trace_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| refuses_without_a_trace(OpKind::MoveInner, maps(2, 1), subject, source);
        with tight(),
        but "a trace is left" with Planted::new(tight(), Fault::LeavesTrace(OpKind::MoveInner));

    stale_vertex_is_refused_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| refuses_stale(HandleKind::Vertex, maps(2, 1), subject, source);
        with roomy(),
        but "a stale handle is not refused" with Planted::new(roomy(), Fault::TakesStale(HandleKind::Vertex));

    stale_half_edge_is_refused_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| refuses_stale(HandleKind::HalfEdge, maps(2, 1), subject, source);
        with roomy(),
        but "a stale handle is not refused" with Planted::new(roomy(), Fault::TakesStale(HandleKind::HalfEdge));

    stale_face_is_refused_on_maps_of_2_edges_and_1_island (unwind 32) =
        |subject, source| refuses_stale(HandleKind::Face, maps(2, 1), subject, source);
        with roomy(),
        but "a stale handle is not refused" with Planted::new(roomy(), Fault::TakesStale(HandleKind::Face));

    validators_agree_on_tables_of_2_half_edges (unwind 32) =
        |judge, source| agrees_with_reference(judge, Tables::Links { half_edges: 2, vertices: 1 }, source);
        with Judge::Fast,
        but "the validators differ" with Judge::BlindTo(Rule::L2);

    validators_agree_on_tables_of_1_vertex_and_1_face (unwind 32) =
        |judge, source| agrees_with_reference(judge, Tables::Vertex, source);
        with Judge::Fast,
        but "the validators differ" with Judge::BlindTo(Rule::F2);

    validators_agree_on_tables_of_1_loop_and_2_faces (unwind 32) =
        |judge, source| agrees_with_reference(judge, Tables::Loop, source);
        with Judge::Fast,
        but "the validators differ" with Judge::BlindTo(Rule::F1);
}
