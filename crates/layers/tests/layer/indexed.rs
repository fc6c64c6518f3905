//! Reading windows by boxes: the same features as by reading everything, less reading, and false boxes.

use crate::support::{read, scratch, write_as};
use parquet::basic::{Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, FloatType};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::fs::{self, File};
use std::path::Path;
use std::sync::Arc;
use twinedge_geometry::Point;
use twinedge_layers::{
    Cause, Dimensions, Feature, Format, Geometry, Indexed, Layer, Place, Position, ReadError, ReadOptions, Shape,
};

const ACROSS: u32 = 40;

/// The window over the whole plane.
const EVERYTHING: [f64; 4] = [f64::NEG_INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::INFINITY];

/// The square with this number, with 40 in a row.
fn square(number: u32) -> [f64; 4] {
    let [x, y] = [number % ACROSS, number / ACROSS].map(f64::from);
    [x, y, x + 1.0, y + 1.0]
}

fn ring([x0, y0, x1, y1]: [f64; 4]) -> Geometry {
    let ring = [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]].map(|[x, y]| Position::new(x, y));
    Geometry::new(Dimensions::Xy, Shape::Polygon(vec![ring.to_vec()]))
}

fn squares(count: u32) -> Layer {
    let feature = |number| Feature { geometry: Some(ring(square(number))), ..Feature::default() };
    Layer { features: (0..count).map(feature).collect(), ..Layer::default() }
}

/// Returns the numbers of the features in a window, whose geometries must equal the layer's.
fn found(file: &mut Indexed, [x0, y0, x1, y1]: [f64; 4], layer: &Layer) -> Result<Vec<u64>, ReadError> {
    let mut found = Vec::new();
    let corners = [Point::new(x0, y0), Point::new(x1, y1)];
    file.read(corners, &mut |_| true, &mut |number, geometry| {
        assert_eq!(geometry, layer.features[number as usize].geometry);
        found.push(number);
    })?;
    Ok(found)
}

fn open(path: &Path) -> Indexed {
    Indexed::open(path, &ReadOptions::default()).unwrap().unwrap()
}

/// The box of a row group, and its rows with their boxes.
struct Group {
    rows: Vec<(Geometry, Option<[f64; 4]>)>,
}

/// Writes `GeoParquet` with these boxes, as 32-bit or 64-bit floats.
fn write_groups(path: &Path, groups: &[Group], is_narrow: bool) {
    let of = |name: &str, kind, repetition| {
        Arc::new(Type::primitive_type_builder(name, kind).with_repetition(repetition).build().unwrap())
    };
    let kind = if is_narrow { Physical::FLOAT } else { Physical::DOUBLE };
    let sides = ["xmin", "ymin", "xmax", "ymax"];
    let sides = sides.iter().map(|side| of(side, kind, Repetition::REQUIRED)).collect();
    let boxes = Type::group_type_builder("bbox").with_repetition(Repetition::OPTIONAL).with_fields(sides).build();
    let fields = vec![
        of("owner", Physical::DOUBLE, Repetition::REQUIRED),
        of("shape", Physical::BYTE_ARRAY, Repetition::REQUIRED),
        Arc::new(boxes.unwrap()),
    ];
    let schema = Type::group_type_builder("schema").with_fields(fields).build().unwrap();
    let geo = r#"{"version": "1.1.0", "primary_column": "shape", "columns": {"shape": {"encoding": "WKB", "geometry_types": [],
        "covering": {"bbox": {"xmin": ["bbox", "xmin"], "ymin": ["bbox", "ymin"], "xmax": ["bbox", "xmax"], "ymax": ["bbox", "ymax"]}}}}}"#;
    let entry = KeyValue::new("geo".to_owned(), geo.to_owned());
    let properties = WriterProperties::builder().set_key_value_metadata(Some(vec![entry])).build();
    let file = File::create(path).unwrap();
    let mut writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties)).unwrap();
    for Group { rows } in groups {
        let mut group = writer.next_row_group().unwrap();
        let mut into = group.next_column().unwrap().unwrap();
        into.typed::<DoubleType>().write_batch(&vec![0.5; rows.len()], None, None).unwrap();
        into.close().unwrap();
        let binary: Vec<ByteArray> = rows.iter().map(|(geometry, _)| wkb(geometry).into()).collect();
        let mut into = group.next_column().unwrap().unwrap();
        into.typed::<ByteArrayType>().write_batch(&binary, None, None).unwrap();
        into.close().unwrap();
        let levels: Vec<i16> = rows.iter().map(|(_, extent)| i16::from(extent.is_some())).collect();
        for side in 0..4 {
            let values: Vec<f64> = rows.iter().filter_map(|(_, extent)| extent.map(|sides| sides[side])).collect();
            let mut into = group.next_column().unwrap().unwrap();
            if is_narrow {
                let values: Vec<f32> = values.iter().map(|value| *value as f32).collect();
                into.typed::<FloatType>().write_batch(&values, Some(&levels), None).unwrap();
            } else {
                into.typed::<DoubleType>().write_batch(&values, Some(&levels), None).unwrap();
            }
            into.close().unwrap();
        }
        group.close().unwrap();
    }
    writer.close().unwrap();
}

