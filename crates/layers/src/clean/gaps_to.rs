//! The feature that gets filled gaps.

use super::super::model::{Feature, FieldKind, Layer, Shape, Value, kind_of};
use std::sync::Arc;

/// The feature that gets filled gaps.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum GapsTo {
    /// One of these, by number: the neighbour among them with the longest common border, or else the first.
    Features(Vec<usize>),
    /// A new feature with these attributes, after all others. It is made only if gaps are filled.
    New(Vec<(Arc<str>, Value)>),
}

/// The reason why no feature can get the gaps.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GapsToError {
    /// No feature has this column.
    #[error("there is no column {0}")]
    NoColumn(String),
    /// The column has values of another type.
    #[error("no feature has {value:?} as its {column}, and a new one cannot have it: the values are of another type")]
    OtherType {
        /// The column.
        column: String,
        /// The value.
        value: String,
    },
}

impl GapsTo {
    /// Selects the features with this value in a column, or else a new feature with it. Features of lines and points are ignored.
    /// O(attributes).
    ///
    /// ```
    /// use twinedge_layers::clean::GapsTo;
    /// use twinedge_layers::{Feature, Layer, Value};
    ///
    /// let feature = |kind: &str| Feature { attributes: vec![("kind".into(), Value::Text(kind.into()))], ..Feature::default() };
    /// let layer = Layer { features: ["parcel", "road", "road"].map(feature).into(), ..Layer::default() };
    /// assert_eq!(GapsTo::with_value(&layer, "kind", "road")?, GapsTo::Features(vec![1, 2]));
    /// let new = GapsTo::with_value(&layer, "kind", "unknown")?;
    /// assert_eq!(new, GapsTo::New(vec![("kind".into(), Value::Text("unknown".into()))]));
    /// # Ok::<_, twinedge_layers::clean::GapsToError>(())
    /// ```
    ///
    /// # Errors
    /// [`GapsToError`].
    pub fn with_value(layer: &Layer, column: &str, value: &str) -> Result<Self, GapsToError> {
        let has_value = |feature: &Feature| feature.get(column).and_then(Value::text).as_deref() == Some(value);
        let all = layer.features.iter().enumerate();
        let with: Vec<usize> =
            all.filter(|(_, it)| has_value(it) && can_receive(it)).map(|(number, _)| number).collect();
        if !with.is_empty() {
            return Ok(Self::Features(with));
        }
        let fields = layer.fields();
        let Some(field) = fields.iter().find(|field| *field.name == *column) else {
            return Err(GapsToError::NoColumn(column.to_owned()));
        };
        let text = || Value::Text(value.to_owned());
        let of_kind = match field.kind {
            FieldKind::Text => Some(text()),
            // Numbers and booleans in JSON notation.
            kind => serde_json::from_str(value).ok().map(Value::of_json).filter(|value| {
                kind_of(value) == Some(kind) || (kind, kind_of(value)) == (FieldKind::Real, Some(FieldKind::Integer))
            }),
        };
        let refused = || GapsToError::OtherType { column: column.to_owned(), value: value.to_owned() };
        Ok(Self::New(vec![(field.name.clone(), of_kind.ok_or_else(refused)?)]))
    }
}

/// Returns true if a feature contains polygons or nothing.
fn can_receive(feature: &Feature) -> bool {
    feature.geometry.as_ref().is_none_or(|geometry| {
        matches!(geometry.shape, Shape::Polygon(_) | Shape::MultiPolygon(_)) || geometry.shape.is_empty()
    })
}
