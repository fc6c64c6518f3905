//! From the three streams to columns.

use super::copy::{CopyReader, SIGNATURE};
use super::error::{Cause, ReadError, TableName};
use super::ewkb::{Geometry, Points, parse};
use super::finding::{Finding, Findings, TopologyColumn};
use super::ids::Ids;
use super::mbr::{Box2, Mbr};
use super::topology::{Column, NULL, Topology, UNKNOWN};
use std::io::BufRead;
use twinedge_geometry::Point;

/// The largest number of rows of a table: half-edges have 32-bit numbers.
const MOST_ROWS: usize = (u32::MAX / 2) as usize - 1;

/// Returns true if [`read`] takes a stream with these first bytes.
#[must_use]
pub fn is_copy(beginning: &[u8]) -> bool {
    beginning.starts_with(SIGNATURE)
}

/// Reads the three streams that `psql` writes for [`sql`](super::sql).
///
/// Ids have 4 or 8 bytes. Of each rule P0 … P4 up to `limit` findings are kept; all are counted. Lines are kept as their bends:
/// points that repeat the one before them are counted and dropped.
///
/// O(n) for n rows and points, or O(n log n) if the ids are sparse. Memory grows with the content, not with stated lengths.
///
/// # Errors
/// [`ReadError::Content`] if the streams are malformed, with byte, table, row and column; and [`ReadError::Io`].
pub fn read(input: impl BufRead, limit: usize) -> Result<Topology, ReadError> {
    let mut streams = CopyReader::new(input);
    let mut read = Reading { topology: Topology::default(), containing: Vec::new(), srid: None };
    read.topology.findings = Findings::new(limit);
    read.nodes(&mut streams)?;
    read.faces(&mut streams)?;
    read.edges(&mut streams)?;
    streams.end()?;
    Ok(read.finish())
}

struct Reading {
    topology: Topology,
    /// Nodes with their containing face, if it is not null.
    containing: Vec<(u32, i64)>,
    srid: Option<u32>,
}

/// Columns of edges that can be resolved only after all edges are read.
#[derive(Default)]
struct Edges {
    ids: Vec<i64>,
    next: Vec<[Option<i64>; 2]>,
    connected: Vec<bool>,
}

impl Reading {
    fn nodes<R: BufRead>(&mut self, streams: &mut CopyReader<R>) -> Result<(), ReadError> {
        streams.begin(TableName::Node)?;
        let mut ids = Vec::new();
        while streams.next_row(3)? {
            let id = streams.integer("node_id")?;
            let containing = streams.integer("containing_face")?;
            let (geometry, srid) = match streams.value("geom")?.map(parse).transpose() {
                Ok(Some((Geometry::Point(point), srid))) => (Ok(point), Some(srid)),
                Ok(Some((other, srid))) => (Err(Some(number(&other))), Some(srid)),
                Ok(None) => (Err(None), None),
                Err(cause) => return Err(streams.error(cause)),
            };
            let Some(id) = self.id(streams, &ids, TableName::Node, id)? else { continue };
            let nowhere = Point::new(f64::NAN, f64::NAN);
            let point = geometry.unwrap_or(nowhere);
            match geometry {
                Err(Some(geometry)) => self.topology.findings.add(Finding::NodeNotPoint { node: id, geometry }),
                _ if point.x.is_nan() && point.y.is_nan() => {
                    self.topology.findings.add(Finding::NodeWithoutPoint { node: id });
                }
                _ => {}
            }
            self.one_system(TableName::Node, id, srid);
            self.containing.extend(containing.map(|face| (ids.len() as u32, face)));
            self.topology.points.push(point);
            ids.push(id);
        }
        self.topology.nodes = Ids::of(ids);
        Ok(())
    }

    fn faces<R: BufRead>(&mut self, streams: &mut CopyReader<R>) -> Result<(), ReadError> {
        streams.begin(TableName::Face)?;
        let mut ids = Vec::new();
        while streams.next_row(2)? {
            let id = streams.integer("face_id")?;
            let (mbr, srid) = match streams.value("mbr")?.map(parse).transpose() {
                Ok(Some((geometry, srid))) => (Mbr::of(&geometry), Some(srid)),
                Ok(None) => (Mbr::Null, None),
                Err(cause) => return Err(streams.error(cause)),
            };
            let Some(id) = self.id(streams, &ids, TableName::Face, id)? else { continue };
            self.one_system(TableName::Face, id, srid);
            self.topology.mbrs.push(mbr);
            ids.push(id);
        }
        self.topology.face_has_edges = vec![false; ids.len()];
        self.topology.boxes = vec![Box2::EMPTY; ids.len()];
        self.topology.faces = Ids::of(ids);
        Ok(())
    }

