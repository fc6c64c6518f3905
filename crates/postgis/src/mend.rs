//! SQL that shows the rows of a finding, and SQL for repairs with only one possible result.
//!
//! Tables are named without their schema, which must come first in `search_path`. A statement is given if valid lines and links
//! determine the value, and omitted if a row could be either restored or changed. Repeat the audit after running statements: one
//! repair may determine the value for another.

use super::error::TableName;
use super::finding::{Finding, TopologyColumn};
use super::labels::Labels;
use super::lines::Lines;
use super::rotation::Rotations;
use super::topology::{Column, NULL, Topology};
use std::collections::{BTreeMap, BTreeSet};
use twinedge::validate::{Field, Record, View, Violation};
use twinedge_diagnosis::{RuleLine, Sql};

/// Cycles with more half-edges are not relabelled.
const LONGEST: usize = 10_000;

pub(super) struct Mender<'a> {
    topology: &'a Topology,
    lines: &'a Lines<'a>,
    rotations: Rotations<'a>,
    labels: Labels<'a>,
    broken: Vec<&'static str>,
}

impl<'a> Mender<'a> {
    /// O(n) for n nodes and edges.
    pub(super) fn of(topology: &'a Topology, lines: &'a Lines<'a>, rules: &[RuleLine]) -> Self {
        let broken = rules.iter().filter(|rule| rule.violations > 0).map(|rule| rule.id).collect();
        Self { topology, lines, rotations: Rotations::of(lines), labels: Labels::of(topology, lines), broken }
    }

    /// Returns true if only these rules are broken, or none.
    fn only(&self, rules: &[&str]) -> bool {
        self.broken.iter().all(|rule| rules.contains(rule))
    }

    pub(super) fn of_finding(&self, finding: &Finding) -> Sql {
        let show = match *finding {
            Finding::IdMissing { table, .. } => format!("SELECT * FROM {table} WHERE {} IS NULL;", id_column(table)),
            Finding::EdgeIdNotPositive { edge } => format!("SELECT * FROM edge_data WHERE edge_id = {edge};"),
            _ => show(finding.record().as_slice()),
        };
        Sql { show, mend: self.mend_finding(finding) }
    }

    /// Returns the SQL for a violation of the validator's rules, with the records that it names.
    pub(super) fn of_violation(&self, violation: &Violation, records: &[String]) -> Sql {
        let mut mend: Vec<String> = self.mend_violation(violation);
        mend.dedup();
        Sql { show: show(records), mend }
    }

    fn mend_finding(&self, finding: &Finding) -> Vec<String> {
        let one = match *finding {
            Finding::ConnectedHasContainingFace { node, .. } => Some(set_containing(node, "NULL")),
            Finding::NoSuchContainingFace { node, .. } => self.locate(node),
            Finding::LiesElsewhere { node, lies_in: Some(face), .. } if !self.breaks(&["P1", "P4", "G1", "G4"]) => {
                Some(set_containing(node, &face.to_string()))
            }
            Finding::MbrMissing { face } | Finding::MbrNotBox { face } | Finding::MbrWrong { face } => {
                self.only(&["P2", "P3", "P4", "B2"]).then(|| {
                    let around = format!(
                        "SELECT ST_Envelope(ST_Collect(geom)) FROM edge_data WHERE {face} IN (left_face, right_face)"
                    );
                    format!("UPDATE face SET mbr = ({around}) WHERE face_id = {face};")
                })
            }
            Finding::UniverseHasMbr { face } => Some(format!("UPDATE face SET mbr = NULL WHERE face_id = {face};")),
            Finding::AbsNextDiffers { edge, column, .. } => self.topology.edges.slot(edge).and_then(|slot| {
                let (side, of) = match column {
                    TopologyColumn::AbsNextLeftEdge => (0, Column::NextLeftEdge),
                    TopologyColumn::AbsNextRightEdge => (1, Column::NextRightEdge),
                };
                let is_link = self.topology.next[slot as usize][side] != NULL;
                is_link.then(|| set_edge(edge, &format!("{column} = abs({})", of.name())))
            }),
            Finding::StartsElsewhere { edge, .. } => self.end_by_links(edge, 0),
            Finding::EndsElsewhere { edge, .. } => self.end_by_links(edge, 1),
            _ => None,
        };
        one.into_iter().collect()
    }

