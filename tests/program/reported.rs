//! The reports of the operators, on every store.

use twinedge::dcel::Dcel;
use twinedge::program::{Program, conformance};
use twinedge::store::{FixedStore, PointerStore, SlotStore, Store};
use twinedge::validate::Expectation;
use twinedge_trials::ReportAudit;

fn holds<S: Store>(make: fn() -> ReportAudit<S>) {
    let mut applied = 0;
    for number in 0..60_u32 {
        // Any bytes do: a multiplicative generator.
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
fn reports_are_right_on_every_store() {
    holds(ReportAudit::<SlotStore>::default);
    holds(ReportAudit::<PointerStore>::default);
    holds(|| ReportAudit::new(Dcel::<FixedStore<24, 40, 40, 24>>::default()));
}
