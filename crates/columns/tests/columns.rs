//! Columns of integers, and the presets of libraries.

#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicI32, AtomicI64, AtomicU32, AtomicU64};
use twinedge::validate::adapt::{FaceLabels, Targets};
use twinedge::validate::{Collect, Expectation, Part, Report, Rule, Start, Table, View};
use twinedge_columns::{Boundaries, Cell, Column, Columns, ColumnsError, OnView, Preset};
use twinedge_trials::enumerate::for_each_corruption;

const SURFACE: Expectation = Expectation::surface();

/// Calls the validator through a pointer: it is compiled once, and not for each type of view.
fn validate(view: &dyn View, expectation: &Expectation, collect: Collect) -> Report {
    twinedge::validate::validate(view, expectation, collect)
}

fn link(value: Option<usize>) -> i64 {
    value.map_or(-1, |value| i64::try_from(value).unwrap_or(-2))
}

/// The links of a table as records of five fields in one array, and the half-edges of vertices and faces.
struct Records {
    half_edges: Vec<i64>,
    leaving: Vec<i64>,
    outer: Vec<i64>,
}

fn records(table: &Table) -> Records {
    let of = |h: usize| [table.origin(h), table.twin(h), table.next(h), table.prev(h), table.face(h)].map(link);
    Records {
        half_edges: (0..table.half_edge_slots()).flat_map(of).collect(),
        leaving: (0..table.vertex_slots()).map(|v| link(table.leaving(v))).collect(),
        outer: (0..table.face_slots()).map(|f| link(table.outer_half_edge(f))).collect(),
    }
}

fn columns(records: &Records) -> Columns<'_, i64> {
    let n = records.half_edges.len() / 5;
    let field = |i| Column::strided(&records.half_edges, i, 5, n).unwrap();
    Columns::new(records.leaving.len(), field(0), field(1), field(2))
        .and_then(|c| c.with_prev(field(3)))
        .and_then(|c| c.with_faces(records.outer.len(), field(4)))
        .and_then(|c| c.with_leaving(Column::new(&records.leaving)))
        .and_then(|c| c.with_outer_half_edge(Column::new(&records.outer)))
        .unwrap()
}

/// Returns the links of the columns, each in an array of its own.
fn slices(columns: &Columns<'_, i64>, table: &Table) -> [Vec<i64>; 7] {
    let half_edges = |of: &dyn Fn(usize) -> Option<usize>| (0..table.half_edge_slots()).map(|h| link(of(h))).collect();
    [
        half_edges(&|h| columns.origin(h)),
        half_edges(&|h| columns.twin(h)),
        half_edges(&|h| columns.next(h)),
        half_edges(&|h| columns.prev(h)),
        half_edges(&|h| columns.face(h)),
        (0..table.vertex_slots()).map(|v| link(columns.leaving(v))).collect(),
        (0..table.face_slots()).map(|f| link(columns.outer_half_edge(f))).collect(),
    ]
}

fn whole(slices: &[Vec<i64>; 7]) -> Columns<'_, i64> {
    let [origin, twin, next, prev, face, leaving, outer] = slices;
    Columns::new(leaving.len(), Column::new(origin), Column::new(twin), Column::new(next))
        .and_then(|c| c.with_prev(Column::new(prev)))
        .and_then(|c| c.with_faces(outer.len(), Column::new(face)))
        .and_then(|c| c.with_leaving(Column::new(leaving)))
        .and_then(|c| c.with_outer_half_edge(Column::new(outer)))
        .unwrap()
}

/// Returns the name of the type of the judged view.
struct NameOfView;

impl OnView for NameOfView {
    type Output = &'static str;
    fn on<V: View>(self, _: V) -> &'static str {
        std::any::type_name::<V>()
    }
}

