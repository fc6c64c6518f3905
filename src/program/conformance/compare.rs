//! Compares a subject with the reference: handles, view, and the handles of vertices before and after an operator.

use super::End;
use super::difference::{Answer, Difference, Question};
use crate::dcel::Corner;
use crate::program::operators::{Call, Op};
use crate::program::pointer_model::{PointerModel, PointerModelVertex};
use crate::program::runner::Runner;
use crate::program::subject::{CornerOf, Subject, isolated_of, view_face_of};
use crate::validate::{Part, Parts};
use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use alloc::{format, vec};
use core::fmt;
use core::iter::repeat;

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

/// Pairs each handle of the reference with the subject's handle of the same element.
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
    fn iter(&self) -> impl Iterator<Item = (A, B)> + '_ {
        self.0.iter().map(|(a, b)| (*a, *b))
    }

    fn get(&self, reference: A) -> Option<B> {
        self.0.get(&reference).copied()
    }

    /// Tells whether two handles name the same element, pairing them if neither is paired yet. Two missing handles agree.
    fn agree(&mut self, reference: Option<A>, subject: Option<B>) -> bool {
        let (Some(a), Some(b)) = (reference, subject) else { return reference.is_none() && subject.is_none() };
        if let Some(known) = self.get(a) {
            return known == b;
        }
        let is_new = self.0.values().all(|other| *other != b);
        self.0.insert(a, b);
        is_new
    }
}

pub(super) type Vertices<K> = Pairs<PointerModelVertex, <K as Subject>::Vertex>;

/// The result of comparing all corners without finding a difference.
pub(super) struct Agreement<K: Subject> {
    pub(super) vertices: Vertices<K>,
    /// True if some half-edge on the border has no `next` in the subject. Without faces this is not checked.
    pub(super) lacks_next: bool,
}

