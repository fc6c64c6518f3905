//! The options of an audit: one table of names, types, defaults and helps, which the program reads as arguments (feature `clap`), and Python and
//! JavaScript as JSON.

use crate::accepted::Accepted;
use crate::error::Error;
use crate::input::Input;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value};
use std::str::FromStr;
use twinedge::validate::{Collect, Expectation};
use twinedge_coverage::Limits;
use twinedge_geometry::noding::Snap;
use twinedge_layers::Format;
use twinedge_meshes::{HalfEdgeMesh, SpaceRule};

/// The shape of the edges of a map of longitudes and latitudes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Edges {
    /// Straight on the map.
    #[cfg_attr(feature = "clap", clap(help = None))]
    Straight,
    /// Arcs of great circles.
    #[cfg_attr(feature = "clap", clap(help = None))]
    Geodesic,
}

/// The options for building a map.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args))]
pub struct MapOptions {
    /// Cut segments wherever they cross, touch or overlap, and round all points to a grid. `auto` chooses the finest grid that
    /// the coordinates allow. SIZE is the width of its cells: with 0.001, coordinates have three decimal places, and such coordinates stay.
    #[serde(serialize_with = "write_snap", deserialize_with = "read_snap")]
    #[cfg_attr(feature = "clap", arg(long, value_name = "auto|SIZE", value_parser = snap, allow_negative_numbers = true))]
    pub snap: Option<Snap>,

    /// Take the names of features from this column (property). Default: name, NAME, Name, ADMIN, admin, title or id, the first
    /// that there is.
    #[cfg_attr(feature = "clap", arg(long, value_name = "COLUMN", global = true))]
    pub name_from: Option<String>,

    /// Accept a file without lines and polygons, such as an empty layer or one of points.
    #[cfg_attr(feature = "clap", arg(long))]
    pub allow_empty: bool,
}

/// The gaps that are meant.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args))]
pub struct AcceptedGaps {
    /// Greatest mean width of a gap that is reported, where it is not --gap-width: wider ones are accepted, as lakes.
    #[cfg_attr(feature = "clap", arg(long, value_name = "W", value_parser = positive))]
    pub lake_width: Option<f64>,

    /// Accept the gap around this point, whatever its width. Can be given several times.
    #[cfg_attr(feature = "clap", arg(long, value_name = "X,Y", value_parser = place, allow_hyphen_values = true))]
    #[serde(alias = "accept_gaps")]
    pub accept_gap: Vec<[f64; 2]>,
}

/// The limits by which a coverage is judged.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Coverage (maps)"))]
pub struct LimitOptions {
    /// Greatest width of a near miss, and of a gap that is reported, in the units of the coordinates, with --geodesic too. The width is the mean one: twice
    /// the area by the length of the border. Wider gaps are counted. Default: gaps of any width, and near misses up to a hundredth of
    /// the median length of the edges.
    #[cfg_attr(feature = "clap", arg(long, value_name = "W", value_parser = positive))]
    pub gap_width: Option<f64>,

    /// The gaps that are meant.
    #[serde(flatten)]
    #[cfg_attr(feature = "clap", command(flatten))]
    pub accepted: AcceptedGaps,

    /// Area below which a thin part of a feature is a sliver. A part is thin if 4π · area / perimeter² is below 0.2: a rectangle 14 times
    /// as long as wide. Default: a thousandth of the median area of all parts of features; `clean` measures them after overlaps are
    /// resolved, so its limit is a little different.
    #[cfg_attr(feature = "clap", arg(long, value_name = "A", value_parser = positive))]
    pub sliver: Option<f64>,
}

impl LimitOptions {
    /// Returns the limits.
    #[must_use]
    pub fn limits(&self) -> Limits {
        Limits {
            gap_width: self.gap_width,
            lake_width: self.accepted.lake_width,
            accepted_gaps: self.accepted.accept_gap.iter().copied().map(Into::into).collect(),
            sliver_area: self.sliver,
            ..Limits::default()
        }
    }
}

/// The options by which a coverage is judged.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Coverage (maps)"))]
pub struct CoverageOptions {
    /// Count what breaks C1 … C7 as violations: overlaps, gaps, near misses, slivers, duplicates, polygons that are not valid by
    /// the OGC, mismatches. Otherwise they are counted and shown, and the map is valid with them; in GeoJSON their `violation` is then false.
    #[cfg_attr(feature = "clap", arg(long))]
    pub coverage: bool,

    /// The limits.
    #[serde(flatten)]
    #[cfg_attr(feature = "clap", command(flatten))]
    pub limits: LimitOptions,
}

/// The measure of lengths and areas.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args))]
pub struct Measured {
    /// Lengths in metres along geodesics and areas in square metres, on the ellipsoid WGS 84; of areas, the borders are straight in the coordinates. Only
    /// for longitudes and latitudes in degrees.
    #[cfg_attr(feature = "clap", arg(long))]
    pub geodesic: bool,
}