/// The well-known binary of a polygon with one ring.
fn wkb(geometry: &Geometry) -> Vec<u8> {
    let Shape::Polygon(rings) = &geometry.shape else { panic!("{geometry:?}") };
    let mut bytes = vec![1, 3, 0, 0, 0, 1, 0, 0, 0];
    bytes.extend((rings[0].len() as u32).to_le_bytes());
    for p in &rings[0] {
        bytes.extend(p.x.to_le_bytes());
        bytes.extend(p.y.to_le_bytes());
    }
    bytes
}

/// Row groups of 40 squares, one for each row of the drawing.
fn rows_of_squares(count: u32) -> Vec<Group> {
    let of = |first: u32| Group {
        rows: (first..(first + ACROSS).min(count)).map(|one| (ring(square(one)), Some(square(one)))).collect(),
    };
    (0..count).step_by(ACROSS as usize).map(of).collect()
}

#[test]
fn a_window_has_the_features_whose_boxes_meet_it() {
    let layer = squares(1600);
    let (_folder, flat) = scratch("squares.fgb");
    write_as(&layer, &flat, Format::FlatGeobuf);
    let (_other, wide) = scratch("squares.parquet");
    write_groups(&wide, &rows_of_squares(1600), false);
    let (_last, narrow) = scratch("narrow.parquet");
    write_groups(&narrow, &rows_of_squares(1600), true);
    for (path, most) in [(&flat, 20), (&wide, 8), (&narrow, 8)] {
        assert_eq!(read(path).unwrap().features.len(), 1600);
        let mut file = open(path);
        let corners = file.corners().unwrap();
        assert!((corners[1].x - 40.0).abs() < 1e-4 && corners[0].y.abs() < 1e-4, "{corners:?}");
        for window in
            [[3.5, 3.5, 5.5, 4.5], [7.0, 7.0, 8.0, 8.0], [-9.0, -9.0, -1.0, -1.0], [39.5, 39.5, 99.0, f64::INFINITY]]
        {
            let meets = |one: &u32| {
                let [x0, y0, x1, y1] = square(*one);
                x0 <= window[2] && window[0] <= x1 && y0 <= window[3] && window[1] <= y1
            };
            let expected: Vec<u64> = (0..1600).filter(meets).map(u64::from).collect();
            assert_eq!(found(&mut file, window, &layer).unwrap(), expected, "{} {window:?}", path.display());
        }
        let before = file.amount();
        assert_eq!(found(&mut file, EVERYTHING, &layer).unwrap().len(), 1600);
        // The four windows were a small part of the file.
        let all = file.amount().bytes - before.bytes;
        assert!(before.bytes * 100 < all * most * 4, "{} of {all}", before.bytes);
        assert_eq!((before.of_features, file.amount().of_bytes), (1600, fs::metadata(path).unwrap().len()));
    }
}