    fn edges<R: BufRead>(&mut self, streams: &mut CopyReader<R>) -> Result<(), ReadError> {
        streams.begin(TableName::EdgeData)?;
        let mut edges = Edges { connected: vec![false; self.topology.points.len()], ..Edges::default() };
        while streams.next_row(10)? {
            let id = streams.integer("edge_id")?;
            let ends = [streams.integer("start_node")?, streams.integer("end_node")?];
            let left = [streams.integer("next_left_edge")?, streams.integer("abs_next_left_edge")?];
            let right = [streams.integer("next_right_edge")?, streams.integer("abs_next_right_edge")?];
            let sides = [streams.integer("left_face")?, streams.integer("right_face")?];
            let (line, srid) = match streams.value("geom")?.map(parse).transpose() {
                Ok(line) => line.unzip(),
                Err(cause) => return Err(streams.error(cause)),
            };
            // Only null and positive ids are handled here: the rest of the row may borrow the stream.
            let Some(id) = id.filter(|id| *id > 0) else {
                self.topology.findings.add(match id {
                    Some(edge) => Finding::EdgeIdNotPositive { edge },
                    None => Finding::IdMissing { table: TableName::EdgeData, row: streams.row() },
                });
                continue;
            };
            self.one_system(TableName::EdgeData, id, srid);
            let fits = self.edge(&mut edges, id, ends, sides, line.as_ref());
            if !fits || edges.ids.len() > MOST_ROWS {
                return Err(streams.error(Cause::TooLarge));
            }
            edges.next.push([left[0], right[0]]);
            let columns = [(left, TopologyColumn::AbsNextLeftEdge), (right, TopologyColumn::AbsNextRightEdge)];
            for ([next, found], column) in columns {
                if next.map(i64::unsigned_abs) != found.and_then(|found| u64::try_from(found).ok()) {
                    self.topology.findings.add(Finding::AbsNextDiffers { edge: id, column, found });
                }
            }
        }
        self.resolve(edges);
        Ok(())
    }

    /// Returns the id of a row; `None` for null: the row is then left out.
    fn id<R: BufRead>(
        &mut self,
        streams: &CopyReader<R>,
        ids: &[i64],
        table: TableName,
        id: Option<i64>,
    ) -> Result<Option<i64>, ReadError> {
        if ids.len() > MOST_ROWS {
            return Err(streams.error(Cause::TooLarge));
        }
        if id.is_none() {
            self.topology.findings.add(Finding::IdMissing { table, row: streams.row() });
        }
        Ok(id)
    }

    /// Compares the reference system of a geometry with the first one.
    fn one_system(&mut self, table: TableName, id: i64, srid: Option<u32>) {
        let Some(srid) = srid else { return };
        let first = *self.srid.get_or_insert(srid);
        if srid != first {
            self.topology.findings.add(Finding::OtherReferenceSystem { table, id, srid, first });
        }
    }

    /// Adds an edge without its links to other edges; false if there are too many bends.
    fn edge(
        &mut self,
        edges: &mut Edges,
        id: i64,
        ends: [Option<i64>; 2],
        sides: [Option<i64>; 2],
        line: Option<&Geometry<'_>>,
    ) -> bool {
        let topology = &mut self.topology;
        let row = edges.ids.len() as u32;
        edges.ids.push(id);
        let mut slot = |ids: &Ids, column: Column, named: Option<i64>| match named.map(|id| (id, ids.slot(id))) {
            None => NULL,
            Some((_, Some(slot))) => slot,
            Some((id, None)) => {
                topology.unknown.push((row, column, id));
                UNKNOWN
            }
        };
        let ends = [slot(&topology.nodes, Column::StartNode, ends[0]), slot(&topology.nodes, Column::EndNode, ends[1])];
        let sides =
            [slot(&topology.faces, Column::LeftFace, sides[0]), slot(&topology.faces, Column::RightFace, sides[1])];
        topology.ends.push(ends);
        topology.sides.push(sides);
        topology.first_bend.push(topology.bends.len() as u32);
        for node in ends {
            if let Some(connected) = edges.connected.get_mut(node as usize) {
                *connected = true;
            }
        }
        let mut around = Box2::EMPTY;
        match line {
            Some(Geometry::Line(points)) if points.iter().len() > 1 => {
                around = Box2::of(points.iter());
                topology.line(row, id, ends, *points);
            }
            other => {
                topology.loose.push((row, None));
                topology.findings.add(match other {
                    Some(Geometry::Line(_)) | None => Finding::EdgeWithoutCurve { edge: id },
                    Some(other) => Finding::EdgeNotCurve { edge: id, geometry: number(other) },
                });
            }
        }
        for face in sides.map(|face| face as usize) {
            if let Some(entry) = topology.boxes.get_mut(face) {
                *entry = entry.around(around);
                topology.face_has_edges[face] = true;
            }
        }
        topology.bends.len() < UNKNOWN as usize
    }

