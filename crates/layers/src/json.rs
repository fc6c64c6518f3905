//! Common parts of GeoJSON and TopoJSON.

use super::crs::Crs;
use super::model::{Dimensions, Geometry, Members, Position, Shape};
use rustc_hash::FxHashMap;
use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use std::fmt;
use std::sync::Arc;

/// Creates a geometry, deriving its dimensions from the positions. A third number is a height; if positions differ in their
/// number of numbers, the dimensions have no such name.
pub(super) fn geometry(shape: Shape, members: Members) -> Geometry {
    let mut count: Option<usize> = None;
    let mut is_uniform = true;
    shape.visit(&mut |position| is_uniform &= *count.get_or_insert(position.more.len()) == position.more.len());
    let height = is_uniform && count == Some(1);
    Geometry { dimensions: Dimensions::with(height, false), shape, members }
}

/// True if all coordinates so far can be longitudes and latitudes.
#[derive(Debug, Default)]
pub(super) struct InDegrees(Option<bool>);

impl InDegrees {
    pub(super) fn look_at(&mut self, geometry: &Geometry) {
        let in_range = |p: &Position| p.x.abs() <= 180.0 && p.y.abs() <= 90.0;
        geometry.shape.visit(&mut |p| self.0 = Some(self.0 != Some(false) && in_range(p)));
    }

    /// Returns the reference system of a file that names none: WGS 84, if there are coordinates and they are in its range.
    pub(super) fn crs(&self) -> Option<Crs> {
        (self.0 == Some(true)).then(|| Crs::epsg(4326))
    }
}

/// The names of columns, each stored once.
#[derive(Debug, Default)]
pub(super) struct Names(FxHashMap<Box<str>, Arc<str>>);

impl Names {
    /// Returns the shared copy of a name. O(its length), expected.
    pub(super) fn get(&mut self, name: &str) -> Arc<str> {
        if let Some(known) = self.0.get(name) {
            return known.clone();
        }
        let new: Arc<str> = name.into();
        self.0.insert(name.into(), new.clone());
        new
    }
}

impl<'de> Deserialize<'de> for Position {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Numbers;
        impl<'de> Visitor<'de> for Numbers {
            type Value = Position;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a position of two numbers or more")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut numbers: A) -> Result<Position, A::Error> {
                let x = numbers.next_element()?.ok_or_else(|| A::Error::invalid_length(0, &self))?;
                position(x, numbers)
            }
        }
        deserializer.deserialize_seq(Numbers)
    }
}

/// Returns the position that begins with this number.
pub(super) fn position<'de, A: SeqAccess<'de>>(x: f64, mut numbers: A) -> Result<Position, A::Error> {
    let short = || A::Error::invalid_length(1, &"a position of two numbers or more");
    let y = numbers.next_element()?.ok_or_else(short)?;
    let mut more = Vec::new();
    while let Some(number) = numbers.next_element()? {
        more.push(number);
    }
    Ok(Position { x, y, more: more.into() })
}
