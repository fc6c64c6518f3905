//! The three tables of the textbooks: vertices, faces, half-edges.
//!
//! ```text
//! Vertex  Coordinates  IncidentEdge
//! v1      (0, 2)       e1,1
//! v2      (2, 2)       e4,2
//! v3      (1, 1)       e2,1
//! v4      (2, 0)       e2,2
//!
//! Face  OuterComponent  InnerComponents
//! f1    nil             e1,1
//! f2    e4,1            nil
//!
//! Half-edge  Origin  Twin  IncidentFace  Next  Prev
//! e1,1       v1      e1,2  f1            e4,2  e3,1
//! e1,2       v2      e1,1  f2            e3,2  e4,1
//! …
//! ```
//!
//! [`Textbook::of`] makes them from any structure, `Display` writes them, and `FromStr` reads them. A table can therefore be
//! copied out of a book and checked: a [`Textbook`] is a [`View`], to be validated with
//! [`Expectation::plane`](twinedge::validate::Expectation::plane). If every vertex has coordinates,
//! [`validate_embedding`](twinedge_map::validate_embedding) also checks these.
//!
//! # What is read
//!
//! There is a line for each record, in any order; columns are separated by white space or `|`. The first letter of the name, `v`,
//! `f` or `e` in either case, decides the table of the line. Lines that start with `Vertex`, `Face`, `Edge` or `Half-edge` are
//! headings, lines of dashes are rules, and `#` starts a comment. Coordinates are optional. `nil` or `-` is no link, and `?` a
//! link to a record that does not exist. An isolated vertex has the edge `nil`, and is listed as an inner component of its face.
//!
//! Source: M. de Berg et al., "Computational Geometry", 3rd edition, section 2.2.

use core::fmt;
use rustc_hash::FxHashMap;
use std::str::FromStr;
use thiserror::Error;
use twinedge::validate::{FaceRow, HalfEdgeRow, Link, Part, Parts, Record, Start, Table, VertexRow, View};
use twinedge_geometry::Point;
use twinedge_map::Embedding;

/// An error in a text of the three tables. Lines are counted from 1.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Error)]
#[non_exhaustive]
pub enum TablesError {
    /// A line starts with no name of a record.
    #[error("line {line}: `{word}` names no vertex, half-edge or face: names start with v, e or f")]
    UnknownRow {
        /// The line.
        line: usize,
        /// The first word of the line.
        word: String,
    },
    /// A line has too few or too many columns.
    #[error("line {line}: {found} columns after the name, where {expected} belong")]
    Columns {
        /// The line.
        line: usize,
        /// The expected columns.
        expected: &'static str,
        /// The number of columns found.
        found: usize,
    },
    /// Two lines describe the same record.
    #[error("line {line}: there is a line for {name} already")]
    Repeated {
        /// The later line.
        line: usize,
        /// The name.
        name: String,
    },
    /// A column names a record without a line.
    #[error("line {line}: there is no {kind} `{name}`")]
    UnknownName {
        /// The line.
        line: usize,
        /// The expected kind of record.
        kind: &'static str,
        /// The name.
        name: String,
    },
    /// Coordinates are not two numbers.
    #[error("line {line}: `{text}` is no pair of coordinates, such as (1, 2.5)")]
    Coordinates {
        /// The line.
        line: usize,
        /// The text found there.
        text: String,
    },
}

/// A structure as the three tables of the textbooks, with names and, as far as known, coordinates.
///
/// ```
/// use twinedge_report::textbook::Textbook;
/// use twinedge::validate::{Collect, Expectation, validate};
///
/// let text = "
///     v1  e1,1
///     v2  e1,2
///     f1  nil  e1,1
///     e1,1  v1  e1,2  f1  e1,2  e1,2
///     e1,2  v2  e1,1  f1  e1,1  e1,1";
/// let tables: Textbook = text.parse()?;
/// assert!(validate(&tables, &Expectation::plane(), Collect::All).is_valid());
/// # Ok::<(), twinedge_report::textbook::TablesError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Textbook {
    table: Table,
    points: Vec<Option<Point>>,
    vertices: Vec<String>,
    half_edges: Vec<String>,
    faces: Vec<String>,
}

