//! The column in which parts name their parents.

use std::str::FromStr;

/// The column in which parts name their parents, and the column with this value in the parents. By default, that is the column of the same name in
/// the other layer, or else the ids, or else the names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParentColumn {
    /// The column of the parts.
    pub column: String,
    /// The column of the parents.
    pub key: Option<String>,
}

impl FromStr for ParentColumn {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (column, key) = text.split_once('=').map_or((text, None), |(column, key)| (column, Some(key)));
        if column.is_empty() || key == Some("") {
            return Err("neither COLUMN nor COLUMN=KEY");
        }
        Ok(Self { column: column.to_owned(), key: key.map(str::to_owned) })
    }
}

impl ParentColumn {
    pub(crate) fn columns(&self, has_other: bool) -> Vec<String> {
        let key = self.key.iter().filter(|_| !has_other);
        std::iter::once(&self.column).chain(key).cloned().collect()
    }
}
