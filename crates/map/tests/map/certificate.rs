//! Certificates of drawings: a drawing without crossings has a certificate that passes, and nothing else has.

use crate::support::drawn::{Drawn, moved_inner, validate_embedding};
use std::cell::Cell;
use twinedge::program::choose::{Choose, Random};
use twinedge::validate::{Collect, Expectation, HalfEdgeRow, Link, Parts, Table, View};
use twinedge_certificate::{Column, Columns, Drawing, Labels, Test, check_drawing};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::certificate::{DrawingError, draw};
use twinedge_map::{Builder, Embedding, Noding, PlanarMap};

const PLANE: Expectation = Expectation::plane();

impl Drawn {
    fn is_valid(&self) -> bool {
        validate_embedding(self, &PLANE, Collect::First).is_valid()
    }

    /// Returns true if a certificate can be made and passes.
    fn is_certified(&self) -> bool {
        draw(self).is_ok_and(|drawing| self.passes(&drawing))
    }

    fn passes(&self, drawing: &Drawing) -> bool {
        check_drawing(&self.structure, &Labels::new(&self.structure).unwrap(), drawing).is_ok()
    }
}

fn point(random: &mut Random, side: usize) -> [f64; 2] {
    [(); 2].map(|()| random.choose(side) as f64)
}

/// A plane map of segments, rings and points on a grid of `side` lines.
fn random_map(random: &mut Random, side: usize, segments: usize) -> PlanarMap {
    let mut builder = Builder::new();
    for _ in 0..segments {
        let (from, to) = (point(random, side), point(random, side));
        if Point::from(from) != Point::from(to) {
            builder.segment(from, to).unwrap();
        }
    }
    let mut map = builder.build_with(Noding::Snap(Snap::Size(1.0))).unwrap();
    for _ in 0..random.choose(3) {
        let _ = map.insert_point(point(random, side));
    }
    map
}

#[test]
fn moved_vertices_are_judged_as_by_the_rules() {
    let (mut valid, mut broken) = (0, 0);
    let mut random = Random::seeded(1);
    for _ in 0..150 {
        let segments = random.choose(5);
        let map = Drawn::of(&random_map(&mut random, 4, segments));
        assert!(map.is_valid());
        let drawing = draw(&map).unwrap();
        assert!(map.passes(&drawing), "{}", map.structure);
        for v in (0..map.points.len()).filter(|v| map.is_vertex(*v)) {
            for (x, y) in (0..16).map(|i| (i % 4, i / 4)) {
                let mut moved = map.clone();
                moved.points[v] = Point::new(f64::from(x), f64::from(y));
                let is_valid = moved.is_valid();
                assert_eq!(moved.is_certified(), is_valid, "vertex {v} to {x} {y}: {}", map.structure);
                // The old drawing with the point moved: if it passes, the map is valid.
                let mut old = drawing.clone();
                let unit = 1_i64 << (-old.exponent).max(0);
                old.points[v] = [i64::from(x) * unit, i64::from(y) * unit];
                assert!(
                    !(old.exponent <= 0 && moved.passes(&old)) || is_valid,
                    "vertex {v} to {x} {y}: {}",
                    map.structure
                );
                *if is_valid { &mut valid } else { &mut broken } += 1;
            }
        }
    }
    assert!(valid > 4_000 && broken > 4_000, "{valid} {broken}");
}