impl Textbook {
    /// Makes the tables of a structure with faces, with `point` for the coordinates of a vertex, if any.
    ///
    /// Records are named by their indices, counted from 1: the first vertex is `v1`, the half-edges of the first edge are `e1,1`
    /// and `e1,2`. Vacant slots are left out. In a [`Dcel`](twinedge::dcel::Dcel), where index 0 is not used and twins are
    /// neighbours, vertex 7 is always `v7`, and half-edges 14 and 15 are `e7,1` and `e7,2`. O(n).
    #[must_use]
    pub fn of<V: View + ?Sized>(view: &V, point: impl Fn(usize) -> Option<Point>) -> Self {
        let vertices = Column::new("v", view.vertex_slots(), |v| view.is_vertex(v));
        let faces = Column::new("f", view.face_slots(), |f| view.is_face(f));
        let half_edges = Column::of_half_edges(view);
        let face_of = |h: usize| match view.boundary(h) {
            Some(b) => view.boundary_face(b),
            None => view.face(h),
        };
        let start = |start: Start| match start {
            Start::HalfEdge(h) => Start::HalfEdge(half_edges.place(h)),
            Start::Vertex(v) => Start::Vertex(vertices.place(v)),
        };
        let vertex_row = |v: &usize| VertexRow { leaving: half_edges.link(view.leaving(*v)), isolated: None };
        let half_edge_row = |h: &usize| HalfEdgeRow {
            origin: vertices.link(view.origin(*h)),
            twin: half_edges.link(view.twin(*h)),
            next: half_edges.link(view.next(*h)),
            prev: half_edges.link(view.prev(*h)),
            boundary: None,
            face: faces.link(face_of(*h)),
        };
        let face_row = |f: &usize| {
            let outer = match view.outer(*f).map(|b| view.boundary_start(b)) {
                Some(Some(Start::HalfEdge(h))) => Some(h),
                Some(_) => Some(usize::MAX),
                None => view.outer_half_edge(*f),
            };
            let inner = |i| match view.inner(*f, i) {
                Some(b) => view.boundary_start(b),
                None => view.inner_start(*f, i),
            };
            FaceRow {
                outer_half_edge: half_edges.link(outer),
                inner_starts: (0..view.inner_count(*f)).map(|i| inner(i).map(start)).collect(),
                ..FaceRow::default()
            }
        };
        let table = Table {
            vertices: vertices.live.iter().map(|v| Some(vertex_row(v))).collect(),
            half_edges: half_edges.live.iter().map(|h| Some(half_edge_row(h))).collect(),
            faces: faces.live.iter().map(|f| Some(face_row(f))).collect(),
            ..Table::default()
        };
        let points = vertices.live.iter().map(|v| point(*v)).collect();
        Self { table, points, vertices: vertices.names, half_edges: half_edges.names, faces: faces.names }
    }

    /// Makes the tables of a structure with coordinates. O(n).
    ///
    /// ```
    /// use twinedge_report::textbook::Textbook;
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// map.insert_segment([0.0, 0.0], [2.0, 1.0])?;
    /// let text = Textbook::of_embedding(&map).to_string();
    /// assert!(text.contains("v2      (2, 1)       e1,2"));
    /// assert_eq!(text.parse(), Ok(Textbook::of_embedding(&map)));
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    #[must_use]
    pub fn of_embedding<E: Embedding + ?Sized>(embedding: &E) -> Self {
        Self::of(embedding, |v| Some(embedding.point(v)))
    }

    /// Returns the links, as plain tables.
    #[must_use]
    pub const fn table(&self) -> &Table {
        &self.table
    }

    /// Returns true if every vertex has coordinates.
    #[must_use]
    pub fn has_coordinates(&self) -> bool {
        self.points.iter().all(Option::is_some)
    }

