//! The feature in question.

use super::names::find;
use super::source::Source;
use crate::output::plain;
use crate::status::Failure;
use twinedge_map::FeatureId;
use twinedge_report::Condition;

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