/// Faults that break only rules of coordinates: a mirror image, an isolated vertex or a component in another face.
#[test]
fn other_topologies_on_the_same_points_are_judged_as_by_the_rules() {
    let (mut valid, mut broken) = (0, 0);
    let mut random = Random::seeded(2);
    for _ in 0..150 {
        let map = Drawn::of(&random_map(&mut random, 5, 4));
        let drawing = draw(&map).unwrap();
        let mut judge = |other: &Drawn| {
            let is_valid = other.is_valid();
            assert_eq!(other.is_certified(), is_valid, "{}", other.structure);
            *if is_valid { &mut valid } else { &mut broken } += 1;
            is_valid
        };
        let mut mirrored = map.clone();
        mirrored.points.iter_mut().for_each(|point| point.x = -point.x);
        judge(&mirrored);
        for b in 0..map.structure.boundaries.len() {
            for f in 0..map.structure.faces.len() {
                if let Some(moved) = moved_inner(&map.structure, b, f) {
                    let moved = Drawn { structure: moved, ..map.clone() };
                    assert_eq!(moved.passes(&drawing), judge(&moved), "{}", moved.structure);
                }
            }
        }
    }
    assert!(valid > 300 && broken > 150, "{valid} {broken}");
}

/// Sets every entry of a drawing to every other value: the change is detected, or the certificate is still valid. No point of a
/// vertex changes, so nothing invalid can be certified; the tests must detect the values with another meaning.
#[test]
fn a_changed_entry_is_found_or_as_good() {
    let mut map = triangles();
    map.insert_point([7.0, 7.0]).unwrap();
    let labels = Labels::new(&map).unwrap();
    let drawing = draw(&map).unwrap();
    let mut found = Vec::new();
    for column in Column::of_drawing() {
        let (mut caught, mut as_good) = (0, 0);
        for i in 0..drawing.columns.column(*column).len() {
            for value in (0..40).chain([u32::MAX - 1, u32::MAX]) {
                let mut changed = drawing.clone();
                let entry = &mut changed.columns.column_mut(*column)[i];
                if *entry != value {
                    *entry = value;
                    *if check_drawing(&map, &labels, &changed).is_ok() { &mut as_good } else { &mut caught } += 1;
                }
            }
        }
        found.push((column.name(), caught, as_good));
    }
    // Ranks are arbitrary growing numbers. A vertex may keep any dart from it, and vacant slots are ignored.
    let as_good: Vec<_> = found.iter().filter(|(_, _, as_good)| *as_good > 0).map(|(name, ..)| *name).collect();
    assert_eq!(as_good, ["dart_rank", "half_edge_dart", "vertex_dart", "face_dart"], "{found:?}");
    assert!(found.iter().all(|(_, caught, _)| *caught > 0), "{found:?}");
}

#[test]
fn coordinates_are_integers_on_the_finest_grid_that_they_need() {
    let mut map = PlanarMap::new();
    map.insert_segment([0.25, -3.0], [1e6, 0.0]).unwrap();
    let drawing = draw(&map).unwrap();
    // Slot 0 is vacant, and three corners are added.
    assert_eq!((drawing.exponent, &drawing.points[1..3]), (-2, &[[1, -12], [4_000_000, 0]][..]));
    assert_eq!(drawing.points.len(), 6);
    assert!(draw(&PlanarMap::new()).is_ok_and(|drawing| drawing.columns.column(Column::DartTwin).len() == 6));
}

/// An edge, with the number of bends of each of its half-edges.
struct Bent([usize; 2]);
impl View for Bent {
    fn parts(&self) -> Parts {
        Parts::NONE
    }
    fn vertex_slots(&self) -> usize {
        2
    }
    fn half_edge_slots(&self) -> usize {
        2
    }
    fn origin(&self, h: usize) -> Link {
        Some(h)
    }
    fn twin(&self, h: usize) -> Link {
        Some(1 - h)
    }
    fn next(&self, h: usize) -> Link {
        Some(1 - h)
    }
}
impl Embedding for Bent {
    fn point(&self, v: usize) -> Point {
        Point::new(v as f64, 0.0)
    }
    fn bends(&self, h: usize) -> usize {
        self.0[h]
    }
}