    /// Returns the name of a record; none for a boundary component, and for a record that does not exist. O(1).
    #[must_use]
    pub fn name(&self, record: Record) -> Option<&str> {
        let (names, index) = match record {
            Record::Vertex(i) => (&self.vertices, i),
            Record::HalfEdge(i) => (&self.half_edges, i),
            Record::Face(i) => (&self.faces, i),
            Record::Boundary(_) => return None,
        };
        names.get(index).map(String::as_str)
    }
}

/// The live records of a kind, with their names, and their positions among them by index.
struct Column {
    live: Vec<usize>,
    names: Vec<String>,
    places: FxHashMap<usize, usize>,
}

impl Column {
    fn new(letter: &str, slots: usize, is_live: impl Fn(usize) -> bool) -> Self {
        let live: Vec<usize> = (0..slots).filter(|i| is_live(*i)).collect();
        let first = usize::from(live.first() == Some(&0));
        let names = live.iter().map(|i| format!("{letter}{}", i + first)).collect();
        Self { places: live.iter().copied().zip(0..).collect(), live, names }
    }

    /// Twins share the number of their edge: half the index of the even one, if that numbers every edge, or else their order.
    fn of_half_edges<V: View + ?Sized>(view: &V) -> Self {
        let mut column = Self::new("e", view.half_edge_slots(), |h| view.is_half_edge(h));
        if column.live.iter().all(|h| view.twin(*h) == Some(*h ^ 1)) {
            let first = usize::from(column.live.first() == Some(&0));
            column.names = column.live.iter().map(|h| format!("e{},{}", h / 2 + first, h % 2 + 1)).collect();
            return column;
        }
        let mut edges = 0;
        let mut names = vec![String::new(); column.live.len()];
        for (place, h) in column.live.iter().enumerate() {
            if names[place].is_empty() {
                edges += 1;
                names[place] = format!("e{edges},1");
                let twin = view.twin(*h).and_then(|twin| names.get_mut(column.place(twin)));
                if let Some(twin) = twin.filter(|name| name.is_empty()) {
                    *twin = format!("e{edges},2");
                }
            }
        }
        column.names = names;
        column
    }

    /// Returns the position of a record among the live ones; past the end, if it is not live.
    fn place(&self, index: usize) -> usize {
        self.places.get(&index).copied().unwrap_or(usize::MAX)
    }

    fn link(&self, link: Link) -> Link {
        link.map(|index| self.place(index))
    }
}

/// Writes lines in columns as wide as their widest entry.
fn columns(f: &mut fmt::Formatter<'_>, heading: &[&str], rows: Vec<Vec<String>>) -> fmt::Result {
    let heading: Vec<String> = heading.iter().map(|word| (*word).to_owned()).collect();
    let rows: Vec<Vec<String>> = core::iter::once(heading).chain(rows).collect();
    let width = |i: usize| rows.iter().filter_map(|row| row.get(i)).map(|word| word.chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..rows[0].len()).map(width).collect();
    for row in &rows {
        let words: Vec<String> = row.iter().zip(&widths).map(|(word, width)| format!("{word:width$}")).collect();
        writeln!(f, "{}", words.join("  ").trim_end())?;
    }
    Ok(())
}

