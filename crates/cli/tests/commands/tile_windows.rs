//! Files with boxes, of which tiles read only a part: the same bytes as from the whole file, less reading, and false boxes.

use crate::shared::members;
use crate::support::{Folder, crossing};
use crate::tile::{as_json, counts_as, write_json};
use serde_json::Value;
use std::fmt::Write as _;

/// The number of squares in a row, and of rows.
const ACROSS: usize = 24;

/// A folder with rows of squares. Some overlap their right neighbours, both across and away from the lines of any grid.
fn squares() -> Folder {
    let mut lines = String::new();
    for number in 0..ACROSS * ACROSS {
        let [x, y] = [number % ACROSS, number / ACROSS].map(|i| i as f64);
        let right = if number % 37 == 5 { x + 1.3 } else { x + 1.0 };
        writeln!(lines, "POLYGON(({x} {y},{right} {y},{right} {0},{x} {0},{x} {y}))", y + 1.0).unwrap();
    }
    let folder = Folder::new(&[("squares.wkt", &lines)]);
    for name in ["squares.fgb", "squares.parquet"] {
        folder.ok(&format!("convert squares.wkt -o {name} --lossy"));
    }
    folder
}

/// Writes a tile to a file named after it. Returns what is said.
fn tile(folder: &Folder, file: &str, grid: &str, at: &str) -> Result<String, String> {
    // Files of three formats are one source.
    let ran = folder.run(&format!("tile {file} --grid {grid} --tile {at} -o {at} --verbose --source one"));
    if ran.status == Some(0) { Ok(ran.err) } else { Err(ran.err) }
}

#[test]
fn the_summary_of_a_tile_has_the_same_bytes_whether_all_was_read_or_its_window() {
    let folder = Folder::new(&[]);
    let files = ["world.fgb", "world.parquet"];
    for name in files {
        folder.ok(&format!("convert {} -o {name} --lossy", crossing()));
    }
    for at in ["0", "1", "2", "3"] {
        let said = tile(&folder, &crossing(), "2x2", at).unwrap();
        assert!(said.contains("the whole file was read"), "{said}");
        let whole = folder.read(at);
        assert!(as_json(&folder, at)["cut"].is_object());
        for file in files {
            tile(&folder, file, "2x2", at).unwrap();
            assert!(folder.read(at) == whole, "{file} {at}");
        }
    }
}

#[test]
fn tiles_read_what_lies_around_them_and_add_up_to_the_audit() {
    let folder = squares();
    let (_, whole) = folder.json("audit squares.wkt --format json");
    assert!(whole["coverage"]["overlaps"].as_u64() > Some(10));
    let all = ["0", "1", "2", "3", "4", "5", "6", "7", "8"];
    for at in all {
        let said = tile(&folder, "squares.fgb", "3x3", at).unwrap();
        // Eight squares each way, and the squares around them.
        let (read, rest) = said.rsplit_once(": ").unwrap().1.split_once(" of 576 features were read, and ").unwrap();
        let read: usize = read.parse().unwrap();
        assert!((81..=144).contains(&read), "{said}");
        let bytes = rest.trim_end().split(" bytes; the file has ");
        let bytes: Vec<u64> = bytes.map(|n| n.replace(',', "").parse().unwrap()).collect();
        assert!(bytes[0] * 2 < bytes[1], "{said}");
    }
    let sum = || folder.json(&format!("sum --format json {}", all.join(" ")));
    let (status, found) = sum();
    counts_as(&found, &whole);
    assert_eq!((status, &found["counts"]), (Some(1), &whole["counts"]));

    // The error names a tile made without cuts, and a tile whose cuts differ from its neighbours' cuts.
    let saved = as_json(&folder, "4");
    for (cut, why) in [
        (Value::Null, "borders cross, and tile 4 was made without cuts"),
        (saved["summary"].clone(), "borders cross, and tile 4: edges still meet elsewhere than at vertices"),
    ] {
        let mut saved = saved.clone();
        saved["cut"] = cut;
        write_json(&folder, "4", saved);
        let (status, found) = sum();
        let said = found["coverage"]["not_checked"].as_str().unwrap();
        assert!(status == Some(1) && said.starts_with(why), "{said}");
    }
}

