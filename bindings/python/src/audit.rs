//! Audits of maps and meshes, by the crate that the program uses.

use crate::source::{Failure, Source};
use crate::work::within;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::time::Instant;
use twinedge_meshes::IndexedMesh;
use twinedge_report::{Accepted, Audited, Compared, InputKind, Options, audit as judge, audit_mesh};

/// Reads options from JSON, and a list of accepted findings. With such a list all findings are listed, since a finding that is not listed could not
/// be accepted.
pub(crate) fn options(asked: &str, accept: Option<&str>) -> Result<Options, Failure> {
    let accepted = accept.map(Accepted::read).transpose();
    let accepted = accepted.map_err(|error| Failure::Value(format!("accept: {error}")))?;
    let options = Options::from_json(serde_json::from_str(asked).map_err(Failure::value)?).map_err(Failure::value)?;
    let list = if accepted.is_some() { Some(usize::MAX) } else { options.list };
    Ok(Options { list, accepted, ..options })
}

/// A report as JSON; its findings as a layer of GeoJSON with the warnings of the layer, if they have places; and its
/// findings as a list of accepted ones.
pub(crate) type Told = (String, Option<String>, Vec<String>, String);

/// Returns the forms of a report. Newly accepted findings have no reason and no date yet.
pub(crate) fn told(audited: &Audited, accepted: Option<&Accepted>) -> Result<Told, Failure> {
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).map_err(Failure::value);
    let (layer, warnings) = audited.findings().ok().unzip();
    let list = audited.accept_all(accepted, "", "")?;
    Ok((text(audited.json()?)?, layer.map(text).transpose()?, warnings.unwrap_or_default(), text(list)?))
}

/// Judges a map or a mesh. Returns the report, and for a mesh the positions at which the corners of each face begin. If
/// time runs out, the report says so.
#[pyfunction]
pub(crate) fn audit<'py>(
    py: Python<'py>,
    source: Source,
    asked: &str,
    accept: Option<&str>,
    timeout: Option<f64>,
) -> PyResult<(Told, Option<Bound<'py, PyArray1<u32>>>)> {
    let options = options(asked, accept)?;
    let (name, asked) = (source.name().to_owned(), options.clone());
    let start = Instant::now();
    let work = move || {
        let mut audited = open_and_judge(source, &options)?;
        audited.took(start.elapsed().as_secs_f64() * 1000.0);
        let offsets = audited.mesh().map(|mesh| mesh.offsets().to_vec());
        Ok::<_, Failure>((told(&audited, options.accepted.as_ref())?, offsets))
    };
    let (told, offsets) = if let Some(outcome) = within(py, timeout, work)? {
        outcome?
    } else {
        let why = format!("time was up after {} s", timeout.unwrap_or_default());
        (told(&Audited::unfinished(&name, InputKind::Map, &asked, &why), None)?, None)
    };
    Ok((told, offsets.map(|offsets| offsets.into_pyarray(py))))
}

fn open_and_judge(source: Source, options: &Options) -> Result<Audited, Failure> {
    let is_in_memory = source.is_in_memory();
    let (mut input, judged) = source.open()?;
    let name = input.name.clone();
    let left_out = input.not_finite.len();
    let named = |error: twinedge_report::Error| match Failure::from(error) {
        Failure::Os(why) => Failure::Os(format!("{name}: {why}")),
        Failure::Value(why) => Failure::Value(format!("{name}: {why}")),
    };
    let kind = if is_in_memory { InputKind::Map } else { InputKind::of(false, false, &mut input).map_err(named)? };
    if !matches!(kind, InputKind::Map | InputKind::Mesh(_)) {
        return Err(Failure::Value(format!("{name}: this is {}, which the program audits", kind.words())));
    }
    let mut audited = judge(input, kind, options, &mut |_| {}).map_err(named)?;
    if let Some(judged) = judged {
        audited.judged(judged);
    }
    match left_out {
        0 => {}
        1 => audited.doubt("1 feature has a coordinate that is NaN or infinite, and was left out"),
        n => audited.doubt(&format!("{n} features have a coordinate that is NaN or infinite, and were left out")),
    }
    Ok(audited)
}

/// Joins faces at their edges and judges the result. Points, if there are any, have three coordinates each; corners are vertices, face by face;
/// `offsets` has the start of each face. The arrays are copied before the lock is released.
#[pyfunction]
pub(crate) fn audit_faces(
    py: Python<'_>,
    vertices: usize,
    points: Option<PyReadonlyArray2<'_, f64>>,
    corners: PyReadonlyArray1<'_, u32>,
    offsets: PyReadonlyArray1<'_, u32>,
    asked: &str,
) -> PyResult<Told> {
    let (corners, offsets) = (corners.as_array().to_vec(), offsets.as_array().to_vec());
    let points = points.map(|points| points.as_array().rows().into_iter().map(|p| [p[0], p[1], p[2]]).collect());
    let options = options(asked, None)?;
    let work = move || {
        // Without points only their number counts.
        let points = points.unwrap_or_else(|| vec![[0.0; 3]; vertices]);
        let mesh = IndexedMesh::new(points, corners, offsets).map_err(Failure::value)?;
        told(&audit_mesh("faces", mesh, &options)?, None)
    };
    let outcome = within(py, None, work)?.ok_or_else(|| PyRuntimeError::new_err("time was up"))?;
    Ok(outcome?)
}

/// Three lists of ids, and a number.
type Difference = (Vec<String>, Vec<String>, Vec<String>, usize);

/// The ids of the findings only in the newer of two reports, only in the older one, and in both with other measures,
/// and the number of all others.
#[pyfunction]
pub(crate) fn diff(old: &str, new: &str) -> PyResult<Difference> {
    let read = |name: &str, text: &str| -> PyResult<Compared> {
        let failed = |error: &dyn std::fmt::Display| PyValueError::new_err(format!("{name}: {error}"));
        let report = serde_json::from_str(text).map_err(|error| failed(&error))?;
        Compared::new(&report).map_err(|error| failed(&error))
    };
    let found = read("old", old)?.difference(&read("new", new)?);
    Ok((found.new, found.gone, found.changed, found.same))
}
