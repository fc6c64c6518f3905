//! Each operator on a small map.

use twinedge::dcel::{BoundaryKey, Connection, RemovedEdge, Side, Split, Turn};

use crate::draw::{Mark, Role, Row, picture};
use crate::scene::{Place, Scene};

/// The corners of the box that contains most maps, counter-clockwise.
const BOX: [Place; 4] = [[15.0, 12.0], [135.0, 12.0], [135.0, 98.0], [15.0, 98.0]];
const CLOSED_BOX: [Place; 5] = [BOX[0], BOX[1], BOX[2], BOX[3], BOX[0]];
const MIDDLE: Place = [75.0, 55.0];
const UPPER: Place = [75.0, 98.0];
const LOWER: Place = [75.0, 12.0];

/// The pictures, each with the name of the operator.
pub(crate) fn all() -> Vec<(&'static str, String)> {
    let pictures = [
        ("add_isolated_vertex", vec![add_isolated_vertex()]),
        ("remove_isolated_vertex", vec![remove_isolated_vertex()]),
        ("connect", vec![bridge(), split()]),
        ("remove_edge", vec![merge(), part()]),
        ("split_edge", vec![split_edge()]),
        ("join_edges", vec![join_edges()]),
        ("split_vertex", vec![split_vertex()]),
        ("contract_edge", vec![contract_edge()]),
        ("flip_edge", vec![flip_edge()]),
        ("move_inner", vec![move_inner()]),
    ];
    pictures.map(|(name, rows)| (name, picture(&format!("{name}, before and after"), &rows))).into()
}

fn add_isolated_vertex() -> Row {
    let before = Scene::new(&[&CLOSED_BOX]);
    let face = before.face(BOX[0], BOX[1]);
    let mut after = before.clone();
    let added = after.dcel.add_isolated_vertex(face).expect("the face is live");
    after.places.insert(after.dcel.vertex(added.vertex).expect("it is live").index(), [95.0, 50.0]);
    assert!(after.dcel.validate().is_valid());
    let name = Mark::Face(face, "f", [45.0, 55.0]);
    Row {
        before: (before, vec![name.clone()]),
        after: (after, vec![name, Mark::Vertex(added.vertex, "v", Role::Made)]),
    }
}

fn remove_isolated_vertex() -> Row {
    let Row { before: (after, marks), after: (before, _) } = add_isolated_vertex();
    let v = before.vertex([95.0, 50.0]);
    let mut check = before.clone();
    check.dcel.remove_isolated_vertex(v).expect("it is isolated");
    assert_eq!(check.dcel.vertex_count(), after.dcel.vertex_count());
    let mut given = marks.clone();
    given.push(Mark::Vertex(v, "v", Role::Dropped));
    Row { before: (before, given), after: (after, marks) }
}

fn bridge() -> Row {
    let hole: [Place; 4] = [[40.0, 40.0], [70.0, 40.0], [55.0, 72.0], [40.0, 40.0]];
    let before = Scene::new(&[&CLOSED_BOX, &hole]);
    let (a, b) = (before.corner(hole[1], MIDDLE), before.corner(BOX[1], MIDDLE));
    let face = before.face(BOX[0], BOX[1]);
    let mut after = before.clone();
    let connected = after.dcel.connect(a, b, Split::default()).expect("corners of one face");
    assert!(matches!(connected.connection, Connection::Bridge { .. }) && after.dcel.validate().is_valid());
    let name = Mark::Face(face, "f", [105.0, 78.0]);
    Row {
        before: (before, vec![name.clone(), Mark::Corner(a, "a"), Mark::Corner(b, "b")]),
        after: (after, vec![name, Mark::HalfEdge(connected.half_edge, "h", Role::Made)]),
    }
}