/// The properties that a mesh must have.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Meshes"))]
#[allow(clippy::struct_excessive_bools, reason = "each is an option of its own")]
pub struct MeshOptions {
    /// The mesh has no border.
    #[cfg_attr(feature = "clap", arg(long, conflicts_with = "borders"))]
    pub closed: bool,

    /// The mesh has exactly N border loops.
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", value_parser = whole, allow_negative_numbers = true))]
    pub borders: Option<usize>,

    /// The genus of the whole mesh is N: 0 for spheres and discs, 1 for a torus.
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", value_parser = whole, allow_negative_numbers = true))]
    pub genus: Option<usize>,

    /// The mesh has exactly N components.
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", value_parser = whole, allow_negative_numbers = true))]
    pub components: Option<usize>,

    /// Every face has three sides.
    #[cfg_attr(feature = "clap", arg(long, conflicts_with = "sides"))]
    pub triangles: bool,

    /// Every face has N sides.
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", value_parser = whole, allow_negative_numbers = true))]
    pub sides: Option<usize>,

    /// No edge is a loop, and no two edges have the same ends.
    #[cfg_attr(feature = "clap", arg(long))]
    pub simple: bool,

    /// Every vertex is a corner of a face.
    #[cfg_attr(feature = "clap", arg(long))]
    pub no_unused_vertices: bool,

    /// No face has all its corners on one line (M9).
    #[cfg_attr(feature = "clap", arg(long))]
    pub no_zero_area: bool,

    /// Faces meet in common corners and edges only (M10). Faces with more than three sides have to be convex for that.
    #[cfg_attr(feature = "clap", arg(long))]
    pub no_crossings: bool,

    /// The faces of closed components face outwards, or inwards around a cavity (M11).
    #[cfg_attr(feature = "clap", arg(long))]
    pub outward: bool,
}

impl MeshOptions {
    /// Returns the rules about the links of a mesh.
    #[must_use]
    pub fn expectation(&self) -> Expectation {
        let mut expectation = HalfEdgeMesh::expectation();
        if self.closed {
            expectation = expectation.closed();
        }
        if let Some(borders) = self.borders {
            expectation = expectation.borders(borders);
        }
        if let Some(genus) = self.genus {
            expectation = expectation.genus(genus);
        }
        if let Some(components) = self.components {
            expectation = expectation.components(components);
        }
        if let Some(sides) = self.sides.or(self.triangles.then_some(3)) {
            expectation = expectation.sides(sides);
        }
        if self.simple {
            expectation = expectation.simple();
        }
        if self.no_unused_vertices {
            expectation = expectation.no_unused_vertices();
        }
        expectation
    }

    /// Returns the rules about the places of a mesh's points.
    #[must_use]
    pub fn space(&self) -> Vec<SpaceRule> {
        let asked = [
            (self.no_zero_area, SpaceRule::Area),
            (self.no_crossings, SpaceRule::Crossing),
            (self.outward, SpaceRule::Outward),
        ];
        asked.into_iter().filter(|(is_asked, _)| *is_asked).map(|(_, rule)| rule).collect()
    }
}

/// The options of an audit. Options for other kinds of input are ignored.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Options {
    /// The greatest number of violations to list, and of findings of each rule C1 … C7; all are counted. `None` lists 1000, and 3 findings of each of
    /// C1 … C7 in text.
    pub list: Option<usize>,
    /// True to keep causes and remedies.
    pub explain: bool,
    /// The options for building a map.
    #[serde(flatten)]
    pub map: MapOptions,
    /// The options by which a coverage is judged.
    #[serde(flatten)]
    pub coverage: CoverageOptions,
    /// The accepted findings of the coverage.
    #[serde(skip)]
    pub accepted: Option<Accepted>,
    /// The column by which parts name their parents, to check that parents consist of their parts.
    pub parent_column: Option<ParentColumn>,
    /// The shape of edges. `None`: great circles if a file of longitudes and latitudes declares edges that are not planar, otherwise straight.
    pub edges: Option<Edges>,
    /// The measure of lengths and areas.
    #[serde(flatten)]
    pub measured: Measured,
    /// The properties that a mesh must have.
    #[serde(flatten)]
    pub mesh: MeshOptions,
}

/// The reason why an object of JSON is not a set of options.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OptionsError {
    /// The object has a member that is no option.
    #[error("{0}: there is no such option")]
    Unknown(String),
    /// A width, an area or a count is negative.
    #[error("{0}: a negative number")]
    Negative(String),
    /// The value of an option has the wrong type.
    #[error("{0}: {1}")]
    Value(String, serde_json::Error),
}

