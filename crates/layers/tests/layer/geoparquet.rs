//! `GeoParquet`: a file from other programs, round trips, Parquet's own type of geometries, and hostile files.

use crate::support::{from_text, read, scratch, through, world};
use parquet::basic::{ConvertedType, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, FixedLenByteArray, FixedLenByteArrayType};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use serde_json::{Value as Json, json};
use std::fs::File;
use std::path::Path;
use std::sync::Arc;
use twinedge_layers::{
    Cause, Crs, Dimensions, Feature, FieldKind, Format, Layer, Loss, Place, ReadError, Shape, Value, losses, write_path,
};

/// Written by `geopandas` 1.2.0 and `pyarrow` 26.0.1: two features, the second without geometry, in EPSG:2056, with a column of boxes.
const PARCELS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/layer/data/parcels.parquet");

/// The point (1, 2) in well-known binary.
const POINT: [u8; 21] = [1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xF0, 0x3F, 0, 0, 0, 0, 0, 0, 0, 0x40];

/// Returns the value under a key in a file's metadata.
fn entry_of(path: &Path, key: &str) -> Option<String> {
    let reader = SerializedFileReader::new(File::open(path).unwrap()).unwrap();
    let entries = reader.metadata().file_metadata().key_value_metadata().unwrap();
    entries.iter().find(|entry| entry.key == key).and_then(|entry| entry.value.clone())
}

/// The metadata of the geometries of a file.
fn geo_of(path: &Path) -> Json {
    serde_json::from_str(&entry_of(path, "geo").unwrap()).unwrap()
}

/// Writes a file with one row and one column of geometries, with this type and metadata.
fn write_point(path: &Path, logical: Option<LogicalType>, metadata: &[(&str, &str)]) {
    let column = Type::primitive_type_builder("shape", Physical::BYTE_ARRAY)
        .with_repetition(Repetition::REQUIRED)
        .with_logical_type(logical);
    let schema = Type::group_type_builder("schema").with_fields(vec![Arc::new(column.build().unwrap())]).build();
    let metadata = metadata.iter().map(|(key, value)| KeyValue::new((*key).to_owned(), (*value).to_owned())).collect();
    let properties = WriterProperties::builder().set_key_value_metadata(Some(metadata)).build();
    let mut writer =
        SerializedFileWriter::new(File::create(path).unwrap(), Arc::new(schema.unwrap()), Arc::new(properties))
            .unwrap();
    let mut group = writer.next_row_group().unwrap();
    let mut into = group.next_column().unwrap().unwrap();
    into.typed::<ByteArrayType>().write_batch(&[ByteArray::from(POINT.to_vec())], None, None).unwrap();
    into.close().unwrap();
    group.close().unwrap();
    writer.close().unwrap();
}

/// Returns the reason for refusing a file as a whole.
fn refused(path: &Path) -> String {
    match read(path).unwrap_err() {
        ReadError::Content { format: Format::GeoParquet, place: Place::Header, cause: Cause::Invalid(message) } => {
            message
        }
        other => panic!("{other}"),
    }
}

