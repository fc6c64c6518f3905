//! The changes that lead from one map to another.

use super::Diff;
use super::error::DiffError;
use super::ids::{Ids, Index};
use super::record::{Change, Record};
use crate::PlanarMap;

/// Compares two maps by the ids of their records, and returns the changes that lead from the first to the second. O(n log n).
///
/// # Errors
/// [`DiffError`]: a record has no id, or shares its id with another record; or the second map lacks features of the first.
pub fn diff(a: &PlanarMap, b: &PlanarMap, ids: &Ids) -> Result<Diff, DiffError> {
    let (old, new) = (Index::new(a, ids)?, Index::new(b, ids)?);
    let features = a.features().count();
    let mut changes = Vec::new();
    for (i, feature) in a.features().enumerate() {
        let [was_there, is_there] = [a, b].map(|map| map.present(feature).is_ok());
        match b.feature(i) {
            Some(same) if was_there == is_there && a.name(feature) == b.name(same) => {}
            // The feature keeps its number but loses its name.
            Some(_) if was_there && !is_there => changes.push((Record::Feature(i), Change::Dropped)),
            _ => return Err(DiffError::Features(i)),
        }
    }
    for record in old.records().filter(|record| new.key(b, *record).is_none()) {
        changes.push((record, Change::Dropped));
    }
    for record in new.records() {
        let is_old = old.key(a, record).is_some();
        let change = match record {
            Record::Vertex(v) => {
                let to = b[new.vertices[&v]];
                let from = old.vertices.get(&v).map(|v| a[*v]);
                match from {
                    None => Some(Change::Added(to)),
                    Some(from) => (from != to).then_some(Change::Moved { from, to }),
                }
            }
            Record::Edge(..) => (!is_old).then_some(Change::Drawn),
            Record::Face(f) => {
                let outline = |map: &PlanarMap, index: &Index| {
                    index.faces.get(&f).and_then(|f| map.dcel().face(*f).ok()).map(|f| index.outline(f))
                };
                let outlines = (outline(a, &old), outline(b, &new));
                match outlines {
                    (None, Some(to)) => Some(Change::Made(to)),
                    (Some(from), Some(to)) if from != to => Some(Change::Reshaped(to)),
                    _ => None,
                }
            }
            Record::Unbounded | Record::Feature(_) => None,
        };
        changes.extend(change.map(|change| (record, change)));
        let (from, to) = (old.features(a, record), new.features(b, record));
        if from != to {
            changes.push((record, Change::Features { from, to }));
        }
        for column in ids.values.iter().filter(|column| column.kind == record.kind()) {
            let value = |map: &PlanarMap, index: &Index| (column.get)(map, index.key(map, record)?);
            let (from, to) = (value(a, &old), value(b, &new));
            if from != to {
                changes.push((record, Change::Value { name: column.name.clone(), from, to }));
            }
        }
    }
    let names = b.features().skip(features).map(|feature| b.name(feature).map(str::to_owned)).collect();
    Ok(Diff { features, names, changes }.in_order())
}