#[test]
fn features_that_are_not_wanted_are_not_read() {
    let (_folder, path) = scratch("squares.fgb");
    write_as(&squares(400), &path, Format::FlatGeobuf);
    let mut file = open(&path);
    let before = file.amount();
    let mut numbers = Vec::new();
    let window = [Point::new(3.5, 3.5), Point::new(5.5, 3.5)];
    file.read(window, &mut |number| number != 124, &mut |number, _| numbers.push(number)).unwrap();
    assert_eq!((numbers, file.amount().features, before.features), (vec![123, 125], 2, 0));
}

#[test]
fn trees_of_all_sizes_are_written_and_read() {
    for count in [1, 2, 15, 16, 17, 256, 257, 300] {
        let layer = squares(count);
        let (_folder, path) = scratch("squares.fgb");
        write_as(&layer, &path, Format::FlatGeobuf);
        assert_eq!(read(&path).unwrap().features.len(), count as usize);
        let mut file = open(&path);
        for number in 0..count {
            let [x0, y0, x1, y1] = square(number);
            let middle = [f64::midpoint(x0, x1), f64::midpoint(y0, y1)];
            let window = [middle[0], middle[1], middle[0], middle[1]];
            assert_eq!(found(&mut file, window, &layer).unwrap(), [u64::from(number)], "{count}");
        }
    }
}

#[test]
fn files_without_boxes_have_no_windows() {
    let mut layer = squares(3);
    layer.features.push(Feature::default());
    let (_folder, path) = scratch("squares.fgb");
    write_as(&layer, &path, Format::FlatGeobuf);
    assert!(Indexed::open(&path, &ReadOptions::default()).unwrap().is_none());
    assert_eq!(read(&path).unwrap().features.len(), 4);
    let (_other, text) = scratch("squares.geojson");
    write_as(&layer, &text, Format::GeoJson);
    assert!(Indexed::open(&text, &ReadOptions::default()).unwrap().is_none());
    // A feature without geometry has no box in GeoParquet, and needs none.
    let (_last, wide) = scratch("squares.parquet");
    write_as(&layer, &wide, Format::GeoParquet);
    assert_eq!(found(&mut open(&wide), [0.5, 0.5, 0.5, 0.5], &layer).unwrap(), [0, 3]);
}

/// Returns the places at which windows over the whole plane detect false boxes.
fn lies(path: &Path, layer: &Layer) -> Vec<Place> {
    let mut file = open(path);
    let mut lies = Vec::new();
    for column in 0..8 {
        let [x0, x1] = [column, column + 1].map(|i| {
            if i == 0 {
                f64::NEG_INFINITY
            } else if i == 8 {
                f64::INFINITY
            } else {
                f64::from(i) * 5.0
            }
        });
        match found(&mut file, [x0, f64::NEG_INFINITY, x1, f64::INFINITY], layer) {
            Ok(_) => {}
            Err(ReadError::Content { place, cause: Cause::OutOfBox, .. }) => lies.push(place),
            Err(other) => panic!("{other}"),
        }
    }
    lies
}

