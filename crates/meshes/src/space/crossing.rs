//! M10 crossing: two faces meet in common corners and common edges only.
//!
//! An R-tree finds pairs of faces with overlapping boxes; tested as in
//! [CGAL](https://doc.cgal.org/latest/Polygon_mesh_processing/group__PMP__intersection__grp.html): excluding shared corners and
//! edges.

use super::super::{Finding, HalfEdgeMesh};
use super::places::{Corner, Place, Places, axis_of, faces, turn};
use super::segment::cross;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};
use std::cmp::Ordering;

type Boxed = GeomWithData<Rectangle<[f64; 3]>, usize>;

/// Returns the numbers of checked and of unchecked faces.
pub(super) fn check(mesh: &HalfEdgeMesh<'_>, places: &Places<'_>, found: &mut dyn FnMut(Finding)) -> (usize, usize) {
    let (judged, left_out): (Vec<usize>, Vec<usize>) = faces(mesh).partition(|face| is_convex(&places.corners(*face)));
    let boxed = |face: &usize| Boxed::new(Rectangle::from_aabb(around(&places.corners(*face))), *face);
    let tree = RTree::bulk_load(judged.iter().map(boxed).collect());
    for face in &judged {
        // Triangles without area belong to M9.
        let with_area = |face: usize| {
            let mut all = places.triangles(face);
            all.retain(|triangle| axis_of(triangle.map(|corner| corner.at)).is_some());
            all
        };
        let triangles = with_area(*face);
        let near = tree.locate_in_envelope_intersecting(around(&places.corners(*face)));
        let mut others: Vec<usize> = near.map(|boxed| boxed.data).filter(|other| other > face).collect();
        others.sort_unstable();
        for other in others {
            let is_crossing = with_area(other).iter().any(|b| triangles.iter().any(|a| cross(a, b)));
            if is_crossing {
                found(Finding::CrossingFaces { faces: [*face, other] });
            }
        }
    }
    (judged.len(), left_out.len())
}

fn around(corners: &[Corner]) -> AABB<[f64; 3]> {
    AABB::from_points(corners.iter().map(|corner| &corner.at))
}

/// Returns true if the triangles from the first corner cover the face exactly, as seen along some axis.
fn is_convex(corners: &[Corner]) -> bool {
    let places: Vec<Place> = corners.iter().map(|corner| corner.at).collect();
    let count = places.len();
    let is_convex_along = |axis: usize| {
        let of_fan = (1..count.saturating_sub(1)).map(|i| turn([places[0], places[i], places[i + 1]], axis));
        let of_corners = (0..count).map(|i| turn([places[i], places[(i + 1) % count], places[(i + 2) % count]], axis));
        let turns: Vec<Ordering> = of_fan.chain(of_corners).filter(|turn| turn.is_ne()).collect();
        !turns.is_empty() && turns.iter().all(|turn| *turn == turns[0])
    };
    count == 3 || axis_of_face(&places).is_none() || (0..3).any(is_convex_along)
}

/// Returns an axis along which the corners of a face do not lie on a line.
fn axis_of_face(places: &[Place]) -> Option<usize> {
    let [first, others @ ..] = places else { return None };
    others.windows(2).find_map(|pair| axis_of([*first, pair[0], pair[1]]))
}
