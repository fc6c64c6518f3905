//! The structure shown on the page, packed.
//!
//! Edges are joined to chains at vertices where nothing else ends. A chain has two sides, numbered `2 · c` and `2 · c + 1`. Each side has the face to
//! its left and the side that follows its end by `next`, as far as the structure has them. The structure may be invalid: a half-edge whose twin does
//! not name it back is a chain with one side.
//!
//! ```text
//!   stream   = chain* sides* face* isolated*          all numbers as LEB128; s(n) is zigzag, Δ from the number before it
//!   chain    = one-sided? points stop* s(Δ half-edge) for each line between two points
//!   stop     = 0 s(Δx) s(Δy) for a bend | 1 + 2 s(Δ index) for a vertex that came before | 2 + 2 s(Δ index) s(Δx) s(Δy)
//!   sides    = next face, for both sides of each chain
//!   next     = 0 for none | 1 + s(side - own side)        face = 0 for none | 1 + its place below
//!   face     = s(Δ index) features s(Δ feature)*
//!   isolated = stop
//! ```
//!
//! Coordinates are rounded to a grid of 2^40 cells across the longer side of the map.

use crate::trace::{finite, target};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde::{Serialize, Serializer};
use twinedge_diagnosis::Position;
use twinedge_map::Embedding;

/// The cells of the grid across the map, as a power of two.
const CELLS: i32 = 40;

/// The maximal number of edges of a structure that is shown as a whole.
const MOST_EDGES: usize = 2_000_000;

#[derive(Debug, Default, Serialize)]
pub(crate) struct Map {
    origin: Position,
    step: f64,
    chains: usize,
    points: usize,
    /// All indices of vertices are less than this.
    vertex_slots: usize,
    faces: usize,
    isolated: usize,
    /// The number of shown edges, and of all edges.
    pub(crate) edges: [usize; 2],
    placeless: usize,
    names: Names,
    /// Another structure whose faces are filled instead.
    pub(crate) areas: Option<Box<Self>>,
    #[serde(serialize_with = "text")]
    stream: Vec<u8>,
}

fn text<S: Serializer>(bytes: &[u8], to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&STANDARD.encode(bytes))
}

#[derive(Debug, Default, Serialize)]
pub(crate) struct Picture {
    pub(crate) map: Map,
    /// The features of the map: name, id, and a colour that differs from the neighbours' colours.
    pub(crate) features: Vec<(Option<String>, Option<String>, usize)>,
}

#[derive(Debug, Default, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Names {
    /// Indices; twins are neighbours.
    #[default]
    Indices,
    /// Ids, with the sign of the side for half-edges; twins are neighbours.
    Ids { vertices: Vec<String>, edges: Vec<String>, faces: Vec<String> },
    /// Separate names. `twins` has the twin of each half-edge, if the twins name each other.
    Own { vertices: Vec<String>, half_edges: Vec<String>, faces: Vec<String>, twins: Vec<Option<usize>> },
}

/// A rectangle, as its least and greatest coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Window {
    low: Position,
    high: Position,
}

impl Window {
    /// Returns the window around points, with their extent as a margin on each side.
    pub(crate) fn around<'a>(points: impl IntoIterator<Item = &'a Position>) -> Option<Self> {
        let all = Self::tight(points)?;
        let margin = [0, 1].map(|i| all.high[i] - all.low[i]);
        let margin = margin[0].max(margin[1]);
        Some(Self { low: all.low.map(|x| x - margin), high: all.high.map(|x| x + margin) })
    }

    fn tight<'a>(points: impl IntoIterator<Item = &'a Position>) -> Option<Self> {
        points.into_iter().fold(None, |found: Option<Self>, p| {
            let Self { low, high } = found.unwrap_or(Self { low: *p, high: *p });
            Some(Self { low: [low[0].min(p[0]), low[1].min(p[1])], high: [high[0].max(p[0]), high[1].max(p[1])] })
        })
    }

    fn meets(&self, other: &Self) -> bool {
        [0, 1].iter().all(|i| self.low[*i] <= other.high[*i] && other.low[*i] <= self.high[*i])
    }
}