#[test]
fn what_has_no_certificate_is_an_error() {
    let mut map = PlanarMap::new();
    map.insert_segment([0.0, 0.0], [1.0, 1.0]).unwrap();
    let edge = Drawn::of(&map);
    let drawn = |from: [f64; 2], to: [f64; 2]| {
        draw(&Drawn { points: vec![Point::default(), from.into(), to.into()], ..edge.clone() }).map(drop)
    };
    assert_eq!(drawn([0.1, 0.0], [1e-9, 1.0]), Err(DrawingError::NoGrid));
    assert_eq!(drawn([1e300, 0.0], [1.0, 1.0]), Err(DrawingError::NoGrid));
    let largest = (1_u64 << 51) as f64;
    assert_eq!(drawn([-largest, largest], [largest, 1.0]), Ok(()));
    assert_eq!(drawn([-largest - 1.0, 0.0], [largest, 1.0]), Err(DrawingError::NoGrid));
    let mut map = Drawn::of(&random_map(&mut Random::seeded(3), 4, 3));
    map.points.iter_mut().for_each(|point| *point = Point::new(1.0, 1.0));
    assert_eq!(draw(&map), Err(DrawingError::NotPlane));
    map.points[1].x = f64::NAN;
    assert_eq!(draw(&map), Err(DrawingError::NoGrid));
    // Dangling links.
    map.points.iter_mut().for_each(|point| *point = Point::default());
    map.structure.half_edges.iter_mut().flatten().for_each(|row| *row = HalfEdgeRow::default());
    assert_eq!(draw(&map), Err(DrawingError::NotPlane));
    assert_eq!(draw(&Bent([1, 1])), Err(DrawingError::Bends { half_edge: 0 }));
}

/// Owners of structures need not answer for the half-edge with the larger index.
#[test]
fn bends_are_asked_of_the_half_edge_with_the_smaller_index() {
    assert!(draw(&Bent([0, 1])).is_ok());
}

/// Columns of other lengths, missing points, and coordinates out of range are unreadable.
#[test]
fn what_is_unreadable_is_not_tested() {
    let map = random_map(&mut Random::seeded(4), 5, 4);
    let labels = Labels::new(&map).unwrap();
    let drawing = draw(&map).unwrap();
    let is_unreadable = |changed: &Drawing| {
        let failures = check_drawing(&map, &labels, changed).unwrap_err();
        failures.len() == 1 && failures[0].test() == Test::Readable
    };
    for column in Column::of_drawing() {
        let mut changed = drawing.clone();
        changed.columns.column_mut(*column).pop();
        assert!(is_unreadable(&changed), "{}", column.name());
    }
    let mut changed = drawing.clone();
    changed.columns.column_mut(Column::DartPoint)[0] = drawing.points.len() as u32;
    assert!(is_unreadable(&changed));
    for x in [-(1 << 53) - 1, 1 << 53] {
        let mut changed = drawing.clone();
        changed.points[0][1] = x;
        assert!(is_unreadable(&changed));
    }
}

/// The tests that fail for a map whose structure or drawing was changed.
fn failing(map: &Drawn, labels: &Labels, drawing: &Drawing) -> Vec<Test> {
    let failures = check_drawing(&map.structure, labels, drawing).err().unwrap_or_default();
    failures.iter().map(|failure| failure.test()).collect()
}

fn set(drawing: &mut Drawing, column: Column, i: usize, value: u32) {
    drawing.columns.column_mut(column)[i] = value;
}

/// Two triangles, one in the other.
fn triangles() -> PlanarMap {
    let mut builder = Builder::new();
    for corners in [[[0.0, 0.0], [6.0, 0.0], [0.0, 6.0]], [[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]]] {
        builder.shape(&twinedge_map::Shape::polygon(corners)).unwrap();
    }
    builder.build().unwrap()
}

fn nested() -> (Drawn, Labels, Drawing) {
    let map = Drawn::of(&triangles());
    let (labels, drawing) = (Labels::new(&map.structure).unwrap(), draw(&map).unwrap());
    (map, labels, drawing)
}

