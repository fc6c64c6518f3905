//! Imports: the same map, keys in the right places, and nothing but planar subdivisions.

use crate::support::erased::validate;
use crate::support::inconsistent::Inconsistent;
use crate::support::programs::{built, check};
use crate::support::tables::{
    TEXTBOOK, Without, face, half_edge, map, textbook_map, textbook_mesh, with_boundary_components, without_border,
};
use std::cell::Cell;
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};
use twinedge::dcel::{Dcel, ImportError, Keys, Outside};
use twinedge::delegate_view;
use twinedge::program::Program;
use twinedge::validate::{Collect, Expectation, FaceRow, Part, Parts, Rule, Start, Table, VertexRow, View};
use twinedge_trials::canonical::isomorphic;
use twinedge_trials::enumerate::for_each_corruption;
use twinedge_trials::forms::{Form, projected};

const PLANE: Expectation = Expectation::plane();
const MESH: Expectation = Expectation::surface();

/// The table of a structure, restricted to these parts.
fn table(view: &impl View, parts: Parts) -> Table {
    projected(&Table::copy_of(view).unwrap(), &Form::new(PLANE, parts))
}

/// Asserts that every record has the key of the record with the same links.
fn assert_keys_fit<V: View>(view: &V, map: &Dcel, keys: &Keys) {
    for h in 0..view.half_edge_slots() {
        assert_eq!(keys.half_edge(h).is_some(), view.is_half_edge(h));
        let Some(key) = keys.half_edge(h) else { continue };
        let here = map.half_edge(key).unwrap();
        assert_eq!(Some(here.next().key()), keys.half_edge(view.next(h).unwrap()));
        assert_eq!(Some(here.origin().key()), keys.vertex(view.origin(h).unwrap()));
        if let Some(t) = view.twin(h) {
            assert_eq!(Some(here.twin().key()), keys.half_edge(t));
            assert_eq!(here.index() < here.twin().index(), h < t);
        }
        if let Some(b) = view.boundary(h) {
            assert_eq!(Some(here.boundary().key()), keys.boundary(b));
            assert_eq!(Some(here.face().key()), keys.face(view.boundary_face(b).unwrap()));
        }
        if let Some(f) = view.face(h) {
            assert_eq!(Some(here.face().key()), keys.face(f));
        }
    }
    for v in 0..view.vertex_slots() {
        assert_eq!(keys.vertex(v).is_some(), view.is_vertex(v));
        if let (Some(key), Some(h)) = (keys.vertex(v), view.leaving(v)) {
            assert_eq!(map.vertex(key).unwrap().leaving().map(|h| h.key()), keys.half_edge(h));
        }
    }
    for b in 0..view.boundary_slots() {
        assert_eq!(keys.boundary(b).is_some(), view.is_boundary(b));
        let Some(key) = keys.boundary(b) else { continue };
        let here = map.boundary(key).unwrap();
        match view.boundary_start(b).unwrap() {
            Start::HalfEdge(h) => assert_eq!(here.start().map(|h| h.key()), keys.half_edge(h)),
            Start::Vertex(v) => assert_eq!(here.isolated_vertex().map(|v| v.key()), keys.vertex(v)),
        }
    }
    for f in 0..view.face_slots() {
        assert_eq!(keys.face(f).is_some(), view.is_face(f));
        let Some(key) = keys.face(f) else { continue };
        let here = map.face(key).unwrap();
        let inner: Vec<_> = here.inner().map(|b| Some(b.key())).collect();
        if view.boundary_slots() > 0 {
            let listed: Vec<_> = (0..view.inner_count(f)).map(|i| keys.boundary(view.inner(f, i).unwrap())).collect();
            assert_eq!(inner, listed);
        } else {
            let starts: Vec<_> = here
                .inner()
                .map(|b| (b.start().map(|h| Some(h.key())), b.isolated_vertex().map(|v| Some(v.key()))))
                .collect();
            let listed = (0..view.inner_count(f)).map(|i| match view.inner_start(f, i).unwrap() {
                Start::HalfEdge(h) => (Some(keys.half_edge(h)), None),
                Start::Vertex(v) => (None, Some(keys.vertex(v))),
            });
            assert_eq!(starts[..view.inner_count(f)], listed.collect::<Vec<_>>());
        }
    }
    let beyond = usize::MAX;
    assert_eq!((keys.vertex(beyond), keys.half_edge(beyond)), (None, None));
    assert_eq!((keys.boundary(beyond), keys.face(beyond)), (None, None));
}