/// The features, names and windows that accompany the packed structure.
pub(crate) struct Beside<'a> {
    pub(crate) features: &'a dyn Fn(usize) -> Vec<usize>,
    pub(crate) names: Names,
    /// The shown part of a structure too large for a page.
    pub(crate) windows: &'a [Window],
}

/// No half-edge, and no side.
const NONE: u32 = u32::MAX;

struct Stop {
    at: Position,
    vertex: Option<usize>,
}

struct Chain {
    ends: [usize; 2],
    is_one_sided: bool,
    stops: Vec<Stop>,
    /// The half-edge of each line between two stops.
    half_edges: Vec<usize>,
}

struct Links {
    /// The twin, if the twins name each other.
    mate: Vec<u32>,
    /// The half-edge that continues a chain.
    follow: Vec<u32>,
    is_continued: Vec<bool>,
}

impl Links {
    fn of<E: Embedding + ?Sized>(structure: &E) -> Self {
        let slots = structure.half_edge_slots();
        let live = |h: &usize| *h < slots && structure.is_half_edge(*h);
        let all = || (0..slots).filter(live);
        let mut mate = vec![NONE; slots];
        let mut named = vec![0_u8; slots];
        for h in all() {
            let twin = structure.twin(h).filter(live).filter(|twin| *twin != h && structure.twin(*twin) == Some(h));
            mate[h] = twin.map_or(NONE, |twin| twin as u32);
            if let Some(next) = structure.next(h).filter(live) {
                named[next] = named[next].saturating_add(1);
            }
        }
        let follows = |h: usize| {
            let next = structure.next(h).filter(live).filter(|next| named[*next] == 1)?;
            let back = Some(mate[h]).filter(|back| *back != NONE).map(|back| back as usize)?;
            let from = Some(mate[next]).filter(|from| *from != NONE).map(|from| from as usize)?;
            let is_through = next != back && named[back] == 1 && structure.next(from) == Some(back);
            (is_through && structure.origin(next) == structure.origin(back)).then_some(next)
        };
        let mut follow = vec![NONE; slots];
        let mut is_continued = vec![false; slots];
        for h in all() {
            if let Some(next) = follows(h) {
                follow[h] = next as u32;
                is_continued[next] = true;
            }
        }
        Self { mate, follow, is_continued }
    }

    fn mate(&self, h: usize) -> Option<usize> {
        Some(self.mate[h]).filter(|mate| *mate != NONE).map(|mate| mate as usize)
    }
}

/// Returns the chains of a structure, and the number of half-edges without a place.
fn chains<E: Embedding + ?Sized>(structure: &E, links: &Links) -> (Vec<Chain>, usize) {
    let slots = structure.half_edge_slots();
    let mut seen = vec![false; slots];
    let mut found = Vec::new();
    let mut placeless = 0;
    let live = || (0..slots).filter(|h| structure.is_half_edge(*h));
    // Open chains come first; the rest are closed.
    for start in live().filter(|h| !links.is_continued[*h]).chain(live()) {
        if seen[start] {
            continue;
        }
        let mut chain = Chain { ends: [start; 2], is_one_sided: false, stops: Vec::new(), half_edges: Vec::new() };
        let mut has_place = true;
        let mut add = |chain: &mut Chain, vertex: Option<usize>| {
            let live = vertex.filter(|v| *v < structure.vertex_slots() && structure.is_vertex(*v));
            match live.and_then(|v| finite(structure.point(v))) {
                Some(at) => chain.stops.push(Stop { at, vertex }),
                None => has_place = false,
            }
        };
        add(&mut chain, structure.origin(start));
        let mut next = Some(start);
        while let Some(h) = next.filter(|h| !seen[*h]) {
            seen[h] = true;
            let mate = links.mate(h);
            if let Some(mate) = mate {
                seen[mate] = true;
            }
            chain.is_one_sided = mate.is_none();
            let bends = (0..structure.bends(h)).filter_map(|i| finite(structure.bend(h, i)));
            chain.stops.extend(bends.map(|at| Stop { at, vertex: None }));
            add(&mut chain, target(structure, h));
            let lines = chain.stops.len().saturating_sub(1);
            chain.half_edges.resize(lines, h);
            chain.ends[1] = h;
            next = Some(links.follow[h]).filter(|next| *next != NONE).map(|next| next as usize);
        }
        if has_place {
            found.push(chain);
        } else {
            placeless += 1;
        }
    }
    (found, placeless)
}