/// The three tables, with an empty line after each but the last.
impl fmt::Display for Textbook {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fn name(names: &[String], link: Link) -> String {
            link.map_or("nil", |i| names.get(i).map_or("?", String::as_str)).to_owned()
        }
        let half_edge = |link| name(&self.half_edges, link);
        let with_points = self.points.iter().any(Option::is_some);
        let vertices = self.vertices.iter().zip(&self.table.vertices).zip(&self.points).map(|((name, row), point)| {
            let point = with_points.then(|| point.map_or(String::from("?"), |p| format!("({}, {})", p.x, p.y)));
            let leaving = half_edge(row.unwrap_or_default().leaving);
            [Some(name.clone()), point, Some(leaving)].into_iter().flatten().collect()
        });
        let heading: &[&str] =
            if with_points { &["Vertex", "Coordinates", "IncidentEdge"] } else { &["Vertex", "IncidentEdge"] };
        columns(f, heading, vertices.collect())?;
        writeln!(f)?;
        let faces = self.faces.iter().zip(&self.table.faces).map(|(face, row)| {
            let row = row.clone().unwrap_or_default();
            let inner = row.inner_starts.iter().map(|start| match start {
                Some(Start::HalfEdge(h)) => half_edge(Some(*h)),
                Some(Start::Vertex(v)) => name(&self.vertices, Some(*v)),
                None => half_edge(None),
            });
            let inner: Vec<String> = inner.collect();
            let inner = if inner.is_empty() { half_edge(None) } else { inner.join(" ") };
            vec![face.clone(), half_edge(row.outer_half_edge), inner]
        });
        columns(f, &["Face", "OuterComponent", "InnerComponents"], faces.collect())?;
        writeln!(f)?;
        let half_edges = self.half_edges.iter().zip(&self.table.half_edges).map(|(h, row)| {
            let row = row.unwrap_or_default();
            let (origin, face) = (name(&self.vertices, row.origin), name(&self.faces, row.face));
            vec![h.clone(), origin, half_edge(row.twin), face, half_edge(row.next), half_edge(row.prev)]
        });
        columns(f, &["Half-edge", "Origin", "Twin", "IncidentFace", "Next", "Prev"], half_edges.collect())
    }
}

/// Returns the words of a line, with coordinates in parentheses as one word.
fn words(line: &str) -> Vec<String> {
    let line = line.split('#').next().unwrap_or_default();
    let mut words = Vec::new();
    let mut word = String::new();
    let mut open = false;
    for c in line.chars() {
        open = (open || c == '(') && c != ')';
        if c == '|' || c.is_whitespace() && !open {
            words.push(core::mem::take(&mut word));
        } else {
            word.push(c);
        }
    }
    words.push(word);
    // A comma after an entry of a list.
    let words = words.into_iter().map(|word| word.trim_end_matches([',', ';']).to_owned());
    words.filter(|word| !word.is_empty()).collect()
}

fn coordinates(line: usize, text: &str) -> Result<Point, TablesError> {
    let inside = text.strip_prefix('(').and_then(|text| text.strip_suffix(')'));
    let mut numbers = inside.into_iter().flat_map(|text| text.split([',', ' '])).filter(|word| !word.is_empty());
    let mut number = || numbers.next()?.parse::<f64>().ok();
    match (number(), number(), numbers.next()) {
        (Some(x), Some(y), None) => Ok(Point::new(x, y)),
        _ => Err(TablesError::Coordinates { line, text: text.to_owned() }),
    }
}

#[derive(Default)]
struct Rows {
    kind: &'static str,
    names: Vec<String>,
    places: FxHashMap<String, usize>,
    /// The number of the line, and the columns after the name.
    columns: Vec<(usize, Vec<String>)>,
}

impl Rows {
    fn of(kind: &'static str) -> Self {
        Self { kind, ..Self::default() }
    }

    fn push(&mut self, line: usize, name: String, columns: Vec<String>) -> Result<(), TablesError> {
        if self.places.insert(name.to_lowercase(), self.names.len()).is_some() {
            return Err(TablesError::Repeated { line, name });
        }
        self.names.push(name);
        self.columns.push((line, columns));
        Ok(())
    }

    fn link(&self, line: usize, name: &str) -> Result<Link, TablesError> {
        match name.to_lowercase().as_str() {
            "nil" | "-" => Ok(None),
            "?" => Ok(Some(usize::MAX)),
            lower => match self.places.get(lower) {
                Some(place) => Ok(Some(*place)),
                None => Err(TablesError::UnknownName { line, kind: self.kind, name: name.to_owned() }),
            },
        }
    }
}

/// Reads the three tables. O(length of the text), expected.
///
/// # Errors
/// [`TablesError`], with the line. The links are not checked; for that, see [`validate`](twinedge::validate::validate).
impl FromStr for Textbook {
    type Err = TablesError;