#[test]
fn what_a_program_makes_comes_in_again() {
    fn law(program: Program) {
        let made = built(&program);
        let (map, keys) = Dcel::from_view(&made, &PLANE, Outside::Given).unwrap();
        assert!(map.validate().is_valid());
        assert!(isomorphic(&map, &made));
        assert_eq!(keys.face(made.unbounded_face().index()), Some(map.unbounded_face().key()));
        assert_keys_fit(&made, &map, &keys);

        let textbook = table(&made, TEXTBOOK);
        let (map, keys) = Dcel::from_view(&textbook, &PLANE, Outside::Given).unwrap();
        assert!(isomorphic(&map, &made));
        assert_keys_fit(&textbook, &map, &keys);
    }
    check(300, 200, law as fn(Program));
}

#[test]
fn parts_may_be_missing() {
    fn law(program: Program) {
        let made = built(&program);
        for parts in [Parts::ALL.without(Part::Places), TEXTBOOK] {
            let table = table(&made, parts.without(Part::Prev).without(Part::Leaving));
            let (map, keys) = Dcel::from_view(&table, &PLANE, Outside::Given).unwrap();
            assert!(isomorphic(&map, &made));
            assert_keys_fit(&table, &map, &keys);
        }
    }
    check(100, 100, law as fn(Program));
}

/// The numbers of structures imported as meshes, closed and open.
static MESHES: [AtomicUsize; 3] = [AtomicUsize::new(0), AtomicUsize::new(0), AtomicUsize::new(0)];

#[test]
fn meshes_come_in_by_a_face_or_a_border() {
    fn law(program: Program) {
        let made = built(&program);
        let one_cycle_each = made.faces().all(|f| f.boundaries().count() == 1);
        let Some(around) = made.unbounded_face().inner().next().and_then(|b| b.start()) else { return };
        if !one_cycle_each {
            return;
        }
        let outside = made.unbounded_face().index();
        let mut closed = table(&made, TEXTBOOK);
        *face(&mut closed, outside) = FaceRow { outer_half_edge: Some(around.index()), ..FaceRow::default() };
        let (map, keys) = Dcel::from_view(&closed, &MESH, Outside::Face(outside)).unwrap();
        assert!(isomorphic(&map, &made));
        assert_keys_fit(&closed, &map, &keys);
        assert_eq!(keys.face(outside), Some(map.unbounded_face().key()));
        MESHES[0].fetch_add(1, Ordering::Relaxed);

        // Half-edges with a twin but without a face.
        let mut open = closed.clone();
        open.faces[outside] = None;
        for h in around.boundary_cycle() {
            half_edge(&mut open, h.index()).face = None;
        }
        let (map, keys) = Dcel::from_view(&open, &MESH.open(), Outside::Border).unwrap();
        assert!(isomorphic(&map, &made));
        assert_keys_fit(&open, &map, &keys);
        MESHES[1].fetch_add(1, Ordering::Relaxed);

        // Half-edges without twin. If the border meets a vertex or an edge twice, the structure changes.
        let once: BTreeSet<_> = around.boundary_cycle().map(|h| h.origin().index()).collect();
        let bridges = around.boundary_cycle().any(|h| h.twin().face().is_unbounded());
        if bridges || once.len() < around.boundary_cycle().count() {
            return;
        }
        for h in around.boundary_cycle() {
            open.half_edges[h.index()] = None;
            if let Some(twin) = &mut open.half_edges[h.twin().index()] {
                twin.twin = None;
            }
            if let Some(v) = &mut open.vertices[h.origin().index()] {
                v.leaving = Some(h.clockwise().index());
            }
        }
        let open = open.without(Part::Prev).without(Part::Leaving);
        let (map, keys) = Dcel::from_view(&open, &OPEN, Outside::Border).unwrap();
        assert!(isomorphic(&map, &made));
        for h in (0..open.half_edge_slots()).filter(|h| open.is_half_edge(*h) && open.twin(*h).is_none()) {
            let twin = map.half_edge(keys.half_edge(h).unwrap()).unwrap().twin();
            assert!(twin.face().is_unbounded());
        }
        MESHES[2].fetch_add(1, Ordering::Relaxed);
    }
    check(1500, 25, law as fn(Program));
    for count in &MESHES {
        assert!(count.load(Ordering::Relaxed) > 20, "{MESHES:?}");
    }
}

