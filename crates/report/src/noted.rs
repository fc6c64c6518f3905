//! Notes taken on features while they are read, because a map does not keep them: ids, met conditions, defects, places.

use crate::error::Error;
use crate::words::{counted, decimals, decimals_of, measure, plain};
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::str::FromStr;
use twinedge_coverage::{Defect, defects};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_layers::io::ReadSummary;
use twinedge_layers::{Feature as LayerFeature, Value};
use twinedge_map::{Feature, Shape};

const COLUMNS: usize = 20;

/// The number of features without geometry named in a warning.
const NULL: usize = 5;

/// The greatest absolute longitude: some maps continue beyond the antimeridian.
const LONGITUDE: f64 = 360.0;

/// The greatest absolute latitude, with a margin for rounding.
const LATITUDE: f64 = 90.0 + 1e-6;

/// The absolute latitude from which an edge counts as running along a pole.
const POLE: f64 = 89.0;

/// The bits of a double below its exponent, and the number of exponents.
const MANTISSA: u32 = 52;
const EXPONENTS: usize = 1 << 11;

/// The minimal length of most edges, in cells of the grid.
const RESOLVED: f64 = 1024.0;

/// A required value of a column.
#[derive(Clone, Debug)]
pub struct Condition {
    /// The column.
    pub column: String,
    /// The value, as text.
    pub value: String,
}

impl FromStr for Condition {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (column, value) = text.split_once('=').ok_or("no COLUMN=VALUE")?;
        Ok(Self { column: column.to_owned(), value: value.to_owned() })
    }
}

/// The notes on the input to keep alongside the map.
#[derive(Clone, Copy, Default)]
pub struct Keep<'a> {
    /// True to keep the data for judging the coverage.
    pub coverage: bool,
    /// Keeps the numbers of the features that meet this condition.
    pub condition: Option<&'a Condition>,
    /// Keeps the values of these columns.
    pub columns: &'a [String],
    /// True to keep the features as read.
    pub features: bool,
    /// True to accept a layer of points alone.
    pub points: bool,
}

/// The notes on the features.
#[derive(Debug)]
pub struct Noted {
    name_from: Option<String>,
    /// The id of each feature in the file.
    pub ids: Vec<Option<String>>,
    /// The numbers of the features that meet the condition.
    pub matching: Vec<usize>,
    /// For each kept column, the value of each feature; empty values are `None`.
    pub values: Vec<Vec<Option<String>>>,
    /// Features that are not valid by the rules of the OGC, by number.
    pub defects: Vec<(usize, Vec<Defect>)>,
    /// The numbers of the features whose geometry was left out because a coordinate is not finite.
    pub(crate) not_finite: Vec<usize>,
    /// The reasons why geometries could not be read.
    pub(crate) unreadable: BTreeMap<usize, String>,
    /// The numbers of the features whose geometry is missing or empty.
    pub(crate) without_geometry: Vec<usize>,
    /// The number of features that have a line or ring that goes from one side of the antimeridian to the other.
    across_antimeridian: usize,
    /// The first features without geometry, and the number of all.
    null: (Vec<String>, usize),
    /// Text columns with all values present and distinct so far, while no feature has a name or an id.
    unique: Option<Vec<(String, HashSet<String>)>>,
    low: Point,
    high: Point,
    /// The number of edges of polygons, by the exponent of their length in x or y.
    edges: Vec<u64>,
    columns: BTreeSet<String>,
    has_name: bool,
    has_condition: bool,
}

impl Noted {
    /// Creates empty notes. Names come from the column, if given.
    pub(crate) fn new(name_from: Option<String>) -> Self {
        let far = f64::INFINITY;
        Self {
            name_from,
            ids: Vec::new(),
            matching: Vec::new(),
            values: Vec::new(),
            defects: Vec::new(),
            not_finite: Vec::new(),
            unreadable: BTreeMap::new(),
            without_geometry: Vec::new(),
            across_antimeridian: 0,
            null: (Vec::new(), 0),
            unique: None,
            low: Point::new(far, far),
            high: Point::new(-far, -far),
            edges: vec![0; EXPONENTS],
            columns: BTreeSet::new(),
            has_name: false,
            has_condition: false,
        }
    }