/// Finds the first corner whose answers differ.
///
/// Asks every question about every corner once. Answers are handles of two structures, so handles must be paired: half-edges by their
/// places, vertices and faces as they are met.
///
/// O(n log n) questions and steps, and O(n²) comparisons of handles, which can only be tested for equality.
pub(super) fn compare_answers<K: Subject>(
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

/// The answer of a subject, with handles replaced by places.
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

/// Finds the first half-edge or isolated vertex whose view differs. A missing `next` on the border is ignored.
///
/// The subject names the handle of each half-edge and isolated vertex of the view, and the handle has a place in the runner's list.
/// In a planar subdivision the faces and the unbounded face settle the nesting: what lies in the unbounded face is the outside of its
/// component, whose other cycles bound faces from outside, and so on inwards.
///
/// O(n²) comparisons of handles.
pub(super) fn compare_view<K: Subject>(
    reference: &Runner<PointerModel>,
    subject: &Runner<K>,
    parts: Parts,
) -> Result<(), Difference> {
    let view = subject.subject();
    let model = reference.subject();
    // The place of each half-edge of the view, by its index.
    let mut places: BTreeMap<usize, usize> = BTreeMap::new();
    let mut seen = vec![false; subject.half_edges().len()];
    for h in (0..view.half_edge_slots()).filter(|h| view.is_half_edge(*h)) {
        let handle = view.half_edge_at(h).ok_or(Difference::NoHandle { half_edge: h })?;
        let place = find(subject.half_edges(), handle, places.len());
        let place = place.filter(|place| !core::mem::replace(&mut seen[*place], true));
        places.insert(h, place.ok_or(Difference::Unknown { half_edge: h, is_named: view.is_named() })?);
    }
    if let Some(place) = seen.iter().position(|seen| !seen) {
        return Err(Difference::Missing { corner: place });
    }
    let names: BTreeMap<_, _> = reference.half_edges().iter().enumerate().map(|(place, name)| (*name, place)).collect();
    let (mut vertices, mut faces) = (Pairs::default(), Pairs::default());
    if parts.has(Part::Holes) && parts.has(Part::UnboundedFace) {
        let is_unbounded =
            |f: &usize| view.is_face(*f) && view.outer(*f).is_none() && view.outer_half_edge(*f).is_none();
        faces.agree(model.unbounded_face(), (0..view.face_slots()).find(is_unbounded));
    }
    for (h, place) in &places {
        let name = reference.half_edges()[*place];
        let place_of = |link: Option<usize>| link.and_then(|index| places.get(&index).copied());
        let face = model.face_of(Corner::At(name)).ok();
        let next = model.next_of(name).ok().and_then(|next| names.get(&next).copied());
        let agreed = [
            (Question::Twin, place_of(view.twin(*h)) == Some(*place ^ 1)),
            (Question::Next, place_of(view.next(*h)) == next || (face.is_none() && view.next(*h).is_none())),
            (Question::Origin, vertices.agree(model.origin_of(name).ok(), view.origin(*h))),
            (Question::Face, !parts.has(Part::Faces) || faces.agree(face, view_face_of(view, *h))),
        ];
        if let Some((question, _)) = agreed.into_iter().find(|(_, agreed)| !agreed) {
            return Err(Difference::View { half_edge: *h, corner: *place, question });
        }
    }
    if !parts.has(Part::Holes) {
        return Ok(());
    }
    let mut seen = vec![false; subject.isolated().len()];
    for (f, v) in isolated_of(view) {
        let handle = view.vertex_at(v).ok_or(Difference::NoVertexHandle { vertex: v })?;
        let place = find(subject.isolated(), handle, 0);
        let place = place.filter(|place| !core::mem::replace(&mut seen[*place], true));
        let name = place.and_then(|place| reference.isolated().get(place));
        let face = name.and_then(|name| model.face_of(Corner::Isolated(*name)).ok());
        if face.is_none() || !faces.agree(face, Some(f)) {
            return Err(Difference::Isolated { vertex: v });
        }
    }
    match seen.iter().position(|seen| !seen) {
        Some(place) => Err(Difference::Missing { corner: subject.half_edges().len() + place }),
        None => Ok(()),
    }
}

/// The place of a handle in a list. Most structures keep the order of creation, so the place is guessed.
fn find<H: Copy + Eq>(list: &[H], handle: H, guess: usize) -> Option<usize> {
    if list.get(guess) == Some(&handle) { Some(guess) } else { list.iter().position(|other| *other == handle) }
}

/// The vertices whose handles an operator may exchange. Data is stored under handles: if a vertex gets another vertex's handle, the
/// map is unchanged, but the vertex's data is lost.
pub(super) enum Exchange {
    Nothing,
    /// Two vertices become one: the ends of the edge, and the ends whose handle may survive.
    Merged {
        ends: [PointerModelVertex; 2],
        may_be_kept: Vec<PointerModelVertex>,
    },
    /// One vertex becomes two.
    Split,
}

impl Exchange {
    /// Determines the vertices whose handles an operator may exchange, before it runs.
    pub(super) fn of<K: Subject>(
        op: Op,
        reference: &Runner<PointerModel>,
        subject: &Runner<K>,
        survivor: Option<End>,
    ) -> Self {
        if matches!(op, Op::SplitVertex { .. }) {
            return Self::Split;
        }
        let Some([h, twin]) = merging(op, reference) else { return Self::Nothing };
        let model = reference.subject();
        let (Ok(origin), Ok(target)) = (model.origin_of(h), model.origin_of(twin)) else { return Self::Nothing };
        // A border half-edge that is not stored is represented by its twin, whose ends are swapped.
        let is_stored = merging(op, subject).is_some_and(|[h, _]| subject.subject().next_of(h).is_ok());
        let may_be_kept = match survivor.filter(|_| is_stored) {
            None => vec![origin, target],
            Some(End::Origin) => vec![origin],
            Some(End::Target) => vec![target],
        };
        Self::Merged { ends: [origin, target], may_be_kept }
    }

    /// Finds a vertex that has lost its handle. O(n log n), plus O(n) if a vertex is split.
    pub(super) fn compare<K: Subject>(&self, before: &Vertices<K>, now: &Vertices<K>) -> Result<(), Difference> {
        for (vertex, was) in before.iter() {
            let Some(is) = now.get(vertex) else { continue };
            let allowed = match self {
                Self::Merged { ends, may_be_kept } if ends.contains(&vertex) => {
                    may_be_kept.iter().filter_map(|end| before.get(*end)).collect()
                }
                Self::Split if now.iter().any(|(other, handle)| handle == was && before.get(other).is_none()) => {
                    continue;
                }
                _ => vec![was],
            };
            if !allowed.contains(&is) {
                let expected: Vec<_> = allowed.iter().map(|handle| format!("{handle:?}")).collect();
                return Err(Difference::Vertex { expected, found: format!("{is:?}") });
            }
        }
        Ok(())
    }
}

fn merging<K: Subject>(op: Op, on: &Runner<K>) -> Option<[K::HalfEdge; 2]> {
    let (Op::ContractEdge { .. } | Op::MeshCollapseEdge { .. }) = op else { return None };
    match on.resolve(op) {
        Ok(Call::ContractEdge { half_edge } | Call::MeshCollapseEdge { half_edge }) => {
            Some([half_edge, on.subject().twin_of(half_edge).ok()?])
        }
        _ => None,
    }
}
