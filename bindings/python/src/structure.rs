//! The validator over arrays.

use crate::arrays::{Array, Atomic, Cells};
use crate::expectation::Claims;
use numpy::{PyArrayDescrMethods as _, PyUntypedArray, PyUntypedArrayMethods as _};
use pyo3::exceptions::{PyMemoryError, PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::cell::{Cell, RefCell};
use twinedge::validate::{Collect, Expectation, Link, Report, View, Violation};
use twinedge::{delegate_view, validate as rules};
use twinedge_columns::{Columns, OnView};

/// The number of half-edges to walk between two checks for signals.
const BETWEEN_SIGNALS: u32 = 1 << 18;

/// A view that ends a validation when the interpreter has a pending signal that raises, such as Ctrl-C: all cycles then
/// end.
struct Interruptible<V> {
    view: V,
    walked: Cell<u32>,
    raised: RefCell<Option<PyErr>>,
}

impl<V: View> Interruptible<V> {
    const fn new(view: V) -> Self {
        Self { view, walked: Cell::new(0), raised: RefCell::new(None) }
    }

    #[cold]
    fn look(&self) {
        self.walked.set(0);
        if self.raised.borrow().is_none()
            && let Err(error) = Python::attach(|py| py.check_signals())
        {
            self.raised.replace(Some(error));
        }
        if self.raised.borrow().is_some() {
            // Look again at the next half-edge.
            self.walked.set(BETWEEN_SIGNALS);
        }
    }
}

impl<V: View> View for Interruptible<V> {
    delegate_view!(|this| &this.view; except next);

    fn next(&self, half_edge: usize) -> Link {
        let walked = self.walked.get();
        self.walked.set(walked + 1);
        if walked >= BETWEEN_SIGNALS {
            self.look();
            if self.walked.get() > 0 {
                return None;
            }
        }
        self.view.next(half_edge)
    }
}

/// The names of the columns of half-edges, and of vertices and faces.
const NAMES: [&str; 8] = ["origin", "target", "twin", "next", "prev", "face", "leaving", "face_half_edge"];

/// Validates a structure whose links are arrays: `columns` has an array or none for each name, all of one type.
/// Unsigned types are read as signed ones, so that the validator is compiled for two types.
#[pyfunction]
pub(crate) fn validate(
    py: Python<'_>,
    columns: &Bound<'_, PyDict>,
    vertices: Option<usize>,
    faces: Option<usize>,
    asked: Claims,
) -> PyResult<String> {
    let next = columns.get_item("next")?.ok_or_else(|| PyTypeError::new_err("next: missing"))?;
    let next = next.cast::<PyUntypedArray>().map_err(|_| PyTypeError::new_err("next: expected an array"))?;
    let dtype = next.dtype();
    let report = if dtype.is_equiv_to(&numpy::dtype::<i64>(py)) {
        of_type::<i64>(py, columns, vertices, faces, &asked)
    } else if dtype.is_equiv_to(&numpy::dtype::<i32>(py)) {
        of_type::<i32>(py, columns, vertices, faces, &asked)
    } else {
        return Err(PyTypeError::new_err(format!("next: dtype {dtype} is no integer of 32 or 64 bits with a sign")));
    }?;
    serde_json::to_string(&report).map_err(|error| PyRuntimeError::new_err(error.to_string()))
}

fn of_type<T: Atomic>(
    py: Python<'_>,
    columns: &Bound<'_, PyDict>,
    vertices: Option<usize>,
    faces: Option<usize>,
    asked: &Claims,
) -> PyResult<Report> {
    let mut arrays = Vec::new();
    for name in NAMES {
        let array = columns.get_item(name)?.filter(|array| !array.is_none());
        arrays.push(array.map(|array| Array::<T>::new(name, &array)).transpose()?);
    }
    let cells =
        arrays.iter().map(|array| array.as_ref().map(Array::cells).transpose()).collect::<PyResult<Vec<_>>>()?;
    let expectation = asked.of_columns()?;
    let (list, cells) = (Collect::AtMost(asked.list()), &cells[..]);
    py.detach(move || {
        let before: Vec<_> = cells.iter().map(|cells| cells.map(|cells| cells.sum())).collect();
        let report = judge(cells, vertices, faces, expectation, list)?;
        if cells.iter().map(|cells| cells.map(|cells| cells.sum())).ne(before) {
            return Err(PyRuntimeError::new_err("an array changed while it was validated"));
        }
        Ok(report)
    })
}

/// Returns the report of the structure, or the raised exception.
fn judge<T: Atomic>(
    cells: &[Option<Cells<'_, T>>],
    vertices: Option<usize>,
    faces: Option<usize>,
    expectation: Expectation,
    collect: Collect,
) -> PyResult<Report> {
    let column = |i: usize| cells[i].map(|cells| cells.column()).transpose();
    let [origin, target, twin, next, prev, face, leaving, face_half_edge] =
        [column(0)?, column(1)?, column(2)?, column(3)?, column(4)?, column(5)?, column(6)?, column(7)?];
    let wrong = |error: twinedge_columns::ColumnsError| PyValueError::new_err(error.to_string());
    let next = next.ok_or_else(|| PyTypeError::new_err("next: missing"))?;
    let ((Some(ends), None) | (None, Some(ends))) = (origin, target) else {
        return Err(PyTypeError::new_err("give either origin or target"));
    };
    // A link beyond the end dangles, and must not raise the number of records.
    let slots = |column: twinedge_columns::Column<'_, T::As>| column.slots().min(next.len());
    let vertices = vertices.or_else(|| leaving.map(|l| l.len())).unwrap_or_else(|| slots(ends));
    let mut columns = Columns::paired(vertices, ends, next).map_err(|error| {
        // The column has one of two names.
        let name = if origin.is_some() { "origin" } else { "target" };
        PyValueError::new_err(error.to_string().replacen("`origin`", &format!("`{name}`"), 1))
    })?;
    if let Some(twin) = twin {
        columns = Columns::new(vertices, ends, twin, next).map_err(wrong)?;
    }
    if target.is_some() {
        columns = columns.by_target();
    }
    if let Some(prev) = prev {
        columns = columns.with_prev(prev).map_err(wrong)?;
    }
    if let Some(face) = face {
        let faces = faces.or_else(|| face_half_edge.map(|f| f.len())).unwrap_or_else(|| slots(face));
        columns = columns.with_faces(faces, face).map_err(wrong)?;
    }
    if let Some(leaving) = leaving {
        columns = columns.with_leaving(leaving).map_err(wrong)?;
    }
    if let Some(kept) = face_half_edge {
        columns = columns.with_outer_half_edge(kept).map_err(wrong)?;
    }
    let memory = || PyMemoryError::new_err("not enough memory, or more than 4,294,967,294 records of a kind");
    columns.with_view(Run(expectation, collect)).ok_or_else(memory)?
}

/// Validates, until it is interrupted.
struct Run(Expectation, Collect);

impl OnView for Run {
    type Output = PyResult<Report>;

    fn on<V: View>(self, view: V) -> PyResult<Report> {
        let view = Interruptible::new(view);
        let report = rules::validate(&view, &self.0, self.1);
        match view.raised.into_inner() {
            None => Ok(report),
            Some(error) => Err(error),
        }
    }
}

/// Returns the usual cause and the remedy of a violation, as an object with its `kind` and `fields`.
#[pyfunction]
pub(crate) fn explain(violation: &str) -> PyResult<(&'static str, &'static str)> {
    let violation: Violation =
        serde_json::from_str(violation).map_err(|error| PyValueError::new_err(error.to_string()))?;
    Ok((violation.cause(), violation.remedy()))
}