impl Options {
    /// Reads options from the members of an object of JSON. Their names are those of the program's options, in snake case or camel case: `gap_width`
    /// or `gapWidth` for `--gap-width`. `accept_gap` can also be `accept_gaps`, as it has several values.
    ///
    /// ```
    /// use twinedge_report::Options;
    ///
    /// let members = serde_json::json!({ "gapWidth": 0.5, "closed": true });
    /// let options = Options::from_json(members.as_object().cloned().unwrap_or_default())?;
    /// assert_eq!(options.coverage.limits.gap_width, Some(0.5));
    /// assert!(options.mesh.closed);
    /// # Ok::<(), twinedge_report::OptionsError>(())
    /// ```
    ///
    /// # Errors
    /// If no option has a name, or if a value is not one of the option's.
    pub fn from_json(members: Map<String, Value>) -> Result<Self, OptionsError> {
        let all = serde_json::to_value(Self::default()).unwrap_or_default();
        let all = || all.as_object().into_iter().flat_map(Map::keys).map(String::as_str).chain(["accept_gaps"]);
        let (mut known, mut options) = (Map::new(), Self::default());
        for (name, value) in members {
            let Some(own) = all().find(|own| *own == name || camel_case(own) == name) else {
                return Err(OptionsError::Unknown(name));
            };
            if value.as_f64().is_some_and(|number| number < 0.0) {
                return Err(OptionsError::Negative(name));
            }
            known.insert(own.to_owned(), value);
            // Each is read with those before it, so that an error is about this one.
            options = serde_json::from_value(known.clone().into()).map_err(|error| OptionsError::Value(name, error))?;
        }
        Ok(options)
    }

    /// Refuses options that edges along great circles exclude. The parameter names another given option of that kind.
    pub(crate) fn refuse_with_geodesic(&self, beside: Option<&'static str>) -> Result<(), Error> {
        let given = [(self.measured.geodesic, "--geodesic"), (self.map.snap.is_some(), "--snap")];
        let own = given.into_iter().find(|(is_given, _)| *is_given).map(|(_, option)| option);
        match beside.or(own).filter(|_| self.edges == Some(Edges::Geodesic)) {
            Some(option) => Err(Error::NotGeodesic(option)),
            None => Ok(()),
        }
    }

    /// Returns true if the file decides the shape of edges: its format can, and no option contradicts.
    pub(crate) fn may_be_said(&self, input: &mut Input) -> Result<bool, Error> {
        let is_asked = self.edges.is_some() || self.measured.geodesic || self.map.snap.is_some();
        Ok(!is_asked && input.map_format()? == Some(Format::GeoParquet))
    }

    pub(crate) fn most(&self) -> usize {
        self.list.unwrap_or(Collect::DEFAULT_CAP)
    }
}

/// The column in which parts name their parents, and the column with this value in the parents. By default, that is the column of the same name in
/// the other layer, or else the ids, or else the names.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
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

impl TryFrom<String> for ParentColumn {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        text.parse()
    }
}

impl From<ParentColumn> for String {
    fn from(parent: ParentColumn) -> Self {
        match parent.key {
            Some(key) => format!("{}={key}", parent.column),
            None => parent.column,
        }
    }
}

fn camel_case(name: &str) -> String {
    let (first, others) = name.split_once('_').unwrap_or((name, ""));
    let capital =
        |word: &str| word.get(..1).unwrap_or_default().to_ascii_uppercase() + word.get(1..).unwrap_or_default();
    others.split_terminator('_').fold(first.to_owned(), |name, word| name + &capital(word))
}

/// Parses the width of a grid's cells, or `auto`.
///
/// # Errors
/// If the text is neither.
pub fn snap(text: &str) -> Result<Snap, &'static str> {
    match text.parse() {
        _ if text == "auto" => Ok(Snap::Auto),
        Ok(size) if size > 0.0 && f64::is_finite(size) => Ok(Snap::Size(size)),
        _ => Err("neither `auto` nor a positive number"),
    }
}

#[allow(clippy::ref_option, clippy::trivially_copy_pass_by_ref, reason = "the form that serde calls")]
fn write_snap<S: Serializer>(snap: &Option<Snap>, to: S) -> Result<S::Ok, S::Error> {
    match snap {
        None => to.serialize_none(),
        Some(Snap::Size(size)) => to.serialize_f64(*size),
        Some(_) => to.serialize_str("auto"),
    }
}

fn read_snap<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Snap>, D::Error> {
    let text = match Value::deserialize(from)? {
        Value::Null => return Ok(None),
        Value::String(text) => text,
        other => other.to_string(),
    };
    snap(&text).map(Some).map_err(D::Error::custom)
}

/// Parses a positive number.
///
/// # Errors
/// If the text is none.
pub fn positive(text: &str) -> Result<f64, &'static str> {
    text.parse().ok().filter(|x| *x > 0.0 && f64::is_finite(*x)).ok_or("not a positive number")
}

/// Parses a whole number.
///
/// # Errors
/// If the text is none.
pub fn whole(text: &str) -> Result<usize, &'static str> {
    text.parse().map_err(|_| "not a whole number")
}

/// Parses a point, in parentheses as reports print it or without.
#[cfg(feature = "clap")]
fn place(text: &str) -> Result<[f64; 2], &'static str> {
    let number = |text: &str| text.trim().parse().ok().filter(|x| f64::is_finite(*x));
    let text = text.trim().trim_start_matches('(').trim_end_matches(')');
    let point = text.split_once(',').and_then(|(x, y)| Some([number(x)?, number(y)?]));
    point.ok_or("not a point: two numbers with a comma between")
}