    /// Records the next feature, and names it by the requested column. `read` has its attributes.
    pub(crate) fn note(&mut self, feature: &mut Feature, read: &LayerFeature, has_geometry: bool, keep: Keep<'_>) {
        let text = |column: &str| read.get(column).and_then(Value::text);
        let number = self.ids.len();
        self.ids.push(feature.id.clone());
        if let Some(column) = &self.name_from {
            feature.name = text(column);
            self.has_name |= feature.name.is_some();
        }
        if let Some(Condition { column, value }) = keep.condition {
            let found = text(column);
            self.has_condition |= found.is_some();
            if found.as_ref() == Some(value) {
                self.matching.push(number);
            }
        }
        self.values.resize_with(keep.columns.len(), Vec::new);
        for (values, column) in self.values.iter_mut().zip(keep.columns) {
            values.push(text(column).filter(|value| !value.is_empty()));
        }
        let is_asked = self.name_from.is_some() || keep.condition.is_some() || !keep.columns.is_empty();
        if is_asked && self.columns.len() < COLUMNS {
            self.columns.extend(read.attributes.iter().map(|(name, _)| name.to_string()));
        }
        let is_finite = self.not_finite.binary_search(&number).is_err();
        if keep.coverage {
            let found = defects(&feature.shapes);
            if !found.is_empty() || !is_finite {
                self.defects.push((number, found));
            }
        }
        if is_finite && feature.shapes.is_empty() {
            self.without_geometry.push(number);
        }
        if !has_geometry && is_finite {
            self.put_null(number, feature.name.as_deref().or(feature.id.as_deref()));
        }
        self.note_unique(number, feature, read);
        let mut crosses = false;
        for shape in &feature.shapes {
            let is_polygon = matches!(shape, Shape::Polygon(_));
            for chain in chains(shape) {
                for p in chain {
                    self.low = Point::new(self.low.x.min(p.x), self.low.y.min(p.y));
                    self.high = Point::new(self.high.x.max(p.x), self.high.y.max(p.y));
                }
                crosses |= chain.windows(2).any(|pair| goes_around(pair[0], pair[1]));
                for pair in chain.windows(2).filter(|_| is_polygon) {
                    let length = (pair[0].x - pair[1].x).abs().max((pair[0].y - pair[1].y).abs());
                    self.edges[(length.to_bits() >> MANTISSA) as usize % EXPONENTS] += 1;
                }
            }
        }
        self.across_antimeridian += usize::from(crosses);
    }

    /// Records the columns that could name the features.
    fn note_unique(&mut self, number: usize, feature: &Feature, read: &LayerFeature) {
        if feature.name.is_some() || feature.id.is_some() || self.name_from.is_some() {
            self.unique = Some(Vec::new());
            return;
        }
        let of_text = read.attributes.iter().filter_map(|(column, value)| match value {
            Value::Text(text) => Some((column.to_string(), text)),
            _ => None,
        });
        if number == 0 {
            self.unique =
                Some(of_text.take(COLUMNS).map(|(column, text)| (column, HashSet::from([text.clone()]))).collect());
            return;
        }
        let unique = self.unique.get_or_insert_default();
        unique.retain_mut(|(column, seen)| match read.get(column) {
            Some(Value::Text(text)) => seen.insert(text.clone()),
            _ => false,
        });
    }

    /// Returns the columns that could name the features, if none has a name.
    pub(crate) fn name_columns(&self) -> impl Iterator<Item = &str> {
        self.unique.iter().filter(|_| self.ids.len() > 1).flatten().map(|(column, _)| column.as_str())
    }

    pub(crate) fn hint(&self) -> Option<String> {
        let mut names = self.name_columns().map(plain);
        let first = names.next()?;
        let others: Vec<String> = names.collect();
        let or = if others.is_empty() { String::new() } else { format!("; or {}", others.join(", ")) };
        Some(format!("the features have no names: --name-from {first} takes them from a column{or}"))
    }

    /// Returns the corners of the bounding box; `None` if there is nothing in it.
    #[must_use]
    pub fn corners(&self) -> Option<[Point; 2]> {
        (self.low.x <= self.high.x).then_some([self.low, self.high])
    }

    /// Extends the bounding box, and adds the number of edges of polygons for each exponent.
    pub(crate) fn reach(&mut self, [low, high]: [Point; 2], edges: &[(u16, u64)]) {
        (self.low, self.high) = (low, high);
        for (exponent, count) in edges {
            self.edges[usize::from(*exponent) % EXPONENTS] = *count;
        }
    }

    /// Returns the number of decimal places of coordinates in text: enough for a ten-millionth of the greatest coordinate and a thousandth of the
    /// median edge.
    #[must_use]
    pub fn decimals(&self) -> usize {
        let edge = self.median_edge().map(|length| length / 10.0);
        decimals(self.largest()).max(decimals_of(edge))
    }

