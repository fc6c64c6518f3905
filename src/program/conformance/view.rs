//! Does the view of a subject say the same as the reference, half-edge by half-edge?
//!
//! Where a view has faces, holes and an unbounded face, canonical forms tell whether it is the right map. Others are compared link by
//! link: the subject gives the handle of each half-edge of the view, and the handle has its place among those of the reference.

use super::answers::Pairs;
use super::difference::{Difference, Question};
use crate::dcel::Corner;
use crate::program::pointer_model::{PointerModel, view_face_of};
use crate::program::run::runner::Runner;
use crate::program::subject::Subject;
use alloc::collections::BTreeMap;
use alloc::vec;

/// Finds the first half-edge of which the view says something else. Where it has no `next`, on the border, nothing is asked.
///
/// O(n²) comparisons of handles.
pub(super) fn compare<K: Subject>(
    reference: &Runner<PointerModel>,
    subject: &Runner<K>,
    has_faces: bool,
) -> Result<(), Difference> {
    let view = subject.subject();
    let model = reference.subject();
    // The place of each half-edge of the view, by its index.
    let mut places: BTreeMap<usize, usize> = BTreeMap::new();
    let mut seen = vec![false; subject.half_edges().len()];
    for h in (0..view.half_edge_slots()).filter(|h| view.is_half_edge(*h)) {
        let handle = view.half_edge_at(h).ok_or(Difference::NoHandle { half_edge: h })?;
        // Most structures keep the order of creation.
        let guess = places.len();
        let place = if subject.half_edges().get(guess) == Some(&handle) {
            Some(guess)
        } else {
            subject.half_edges().iter().position(|other| *other == handle)
        };
        let place = place.filter(|place| !core::mem::replace(&mut seen[*place], true));
        places.insert(h, place.ok_or(Difference::Unknown { half_edge: h, is_named: view.is_named() })?);
    }
    if let Some(place) = seen.iter().position(|seen| !seen) {
        return Err(Difference::Missing { corner: place });
    }
    let names: BTreeMap<_, _> = reference.half_edges().iter().enumerate().map(|(place, name)| (*name, place)).collect();
    let (mut vertices, mut faces) = (Pairs::default(), Pairs::default());
    for (h, place) in &places {
        let name = reference.half_edges()[*place];
        let place_of = |link: Option<usize>| link.and_then(|index| places.get(&index).copied());
        let face = model.face_of(Corner::At(name)).ok();
        let next = model.next_of(name).ok().and_then(|next| names.get(&next).copied());
        let agreed = [
            (Question::Twin, place_of(view.twin(*h)) == Some(*place ^ 1)),
            (Question::Next, place_of(view.next(*h)) == next || (face.is_none() && view.next(*h).is_none())),
            (Question::Origin, vertices.agree(model.origin_of(name).ok(), view.origin(*h))),
            (Question::Face, !has_faces || faces.agree(face, view_face_of(view, *h))),
        ];
        if let Some((question, _)) = agreed.into_iter().find(|(_, agreed)| !agreed) {
            return Err(Difference::View { half_edge: *h, corner: *place, question });
        }
    }
    Ok(())
}