#[test]
fn boxes_that_lie_are_found_by_some_window() {
    let layer = squares(80);
    let sound = rows_of_squares(80);
    let (_folder, path) = scratch("squares.parquet");
    write_groups(&path, &sound, false);
    assert_eq!(lies(&path, &layer), []);
    let liar = Place::Feature(47);
    let [x0, y0, x1, y1] = square(47);
    let nan = f64::NAN;
    for (extent, message) in [
        (Some([x0, y0, x1 - 0.5, y1]), "smaller"),
        (Some([x0 + 20.0, y0, x1 + 20.0, y1]), "elsewhere"),
        (Some([x0, y0, x0, y0]), "a point"),
        (Some([-50.0, y0, -49.0, y1]), "outside of the drawing"),
    ] {
        let mut groups = rows_of_squares(80);
        groups[1].rows[7].1 = extent;
        write_groups(&path, &groups, false);
        let found = lies(&path, &layer);
        assert!(!found.is_empty() && found.iter().all(|place| *place == liar), "{message}: {found:?}");
    }
    // A row whose box is useless has no known place. It is read with its row group, whose box covers the other rows.
    for extent in [Some([x1, y0, x0, y1]), Some([nan; 4])] {
        let mut groups = rows_of_squares(80);
        groups[1].rows[7].1 = extent;
        write_groups(&path, &groups, false);
        assert_eq!(lies(&path, &layer), [], "{extent:?}");
        assert!(found(&mut open(&path), [3.5, 1.5, 3.5, 1.5], &layer).unwrap().contains(&47));
        groups[1].rows[7].0 = ring([99.0, 1.0, 100.0, 2.0]);
        let mut moved = squares(80);
        moved.features[47].geometry = Some(groups[1].rows[7].0.clone());
        write_groups(&path, &groups, false);
        assert!(lies(&path, &moved).contains(&liar), "{extent:?}");
    }
}

#[test]
fn the_box_of_a_row_lies_in_that_of_its_row_group() {
    let layer = squares(80);
    let (_folder, path) = scratch("squares.parquet");
    write_groups(&path, &rows_of_squares(80), false);
    // The statistics claim that the upper sides of the second row group are at 1.5; they are at 2.
    let mut bytes = fs::read(&path).unwrap();
    let end = bytes.len() - 8;
    let footer = end - u32::from_le_bytes(bytes[end..end + 4].try_into().unwrap()) as usize;
    let places: Vec<usize> =
        (footer..end).filter(|place| bytes[*place..].starts_with(&2.0_f64.to_le_bytes())).collect();
    assert!(!places.is_empty());
    for place in places {
        bytes[place..place + 8].copy_from_slice(&1.5_f64.to_le_bytes());
    }
    fs::write(&path, bytes).unwrap();
    assert_eq!(found(&mut open(&path), [3.5, 0.5, 3.5, 0.5], &layer).unwrap(), [3]);
    match found(&mut open(&path), [3.5, 1.25, 3.5, 1.25], &layer).unwrap_err() {
        ReadError::Content { place: Place::Feature(40), cause: Cause::OutOfBox, .. } => {}
        other => panic!("{other}"),
    }
}

#[test]
fn how_far_a_layer_reaches_is_not_known_if_it_is_not_of_one_row() {
    let (_folder, path) = scratch("squares.parquet");
    // A row without a box, and a row across the antimeridian, among rows with boxes.
    for extent in [None, Some([178.0, 1.0, -178.0, 2.0])] {
        let mut groups = rows_of_squares(80);
        let moved = Group { rows: vec![(ring([178.0, 1.0, 182.0, 2.0]), extent), (ring(square(3)), Some(square(3)))] };
        groups.push(moved);
        write_groups(&path, &groups, false);
        let mut file = open(&path);
        assert_eq!(file.corners(), None, "{extent:?}");
        let mut numbers = Vec::new();
        let window = [Point::new(181.0, 1.0), Point::new(181.5, 2.0)];
        file.read(window, &mut |_| true, &mut |number, _| numbers.push(number)).unwrap();
        assert_eq!(numbers, [80], "{extent:?}");
    }
}

/// The numbers of nodes in the index of a file of 300 squares.
const NODES: [usize; 4] = [1, 2, 19, 300];

