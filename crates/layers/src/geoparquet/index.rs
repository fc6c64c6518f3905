//! The boxes of `GeoParquet`: the statistics of the column of boxes, or of Parquet's own geometry type, locate the rows of a row
//! group, and the column of boxes locates each row.
//!
//! Only the columns of the geometries and of the boxes are read.

use super::super::each::EachGeometry;
use super::super::error::{Cause, Place, ReadError};
use super::super::extent::Extent;
use super::super::model::Header;
use super::geometry_column::GeometryColumn;
use super::read::{ask, content, geometry};
use crate::windows::Windows;
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{ByteArray, ByteArrayType, DataType};
use parquet::errors::ParquetError;
use parquet::file::metadata::{ColumnChunkMetaData, RowGroupMetaData};
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
use parquet::file::statistics::Statistics;
use parquet::record::Field as Cell;
use std::fs::File;
use std::path::Path;

/// The number of values read at once.
const READ: usize = 1 << 14;

/// The codes of well-known binary.
const POINT: i32 = 1;
const MULTI_POINT: i32 = 4;

/// The rows of a row group, with their extent.
struct Group {
    first: u64,
    rows: u64,
    /// The box of nothing, if not all of them are located.
    extent: Extent,
    /// False if all geometries are null.
    has_geometries: bool,
}

pub(crate) struct IndexedFile {
    reader: SerializedFileReader<File>,
    column: GeometryColumn,
    groups: Vec<Group>,
    length: u64,
    read: u64,
}

impl IndexedFile {
    /// Opens a file; `None` if its row groups have no boxes.
    pub(crate) fn open(path: &Path) -> Result<Option<Self>, ReadError> {
        let in_header = |cause| content(Place::Header, cause);
        let file = File::open(path)?;
        let length = file.metadata()?.len();
        let reader = ask(Place::Header, || SerializedFileReader::new(file))?;
        let metadata = reader.metadata();
        let mut column = GeometryColumn::of_file(metadata.file_metadata()).map_err(in_header)?;
        column.has_only_points |= metadata.row_groups().iter().all(|group| has_only_points(group, &column.name));
        let GeometryColumn { name, covering, .. } = &column;
        let mut groups = Vec::new();
        let mut first = 0;
        for group in metadata.row_groups() {
            let rows = u64::try_from(group.num_rows()).unwrap_or_default();
            let Some(extent) = extent(group, name, covering.as_ref()) else { return Ok(None) };
            let nulls = column_of(group, std::slice::from_ref(name)).map_or(0, nulls);
            groups.push(Group { first, rows, extent, has_geometries: nulls < rows });
            first += rows;
        }
        Ok(Some(Self { reader, column, groups, length, read: 0 }))
    }
}

impl Windows for IndexedFile {
    fn header(&self) -> Result<Header, ReadError> {
        Ok(self.column.header())
    }

    fn has_only_points(&self) -> Result<bool, ReadError> {
        Ok(self.column.has_only_points)
    }

    /// Returns the number of features in the row groups that may meet a window.
    fn passed(&self, window: &Extent) -> u64 {
        self.groups.iter().filter(|group| group.extent.may_meet(window)).map(|group| group.rows).sum()
    }

    /// The box of nothing if some geometries are not located.
    fn extent(&self) -> Extent {
        let mut extents = self.groups.iter().filter(|group| group.has_geometries).map(|group| group.extent);
        let around = |all: Extent, extent: Extent| extent.is_known().then(|| all.with(extent));
        extents.try_fold(Extent::NOTHING, around).unwrap_or(Extent::NOTHING)
    }

    fn count(&self) -> u64 {
        self.groups.iter().map(|group| group.rows).sum()
    }

    /// Returns the numbers of column bytes read and in total.
    fn bytes(&self) -> [u64; 2] {
        [self.read, self.length]
    }

