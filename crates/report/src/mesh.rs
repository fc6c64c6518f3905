//! The audit of a mesh.

use crate::error::Error;
use crate::input::Input;
use crate::options::Options;
use crate::packed::{Beside, Map, Names, Picture};
use crate::report::{AuditReport, JsonForm, Note};
use crate::trace::{placed, position};
use crate::words::{counted, grouped};
use serde_json::to_value;
use twinedge::validate::{Collect, Record, View as _, Violation};
use twinedge_diagnosis::{Diagnosis, Kind, Records};
use twinedge_map::Embedding as _;
use twinedge_meshes::{Finding, Format as MeshFormat, HalfEdgeMesh, IndexedMesh, MeshAudit, MeshFile};

/// Checks everything requested.
pub(crate) fn in_space(mesh: &IndexedMesh, asked: &Options) -> MeshAudit {
    twinedge_meshes::audit_in_space(mesh, &asked.mesh.expectation(), &asked.mesh.space(), Collect::AtMost(asked.most()))
}

pub(crate) fn audit(
    Input { name, reader, .. }: Input,
    format: MeshFormat,
    asked: &Options,
) -> Result<(AuditReport, IndexedMesh), Error> {
    let file = twinedge_meshes::read(reader, Some(format))?;
    let mut report = of_mesh(&name, format.first_number(), &in_space(&file.mesh, asked))?;
    report.notes = notes(&file);
    report.json.extra.insert("format".to_owned(), format.name().into());
    report.json.extra.insert("dropped".to_owned(), to_value(&file.dropped)?);
    Ok((report, file.mesh))
}

pub(crate) fn of_mesh(name: &str, first: usize, audit: &MeshAudit) -> Result<AuditReport, Error> {
    let (findings, report) = (audit.findings(), audit.report());
    let mut extra = serde_json::Map::new();
    extra.insert("messages_count_from".to_owned(), first.into());
    Ok(AuditReport {
        valid: audit.is_valid(),
        counts: audit
            .count_lines()
            .map(|(what, count)| (what, count.map_or_else(|| "unknown".to_owned(), signed)))
            .into(),
        rules: audit.rules(),
        violations: report.violations().iter().map(|one| violation(one, first)).collect(),
        violation_count: report.violation_count(),
        findings: findings.list().iter().map(|one| finding(one, first)).collect(),
        finding_count: findings.total() as u64,
        remarks: audit.remarks(),
        json: JsonForm { counts: to_value(audit.counts())?, has_findings: true, extra, ..JsonForm::default() },
        ..AuditReport::new(name)
    })
}

/// Adds shapes to the findings, on the plane on which the mesh is drawn. O(points and corners).
pub(crate) fn trace(report: &mut AuditReport, mesh: &IndexedMesh) {
    let (drawn, _) = HalfEdgeMesh::link(mesh, Collect::First);
    let at = |vertex: &usize| position(drawn.point(*vertex));
    for one in &mut report.violations {
        if let Kind::Of(violation) = &one.kind {
            one.trace = placed(&drawn, violation).trace;
        }
    }
    for one in &mut report.findings {
        if let Records::OfMesh { faces, vertices } = &one.records {
            let ring = |face: &usize| {
                let corners = mesh.face(*face).iter().map(|vertex| *vertex as usize);
                let ring: Vec<usize> = corners.collect();
                ring.iter().chain(ring.first()).map(at).collect()
            };
            one.trace.lines = faces.iter().map(ring).collect();
            one.trace.points = vertices.iter().map(at).collect();
        }
    }
}

/// Returns the mesh as seen along the axis of its smallest extent; an empty picture if all points coincide.
pub(crate) fn picture(mesh: &IndexedMesh, report: &AuditReport) -> Picture {
    let mut points = mesh.points().iter();
    let first = points.next();
    if points.all(|point| Some(point) == first) {
        return Picture::default();
    }
    let (drawn, _) = HalfEdgeMesh::link(mesh, Collect::First);
    let name = |record: Record| record.to_string();
    let slots = 0..drawn.half_edge_slots();
    let mutual = |h: &usize| drawn.twin(*h).filter(|t| drawn.twin(*t) == Some(*h));
    let names = Names::Own {
        vertices: (0..drawn.vertex_slots()).map(|v| name(Record::Vertex(v))).collect(),
        half_edges: slots.clone().map(|h| name(Record::HalfEdge(h))).collect(),
        faces: (0..drawn.face_slots()).map(|f| name(Record::Face(f))).collect(),
        twins: slots.map(|h| mutual(&h)).collect(),
    };
    let map = Map::pack(&drawn, Beside { features: &|_| Vec::new(), names, windows: &report.windows() });
    Picture { map, ..Picture::default() }
}

fn violation(violation: &Violation, first: usize) -> Diagnosis {
    Diagnosis { message: violation.named(|record| record.index() + first).message(), ..violation.into() }
}

fn finding(finding: &Finding, first: usize) -> Diagnosis {
    Diagnosis { message: finding.counted_from(first).to_string(), ..finding.into() }
}

fn signed(count: isize) -> String {
    let sign = if count < 0 { "-" } else { "" };
    format!("{sign}{}", grouped(count.unsigned_abs()))
}

fn notes(file: &MeshFile) -> Vec<Note> {
    let (points, faces) = (file.mesh.points().len(), file.mesh.face_count());
    let dropped = file.dropped.iter().map(|dropped| format!("; not used: {} {}", dropped.count, dropped.what));
    let dropped: String = dropped.collect();
    let as_the_file = if file.format.first_number() == 1 { ", as the file counts points" } else { "" };
    vec![
        Note::Plain(format!("{}, {}, {}{dropped}", file.format, counted(points, "point"), counted(faces, "face"))),
        Note::Plain(format!(
            "vertices, faces and corners (half-edges) are counted from {}{as_the_file}",
            file.format.first_number()
        )),
    ]
}