impl Map {
    /// Packs a structure. O(n) for its size n, and O(n · w) for w windows if it is too large.
    pub(crate) fn pack<E: Embedding + ?Sized>(structure: &E, beside: Beside<'_>) -> Self {
        Self::pack_up_to(MOST_EDGES, structure, beside)
    }

    fn pack_up_to<E: Embedding + ?Sized>(most_edges: usize, structure: &E, beside: Beside<'_>) -> Self {
        let links = Links::of(structure);
        let (mut chains, mut placeless) = chains(structure, &links);
        let edges = |chains: &[Chain]| -> usize {
            let of = |chain: &Chain| chain.half_edges.chunk_by(|a, b| a == b).count();
            chains.iter().map(of).sum()
        };
        let all = edges(&chains);
        let box_of = |chain: &Chain| Window::tight(chain.stops.iter().map(|stop| &stop.at));
        let whole = chains.iter().filter_map(box_of).fold(None, |sum: Option<Window>, one| {
            Window::tight(sum.iter().chain([&one]).flat_map(|window| [&window.low, &window.high]))
        });
        if all > most_edges {
            chains
                .retain(|chain| box_of(chain).is_some_and(|of| beside.windows.iter().any(|window| window.meets(&of))));
        }
        let shown = edges(&chains);

        let mut is_origin = vec![false; structure.vertex_slots()];
        let half_edges = (0..structure.half_edge_slots()).filter(|h| structure.is_half_edge(*h));
        for v in half_edges.filter_map(|h| structure.origin(h)) {
            if let Some(is_origin) = is_origin.get_mut(v) {
                *is_origin = true;
            }
        }
        let lone = (0..structure.vertex_slots()).filter(|v| structure.is_vertex(*v) && !is_origin[*v]);
        let isolated: Vec<(usize, Option<Position>)> = lone.map(|v| (v, finite(structure.point(v)))).collect();
        placeless += isolated.iter().filter(|(_, at)| at.is_none()).count();
        let isolated: Vec<(usize, Position)> = isolated.into_iter().filter_map(|(v, at)| Some((v, at?))).collect();
        let whole = Window::tight(
            whole.iter().flat_map(|window| [&window.low, &window.high]).chain(isolated.iter().map(|(_, at)| at)),
        );
        let (origin, span) =
            whole.map_or(([0.0; 2], 0.0), |Window { low, high }| (low, (high[0] - low[0]).max(high[1] - low[1])));
        let step = if span > 0.0 { (span.log2().ceil() - f64::from(CELLS)).exp2() } else { 1.0 };

        let known = vec![false; structure.vertex_slots()];
        let mut stream = Stream { origin, step, known, ..Stream::default() };
        let mut side = vec![NONE; structure.half_edge_slots()];
        for (c, chain) in (0..).step_by(2).zip(&chains) {
            stream.chain(chain);
            side[chain.ends[0]] = c;
            if let Some(mate) = links.mate(chain.ends[1]) {
                side[mate] = c + 1;
            }
        }
        let faces: Vec<usize> = (0..structure.face_slots()).filter(|f| structure.is_face(*f)).collect();
        let mut places = vec![0; structure.face_slots()];
        for (place, face) in (1..).zip(&faces) {
            places[*face] = place;
        }
        let face_of = |h: usize| match structure.boundary(h) {
            Some(b) if b < structure.boundary_slots() => structure.boundary_face(b),
            Some(_) => None,
            None => structure.face(h),
        };
        for (c, chain) in (0_u32..).step_by(2).zip(&chains) {
            let first = links.mate(chain.ends[0]).filter(|_| !chain.is_one_sided);
            for (own, last) in [(c, Some(chain.ends[1])), (c + 1, first)] {
                let next = last.and_then(|h| structure.next(h)).and_then(|next| side.get(next).copied());
                match next.filter(|next| *next != NONE) {
                    Some(next) => stream.number(1 + zigzag(i64::from(next) - i64::from(own))),
                    None => stream.number(0),
                }
                let face = last.and_then(face_of).and_then(|face| places.get(face).copied());
                stream.number(face.unwrap_or(0));
            }
        }
        for face in &faces {
            stream.index(*face, |stream| &mut stream.face);
            let features = (beside.features)(*face);
            stream.number(features.len() as u64);
            let mut last = 0;
            for feature in features.into_iter().map(signed) {
                stream.number(zigzag(feature - last));
                last = feature;
            }
        }
        for (vertex, at) in &isolated {
            stream.stop(&Stop { at: *at, vertex: Some(*vertex) });
        }
        Self {
            origin,
            step,
            chains: chains.len(),
            points: chains.iter().map(|chain| chain.stops.len()).sum(),
            vertex_slots: structure.vertex_slots(),
            faces: faces.len(),
            isolated: isolated.len(),
            edges: [shown, all],
            placeless,
            names: beside.names,
            areas: None,
            stream: stream.bytes,
        }
    }
}