    fn mend_violation(&self, violation: &Violation) -> Vec<String> {
        let one = match *violation {
            Violation::Nil { record: Record::HalfEdge(h), field }
            | Violation::Dangling { record: Record::HalfEdge(h), field, .. } => match field {
                Field::Origin => self.end(h),
                Field::Next => self.next(h),
                Field::Face => self.face_row(h).or_else(|| self.label(h, 1)),
                _ => None,
            },
            Violation::NextShared { first, second, .. } => {
                return [first, second].into_iter().filter_map(|h| self.next(h)).collect();
            }
            Violation::Target { half_edge, .. } => self.next(half_edge),
            Violation::FaceChanges { half_edge, next, .. } => {
                self.next(half_edge).or_else(|| self.label(half_edge, 2)).or_else(|| self.label(next, 2))
            }
            Violation::SplitRotation { vertex, .. } | Violation::OutOfOrder { vertex, .. } => {
                let links = self.wrong_links(vertex).unwrap_or_default();
                return links.into_iter().filter_map(|link| self.set_next(link)).collect();
            }
            Violation::IsolatedUnclaimed { vertex } => {
                self.topology.nodes.id(vertex).and_then(|node| self.locate(node))
            }
            Violation::WrongFace { boundary, found: Some(face), .. } if self.only(&["G5"]) => {
                return self.relabel(boundary, face);
            }
            _ => None,
        };
        one.into_iter().collect()
    }

    fn breaks(&self, rules: &[&str]) -> bool {
        self.broken.iter().any(|rule| rules.contains(rule))
    }

    /// Lets PostGIS find `containing_face` of an isolated node, if the links are valid.
    fn locate(&self, node: i64) -> Option<String> {
        let face = "topology.GetFaceContainingPoint(current_schema()::text, geom)";
        self.only(&["P2", "P4", "B2"]).then(|| set_containing(node, face))
    }

    /// Returns the node at an end of an edge: the one at the end of the line, or the row required by all edges with its id.
    fn end(&self, half_edge: usize) -> Option<String> {
        let (edge, side) = (half_edge / 2, half_edge % 2);
        let topology = self.topology;
        topology.line_ends(edge)?;
        let (id, found) = (topology.edges.id(edge)?, self.lines.origin(half_edge)?);
        if found < topology.nodes.len() {
            return Some(set_edge(id, &format!("{} = {}", END[side].name(), topology.nodes.id(found)?)));
        }
        let node = topology.unknown(edge, END[side])?;
        let at = topology.line_ends(edge)?[side];
        let is_there = |&(edge, column, _): &(u32, Column, i64)| {
            topology.line_ends(edge as usize).is_some_and(|ends| ends[usize::from(column == Column::EndNode)] == at)
        };
        let of_node = |entry: &&(u32, Column, i64)| END.contains(&entry.1) && entry.2 == node;
        topology.unknown.iter().filter(of_node).all(is_there).then(|| {
            let point = ["ST_StartPoint", "ST_EndPoint"][side];
            let is_new = format!("NOT EXISTS (SELECT FROM node WHERE node_id = {node})");
            let row = format!("SELECT {node}, {point}(geom) FROM edge_data WHERE edge_id = {id} AND {is_new}");
            format!("INSERT INTO node (node_id, geom) {row};")
        })
    }

    /// Returns the node at an end of an edge, if the line ends at a node other than the named one, and the links lead there.
    fn end_by_links(&self, edge: i64, side: usize) -> Option<String> {
        let slot = self.topology.edges.slot(edge)? as usize;
        let half_edge = 2 * slot + side;
        let found = self.lines.origin(half_edge).filter(|found| *found < self.topology.nodes.len())?;
        let after = self.topology.next(half_edge ^ 1).filter(|next| *next < self.topology.half_edge_slots())?;
        (after / 2 != slot && self.topology.origin(after) == Some(found)).then_some(())?;
        self.end(half_edge)
    }

    /// Returns the link to the next edge according to the lines, if it differs.
    fn next(&self, half_edge: usize) -> Option<String> {
        let links = self.wrong_links(self.lines.origin(half_edge ^ 1)?)?;
        links.into_iter().find(|[from, _]| *from == half_edge).and_then(|link| self.set_next(link))
    }

    /// Returns the links at a vertex that differ from the lines; `None` where labels contradict the lines.
    fn wrong_links(&self, vertex: usize) -> Option<Vec<[usize; 2]>> {
        let topology = self.topology;
        let mut links = self.rotations.links(vertex)?;
        links.retain(|[from, next]| topology.next(*from) != Some(*next));
        let face = |h: usize| topology.face(h).filter(|face| *face < topology.faces.len());
        links.iter().all(|[from, next]| face(*from).is_some() && face(*from) == face(*next)).then_some(links)
    }

    fn set_next(&self, [half_edge, next]: [usize; 2]) -> Option<String> {
        let (edge, id) = (self.topology.edges.id(half_edge / 2)?, self.topology.edges.id(next / 2)?);
        let sign = if next.is_multiple_of(2) { "" } else { "-" };
        let column = [Column::NextLeftEdge, Column::NextRightEdge][half_edge % 2].name();
        Some(set_edge(edge, &format!("{column} = {sign}{id}, abs_{column} = {id}")))
    }

