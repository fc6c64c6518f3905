//! The audit of a mesh: findings, the validator's report, and counts.

use super::space;
use super::{Findings, HalfEdgeMesh, IndexedMesh, Kind, MeshCounts, SpaceOutcome, SpaceRule};
use std::fmt;
use twinedge::validate::{Collect, Expectation, Report, Rule, validate};
use twinedge_diagnosis::{Diagnosis, Reason, RuleLine, write_list};

/// The findings of an audit. `Display` prints all of it as text; with the feature `serde` it is serialized as
///
/// ```text
/// {
///   "schema": "twinedge-report/1",
///   "valid": false,
///   "counts": {"vertices": 7, "unused_vertices": 0, "edges": 12, "border_edges": 0, "faces": 8, "left_out_faces": 0,
///              "triangles": 8, "components": 1, "borders": 0, "euler_characteristic": 3, "genus": null, "orientable": true},
///   "finding_count": 1,
///   "findings": [{"kind": "non_manifold_vertex", "faces": [0, 4], "vertices": [0],
///                 "message": "2 fans of faces meet at vertex 0 and share no edge there; one face of each: 0, 4"}],
///   "rules": [{"id": "R1", "checked": 120, "violations": 0, "unchecked": null}, …,
///             {"id": "M7", "checked": 0, "violations": 0, "unchecked": {"broken": "V2"}}],
///   "violation_count": 1,
///   "violations": [{"rule": "V2", "kind": "split_rotation", "fields": {"vertex": 0, …}, "records": [{"vertex": 0}, {"half_edge": 20}],
///                   "message": "from half-edge 20 the rotation of vertex 0 reaches …"}]
/// }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MeshAudit {
    counts: MeshCounts,
    findings: Findings,
    report: Report,
    space: Vec<SpaceOutcome>,
}

/// Joins the faces of a mesh, validates the result, and counts.
///
/// The expectation is [`HalfEdgeMesh::expectation`], surfaces of any genus and with any borders, or that with further claims:
/// rules M1 … M8. If some faces cannot be joined, some of these rules cannot be checked, and the report says so.
///
/// `collect` limits the findings of each kind, and the violations, that are kept. All are counted; violations as [`Collect`]
/// says. Time and memory are linear in points and corners (expected, up to the inverse of Ackermann's function). It accepts every
/// mesh.
///
/// ```
/// use twinedge::validate::Collect;
/// use twinedge_meshes::{HalfEdgeMesh, IndexedMesh, Kind, audit};
///
/// // Two tetrahedra that touch at vertex 0.
/// let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 5, 4], [0, 4, 6], [4, 5, 6], [5, 0, 6]];
/// let mesh = IndexedMesh::from_faces(vec![[0.0; 3]; 7], faces)?;
/// let audit = audit(&mesh, &HalfEdgeMesh::expectation().closed().genus(0), Collect::All);
///
/// assert!(!audit.is_valid());
/// let finding = &audit.findings().list()[0];
/// assert_eq!(finding.kind(), Kind::NonManifoldVertex);
/// assert_eq!(
///     finding.to_string(),
///     "2 fans of faces meet at vertex 0 and share no edge there; one face of each: 0, 4"
/// );
/// println!("{audit}");
/// # #[cfg(feature = "serde")]
/// println!("{}", serde_json::to_string_pretty(&audit)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn audit(mesh: &IndexedMesh, expectation: &Expectation, collect: Collect) -> MeshAudit {
    audit_in_space(mesh, expectation, &[], collect)
}

/// Like [`audit`], and also checks rules about the coordinates of the points: M9 … M11.
///
/// In addition O(n log n + k) for k pairs of faces with overlapping boxes (M10), and O(n) per component that faces inwards (M11).
///
/// ```
/// use twinedge::validate::Collect;
/// use twinedge_meshes::{HalfEdgeMesh, IndexedMesh, SpaceRule, audit_in_space};
///
/// // A tetrahedron that is wound the wrong way round.
/// let points = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let mesh = IndexedMesh::from_faces(points, [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]])?;
/// let audit = audit_in_space(&mesh, &HalfEdgeMesh::expectation().closed(), &SpaceRule::ALL, Collect::All);
/// assert_eq!(audit.findings().total(), 1);
/// assert_eq!(audit.findings().list()[0].to_string(), "the closed component of face 0, of 4 faces, faces inwards");
/// # Ok::<(), twinedge_meshes::IndexedMeshError>(())
/// ```
#[must_use]
pub fn audit_in_space(
    mesh: &IndexedMesh,
    expectation: &Expectation,
    rules: &[SpaceRule],
    collect: Collect,
) -> MeshAudit {
    let (half_edges, mut findings) = HalfEdgeMesh::link(mesh, collect);
    let report = validate(&half_edges, expectation, collect);
    let counts = MeshCounts::new(&half_edges, &findings, &report);
    let space = match rules {
        [] => Vec::new(),
        rules => space::check(&half_edges, rules, &mut findings),
    };
    MeshAudit { counts, findings, report, space }
}