/// A stream of numbers, which are small if they are close to their predecessors.
#[derive(Default)]
struct Stream {
    bytes: Vec<u8>,
    origin: Position,
    step: f64,
    at: [i64; 2],
    /// The vertices that came before.
    known: Vec<bool>,
    vertex: i64,
    half_edge: i64,
    face: i64,
}

fn zigzag(number: i64) -> u64 {
    let twice = number.unsigned_abs().wrapping_mul(2);
    if number < 0 { twice.wrapping_sub(1) } else { twice }
}

/// Converts an index; no index is too large.
fn signed(index: usize) -> i64 {
    i64::try_from(index).unwrap_or(i64::MAX)
}

impl Stream {
    fn number(&mut self, mut number: u64) {
        while number >= 0x80 {
            self.bytes.push(number as u8 | 0x80);
            number >>= 7;
        }
        self.bytes.push(number as u8);
    }

    fn index(&mut self, index: usize, last: impl Fn(&mut Self) -> &mut i64) {
        let index = signed(index);
        let before = std::mem::replace(last(self), index);
        self.number(zigzag(index - before));
    }

    fn stop(&mut self, stop: &Stop) {
        let cell = [0, 1].map(|i| ((stop.at[i] - self.origin[i]) / self.step).round() as i64);
        let is_new = match stop.vertex {
            None => {
                self.number(0);
                true
            }
            Some(vertex) => {
                let is_new = !std::mem::replace(&mut self.known[vertex], true);
                let vertex = signed(vertex);
                self.number(1 + 2 * zigzag(vertex - self.vertex) + u64::from(is_new));
                self.vertex = vertex;
                is_new
            }
        };
        if is_new {
            self.number(zigzag(cell[0] - self.at[0]));
            self.number(zigzag(cell[1] - self.at[1]));
        }
        self.at = cell;
    }