    /// Returns the row of a missing face, if all half-edges that name it form one cycle.
    fn face_row(&self, half_edge: usize) -> Option<String> {
        let topology = self.topology;
        let column = |h: usize| SIDE[h % 2];
        let face = topology.unknown(half_edge / 2, column(half_edge))?;
        let names_it = |h: usize| topology.unknown(h / 2, column(h)) == Some(face);
        let of_face = topology.unknown.iter().filter(|entry| SIDE.contains(&entry.1) && entry.2 == face);
        let mut half_edges = of_face.map(|entry| 2 * entry.0 as usize + usize::from(entry.1 == Column::RightFace));
        half_edges.all(|h| topology.next(h).is_some_and(names_it)).then(|| {
            let mbr = if face == 0 { "NULL" } else { "ST_Envelope(ST_Collect(geom))" };
            let is_new = format!("NOT EXISTS (SELECT FROM face WHERE face_id = {face})");
            let rows = format!("FROM edge_data WHERE {face} IN (left_face, right_face) HAVING {is_new}");
            format!("INSERT INTO face (face_id, mbr) SELECT {face}, {mbr} {rows};")
        })
    }

    /// Returns the face of a half-edge, if at least `least` others are in its cycle, and all of these name one face.
    fn label(&self, half_edge: usize, least: usize) -> Option<String> {
        let topology = self.topology;
        let others = self.cycle(half_edge)?.split_off(1);
        let face = topology.face(*others.first()?).filter(|face| *face < topology.faces.len())?;
        let agree = others.len() >= least && others.iter().all(|h| topology.face(*h) == Some(face));
        (agree && self.labels.fits(half_edge, face)).then_some(())?;
        let (edge, face) = (topology.edges.id(half_edge / 2)?, topology.faces.id(face)?);
        Some(set_edge(edge, &format!("{} = {face}", SIDE[half_edge % 2].name())))
    }

    fn relabel(&self, boundary: Record, face: usize) -> Vec<String> {
        let topology = self.topology;
        let Some(face) = topology.faces.id(face) else { return Vec::new() };
        match boundary {
            Record::Vertex(node) => {
                topology.nodes.id(node).map(|node| set_containing(node, &face.to_string())).into_iter().collect()
            }
            Record::HalfEdge(h) => {
                let cycle = self.cycle(h).unwrap_or_default();
                let update = |side: usize| {
                    let of_side = cycle.iter().filter(|h| **h % 2 == side);
                    let edges: Vec<String> =
                        of_side.filter_map(|h| topology.edges.id(h / 2)).map(|id| id.to_string()).collect();
                    let set = format!("UPDATE edge_data SET {} = {face}", SIDE[side].name());
                    (!edges.is_empty()).then(|| format!("{set} WHERE edge_id IN ({});", edges.join(", ")))
                };
                [0, 1].into_iter().filter_map(update).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Returns the half-edges from this one on, if `next` leads back to it.
    fn cycle(&self, half_edge: usize) -> Option<Vec<usize>> {
        let mut cycle = vec![half_edge];
        loop {
            let next = self.topology.next(cycle[cycle.len() - 1]).filter(|h| *h < self.topology.half_edge_slots())?;
            if next == half_edge {
                return Some(cycle);
            }
            if cycle.len() == LONGEST {
                return None;
            }
            cycle.push(next);
        }
    }
}

const END: [Column; 2] = [Column::StartNode, Column::EndNode];
const SIDE: [Column; 2] = [Column::LeftFace, Column::RightFace];

fn set_containing(node: i64, face: &str) -> String {
    format!("UPDATE node SET containing_face = {face} WHERE node_id = {node};")
}

fn set_edge(edge: i64, what: &str) -> String {
    format!("UPDATE edge_data SET {what} WHERE edge_id = {edge};")
}

const fn id_column(table: TableName) -> &'static str {
    match table {
        TableName::Node => "node_id",
        TableName::Face => "face_id",
        TableName::EdgeData => "edge_id",
    }
}

/// Returns the SQL that shows these records, or face 0 if there are none.
fn show(records: &[String]) -> String {
    let mut ids: BTreeMap<&str, BTreeSet<i64>> = BTreeMap::new();
    for (table, id) in records.iter().filter_map(|record| record.split_once(' ')) {
        let Ok(id) = id.trim_start_matches(['+', '-']).parse() else { continue };
        ids.entry(table).or_default().insert(id);
    }
    if ids.is_empty() {
        ids.entry("face").or_default().insert(0);
    }
    let select = ids.into_iter().map(|(table, ids)| {
        let table = match table {
            "node" => TableName::Node,
            "face" => TableName::Face,
            _ => TableName::EdgeData,
        };
        let ids: Vec<String> = ids.iter().map(ToString::to_string).collect();
        format!("SELECT * FROM {table} WHERE {} IN ({});", id_column(table), ids.join(", "))
    });
    select.collect::<Vec<_>>().join(" ")
}
