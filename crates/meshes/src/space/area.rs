//! M9 area: the corners of a face do not all lie on one line.

use super::super::{Finding, HalfEdgeMesh};
use super::places::{Places, axis_of, faces};

pub(super) fn check(mesh: &HalfEdgeMesh<'_>, places: &Places<'_>, found: &mut dyn FnMut(Finding)) -> usize {
    let mut checked = 0;
    for face in faces(mesh) {
        checked += 1;
        let corners = places.corners(face);
        let first = corners.first().copied();
        let second = corners.iter().copied().find(|corner| first.is_some_and(|first| first.number != corner.number));
        let has_area = first.zip(second).is_some_and(|(first, second)| {
            corners.iter().any(|third| axis_of([first.at, second.at, third.at]).is_some())
        });
        if !has_area {
            found(Finding::ZeroArea { face });
        }
    }
    checked
}
