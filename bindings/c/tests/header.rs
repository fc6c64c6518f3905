//! `include/twinedge.h` is up to date with the sources, and every file that names a version names the same.

use std::path::Path;

const FOLDER: &str = env!("CARGO_MANIFEST_DIR");

#[test]
fn the_header_is_current() {
    let config = cbindgen::Config::from_file(Path::new(FOLDER).join("cbindgen.toml")).expect("cbindgen.toml");
    let mut made = Vec::new();
    cbindgen::generate_with_config(FOLDER, config).expect("the sources are Rust").write(&mut made);
    let path = Path::new(FOLDER).join("include/twinedge.h");
    if std::env::var_os("UPDATE_HEADER").is_some() {
        std::fs::write(&path, &made).expect("the header can be written");
    }
    let kept = std::fs::read(&path).unwrap_or_default();
    assert!(kept == made, "the header is old: UPDATE_HEADER=1 cargo test --test header");
}

#[test]
fn every_package_names_the_version() {
    let version = env!("CARGO_PKG_VERSION");
    for (file, line) in [
        ("twinedge.pc", format!("Version: {version}")),
        ("twinedge-config-version.cmake", format!("set(PACKAGE_VERSION \"{version}\")")),
    ] {
        let text = std::fs::read_to_string(Path::new(FOLDER).join(file)).expect("the file can be read");
        assert!(text.lines().any(|each| each == line), "{file} does not say {line}");
    }
}
