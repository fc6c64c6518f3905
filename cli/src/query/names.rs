//! Features by name.

use super::source::Source;
use crate::output::counted;
use crate::status::Failure;
use twinedge_map::{FeatureId, PlanarMap};

const SUGGESTIONS: usize = 3;
/// The least similarity of a suggested name, from 0 to 1.
const SIMILAR: f64 = 0.75;

/// Finds the feature with this name, or with the number after a `#`.
pub(crate) fn find(asked: &Source, name: &str) -> Result<FeatureId, Failure> {
    let Source { input, map, .. } = asked;
    let named: Vec<FeatureId> = map.features().filter(|f| map.name(*f) == Some(name)).collect();
    let numbered = name.strip_prefix('#').and_then(|number| number.parse().ok());
    match (&named[..], numbered.and_then(|number: usize| map.features().nth(number))) {
        ([only], _) => Ok(*only),
        ([], Some(feature)) => Ok(feature),
        ([], None) => {
            if numbered.is_some() {
                let features = counted(map.features().count(), "feature");
                return Err(Failure(format!(
                    "{input}: no feature has the number {name}; there are {features}, counted from #0"
                )));
            }
            let like = similar(map, name);
            let hint = if !like.is_empty() {
                format!("; did you mean {}?", like.join(", "))
            } else if map.features().any(|f| map.name(f).is_none()) {
                format!("; those without a name are asked for by their numbers, from '#0' to '#{}'", last(map))
            } else {
                String::new()
            };
            Err(Failure(format!("{input}: no feature has the name {name}{hint}")))
        }
        (several, _) => {
            let numbers: Vec<String> = several.iter().map(|f| asked.hint(f.index())).collect();
            let numbers = numbers.join(", ");
            Err(Failure(format!("{input}: {} features have the name {name}; ask for one of {numbers}", several.len())))
        }
    }
}

fn last(map: &PlanarMap) -> usize {
    map.features().count().saturating_sub(1)
}

/// The names most like this one, the most similar first.
fn similar<'a>(map: &'a PlanarMap, name: &str) -> Vec<&'a str> {
    let name = name.to_lowercase();
    let mut scored: Vec<(f64, &str)> = map
        .features()
        .filter_map(|f| map.name(f))
        .map(|other| (strsim::jaro_winkler(&name, &other.to_lowercase()), other))
        .filter(|(score, _)| *score >= SIMILAR)
        .collect();
    scored.sort_by(|(a, x), (b, y)| b.total_cmp(a).then_with(|| x.cmp(y)));
    scored.dedup_by(|(_, x), (_, y)| x == y);
    scored.into_iter().take(SUGGESTIONS).map(|(_, other)| other).collect()
}