#[test]
fn columns_are_judged_in_the_fastest_form_that_they_have() {
    let table = pillow();
    let records = records(&table);
    let slices = slices(&columns(&records), &table);
    let whole = whole(&slices);
    let form = |columns: Columns<'_, i64>| {
        let name = columns.with_view(NameOfView).unwrap();
        let reads = ["Forward", "Column<", "&[i64]", "dyn"].into_iter().find(|kind| name.contains(kind)).unwrap();
        (reads, name.ends_with("true>"))
    };
    assert_eq!(form(whole), ("&[i64]", true));
    assert_eq!(form(whole.with_live_faces(&[true, true]).unwrap()), ("&[i64]", true));
    assert_eq!(form(whole.with_live_faces(&[true, false]).unwrap()), ("&[i64]", false));
    assert_eq!(form(columns(&records)), ("Forward", true));
    assert_eq!(form(columns(&records).with_live_faces(&[true, false]).unwrap()), ("Column<", false));
    let backward = Column::strided(&slices[3], 5, -1, 6).unwrap();
    assert_eq!(form(whole.with_prev(backward).unwrap()), ("Column<", false));
    assert_eq!(form(whole.by_target()), ("&[i64]", false));
    assert_eq!(form(columns(&records).by_target()).0, "dyn");
    // Twins are paired if there is no column of them.
    let paired = Columns::paired(3, Column::new(&slices[0]), Column::new(&slices[2])).unwrap();
    assert_eq!(
        ((0..6).map(|h| paired.twin(h)).collect::<Vec<_>>(), paired.prev(0)),
        ([1, 0, 3, 2, 5, 4].map(Some).to_vec(), None)
    );
}

/// A closed surface: two triangles, back to back.
fn pillow() -> Table {
    "P 3 prev leaving faces V 3 0 - 2 - 4 - H 6 0 1 2 4 - 1 0 5 3 - 1 3 4 0 - 2 2 1 5 - 2 5 0 2 - 0 4 3 1 - B 0 F 2 - 0 - 0 HF 6 0 1 0 1 0 1 FH 2 0 0 1 0"
        .parse()
        .unwrap()
}

/// Two triangles, one inside the other, and an isolated vertex between them, with boundary components but without places.
///
/// ```text
///   face 0                 vertices 0 1 2, half-edges 0 2 4 inside and 1 3 5 outside
///        2                 vertices 3 4 5, half-edges 6 8 10 inside and 7 9 11 outside
///       / \
///      / 5 \                boundary components: 0 around the outer triangle, listed by face 0
///     / / \ \                                    1 in it, outer of face 1
///    / /_2_\ \  ·6                              2 around the inner triangle and 3, which is vertex 6, listed by face 1
///   /  3   4  \                                  4 in the inner triangle, outer of face 2
///  0 ───────── 1           face 1 lies between the triangles, face 2 in the inner one
/// ```
fn nested() -> Table {
    "P 6 prev leaving faces boundary_components holes unbounded_face V 7 0 - 1 - 3 - 6 - 7 - 9 - - 3 \
     H 12 0 1 2 4 1 1 0 5 3 0 1 3 4 0 1 2 2 1 5 0 2 5 0 2 1 0 4 3 1 0 3 7 8 10 4 4 6 11 9 2 4 9 10 6 4 5 8 7 11 2 5 11 6 8 4 3 10 9 7 2 \
     B 5 0 h1 - 1 h0 - 1 h7 - 1 v6 - 2 h6 - F 3 - 1 0 1 2 2 3 4 0"
        .parse()
        .unwrap()
}

#[test]
fn columns_have_the_verdict_of_the_table_that_they_are_of() {
    let mut table = pillow();
    assert!(validate(&table, &SURFACE, Collect::All).is_valid());
    let (mut broken, parts) = (BTreeSet::new(), table.parts);
    for_each_corruption(&mut table, parts, |changed, _, _| {
        let records = records(changed);
        let columns = columns(&records);
        assert_eq!(columns.parts(), parts);
        let (of_table, of_columns) =
            (validate(changed, &SURFACE, Collect::All), validate(&columns, &SURFACE, Collect::All));
        let slices = slices(&columns, changed);
        let whole = whole(&slices);
        let last = slices[3].len() - 1;
        let backward: Vec<_> = slices[3].iter().rev().copied().collect();
        let backward = Column::strided(&backward, last, -1, slices[3].len()).unwrap();
        for form in [columns, whole, whole.with_prev(backward).unwrap()] {
            assert_eq!(Some(&of_columns), form.validate(SURFACE, Collect::All).as_ref());
        }
        assert_eq!(of_table.broken_rules().collect::<Vec<_>>(), of_columns.broken_rules().collect::<Vec<_>>());
        broken.extend(of_columns.broken_rules().next());
    });
    assert!(broken.len() >= 7, "{broken:?}");
}

