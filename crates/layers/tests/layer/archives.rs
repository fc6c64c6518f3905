//! Layers in archives, and archives that are damaged, expand without end, or contain unsafe paths.

use crate::support::{from_bytes, from_text, read, scratch, world};
use flate2::Compression;
use flate2::write::GzEncoder;
use std::fs;
use std::io::{Cursor, Write};
use std::path::Path;
use std::sync::Arc;
use twinedge_layers::{
    ArchiveError, Files, Format, Layer, ReadError, ReadOptions, UnpackedFiles, read_layer, read_path, unpack_bytes,
    write, write_files, write_path, zip,
};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// A zip archive with these files.
fn zipped(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in files {
        archive
            .start_file(*name, SimpleFileOptions::default().compression_method(CompressionMethod::Deflated))
            .unwrap();
        archive.write_all(content).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

fn gzipped(content: &[u8]) -> Vec<u8> {
    let mut gzip = GzEncoder::new(Vec::new(), Compression::default());
    gzip.write_all(content).unwrap();
    gzip.finish().unwrap()
}

fn geojson(layer: &Layer) -> Vec<u8> {
    let mut text = Vec::new();
    write(layer, &mut text, Format::GeoJson).unwrap();
    text
}

fn parts_of_shapefile(layer: &Layer) -> Vec<(String, Vec<u8>)> {
    let (folder, path) = scratch("countries.shp");
    write_path(layer, &path, Format::Shapefile).unwrap();
    let files = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().path());
    files.map(|path| (path.file_name().unwrap().to_str().unwrap().to_owned(), fs::read(&path).unwrap())).collect()
}

/// Reads the layer of an archive in memory, with all its parts.
fn in_memory(archive: &[u8]) -> Result<Layer, ReadError> {
    let UnpackedFiles { files, path, layer } = unpack_bytes(archive, None, None)?.expect("it is an archive");
    let main = files.share(&path).expect("it was unpacked");
    let options = ReadOptions { layer, files: Some(Arc::new(files)), ..ReadOptions::default() };
    read_layer(&mut &*main, Some(&path), &options)
}

#[test]
fn a_shapefile_is_written_zipped_and_read_without_a_disk() {
    let layer = world();
    let files = write_files(&layer, Path::new("countries.shp"), Format::Shapefile).unwrap();
    let on_disk: Files = parts_of_shapefile(&layer).into_iter().map(|(name, bytes)| (name.into(), bytes)).collect();
    assert_eq!(files, on_disk);
    let (_folder, path) = scratch("countries.zip");
    let archive = zip(&files).unwrap();
    fs::write(&path, &archive).unwrap();
    assert_eq!(in_memory(&archive).unwrap(), read(&path).unwrap());
    assert_eq!(in_memory(&gzipped(&geojson(&layer))).unwrap(), layer);
    // Missing parts are not looked for on disk.
    let alone: Files =
        [(path.with_extension("shp"), files.get(Path::new("countries.shp")).unwrap().to_vec())].into_iter().collect();
    let options = ReadOptions { files: Some(Arc::new(alone)), ..ReadOptions::default() };
    fs::write(path.with_extension("dbf"), files.get(Path::new("countries.dbf")).unwrap()).unwrap();
    let bytes = files.get(Path::new("countries.shp")).unwrap();
    let without_table = read_layer(&mut &*bytes, Some(&path.with_extension("shp")), &options).unwrap();
    assert!(without_table.features.iter().all(|feature| feature.attributes.is_empty()));
}

#[test]
fn an_archive_that_expands_without_end_is_refused_in_memory_too() {
    let archive = gzipped(&vec![0; 1 << 20]).repeat(90);
    assert!(matches!(unpack_bytes(&archive, None, None), Err(ReadError::Archive(ArchiveError::Expands { .. }))));
}

#[test]
fn a_zipped_shapefile_is_read_as_it_is() {
    let parts = parts_of_shapefile(&world());
    let names: Vec<String> = parts.iter().map(|(name, _)| format!("data/2026/{name}")).collect();
    let mut files: Vec<(&str, &[u8])> = vec![("readme.txt", b"countries"), ("__MACOSX/countries.shp", b"?")];
    files.extend(names.iter().zip(&parts).map(|(name, (_, content))| (name.as_str(), content.as_slice())));
    let (folder, path) = scratch("countries.zip");
    fs::write(&path, zipped(&files)).unwrap();
    for (name, content) in &parts {
        fs::write(folder.path().join(name), content).unwrap();
    }
    let plain = read(&folder.path().join("countries.shp")).unwrap();
    assert_eq!(read(&path).unwrap(), plain);
    // Also from a stream.
    assert_eq!(from_bytes(&fs::read(&path).unwrap()).unwrap(), plain);
}

#[test]
fn gzip_data_is_read_as_what_is_in_it() {
    let layer = from_text("POINT(1 2)\nPOINT(3 4)\n");
    let (folder, geopackage) = scratch("points.gpkg");
    write_path(&layer, &geopackage, Format::GeoPackage).unwrap();
    for (name, content) in [("points.geojson.gz", geojson(&layer)), ("points.gpkg.gz", fs::read(&geopackage).unwrap())]
    {
        let packed = gzipped(&content);
        let path = folder.path().join(name);
        fs::write(&path, &packed).unwrap();
        assert_eq!(read(&path).unwrap().features[1].geometry, layer.features[1].geometry, "{name}");
        assert_eq!(from_bytes(&packed).unwrap().features.len(), 2, "{name}");
    }
}

#[test]
fn one_of_several_layers_of_an_archive_is_chosen_by_its_name() {
    let [one, two] = ["POINT(1 2)\n", "POINT(1 2)\nPOINT(3 4)\n"];
    let (_folder, path) = scratch("both.zip");
    fs::write(&path, zipped(&[("a/one.wkt", one.as_bytes()), ("b/two.wkt", two.as_bytes())])).unwrap();
    let with = |layer: Option<&str>| {
        read_path(&path, &ReadOptions { layer: layer.map(str::to_owned), ..ReadOptions::default() })
    };
    for (name, count) in [("one", 1), ("two", 2), ("two.wkt", 2), ("b/two.wkt", 2)] {
        assert_eq!(with(Some(name)).unwrap().features.len(), count, "{name}");
    }
    for wanted in [None, Some("three")] {
        let Err(ReadError::Layers { layers, .. }) = with(wanted) else { panic!("{wanted:?}") };
        assert_eq!(layers, [Path::new("a/one.wkt"), Path::new("b/two.wkt")].map(|path| path.display().to_string()));
    }
}

fn archive_error(bytes: &[u8]) -> ArchiveError {
    match from_bytes(bytes) {
        Err(ReadError::Archive(error)) => error,
        other => panic!("{other:?}"),
    }
}

#[test]
fn archives_that_expand_without_end_are_refused() {
    let zeros = vec![0; 1 << 20];
    assert_eq!(archive_error(&gzipped(&zeros).repeat(90)), ArchiveError::Expands { times: 200 });
    // The sizes declared in a zip archive are not trusted: the limit applies to all parts of a layer together.
    let parts = ["shp", "shx", "dbf", "prj", "cpg"].map(|extension| format!("a.{extension}"));
    let zeros = vec![0; 18 << 20];
    let files: Vec<(&str, &[u8])> = parts.iter().map(|name| (name.as_str(), zeros.as_slice())).collect();
    assert_eq!(archive_error(&zipped(&files)), ArchiveError::Expands { times: 200 });
}

#[test]
fn damaged_archives_end_in_errors() {
    let text = geojson(&world());
    let (gzip, zip) = (gzipped(&text), zipped(&[("world.geojson", &text)]));
    for packed in [&gzip, &zip] {
        assert!(matches!(archive_error(&packed[..packed.len() / 2]), ArchiveError::Damaged(_)));
        let mut changed = packed.clone();
        for byte in &mut changed[200..300] {
            *byte ^= 0x55;
        }
        assert!(from_bytes(&changed).is_err());
    }
    assert_eq!(archive_error(&zipped(&[("letter.docx", b"")])), ArchiveError::NoLayer);
}

#[test]
fn files_of_an_archive_stay_in_their_folder() {
    assert_eq!(
        archive_error(&zipped(&[("../world.geojson", b"{}"), ("/etc/../../x.wkt", b"")])),
        ArchiveError::NoLayer
    );
    // An archive in an archive is not unpacked.
    let nested = gzipped(&gzipped(b"POINT(1 2)"));
    assert!(matches!(from_bytes(&nested), Err(ReadError::Foreign(_))));
}
