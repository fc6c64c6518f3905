//! The map and the feature in question.

use crate::output::{Failure, counted, plain};
use twinedge_map::{FeatureId, PlanarMap};
use twinedge_report::{Condition, Noted};

/// A map, the name of its input, and the notes on its features.
pub(crate) struct Source {
    pub(crate) input: String,
    pub(crate) map: PlanarMap,
    pub(crate) noted: Noted,
}

impl Source {
    /// Describes how to select a feature by its number, with its id, if it has one.
    pub(super) fn hint(&self, number: usize) -> String {
        match self.noted.ids.get(number).and_then(Option::as_deref) {
            Some(id) => format!("'#{number}' (id {})", plain(id)),
            None => format!("'#{number}'"),
        }
    }
}

/// A feature, by its name, its id or a column.
#[derive(Debug, clap::Args)]
#[group(multiple = false)]
pub(super) struct Which {
    /// The feature, by its name, or by # and its number, counted from 0.
    name: Option<String>,

    /// The feature, by its id in the file.
    #[arg(long, value_name = "ID")]
    id: Option<String>,

    /// The feature that has this value in a column (property), as in `--where owner=Meier`.
    #[arg(long = "where", value_name = "COLUMN=VALUE")]
    condition: Option<Condition>,
}

impl Which {
    /// Returns the condition to note while the map is read.
    pub(super) const fn condition(&self) -> Option<&Condition> {
        self.condition.as_ref()
    }

    /// Returns true if a feature is selected.
    pub(super) const fn is_given(&self) -> bool {
        self.name.is_some() || self.id.is_some() || self.condition.is_some()
    }

    /// Returns the only feature that matches.
    pub(super) fn find(&self, asked: &Source) -> Result<FeatureId, Failure> {
        match self {
            Self { name: Some(name), .. } => find(asked, name),
            Self { id: Some(id), .. } => {
                let ids = asked.noted.ids.iter().enumerate();
                let found: Vec<usize> =
                    ids.filter(|(_, other)| other.as_ref() == Some(id)).map(|(number, _)| number).collect();
                only(asked, &found, &format!("the id {}", plain(id)))
            }
            Self { condition: Some(Condition { column, value }), .. } => {
                only(asked, &asked.noted.matching, &format!("{} = {}", plain(column), plain(value)))
            }
            _ => Err(Failure("say which feature: NAME, --id or --where".to_owned())),
        }
    }
}

/// Returns the only one of these features; it is an error if there are several.
fn only(asked: &Source, found: &[usize], what: &str) -> Result<FeatureId, Failure> {
    let Source { input, map, .. } = asked;
    match *found {
        [number] => map.feature(number).ok_or_else(|| Failure(format!("{input}: no feature has {what}"))),
        [] => Err(Failure(format!("{input}: no feature has {what}"))),
        _ => {
            let numbers: Vec<String> = found.iter().map(|number| asked.hint(*number)).collect();
            Err(Failure(format!(
                "{input}: {} features have {what}; ask for one of {}",
                found.len(),
                numbers.join(", ")
            )))
        }
    }
}

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