/// The records of boundary components of a table, and the lists of its faces one after the other.
#[derive(Default)]
struct Lists {
    boundary: Vec<i64>,
    isolated: Vec<i64>,
    face: Vec<i64>,
    half_edge: Vec<i64>,
    vertex: Vec<i64>,
    outer: Vec<i64>,
    inner_first: Vec<i64>,
    inner: Vec<i64>,
    live: [Vec<bool>; 4],
}

fn lists(table: &Table) -> Lists {
    let mut lists = Lists {
        boundary: (0..table.half_edge_slots()).map(|h| link(table.boundary(h))).collect(),
        isolated: (0..table.vertex_slots()).map(|v| link(table.isolated(v))).collect(),
        outer: (0..table.face_slots()).map(|f| link(table.outer(f))).collect(),
        live: [
            (0..table.vertex_slots()).map(|v| table.is_vertex(v)).collect(),
            (0..table.half_edge_slots()).map(|h| table.is_half_edge(h)).collect(),
            (0..table.boundary_slots()).map(|b| table.is_boundary(b)).collect(),
            (0..table.face_slots()).map(|f| table.is_face(f)).collect(),
        ],
        ..Lists::default()
    };
    for boundary in 0..table.boundary_slots() {
        lists.face.push(link(table.boundary_face(boundary)));
        let (half_edge, vertex) = match table.boundary_start(boundary) {
            Some(Start::HalfEdge(half_edge)) => (Some(half_edge), None),
            Some(Start::Vertex(vertex)) => (None, Some(vertex)),
            None => (None, None),
        };
        lists.half_edge.push(link(half_edge));
        lists.vertex.push(link(vertex));
    }
    for face in 0..table.face_slots() {
        lists.inner_first.push(i64::try_from(lists.inner.len()).unwrap());
        lists.inner.extend((0..table.inner_count(face)).map(|i| link(table.inner(face, i))));
    }
    lists.inner_first.push(i64::try_from(lists.inner.len()).unwrap());
    lists
}

fn boundaries(lists: &Lists) -> Boundaries<'_, i64> {
    Boundaries {
        boundary: Column::new(&lists.boundary),
        isolated: Some(Column::new(&lists.isolated)),
        face: Column::new(&lists.face),
        half_edge: Column::new(&lists.half_edge),
        vertex: Some(Column::new(&lists.vertex)),
        outer: Column::new(&lists.outer),
        inner_first: Column::new(&lists.inner_first),
        inner: Column::new(&lists.inner),
    }
}

fn with_lists<'a>(records: &'a Records, lists: &'a Lists) -> Columns<'a, i64> {
    let n = records.half_edges.len() / 5;
    let field = |i| Column::strided(&records.half_edges, i, 5, n).unwrap();
    Columns::new(records.leaving.len(), field(0), field(1), field(2))
        .and_then(|c| c.with_prev(field(3)))
        .and_then(|c| c.with_leaving(Column::new(&records.leaving)))
        .and_then(|c| c.with_boundaries(lists.outer.len(), boundaries(lists)))
        .and_then(|c| c.with_live_vertices(&lists.live[0]))
        .and_then(|c| c.with_live_half_edges(&lists.live[1]))
        .and_then(|c| c.with_live_boundaries(&lists.live[2]))
        .and_then(|c| c.with_live_faces(&lists.live[3]))
        .unwrap()
}