    fn from_str(text: &str) -> Result<Self, TablesError> {
        let [mut vertices, mut half_edges, mut faces] = ["vertex", "half-edge", "face"].map(Rows::of);
        for (line, text) in (1..).zip(text.lines()) {
            let mut words = words(text).into_iter();
            let Some(first) = words.next() else { continue };
            let lower = first.to_lowercase();
            let is_rule = first.chars().all(|c| "-–—=+:".contains(c));
            if is_rule || ["vertex", "face", "edge", "half-edge", "halfedge", "half"].contains(&lower.as_str()) {
                continue;
            }
            let rows = match lower.chars().next() {
                Some('v') => &mut vertices,
                Some('f') => &mut faces,
                Some('e') => &mut half_edges,
                _ => return Err(TablesError::UnknownRow { line, word: first }),
            };
            rows.push(line, first, words.collect())?;
        }

        let mut points = Vec::with_capacity(vertices.names.len());
        let mut table = Table::default();
        for (line, columns) in &vertices.columns {
            let (point, leaving) = match columns.as_slice() {
                [leaving] => (None, leaving),
                [unknown, leaving] if unknown == "?" => (None, leaving),
                [point, leaving] => (Some(coordinates(*line, point)?), leaving),
                other => {
                    let expected = "the coordinates, if any, and the incident edge";
                    return Err(TablesError::Columns { line: *line, expected, found: other.len() });
                }
            };
            points.push(point);
            let leaving = half_edges.link(*line, leaving)?;
            table.vertices.push(Some(VertexRow { leaving, isolated: None }));
        }
        for (line, columns) in &half_edges.columns {
            let [origin, twin, face, next, prev] = columns.as_slice() else {
                let expected = "origin, twin, incident face, next and prev";
                return Err(TablesError::Columns { line: *line, expected, found: columns.len() });
            };
            table.half_edges.push(Some(HalfEdgeRow {
                origin: vertices.link(*line, origin)?,
                twin: half_edges.link(*line, twin)?,
                face: faces.link(*line, face)?,
                next: half_edges.link(*line, next)?,
                prev: half_edges.link(*line, prev)?,
                boundary: None,
            }));
        }
        for (line, columns) in &faces.columns {
            let Some((outer, inner)) = columns.split_first() else {
                let expected = "the outer component and the inner components, if any,";
                return Err(TablesError::Columns { line: *line, expected, found: 0 });
            };
            // `nil` alone is the empty list.
            let inner = match inner {
                [only] if half_edges.link(*line, only) == Ok(None) => &[],
                inner => inner,
            };
            let start = |name: &String| match name.chars().next() {
                Some('v' | 'V') => Ok(vertices.link(*line, name)?.map(Start::Vertex)),
                _ => Ok(half_edges.link(*line, name)?.map(Start::HalfEdge)),
            };
            table.faces.push(Some(FaceRow {
                outer_half_edge: half_edges.link(*line, outer)?,
                inner_starts: inner.iter().map(start).collect::<Result<_, _>>()?,
                ..FaceRow::default()
            }));
        }
        Ok(Self { table, points, vertices: vertices.names, half_edges: half_edges.names, faces: faces.names })
    }
}

macro_rules! delegate {
    ($($name:ident($($arg:ident),*) -> $out:ty;)*) => {$(
        fn $name(&self, $($arg: usize),*) -> $out {
            self.table.$name($($arg),*)
        }
    )*};
}

/// Indices are the positions of the records in their tables, counted from 0.
impl View for Textbook {
    fn parts(&self) -> Parts {
        Parts::ALL.without(Part::BoundaryComponents)
    }

    delegate! {
        vertex_slots() -> usize;
        half_edge_slots() -> usize;
        face_slots() -> usize;
        origin(half_edge) -> Link;
        twin(half_edge) -> Link;
        next(half_edge) -> Link;
        prev(half_edge) -> Link;
        face(half_edge) -> Link;
        leaving(vertex) -> Link;
        inner_count(face) -> usize;
        outer_half_edge(face) -> Link;
        inner_start(face, position) -> Option<Start>;
    }
}

/// A vertex without coordinates is at NaN, which G1 reports.
impl Embedding for Textbook {
    fn point(&self, vertex: usize) -> Point {
        self.points.get(vertex).copied().flatten().unwrap_or(Point::new(f64::NAN, f64::NAN))
    }
}
