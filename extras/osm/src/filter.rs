//! The selection of relations.

use std::fmt;
use std::str::FromStr;

/// Selects the relations that have every tag of a list. Text is `KEY=VALUE` or `KEY`, for any value, separated by commas.
///
/// ```
/// use twinedge_osm::TagFilter;
///
/// let counties: TagFilter = "boundary=administrative,admin_level=6".parse()?;
/// assert!(counties.accepts(&[("admin_level", "6"), ("boundary", "administrative"), ("name", "Kent")]));
/// assert!(!counties.accepts(&[("admin_level", "8"), ("boundary", "administrative")]));
/// assert!("postal_code".parse::<TagFilter>()?.accepts(&[("postal_code", "3011")]));
/// # Ok::<_, twinedge_osm::InvalidFilter>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TagFilter(Vec<(String, Option<String>)>);

/// The error of reading a [`TagFilter`]: a key is empty.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("tags are asked for as KEY=VALUE or KEY, separated by commas, and not as {0:?}")]
pub struct InvalidFilter(String);

impl TagFilter {
    /// Returns true if these tags include every selected one. O(tags · selected).
    #[must_use]
    pub fn accepts(&self, tags: &[(impl AsRef<str>, impl AsRef<str>)]) -> bool {
        self.0.iter().all(|(key, value)| {
            tags.iter().any(|(k, v)| k.as_ref() == key && value.as_ref().is_none_or(|value| v.as_ref() == value))
        })
    }
}

impl FromStr for TagFilter {
    type Err = InvalidFilter;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let tag = |tag: &str| {
            let (key, value) = tag.split_once('=').map_or((tag, None), |(key, value)| (key, Some(value)));
            let key = key.trim();
            if key.is_empty() {
                return Err(InvalidFilter(text.to_owned()));
            }
            Ok((key.to_owned(), value.map(|value| value.trim().to_owned())))
        };
        text.split(',').map(tag).collect::<Result<_, _>>().map(Self)
    }
}

impl fmt::Display for TagFilter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, (key, value)) in self.0.iter().enumerate() {
            let comma = if number == 0 { "" } else { "," };
            write!(f, "{comma}{key}")?;
            if let Some(value) = value {
                write!(f, "={value}")?;
            }
        }
        Ok(())
    }
}