fn split() -> Row {
    let before = Scene::new(&[&CLOSED_BOX]);
    let (a, b) = (before.corner(BOX[0], MIDDLE), before.corner(BOX[2], MIDDLE));
    let face = before.face(BOX[0], BOX[1]);
    let mut after = before.clone();
    let connected = after.dcel.connect(a, b, Split { new_face: Side::Left, inner: &[] }).expect("corners of one face");
    let made = connected.new_face().expect("a split");
    assert!(after.dcel.validate().is_valid());
    Row {
        before: (before, vec![Mark::Face(face, "f", [75.0, 55.0]), Mark::Corner(a, "a"), Mark::Corner(b, "b")]),
        after: (
            after,
            vec![
                Mark::Face(face, "f", [110.0, 38.0]),
                Mark::Face(made, "new", [38.0, 76.0]),
                Mark::HalfEdge(connected.half_edge, "h", Role::Made),
            ],
        ),
    }
}

fn merge() -> Row {
    let before = Scene::new(&[&[BOX[0], LOWER, BOX[1], BOX[2], UPPER, BOX[3], BOX[0]], &[LOWER, UPPER]]);
    let h = before.half_edge(LOWER, UPPER);
    let (left, right) = (before.face(LOWER, UPPER), before.face(UPPER, LOWER));
    let mut after = before.clone();
    let removed = after.dcel.remove_edge(h).expect("it is live");
    assert!(matches!(removed, RemovedEdge::Merged { kept_face, .. } if kept_face == left));
    let name = Mark::Face(left, "f", [38.0, 55.0]);
    Row {
        before: (
            before,
            vec![
                name.clone(),
                Mark::Face(right, "g", [110.0, 55.0]),
                Mark::Edge(h, Role::Dropped),
                Mark::HalfEdge(h, "h", Role::Given),
            ],
        ),
        after: (after, vec![name]),
    }
}

fn part() -> Row {
    let Row { after: (before, _), .. } = bridge();
    let h = before.half_edge([70.0, 40.0], BOX[1]);
    let face = before.face(BOX[0], BOX[1]);
    let mut after = before.clone();
    let removed = after.dcel.remove_edge(h).expect("it is live");
    assert!(matches!(removed, RemovedEdge::Parted { .. }) && after.dcel.validate().is_valid());
    let name = Mark::Face(face, "f", [105.0, 78.0]);
    Row {
        before: (before, vec![name.clone(), Mark::Edge(h, Role::Dropped), Mark::HalfEdge(h, "h", Role::Given)]),
        after: (after, vec![name]),
    }
}

/// A triangle whose lower edge can be split.
const TRIANGLE: [Place; 4] = [[15.0, 30.0], [135.0, 30.0], [75.0, 98.0], [15.0, 30.0]];

fn split_edge() -> Row {
    let before = Scene::new(&[&TRIANGLE]);
    let h = before.half_edge(TRIANGLE[0], TRIANGLE[1]);
    let mut after = before.clone();
    let made = after.dcel.split_edge(h).expect("it is live");
    after.places.insert(after.dcel.vertex(made.vertex).expect("it is live").index(), [75.0, 30.0]);
    assert!(after.dcel.validate().is_valid());
    Row {
        before: (before, vec![Mark::HalfEdge(h, "h", Role::Given)]),
        after: (
            after,
            vec![
                Mark::HalfEdge(h, "h", Role::Given),
                Mark::HalfEdge(made.half_edge, "new", Role::Made),
                Mark::Vertex(made.vertex, "w", Role::Made),
            ],
        ),
    }
}

fn join_edges() -> Row {
    let Row { after: (before, _), .. } = split_edge();
    let middle = [75.0, 30.0];
    let (h, next) = (before.half_edge(TRIANGLE[0], middle), before.half_edge(middle, TRIANGLE[1]));
    let vertex = before.vertex(middle);
    let mut after = before.clone();
    let joined = after.dcel.join_edges(h).expect("the degree is 2");
    assert!(after.dcel.validate().is_valid());
    assert_eq!((joined.vertex, joined.half_edge), (vertex, next));
    Row {
        before: (
            before,
            vec![
                Mark::HalfEdge(h, "h", Role::Given),
                Mark::HalfEdge(next, "next", Role::Dropped),
                Mark::Vertex(vertex, "v", Role::Dropped),
            ],
        ),
        after: (after, vec![Mark::HalfEdge(h, "h", Role::Given)]),
    }
}

/// The ends of the spokes of a wheel without a rim.
const SPOKES: [Place; 5] = [BOX[0], [15.0, 55.0], BOX[3], BOX[1], BOX[2]];
const APART: [Place; 2] = [[50.0, 55.0], [102.0, 55.0]];

