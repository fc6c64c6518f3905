//! Changes with a history: the time of operators and edits as changes with undo, of undoing and of redoing them, as
//! multiples of their time without.
//!
//! The four are timed in turn, round after round, and the median of the rounds is printed. Operators at random places:
//! an edge split and joined again, a face split by an edge and merged, an isolated vertex added and removed; on a
//! triangulated grid that fits into the cache and on one that does not. Edits: an edge erased and drawn again.
//!
//! Targets: at most 1.3, and for undoing at most 1. Edits meet them, and so do operators that wait for memory. An
//! operator of 10 to 30 ns in the cache takes about 3 times as long as a change, and twice as long to undo. Run with
//! `cargo bench -p twinedge-benches --bench history`.

mod common;

use std::convert::Infallible;
use std::hint::black_box;
use std::time::Instant;
use twinedge::dcel::{Dcel, FaceKey, HalfEdgeKey, History, Side, Split, VertexKey};
use twinedge_map::PlanarMap;

const ROUNDS: usize = 41;

/// Times the parts of a round in turn. Returns the median of each as a multiple of the first, and the first in nanoseconds.
fn rounds<const N: usize>(calls: usize, mut round: impl FnMut() -> [Instant; N]) -> (f64, Vec<f64>) {
    let mut times: Vec<Vec<f64>> = vec![Vec::new(); N - 1];
    for _ in 0..ROUNDS {
        let instants = round();
        for (i, pair) in instants.windows(2).enumerate() {
            times[i].push((pair[1] - pair[0]).as_nanos() as f64);
        }
    }
    let median = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    let ratios = (1..N - 1).map(|i| median(times[i].iter().zip(&times[0]).map(|(a, b)| a / b).collect()));
    let ratios = ratios.collect();
    (median(times[0].clone()) / calls as f64, ratios)
}

fn print(name: &str, (nanoseconds, ratios): (f64, Vec<f64>)) {
    let [change, undo, redo] = ratios[..] else { unreachable!("there are three") };
    println!("{name:44} {nanoseconds:7.0} ns   change {change:4.2}   undo {undo:4.2}   redo {redo:4.2}");
}

/// A pair of operators; the second undoes the first.
trait Pair {
    type Made: Copy;
    fn make(&self, dcel: &mut Dcel, place: usize) -> Self::Made;
    fn take_back(&self, dcel: &mut Dcel, made: Self::Made);
}

struct SplitEdges(Vec<HalfEdgeKey>);
struct Isolated(Vec<FaceKey>);
struct Diagonals(Vec<[HalfEdgeKey; 2]>);

impl Pair for SplitEdges {
    type Made = HalfEdgeKey;
    fn make(&self, dcel: &mut Dcel, place: usize) -> HalfEdgeKey {
        dcel.split_edge(self.0[place]).expect("it is an edge");
        self.0[place]
    }
    fn take_back(&self, dcel: &mut Dcel, made: HalfEdgeKey) {
        black_box(dcel.join_edges(made).expect("the new vertex has two edges"));
    }
}

impl Pair for Isolated {
    type Made = VertexKey;
    fn make(&self, dcel: &mut Dcel, place: usize) -> VertexKey {
        dcel.add_isolated_vertex(self.0[place]).expect("it is a face").vertex
    }
    fn take_back(&self, dcel: &mut Dcel, made: VertexKey) {
        dcel.remove_isolated_vertex(made).expect("it is isolated");
    }
}

impl Pair for Diagonals {
    type Made = HalfEdgeKey;
    fn make(&self, dcel: &mut Dcel, place: usize) -> HalfEdgeKey {
        let [from, to] = self.0[place];
        dcel.connect(from, to, Split { new_face: Side::Left, inner: &[] }).expect("one face").half_edge
    }
    fn take_back(&self, dcel: &mut Dcel, made: HalfEdgeKey) {
        dcel.remove_edge(made).expect("just made");
    }
}

fn operators<P: Pair>(name: &str, dcel: &Dcel, pair: &P, places: usize) {
    let mut plain = dcel.clone();
    let mut history = History::new(dcel.clone());
    let mut round = || {
        let start = Instant::now();
        for place in 0..places {
            let made = pair.make(&mut plain, place);
            pair.take_back(&mut plain, made);
        }
        let done = Instant::now();
        for place in 0..places {
            let made =
                history.change("make", |dcel| Ok::<_, Infallible>(pair.make(dcel, place))).expect("it cannot fail");
            history
                .change("take back", |dcel| {
                    pair.take_back(dcel, made);
                    Ok::<_, Infallible>(())
                })
                .expect("it cannot fail");
        }
        let changed = Instant::now();
        while history.undo() {}
        let undone = Instant::now();
        while history.redo() {}
        let redone = Instant::now();
        // The next round uses the memory again.
        history.forget(0);
        [start, done, changed, undone, redone]
    };
    round();
    print(name, rounds(2 * places, round));
}

/// Returns `count` elements of `all`, far apart.
fn spread<T: Copy>(all: &[T], count: usize) -> Vec<T> {
    (0..count).map(|i: usize| all[i.wrapping_mul(0x9E37_79B9_7F4A_7C15) % all.len()]).collect()
}

fn edits() {
    let map = common::triangulated_grid(183);
    let walls: Vec<(HalfEdgeKey, [VertexKey; 2])> =
        map.dcel().edges().map(|h| (h.key(), [h.origin().key(), h.target().key()])).collect();
    let mut walls = spread(&walls, 500);
    walls.sort_unstable();
    walls.dedup();
    let redraw =
        |map: &mut PlanarMap, [from, to]: [VertexKey; 2]| map.insert_segment(from, to).expect("it was there").way[0];
    let mut plain = map.clone();
    let mut history = History::new(map);
    let original = walls.clone();
    let round = || {
        let start = Instant::now();
        for (h, ends) in &mut walls {
            plain.remove_edge(*h).expect("it is an edge");
            *h = redraw(&mut plain, *ends);
        }
        let done = Instant::now();
        for (h, ends) in &original {
            history.change("erase", |map| map.remove_edge(*h)).expect("it is an edge");
            let _ = history.change("draw", |map| Ok::<_, Infallible>(redraw(map, *ends))).expect("it cannot fail");
        }
        let changed = Instant::now();
        while history.undo() {}
        let undone = Instant::now();
        while history.redo() {}
        let redone = Instant::now();
        // The next round uses the memory again.
        while history.undo() {}
        [start, done, changed, undone, redone]
    };
    print("an edge erased and drawn again", rounds(1000, round));
}

fn main() {
    for side in [19, 578] {
        let dcel = common::triangulated_grid(side).dcel().clone();
        let edges: Vec<HalfEdgeKey> = dcel.edges().map(|h| h.key()).collect();
        let faces: Vec<FaceKey> = dcel.faces().map(|f| f.key()).collect();
        let places = 1000.min(edges.len());
        let name = |what: &str| format!("{what}, {} edges", edges.len());
        operators(&name("an edge split and joined"), &dcel, &SplitEdges(spread(&edges, places)), places);
        operators(&name("a vertex added and removed"), &dcel, &Isolated(spread(&faces, places)), places);
        let corners: Vec<[HalfEdgeKey; 2]> =
            dcel.faces().filter_map(|face| face.outer_half_edge()).map(|h| [h.key(), h.next().key()]).collect();
        operators(&name("a face split and merged"), &dcel, &Diagonals(spread(&corners, places)), places);
    }
    edits();
}