#[test]
fn what_geopandas_wrote_is_read() {
    use FieldKind::{Bool, Bytes, Date, DateTime, Integer, Json as List, Real, Text};

    let layer = read(Path::new(PARCELS)).unwrap();
    assert_eq!(layer.header.crs, Some(Crs::epsg(2056)));
    let kinds: Vec<(&str, FieldKind)> = layer.header.fields.iter().map(|field| (&*field.name, field.kind)).collect();
    assert_eq!(
        kinds,
        [
            ("zone", Text),
            ("small", Integer),
            ("big", Integer),
            ("size", Real),
            ("price", Real),
            ("exact", Text),
            ("day", Date),
            ("utc", DateTime),
            ("clock", DateTime),
            ("noon", Text),
            ("open", Bool),
            ("raw", Bytes),
            ("tags", List),
            ("owner", List),
            ("names", List)
        ]
    );
    let [first, second] = &layer.features[..] else { panic!("{} features", layer.features.len()) };
    let values: Vec<Value> = first.attributes.iter().map(|(_, value)| value.clone()).collect();
    assert_eq!(
        values,
        [
            Value::Text("Zürich".into()),
            Value::Integer(1),
            Value::Json(u64::MAX.into()),
            Value::Real(1.5),
            Value::Real(12.3),
            Value::Text("12345678901234567890.12".into()),
            Value::Date("2020-02-29".into()),
            Value::DateTime("2020-02-29T12:30:00.123456789Z".into()),
            Value::DateTime("2020-02-29T12:30:00".into()),
            Value::Text("12:00:00.500".into()),
            Value::Bool(true),
            Value::Bytes(vec![0, 0xFF]),
            Value::Json(json!(["a", null])),
            Value::Json(json!({"name": "Meier", "share": 0.5})),
            Value::Json(json!({"de": "Bach"}))
        ]
    );
    let geometry = first.geometry.as_ref().unwrap();
    assert_eq!(geometry.dimensions, Dimensions::Xyz);
    let Shape::Polygon(rings) = &geometry.shape else { panic!("{geometry:?}") };
    assert_eq!(rings.iter().map(Vec::len).collect::<Vec<_>>(), [5, 4]);
    assert_eq!((rings[1][1].x, rings[1][1].y, &*rings[1][1].more), (1.0, 2.0, &[2.0][..]));
    assert_eq!(second.geometry, None);
    assert_eq!(second.get("small"), Some(&Value::Integer(-5)));
    assert_eq!(second.get("size"), Some(&Value::Real(f64::INFINITY)));
    assert_eq!(second.get("utc"), Some(&Value::DateTime("1970-01-01T00:00:00Z".into())));
    assert_eq!([second.get("zone"), second.get("price")], [Some(&Value::Null); 2]);
}

#[test]
fn what_was_read_comes_back() {
    let layer = read(Path::new(PARCELS)).unwrap();
    let kinds: Vec<Loss> = losses(&layer, Format::GeoParquet);
    // Nanoseconds are finer than the written precision, and the model has no unsigned 64-bit integers.
    let lost = |column: &str, from, to| Loss::Type { column: column.to_owned(), from, to };
    assert_eq!(
        kinds,
        [lost("big", FieldKind::Json, FieldKind::Text), lost("utc", FieldKind::DateTime, FieldKind::Text)]
    );
    let again = through(&layer, Format::GeoParquet);
    assert_eq!(again.features[0].get("utc"), Some(&Value::Text("2020-02-29T12:30:00.123456789Z".into())));
    for (before, after) in layer.features.iter().zip(&again.features) {
        assert_eq!(before.geometry, after.geometry);
        for ((name, one), (_, other)) in before.attributes.iter().zip(&after.attributes) {
            assert!(one == other || one.text() == other.text(), "{name}: {one:?} {other:?}");
        }
    }
    assert_eq!(again.header.crs, layer.header.crs);
    // Further round trips change nothing.
    assert!(losses(&again, Format::GeoParquet).is_empty());
    assert_eq!(through(&again, Format::GeoParquet), again);
}

#[test]
fn several_row_groups_come_back_in_order() {
    let feature =
        |number: i64| Feature { attributes: vec![("n".into(), Value::Integer(number))], ..Feature::default() };
    let layer = Layer { features: (0..70_000).map(feature).collect(), ..Layer::default() };
    let again = through(&layer, Format::GeoParquet);
    assert_eq!(again.features, layer.features);
}