#[test]
fn a_corrupted_table_comes_in_only_if_it_is_valid_all_the_same() {
    let (mut refused, mut valid) = (0, 0);
    let mut all = |mut table: Table| {
        let parts = table.parts;
        for_each_corruption(&mut table, parts, |corrupted, _, _| {
            let report = validate(corrupted, &PLANE, Collect::All);
            match Dcel::from_view(corrupted, &PLANE, Outside::Given) {
                Ok((map, keys)) => {
                    assert!(report.is_valid());
                    assert!(map.validate().is_valid());
                    assert_keys_fit(corrupted, &map, &keys);
                    valid += 1;
                }
                Err(ImportError::Invalid(found)) => {
                    assert!(!report.is_valid());
                    assert_eq!(*found, report);
                    refused += 1;
                }
                Err(other) => panic!("{other}"),
            }
        });
    };
    let program = "twinedge program 1
        add_isolated_vertex unbounded
        split_vertex i0 i0
        connect h0 h1 left
        add_isolated_vertex h0
        add_isolated_vertex unbounded
        split_vertex i0 i0";
    let made = built(&program.parse().unwrap());
    all(table(&made, Parts::ALL));
    all(table(&made, TEXTBOOK));
    assert!(refused > 500 && valid > 5, "{refused} refused, {valid} valid");
}

#[test]
fn a_view_that_changes_its_answers_never_comes_in_wrong() {
    let program = "twinedge program 1
        add_isolated_vertex unbounded
        split_vertex i0 i0
        connect h0 h1 left
        add_isolated_vertex h0
        add_isolated_vertex unbounded";
    let made = built(&program.parse().unwrap());
    let mut outcomes = [0; 3];
    for table in [Parts::ALL, TEXTBOOK].map(|parts| table(&made, parts)) {
        for patience in 0..400 {
            for seed in 0..5 {
                let view = Inconsistent::new(&table, patience, seed);
                let outcome = match Dcel::from_view(&view, &PLANE, Outside::Given) {
                    Ok((map, _)) => {
                        assert!(map.validate().is_valid());
                        0
                    }
                    Err(ImportError::Invalid(_)) => 1,
                    Err(ImportError::Inconsistent | ImportError::Border | ImportError::NotPlane(_)) => 2,
                    Err(other) => panic!("{other}"),
                };
                outcomes[outcome] += 1;
            }
        }
    }
    assert!(outcomes.iter().all(|count| *count > 0), "{outcomes:?}");
}

/// Answers from one table for a number of questions, and then from another one.
struct Switched<'a> {
    tables: [&'a Table; 2],
    left: Cell<usize>,
}

impl Switched<'_> {
    fn now(&self) -> &Table {
        match self.left.get().checked_sub(1) {
            None => self.tables[1],
            Some(left) => {
                self.left.set(left);
                self.tables[0]
            }
        }
    }
}

