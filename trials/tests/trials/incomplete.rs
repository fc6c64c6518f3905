//! A structure that lacks operators, and one that is held to what it is not.

use twinedge::dcel::{Dcel, FaceKey, HalfEdgeKey, Side, Turn, VertexKey};
use twinedge::delegate_view;
use twinedge::program::{CornerOf, Refusal, Subject};
use twinedge::validate::{Expectation, Part, Parts, Rule, View};
use twinedge_trials::prove::ProveWork;
use twinedge_trials::soak::SoakWork;
use twinedge_trials::tables::TablesWork;
use twinedge_trials::{Outcome, Run, Structure, StructureError, prove, soak};

/// A [`Dcel`] without `split_vertex`. It may also hide its faces from the validator, or say that it stores fewer parts.
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

    /// One that does not store this part.
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

macro_rules! operators_as_they_are {
    ($($name:ident($($arg:ident: $argument:ty),*) -> $answer:ty;)*) => {
        $(fn $name(&mut self $(, $arg: $argument)*) -> Result<$answer, Refusal> {
            Subject::$name(&mut self.dcel $(, $arg)*)
        })*
    };
}

macro_rules! questions_as_they_are {
    ($($name:ident($arg:ident: $argument:ty) -> $answer:ty;)*) => {
        $(fn $name(&self, $arg: $argument) -> Result<$answer, Refusal> {
            Subject::$name(&self.dcel, $arg)
        })*
    };
}

impl Subject for Partial {
    type Vertex = VertexKey;
    type HalfEdge = HalfEdgeKey;
    type Face = FaceKey;
    fn unbounded_face(&self) -> Option<FaceKey> {
        Subject::unbounded_face(&self.dcel)
    }
    questions_as_they_are! {
        face_of(corner: CornerOf<Self>) -> FaceKey;
        origin_of(half_edge: HalfEdgeKey) -> VertexKey;
        twin_of(half_edge: HalfEdgeKey) -> HalfEdgeKey;
        next_of(half_edge: HalfEdgeKey) -> HalfEdgeKey;
    }
    operators_as_they_are! {
        add_isolated_vertex(face: FaceKey) -> VertexKey;
        remove_isolated_vertex(vertex: VertexKey) -> ();
        connect(from: CornerOf<Self>, to: CornerOf<Self>, side: Side, inner: &[CornerOf<Self>]) -> HalfEdgeKey;
        remove_edge(half_edge: HalfEdgeKey) -> Option<FaceKey>;
        split_edge(half_edge: HalfEdgeKey) -> HalfEdgeKey;
        join_edges(half_edge: HalfEdgeKey) -> ();
        contract_edge(half_edge: HalfEdgeKey) -> VertexKey;
        flip_edge(half_edge: HalfEdgeKey, turn: Turn) -> ();
        move_inner(inner: CornerOf<Self>, face: FaceKey) -> ();
    }
    fn split_vertex(&mut self, _: CornerOf<Self>, _: CornerOf<Self>) -> Result<HalfEdgeKey, Refusal> {
        Err(Refusal::Unsupported)
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
    // This is what `unwrap` shows.
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