    fn resolve(&mut self, Edges { ids, next, connected }: Edges) {
        let topology = &mut self.topology;
        topology.first_bend.push(topology.bends.len() as u32);
        topology.edges = Ids::of(ids);
        for (row, links) in (0..).zip(next) {
            let columns = [Column::NextLeftEdge, Column::NextRightEdge];
            let mut resolved = [NULL; 2];
            for ((named, column), link) in links.into_iter().zip(columns).zip(&mut resolved) {
                let Some(id) = named else { continue };
                let found = id.checked_abs().and_then(|id| topology.edges.slot(id));
                *link = found.map_or(UNKNOWN, |edge| 2 * edge + u32::from(id < 0));
                if found.is_none() {
                    topology.unknown.push((row, column, id));
                }
            }
            topology.next.push(resolved);
        }
        topology.unknown.sort_unstable();
        for (node, id) in std::mem::take(&mut self.containing) {
            let name = topology.nodes.id(node as usize).unwrap_or_default();
            let is_face = |face: &u32| topology.face_has_edges[*face as usize] || id == 0;
            match topology.faces.slot(id).filter(is_face) {
                _ if connected[node as usize] => {
                    topology.findings.add(Finding::ConnectedHasContainingFace { node: name, face: id });
                }
                Some(face) => topology.contained.push((face, node)),
                None => topology.findings.add(Finding::NoSuchContainingFace { node: name, face: id }),
            }
        }
        topology.contained.sort_unstable();
    }

    /// Judges rows after all are read.
    fn finish(self) -> Topology {
        let mut topology = self.topology;
        let tables = [
            (TableName::Node, &topology.nodes),
            (TableName::Face, &topology.faces),
            (TableName::EdgeData, &topology.edges),
        ];
        for (table, ids) in tables {
            for id in ids.repeated().filter_map(|slot| ids.id(slot)) {
                topology.findings.add(Finding::IdRepeated { table, id });
            }
        }
        for (slot, has_edges) in topology.face_has_edges.iter().enumerate() {
            let face = topology.faces.id(slot).unwrap_or_default();
            if !has_edges && face != 0 && topology.faces.is_first(slot) {
                topology.findings.add(Finding::FaceWithoutEdges { face });
            }
        }
        topology
    }
}

impl Topology {
    /// Adds the bends of a line of two points or more, and compares its ends with the nodes.
    fn line(&mut self, row: u32, id: i64, ends: [u32; 2], points: Points<'_>) {
        let mut points = points.iter();
        let (Some(first), Some(last)) = (points.next(), points.next_back()) else { return };
        let nodes = ends.map(|node| self.points.get(node as usize).copied());
        let lies_at = |node: Option<Point>, end: Point| {
            // NaN coordinates belong to G1, and a node without point is already reported.
            #[expect(clippy::float_cmp, reason = "PostGIS, too, wants the very point of the node")]
            let same = |a: f64, b: f64| a == b || a.is_nan();
            node.is_none_or(|at| same(at.x, end.x) && same(at.y, end.y))
        };
        let name = |node: u32| self.nodes.id(node as usize).unwrap_or_default();
        if !lies_at(nodes[0], first) {
            self.findings.add(Finding::StartsElsewhere { edge: id, node: name(ends[0]) });
        }
        if !lies_at(nodes[1], last) {
            self.findings.add(Finding::EndsElsewhere { edge: id, node: name(ends[1]) });
        }
        if nodes != [Some(first), Some(last)] {
            self.loose.push((row, Some([first, last])));
        }
        let begin = self.bends.len();
        let mut before = first;
        for point in points {
            if point == before {
                self.repeated_points += 1;
            } else {
                self.bends.push(point);
            }
            before = point;
        }
        if self.bends.len() > begin && before == last {
            self.bends.pop();
            self.repeated_points += 1;
        }
    }
}

const fn number(geometry: &Geometry<'_>) -> u32 {
    match geometry {
        Geometry::Point(_) => 1,
        Geometry::Line(_) => 2,
        Geometry::Polygon(..) => 3,
        Geometry::Other(number) => *number,
    }
}
