use super::{Open, Record};
use crate::diff::ApplyError;

/// The ids of a face's ends are (number, 0).
fn matched(claims: &[(u128, u128)], largest_ring: usize) -> Result<Vec<(u128, u128)>, ApplyError> {
    let mut open = Open::default();
    for (id, face) in claims {
        open.faces_of.entry(*id).or_default().insert((*face, 0));
        open.ids_of.entry((*face, 0)).or_default().insert(*id);
    }
    let mut found: Vec<_> =
        open.matched(|ids| ids.len() <= largest_ring)?.into_iter().map(|(id, face)| (id, face.0)).collect();
    found.sort_unstable();
    Ok(found)
}

#[test]
fn ids_and_faces_that_are_left_alone_are_matched_one_after_the_other() {
    assert_eq!(matched(&[(1, 11), (1, 12), (2, 12), (2, 13), (3, 13)], 0), Ok(vec![(1, 11), (2, 12), (3, 13)]));
}

/// Ids 1 and 2 and faces 11 and 12 form a ring; the others hang on a face of the ring.
#[test]
fn faces_that_hang_on_a_ring_are_matched_before_it_is_opened() {
    let claims = [(1, 11), (1, 12), (2, 11), (2, 12), (3, 12), (3, 13), (4, 13), (4, 14)];
    assert_eq!(matched(&claims, 2), Ok(vec![(1, 11), (2, 12), (3, 13), (4, 14)]));
}

/// Ids 1 and 2 and faces 11 and 12 form a ring; the others hang on an id of the ring.
#[test]
fn ids_that_hang_on_a_ring_are_matched_before_it_is_opened() {
    let claims = [(1, 11), (1, 12), (2, 11), (2, 12), (2, 13), (3, 13), (3, 14), (4, 14)];
    assert_eq!(matched(&claims, 2), Ok(vec![(1, 11), (2, 12), (3, 13), (4, 14)]));
}

#[test]
fn rings_whose_faces_differ_are_refused() {
    let claims = [(1, 11), (1, 12), (2, 11), (2, 12)];
    assert_eq!(matched(&claims, 1), Err(ApplyError::NotOneFace(Record::Face(1))));
}

#[test]
fn two_ids_that_claim_one_face_are_refused() {
    assert_eq!(matched(&[(1, 11), (2, 11)], 2), Err(ApplyError::OneFace(Record::Face(1), Record::Face(2))));
}