#[test]
fn boundary_components_in_columns_have_the_verdict_of_their_table() {
    let mut table = nested();
    // A vacant slot of each kind, which is skipped.
    table.vertices.push(None);
    table.half_edges.push(None);
    table.boundaries.push(None);
    table.faces.push(None);
    let expectation = Preset::Arrangement2.expectation();
    assert!(validate(&table, &expectation, Collect::All).is_valid());
    let (mut broken, parts) = (BTreeSet::new(), table.parts);
    for_each_corruption(&mut table, parts, |changed, _, _| {
        let (records, lists) = (records(changed), lists(changed));
        let columns = with_lists(&records, &lists);
        assert_eq!(columns.parts(), parts);
        let of_table = validate(changed, &expectation, Collect::All);
        let of_columns = validate(&columns, &expectation, Collect::All);
        assert_eq!(Some(&of_columns), columns.validate(expectation, Collect::All).as_ref());
        // A dangling link may be another number, but the broken rules are the same.
        assert_eq!(of_table.broken_rules().collect::<Vec<_>>(), of_columns.broken_rules().collect::<Vec<_>>());
        broken.extend(of_columns.broken_rules().next());
    });
    assert!(broken.len() >= 9, "{broken:?}");
}

/// A wrapper that lends no columns of its structure.
struct Asked<'a>(Columns<'a, u32>);

impl View for Asked<'_> {
    twinedge::delegate_view!(|this| &this.0);
}

/// Converts a column to unsigned integers.
fn unsigned(column: &[i64]) -> Vec<u32> {
    column
        .iter()
        .map(|link| if *link == -1 { u32::MAX } else { u32::try_from(*link).unwrap_or(u32::MAX - 1) })
        .collect()
}

#[test]
fn columns_that_are_lent_have_the_verdict_of_columns_that_are_asked() {
    for (mut table, expectation) in [(pillow(), SURFACE), (nested(), Preset::Arrangement2.expectation())] {
        let parts = table.parts;
        let [mut lent, mut broken] = [0; 2];
        for_each_corruption(&mut table, parts, |changed, _, _| {
            let slices = slices(&columns(&records(changed)), changed);
            let [origin, twin, next, prev, face, leaving, outer] = slices.each_ref().map(|column| unsigned(column));
            let lists = lists(changed);
            let of = [&lists.boundary, &lists.isolated, &lists.face, &lists.half_edge, &lists.vertex, &lists.outer];
            let [boundary, isolated, of_boundary, half_edge, vertex, outer_boundary] =
                of.map(|column| unsigned(column));
            let [inner_first, inner] = [&lists.inner_first, &lists.inner].map(|column| unsigned(column));
            let boundaries = Boundaries {
                boundary: Column::new(&boundary),
                isolated: Some(Column::new(&isolated)),
                face: Column::new(&of_boundary),
                half_edge: Column::new(&half_edge),
                vertex: Some(Column::new(&vertex)),
                outer: Column::new(&outer_boundary),
                inner_first: Column::new(&inner_first),
                inner: Column::new(&inner),
            };
            let numbers = Columns::new(leaving.len(), Column::new(&origin), Column::new(&twin), Column::new(&next))
                .and_then(|c| c.with_prev(Column::new(&prev)))
                .and_then(|c| c.with_leaving(Column::new(&leaving)));
            let numbers = if parts.has(Part::BoundaryComponents) {
                numbers.and_then(|c| c.with_boundaries(lists.outer.len(), boundaries))
            } else {
                numbers
                    .and_then(|c| c.with_faces(outer.len(), Column::new(&face)))
                    .and_then(|c| c.with_outer_half_edge(Column::new(&outer)))
            };
            let [v, h, b, f] = &lists.live;
            let numbers = numbers.and_then(|c| c.with_live_vertices(v)).and_then(|c| c.with_live_half_edges(h));
            let numbers = numbers.and_then(|c| c.with_live_boundaries(b)).and_then(|c| c.with_live_faces(f)).unwrap();

            let paired = (0..changed.half_edge_slots()).all(|h| numbers.twin(h) == Some(h ^ 1));
            assert_eq!(numbers.half_edge_columns().is_some(), paired && !h.contains(&false));
            lent += usize::from(numbers.half_edge_columns().is_some());
            let report = numbers.validate(expectation, Collect::All).unwrap();
            assert_eq!(report, validate(&Asked(numbers), &expectation, Collect::All));
            broken += usize::from(!report.is_valid());
        });
        assert!(lent > 100 && broken > 100, "{lent} {broken}");
    }
}