/// The expected metadata follow the specification, version 1.1.0.
#[test]
fn the_metadata_describe_the_geometries() {
    let (_folder, path) = scratch("world.parquet");
    write_path(&world(), &path, Format::GeoParquet).unwrap();
    let geo = geo_of(&path);
    assert_eq!((&geo["version"], &geo["primary_column"]), (&json!("1.1.0"), &json!("geometry")));
    let column = &geo["columns"]["geometry"];
    assert_eq!(column["encoding"], "WKB");
    assert_eq!(column["geometry_types"], json!(["MultiPolygon", "Polygon"]));
    assert_eq!(column["covering"]["bbox"]["ymax"], json!(["bbox", "ymax"]));
    let bbox: Vec<f64> = serde_json::from_value(column["bbox"].clone()).unwrap();
    let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
    for geometry in world().features.iter().filter_map(|feature| feature.geometry.as_ref()) {
        geometry.shape.visit(&mut |p| (least, greatest) = (least.min(p.x), greatest.max(p.x)));
    }
    assert_eq!((bbox[0], bbox[2]), (least, greatest));
    // Some coordinates exceed 180 degrees, so they are not known to be longitudes. Longitudes and latitudes need no reference system.
    assert_eq!(column.get("crs"), Some(&Json::Null));
    write_path(
        &from_text(r#"{"type":"Point","coordinates":[1,2]}"#),
        &path.with_extension("geoparquet"),
        Format::GeoParquet,
    )
    .unwrap();
    assert_eq!(geo_of(&path.with_extension("geoparquet"))["columns"]["geometry"].get("crs"), None);
}

#[test]
fn reference_systems_come_back() {
    let layer = |crs: Option<Crs>| {
        let mut layer = from_text("POINT(1 2)\n");
        layer.header.crs = crs;
        layer
    };
    let own = json!({"type": "EngineeringCRS", "name": "site", "datum": {"type": "EngineeringDatum", "name": "peg"},
        "coordinate_system": {"subtype": "Cartesian", "axis": []}});
    let of_own = Crs { projjson: Some(own.clone()), ..Crs::default() };
    for crs in [None, Some(Crs::epsg(4326)), Some(Crs::epsg(2056)), Some(Crs::epsg(3857)), Some(of_own.clone())] {
        let before = layer(crs.clone());
        assert!(losses(&before, Format::GeoParquet).is_empty());
        assert_eq!(through(&before, Format::GeoParquet).header.crs, crs);
    }
    assert_eq!(of_own.name(), "site");
    assert!(of_own.is_other());
    assert_eq!(losses(&layer(Some(of_own)), Format::GeoPackage), [Loss::Crs("site".into())]);
    let (_folder, path) = scratch("bern.parquet");
    write_path(&layer(Some(Crs::epsg(2056))), &path, Format::GeoParquet).unwrap();
    let crs = geo_of(&path)["columns"]["geometry"]["crs"].clone();
    assert_eq!((&crs["type"], &crs["id"]), (&json!("ProjectedCRS"), &json!({"authority": "EPSG", "code": 2056})));
    // A text without a number has no known definition.
    let unknown = Crs { wkt: Some("LOCAL_CS[\"x\"]".into()), ..Crs::default() };
    assert_eq!(losses(&layer(Some(unknown)), Format::GeoParquet), [Loss::Crs("x".into())]);
    assert_eq!(losses(&layer(Some(Crs::epsg(99_999))), Format::GeoParquet), [Loss::Crs("EPSG:99999".into())]);
}

#[test]
fn columns_named_as_those_of_the_format_keep_their_names() {
    let layer = from_text(
        r#"{"type":"Feature","properties":{"geometry":"flat","bbox":"none"},"geometry":{"type":"Point","coordinates":[1,2]}}"#,
    );
    let again = through(&layer, Format::GeoParquet);
    assert_eq!(again.features, layer.features);
}

#[test]
fn what_cannot_be_held_is_said() {
    let layer = from_text(
        r#"{"type":"FeatureCollection","name":"x","source":1,"features":[
{"type":"Feature","id":1,"properties":{"a":1},"geometry":null},
{"type":"Feature","id":"1","properties":{"a":"b","c":2},"geometry":null}]}"#,
    );
    assert_eq!(
        losses(&layer, Format::GeoParquet),
        [
            Loss::Ids(2),
            Loss::Members(vec!["source".into()]),
            Loss::Name("x".into()),
            Loss::Type { column: "a".into(), from: FieldKind::Integer, to: FieldKind::Text },
            Loss::Absent(1)
        ]
    );
}