    /// Passes on the geometries that may meet a window, with their feature numbers in order. Memory O(pages of a row group).
    fn read(
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
            let boxes = self.column.covering.as_ref().map(|paths| ask(place, || Boxes::new(&*rows, paths)));
            let mut boxes = boxes.transpose()?;
            let of_boxes = self.column.covering.iter().flatten().filter_map(|path| column_of(rows.metadata(), path));
            self.read += of_boxes.map(size).sum::<u64>();
            // Geometries elsewhere are skipped, mostly with their pages.
            let mut geometries: Option<Geometries> = None;
            for (number, row) in (group.first..).zip(0..group.rows as usize) {
                let place = Place::Feature(number as usize);
                let refused = |cause| content(place, cause);
                let extent = boxes.as_mut().map(|boxes| ask(place, || boxes.next())).transpose()?;
                let extent = extent.unwrap_or(Extent::NOTHING);
                group.extent.check(&extent).map_err(refused)?;
                if !(extent.may_meet(window) && is_wanted(number)) {
                    continue;
                }
                let opened = match &mut geometries {
                    Some(opened) => opened,
                    none => {
                        let column = column_of(rows.metadata(), std::slice::from_ref(&self.column.name));
                        self.read += column.map_or(0, size);
                        none.insert(Geometries::new(&*rows, &self.column.name, place)?)
                    }
                };
                let binary = ask(place, || opened.at(row))?;
                let geometry = geometry(binary.map_or(Cell::Null, Cell::Bytes)).map_err(refused)?;
                if let Some(geometry) = &geometry {
                    extent.or(group.extent).check_geometry(geometry).map_err(refused)?;
                }
                each(number, geometry);
            }
        }
        Ok(())
    }
}

/// The geometries of a row group, in well-known binary.
struct Geometries {
    column: ColumnReaderImpl<ByteArrayType>,
    next: usize,
}

impl Geometries {
    fn new(rows: &dyn RowGroupReader, name: &str, place: Place) -> Result<Self, ReadError> {
        let at = place_of(rows.metadata(), &[name.to_owned()]);
        let column = at.map(|at| ask(place, || rows.get_column_reader(at))).transpose()?;
        match column {
            Some(ColumnReader::ByteArrayColumnReader(column)) => Ok(Self { column, next: 0 }),
            _ => Err(content(place, Cause::Invalid("a geometry that is not made of bytes".to_owned()))),
        }
    }

    /// Returns the geometry of a row after the ones already read; `None` if it is null.
    fn at(&mut self, row: usize) -> Result<Option<ByteArray>, ParquetError> {
        self.column.skip_records(row - self.next)?;
        self.next = row + 1;
        let (mut levels, mut values) = (Vec::new(), Vec::new());
        let (records, ..) = self.column.read_records(1, Some(&mut levels), None, &mut values)?;
        if records == 0 {
            return Err(damaged("the column of geometries ends before its rows"));
        }
        Ok(values.pop())
    }
}

/// The boxes of the rows of a row group, in order.
struct Boxes {
    sides: [Numbers; 4],
    read: std::vec::IntoIter<Extent>,
}

/// A column of numbers, with the definition level of present values.
struct Numbers {
    column: ColumnReader,
    most: i16,
}

impl Boxes {
    fn new(rows: &dyn RowGroupReader, paths: &[Vec<String>; 4]) -> Result<Self, ParquetError> {
        let numbers = |path: &Vec<String>| {
            let place = place_of(rows.metadata(), path).ok_or_else(|| damaged("there is no column of boxes"))?;
            let most = rows.metadata().column(place).column_descr().max_def_level();
            Ok::<_, ParquetError>(Numbers { column: rows.get_column_reader(place)?, most })
        };
        let [x0, y0, x1, y1] = paths.each_ref().map(numbers);
        Ok(Self { sides: [x0?, y0?, x1?, y1?], read: Vec::new().into_iter() })
    }

    /// Returns the box of the next row, or the box of nothing.
    fn next(&mut self) -> Result<Extent, ParquetError> {
        if self.read.as_slice().is_empty() {
            let [x0, y0, x1, y1] = self.sides.each_mut().map(Numbers::next);
            let corners = x0?.into_iter().zip(y0?).zip(x1?.into_iter().zip(y1?));
            let extents = corners.map(|corners| match corners {
                ((Some([x0, _]), Some([y0, _])), (Some([_, x1]), Some([_, y1]))) => Extent::new([x0, y0, x1, y1]),
                _ => Extent::NOTHING,
            });
            self.read = extents.collect::<Vec<_>>().into_iter();
        }
        self.read.next().ok_or_else(|| damaged("the column of boxes ends before its rows"))
    }
}