    fn chain(&mut self, chain: &Chain) {
        self.number(u64::from(chain.is_one_sided));
        self.number(chain.stops.len() as u64);
        for stop in &chain.stops {
            self.stop(stop);
        }
        for h in &chain.half_edges {
            self.index(*h, |stream| &mut stream.half_edge);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Beside, Map, Names, Window, zigzag};
    use crate::textbook::Textbook;
    use twinedge_map::{Builder, Shape};

    fn pack(structure: &impl twinedge_map::Embedding) -> Map {
        Map::pack(structure, Beside { features: &|_| vec![7], names: Names::Indices, windows: &[] })
    }

    fn numbers(bytes: &[u8]) -> Vec<u64> {
        let mut found = Vec::new();
        let (mut number, mut shift) = (0, 0);
        for byte in bytes {
            number |= u64::from(byte & 0x7f) << shift;
            shift += 7;
            if byte & 0x80 == 0 {
                found.push(number);
                (number, shift) = (0, 0);
            }
        }
        found
    }

    #[test]
    fn small_numbers_are_short() {
        assert_eq!([0, -1, 1, -2, 2].map(zigzag), [0, 1, 2, 3, 4]);
        assert_eq!(zigzag(i64::MIN), u64::MAX);
    }

    #[test]
    fn a_ring_is_one_chain_with_a_side_in_each_face() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let mut builder = Builder::new();
        builder.shape(&Shape::polygon(square)).expect("in range");
        let packed = pack(&builder.build().expect("small"));
        assert_eq!((packed.chains, packed.points, packed.faces, packed.edges), (1, 5, 2, [4, 4]));
        let numbers = numbers(&packed.stream);
        // Two sides and five points, four half-edges, two sides, two faces with a feature each.
        assert_eq!(numbers.len(), 2 + (4 * 3 + 1) + 4 + 2 * 2 + 2 * 3);
        // Each side is its own next, and they are in different faces.
        let [next, face, next_back, face_back] = numbers[19..23] else { panic!("{numbers:?}") };
        assert_eq!((next, next_back), (1, 1));
        assert_eq!([face, face_back].iter().sum::<u64>(), 3);
    }

    #[test]
    fn a_half_edge_whose_twin_disowns_it_is_a_chain_with_one_side() {
        // e1,1 and e1,2 are twins; e2,1 names e1,2 as its twin, which does not name it back.
        let tables = "v1 (0, 0) e1,1\nv2 (4, 0) e1,2\nv3 (9, 9) e2,1\nf1 nil e1,1
            e1,1 v1 e1,2 f1 e1,2 e1,2\ne1,2 v2 e1,1 f1 e1,1 e1,1\ne2,1 v3 e1,2 f1 ? nil";
        let tables: Textbook = tables.parse().expect("it is one");
        let packed = pack(&tables);
        assert_eq!((packed.chains, packed.edges, packed.placeless), (2, [2, 2], 0));
        let numbers = numbers(&packed.stream);
        // Flag, number of points, two new vertices, a half-edge; then the other chain.
        assert_eq!((numbers[0], numbers[9]), (0, 1));
        let nowhere: Textbook = tables.to_string().replace("(9, 9)", "?").parse().expect("it is one");
        assert_eq!((pack(&nowhere).chains, pack(&nowhere).placeless), (1, 1));
    }

    #[test]
    fn of_a_structure_that_is_too_large_the_windows_are_shown() {
        let mut builder = Builder::new();
        for x in [0.0, 100.0] {
            let triangle = [[x, 0.0], [x + 1.0, 0.0], [x, 1.0]];
            builder.shape(&Shape::polygon(triangle)).expect("in range");
        }
        let map = builder.build().expect("small");
        let window = Window::around(&[[99.0, 0.0], [100.0, 0.5]]).expect("there are points");
        let up_to = |most| {
            let beside = Beside { features: &|_| Vec::new(), names: Names::Indices, windows: &[window] };
            Map::pack_up_to(most, &map, beside)
        };
        assert_eq!((up_to(6).edges, up_to(6).chains), ([6, 6], 2));
        let cut = up_to(5);
        assert_eq!((cut.edges, cut.chains, cut.points), ([3, 6], 1, 4));
    }

    #[test]
    fn windows_have_margins() {
        let window = Window::around(&[[0.0, 0.0], [4.0, 1.0]]).expect("there are points");
        assert_eq!((window.low, window.high), ([-4.0, -4.0], [8.0, 5.0]));
        assert!(window.meets(&Window::around(&[[8.0, 5.0]]).expect("there is a point")));
        assert!(!window.meets(&Window::around(&[[8.1, 0.0]]).expect("there is a point")));
    }
}
