//! The properties of a feature, while it is read.

/// The properties (attributes) of a feature: values by name of column. Empty for formats without attributes.
///
/// They are available while a feature is read ([`read_with_properties`](super::read_with_properties)) and are not kept.
///
/// ```
/// use twinedge_formats::io;
/// use twinedge_formats::io::Format;
///
/// let text = r#"{"type": "Feature", "properties": {"area": 12.5, "owner": "Meier"}, "geometry": null}"#;
/// io::read_with_properties(text.as_bytes(), None, |_, properties| {
///     assert_eq!(properties.get("owner").as_deref(), Some("Meier"));
///     assert_eq!(properties.get("area").as_deref(), Some("12.5"));
///     assert_eq!(properties.get("zone"), None);
///     assert_eq!(properties.columns().collect::<Vec<_>>(), ["area", "owner"]);
///     Ok::<_, io::ReadError>(())
/// })?;
/// # Ok::<_, io::ReadError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Properties {
    pub(super) object: ::geojson::JsonObject,
}

impl Properties {
    /// Returns the value in a column, as text: a string as it is, a number or a boolean as in the file, a list or an object as
    /// JSON. `None` for null and for missing columns. O(log columns + text).
    #[must_use]
    pub fn get(&self, column: &str) -> Option<String> {
        match self.object.get(column)? {
            ::geojson::JsonValue::Null => None,
            ::geojson::JsonValue::String(text) => Some(text.clone()),
            other => Some(other.to_string()),
        }
    }

    /// Returns the names of the columns.
    pub fn columns(&self) -> impl Iterator<Item = &str> {
        self.object.keys().map(String::as_str)
    }
}
