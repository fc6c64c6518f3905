//! Attributes of an edited map: numbers, ids, and any objects of Python.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use slotmap::{Key as _, KeyData};
use std::fmt;
use std::sync::{Arc, Mutex};
use twinedge::dcel::{Attribute, Attributed, Edges, Faces, Policy, Value, Vertices};
use twinedge_map::PlanarMap;
use twinedge_map::edit::EditError;

/// The exception raised by the function of a policy.
pub(crate) type Raised = Arc<Mutex<Option<PyErr>>>;

/// A function that writes a value.
pub(crate) type Setting = Box<dyn FnOnce(&mut PlanarMap) -> Result<(), EditError>>;

/// An attribute of unknown type.
pub(crate) trait Column: Send + Sync {
    fn setting(&self, of: u64, value: Option<Bound<'_, PyAny>>) -> PyResult<Setting>;
    fn get(&self, py: Python<'_>, map: &PlanarMap, of: u64) -> PyResult<Option<Py<PyAny>>>;
    fn all(&self, py: Python<'_>, map: &PlanarMap) -> PyResult<Vec<(u64, Py<PyAny>)>>;
    fn find(&self, map: &PlanarMap, value: &Bound<'_, PyAny>) -> PyResult<Option<u64>>;
}

/// A value type that Python also has.
trait Told: Value {
    fn told(&self, py: Python<'_>) -> PyResult<Py<PyAny>>;
    fn read(value: &Bound<'_, PyAny>) -> PyResult<Self>;
}

/// Any object.
#[derive(Clone)]
struct Object(Arc<Py<PyAny>>);

impl fmt::Debug for Object {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&self.0, f)
    }
}

impl Told for Object {
    fn told(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        Ok(self.0.clone_ref(py))
    }

    fn read(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self(Arc::new(value.clone().unbind())))
    }
}

impl Told for f64 {
    fn told(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        Ok(self.into_pyobject(py)?.into_any().unbind())
    }

    fn read(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        value.extract()
    }
}

impl Told for u64 {
    fn told(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        Ok(self.into_pyobject(py)?.into_any().unbind())
    }

    fn read(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        value.extract()
    }
}

impl<K: Attributed, T: Told> Column for Attribute<K, T> {
    fn setting(&self, of: u64, value: Option<Bound<'_, PyAny>>) -> PyResult<Setting> {
        let (attribute, value) = (*self, value.map(|value| T::read(&value)).transpose()?);
        let key = KeyData::from_ffi(of).into();
        Ok(Box::new(move |map| {
            let had = match value {
                Some(value) => map.set_value(attribute, key, value),
                None => map.remove_value(attribute, key),
            };
            had.map(|_| ())
        }))
    }

    fn get(&self, py: Python<'_>, map: &PlanarMap, of: u64) -> PyResult<Option<Py<PyAny>>> {
        map.value(*self, KeyData::from_ffi(of).into()).map(|value| value.told(py)).transpose()
    }

    fn all(&self, py: Python<'_>, map: &PlanarMap) -> PyResult<Vec<(u64, Py<PyAny>)>> {
        let all = map.values(*self).into_iter().flatten();
        all.map(|(key, value)| Ok((key.data().as_ffi(), value.told(py)?))).collect()
    }

    fn find(&self, map: &PlanarMap, value: &Bound<'_, PyAny>) -> PyResult<Option<u64>> {
        Ok(map.find(*self, &T::read(value)?).map(|key| key.data().as_ffi()))
    }
}

/// A rule by its name, or a function.
enum Rule {
    Named(String),
    Call(Py<PyAny>),
}

impl Rule {
    fn new(rule: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(if rule.is_callable() { Self::Call(rule.clone().unbind()) } else { Self::Named(rule.extract()?) })
    }

    fn name(&self) -> &str {
        if let Self::Named(name) = self { name } else { "a function" }
    }
}

/// Calls a function of a policy. Keeps its exception, and refuses the edit.
fn call<'py, R: FromPyObjectOwned<'py>>(
    py: Python<'py>,
    function: &Py<PyAny>,
    arguments: impl pyo3::call::PyCallArgs<'py>,
    raised: &Raised,
) -> Result<R, &'static str> {
    let outcome = function.bind(py).call1(arguments).and_then(|value| value.extract::<R>().map_err(Into::into));
    outcome.map_err(|error| {
        if let Ok(mut raised) = raised.lock() {
            *raised = Some(error);
        }
        "its function raised an exception"
    })
}

fn unknown(what: &str, rule: &Rule, known: &str) -> PyErr {
    PyValueError::new_err(format!("{what}: {:?} is none of {known}", rule.name()))
}

/// A policy for objects.
fn of_objects<K: Attributed>(
    mut policy: Policy<K, Object>,
    split: Rule,
    merge: Rule,
    raised: &Raised,
) -> PyResult<Policy<K, Object>> {
    policy = match split {
        Rule::Call(function) => {
            let raised = raised.clone();
            policy.split_with(move |value: Object| {
                Python::attach(|py| {
                    let (kept, other): (Option<Py<PyAny>>, Option<Py<PyAny>>) =
                        call(py, &function, (value.0.clone_ref(py),), &raised)?;
                    Ok([kept, other].map(|part| part.map(|part| Object(Arc::new(part)))))
                })
            })
        }
        Rule::Named(name) if name == "keep" => policy,
        Rule::Named(name) if name == "copy" => policy.split_copy(),
        split @ Rule::Named(_) => {
            return Err(unknown(
                "split",
                &split,
                "keep, copy, share (edges, faces), between (vertices), or a function",
            ));
        }
    };
    Ok(match merge {
        Rule::Call(function) => {
            let raised = raised.clone();
            policy.merge_with(move |kept: Option<Object>, dropped| {
                Python::attach(|py| {
                    let [kept, dropped] = [kept, dropped].map(|value| value.map(|value| value.0.clone_ref(py)));
                    let merged: Option<Py<PyAny>> = call(py, &function, (kept, dropped), &raised)?;
                    Ok(merged.map(|value| Object(Arc::new(value))))
                })
            })
        }
        Rule::Named(name) if name == "equal" => {
            let raised = raised.clone();
            policy.merge_with(move |kept: Option<Object>, dropped| {
                Python::attach(|py| match (&kept, &dropped) {
                    (None, None) => Ok(None),
                    (Some(a), Some(b)) => match a.0.bind(py).eq(b.0.bind(py)) {
                        Ok(true) => Ok(kept),
                        Ok(false) => Err(DIFFER),
                        Err(error) => {
                            raised.lock().map_err(|_| DIFFER)?.replace(error);
                            Err(DIFFER)
                        }
                    },
                    _ => Err(DIFFER),
                })
            })
        }
        Rule::Named(name) if name == "keep" => policy,
        merge @ Rule::Named(_) => return Err(unknown("merge", &merge, "keep, equal, sum, or a function")),
    })
}

const DIFFER: &str = "the values of the merged records differ";

/// A policy for numbers, except for their distribution.
fn of_numbers<K: Attributed>(policy: Policy<K, f64>, split: &Rule, merge: &Rule) -> PyResult<Policy<K, f64>> {
    let policy = match split.name() {
        "keep" | "share" | "between" => policy,
        "copy" => policy.split_copy(),
        _ => {
            return Err(unknown(
                "split",
                split,
                "keep, copy, share (edges, faces) and between (vertices), for numbers",
            ));
        }
    };
    Ok(match merge.name() {
        "sum" => policy.merge_sum(),
        "equal" => policy.merge_equal(),
        "keep" => policy,
        _ => return Err(unknown("merge", merge, "keep, equal and sum, for numbers")),
    })
}

/// Adds an attribute to a map.
pub(crate) fn add(
    map: &mut PlanarMap,
    of: &str,
    split: &Bound<'_, PyAny>,
    merge: &Bound<'_, PyAny>,
    ids: Option<u64>,
    raised: Raised,
) -> PyResult<Box<dyn Column>> {
    let (split, merge) = (Rule::new(split)?, Rule::new(merge)?);
    let is_number = ["share", "between"].contains(&split.name()) || merge.name() == "sum";
    Ok(match (of, ids) {
        ("faces", Some(first)) => Box::new(map.add_attribute(Policy::of_faces().ids(first))),
        ("edges", Some(first)) => Box::new(map.add_attribute(Policy::of_edges().ids(first))),
        ("vertices", Some(first)) => Box::new(map.add_attribute(Policy::of_vertices().ids(first))),
        ("faces", None) if is_number && split.name() != "between" => {
            let policy: Policy<Faces, f64> = of_numbers(Policy::of_faces(), &split, &merge)?;
            Box::new(map.add_attribute(if split.name() == "share" { policy.split_share() } else { policy }))
        }
        ("edges", None) if is_number && split.name() != "between" => {
            let policy: Policy<Edges, f64> = of_numbers(Policy::of_edges(), &split, &merge)?;
            Box::new(map.add_attribute(if split.name() == "share" { policy.split_share() } else { policy }))
        }
        ("vertices", None) if is_number && split.name() != "share" => {
            let policy: Policy<Vertices, f64> = of_numbers(Policy::of_vertices(), &split, &merge)?;
            Box::new(map.add_attribute(if split.name() == "between" { policy.interpolate() } else { policy }))
        }
        ("faces", None) => Box::new(map.add_attribute(of_objects(Policy::of_faces(), split, merge, &raised)?)),
        ("edges", None) => Box::new(map.add_attribute(of_objects(Policy::of_edges(), split, merge, &raised)?)),
        ("vertices", None) => Box::new(map.add_attribute(of_objects(Policy::of_vertices(), split, merge, &raised)?)),
        _ => return Err(PyValueError::new_err(format!("of: {of:?} is none of faces, edges, vertices"))),
    })
}
