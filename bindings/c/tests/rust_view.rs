//! The least processor time of a validation of a torus of 1,000,000 half-edges, through a `View` of Rust's own vectors. `time.c`
//! does the same through columns.

use std::hint::black_box;
use std::process::Command;
use twinedge::validate::{Collect, Expectation, Link, Part, Parts, View, validate};

struct Torus {
    origin: Vec<u32>,
    twin: Vec<u32>,
    next: Vec<u32>,
    prev: Vec<u32>,
    face: Vec<u32>,
    leaving: Vec<u32>,
    kept: Vec<u32>,
}

impl Torus {
    /// `n × n` squares. Half-edges `4 v` and `4 v + 1` are the edge from vertex `v` to the right, `4 v + 2` and
    /// `4 v + 3` the edge upwards.
    fn new(n: u32) -> Self {
        let vertex = |x: u32, y: u32| (y % n) * n + x % n;
        let size = (4 * n * n) as usize;
        let mut torus = Self {
            origin: vec![0; size],
            twin: (0..4 * n * n).map(|h| h ^ 1).collect(),
            next: vec![0; size],
            prev: vec![0; size],
            face: vec![0; size],
            leaving: vec![],
            kept: vec![],
        };
        for y in 0..n {
            for x in 0..n {
                let [here, right, above] = [vertex(x, y), vertex(x + 1, y), vertex(x, y + 1)];
                // The sides of the square above and to the right, counter-clockwise.
                let sides = [4 * here, 4 * right + 2, 4 * above + 1, 4 * here + 3];
                let origins = [here, right, vertex(x + 1, y + 1), above];
                for i in 0..4 {
                    let side = sides[i] as usize;
                    torus.origin[side] = origins[i];
                    torus.next[side] = sides[(i + 1) % 4];
                    torus.prev[side] = sides[(i + 3) % 4];
                    torus.face[side] = here;
                }
                torus.leaving.push(4 * here);
                torus.kept.push(4 * here);
            }
        }
        torus
    }
}

fn link(value: u32) -> Link {
    (value != u32::MAX).then_some(value as usize)
}

impl View for Torus {
    fn parts(&self) -> Parts {
        Parts::NONE.with(Part::Prev).with(Part::Leaving).with(Part::Faces)
    }
    fn vertex_slots(&self) -> usize {
        self.leaving.len()
    }
    fn half_edge_slots(&self) -> usize {
        self.next.len()
    }
    fn face_slots(&self) -> usize {
        self.kept.len()
    }
    fn origin(&self, half_edge: usize) -> Link {
        link(self.origin[half_edge])
    }
    fn twin(&self, half_edge: usize) -> Link {
        link(self.twin[half_edge])
    }
    fn next(&self, half_edge: usize) -> Link {
        link(self.next[half_edge])
    }
    fn prev(&self, half_edge: usize) -> Link {
        link(self.prev[half_edge])
    }
    fn face(&self, half_edge: usize) -> Link {
        link(self.face[half_edge])
    }
    fn leaving(&self, vertex: usize) -> Link {
        link(self.leaving[vertex])
    }
    fn outer_half_edge(&self, face: usize) -> Link {
        link(self.kept[face])
    }
}

/// Arguments: a program that prints milliseconds, `tests/time.c`. Both are measured in turn, and their ratio is
/// printed.
fn main() {
    let torus = Torus::new(500);
    let expectation = Expectation::surface().genus(1);
    let rust = || {
        let (mut least, mut all) = (f64::INFINITY, 0);
        for _ in 0..5 {
            let start = std::time::Instant::now();
            let report = validate(black_box(&torus), &expectation, Collect::All);
            least = least.min(start.elapsed().as_secs_f64() * 1e3);
            assert!(report.is_valid(), "{report}");
            all += report.counts().half_edges;
        }
        assert_eq!(all, 5_000_000);
        least
    };
    let program = std::env::args().nth(1).expect("the program of tests/time.c");
    let columns = || -> f64 {
        let output = Command::new(&program).output().expect("the program runs");
        String::from_utf8_lossy(&output.stdout).trim().parse().expect("milliseconds")
    };
    let least = |times: [f64; 5]| times.into_iter().fold(f64::INFINITY, f64::min);
    let pairs = [(); 5].map(|()| (rust(), columns()));
    let (rust, columns) = (least(pairs.map(|pair| pair.0)), least(pairs.map(|pair| pair.1)));
    println!(
        "1,000,000 half-edges: {rust:.1} ms through a view in Rust, {columns:.1} ms over columns from C, ratio {:.2}",
        columns / rust
    );
}
