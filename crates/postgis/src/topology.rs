//! A topology of PostGIS as columns, and as a view.

use super::finding::Findings;
use super::ids::Ids;
use super::mbr::{Box2, Mbr};
use twinedge::validate::{Link, Parts, Record, View};
use twinedge_geometry::Point;
use twinedge_map::Embedding;

/// A column that is null in the database.
pub(super) const NULL: u32 = u32::MAX;
/// A column that names no existing record.
pub(super) const UNKNOWN: u32 = u32::MAX - 1;

/// A topology as in the database: half-edge `2 · i` is the edge of row `i` in the direction of its line, `2 · i + 1` backwards.
///
/// As a [`View`] it has origins, twins, `next` and faces; `prev`, leaving half-edges and the lists of the faces are not stored.
/// Rows that break P0, and faces that break P3, are no records of the view.
///
/// ```
/// use twinedge_postgis::{ReadError, read};
/// let nothing: &[u8] = b"";
/// assert!(matches!(read(nothing, 100), Err(ReadError::Content { byte: 0, .. })));
/// ```
#[derive(Debug, Default)]
pub struct Topology {
    pub(super) nodes: Ids,
    /// NaN for a node without point.
    pub(super) points: Vec<Point>,
    pub(super) faces: Ids,
    pub(super) face_has_edges: Vec<bool>,
    pub(super) mbrs: Vec<Mbr>,
    pub(super) boxes: Vec<Box2>,
    pub(super) edges: Ids,
    /// Start and end node of each edge, left and right next half-edge, left and right face.
    pub(super) ends: Vec<[u32; 2]>,
    pub(super) next: Vec<[u32; 2]>,
    pub(super) sides: Vec<[u32; 2]>,
    /// The index of the first bend of each edge; the last entry is the number of bends.
    pub(super) first_bend: Vec<u32>,
    pub(super) bends: Vec<Point>,
    /// The edges whose line does not end at their nodes, in order, with the ends of the line; none for an edge without line.
    pub(super) loose: Vec<(u32, Option<[Point; 2]>)>,
    /// Faces with the isolated nodes that they contain, sorted.
    pub(super) contained: Vec<(u32, u32)>,
    /// The ids in columns of edges without such a record, sorted.
    pub(super) unknown: Vec<(u32, Column, i64)>,
    pub(super) repeated_points: u64,
    pub(super) findings: Findings,
}

/// A column of `edge_data` that names another record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Column {
    StartNode,
    EndNode,
    NextLeftEdge,
    NextRightEdge,
    LeftFace,
    RightFace,
}

impl Column {
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::StartNode => "start_node",
            Self::EndNode => "end_node",
            Self::NextLeftEdge => "next_left_edge",
            Self::NextRightEdge => "next_right_edge",
            Self::LeftFace => "left_face",
            Self::RightFace => "right_face",
        }
    }
}

fn link(column: &[[u32; 2]], half_edge: usize) -> Link {
    match column[half_edge / 2][half_edge % 2] {
        NULL => None,
        UNKNOWN => Some(usize::MAX),
        slot => Some(slot as usize),
    }
}

impl Topology {
    /// Returns the name of a record in the database: the id of a node or a face, and the id of an edge with the sign of its side.
    ///
    /// For [`Report::named`](twinedge::validate::Report::named). A record that does not exist is named by its number.
    #[must_use]
    pub fn name(&self, record: Record) -> String {
        let id = match record {
            Record::Vertex(v) => self.nodes.id(v),
            Record::HalfEdge(h) => {
                let edge = self.edges.id(h / 2);
                return edge.map_or_else(|| h.to_string(), |id| format!("{}{id}", if h % 2 == 0 { '+' } else { '-' }));
            }
            Record::Face(f) => self.faces.id(f),
            Record::Boundary(_) => None,
        };
        id.map_or_else(|| record.index().to_string(), |id| id.to_string())
    }

    /// Returns the slot of face 0.
    #[must_use]
    pub fn universe(&self) -> Option<usize> {
        self.faces.slot(0).map(|slot| slot as usize)
    }

    /// Returns the number of points of lines that repeat the point before them. They are legal, and no bends.
    #[must_use]
    pub const fn repeated_points(&self) -> u64 {
        self.repeated_points
    }

    /// Returns the id in a column, if it names no record.
    pub(super) fn unknown(&self, edge: usize, column: Column) -> Option<i64> {
        let key = |entry: &(u32, Column, i64)| (entry.0 as usize, entry.1);
        let at = self.unknown.binary_search_by_key(&(edge, column), key).ok()?;
        Some(self.unknown[at].2)
    }

    /// Returns both ends of the line of an edge; none for an edge without line.
    pub(super) fn line_ends(&self, edge: usize) -> Option<[Point; 2]> {
        if let Ok(at) = self.loose.binary_search_by_key(&edge, |(loose, _)| *loose as usize) {
            return self.loose[at].1;
        }
        let [start, end] = self.ends[edge].map(|node| self.points.get(node as usize).copied());
        Some([start?, end?])
    }

    /// Returns the points of the line of an edge, in its direction; none for an edge without line.
    pub(super) fn line_points(&self, edge: usize) -> Vec<Point> {
        let Some([start, end]) = self.line_ends(edge) else { return Vec::new() };
        let bends = (0..self.bends(2 * edge)).map(|bend| self.bend(2 * edge, bend));
        [start].into_iter().chain(bends).chain([end]).collect()
    }

    pub(super) fn contained(&self, face: usize) -> &[(u32, u32)] {
        let before = |face: usize| self.contained.partition_point(|(f, _)| (*f as usize) < face);
        &self.contained[before(face)..before(face.saturating_add(1))]
    }
}

/// The topology as its columns state it: half-edges name their faces, and faces list nothing.
impl View for Topology {
    fn parts(&self) -> Parts {
        Parts::NONE
    }

    fn vertex_slots(&self) -> usize {
        self.nodes.len()
    }

    fn half_edge_slots(&self) -> usize {
        2 * self.edges.len()
    }

    fn face_slots(&self) -> usize {
        self.faces.len()
    }

    fn is_vertex(&self, vertex: usize) -> bool {
        self.nodes.is_first(vertex)
    }

    fn is_half_edge(&self, half_edge: usize) -> bool {
        self.edges.is_first(half_edge / 2)
    }

    fn is_face(&self, face: usize) -> bool {
        self.faces.is_first(face) && (self.face_has_edges[face] || self.faces.id(face) == Some(0))
    }

    fn origin(&self, half_edge: usize) -> Link {
        link(&self.ends, half_edge)
    }

    fn twin(&self, half_edge: usize) -> Link {
        Some(half_edge ^ 1)
    }

    fn next(&self, half_edge: usize) -> Link {
        link(&self.next, half_edge)
    }

    fn face(&self, half_edge: usize) -> Link {
        link(&self.sides, half_edge)
    }
}

impl Embedding for Topology {
    fn point(&self, vertex: usize) -> Point {
        self.points[vertex]
    }

    fn bends(&self, half_edge: usize) -> usize {
        let edge = half_edge / 2;
        (self.first_bend[edge + 1] - self.first_bend[edge]) as usize
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        let edge = half_edge / 2;
        let [from, to] = [self.first_bend[edge], self.first_bend[edge + 1]].map(|place| place as usize);
        self.bends[if half_edge.is_multiple_of(2) { from + bend } else { to - 1 - bend }]
    }
}
