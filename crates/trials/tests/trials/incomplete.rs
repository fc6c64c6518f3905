//! A structure that lacks operators, and one with a wrong expectation.

use twinedge::dcel::Dcel;
use twinedge::program::{Call, CallOf, HandleOf, Refusal, Subject};
use twinedge::validate::{Expectation, Part, Parts, Rule, View};
use twinedge::{delegate_subject, delegate_view};
use twinedge_trials::prove::ProveWork;
use twinedge_trials::soak::SoakWork;
use twinedge_trials::tables::TablesWork;
use twinedge_trials::{Run, Structure, StructureError, prove, soak};

/// A [`Dcel`] without `split_vertex`. It may also hide its faces from the validator, or claim to store fewer parts.
#[derive(Clone)]
pub(crate) struct Partial {
    dcel: Dcel,
    hides_faces: bool,
    stores: Parts,
}

impl Partial {
    fn new(hides_faces: bool) -> Self {
        Self { dcel: Dcel::new(), hides_faces, stores: Parts::ALL }
    }

    /// Returns one that does not store this part.
    pub(crate) fn without(part: Part) -> Self {
        Self { stores: Parts::ALL.without(part), ..Self::new(false) }
    }
}

impl View for Partial {
    delegate_view!(|this| &this.dcel; except parts, is_face);
    fn parts(&self) -> Parts {
        self.stores
    }
    fn is_face(&self, f: usize) -> bool {
        !self.hides_faces && self.dcel.is_face(f)
    }
}

impl Subject for Partial {
    delegate_subject!(Dcel, |this| &this.dcel);

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        if let Call::SplitVertex { .. } = call { Err(Refusal::Unsupported) } else { self.dcel.apply(call) }
    }
}

fn partial() -> Structure<Partial> {
    Structure::new("partial", || Partial::new(false), Expectation::plane())
}

#[test]
fn counts_that_fall_short_for_want_of_an_operator_name_it() {
    let outcome = prove(&partial(), ProveWork { edges: 1 }, &Run::default()).unwrap();
    assert_eq!(outcome.unsupported, ["split_vertex"]);
    let reasons = outcome.reasons();
    let short = "connected maps of 1 edges, rooted: grown 1, published 2";
    let [why, count] = [&["split_vertex"][..], &[short]].map(|told| {
        reasons
            .iter()
            .position(|reason| told.iter().all(|told| reason.contains(told)))
            .unwrap_or_else(|| panic!("{reasons:?}"))
    });
    assert!(why < count, "{reasons:?}");
}

#[test]
fn a_structure_whose_empty_map_is_wrong_gets_one_message() {
    let hides = || Partial::new(true);
    let error = prove(&Structure::new("hides", hides, Expectation::plane()), ProveWork { edges: 2 }, &Run::default());
    let error = error.unwrap_err();
    let StructureError::InvalidStart(violation) = error else { panic!("{error}") };
    assert_eq!(violation.rule(), Rule::F1);
    let text = error.to_string();
    assert!(
        text.starts_with("the empty map of the structure breaks F1: ") && text.contains(violation.remedy()),
        "{text}"
    );
    // This is the output of `unwrap`.
    assert_eq!(format!("{error:?}"), text);
}

#[test]
fn a_soak_of_no_structure_does_not_pass() {
    let outcome = soak(&[], SoakWork { programs: 2, steps: 2, seed: 1 }, &Run::default());
    assert_eq!(outcome.reasons(), ["no structure was given, so nothing was compared"]);
    assert!(!outcome.is_ok());
}

#[test]
fn estimates_of_work_without_end_do_not_overflow() {
    for edges in [0, 5, 32, 33, 37, 1_000, usize::MAX] {
        let amount = ProveWork { edges }.estimate().amount;
        assert!(edges < 33 || amount == u128::MAX, "{edges}: {amount}");
    }
    for half_edges in [0, 4, 58, 60, 1_000, usize::MAX] {
        let amount = TablesWork { half_edges }.estimate().amount;
        assert!(half_edges < 58 || amount == u128::MAX, "{half_edges}: {amount}");
    }
}