#[test]
fn ids_are_a_column_that_the_metadata_name() {
    let feature = |id: &str| format!(r#"{{"type":"Feature"{id},"properties":{{"fid":"a","id":2}},"geometry":null}}"#);
    let file = |ids: [&str; 2]| {
        let layer = from_text(&format!("{}\n{}\n", feature(ids[0]), feature(ids[1])));
        assert!(losses(&layer, Format::GeoParquet).is_empty());
        let (folder, path) = scratch("ids.parquet");
        write_path(&layer, &path, Format::GeoParquet).unwrap();
        assert_eq!(read(&path).unwrap().features, layer.features);
        (folder, path)
    };
    // The column of ids is named as by GDAL. The layer's own column keeps its name.
    let (_folder, path) = file([r#","id":-7"#, ""]);
    let schema: Json = serde_json::from_str(&entry_of(&path, "gdal:schema").unwrap()).unwrap();
    assert_eq!(schema, json!({"fid": "fid_1", "columns": {}}));
    let (_folder, path) = file([r#","id":"A-1""#, r#","id":"é""#]);
    assert_eq!((entry_of(&path, "gdal:schema"), entry_of(&path, "twinedge:id").as_deref()), (None, Some("id_1")));
    let (_folder, path) = file(["", ""]);
    assert_eq!((entry_of(&path, "gdal:schema"), entry_of(&path, "twinedge:id")), (None, None));
}

#[test]
fn metadata_that_name_no_column_of_ids_are_none() {
    for metadata in [r#"{"fid":"shape"}"#, r#"{"fid":"none"}"#, r#"{"fid":3}"#, r#"{"fid":""}"#, "{", "[]"] {
        let (_folder, path) = scratch("no_ids.parquet");
        write_point(&path, Some(LogicalType::geometry(None)), &[("gdal:schema", metadata)]);
        let layer = read(&path).unwrap();
        assert!(layer.features[0].id.is_none() && layer.features[0].geometry.is_some(), "{metadata}");
    }
}

/// Dates and times whose text would not survive a round trip stay text.
#[test]
fn moments_are_moments_only_if_they_come_back_as_they_were() {
    let through = |values: &[Value]| {
        let feature = |value: &Value| Feature { attributes: vec![("t".into(), value.clone())], ..Feature::default() };
        let layer = Layer { features: values.iter().map(feature).collect(), ..Layer::default() };
        through(&layer, Format::GeoParquet).features.iter().map(|f| f.get("t").unwrap().clone()).collect::<Vec<_>>()
    };
    let moment = |text: &str| Value::DateTime(text.to_owned());
    let kept = [moment("0001-01-01T00:00:00Z"), Value::Null, moment("9999-12-31T23:59:59.999999Z")];
    assert_eq!(through(&kept), kept);
    let days = [Value::Date("2024-02-29".into()), Value::Date("1969-12-31".into())];
    assert_eq!(through(&days), days);
    for text in ["2026-01-31T12:00:00+01:00", "2026-01-31 12:00:00Z", "2026-01-31T12:00:00.500000Z", "yesterday"] {
        assert_eq!(through(&[moment(text)]), [Value::Text(text.to_owned())]);
    }
    // Moments with and without a time zone have no common type.
    let mixed = [moment("2026-01-31T12:00:00Z"), moment("2026-01-31T12:00:00")];
    assert!(through(&mixed).iter().all(|value| matches!(value, Value::Text(_))));
    assert_eq!(through(&[Value::Date("2024-02-30".into())]), [Value::Text("2024-02-30".into())]);
}

#[test]
fn the_own_type_of_parquet_is_read() {
    let (_folder, path) = scratch("native.parquet");
    let crs = |text: &str, metadata: &[(&str, &str)]| {
        write_point(&path, Some(LogicalType::geometry(Some(text.to_owned()))), metadata);
        let layer = read(&path).unwrap();
        assert_eq!(layer.features[0].geometry, from_text("POINT(1 2)\n").features[0].geometry);
        layer.header.crs
    };
    assert_eq!(crs("srid:2056", &[]), Some(Crs::epsg(2056)));
    assert_eq!(crs("srid:0", &[]), None);
    assert_eq!(crs("EPSG:3857", &[]), Some(Crs::epsg(3857)));
    assert_eq!(crs("OGC:CRS84", &[]), Some(Crs::epsg(4326)));
    assert_eq!(crs(r#"{"id":{"authority":"EPSG","code":2056}}"#, &[]), Some(Crs::epsg(2056)));
    assert_eq!(crs("projjson:here", &[("here", r#"{"id":{"authority":"EPSG","code":2056}}"#)]), Some(Crs::epsg(2056)));
    assert_eq!(crs("nonsense", &[]), None);
    write_point(&path, Some(LogicalType::geometry(None)), &[]);
    assert_eq!(read(&path).unwrap().header.crs, Some(Crs::epsg(4326)));
    // The reader reports and keeps edges that are not straight on the map.
    write_point(&path, Some(LogicalType::geography(None, None)), &[]);
    let round = read(&path).unwrap();
    assert_eq!(round.header.members.get("edges"), Some(&json!("spherical")));
    assert_eq!(losses(&round, Format::GeoJson), []);
    assert_eq!(losses(&round, Format::GeoPackage), [Loss::Members(vec!["edges".into()])]);
    assert_eq!(through(&round, Format::GeoParquet).header.members, round.header.members);
}

#[test]
fn what_is_not_read_is_refused_with_a_reason() {
    let (_folder, path) = scratch("other.parquet");
    write_point(&path, None, &[]);
    assert!(refused(&path).starts_with("it has no column of geometries"));
    let of_column = |column: Json| {
        let geo = json!({"primary_column": "shape", "columns": {"shape": column}}).to_string();
        write_point(&path, None, &[("geo", &geo)]);
    };
    of_column(json!({"encoding": "polygon"}));
    assert_eq!(
        refused(&path),
        "the geometries are encoded as \"polygon\", and only WKB is read here: \
         `ogr2ogr -f Parquet -lco GEOMETRY_ENCODING=WKB map.parquet FILE`"
    );
    // `DuckDB` writes a text in place of PROJJSON.
    for (crs, expected) in [
        (Json::Null, None),
        (json!("EPSG:2056"), Some(2056)),
        (json!("OGC:CRS84"), Some(4326)),
        (json!("EPSG:4326"), Some(4326)),
    ] {
        of_column(json!({"encoding": "WKB", "crs": crs}));
        assert_eq!(read(&path).unwrap().header.crs, expected.map(Crs::epsg), "{crs}");
    }
    for (geo, reason) in [
        ("{", "the metadata \"geo\" are not JSON: EOF while parsing an object at line 1 column 1"),
        ("{}", "the metadata \"geo\" name no primary_column"),
        (r#"{"primary_column":"x","columns":{}}"#, "the metadata \"geo\" do not describe x"),
        (
            r#"{"primary_column":"x","columns":{"x":{"encoding":"WKB"}}}"#,
            "it has no column x, where the geometries should be",
        ),
    ] {
        write_point(&path, None, &[("geo", geo)]);
        assert_eq!(refused(&path), reason);
    }
}

/// The crate `parquet` has no value for intervals.
#[test]
fn intervals_are_refused() {
    let (_folder, path) = scratch("interval.parquet");
    let column = Type::primitive_type_builder("lease", Physical::FIXED_LEN_BYTE_ARRAY)
        .with_length(12)
        .with_repetition(Repetition::REQUIRED)
        .with_converted_type(ConvertedType::INTERVAL);
    let schema = Type::group_type_builder("schema").with_fields(vec![Arc::new(column.build().unwrap())]).build();
    let metadata = r#"{"primary_column":"shape","columns":{"shape":{"encoding":"WKB"}}}"#;
    let metadata = vec![KeyValue::new("geo".to_owned(), metadata.to_owned())];
    let properties = WriterProperties::builder().set_key_value_metadata(Some(metadata)).build();
    let file = File::create(&path).unwrap();
    let mut writer = SerializedFileWriter::new(file, Arc::new(schema.unwrap()), Arc::new(properties)).unwrap();
    let mut group = writer.next_row_group().unwrap();
    let mut into = group.next_column().unwrap().unwrap();
    let value = FixedLenByteArray::from(vec![0; 12]);
    into.typed::<FixedLenByteArrayType>().write_batch(&[value], None, None).unwrap();
    into.close().unwrap();
    group.close().unwrap();
    writer.close().unwrap();
    assert_eq!(refused(&path), "the column lease has intervals of time, which are not read here");
}
