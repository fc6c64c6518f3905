//! Columns of a torus of 1,000,000 half-edges against the same links in a view of Rust's own vectors: whole slices,
//! fields of an array of structs, a vacant slot, records of boundary components; and the slower forms.
//!
//! Target: 1.2 times the view. Run with `cargo bench -p twinedge-benches --bench columns`.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use twinedge::validate::{Collect, Expectation, Link, Part, Parts, Start, View, validate};
use twinedge::view_answers;
use twinedge_columns::{Boundaries, Column, Columns};

const N: u32 = 500;

/// `N × N` squares. Half-edges `4 v` and `4 v + 1` are the edge from vertex `v` to the right, `4 v + 2` and `4 v + 3`
/// the edge upwards.
struct Torus {
    /// Origin, twin, next, prev and face of each half-edge.
    records: Vec<[u32; 5]>,
    /// The links of `records`, field by field.
    fields: [Vec<u32>; 5],
    /// The half-edge that vertex `v` keeps, and the half-edge that face `v` keeps.
    kept: Vec<u32>,
    faces: Vec<u32>,
    live: Vec<bool>,
}

impl Torus {
    fn new() -> Self {
        let vertex = |x: u32, y: u32| (y % N) * N + x % N;
        let mut records = vec![[0; 5]; (4 * N * N) as usize];
        for (y, x) in (0..N).flat_map(|y| (0..N).map(move |x| (y, x))) {
            let [here, right, above] = [vertex(x, y), vertex(x + 1, y), vertex(x, y + 1)];
            // The sides of the square above and to the right, counter-clockwise.
            let sides = [4 * here, 4 * right + 2, 4 * above + 1, 4 * here + 3];
            let origins = [here, right, vertex(x + 1, y + 1), above];
            for i in 0..4 {
                let (next, prev) = (sides[(i + 1) % 4], sides[(i + 3) % 4]);
                records[sides[i] as usize] = [origins[i], sides[i] ^ 1, next, prev, here];
            }
        }
        // A vacant slot.
        let field = |i: usize| records.iter().map(|record| record[i]).chain([u32::MAX]).collect();
        let mut live = vec![true; records.len() + 1];
        live[records.len()] = false;
        let kept = (0..N * N).map(|v| 4 * v).collect();
        Self { fields: [0, 1, 2, 3, 4].map(field), records, kept, faces: (0..N * N).collect(), live }
    }

    /// The first half-edges of a field.
    fn cells(&self, field: usize, len: usize) -> &[u32] {
        &self.fields[field][..len]
    }

    fn columns<'a>(&'a self, column: impl Fn(usize) -> Column<'a, u32>) -> Columns<'a, u32> {
        let kept = Column::new(&self.kept);
        let columns = Columns::new(self.kept.len(), column(0), column(1), column(2)).expect("lengths");
        let columns = columns.with_prev(column(3)).and_then(|columns| columns.with_leaving(kept)).expect("lengths");
        let columns = columns.with_faces(self.kept.len(), column(4)).expect("lengths");
        columns.with_outer_half_edge(kept).expect("lengths")
    }
}

fn link(value: u32) -> Link {
    (value != u32::MAX).then_some(value as usize)
}

const EXPECTED: Expectation = Expectation::surface().genus(1);
/// All parts except records of boundary components.
const MESH: Parts = Parts::NONE.with(Part::Prev).with(Part::Leaving).with(Part::Faces);

struct Slices<'a>(&'a Torus, [&'a [u32]; 5]);

impl View for Slices<'_> {
    view_answers! { |torus|
        parts => MESH,
        vertex_slots => torus.0.kept.len(),
        half_edge_slots => torus.1[2].len(),
        face_slots => torus.0.kept.len(),
        origin(h) => link(torus.1[0][h]),
        twin(h) => link(torus.1[1][h]),
        next(h) => link(torus.1[2][h]),
        prev(h) => link(torus.1[3][h]),
        face(h) => link(torus.1[4][h]),
        leaving(v) => link(torus.0.kept[v]),
        outer_half_edge(f) => link(torus.0.kept[f]),
    }
}

struct Vacant<'a>(Slices<'a>);