impl Numbers {
    /// Reads further numbers, each as bounds that account for rounding; `None` for null.
    fn next(&mut self) -> Result<Vec<Option<[f64; 2]>>, ParquetError> {
        match &mut self.column {
            ColumnReader::DoubleColumnReader(column) => values(column, self.most, |number| [number; 2]),
            // Some writers round to the nearest 32-bit number.
            ColumnReader::FloatColumnReader(column) => values(column, self.most, around),
            _ => Err(damaged("the column of boxes has no numbers")),
        }
    }
}

fn values<T: DataType>(
    column: &mut ColumnReaderImpl<T>,
    most: i16,
    number: impl Fn(T::T) -> [f64; 2],
) -> Result<Vec<Option<[f64; 2]>>, ParquetError> {
    let (mut levels, mut values) = (Vec::new(), Vec::new());
    column.read_records(READ, Some(&mut levels), None, &mut values)?;
    let mut values = values.into_iter().map(number);
    if most == 0 {
        return Ok(values.map(Some).collect());
    }
    Ok(levels.into_iter().map(|level| if level == most { values.next() } else { None }).collect())
}

fn damaged(what: &str) -> ParquetError {
    ParquetError::General(what.to_owned())
}

fn around(number: f32) -> [f64; 2] {
    [number.next_down(), number.next_up()].map(f64::from)
}

fn column_of<'a>(group: &'a RowGroupMetaData, path: &[String]) -> Option<&'a ColumnChunkMetaData> {
    place_of(group, path).map(|place| group.column(place))
}

fn place_of(group: &RowGroupMetaData, path: &[String]) -> Option<usize> {
    group.columns().iter().position(|column| column.column_path().parts() == path)
}

fn size(column: &ColumnChunkMetaData) -> u64 {
    u64::try_from(column.compressed_size()).unwrap_or_default()
}

/// Returns true if the statistics of a column of Parquet's own geometries declare that all are points, with any dimensions.
fn has_only_points(group: &RowGroupMetaData, geometry: &str) -> bool {
    let column = column_of(group, &[geometry.to_owned()]);
    let types = column.and_then(ColumnChunkMetaData::geo_statistics).and_then(|found| found.geospatial_types());
    types.is_some_and(|types| {
        !types.is_empty() && types.iter().all(|code| [POINT, MULTI_POINT].contains(&(code % 1000)))
    })
}

/// Returns the number of nulls in a column. Some writers leave out 0.
fn nulls(column: &ColumnChunkMetaData) -> u64 {
    column.statistics().and_then(Statistics::null_count_opt).unwrap_or_default()
}

/// Returns the box around the rows of a row group, or the box of nothing if some are not located; `None` if the file does not
/// state it.
///
/// Statistics leave out rows without a box. They do not reveal a box across the antimeridian if other boxes reach farther to both
/// sides: a geometry outside the box of its row group is refused when it is read.
fn extent(group: &RowGroupMetaData, geometry: &str, covering: Option<&[Vec<String>; 4]>) -> Option<Extent> {
    let geometries = column_of(group, &[geometry.to_owned()]);
    let Some(paths) = covering else {
        let found = geometries?.geo_statistics()?.bounding_box()?;
        return Some(Extent::new([found.get_xmin(), found.get_ymin(), found.get_xmax(), found.get_ymax()]));
    };
    let columns = paths.each_ref().map(|path| column_of(group, path));
    let [Some(x0), Some(y0), Some(x1), Some(y1)] = columns else { return None };
    // A null geometry needs no box.
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
    // If a side is beyond the opposite side of all rows, it belongs to a box whose corners are not in order.
    let is_in_order = |low, high| least(low) <= least(high) && greatest(low) <= greatest(high);
    Some(if is_in_order(x0, x1) && is_in_order(y0, y1) { extent } else { Extent::NOTHING })
}