#[test]
fn lists_of_faces_may_start_anywhere() {
    let table = nested();
    let (records, mut lists) = (records(&table), lists(&table));
    let expectation = Preset::Arrangement2.expectation();
    let broken = |lists: &Lists| {
        let columns = with_lists(&records, lists);
        let report = validate(&columns, &expectation, Collect::All);
        assert_eq!(Some(&report), columns.validate(expectation, Collect::All).as_ref());
        report.broken_rules().collect::<Vec<_>>()
    };
    assert_eq!((&lists.inner_first[..], broken(&lists)), (&[0, 1, 3, 3][..], vec![]));
    for (place, value, first) in [
        (0, -1, Rule::F2),
        (0, 1, Rule::F2),
        (1, 0, Rule::F2),
        (3, 4, Rule::R1),
        (3, -2, Rule::R1),
        (0, -2, Rule::F2),
        (3, i64::MAX, Rule::R1),
    ] {
        let right = std::mem::replace(&mut lists.inner_first[place], value);
        assert_eq!(broken(&lists).first(), Some(&first), "{place} {value}");
        lists.inner_first[place] = right;
    }
}

#[test]
fn every_type_of_integer_holds_the_same_links() {
    let origin = [0_i32, 1, 1, 2, 2, 0, -1, -2, 7];
    let links: Vec<_> = origin.iter().map(Cell::link).collect();
    let [a, b, c, d] = [
        origin.map(i64::from).map(AtomicI64::new).iter().map(Cell::link).collect::<Vec<_>>(),
        origin.map(AtomicI32::new).iter().map(Cell::link).collect(),
        origin.map(|i| AtomicU32::new(i.cast_unsigned())).iter().map(Cell::link).collect(),
        origin.map(|i| AtomicU64::new(i64::from(i).cast_unsigned())).iter().map(Cell::link).collect(),
    ];
    assert_eq!((&a, &b), (&links, &links));
    // Without a sign, −2 is a large number, which also dangles.
    for unsigned in [c, d] {
        assert_eq!((&unsigned[..7], unsigned[8]), (&links[..7], links[8]));
        assert!(unsigned[7] > Some(1 << 31));
    }
    assert_eq!(links[6..], [None, Some(usize::MAX), Some(7)]);
}

#[test]
fn a_column_lies_in_its_slice() {
    let cells = [3_u32, 5, 7, 9];
    let reversed = Column::strided(&cells, 3, -1, 4).unwrap();
    assert_eq!([0, 1, 2, 3, 4].map(|i| reversed.link(i)), [Some(9), Some(7), Some(5), Some(3), None]);
    assert_eq!((reversed.slots(), reversed.link(usize::MAX), reversed.is_empty()), (10, None, false));
    let constant = Column::strided(&cells, 2, 0, 1000).unwrap();
    assert_eq!((constant.link(999), constant.link(1000)), (Some(7), None));
    let none = Column::strided(&cells, 99, isize::MIN, 0).unwrap();
    assert_eq!((none.link(0), none.slots(), none.is_empty()), (None, 0, true));
    for (first, stride, len) in
        [(0, 1, 5), (4, 1, 1), (1, 2, 3), (2, -1, 4), (0, -1, 2), (3, isize::MAX, 3), (3, isize::MIN, 3)]
    {
        let error = Column::strided(&cells, first, stride, len).unwrap_err();
        assert_eq!(error, ColumnsError::OutOfSlice { first, stride, len, cells: 4 });
        assert!(error.to_string().ends_with("not in a slice of 4"));
    }
}