#[test]
fn a_vertex_has_a_dart_that_starts_there() {
    let (map, labels, drawing) = nested();
    for v in (0..map.points.len()).filter(|v| map.is_vertex(*v)) {
        for (dart, point) in drawing.columns.column(Column::DartPoint).iter().enumerate() {
            let mut changed = drawing.clone();
            set(&mut changed, Column::VertexDart, v, dart as u32);
            let expected = if *point as usize == v { vec![] } else { vec![Test::VertexDartOk] };
            assert_eq!(failing(&map, &labels, &changed), expected, "vertex {v}, dart {dart}");
        }
    }
}

#[test]
fn a_triangle_between_added_edges_is_in_the_face_around_it() {
    let (map, labels, drawing) = nested();
    let half_edge = drawing.columns.column(Column::DartHalfEdge);
    let is_added = |triangle: &usize| (0..3).all(|i| half_edge[3 * triangle + i] == u32::MAX);
    let mut seen = 0;
    for triangle in (1..half_edge.len() / 3).filter(is_added) {
        let mut changed = drawing.clone();
        for dart in 3 * triangle..3 * triangle + 3 {
            let face = drawing.columns.column(Column::DartFace)[dart];
            set(&mut changed, Column::DartFace, dart, (0..3).find(|f| *f != face).unwrap());
        }
        assert_eq!(failing(&map, &labels, &changed), [Test::DartFaceOk], "triangle {triangle}");
        seen += 1;
    }
    assert!(seen > 0);
}

/// In a face of one triangle, ranks descend towards the next face.
#[test]
fn ranks_lead_down_inside_a_face() {
    let (map, labels, mut drawing) = nested();
    let half_edge = drawing.columns.column(Column::DartHalfEdge);
    let triangle = (0..half_edge.len() / 3).find(|triangle| (0..3).all(|i| half_edge[3 * triangle + i] != u32::MAX));
    let darts = [0, 1, 2].map(|i| 3 * triangle.unwrap() + i);
    let kept =
        darts.iter().position(|dart| drawing.columns.column(Column::FaceDart).contains(&(*dart as u32))).unwrap();
    for (i, rank) in [(0, 3000), (1, 2000), (2, 1000)] {
        set(&mut drawing, Column::DartRank, darts[(kept + i) % 3], rank);
    }
    assert_eq!(failing(&map, &labels, &drawing), [Test::DartRankOk]);
}

/// A half-edge misplaced on one side of the big triangle, which has no vertex of the map.
#[test]
fn a_half_edge_lies_on_one_dart() {
    let (map, labels, drawing) = nested();
    let points = drawing.columns.column(Column::DartPoint);
    let unbounded = drawing.columns.column(Column::DartFace)[0];
    let half_edges = drawing.columns.column(Column::DartHalfEdge).iter().zip(drawing.columns.column(Column::DartFace));
    let half_edge =
        *half_edges.filter(|(h, face)| **h != u32::MAX && **face == unbounded).map(|(h, _)| h).next().unwrap();
    let found = [0, 1, 2].map(|dart| {
        let twin = drawing.columns.column(Column::DartTwin)[dart] as usize;
        let mut changed = drawing.clone();
        for at in [dart, twin] {
            set(&mut changed, Column::DartHalfEdge, at, half_edge);
        }
        for other in (0..points.len()).filter(|other| [points[dart], points[twin]].contains(&points[*other])) {
            set(&mut changed, Column::DartAhead, other, half_edge);
        }
        failing(&map, &labels, &changed)
    });
    assert!(found.contains(&vec![Test::DartHalfEdgeOk]), "{found:?}");
}

/// Two corners of a triangle have exchanged their names in the structure.
#[test]
fn a_half_edge_starts_where_its_dart_starts() {
    let (mut map, labels, drawing) = nested();
    let live: Vec<usize> = (0..map.points.len()).filter(|v| map.is_vertex(*v)).collect();
    let inner: Vec<usize> = live.into_iter().filter(|v| map.points[*v].x.max(map.points[*v].y) < 3.0).collect();
    let [u, v] = [inner[1], inner[2]];
    for row in map.structure.half_edges.iter_mut().flatten() {
        row.origin = row.origin.map(|origin| if [u, v].contains(&origin) { u + v - origin } else { origin });
    }
    map.structure.vertices.swap(u, v);
    assert_eq!(failing(&map, &labels, &drawing), [Test::HalfEdgeDartOk]);
}

