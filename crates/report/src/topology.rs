//! The audit of a PostGIS topology, as written by `psql`, or of the arcs of TopoJSON.

use crate::error::Error;
use crate::input::Input;
use crate::options::Options;
use crate::packed::{Beside, Map, Names, Picture};
use crate::report::{AuditReport, JsonForm, Note};
use crate::words::grouped;
use serde_json::to_value;
use twinedge::validate::Record;
use twinedge_layers::topojson::{self, ArcTopology};
use twinedge_map::Embedding;
use twinedge_postgis::{Topology, TopologyAudit};

pub(crate) fn audit_postgis(
    Input { name, reader, .. }: Input,
    asked: &Options,
) -> Result<(AuditReport, Topology), Error> {
    let topology = twinedge_postgis::read(reader, asked.most())?;
    let audit = twinedge_postgis::audit(&topology, asked.most())?;
    let mut report = report(&name, &audit, &POSTGIS)?;
    if asked.explain && !audit.is_valid() {
        report.remarks.push(SQL);
    }
    Ok((report, topology))
}

pub(crate) fn audit_arcs(
    Input { name, mut reader, layer, .. }: Input,
    asked: &Options,
) -> Result<(AuditReport, ArcTopology), Error> {
    let topology = topojson::read(&mut reader, layer.as_deref(), asked.most())?;
    let report = report(&name, &topojson::audit(&topology, asked.most()), &ARCS)?;
    Ok((report, topology))
}

const SQL: &str = "The SQL is for psql, after `SET search_path TO \"NAME\", public, topology;`. A fault with \"mend\" can be mended in this way only. Audit \
    again afterwards: more may be known then.";

/// A kind of topology, in words.
struct Words {
    note: &'static str,
    nodes: &'static str,
    edges: &'static str,
    faces: &'static str,
    repeated: &'static str,
}

const POSTGIS: Words = Words {
    note: "a topology of PostGIS; records have the ids of the database",
    nodes: "nodes (V)",
    edges: "edges (E)",
    faces: "faces (F), face 0 included",
    repeated: "repeated points, which are legal",
};

const ARCS: Words = Words {
    note: "arcs of TopoJSON; half-edge 3 is arc 3, and ~3 is arc 3 backwards",
    nodes: "ends of arcs (V)",
    edges: "arcs at polygons (E)",
    faces: "polygons (F)",
    repeated: "repeated points",
};

fn report(name: &str, audit: &TopologyAudit, words: &Words) -> Result<AuditReport, Error> {
    let counts = audit.counts();
    let json = to_value(audit)?;
    Ok(AuditReport {
        valid: audit.is_valid(),
        notes: vec![Note::Plain(words.note.to_owned())],
        counts: vec![
            (words.nodes, grouped(counts.nodes)),
            (words.edges, grouped(counts.edges)),
            (words.faces, grouped(counts.faces)),
            ("components (C)", counts.components.map_or_else(|| "unknown".to_owned(), grouped)),
            ("isolated nodes", grouped(counts.isolated_nodes)),
            ("bends", grouped(counts.bends)),
            (words.repeated, grouped(counts.repeated_points)),
        ],
        rules: audit.rules().to_vec(),
        violations: audit.violations().to_vec(),
        violation_count: audit.violation_count(),
        json: JsonForm { counts: json["counts"].clone(), is_named: true, ..JsonForm::default() },
        ..AuditReport::new(name)
    })
}

pub(crate) fn picture(topology: &impl Embedding, name: impl Fn(Record) -> String, report: &AuditReport) -> Picture {
    let names = Names::Ids {
        vertices: (0..topology.vertex_slots()).map(|v| name(Record::Vertex(v))).collect(),
        edges: (0..topology.half_edge_slots() / 2)
            .map(|edge| name(Record::HalfEdge(2 * edge)).trim_start_matches('+').to_owned())
            .collect(),
        faces: (0..topology.face_slots()).map(|f| name(Record::Face(f))).collect(),
    };
    let map = Map::pack(topology, Beside { features: &|_| Vec::new(), names, windows: &report.windows() });
    Picture { map, ..Picture::default() }
}
