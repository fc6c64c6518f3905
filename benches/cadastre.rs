//! A synthetic cadastre of any size: parcels that share noisy borders, with planted faults of each kind C1 … C7, as newline-delimited GeoJSON.
//!
//! ```text
//! cargo run --release -p twinedge-benches --bin cadastre -- 1000000 12 10 > cadastre.geojsonl
//! ```
//!
//! The arguments are the number of parcels, the number of vertices of each parcel (a multiple of 4, from 12 on), and
//! the number of times that each fault is planted. Prints the number of vertices and the expected findings of an audit
//! to standard error. After these, `plane` plants no faults by which borders cross or lack vertices (C7, G4), and
//! `shifted` moves everything by half a parcel, for a second layer over the first. Coordinates are small multiples of a
//! power of two, so that midpoints lie on their edges exactly.

use std::io::{self, BufWriter, Write};

/// The width of a parcel in units.
const PITCH: i64 = 1 << 16;

/// A unit in coordinates.
const UNIT: f64 = 1.0 / 1024.0;

type Place = [i64; 2];

#[derive(Clone, Copy, PartialEq, Eq)]
enum Fault {
    Overlap,
    Gap,
    Sliver,
    Duplicate,
    Invalid,
    Mismatch,
    Crossing,
}

/// The faults of parcels of the block; near misses are next to it.
const OF_PARCELS: [Fault; 7] =
    [Fault::Overlap, Fault::Gap, Fault::Sliver, Fault::Duplicate, Fault::Invalid, Fault::Mismatch, Fault::Crossing];

/// Returns a pseudorandom number, by splitmix64.
fn mixed(of: [i64; 4]) -> u64 {
    of.into_iter().fold(0, |seed, part| {
        let mut z = (seed ^ part.cast_unsigned()).wrapping_add(0x9e37_79b9_7f4a_7c15);
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    })
}

/// The noise of a place, an even number of units up to `most`.
fn noise(of: [i64; 4], most: i64) -> Place {
    let number = mixed(of);
    let part = |bits: u64| (bits.cast_signed() & 0xffff) * most / 0x10000 / 2 * 2 - most / 2 / 2 * 2;
    [part(number), part(number >> 32)]
}

fn corner(i: i64, j: i64) -> Place {
    let [x, y] = noise([0, i, j, 0], PITCH / 8);
    [i * PITCH + x, j * PITCH + y]
}

/// Returns the midpoint of two positions.
fn middle(p: Place, q: Place) -> Place {
    [0, 1].map(|axis| i64::midpoint(p[axis], q[axis]))
}

/// Two squares left of the block with a slit between them.
fn near_miss(number: i64) -> [Vec<Place>; 2] {
    let square = |x: i64| {
        let y = 2 * number * PITCH;
        vec![[x, y], [x + PITCH, y], [x + PITCH, y + PITCH], [x, y + PITCH]]
    };
    [square(-5 * PITCH), square(-4 * PITCH + 64)]
}

struct Cadastre {
    /// The number of edges of each side of a parcel.
    edges: i64,
}

impl Cadastre {
    /// The border from a corner to the next one, upwards or to the right, without its end.
    fn border(&self, [i, j]: Place, is_upright: bool) -> Vec<Place> {
        let (a, b) = (corner(i, j), if is_upright { corner(i, j + 1) } else { corner(i + 1, j) });
        let between = |t: i64| {
            let [x, y] = noise([1 + i64::from(is_upright), i, j, t], PITCH / self.edges / 4);
            [0, 1].map(|axis| (a[axis] + (b[axis] - a[axis]) * t / self.edges + [x, y][axis]) / 2 * 2)
        };
        [a].into_iter().chain((1..self.edges).map(between)).collect()
    }

    /// The four sides of a parcel, counter-clockwise.
    fn sides(&self, [i, j]: Place) -> [Vec<Place>; 4] {
        let back = |mut border: Vec<Place>, end: Place| {
            border.push(end);
            border.reverse();
            border.pop();
            border
        };
        [
            self.border([i, j], false),
            self.border([i + 1, j], true),
            back(self.border([i, j + 1], false), corner(i + 1, j + 1)),
            back(self.border([i, j], true), corner(i, j + 1)),
        ]
    }