impl View for Switched<'_> {
    delegate_view!(|this| this.now());
}

/// Validation sees a loop in the unbounded face; afterwards the same loop lies in the face that it bounds.
#[test]
fn a_component_that_moves_into_itself_does_not_come_in() {
    let parsed = |text: &str| text.parse::<Table>().unwrap();
    let right = parsed("V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 1 h0 o 0 h1 i0 F 2 - 1 1 0 0");
    let inside_itself = parsed("V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 1 h0 o 1 h1 i0 F 2 - 0 0 1 1");
    let mut broken = BTreeSet::new();
    for patience in 0..300 {
        let view = Switched { tables: [&right, &inside_itself], left: Cell::new(patience) };
        match Dcel::from_view(&view, &PLANE, Outside::Given) {
            Ok((map, _)) => assert!(map.validate().is_valid()),
            Err(ImportError::NotPlane(report)) => {
                broken.insert(report.first().unwrap().rule());
            }
            Err(ImportError::Invalid(_) | ImportError::Inconsistent) => {}
            Err(other) => panic!("{other}"),
        }
    }
    assert!(broken.contains(&Rule::T2), "{broken:?}");
}

/// After validation, a face has lost its outer boundary component, the unbounded face has got one, or a closed mesh has become open.
#[test]
fn what_is_missing_when_it_is_read_is_inconsistent() {
    let parsed = |text: &str| text.parse::<Table>().unwrap();
    let right = parsed("V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 1 h0 o 0 h1 i0 F 2 - 1 1 0 0");
    let without_outer = parsed("V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 1 h0 o 0 h1 i0 F 2 - 1 1 - 0");
    let without_unbounded = parsed("V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 1 h0 o 0 h1 o F 2 1 0 0 0");
    let closed = textbook_mesh(3, &[[0, 1, 2], [2, 1, 0]]);
    let mut open = closed.clone();
    for h in 0..open.half_edges.len() {
        half_edge(&mut open, h).twin = None;
    }
    for (tables, expectation, outside) in [
        ([&right, &without_outer], PLANE, Outside::Given),
        ([&right, &without_unbounded], PLANE, Outside::Given),
        ([&closed, &open], MESH, Outside::Border),
    ] {
        let mut inconsistent = 0;
        for patience in 0..400 {
            let view = Switched { tables, left: Cell::new(patience) };
            match Dcel::from_view(&view, &expectation, outside) {
                Ok((map, _)) => assert!(map.validate().is_valid() && outside == Outside::Given),
                Err(ImportError::Inconsistent) => inconsistent += 1,
                Err(ImportError::Invalid(_) | ImportError::NotPlane(_) | ImportError::NoBorder) => {}
                Err(other) => panic!("{other}"),
            }
        }
        assert!(inconsistent > 0);
    }
}

fn refusal(view: &impl View, expectation: Expectation, outside: Outside) -> ImportError {
    Dcel::from_view(view, &expectation, outside).unwrap_err()
}

/// An open mesh of two triangles side by side, 0 1 2 and 2 1 3, without twins along their border.
fn two_triangles() -> Table {
    bordered(textbook_mesh(4, &[[0, 1, 2], [2, 1, 3]]))
}

/// Removes the half-edges that belong to no triangle.
fn bordered(table: Table) -> Table {
    let mut table = without_border(&table).without(Part::Prev).without(Part::Leaving);
    table.vertices.iter_mut().flatten().for_each(|row| row.leaving = None);
    table
}

const OPEN: Expectation = MESH.open();

const TETRAHEDRON: [[usize; 3]; 4] = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];