/// At the middle of a path, the half-edges lie on each other's darts.
#[test]
fn a_half_edge_lies_on_the_other_side_of_its_twin() {
    let mut map = PlanarMap::new();
    map.insert_segment([0.0, 0.0], [2.0, 1.0]).unwrap();
    map.insert_segment([2.0, 1.0], [4.0, 0.0]).unwrap();
    let map = Drawn::of(&map);
    let (labels, mut drawing) = (Labels::new(&map.structure).unwrap(), draw(&map).unwrap());
    assert_eq!(failing(&map, &labels, &drawing), []);
    let middle = map.points.iter().position(|point| *point == Point::new(2.0, 1.0)).unwrap();
    let around: Vec<u32> =
        (0..map.structure.half_edges.len()).filter(|h| map.origin(*h) == Some(middle)).map(|h| h as u32).collect();
    let other = |h: u32| if around.contains(&h) { around[0] + around[1] - h } else { h };
    for column in [Column::DartHalfEdge, Column::DartAhead] {
        drawing.columns.column_mut(column).iter_mut().filter(|h| **h != u32::MAX).for_each(|h| *h = other(*h));
    }
    drawing.columns.column_mut(Column::HalfEdgeDart).swap(around[0] as usize, around[1] as usize);
    assert_eq!(failing(&map, &labels, &drawing), [Test::HalfEdgeDartOk]);
}

/// One triangle on both sides of nothing, for a map without vertices.
#[test]
fn the_outer_triangle_is_not_flat() {
    let table: Table = "V 0 H 0 B 0 F 1 - 0".parse().unwrap();
    let map = Drawn::new(table, Vec::<Point>::new());
    let mut drawing = Drawing { points: vec![[0, 0]], ..Drawing::default() };
    let columns = [
        (Column::DartTwin, vec![0, 1, 2]),
        (Column::DartPoint, vec![0; 3]),
        (Column::DartHalfEdge, vec![u32::MAX; 3]),
        (Column::DartAhead, vec![0; 3]),
        (Column::DartFace, vec![0; 3]),
        (Column::DartRank, vec![0, 2, 1]),
        (Column::FaceDart, vec![0]),
    ];
    for (column, numbers) in columns {
        *drawing.columns.column_mut(column) = numbers;
    }
    assert_eq!(failing(&map, &Labels::new(&map.structure).unwrap(), &drawing), [Test::TriangleOk]);
}

/// The twin then has no dart, which is also reported.
#[test]
fn an_edge_is_added_on_both_sides() {
    let (map, labels, drawing) = nested();
    let half_edge = drawing.columns.column(Column::DartHalfEdge);
    for dart in (0..half_edge.len()).filter(|dart| half_edge[*dart] != u32::MAX) {
        let mut changed = drawing.clone();
        set(&mut changed, Column::DartHalfEdge, dart, u32::MAX);
        let failures = failing(&map, &labels, &changed);
        assert!(failures.contains(&Test::DartHalfEdgeOk), "dart {dart}: {failures:?}");
    }
}

/// A triangle whose last `next` leads past the last slot, and that claims a half-edge there.
struct Liar(PlanarMap);

impl View for Liar {
    twinedge::delegate_view!(|this| &this.0; except next, is_half_edge);

    fn next(&self, half_edge: usize) -> Link {
        if half_edge + 1 == self.0.half_edge_slots() { Some(half_edge + 1) } else { self.0.next(half_edge) }
    }

    fn is_half_edge(&self, half_edge: usize) -> bool {
        half_edge == self.0.half_edge_slots() || self.0.is_half_edge(half_edge)
    }
}

