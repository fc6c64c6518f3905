use twinedge::dcel::Dcel;
use twinedge::program::*;
use twinedge::validate::Expectation;

/// how it fails
#[test]
fn regression() {
    let program = "twinedge program 1
        add_isolated_vertex unbounded
        connect i0 ~0 right inner 0 also h1
        flip_edge !h0 cw
    ".parse::<Program>().unwrap();
    // The structure with the planted bug is not public. This one passes.
    let result = conformance::run(&program, Dcel::new(), &Expectation::plane());
    assert!(result.is_ok(), "{result:?}");
}