#[test]
fn a_tetrahedron_comes_in_by_any_of_its_faces() {
    let table = textbook_mesh(4, &TETRAHEDRON);
    for f in 0..4 {
        let (map, keys) = Dcel::from_view(&table, &MESH, Outside::Face(f)).unwrap();
        assert_eq!((map.vertex_count(), map.edge_count(), map.face_count()), (4, 6, 4));
        assert_eq!(keys.face(f), Some(map.unbounded_face().key()));
        assert_eq!(map.unbounded_face().inner_count(), 1);
        assert_keys_fit(&table, &map, &keys);
    }
}

#[test]
fn an_open_mesh_comes_in_by_its_border() {
    let table = two_triangles();
    let (map, keys) = Dcel::from_view(&table, &OPEN, Outside::Border).unwrap();
    assert_eq!((map.vertex_count(), map.edge_count(), map.face_count()), (4, 5, 3));
    assert_eq!(map.unbounded_face().half_edges().count(), 4);
    assert_keys_fit(&table, &map, &keys);
    // Records of boundary components, and border half-edges that name none.
    let mut records = with_boundary_components(&textbook_mesh(3, &[[0, 1, 2], [2, 1, 0]]));
    (records.boundaries[1], records.faces[1]) = (None, None);
    for row in records.half_edges.iter_mut().flatten().filter(|row| row.boundary == Some(1)) {
        row.boundary = None;
    }
    let (map, keys) = Dcel::from_view(&records, &OPEN, Outside::Border).unwrap();
    assert_eq!((map.vertex_count(), map.edge_count(), map.face_count()), (3, 3, 2));
    assert_keys_fit(&records, &map, &keys);
    // With a loose vertex and a second piece.
    let mut more = bordered(textbook_mesh(8, &[[0, 1, 2], [2, 1, 3], [4, 5, 6]]));
    let (map, keys) = Dcel::from_view(&more, &OPEN, Outside::Border).unwrap();
    assert_eq!(map.unbounded_face().inner_count(), 3);
    assert!(map.vertex(keys.vertex(7).unwrap()).unwrap().isolated().unwrap().face().is_unbounded());
    // Components that lie in a face have no border.
    more.faces.truncate(2);
    for h in 0..more.half_edges.len() {
        if more.half_edges[h].is_some_and(|row| row.face == Some(2)) {
            more.half_edges[h] = None;
        }
    }
    more.vertices.truncate(4);
    face(&mut more, 1).inner_starts = vec![];
    more.parts = more.parts.without(Part::UnboundedFace);
    more.vertices.push(Some(VertexRow::default()));
    face(&mut more, 1).inner_starts.push(Some(Start::Vertex(4)));
    let (map, keys) = Dcel::from_view(&more, &PLANE.open(), Outside::Border).unwrap();
    assert_eq!(map.unbounded_face().inner_count(), 1);
    assert_eq!(map.vertex(keys.vertex(4).unwrap()).unwrap().isolated().map(|b| b.face().key()), keys.face(1));
}

#[test]
fn what_is_not_valid_is_refused_with_the_report() {
    let mut table = textbook_mesh(4, &TETRAHEDRON);
    half_edge(&mut table, 0).next = Some(0);
    let error = refusal(&table, MESH, Outside::Face(0));
    let report = error.report().unwrap();
    assert!(matches!(error, ImportError::Invalid(_)));
    assert_eq!(report, &validate(&table, &MESH, Collect::All));
    assert_eq!(format!("{error:?}"), error.to_string());
    assert!(error.to_string().starts_with("the structure is not valid:\nR1"), "{error}");
}

