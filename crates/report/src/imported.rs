//! Reads the features of a map and builds it.

use crate::error::Error;
use crate::input::Input;
use crate::noted::{Keep, Noted};
use crate::options::MapOptions;
use crate::read_ahead::{Take, read_ahead};
use std::io;
use twinedge_coverage::insert_touches;
use twinedge_geometry::noding::Snap;
use twinedge_layers::io::ReadSummary;
use twinedge_layers::{Crs, Each, Format, Header, Layer, ReadError, read, to_map};
use twinedge_map::{BuildSummary, Builder, Feature, Noding, PlanarMap, UnmatchedVertex};

/// A map, with notes on its input.
#[derive(Debug)]
pub struct Imported {
    /// The name of the input.
    pub name: String,
    /// The reader's counts of read and dropped parts.
    pub read: ReadSummary,
    /// The map.
    pub map: PlanarMap,
    /// The builder's findings.
    pub summary: BuildSummary,
    /// The notes on the features.
    pub noted: Noted,
    /// The builder of the map, if it was kept: the map is not plane, or was snapped to a requested grid.
    pub builder: Option<Builder>,
    /// The vertices that borders of features lack (C7), if the coverage is judged.
    pub unmatched: Vec<UnmatchedVertex>,
    /// The features as read, if they are kept.
    pub features: Vec<Feature>,
    /// The coordinate reference system, if the file names one.
    pub crs: Option<Crs>,
    /// True if the format prescribes the orientation of rings.
    pub orients_rings: bool,
    /// The shape of edges, if the file declares them not planar: `spherical`, or a kind of curve on an ellipsoid.
    pub edges: Option<String>,
}

