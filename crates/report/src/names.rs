//! Features by name.

use crate::imported::Imported;
use crate::words::plain;
use twinedge_diagnosis::FeatureName;
use twinedge_map::{FeatureId, PlanarMap};

/// Returns a feature's name, made safe for a terminal, or its number, counted from 0.
#[must_use]
pub fn label(map: &PlanarMap, feature: FeatureId) -> String {
    words(map.name(feature), feature.index())
}

fn words(name: Option<&str>, number: usize) -> String {
    name.map_or_else(|| format!("feature {number}"), plain)
}

/// Returns a feature's name, id and number.
#[must_use]
pub fn named(imported: &Imported, feature: FeatureId) -> FeatureName {
    numbered_name(imported, feature.index())
}

pub(crate) fn numbered_name(imported: &Imported, number: usize) -> FeatureName {
    let map: &PlanarMap = &imported.map;
    let id = imported.noted.ids.get(number).cloned().flatten();
    let name = map.feature(number).and_then(|feature| map.name(feature));
    let label = match (&id, name) {
        (Some(id), Some(name)) if name != id => format!("{} (id {})", plain(name), plain(id)),
        (Some(id), None) => format!("id {}", plain(id)),
        _ => words(name, number),
    };
    FeatureName { number, id, name: name.map(str::to_owned), label }
}

#[cfg(feature = "geodesic")]
pub(crate) fn all_named(imported: &Imported, features: impl IntoIterator<Item = u32>) -> Vec<FeatureName> {
    let ids = features.into_iter().filter_map(|feature| imported.map.feature(feature as usize));
    ids.map(|id| named(imported, id)).collect()
}
