//! Audits of meshes: lists of faces, and mesh files.

use crate::expectation::Claims;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::{PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::path::PathBuf;
use twinedge::validate::Collect;
use twinedge_formats::mesh::{self, HalfEdgeMesh, IndexedMesh, audit};

fn report(mesh: &IndexedMesh, asked: &Claims) -> Result<String, PyErr> {
    let audit = audit(mesh, &asked.asking(HalfEdgeMesh::expectation()), Collect::AtMost(asked.list()));
    serde_json::to_string(&audit).map_err(|error| PyRuntimeError::new_err(error.to_string()))
}

/// Joins faces at their edges and judges the result. Corners are vertices, face by face; `offsets` says where each begins. The
/// arrays are copied before the lock is released.
#[pyfunction]
pub(crate) fn audit_faces(
    py: Python<'_>,
    points: PyReadonlyArray2<'_, f64>,
    corners: PyReadonlyArray1<'_, u32>,
    offsets: PyReadonlyArray1<'_, u32>,
    asked: Claims,
) -> PyResult<String> {
    let points: Vec<[f64; 3]> = points.as_array().rows().into_iter().map(|row| [row[0], row[1], row[2]]).collect();
    let (corners, offsets) = (corners.as_array().to_vec(), offsets.as_array().to_vec());
    py.detach(move || {
        let mesh =
            IndexedMesh::new(points, corners, offsets).map_err(|error| PyValueError::new_err(error.to_string()))?;
        report(&mesh, &asked)
    })
}

/// Reads a mesh file and judges it: the report as JSON, and where the corners of each face begin.
#[pyfunction]
pub(crate) fn audit_mesh(py: Python<'_>, path: PathBuf, asked: Claims) -> PyResult<(String, Bound<'_, PyArray1<u32>>)> {
    let (text, offsets) = py.detach(move || {
        let file = mesh::read_path(&path).map_err(|error| {
            let text = format!("{}: {error}", path.display());
            if path.exists() { PyValueError::new_err(text) } else { PyOSError::new_err(text) }
        })?;
        Ok::<_, PyErr>((report(&file.mesh, &asked)?, file.mesh.offsets().to_vec()))
    })?;
    Ok((text, offsets.into_pyarray(py)))
}