    /// Returns the least power of two above the length of half the edges of polygons, if there are any.
    fn median_edge(&self) -> Option<f64> {
        let (all, mut shorter) = (self.edges.iter().sum::<u64>(), 0);
        let median = self.edges.iter().position(|count| {
            shorter += count;
            2 * shorter >= all
        })?;
        (all > 0).then(|| f64::from_bits((median as u64 + 1) << MANTISSA))
    }

    fn largest(&self) -> f64 {
        let all = [self.low.x, self.low.y, self.high.x, self.high.y];
        all.into_iter().filter(|x| x.is_finite()).fold(0.0, |greatest, x| x.abs().max(greatest))
    }

    /// Returns the reason why crossing borders cannot be cut: the coordinates reach so far that most edges of polygons vanish on the required grid.
    pub(crate) fn too_far_to_cut(&self) -> Option<String> {
        let (largest, length) = (self.largest(), self.median_edge()?);
        let cell = largest / Snap::AUTO_CELLS as f64;
        (length < cell * RESOLVED).then(|| {
            format!(
                "half of the edges are shorter than {}, and the grid that cuts crossing borders has cells of at least {}",
                measure(length),
                measure(cell)
            )
        })
    }

    pub(crate) fn refuse_unknown_columns(&self, keep: Keep<'_>) -> Result<(), Error> {
        let by_name = self.name_from.as_ref().filter(|_| !self.has_name);
        let by_condition = keep.condition.map(|condition| &condition.column).filter(|_| !self.has_condition);
        by_name.or(by_condition).map_or(Ok(()), |column| Err(self.no_column(column)))
    }

    pub(crate) fn no_column(&self, column: &str) -> Error {
        let known = self.columns.iter().take(COLUMNS).map(|column| plain(column)).collect();
        Error::NoColumn { column: column.to_owned(), known }
    }

    /// Returns true if the coordinates can be longitudes and latitudes and the file names no other reference system.
    pub(crate) fn look_like_degrees(&self, read: &ReadSummary) -> bool {
        read.other_crs == 0 && are_degrees(self.corners())
    }

    /// Counts a feature without geometry.
    pub(crate) fn put_null(&mut self, number: usize, name: Option<&str>) {
        self.null.1 += 1;
        if self.null.0.len() < NULL {
            self.null.0.push(name.map_or_else(|| format!("feature {number}"), plain));
        }
    }

    /// Describes the features without geometry, with their number.
    pub(crate) fn without_geometry(&self) -> Option<String> {
        let (names, count) = &self.null;
        let more = if *count > names.len() { ", …" } else { "" };
        (*count > 0).then(|| format!("{} without geometry: {}{more}", counted(*count, "feature"), names.join(", ")))
    }

    /// Returns warnings about the coordinates.
    #[must_use]
    pub fn warnings(&self, read: &ReadSummary) -> Vec<String> {
        let mut warnings = Vec::new();
        if read.other_crs > 0 {
            warnings.push(
                "the file names a coordinate reference system (crs) other than longitude and latitude on WGS 84; it was \
ignored, and lengths and areas are in its units"
                    .to_owned(),
            );
        }
        if self.look_like_degrees(read) && self.across_antimeridian > 0 {
            let (count, have) = match self.across_antimeridian {
                1 => ("1 feature".to_owned(), "has"),
                n => (format!("{n} features"), "have"),
            };
            warnings.push(format!(
                "{count} {have} edges that span more than 180 degrees of longitude: they probably cross the antimeridian, and run \
around the whole map here; cut them at 180 degrees"
            ));
        }
        warnings
    }
}

/// Returns true if everything between two corners can be longitudes and latitudes.
pub(crate) fn are_degrees(corners: Option<[Point; 2]>) -> bool {
    corners.is_none_or(|[low, high]| {
        low.x >= -LONGITUDE && high.x <= LONGITUDE && low.y >= -LATITUDE && high.y <= LATITUDE
    })
}

/// Returns true if an edge spans more than half of the longitudes, unless it runs along a pole, as an edge of Antarctica does.
fn goes_around(a: Point, b: Point) -> bool {
    (b.x - a.x).abs() > 180.0 && a.y.abs().min(b.y.abs()) < POLE
}

/// The rings, lines and points of a shape.
fn chains(shape: &Shape) -> Box<dyn Iterator<Item = &[Point]> + '_> {
    match shape {
        Shape::Polygon(rings) => Box::new(rings.iter().map(Vec::as_slice)),
        Shape::Line(points) => Box::new(std::iter::once(points.as_slice())),
        Shape::Point(point) => Box::new(std::iter::once(std::slice::from_ref(point))),
    }
}
