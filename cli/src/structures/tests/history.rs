use twinedge::program::*;
use twinedge::validate::Expectation;
use twinedge_trials::Rewound;

/// how it fails
#[test]
fn regression() {
    let program = Program(vec![
        Op::AddIsolatedVertex { face: FacePick::Unbounded },
        Op::Connect { from: Corner::Isolated(VertexPick::Isolated(0)), to: SecondPick::Fitting(0), new_face: Side::Right, inner: InnerPick { mask: 1, also: Some(Corner::At(HalfEdgePick::Live(1))) } },
        Op::FlipEdge { half_edge: HalfEdgePick::Retired(0), turn: Turn::Clockwise },
    ]);
    let result = conformance::run(&program, Rewound::default(), &Expectation::plane());
    assert!(result.is_ok(), "{result:?}");
}
