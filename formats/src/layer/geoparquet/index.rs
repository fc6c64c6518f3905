//! The boxes of `GeoParquet`: the statistics of the column of boxes, or of Parquet's own type of geometries, say where the rows of a row group are, and the
//! column of boxes says where each row is.
//!
//! Of columns, those of the geometries and of the boxes are read, and no others.

use super::super::each::EachGeometry;
use super::super::error::{Cause, Place, ReadError};
use super::super::extent::Extent;
use super::geometry_column::GeometryColumn;
use super::read::{ask, content, geometry};
use parquet::file::metadata::{ColumnChunkMetaData, RowGroupMetaData};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::statistics::Statistics;
use parquet::record::Field as Cell;
use parquet::record::reader::RowIter;
use parquet::schema::types::Type;
use std::fs::File;
use std::path::Path;

/// The rows of a row group, and where they are.
struct Group {
    first: u64,
    rows: u64,
    /// That of nothing, if it is not known where all of them are.
    extent: Extent,
    /// False if all geometries are null.
    has_geometries: bool,
}

/// A file with boxes.
pub(in crate::layer) struct IndexedFile {
    reader: SerializedFileReader<File>,
    geometry: String,
    /// The paths of the columns of the boxes.
    covering: Option<[Vec<String>; 4]>,
    /// The columns that are read.
    wanted: Type,
    groups: Vec<Group>,
    length: u64,
    read: u64,
}

impl IndexedFile {
    /// Opens a file; none, if its row groups have no boxes.
    pub(in crate::layer) fn open(path: &Path) -> Result<Option<Self>, ReadError> {
        let in_header = |cause| content(Place::Header, cause);
        let file = File::open(path)?;
        let length = file.metadata()?.len();
        let reader = ask(Place::Header, || SerializedFileReader::new(file))?;
        let metadata = reader.metadata();
        let GeometryColumn { name, covering, .. } =
            GeometryColumn::of_file(metadata.file_metadata()).map_err(in_header)?;
        let mut groups = Vec::new();
        let mut first = 0;
        for group in metadata.row_groups() {
            let rows = u64::try_from(group.num_rows()).unwrap_or_default();
            let Some(extent) = extent(group, &name, covering.as_ref()) else { return Ok(None) };
            let nulls = column_of(group, std::slice::from_ref(&name)).map_or(0, nulls);
            groups.push(Group { first, rows, extent, has_geometries: nulls < rows });
            first += rows;
        }
        let schema = metadata.file_metadata().schema();
        let of_boxes = covering.as_ref().map(|[path, ..]| path[0].as_str());
        let fields = schema.get_fields().iter().filter(|field| field.name() == name || Some(field.name()) == of_boxes);
        let wanted = Type::group_type_builder(schema.name()).with_fields(fields.cloned().collect()).build();
        let wanted = wanted.map_err(|error| in_header(Cause::Invalid(error.to_string())))?;
        Ok(Some(Self { reader, geometry: name, covering, wanted, groups, length, read: 0 }))
    }

    /// The box around all geometries; that of nothing, if it is not known where some are.
    pub(in crate::layer) fn extent(&self) -> Extent {
        let mut extents = self.groups.iter().filter(|group| group.has_geometries).map(|group| group.extent);
        let around = |all: Extent, extent: Extent| extent.is_known().then(|| all.with(extent));
        extents.try_fold(Extent::NOTHING, around).unwrap_or(Extent::NOTHING)
    }

    /// The number of features.
    pub(in crate::layer) fn count(&self) -> u64 {
        self.groups.iter().map(|group| group.rows).sum()
    }

    /// The numbers of bytes of columns that were read, and of all there are.
    pub(in crate::layer) const fn bytes(&self) -> [u64; 2] {
        [self.read, self.length]
    }

