//! Features by name.

use crate::imported::Imported;
use crate::words::plain;
use twinedge::map::{FeatureId, PlanarMap};
use twinedge_formats::diagnosis::FeatureName;

/// The name of a feature, fit for a terminal, or its number, counted from 0.
#[must_use]
pub fn label(map: &PlanarMap, feature: FeatureId) -> String {
    map.name(feature).map_or_else(|| format!("feature {}", feature.index()), plain)
}

/// The name, the id and the number of a feature.
#[must_use]
pub fn named(imported: &Imported, feature: FeatureId) -> FeatureName {
    let map: &PlanarMap = &imported.map;
    let id = imported.noted.ids.get(feature.index()).cloned().flatten();
    let label = match &id {
        Some(id) if map.name(feature).is_some_and(|name| name != id) => {
            format!("{} (id {})", label(map, feature), plain(id))
        }
        Some(id) if map.name(feature).is_none() => format!("id {}", plain(id)),
        _ => label(map, feature),
    };
    FeatureName { number: feature.index(), id, name: map.name(feature).map(str::to_owned), label }
}

/// The names, ids and numbers of features.
pub(crate) fn all_named(imported: &Imported, features: impl IntoIterator<Item = u32>) -> Vec<FeatureName> {
    let ids = features.into_iter().filter_map(|feature| imported.map.feature(feature as usize));
    ids.map(|id| named(imported, id)).collect()
}