    /// Returns the rings of a parcel with a fault on its right side, and of any parts planted next to it.
    fn rings(&self, at: Place, fault: Option<Fault>) -> Vec<Vec<Place>> {
        let sides = self.sides(at);
        let mut ring = sides.concat();
        let first = sides[0].len();
        let off = PITCH / self.edges / 8 / 2 * 2;
        let mut more = Vec::new();
        match fault {
            Some(Fault::Overlap) => ring[first + 1][0] += off,
            Some(Fault::Gap) => ring[first + 1][0] -= off,
            Some(Fault::Crossing) => {
                ring[first + 1][0] += off;
                ring[first + 2][0] -= off;
            }
            Some(Fault::Sliver) => {
                let [p, q] = [ring[first], ring[first + 1]];
                let [x, y] = middle(p, q);
                let apex = [x - 64, y];
                ring.insert(first + 1, apex);
                more.push(vec![p, q, apex]);
            }
            Some(Fault::Duplicate) => more.push(ring.clone()),
            Some(Fault::Invalid) => {
                let (p, [i, j]) = (ring[1], at);
                ring.splice(2..2, [[i * PITCH + PITCH / 2, j * PITCH + PITCH / 2], p]);
            }
            Some(Fault::Mismatch) => {
                let [p, q] = [ring[first], ring[first + 1]];
                ring.insert(first + 1, middle(p, q));
            }
            None => {}
        }
        more.insert(0, ring);
        more
    }
}

fn main() -> io::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize, default: i64| arguments.get(i).and_then(|text| text.parse().ok()).unwrap_or(default);
    let (parcels, vertices, times) = (number(0, 10_000), number(1, 12), number(2, 10));
    let has = |word: &str| arguments.iter().skip(3).any(|other| other == word);
    let is_plane = has("plane");
    let shift = if has("shifted") { PITCH / 2 } else { 0 };
    let columns = (1..=parcels).find(|side| side * side >= parcels).unwrap_or(1);
    let cadastre = Cadastre { edges: (vertices / 4).max(3) };
    let kinds: Vec<Fault> = OF_PARCELS
        .into_iter()
        .filter(|fault| !is_plane || !matches!(fault, Fault::Mismatch | Fault::Crossing))
        .collect();
    // Every third parcel of every third row may have a fault, so that none meets another.
    let (across, rows) = (columns / 3, parcels / columns / 3);
    let (places, wanted) = (across * rows, i64::try_from(kinds.len()).map_or(0, |kinds| kinds * times));
    if places < wanted {
        return Err(io::Error::other("there are too few parcels for so many faults"));
    }
    let fault_at = |i: i64, j: i64| {
        if wanted == 0 || i % 3 != 1 || j % 3 != 1 || i / 3 >= across || j / 3 >= rows {
            return None;
        }
        let (place, every) = (j / 3 * across + i / 3, places / wanted);
        let planted = place / every;
        (place % every == 0 && planted < wanted).then(|| kinds[planted.unsigned_abs() as usize % kinds.len()])
    };
    let mut out = BufWriter::new(io::stdout().lock());
    let (mut id, mut points) = (0_u64, 0);
    let mut write = |ring: &[Place]| -> io::Result<()> {
        write!(
            out,
            r#"{{"type":"Feature","id":"{id}","properties":null,"geometry":{{"type":"Polygon","coordinates":[["#
        )?;
        for [x, y] in ring {
            write!(out, "[{},{}],", (x + shift) as f64 * UNIT, (y + shift) as f64 * UNIT)?;
        }
        let [x, y] = ring[0];
        writeln!(out, "[{},{}]]]}}}}", (x + shift) as f64 * UNIT, (y + shift) as f64 * UNIT)?;
        id += 1;
        points += ring.len();
        Ok(())
    };
    for parcel in 0..parcels {
        let (i, j) = (parcel % columns, parcel / columns);
        for ring in cadastre.rings([i, j], fault_at(i, j)) {
            write(&ring)?;
        }
    }
    for number in 0..times {
        for ring in near_miss(number) {
            write(&ring)?;
        }
    }
    out.flush()?;
    let crossing = if is_plane { 0 } else { times };
    eprintln!(
        r#"{{"features": {id}, "vertices": {points}, "overlaps": {}, "gaps": {}, "near_misses": {times}, "slivers": {times}, "duplicates": {times}, "ogc_invalid": {times}, "mismatches": {crossing}, "clashes": {}}}"#,
        times + crossing,
        times + crossing,
        2 * crossing
    );
    Ok(())
}
