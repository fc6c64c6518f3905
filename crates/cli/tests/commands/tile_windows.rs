//! `twinedge tile` for files with boxes: the same bytes as from the whole file, less reading, false boxes, and missing tiles.

use crate::support::{complaint, data, json, scratch_folder, twinedge, twinedge_reading, twinedge_with};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::Path;

/// The number of squares in a row, and of rows.
const ACROSS: usize = 24;

/// Rows of squares. Some overlap their right neighbours, both across and away from the lines of any grid.
fn squares() -> String {
    let mut lines = String::new();
    for number in 0..ACROSS * ACROSS {
        let [x, y] = [number % ACROSS, number / ACROSS].map(|i| i as f64);
        let right = if number % 37 == 5 { x + 1.3 } else { x + 1.0 };
        let ring = [[x, y], [right, y], [right, y + 1.0], [x, y + 1.0], [x, y]];
        let geometry = json!({"type": "Polygon", "coordinates": [ring]});
        writeln!(lines, "{}", json!({"type": "Feature", "properties": {"owner": number}, "geometry": geometry}))
            .unwrap();
    }
    lines
}

fn convert(from: &str, folder: &Path, name: &str) -> String {
    let to = folder.join(name).to_str().unwrap().to_owned();
    // Ids are lost.
    let output = twinedge(&["convert", from, "-o", &to, "--lossy"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    to
}

/// Makes a tile. Returns the path of its summary, and the output.
fn tile(file: &str, grid: &str, at: &str, folder: &Path) -> Result<(String, String), String> {
    let summary = folder.join(format!("{}-{at}.summary", Path::new(file).extension().unwrap().display()));
    let summary = summary.to_str().unwrap().to_owned();
    let output = twinedge(&["tile", file, "--grid", grid, "--tile", at, "-o", &summary, "--verbose"]);
    let said = String::from_utf8(output.stderr).unwrap();
    if output.status.success() { Ok((summary, said)) } else { Err(said) }
}

#[test]
fn the_summary_of_a_tile_has_the_same_bytes_whether_all_was_read_or_its_window() {
    let folder = scratch_folder("tile-windows");
    let text = data("world-110m-crossing.geojson");
    let others = ["world.fgb", "world.parquet"].map(|name| convert(&text, &folder, name));
    for at in ["0,0", "1,0", "0,1", "1,1"] {
        let (whole, said) = tile(&text, "2x2", at, &folder).unwrap();
        assert!(said.contains("the whole file was read"), "{said}");
        let whole = std::fs::read(whole).unwrap();
        assert!(String::from_utf8_lossy(&whole).contains("\"cut\":{"));
        for file in &others {
            let (summary, _) = tile(file, "2x2", at, &folder).unwrap();
            assert!(std::fs::read(summary).unwrap() == whole, "{file} {at}");
        }
    }
}

#[test]
fn tiles_read_what_lies_around_them_and_add_up_to_the_audit() {
    let folder = scratch_folder("tile-windows-sum");
    let text = folder.join("squares.geojsonl").to_str().unwrap().to_owned();
    std::fs::write(&text, squares()).unwrap();
    let (_, whole) = json(&["audit", &text, "--format", "json"]);
    assert!(whole["coverage"]["overlaps"].as_u64() > Some(10));
    let file = convert(&text, &folder, "squares.fgb");
    let mut files = Vec::new();
    for at in ["0,0", "1,0", "2,0", "0,1", "1,1", "2,1", "0,2", "1,2", "2,2"] {
        let (summary, said) = tile(&file, "3x3", at, &folder).unwrap();
        // Eight squares each way, and the squares around them.
        let (read, rest) = said.rsplit_once(": ").unwrap().1.split_once(" of 576 features were read, and ").unwrap();
        let read: usize = read.parse().unwrap();
        assert!((81..=144).contains(&read), "{said}");
        let bytes = rest.trim_end().split(" bytes; the file has ");
        let bytes: Vec<u64> = bytes.map(|n| n.replace(',', "").parse().unwrap()).collect();
        assert!(bytes[0] * 2 < bytes[1], "{said}");
        files.push(summary);
    }
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    let (status, sum) = json(&[&["sum", "--format", "json"], &files[..]].concat());
    assert_eq!((status, &sum["rules"], &sum["counts"]), (Some(1), &whole["rules"], &whole["counts"]));
    for key in ["overlaps", "gaps", "near_misses", "slivers", "duplicates", "ogc_invalid", "mismatches", "not_checked"]
    {
        assert_eq!(sum["coverage"][key], whole["coverage"][key], "{key}");
    }

    // The error names a tile made without cuts, and a tile whose cuts differ from its neighbours' cuts.
    let saved: Value = serde_json::from_slice(&std::fs::read(files[4]).unwrap()).unwrap();
    let with = |cut: Value| {
        let mut saved = saved.clone();
        saved["cut"] = cut;
        std::fs::write(files[4], saved.to_string()).unwrap();
        let (status, sum) = json(&[&["sum", "--format", "json"], &files[..]].concat());
        assert_eq!(status, Some(1));
        sum["coverage"]["not_checked"].as_str().unwrap().to_owned()
    };
    assert_eq!(with(Value::Null), "borders cross, and tile (1,1) was made without cuts");
    let why = with(saved["summary"].clone());
    assert!(why.starts_with("borders cross, and tile (1,1): edges still meet elsewhere than at vertices"), "{why}");
}

#[test]
fn a_box_that_is_smaller_than_its_feature_is_an_error_in_the_tile_where_it_shows_it() {
    let folder = scratch_folder("tile-windows-lies");
    let text = folder.join("squares.geojsonl").to_str().unwrap().to_owned();
    std::fs::write(&text, squares()).unwrap();
    let file = convert(&text, &folder, "squares.fgb");
    let mut bytes = std::fs::read(&file).unwrap();
    let header = u32::from_le_bytes(bytes[8..12].try_into().unwrap()) as usize;
    // The nodes of the features come after 1, 3 and 36 others. Square 12 is in the middle column, and its box is shifted to the left.
    let right = 12 + header + 40 * (40 + 12) + 16;
    assert_eq!(bytes[right..right + 8], 13.0_f64.to_le_bytes());
    bytes[right - 16..right - 8].copy_from_slice(&2.0_f64.to_le_bytes());
    bytes[right..right + 8].copy_from_slice(&3.0_f64.to_le_bytes());
    std::fs::write(&file, bytes).unwrap();
    let made = ["0,0", "1,0", "2,0"].map(|at| tile(&file, "3x1", at, &folder));
    let error = made[0].as_ref().unwrap_err();
    assert!(error.contains("FlatGeobuf: feature 12: it reaches out of the box"), "{error}");
    assert!(made[1].is_ok() && made[2].is_ok(), "{made:?}");
}

#[test]
#[cfg(unix)]
fn a_tile_of_a_pipe_is_that_of_the_file() {
    let folder = scratch_folder("tile-windows-pipe");
    let text = folder.join("squares.geojsonl").to_str().unwrap().to_owned();
    std::fs::write(&text, squares()).unwrap();
    let [of_file, of_pipe] = ["file", "pipe"].map(|name| folder.join(name).to_str().unwrap().to_owned());
    let arguments = ["--grid", "1x1", "--tile", "0,0", "-o"];
    assert!(twinedge(&[&["tile", &text], &arguments[..], &[&of_file]].concat()).status.success());
    let arguments = [&["tile", "/dev/stdin"], &arguments[..], &[&of_pipe]].concat();
    let output = twinedge_reading(&arguments, squares().as_bytes());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(std::fs::read(of_pipe).unwrap() == std::fs::read(of_file).unwrap());
}

#[test]
fn what_is_refused_of_a_file_with_boxes() {
    let folder = scratch_folder("tile-windows-refused");
    let text = folder.join("squares.geojsonl").to_str().unwrap().to_owned();
    std::fs::write(&text, squares()).unwrap();
    let file = convert(&text, &folder, "squares.fgb");
    for (arguments, told) in [
        (&["--tile", "3,0"][..], "the grid has no tile 3,0"),
        (&["--tile", "0,0", "--layer", "other"], "there is no layer \"other\""),
    ] {
        let output = twinedge(&[&["tile", &file, "--grid", "3x1", "-o", "x"], arguments].concat());
        assert_eq!(output.status.code(), Some(2));
        let text = complaint(&output);
        assert!(text.contains(told), "{text}");
    }
}

/// Returns the report of an audit by tiles, without the time and the file's name and digest. There is no folder for temporary files.
#[cfg(unix)]
fn without_copy(arguments: &[&str], input: &[u8]) -> Result<Value, String> {
    let arguments = [&["audit", "--format", "json"], arguments].concat();
    let output = twinedge_with(("TMPDIR", "/nowhere"), &arguments, input);
    let said = String::from_utf8(output.stderr).unwrap();
    if !said.is_empty() {
        return Err(said);
    }
    let mut report: Value = serde_json::from_slice(&output.stdout).unwrap();
    let object = report.as_object_mut().unwrap();
    for key in ["elapsed_ms", "input", "judged"] {
        object.remove(key);
    }
    Ok(report)
}

#[test]
#[cfg(unix)]
fn an_audit_by_tiles_reads_files_with_boxes_where_they_are_and_says_the_same() {
    let folder = scratch_folder("tile-windows-audit");
    let text = folder.join("squares.geojsonl").to_str().unwrap().to_owned();
    std::fs::write(&text, squares()).unwrap();
    for (of, text, memory) in [("world", data("world-110m-crossing.geojson"), "12M"), ("squares", text, "2M")] {
        let flat = convert(&text, &folder, &format!("{of}.fgb"));
        let parquet = convert(&text, &folder, &format!("{of}.parquet"));
        for options in [["--tiles", "3"], ["--memory", memory]] {
            let by_index = without_copy(&[&[&*flat][..], &options].concat(), b"").unwrap();
            assert!(by_index["tiles"]["columns"].as_u64() > Some(1), "{options:?}");
            // A pipe is read once.
            let columns = by_index["tiles"]["columns"].to_string();
            let piped = without_copy(&["/dev/stdin", "--tiles", &columns], &std::fs::read(&flat).unwrap());
            assert_eq!(by_index, piped.unwrap(), "{of} {options:?}");
            let of_parquet = without_copy(&[&[&*parquet][..], &options].concat(), b"").unwrap();
            for key in ["rules", "counts", "verdict"] {
                assert_eq!(of_parquet[key], by_index[key], "{of} {options:?}: {key}");
            }
            let findings = |report: &Value| {
                let findings = report["coverage"]["findings"].as_array().unwrap().iter();
                findings.map(|one| (one["rule"].clone(), one["at"].clone(), one["area"].clone())).collect::<Vec<_>>()
            };
            assert_eq!(findings(&of_parquet), findings(&by_index), "{of} {options:?}");
        }
    }
    // Without boxes, features are copied to the folder for temporary files.
    let stream = squares();
    let piped = without_copy(&["/dev/stdin", "--memory", "200K"], stream.as_bytes());
    assert!(piped.as_ref().is_err_and(|said| said.contains("--memory: No such file")), "{piped:?}");
}
