//! Do the handles of a subject say the same as those of the reference?
//!
//! Every corner is asked every question once. That is not all: an answer is a handle, and the handles of two structures
//! have to be paired. The half-edges are paired by their places; vertices and faces as they are met, each with one other.

use super::difference::{Answer, Difference, Question};
use crate::dcel::Corner;
use crate::program::pointer_model::{PointerModel, PointerModelVertex};
use crate::program::run::runner::Runner;
use crate::program::subject::{CornerOf, Subject};
use alloc::collections::BTreeMap;
use core::fmt;
use core::iter::repeat;

/// The answers of a subject about a corner.
struct Said<K: Subject> {
    twin: Option<K::HalfEdge>,
    next: Option<K::HalfEdge>,
    origin: Option<K::Vertex>,
    face: Option<K::Face>,
}

impl<K: Subject> Said<K> {
    fn of(subject: &K, corner: Option<CornerOf<K>>) -> Self {
        let half_edge = match corner {
            Some(Corner::At(h)) => Some(h),
            _ => None,
        };
        Self {
            twin: half_edge.and_then(|h| subject.twin_of(h).ok()),
            next: half_edge.and_then(|h| subject.next_of(h).ok()),
            origin: half_edge.and_then(|h| subject.origin_of(h).ok()),
            face: corner.and_then(|corner| subject.face_of(corner).ok()),
        }
    }
}

/// Handles of the reference, each with the one handle of the subject that names the same.
pub(super) struct Pairs<A, B>(BTreeMap<A, B>);

impl<A, B> Default for Pairs<A, B> {
    fn default() -> Self {
        Self(BTreeMap::new())
    }
}

impl<A: fmt::Debug, B: fmt::Debug> fmt::Debug for Pairs<A, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl<A: Copy + Ord, B: Copy + Eq> Pairs<A, B> {
    pub(super) fn iter(&self) -> impl Iterator<Item = (A, B)> + '_ {
        self.0.iter().map(|(a, b)| (*a, *b))
    }

    pub(super) fn get(&self, reference: A) -> Option<B> {
        self.0.get(&reference).copied()
    }

    /// Tells whether these two belong together: they are paired already, or neither is and now they are. Two that are not there
    /// say the same.
    pub(super) fn agree(&mut self, reference: Option<A>, subject: Option<B>) -> bool {
        let (Some(a), Some(b)) = (reference, subject) else { return reference.is_none() && subject.is_none() };
        if let Some(known) = self.get(a) {
            return known == b;
        }
        let is_new = self.0.values().all(|other| *other != b);
        self.0.insert(a, b);
        is_new
    }
}

/// The vertices of the reference, each with the handle of the subject.
pub(super) type Vertices<K> = Pairs<PointerModelVertex, <K as Subject>::Vertex>;

/// The comparison of all corners, if nothing differs.
pub(super) struct Agreement<K: Subject> {
    pub(super) vertices: Vertices<K>,
    /// True if there is a half-edge on the border of which the subject has no `next`. Without faces it is not asked for any.
    pub(super) lacks_next: bool,
}

/// Finds the first corner of which the subject says something else.
///
/// O(n log n) questions and steps, and O(n²) comparisons of handles, of which nothing more is known than whether two are
/// equal.
pub(super) fn compare<K: Subject>(
    reference: &Runner<PointerModel>,
    subject: &Runner<K>,
    has_faces: bool,
) -> Result<Agreement<K>, Difference> {
    let both = reference.half_edges().iter().copied().zip(subject.half_edges().iter().copied());
    let half_edges: BTreeMap<_, _> = both.collect();
    let same = |a: Option<_>, b: Option<K::HalfEdge>| match a {
        Some(a) => b.is_some() && half_edges.get(&a).copied() == b,
        None => b.is_none(),
    };
    let mut vertices = Pairs::default();
    let mut faces = Pairs::default();
    if let (Some(a), Some(b)) = (reference.subject().unbounded_face(), subject.subject().unbounded_face()) {
        faces.agree(Some(a), Some(b));
    }
    let mut lacks_next = false;
    let corners = subject.corners().map(Some).chain(repeat(None));
    for (place, (corner, other)) in reference.corners().zip(corners).enumerate() {
        let (a, b) = (Said::of(reference.subject(), Some(corner)), Said::of(subject.subject(), other));
        let is_without_next = a.face.is_none() && b.next.is_none();
        lacks_next |= is_without_next;
        let agreed = [
            (Question::Twin, same(a.twin, b.twin)),
            (Question::Next, same(a.next, b.next) || is_without_next),
            (Question::Origin, vertices.agree(a.origin, b.origin)),
            (Question::Face, !has_faces || faces.agree(a.face, b.face)),
        ];
        if let Some((question, _)) = agreed.into_iter().find(|(_, agreed)| !agreed) {
            let (reference, subject) = (answer(reference, place, question), answer(subject, place, question));
            return Err(Difference::Answers { corner: place, question, reference, subject });
        }
    }
    Ok(Agreement { vertices, lacks_next })
}

/// The answer of a subject, in places.
fn answer<K: Subject>(runner: &Runner<K>, corner: usize, question: Question) -> Answer {
    let subject = runner.subject();
    let said = Said::of(subject, runner.corners().nth(corner));
    let place_of = |h: Option<K::HalfEdge>| h.and_then(|h| runner.half_edges().iter().position(|other| *other == h));
    let place = match question {
        Question::Twin => place_of(said.twin),
        Question::Next => place_of(said.next),
        Question::Origin => {
            let same = |other: &K::HalfEdge| said.origin.is_some() && subject.origin_of(*other).ok() == said.origin;
            runner.half_edges().iter().position(same)
        }
        Question::Face if said.face.is_some() && said.face == subject.unbounded_face() => return Answer::Unbounded,
        Question::Face => {
            let same = |other| said.face.is_some() && subject.face_of(other).ok() == said.face;
            runner.corners().position(same)
        }
    };
    place.map_or(Answer::Nothing, Answer::Corner)
}
