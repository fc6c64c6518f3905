//! Audits of maps: GeoJSON and WKT.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use serde::Serialize;
use serde_json::json;
use std::collections::BTreeSet;
use twinedge::algorithm::coverage::{self, Coverage, CoverageRule, Defect, Limits, check, defects, mismatches};
use twinedge::dcel::{Boundary, Face, Vertex};
use twinedge::geometry::noding::Snap;
use twinedge::io::{Format, ReadError, read};
use twinedge::map::{BuildError, Builder, FeatureId, Noding, PlanarMap};
use twinedge::validate::{Collect, Expectation, Record, Violation, places, validate_embedding};
use twinedge_formats::diagnosis::Flaw;

/// The number of defects of each kind that are listed of a feature.
const DEFECTS: usize = 100;

/// An error: no map can be read or built.
struct Refusal(String);

impl From<ReadError> for Refusal {
    fn from(error: ReadError) -> Self {
        Self(error.to_string())
    }
}

/// A finding beside the rules of the validator.
#[derive(Serialize)]
struct Finding {
    rule: &'static str,
    kind: &'static str,
    features: Vec<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    area: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    width: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    length: Option<f64>,
    /// The defects of a feature that is not valid by the rules of the OGC.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    defects: Vec<Flaw>,
    /// The vertices that a mismatch is about.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    missing: Vec<MissingVertex>,
    message: String,
}

/// A vertex that the border of a feature lacks.
#[derive(Serialize)]
struct MissingVertex {
    at: [f64; 2],
    feature: usize,
}

/// The options of C1 … C7.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Options {
    coverage: bool,
    gap_width: Option<f64>,
    lake_width: Option<f64>,
    accepted_gaps: Vec<[f64; 2]>,
    sliver_area: Option<f64>,
    snap: Option<f64>,
    list: usize,
    /// The features that are left out, in order, as a coordinate is not finite.
    not_finite: Vec<usize>,
}

/// The report as JSON, and the name of each feature.
type Verdict = (String, Vec<Option<String>>);

/// Builds the planar map of a text and judges it. A `snap` of 0 chooses the grid.
#[pyfunction]
pub(crate) fn audit_map(
    py: Python<'_>,
    text: PyBackedBytes,
    format: Option<&str>,
    asked: Options,
) -> PyResult<Verdict> {
    let format = match format {
        None => None,
        Some("geojson") => Some(Format::GeoJson),
        Some("wkt") => Some(Format::Wkt),
        Some(other) => return Err(PyValueError::new_err(format!("format: there is none named {other:?}"))),
    };
    py.detach(move || audit(&text, format, &asked)).map_err(|Refusal(why)| PyValueError::new_err(why))
}

fn audit(text: &[u8], format: Option<Format>, asked: &Options) -> Result<Verdict, Refusal> {
    let mut builder = Builder::new();
    let mut invalid: Vec<(usize, Vec<Defect>)> = Vec::new();
    let (mut names, mut without_geometry) = (Vec::new(), Vec::new());
    read(text, format, |feature| {
        let (number, found) = (names.len(), defects(&feature.shapes));
        let is_finite = asked.not_finite.binary_search(&number).is_err();
        if !found.is_empty() || !is_finite {
            invalid.push((number, found));
        } else if feature.shapes.is_empty() {
            without_geometry.push(number);
        }
        names.push(feature.name.clone().or_else(|| feature.id.clone()));
        builder.feature(&feature).map(drop).map_err(|error: BuildError| Refusal(error.to_string()))
    })?;
    let noding = match asked.snap {
        None => Noding::None,
        Some(size) if size > 0.0 && size.is_finite() => Noding::Snap(Snap::Size(size)),
        Some(_) => Noding::Snap(Snap::Auto),
    };
    let kept = builder.clone();
    let map = builder.build_with(noding).map_err(|error| Refusal(error.to_string()))?;
    let report = validate_embedding(&map, &Expectation::plane(), Collect::AtMost(asked.list));
    let mut document = serde_json::to_value(&report).map_err(|error| Refusal(error.to_string()))?;
    let listed = document["violations"].as_array_mut().into_iter().flatten();
    for (object, violation) in listed.zip(report.violations()) {
        let at: Vec<[f64; 2]> = places(&map, violation).into_iter().map(Into::into).collect();
        object["at"] = json!(at);
        object["features"] = json!(features(&map, violation));
    }
    let limits = Limits {
        gap_width: asked.gap_width,
        lake_width: asked.lake_width,
        accepted_gaps: asked.accepted_gaps.iter().copied().map(Into::into).collect(),
        sliver_area: asked.sliver_area,
        ..Limits::default()
    };
    // The faces that features cover are known on a plane map only: borders that cross are cut first.
    let refused = |error: &dyn ToString| Refusal(error.to_string());
    // Of a map that is plane without noding, borders meet at vertices only.
    let unmatched = if map.is_plane() && noding == Noding::None { Vec::new() } else { kept.unmatched() };
    let map = if map.is_plane() {
        map
    } else {
        kept.build_with(Noding::Snap(Snap::Auto)).map_err(|error| refused(&error))?
    };
    let coverage = check(&map, &limits).map_err(|error| refused(&error))?;
    let mismatches = mismatches(&map, &unmatched).map_err(|error| refused(&error))?;
    let found = findings(&coverage, &invalid, &mismatches);
    if asked.coverage && !found.is_empty() || !asked.not_finite.is_empty() {
        document["valid"] = json!(false);
    }
    document["finding_count"] = json!(found.len());
    document["findings"] = json!(found.into_iter().take(asked.list).collect::<Vec<_>>());
    document["wider_gaps"] = json!(coverage.wider_gaps.len());
    document["accepted_gaps"] = json!(coverage.accepted_gaps.len());
    document["features"] = json!(names.len());
    document["without_geometry"] = json!(without_geometry);
    Ok((document.to_string(), names))
}

