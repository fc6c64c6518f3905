//! The reports of the operators, with and without limits.

use twinedge::dcel::{Dcel, Room};
use twinedge::program::{Program, conformance};
use twinedge::validate::Expectation;
use twinedge_trials::ReportAudit;

fn holds(make: impl Fn() -> ReportAudit) {
    let mut applied = 0;
    for number in 0..60_u32 {
        // Any bytes will do: a multiplicative generator.
        let mut state = number.wrapping_mul(0x9E37_79B9) | 1;
        let bytes: Vec<u8> = (0..600)
            .map(|_| {
                state = state.wrapping_mul(48_271) % 0x7FFF_FFFF;
                (state >> 8) as u8
            })
            .collect();
        let summary = conformance::run(&Program::from_bytes(&bytes), make(), &Expectation::plane()).unwrap();
        applied += summary.total().applied;
    }
    assert!(applied > 300, "{applied}");
}

#[test]
fn reports_are_right() {
    holds(ReportAudit::default);
    let most = Room { vertices: 12, edges: 16, boundaries: 12, faces: 8 };
    holds(|| ReportAudit::new(Dcel::with_limits(most)));
}