    /// Hands over the geometries that may meet a window, with the numbers of their features in order. Memory O(pages of a row group).
    pub(in crate::layer) fn read(
        &mut self,
        window: &Extent,
        is_wanted: &mut dyn FnMut(u64) -> bool,
        each: &mut EachGeometry<'_>,
    ) -> Result<(), ReadError> {
        for (number, group) in self.groups.iter().enumerate() {
            if !group.extent.may_meet(window) {
                continue;
            }
            let place = Place::Feature(group.first as usize);
            let rows = ask(place, || self.reader.get_row_group(number))?;
            let columns = rows.metadata().columns().iter();
            let wanted = columns.filter(|column| {
                let [root, ..] = column.column_path().parts() else { return false };
                self.wanted.get_fields().iter().any(|field| field.name() == root)
            });
            self.read += wanted.map(|column| u64::try_from(column.compressed_size()).unwrap_or_default()).sum::<u64>();
            let mut rows = ask(place, || RowIter::from_row_group(Some(self.wanted.clone()), &*rows))?;
            for number in group.first.. {
                let place = Place::Feature(number as usize);
                let refused = |cause| content(place, cause);
                let Some(row) = ask(place, || rows.next().transpose())? else { break };
                let (mut shape, mut extent) = (Cell::Null, Extent::NOTHING);
                for (name, cell) in row.into_columns() {
                    if name == self.geometry {
                        shape = cell;
                    } else if let Some(paths) = &self.covering {
                        extent = box_of(&cell, paths);
                    }
                }
                group.extent.check(&extent).map_err(refused)?;
                if extent.may_meet(window) && is_wanted(number) {
                    let geometry = geometry(shape).map_err(refused)?;
                    if let Some(geometry) = &geometry {
                        extent.or(group.extent).check_geometry(geometry).map_err(refused)?;
                    }
                    each(number, geometry);
                }
            }
        }
        Ok(())
    }
}

/// The box of a row; that of nothing, if it has none.
fn box_of(cell: &Cell, paths: &[Vec<String>; 4]) -> Extent {
    let number = |path: &Vec<String>| {
        let inner = path[1..].iter().try_fold(cell, |cell, name| match cell {
            Cell::Group(row) => row.get_column_iter().find(|(of, _)| *of == name).map(|(_, cell)| cell),
            _ => None,
        });
        match inner {
            Some(Cell::Double(number)) => Some([*number; 2]),
            // Some writers round to the nearest number of 32 bits.
            Some(Cell::Float(number)) => Some(around(*number)),
            _ => None,
        }
    };
    let [Some([x0, _]), Some([y0, _]), Some([_, x1]), Some([_, y1])] = paths.each_ref().map(number) else {
        return Extent::NOTHING;
    };
    Extent::new([x0, y0, x1, y1])
}

/// The neighbours of a number of 32 bits.
fn around(number: f32) -> [f64; 2] {
    [number.next_down(), number.next_up()].map(f64::from)
}

fn column_of<'a>(group: &'a RowGroupMetaData, path: &[String]) -> Option<&'a ColumnChunkMetaData> {
    group.columns().iter().find(|column| column.column_path().parts() == path)
}

/// The number of nulls in a column. Some writers leave out 0.
fn nulls(column: &ColumnChunkMetaData) -> u64 {
    column.statistics().and_then(Statistics::null_count_opt).unwrap_or_default()
}

/// The box around the rows of a row group, that of nothing if it is not known of all of them; none, if the file does not say.
///
/// Statistics leave out rows without a box. They do not show a box across the antimeridian if other boxes reach farther to both sides: a geometry
/// that lies outside of the box of its row group is refused when it is read.
fn extent(group: &RowGroupMetaData, geometry: &str, covering: Option<&[Vec<String>; 4]>) -> Option<Extent> {
    let geometries = column_of(group, &[geometry.to_owned()]);
    let Some(paths) = covering else {
        let found = geometries?.geo_statistics()?.bounding_box()?;
        return Some(Extent::new([found.get_xmin(), found.get_ymin(), found.get_xmax(), found.get_ymax()]));
    };
    let columns = paths.each_ref().map(|path| column_of(group, path));
    let [Some(x0), Some(y0), Some(x1), Some(y1)] = columns else { return None };
    // A geometry that is null needs no box.
    let without_box = geometries.map_or(0, nulls);
    let all_null = u64::try_from(group.num_rows()).unwrap_or_default();
    if [x0, y0, x1, y1].into_iter().any(|column| nulls(column) > without_box || nulls(column) == all_null) {
        return Some(Extent::NOTHING);
    }
    let least = |column: &ColumnChunkMetaData| match column.statistics()? {
        Statistics::Double(found) => found.min_opt().copied(),
        Statistics::Float(found) => found.min_opt().map(|number| around(*number)[0]),
        _ => None,
    };
    let greatest = |column: &ColumnChunkMetaData| match column.statistics()? {
        Statistics::Double(found) => found.max_opt().copied(),
        Statistics::Float(found) => found.max_opt().map(|number| around(*number)[1]),
        _ => None,
    };
    let extent = Extent::new([least(x0)?, least(y0)?, greatest(x1)?, greatest(y1)?]);
    // A side that is beyond the opposite one of all rows is that of a box whose corners are not in order.
    let is_in_order = |low, high| least(low) <= least(high) && greatest(low) <= greatest(high);
    Some(if is_in_order(x0, x1) && is_in_order(y0, y1) { extent } else { Extent::NOTHING })
}