impl Embedding for Liar {
    fn point(&self, vertex: usize) -> Point {
        Embedding::point(&self.0, vertex)
    }
}

#[test]
fn a_structure_that_lies_about_its_slots_is_not_drawn() {
    let mut map = PlanarMap::new();
    map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]]).unwrap();
    assert_eq!(draw(&Liar(map)).err(), Some(DrawingError::NotPlane));
}

/// A drawing whose points move far away after a number of reads.
struct Restless<'a> {
    drawing: &'a Drawing,
    asked: Cell<usize>,
    patience: usize,
}

impl Columns for Restless<'_> {
    type Numbers<'a>
        = &'a [u32]
    where
        Self: 'a;

    fn column(&self, column: Column) -> &[u32] {
        self.drawing.columns.column(column)
    }
    fn points(&self) -> usize {
        self.drawing.points.len()
    }
    fn point(&self, point: usize) -> Option<[i64; 2]> {
        self.asked.set(self.asked.get() + 1);
        let far = [[i64::MIN, i64::MIN], [i64::MAX, i64::MIN], [i64::MIN, i64::MAX]];
        if self.asked.get() > self.patience { Some(far[point % 3]) } else { self.drawing.points.get(point).copied() }
    }
}

#[test]
fn points_that_move_while_they_are_checked_do_not_pass() {
    let mut map = PlanarMap::new();
    map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]).unwrap();
    map.insert_point([1.0, 2.0]).unwrap();
    let (labels, drawing) = (Labels::new(&map).unwrap(), draw(&map).unwrap());
    let failed = |patience| {
        let restless = Restless { drawing: &drawing, asked: Cell::new(0), patience };
        let failures = check_drawing(&map, &labels, &restless).err().unwrap_or_default();
        (failures.iter().map(|failure| failure.test()).collect::<Vec<_>>(), restless.asked.get())
    };
    let (failures, questions) = failed(usize::MAX);
    assert!(failures.is_empty());
    let points = drawing.points.len();
    assert!((0..points).all(|patience| failed(patience).0 == [Test::Readable]));
    // Once all were in range.
    assert_eq!(failed(points).0, [Test::TriangleOk]);
    assert!((points..questions).all(|patience| failed(patience).1 == questions));
}

/// A column of zeros of this length.
#[derive(Clone, Copy)]
struct Zeros(usize);

impl twinedge_certificate::Numbers for Zeros {
    fn count(self) -> usize {
        self.0
    }
    fn at(self, _i: usize) -> Option<u32> {
        Some(0)
    }
}

/// A drawing of a map that claims this number of darts and points.
struct Endless {
    map: PlanarMap,
    darts: usize,
    points: usize,
}

impl Columns for Endless {
    type Numbers<'a> = Zeros;

    fn column(&self, column: Column) -> Zeros {
        Zeros(match column {
            Column::HalfEdgeDart => self.map.half_edge_slots(),
            Column::VertexDart => self.map.vertex_slots(),
            Column::FaceDart => self.map.face_slots(),
            _ => self.darts,
        })
    }
    fn points(&self) -> usize {
        self.points
    }
    fn point(&self, _point: usize) -> Option<[i64; 2]> {
        Some([0, 0])
    }
}

#[test]
fn more_darts_or_points_than_can_be_numbered_are_not_looked_at() {
    let failed = |darts, points| {
        let drawing = Endless { map: PlanarMap::new(), darts, points };
        let labels = Labels::new(&drawing.map).unwrap();
        let failures = check_drawing(&drawing.map, &labels, &drawing).err().unwrap_or_default();
        failures.iter().map(|failure| failure.test()).collect::<Vec<_>>()
    };
    assert!(!failed(0, 3).contains(&Test::Readable));
    assert_eq!(failed(usize::MAX, 3), [Test::Readable]);
    assert_eq!(failed(0, usize::MAX), [Test::Readable]);
}