fn split_vertex() -> Row {
    let spokes = SPOKES.map(|end| [MIDDLE, end]);
    let before = Scene::new(&spokes.each_ref().map(|spoke| &spoke[..]));
    let (a, b) = (before.corner(MIDDLE, LOWER), before.corner(MIDDLE, UPPER));
    let v = before.vertex(MIDDLE);
    let mut after = before.clone();
    let made = after.dcel.split_vertex(a, b).expect("corners of one vertex");
    after.places.insert(after.dcel.vertex(v).expect("it is live").index(), APART[0]);
    after.places.insert(after.dcel.vertex(made.vertex).expect("it is live").index(), APART[1]);
    assert!(after.dcel.validate().is_valid());
    Row {
        before: (before, vec![Mark::Corner(a, "a"), Mark::Corner(b, "b")]),
        after: (
            after,
            vec![Mark::HalfEdge(made.half_edge, "h", Role::Made), Mark::Vertex(made.vertex, "w", Role::Made)],
        ),
    }
}

fn contract_edge() -> Row {
    let Row { after: (before, _), .. } = split_vertex();
    let h = before.half_edge(APART[0], APART[1]);
    let mut after = before.clone();
    let contracted = after.dcel.contract_edge(h).expect("it is no loop");
    assert_eq!(contracted.dropped, before.vertex(APART[1]));
    after.places.insert(after.dcel.vertex(contracted.kept).expect("it is live").index(), MIDDLE);
    assert!(after.dcel.validate().is_valid());
    Row {
        before: (
            before,
            vec![
                Mark::Edge(h, Role::Dropped),
                Mark::HalfEdge(h, "h", Role::Given),
                Mark::Vertex(contracted.dropped, "v", Role::Dropped),
            ],
        ),
        after: (after, vec![]),
    }
}

fn flip_edge() -> Row {
    let before = Scene::new(&[&CLOSED_BOX, &[BOX[0], BOX[2]]]);
    let h = before.half_edge(BOX[0], BOX[2]);
    let (left, right) = (before.face(BOX[0], BOX[2]), before.face(BOX[2], BOX[0]));
    let mut after = before.clone();
    after.dcel.flip_edge(h, Turn::CounterClockwise).expect("it separates two faces");
    assert!(after.dcel.validate().is_valid());
    let arrow = Mark::HalfEdge(h, "h", Role::Given);
    Row {
        before: (
            before,
            vec![Mark::Face(left, "f", [38.0, 76.0]), Mark::Face(right, "g", [112.0, 34.0]), arrow.clone()],
        ),
        after: (after, vec![Mark::Face(left, "f", [38.0, 34.0]), Mark::Face(right, "g", [112.0, 76.0]), arrow]),
    }
}

fn move_inner() -> Row {
    let hole: [Place; 4] = [[30.0, 40.0], [60.0, 40.0], [45.0, 70.0], [30.0, 40.0]];
    let before = Scene::new(&[&[BOX[0], LOWER, BOX[1], BOX[2], UPPER, BOX[3], BOX[0]], &[LOWER, UPPER], &hole]);
    let outside = before.half_edge(hole[1], hole[0]);
    let boundary: BoundaryKey = before.dcel.half_edge(outside).expect("it is live").boundary().key();
    let face = before.face(UPPER, LOWER);
    let mut after = before.clone();
    after.dcel.move_inner(boundary, face).expect("it is an inner one");
    for place in &hole[..3] {
        let v = before.dcel.vertex(before.vertex(*place)).expect("it is live").index();
        after.places.insert(v, [place[0] + 60.0, place[1]]);
    }
    assert!(after.dcel.validate().is_valid());
    let cycle: Vec<Mark> = before
        .dcel
        .boundary(boundary)
        .expect("it is live")
        .half_edges()
        .map(|h| Mark::Edge(h.key(), Role::Given))
        .collect();
    let marks = |place: Place| {
        let mut marks = cycle.clone();
        marks.push(Mark::Face(face, "f", place));
        marks
    };
    Row { before: (before, marks([105.0, 55.0])), after: (after, marks([105.0, 84.0])) }
}
