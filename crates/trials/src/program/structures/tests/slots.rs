use twinedge::dcel::Dcel;
use twinedge::program::*;
use twinedge::validate::Expectation;
use twinedge_trials::ReportAudit;

/// how it fails
#[test]
fn regression() {
    let program = "twinedge program 1
        add_isolated_vertex unbounded
        connect i0 ~0 right inner 0 also h1
        flip_edge !h0 cw
    ".parse::<Program>().unwrap();
    let result = conformance::run(&program, ReportAudit::new(Dcel::new()), &Expectation::plane());
    assert!(result.is_ok(), "{result:?}");
}