impl View for Vacant<'_> {
    twinedge::delegate_view!(|this| &this.0; except is_half_edge);
    fn is_half_edge(&self, half_edge: usize) -> bool {
        self.0.0.live.get(half_edge).is_some_and(|live| *live)
    }
}

struct Records<'a>(&'a Torus);

impl View for Records<'_> {
    view_answers! { |torus|
        parts => MESH,
        vertex_slots => torus.0.kept.len(),
        half_edge_slots => torus.0.records.len(),
        face_slots => torus.0.kept.len(),
        origin(h) => link(torus.0.records[h][0]),
        twin(h) => link(torus.0.records[h][1]),
        next(h) => link(torus.0.records[h][2]),
        prev(h) => link(torus.0.records[h][3]),
        face(h) => link(torus.0.records[h][4]),
        leaving(v) => link(torus.0.kept[v]),
        outer_half_edge(f) => link(torus.0.kept[f]),
    }
}

/// Each face has one boundary component, of its own number.
struct Lists<'a>(Slices<'a>);

impl View for Lists<'_> {
    twinedge::delegate_view!(|this| &this.0; except parts, boundary_slots, is_boundary, boundary, boundary_face, boundary_start, outer);
    fn parts(&self) -> Parts {
        Parts::ALL.without(Part::Places)
    }
    fn boundary_slots(&self) -> usize {
        self.0.0.faces.len()
    }
    fn boundary(&self, half_edge: usize) -> Link {
        self.0.face(half_edge)
    }
    fn boundary_face(&self, boundary: usize) -> Link {
        link(self.0.0.faces[boundary])
    }
    fn boundary_start(&self, boundary: usize) -> Option<Start> {
        link(self.0.0.kept[boundary]).map(Start::HalfEdge)
    }
    fn outer(&self, face: usize) -> Link {
        link(self.0.0.faces[face])
    }
}

fn columns(c: &mut Criterion) {
    let torus = Torus::new();
    let count = torus.records.len();
    let mut group = c.benchmark_group("columns of 1,000,000 half-edges");
    group.sample_size(10).throughput(Throughput::Elements(count as u64));

    let of_view = |view: &dyn Fn() -> bool| assert!(view());
    let slices = |len| Slices(&torus, [0, 1, 2, 3, 4].map(|field| torus.cells(field, len)));
    let judged = |view: &Columns<'_, u32>| {
        assert!(black_box(view).validate(EXPECTED, Collect::First).is_some_and(|report| report.is_valid()));
    };
    macro_rules! view {
        ($name:literal, $view:expr) => {
            let view = $view;
            let is_valid = || validate(black_box(&view), &EXPECTED, Collect::First).is_valid();
            group.bench_function($name, |b| b.iter(|| of_view(&is_valid)));
        };
    }

    view!("slices: view", slices(count));
    let whole = torus.columns(|field| Column::new(torus.cells(field, count)));
    group.bench_function("slices: columns", |b| b.iter(|| judged(&whole)));
    view!("slices: columns as any view", whole);

    view!("fields of structs: view", Records(&torus));
    let flat = torus.records.as_flattened();
    let strided = torus.columns(|field| Column::strided(flat, field, 5, count).expect("in the slice"));
    group.bench_function("fields of structs: columns", |b| b.iter(|| judged(&strided)));

    view!("a vacant slot: view", Vacant(slices(count + 1)));
    let vacant = torus.columns(|field| Column::new(&torus.fields[field]));
    let vacant = vacant.with_live_half_edges(&torus.live).expect("lengths");
    group.bench_function("a vacant slot: columns", |b| b.iter(|| judged(&vacant)));

    view!("boundary components: view", Lists(slices(count)));
    let (faces, kept, none) = (Column::new(&torus.faces), Column::new(&torus.kept), vec![0; torus.faces.len() + 1]);
    let boundaries = Boundaries {
        boundary: Column::new(torus.cells(4, count)),
        isolated: None,
        face: faces,
        half_edge: kept,
        vertex: None,
        outer: faces,
        inner_first: Column::new(&none),
        inner: Column::new(&[]),
    };
    let listed = whole.with_boundaries(torus.faces.len(), boundaries).expect("lengths");
    group.bench_function("boundary components: columns", |b| b.iter(|| judged(&listed)));
    group.finish();
}

criterion_group!(benches, columns);
criterion_main!(benches);