#[test]
fn each_structure_that_does_not_suit_has_its_refusal() {
    let mesh = textbook_mesh(4, &TETRAHEDRON);
    let mut vacant = mesh.clone();
    vacant.faces.insert(0, None);
    for h in 0..12 {
        let row = half_edge(&mut vacant, h);
        row.face = row.face.map(|f| f + 1);
    }
    assert!(Dcel::from_view(&vacant, &MESH, Outside::Face(1)).is_ok());
    let plane = textbook_map(2, &[(0, 1), (1, 0)], &[(None, &[Start::HalfEdge(0)])]);
    // One vertex, two loops, one face.
    let torus = textbook_map(1, &[(0, 2), (0, 3), (0, 1), (0, 0)], &[(Some(0), &[])]);
    let twice: Vec<_> = TETRAHEDRON.iter().copied().chain(TETRAHEDRON.map(|t| t.map(|v| v + 4))).collect();
    let twice = textbook_mesh(8, &twice);
    // A ring of six triangles around a hole, and beside it a component without a border.
    let ring = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]];
    let with_closed: Vec<_> = ring.into_iter().chain(TETRAHEDRON.map(|t| t.map(|v| v + 6))).collect();
    let (ring, with_closed) = (bordered(textbook_mesh(6, &ring)), bordered(textbook_mesh(10, &with_closed)));
    for (table, expectation, outside, expected) in [
        (&mesh.without(Part::Faces), MESH, Outside::Face(0), ImportError::Lacks(Part::Faces)),
        (&mesh, MESH, Outside::Given, ImportError::NoUnboundedFace),
        (&mesh, MESH, Outside::Face(4), ImportError::NoSuchFace(4)),
        (&mesh, MESH, Outside::Border, ImportError::NoBorder),
        (&vacant, MESH, Outside::Face(0), ImportError::NoSuchFace(0)),
        (&plane, PLANE, Outside::Face(0), ImportError::SecondUnboundedFace),
        (&plane, PLANE, Outside::Border, ImportError::SecondUnboundedFace),
        (&torus, MESH, Outside::Face(0), ImportError::Genus(1)),
        (&twice, MESH, Outside::Face(0), ImportError::Disconnected(2)),
        (&two_triangles(), OPEN, Outside::Face(0), ImportError::Border),
        (&ring, OPEN, Outside::Border, ImportError::SeveralBorders { borders: 2, components: 1 }),
    ] {
        let error = refusal(table, expectation, outside);
        assert_eq!((error.report(), &error), (None, &expected));
    }
    let told = ImportError::Lacks(Part::Faces).to_string();
    assert_eq!(told, "a planar subdivision needs faces, which the structure does not store");
    // With lists of inner boundary components the validator finds the component that lies nowhere.
    let listed = twice.without(Part::UnboundedFace);
    for (table, expectation, outside) in [(&listed, PLANE, Outside::Face(0)), (&with_closed, OPEN, Outside::Border)] {
        let error = refusal(table, expectation, outside);
        assert!(matches!(error, ImportError::NotPlane(_) | ImportError::Invalid(_)), "{error}");
        assert_eq!(error.report().unwrap().first().unwrap().rule(), Rule::T1);
    }
}

#[test]
fn the_empty_map_comes_in() {
    let empty = map(0, &[], &[(None, &[])]);
    let (map, keys) = Dcel::from_view(&empty, &PLANE, Outside::Given).unwrap();
    assert_eq!((map.vertex_count(), map.edge_count(), map.face_count()), (0, 0, 1));
    assert_eq!(keys.face(0), Some(map.unbounded_face().key()));
}

#[test]
fn what_came_in_can_be_changed_and_its_keys_are_its_own() {
    let table = textbook_mesh(4, &TETRAHEDRON);
    let (mut one, keys) = Dcel::from_view(&table, &MESH, Outside::Face(0)).unwrap();
    let (other, other_keys) = Dcel::from_view(&table, &MESH, Outside::Face(0)).unwrap();
    let h = keys.half_edge(2).unwrap();
    assert!(other.half_edge(h).is_err());
    assert!(one.half_edge(other_keys.half_edge(2).unwrap()).is_err());
    one.remove_edge(h).unwrap();
    assert!(one.half_edge(h).is_err());
    let outside = one.unbounded_face().key();
    one.add_isolated_vertex(outside).unwrap();
    assert!(one.validate().is_valid());
}