#[test]
fn an_index_that_lies_is_found_by_some_window() {
    let layer = squares(300);
    let (_folder, path) = scratch("squares.fgb");
    write_as(&layer, &path, Format::FlatGeobuf);
    assert_eq!(lies(&path, &layer), []);
    let bytes = fs::read(&path).unwrap();
    let header = u32::from_le_bytes(bytes[8..12].try_into().unwrap()) as usize;
    let index = 12 + header;
    let mut start = index;
    let mut caught = 0;
    for (level, count) in NODES.into_iter().enumerate() {
        for node in (0..count).step_by(if count == 300 { 7 } else { 1 }) {
            let at = start + 40 * node;
            for (side, by) in [(0, 0.25), (1, 0.25), (2, -0.25), (3, -0.25)] {
                let mut damaged = bytes.clone();
                let number = at + 8 * side;
                let value = f64::from_le_bytes(bytes[number..number + 8].try_into().unwrap()) + by;
                damaged[number..number + 8].copy_from_slice(&value.to_le_bytes());
                fs::write(&path, damaged).unwrap();
                assert!(!lies(&path, &layer).is_empty(), "level {level}, node {node}, side {side}");
                caught += 1;
            }
        }
        start += 40 * count;
    }
    assert_eq!(caught, 4 * (1 + 2 + 19 + 43));
    // A tree without ordered boxes is read to its leaves, which reveals features outside of the boxes above.
    let hidden = start - 40 * 300 + 40 * 290;
    let mut damaged = bytes.clone();
    damaged[hidden..hidden + 8].copy_from_slice(&f64::INFINITY.to_le_bytes());
    fs::write(&path, damaged).unwrap();
    assert_eq!(lies(&path, &layer), []);
    assert!(found(&mut open(&path), [10.5, 7.5, 10.5, 7.5], &layer).unwrap().contains(&290));
}

#[test]
fn an_index_in_another_order_is_refused() {
    let layer = squares(40);
    let (_folder, path) = scratch("squares.fgb");
    write_as(&layer, &path, Format::FlatGeobuf);
    let bytes = fs::read(&path).unwrap();
    let header = u32::from_le_bytes(bytes[8..12].try_into().unwrap()) as usize;
    let leaf = |number: usize| 12 + header + 40 * (1 + 3 + number);
    for (a, b) in [(0, 1), (7, 8), (38, 39), (3, 30)] {
        let mut damaged = bytes.clone();
        let [one, other] = [a, b].map(|number| bytes[leaf(number) + 32..leaf(number) + 40].to_vec());
        damaged[leaf(a) + 32..leaf(a) + 40].copy_from_slice(&other);
        damaged[leaf(b) + 32..leaf(b) + 40].copy_from_slice(&one);
        fs::write(&path, damaged).unwrap();
        let error = found(&mut open(&path), EVERYTHING, &layer).unwrap_err().to_string();
        assert!(error.contains("the index does not list the features in their order"), "{error}");
    }
    // An additional feature at the beginning: all others would have false numbers.
    let features = leaf(40);
    let first = 4 + u32::from_le_bytes(bytes[features..features + 4].try_into().unwrap()) as usize;
    let mut more = [&bytes[..features + first], &bytes[features..]].concat();
    for number in 0..40 {
        let place = leaf(number) + 32;
        let offset = u64::from_le_bytes(more[place..place + 8].try_into().unwrap()) + first as u64;
        more[place..place + 8].copy_from_slice(&offset.to_le_bytes());
    }
    fs::write(&path, more).unwrap();
    assert_eq!(found(&mut open(&path), [3.5, 0.5, 3.5, 0.5], &layer).unwrap(), [3]);
    let error = found(&mut open(&path), [0.5, 0.5, 0.5, 0.5], &layer).unwrap_err().to_string();
    assert!(error.contains("feature 0") && error.contains("in their order"), "{error}");
    fs::write(&path, &bytes[..bytes.len() - 1]).unwrap();
    let error = found(&mut open(&path), [39.5, 0.5, 39.5, 0.5], &layer).unwrap_err().to_string();
    assert!(error.contains("order") || error.contains("ends within"), "{error}");
}

