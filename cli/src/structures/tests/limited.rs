use twinedge::dcel::{Dcel, Room};
use twinedge::program::*;
use twinedge::validate::Expectation;
use twinedge_trials::ReportAudit;

/// how it fails
#[test]
fn regression() {
    let program = Program(vec![
        Op::AddIsolatedVertex { face: FacePick::Unbounded },
        Op::Connect { from: Corner::Isolated(VertexPick::Isolated(0)), to: SecondPick::Fitting(0), new_face: Side::Right, inner: InnerPick { mask: 1, also: Some(Corner::At(HalfEdgePick::Live(1))) } },
        Op::FlipEdge { half_edge: HalfEdgePick::Retired(0), turn: Turn::Clockwise },
    ]);
    let result = conformance::run(&program, ReportAudit::new(Dcel::with_limits(Room { vertices: 24, edges: 40, boundaries: 40, faces: 24 })), &Expectation::plane());
    assert!(result.is_ok(), "{result:?}");
}