#[test]
fn a_box_that_is_smaller_than_its_feature_is_an_error_in_the_tile_where_it_shows_it() {
    let folder = squares();
    folder.transcript(
        "
tile squares.fgb --grid 3x1 --tile 3 -o x => 2 the grid has no tile 3
tile squares.fgb --grid 3x1 --tile 0 -o x --layer other => 2 there is no layer \"other\"
",
    );
    let mut bytes = folder.read("squares.fgb");
    let header = u32::from_le_bytes(bytes[8..12].try_into().unwrap()) as usize;
    // The nodes of the features come after 1, 3 and 36 others. Square 12 is in the middle column, and its box is shifted to the left.
    let right = 12 + header + 40 * (40 + 12) + 16;
    assert_eq!(bytes[right..right + 8], 13.0_f64.to_le_bytes());
    bytes[right - 16..right - 8].copy_from_slice(&2.0_f64.to_le_bytes());
    bytes[right..right + 8].copy_from_slice(&3.0_f64.to_le_bytes());
    folder.write("squares.fgb", bytes);
    let made = ["0", "1", "2"].map(|at| tile(&folder, "squares.fgb", "3x1", at));
    let error = made[0].as_ref().unwrap_err();
    assert!(error.contains("FlatGeobuf: feature 12: it reaches out of the box"), "{error}");
    assert!(made[1].is_ok() && made[2].is_ok(), "{made:?}");
}

/// Files with boxes are read tile by tile where they are; others are copied to the folder for temporary files, and there is none.
#[test]
#[cfg(unix)]
fn an_audit_by_tiles_reads_files_with_boxes_where_they_are_and_says_the_same() {
    let folder = squares();
    for to in ["fgb", "parquet"] {
        folder.ok(&format!("convert {} -o world.{to} --lossy", crossing()));
    }
    let without_copy = |arguments: &str| {
        let ran = folder.run_with(&[("TMPDIR", "/nowhere")], &format!("audit --format json {arguments}"));
        if ran.out.is_empty() {
            return Err(ran.err);
        }
        let mut report: Value = serde_json::from_str(&ran.out).unwrap();
        assert!(report["tiles"]["count"].as_u64() > Some(1), "{arguments}");
        for key in ["elapsed_ms", "input", "judged", "tiles"] {
            report[key] = Value::Null;
        }
        Ok(report)
    };
    for (of, memory) in [("world", "12M"), ("squares", "2M")] {
        for words in ["--tiles 3", &format!("--memory {memory}")] {
            let by_index = without_copy(&format!("{of}.fgb {words}")).unwrap();
            // A pipe is read once.
            let piped = without_copy(&format!("/dev/stdin --tiles 3 < {of}.fgb"));
            assert_eq!(by_index, piped.unwrap(), "{of} {words}");
            let of_parquet = without_copy(&format!("{of}.parquet {words}")).unwrap();
            assert_eq!(of_parquet["counts"], by_index["counts"], "{of} {words}");
            counts_as(&of_parquet, &by_index);
            let findings = |report: &Value| members(&report["coverage"]["findings"], &["rule", "at", "area"]);
            assert_eq!(findings(&of_parquet), findings(&by_index), "{of} {words}");
        }
    }
    let piped = without_copy("/dev/stdin --memory 200K < squares.wkt");
    assert!(piped.as_ref().is_err_and(|said| said.contains("--memory: No such file")), "{piped:?}");
    // A tile of a pipe is that of the file.
    folder.ok("tile squares.wkt --grid 1x1 --tile 0 -o of_file");
    folder.ok("tile /dev/stdin --grid 1x1 --tile 0 -o of_pipe < squares.wkt");
    assert!(folder.read("of_pipe") == folder.read("of_file"));
}