#[test]
fn every_column_has_the_length_of_its_records() {
    let (long, short) = ([0_i32; 4], [0_i32; 3]);
    let (long, short) = (Column::new(&long), Column::new(&short));
    let right = || Columns::new(3, long, long, long).unwrap();
    assert!(right().with_leaving(short).is_ok());
    for (error, column, found, expected) in [
        (Columns::new(3, short, long, long), "origin", 3, 4),
        (Columns::new(3, long, short, long), "twin", 3, 4),
        (Columns::paired(3, long, short), "origin", 4, 3),
        (right().with_prev(short), "prev", 3, 4),
        (right().with_faces(2, short), "face", 3, 4),
        (right().with_leaving(long), "leaving", 4, 3),
        (right().with_outer_half_edge(short), "outer_half_edge", 3, 0),
    ] {
        assert_eq!(error.unwrap_err(), ColumnsError::Length { column, found, expected });
    }
    // Four half-edges, three vertices and boundary components, two faces.
    let fits = Boundaries {
        boundary: long,
        isolated: Some(short),
        face: short,
        half_edge: short,
        vertex: Some(short),
        outer: Column::strided(&[0_i32], 0, 0, 2).unwrap(),
        inner_first: short,
        inner: long,
    };
    assert!(right().with_boundaries(2, fits).is_ok());
    for (boundaries, column, found, expected) in [
        (Boundaries { boundary: short, ..fits }, "boundary", 3, 4),
        (Boundaries { isolated: Some(long), ..fits }, "isolated", 4, 3),
        (Boundaries { face: long, ..fits }, "boundary_half_edge", 3, 4),
        (Boundaries { half_edge: long, ..fits }, "boundary_half_edge", 4, 3),
        (Boundaries { vertex: Some(long), ..fits }, "boundary_vertex", 4, 3),
        (Boundaries { outer: short, ..fits }, "outer", 3, 2),
        (Boundaries { inner_first: long, ..fits }, "inner_first", 4, 3),
    ] {
        let error = right().with_boundaries(2, boundaries).unwrap_err();
        assert_eq!(error, ColumnsError::Length { column, found, expected });
    }
    let live = [true; 5];
    for (error, column, expected) in [
        (right().with_live_vertices(&live), "live_vertices", 3),
        (right().with_live_half_edges(&live), "live_half_edges", 4),
        (right().with_live_boundaries(&live), "live_boundaries", 0),
        (right().with_live_faces(&live), "live_faces", 0),
    ] {
        assert_eq!(error.unwrap_err(), ColumnsError::Length { column, found: 5, expected });
    }
}

#[test]
fn targets_pairs_and_labels_are_completed_by_the_adapters() {
    // The pillow by its targets, without twins and without lists of the faces.
    let (target, next, face) = ([1_u32, 0, 2, 1, 0, 2], [2_u32, 5, 4, 1, 0, 3], [0_u32, 1, 0, 1, 0, 1]);
    let judge = |target: &[u32], face: &[u32]| {
        let columns = Columns::paired(3, Column::new(target), Column::new(&next)).unwrap().by_target();
        let columns = columns.with_faces(2, Column::new(face)).unwrap();
        let targets = Targets::of(columns, |h| Column::new(target).link(h)).unwrap();
        let report = validate(&FaceLabels::one_cycle(targets).unwrap(), &SURFACE, Collect::All);
        assert_eq!(Some(&report), columns.validate(SURFACE, Collect::All).as_ref());
        report.broken_rules().next()
    };
    assert_eq!(judge(&target, &face), None);
    assert_eq!(judge(&target, &[0, 1, 0, 1, 1, 1]), Some(Rule::B1));
    assert_eq!(judge(&[1, 0, 2, 1, 0, 9], &face), Some(Rule::R1));
}

#[test]
fn presets_have_names_sources_and_claims() {
    let names: BTreeSet<_> = Preset::ALL.iter().map(|preset| preset.name()).collect();
    assert_eq!(names.len(), 6);
    for preset in Preset::ALL {
        assert_eq!(Preset::from_name(preset.name()), Some(*preset));
        assert!(preset.source().contains(", "));
    }
    assert_eq!(Preset::from_name("cgal"), None);
    let asks = |preset: Preset| {
        Rule::ALL.iter().copied().filter(|r| r.is_optional() && preset.expectation().asks_for(*r)).collect::<Vec<_>>()
    };
    assert_eq!(
        Preset::ALL.iter().map(|p| asks(*p)).collect::<Vec<_>>(),
        [vec![], vec![Rule::M8], vec![], vec![Rule::M3], vec![Rule::M2], vec![Rule::M2]]
    );
    // The nested triangles have holes: they fit an arrangement or a graph in the plane, and no mesh.
    let table = nested();
    for preset in Preset::ALL {
        assert_eq!(
            validate(&table, &preset.expectation(), Collect::First).is_valid(),
            *preset == Preset::Arrangement2 || *preset == Preset::Networkx,
            "{preset:?}"
        );
    }
}