impl MeshAudit {
    /// Returns true if the mesh consists of surfaces and is as expected: no finding is a fault, the validator found no violation,
    /// and all requested rules were checked on all faces.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        let is_whole = self.space.iter().all(|outcome| outcome.left_out == 0);
        self.findings.is_faultless() && self.report.is_valid() && is_whole
    }

    /// Returns the rules: first the validator's, then the requested ones of M9 … M11.
    #[must_use]
    pub fn rules(&self) -> Vec<RuleLine> {
        let of_space = self.space.iter().map(|SpaceOutcome { rule, checked, left_out }| RuleLine {
            id: rule.id(),
            name: rule.name(),
            statement: rule.statement(),
            checked: *checked as u64,
            unit: rule.unit(),
            violations: self.findings.count(Kind::of(*rule)) as u64,
            unchecked: (*left_out > 0).then_some(Reason::NotConvex),
            left_out: (*left_out > 0).then_some(*left_out as u64),
        });
        RuleLine::of(&self.report).into_iter().chain(of_space).collect()
    }

    /// Returns the counts of the mesh.
    #[must_use]
    pub const fn counts(&self) -> &MeshCounts {
        &self.counts
    }

    /// Returns the faults of the list of faces.
    #[must_use]
    pub const fn findings(&self) -> &Findings {
        &self.findings
    }

    /// Returns the validator's report on the half-edges. Each half-edge has the number of its corner.
    #[must_use]
    pub const fn report(&self) -> &Report {
        &self.report
    }
}

impl MeshAudit {
    /// Returns the number of edges and vertices that keep faces apart.
    fn not_joined(&self) -> usize {
        self.edges_not_joined() + self.findings.count(Kind::NonManifoldVertex)
    }

    fn edges_not_joined(&self) -> usize {
        self.findings.count(Kind::NonManifoldEdge) + self.findings.count(Kind::FlippedFaces)
    }

    /// Returns the counts of the text form, in words. `None` is a count that could not be determined.
    #[must_use]
    pub fn count_lines(&self) -> [(&'static str, Option<isize>); 8] {
        let MeshCounts { vertices, edges, faces, components, borders, euler_characteristic, genus, .. } = self.counts;
        let known = |count: usize| Some(count.cast_signed());
        [
            ("vertices (V)", known(vertices)),
            ("edges (E)", known(edges)),
            ("edges not joined", known(self.edges_not_joined())),
            ("faces (F)", known(faces)),
            ("components of faces", known(components)),
            ("border loops", borders.and_then(known)),
            ("Euler characteristic", Some(euler_characteristic)),
            ("genus", genus.and_then(known)),
        ]
    }

    /// Returns sentences about violations that follow from the findings.
    #[must_use]
    pub fn remarks(&self) -> Vec<&'static str> {
        let violations = |rule| self.report.outcome(rule).map_or(0, |outcome| outcome.violations);
        let of_m4 = (violations(Rule::M4) > self.counts.border_edges as u64)
            .then_some("M4 counts the half-edges that could not be joined because of the findings above, too");
        let of_v2 = (self.not_joined() > 0 && violations(Rule::V2) > 0).then_some(
            "V2 is broken because of the findings above: where faces are not joined, the fan of a vertex falls apart",
        );
        of_m4.into_iter().chain(of_v2).collect()
    }
}

/// Findings come first, then the counts, the rules of the validator, and the verdict.
impl fmt::Display for MeshAudit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let listed: Vec<Diagnosis> = self.findings.list().iter().map(Into::into).collect();
        write_list(f, &listed, self.findings.total() as u64)?;
        if self.findings.total() > 0 {
            writeln!(f)?;
        }
        for (what, count) in self.count_lines() {
            let count = count.map_or_else(|| "unknown".to_owned(), |count| count.to_string());
            writeln!(f, "{what:20} {count:>12}")?;
        }
        write!(f, "{}", self.report)?;
        self.rules().iter().skip(self.report.outcomes().count()).try_for_each(|rule| writeln!(f, "{rule}"))?;
        self.remarks().iter().try_for_each(|remark| writeln!(f, "{remark}"))?;
        f.write_str(if self.is_valid() { "valid" } else { "not valid" })
    }
}