#[test]
fn what_gdal_and_geopandas_wrote_has_windows() {
    for name in ["parcels.fgb", "parcels.parquet"] {
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/layer/data")).join(name);
        let layer = read(&path).unwrap();
        let mut file = open(&path);
        assert_eq!(found(&mut file, EVERYTHING, &layer).unwrap(), [0, 1], "{name}");
        let corners = file.corners().unwrap();
        let far = [corners[1].x + 1.0, corners[1].y + 1.0, f64::INFINITY, f64::INFINITY];
        assert!(
            found(&mut open(&path), far, &layer)
                .unwrap()
                .iter()
                .all(|one| layer.features[*one as usize].geometry.is_none())
        );
    }
}

/// Written by `pyarrow` 26.0.1 with Parquet's own type of geometries: 64 squares, eight in a row and sixteen in a row group; number 20 has no
/// geometry.
#[test]
fn windows_are_read_by_the_statistics_of_parquets_own_geometries() {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/layer/data/native.parquet"));
    let layer = read(path).unwrap();
    let mut file = open(path);
    assert_eq!(file.header().unwrap().crs.unwrap().code, Some(("EPSG".to_owned(), 2056)));
    assert_eq!(file.corners(), Some([Point::new(0.0, 0.0), Point::new(8.0, 8.0)]));
    assert_eq!(found(&mut file, EVERYTHING, &layer).unwrap().len(), 64);
    let all = file.amount().bytes;
    for group in 0..4_u32 {
        // In the second row of the group.
        let y = f64::from(group) * 2.0 + 1.5;
        let window = [3.5, y, 3.75, y];
        let before = file.amount().bytes;
        // The rows of the group have no separate boxes.
        let first = u64::from(group) * 16;
        assert_eq!(found(&mut file, window, &layer).unwrap(), (first..first + 16).collect::<Vec<_>>());
        let read = file.amount().bytes - before;
        assert!((all / 5..all / 3).contains(&read), "{read} of {all}");
        assert_eq!(file.passed([Point::new(3.5, y), Point::new(3.75, y)]), 16);
    }
    // A corner of square 41 is moved out of the box of its row group.
    let mut bytes = fs::read(path).unwrap();
    let side: Vec<u8> = [2.0_f64, 5.0, 2.0, 6.0].into_iter().flat_map(f64::to_le_bytes).collect();
    let places: Vec<usize> = (0..bytes.len() - 32).filter(|place| bytes[*place..].starts_with(&side)).collect();
    let [place] = places[..] else { panic!("{places:?}") };
    bytes[place + 24..place + 32].copy_from_slice(&66.0_f64.to_le_bytes());
    let (_folder, damaged) = scratch("native.parquet");
    fs::write(&damaged, bytes).unwrap();
    assert_eq!(found(&mut open(&damaged), [3.5, 3.5, 3.5, 3.5], &layer).unwrap().len(), 16);
    match found(&mut open(&damaged), [3.5, 5.5, 3.5, 5.5], &layer).unwrap_err() {
        ReadError::Content { place: Place::Feature(41), cause: Cause::OutOfBox, .. } => {}
        other => panic!("{other}"),
    }
}

#[test]
fn files_say_that_they_have_points_only() {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/layer/data/native-points.parquet"));
    assert!(open(path).has_only_points().unwrap());
    let point = |n| Geometry::new(Dimensions::Xy, Shape::Point(Some(Position::new(n, 0.0))));
    let points = [0.0, 1.0].map(|n| Feature { geometry: Some(point(n)), ..Feature::default() });
    let mut layer = Layer { features: points.to_vec(), ..Layer::default() };
    for (format, name) in [(Format::FlatGeobuf, "points.fgb"), (Format::GeoParquet, "points.parquet")] {
        let (_folder, path) = scratch(name);
        write_as(&layer, &path, format);
        assert!(open(&path).has_only_points().unwrap(), "{name}");
        layer.features.push(squares(1).features[0].clone());
        write_as(&layer, &path, format);
        assert!(!open(&path).has_only_points().unwrap(), "{name}");
        layer.features.pop();
    }
}