impl Imported {
    /// Reads a map and builds it. `keep` selects the notes to take; `stage` is called with the name of each step.
    ///
    /// # Errors
    /// [`Error`].
    pub fn read(
        input: Input,
        options: &MapOptions,
        keep: Keep<'_>,
        stage: &mut dyn FnMut(&'static str),
    ) -> Result<Self, Error> {
        Self::built(options, keep, stage, |each| Gathered::new(input, options, keep, each))
    }

    /// Builds the map of a layer in memory, as [`read`](Self::read) does.
    ///
    /// # Errors
    /// [`Error`].
    pub fn of_layer(
        name: &str,
        layer: Layer,
        options: &MapOptions,
        keep: Keep<'_>,
        stage: &mut dyn FnMut(&'static str),
    ) -> Result<Self, Error> {
        Self::built(options, keep, stage, |each| Gathered::of_layer(name, layer, options, keep, each))
    }

    fn built(
        options: &MapOptions,
        keep: Keep<'_>,
        stage: &mut dyn FnMut(&'static str),
        gather: impl FnOnce(&mut Take<'_>) -> Result<Gathered, Error>,
    ) -> Result<Self, Error> {
        let (mut builder, mut features) = (Builder::new(), Vec::new());
        let gathered = gather(&mut |feature| {
            if keep.features {
                features.push(feature.clone());
            }
            insert_touches(&mut feature.shapes);
            builder.feature(feature).map_err(ReadError::refused)?;
            Ok(())
        })?;
        let Gathered { name, read, noted, crs, orients_rings, edges } = gathered;
        let summary = builder.summary().clone();
        stage("building the map");
        let (map, builder, unmatched) = match options.snap {
            None if keep.coverage => {
                let (map, builder) = builder.build_keeping()?;
                // In a plane map, borders meet only at vertices.
                let unmatched = builder.as_ref().map(Builder::unmatched).unwrap_or_default();
                (map, builder, unmatched)
            }
            None => (builder.build()?, None, Vec::new()),
            Some(snap) if keep.coverage => {
                let unmatched = builder.unmatched();
                // Comparing finds the features that the grid removed or created.
                let kept = matches!(snap, Snap::Size(_)).then(|| builder.clone());
                (builder.build_with(Noding::Snap(snap))?, kept, unmatched)
            }
            Some(snap) => (builder.build_with(Noding::Snap(snap))?, None, Vec::new()),
        };
        Ok(Self { name, read, map, summary, noted, builder, unmatched, features, crs, orients_rings, edges })
    }

    /// Returns true if the file declares edges between longitudes and latitudes that are not straight.
    pub(crate) fn has_great_circles(&self) -> bool {
        self.edges.is_some() && self.noted.look_like_degrees(&self.read)
    }

    /// Returns all warnings about the input, including that edges are judged as straight.
    pub(crate) fn warnings(&self) -> Vec<String> {
        let edges = self.edges.as_ref().map(|edges| {
            format!("the file says that its edges are {edges}, and they were judged as straight; --edges geodesic judges great circles")
        });
        self.noted.without_geometry().into_iter().chain(self.noted.warnings(&self.read)).chain(edges).collect()
    }

    /// Reads the features of a map, and calls `put` with each, without building the map: the result has only their names, and the summary does not know
    /// segments repeated by different features.
    ///
    /// # Errors
    /// [`Error`].
    pub fn features(
        input: Input,
        options: &MapOptions,
        keep: Keep<'_>,
        put: &mut (dyn FnMut(Feature) -> io::Result<()> + Send),
    ) -> Result<Self, Error> {
        let (mut summary, mut all_names) = (BuildSummary::default(), Vec::new());
        let gathered = Gathered::new(input, options, keep, &mut |feature| {
            summary.count(feature).map_err(ReadError::refused)?;
            all_names.push(feature.name.take());
            feature.id = None;
            insert_touches(&mut feature.shapes);
            Ok(put(std::mem::take(feature))?)
        })?;
        let Gathered { name, read, noted, crs, orients_rings, edges } = gathered;
        let map = names(all_names.into_iter())?;
        let (builder, unmatched) = (None, Vec::new());
        let features = Vec::new();
        Ok(Self { name, read, map, summary, noted, builder, unmatched, features, crs, orients_rings, edges })
    }
}

/// Creates an empty map whose features have these names.
pub(crate) fn names(names: impl Iterator<Item = Option<String>>) -> Result<PlanarMap, Error> {
    let mut builder = Builder::new();
    for name in names {
        builder.feature(&Feature { name, ..Feature::default() })?;
    }
    Ok(builder.build()?)
}

/// Everything gathered from an input.
struct Gathered {
    name: String,
    read: ReadSummary,
    noted: Noted,
    crs: Option<Crs>,
    orients_rings: bool,
    edges: Option<String>,
}

impl Gathered {
    fn new(mut input: Input, options: &MapOptions, keep: Keep<'_>, each: &mut Take<'_>) -> Result<Self, Error> {
        let orients_rings = input.map_format()?.is_some_and(Format::orients_rings);
        let read_options = input.options();
        let Input { name, mut reader, path, not_finite, kept: _kept, .. } = input;
        let mut noted = Noted::new(options.name_from.clone());
        noted.not_finite = not_finite;
        let read = |each: &mut Each<'_>| read(&mut reader, path.as_deref(), &read_options, each);
        Self::of(name, orients_rings, options, keep, gather(read, noted, keep, each)?)
    }

    fn of_layer(
        name: &str,
        layer: Layer,
        options: &MapOptions,
        keep: Keep<'_>,
        each: &mut Take<'_>,
    ) -> Result<Self, Error> {
        let read = |each: &mut Each<'_>| {
            layer.features.into_iter().try_for_each(each)?;
            Ok(layer.header)
        };
        let noted = Noted::new(options.name_from.clone());
        Self::of(name.to_owned(), true, options, keep, gather(read, noted, keep, each)?)
    }

    fn of(
        name: String,
        orients_rings: bool,
        options: &MapOptions,
        keep: Keep<'_>,
        (read, noted, header): (ReadSummary, Noted, Header),
    ) -> Result<Self, Error> {
        // A layer of points can be judged by another layer.
        let is_map = read.polygons + read.lines > 0 || keep.points && read.points > 0;
        if !options.allow_empty && !is_map {
            return Err(Error::NoMap(Box::new(read)));
        }
        noted.refuse_unknown_columns(keep)?;
        let edges = header.edges().map(str::to_owned);
        Ok(Self { name, read, noted, crs: header.crs, orients_rings, edges })
    }
}

/// Reads features, records the notes on each, and hands it on.
fn gather(
    read: impl FnOnce(&mut Each<'_>) -> Result<Header, ReadError>,
    mut noted: Noted,
    keep: Keep<'_>,
    each: &mut Take<'_>,
) -> Result<(ReadSummary, Noted, Header), ReadError> {
    let mut summary = ReadSummary::default();
    let header = read_ahead(each, |hand_on| {
        read(&mut |mut feature| {
            let mut of_map = to_map(&feature, &mut summary);
            // A large geometry is not kept twice.
            let has_geometry = feature.geometry.take().is_some();
            noted.note(&mut of_map, &feature, has_geometry, keep);
            hand_on(of_map)
        })
    })?;
    summary.other_crs += usize::from(header.crs.as_ref().is_some_and(Crs::is_other));
    Ok((summary, noted, header))
}
