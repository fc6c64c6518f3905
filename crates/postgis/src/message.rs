//! Violations of the validator in the words of the database.

use super::topology::{Column, Topology};
use twinedge::validate::{Field, Record, Violation};

const fn column(half_edge: usize, field: Field) -> Option<Column> {
    Some(match (field, half_edge.is_multiple_of(2)) {
        (Field::Origin, true) => Column::StartNode,
        (Field::Origin, false) => Column::EndNode,
        (Field::Next, true) => Column::NextLeftEdge,
        (Field::Next, false) => Column::NextRightEdge,
        (Field::Face, true) => Column::LeftFace,
        (Field::Face, false) => Column::RightFace,
        _ => return None,
    })
}

fn named(topology: &Topology, half_edge: usize, field: Field) -> String {
    let edge = topology.edges.id(half_edge / 2).unwrap_or_default();
    format!("{} of edge {edge}", column(half_edge, field).map_or("side", Column::name))
}

/// Returns a half-edge in the notation of the columns.
fn signed(topology: &Topology, half_edge: usize) -> String {
    topology.name(Record::HalfEdge(half_edge)).trim_start_matches('+').to_owned()
}

/// Returns a violation in a sentence that names database ids, and columns where they are clearer.
pub(super) fn message(topology: &Topology, name: impl Fn(Record) -> String, violation: &Violation) -> String {
    let edge = |h: usize| topology.edges.id(h / 2).unwrap_or_default();
    match *violation {
        Violation::Nil { record: Record::HalfEdge(h), field } => {
            if let Some(column) = column(h, field) {
                return format!("{} of edge {} is null", column.name(), edge(h));
            }
        }
        Violation::Dangling { record: Record::HalfEdge(h), field, .. } => {
            if let Some(column) = column(h, field) {
                let what = match field {
                    Field::Origin => "node",
                    Field::Next => "edge",
                    _ => "face",
                };
                if let Some(named) = topology.unknown(h / 2, column) {
                    let (name, edge) = (column.name(), edge(h));
                    return format!("{name} of edge {edge} is {named}, and there is no such {what}");
                }
            }
        }
        Violation::NextShared { first, second, next } => {
            let [first, second] = [first, second].map(|h| named(topology, h, Field::Next));
            let next = signed(topology, next);
            return format!("{first} and {second} are both {next}, so one of their rings never closes");
        }
        Violation::Target { half_edge, next, target, found } => {
            let (column, next, edge) =
                (named(topology, half_edge, Field::Next), signed(topology, next), signed(topology, half_edge));
            let [target, found] = [target, found].map(|node| name(Record::Vertex(node)));
            return format!("{column} is {next}, which starts at node {found}, but edge {edge} ends at node {target}");
        }
        Violation::FaceChanges { half_edge, next, face: Some(face), found: Some(found) } => {
            let [one, other] = [half_edge, next].map(|h| named(topology, h, Field::Face));
            let [face, found] = [face, found].map(|face| name(Record::Face(face)));
            return format!(
                "{one} is {face}, but {other}, which follows it, is {found}: the face changes along a ring"
            );
        }
        Violation::IsolatedUnclaimed { vertex } => {
            let node = topology.name(Record::Vertex(vertex));
            return format!("node {node} has no edges, and no face contains it");
        }
        _ => {}
    }
    // Names are ids, so no word of a name is replaced.
    let words = [["half-edge", "edge"], ["vertices", "nodes"], ["vertex", "node"]];
    words.into_iter().fold(violation.named(name).message(), |text, [word, own]| text.replace(word, own))
}

/// Returns the unit of a rule. PostGIS calls a half-edge a signed edge.
pub(super) fn unit(unit: &'static str) -> &'static str {
    match unit {
        "vertex" => "node",
        "vertices" => "nodes",
        "half-edge" => "signed edge",
        "half-edges" => "signed edges",
        other => other,
    }
}