/// The numbers of the features that a violation touches.
fn features(map: &PlanarMap, violation: &Violation) -> BTreeSet<usize> {
    let dcel = map.dcel();
    let mut found = BTreeSet::new();
    for record in violation.records().into_iter().flatten() {
        let half_edges: Vec<_> = match record {
            Record::HalfEdge(h) => dcel.half_edge_at(h).into_iter().collect(),
            Record::Vertex(v) => dcel.vertex_at(v).into_iter().flat_map(Vertex::rotation).collect(),
            Record::Boundary(b) => dcel.boundary_at(b).and_then(Boundary::start).into_iter().collect(),
            Record::Face(f) => {
                let face = dcel.face_at(f).map(Face::key);
                found.extend(face.and_then(|f| map.features_of(f).ok()).into_iter().flatten().map(FeatureId::index));
                Vec::new()
            }
        };
        for h in half_edges {
            found.extend(map.features_along(h.key()).into_iter().flatten().map(FeatureId::index));
        }
    }
    found
}

/// Returns the findings of C1 … C7, in order.
fn findings(coverage: &Coverage, invalid: &[(usize, Vec<Defect>)], mismatches: &[coverage::Finding]) -> Vec<Finding> {
    let of_map = coverage.findings.iter().map(|finding| {
        let features: Vec<usize> = finding.features.iter().map(|feature| feature.index()).collect();
        let (name, area, width) = (finding.rule.name(), finding.area, finding.width);
        Finding {
            rule: finding.rule.id(),
            kind: finding.rule.name(),
            message: format!("{name} of features {features:?}, area {area}, mean width {width}"),
            features,
            at: Some(finding.at.into()),
            area: Some(area),
            width: Some(width),
            length: Some(finding.length),
            defects: Vec::new(),
            missing: Vec::new(),
        }
    });
    let invalid = invalid.iter().map(|(feature, defects)| not_valid(*feature, defects));
    of_map.chain(invalid).chain(mismatches.iter().map(mismatch)).collect()
}

/// Borders that lack vertices of each other.
fn mismatch(finding: &coverage::Finding) -> Finding {
    let features: Vec<usize> = finding.features.iter().map(|feature| feature.index()).collect();
    let count = finding.missing.len();
    let vertices = if count == 1 { "1 vertex".to_owned() } else { format!("{count} vertices") };
    Finding {
        rule: finding.rule.id(),
        kind: finding.rule.name(),
        message: format!("{vertices} missing where the borders of features {features:?} meet"),
        features,
        at: Some(finding.at.into()),
        area: None,
        width: None,
        length: Some(finding.length),
        defects: Vec::new(),
        missing: finding
            .missing
            .iter()
            .map(|vertex| MissingVertex { at: vertex.at.into(), feature: vertex.feature.index() })
            .collect(),
    }
}

/// A feature that is not valid by the rules of the OGC. Without defects, a coordinate is not finite.
fn not_valid(feature: usize, defects: &[Defect]) -> Finding {
    // They are sorted by kind.
    let defects_of_kind = || defects.chunk_by(|a, b| a.kind == b.kind);
    let reasons: Vec<String> = defects_of_kind().map(|kind| kind[0].kind.to_string()).collect();
    let why = if reasons.is_empty() {
        "a coordinate is NaN or infinite; it is left out".to_owned()
    } else {
        reasons.join(", ")
    };
    let flaw =
        |one: &Defect| Flaw { reason: one.kind.to_string(), at: one.at.into(), shape: one.shape, ring: one.ring };
    Finding {
        rule: CoverageRule::Validity.id(),
        kind: CoverageRule::Validity.name(),
        features: vec![feature],
        at: defects.first().map(|defect| defect.at.into()),
        area: None,
        width: None,
        length: None,
        defects: defects_of_kind().flat_map(|kind| kind.iter().take(DEFECTS)).map(flaw).collect(),
        missing: Vec::new(),
        message: format!("feature {feature} is not valid: {why}"),
    }
}
