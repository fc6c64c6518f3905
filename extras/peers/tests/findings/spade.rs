//! `spade` 2.15.1. All findings concern `add_constraint_and_split`, whose documentation says that "intersection points may
//! not exactly lie on the line", but not that the triangulation may break; "robustness" is the first goal of the crate's
//! README.

use crate::{breaks, panics, still};
use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};
use twinedge_peers::crates::spade::CdtView;

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// A call.
enum Call {
    Insert(f64, f64),
    Remove(usize),
    Constrain(usize, usize),
    Split(usize, usize),
}
use Call::{Constrain, Insert, Remove, Split};

fn apply(cdt: &mut Cdt, call: &Call) {
    let vertex = FixedVertexHandle::from_index;
    match *call {
        Insert(x, y) => drop(cdt.insert(Point2::new(x, y)).unwrap()),
        Remove(v) => drop(cdt.remove(vertex(v))),
        Constrain(from, to) => drop(cdt.try_add_constraint(vertex(from), vertex(to))),
        Split(from, to) => drop(cdt.add_constraint_and_split(vertex(from), vertex(to), |position| position)),
    }
}

/// Makes the calls, and asserts the rules after each.
fn sound(calls: &[Call]) -> Cdt {
    let mut cdt = Cdt::new();
    for call in calls {
        apply(&mut cdt, call);
        assert!(CdtView::new(&cdt).report().is_valid());
    }
    cdt
}

/// Twice the signed area of each inner face, positive if counter-clockwise.
fn areas(cdt: &Cdt) -> Vec<f64> {
    let area = |[a, b, c]: [Point2<f64>; 3]| (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    cdt.inner_faces().map(|face| area(face.positions())).collect()
}

#[test]
fn add_constraint_and_split_panics_at_the_end_of_a_conflict_region() {
    let calls = [
        Insert(0.0, 0.0),
        Insert(3.0, 0.0),
        Insert(0.0, 1.0),
        Insert(0.0, 2.0),
        Insert(6.0, 12.0),
        Insert(6.0, 7.0),
        Remove(2),
        Insert(9.0, 2.0),
        Insert(9.0, 8.0),
        Constrain(6, 2),
        Remove(3),
        Insert(0.0, 5.0),
        Remove(0),
        Split(1, 4),
        Split(4, 5),
    ];
    let mut cdt = sound(&calls);
    panics("S1", "spade-2.15.1/src/cdt.rs", "!previous_region.is_empty()", || apply(&mut cdt, &Split(3, 0)));
}

#[test]
fn add_constraint_and_split_panics_on_a_face_that_is_turned_over() {
    let calls = [
        Insert(0.0, 7.0),
        Insert(5.0, 13.0),
        Insert(0.0, 0.0),
        Insert(9.0, 9.0),
        Remove(2),
        Constrain(1, 2),
        Insert(11.0, 10.0),
        Insert(10.0, 4.0),
        Split(3, 0),
        Insert(1.0, 0.0),
        Insert(5.0, 15.0),
        Remove(2),
        Split(4, 2),
        Split(5, 1),
        Split(6, 3),
    ];
    let mut cdt = sound(&calls);
    panics("S2", "src/delaunay_core/triangulation_ext.rs", "is_ordered_ccw", || apply(&mut cdt, &Split(4, 2)));
}

#[test]
fn add_constraint_and_split_makes_edges_overlap() {
    let calls = [
        Insert(0.0, 0.0),
        Insert(0.0, 1.0),
        Remove(0),
        Insert(0.0, 6.0),
        Insert(9.0, 9.0),
        Insert(3.0, 8.0),
        Insert(10.0, 7.0),
        Constrain(3, 4),
        Remove(0),
        Split(1, 2),
        Insert(9.0, 13.0),
        Remove(3),
        Insert(4.0, 6.0),
        Insert(0.0, 0.0),
        Remove(0),
        Insert(0.0, 1.0),
        Insert(5.0, 13.0),
        Remove(6),
        Split(5, 3),
        Split(1, 2),
    ];
    let mut cdt = sound(&calls);
    apply(&mut cdt, &Split(6, 5));
    breaks("S3", &CdtView::new(&cdt).report(), "G4");
    still("S3", areas(&cdt).contains(&0.0));
}

#[test]
fn add_constraint_and_split_breaks_the_rotation() {
    let calls = [
        Insert(0.0, 5.0),
        Insert(0.0, 1.0),
        Insert(0.0, 0.0),
        Insert(0.0, 2.0),
        Insert(10.0, 15.0),
        Insert(8.0, 3.0),
        Remove(3),
        Remove(2),
        Insert(0.0, 0.0),
        Split(2, 3),
        Insert(11.0, 12.0),
        Insert(10.0, 10.0),
        Split(5, 1),
        Remove(5),
        Remove(4),
        Constrain(2, 3),
    ];
    let mut cdt = sound(&calls);
    apply(&mut cdt, &Split(0, 4));
    breaks("S4", &CdtView::new(&cdt).report(), "G2");
    still("S4", areas(&cdt).iter().any(|area| *area < 0.0));
    // With debug assertions, removing a vertex of a face next to the inverted one panics.
    panics("S4", "src/delaunay_core/triangulation_ext.rs", "is_ordered_ccw", || apply(&mut cdt, &Remove(2)));
}

/// "Failed to locate position. This is a bug in spade", says the crate itself.
#[test]
#[expect(clippy::unreadable_literal, reason = "as the search printed them")]
fn add_constraint_and_split_fails_to_locate_a_position() {
    let calls = [
        Insert(0.0, 1.0),
        Insert(0.0, 0.5403023058681398),
        Insert(0.0, 0.960170286650366),
        Remove(1),
        Insert(-0.9589242746631385, -0.4161468365471424),
        Split(2, 1),
        Insert(0.8414709848078965, 1.0),
        Insert(0.0, 0.5403023058681398),
        Insert(0.0, -0.4161468365471424),
        Insert(-0.2879033166650653, 1.0),
        Remove(5),
        Insert(0.0, -0.4161468365471424),
        Split(4, 5),
        Insert(-0.7568024953079282, 1.0),
        Split(2, 0),
        Insert(-0.9999902065507035, -0.27516333805159693),
        Remove(4),
        Split(4, 3),
        Remove(10),
        Split(6, 8),
    ];
    let mut cdt = sound(&calls);
    let message = "This is a bug in spade";
    panics("S5", "src/delaunay_core/triangulation_ext.rs", message, || apply(&mut cdt, &Split(1, 10)));
}
