//! Colours, silence, completions, and messages that name the words of the command line.

use crate::support::{complaint, scratch_folder, twinedge};

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The built-in map.
fn built_in() -> String {
    format!("{}/data/world-110m.geojson", env!("CARGO_MANIFEST_DIR"))
}

/// Two squares that overlap.
fn crossing(folder: &str) -> String {
    let file = scratch_folder(folder).join("overlap.wkt");
    std::fs::write(&file, "POLYGON((0 0,2 0,2 2,0 2,0 0))\nPOLYGON((1 1,3 1,3 3,1 3,1 1))\n").unwrap();
    file.display().to_string()
}

#[test]
fn quiet_prints_nothing_and_keeps_the_exit_status() {
    for (arguments, status) in [(["audit", &built_in()], 0), (["audit", &crossing("quiet")], 1)] {
        let output = twinedge(&[&arguments[..], &["-q"]].concat());
        assert_eq!((output.status.code(), text(&output.stdout)), (Some(status), String::new()));
    }
}

#[test]
fn colours_are_there_when_asked_for() {
    let file = crossing("colours");
    let coloured = |when| text(&twinedge(&["audit", &file, "--color", when]).stdout).contains('\u{1b}');
    assert_eq!([coloured("always"), coloured("never"), coloured("auto")], [true, false, false]);
}

#[test]
fn completions_name_every_command() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = text(&twinedge(&["completions", shell]).stdout);
        assert!(["audit", "certify", "sum"].iter().all(|command| script.contains(command)), "{shell}");
    }
}

#[test]
fn numbers_that_are_none_are_named_in_plain_words() {
    for (arguments, told) in [
        (
            &["audit", "--snap", "-1"][..],
            "invalid value '-1' for '--snap <auto|SIZE>': neither `auto` nor a positive number",
        ),
        (&["clean", "a.shp", "--snap", "-1"], "neither `auto` nor a positive number"),
        (&["audit", "--list", "x"], "invalid value 'x' for '--list <N>': not a whole number"),
        (&["audit", "--list", "-1"], "not a whole number"),
    ] {
        let output = twinedge(arguments);
        assert!(
            output.status.code() == Some(2) && text(&output.stderr).contains(told),
            "{arguments:?}: {}",
            text(&output.stderr)
        );
    }
}

#[test]
fn errors_name_the_file_that_was_asked_for() {
    let folder = scratch_folder("asked-for").join("missing");
    let output = twinedge(&["convert", &built_in(), "--lossy", "-o", &folder.join("a.gpkg").display().to_string()]);
    let complaint = complaint(&output);
    assert!(output.status.code() == Some(2) && complaint.contains("missing/a.gpkg: No such file"), "{complaint}");
    assert!(!complaint.contains(".twinedge-"), "{complaint}");
}

#[test]
fn a_report_goes_to_standard_error_beside_a_layer_on_standard_output() {
    let input = crossing("beside");
    let text_of_report = text(&twinedge(&["clean", &input, "--dry-run"]).stdout);
    let cleaned = twinedge(&["clean", &input, "-o", "-"]);
    assert!(text(&cleaned.stdout).starts_with('{') && !text(&cleaned.stdout).contains("overlap"));
    let overlap = text_of_report.lines().find(|line| line.contains("overlap of")).unwrap();
    assert!(text(&cleaned.stderr).contains(overlap), "{}", text(&cleaned.stderr));
    let cleaned = twinedge(&["clean", &input, "-o", "-", "--format", "json"]);
    assert!(serde_json::from_slice::<serde_json::Value>(&cleaned.stderr).is_ok_and(|report| report.is_object()));
}

#[test]
fn a_picture_of_a_map_that_is_not_valid_says_why() {
    let output = twinedge(&["draw", &crossing("picture")]);
    assert!(output.status.code() == Some(1) && text(&output.stdout).contains("<svg"));
    assert!(complaint(&output).contains("not valid"), "{}", text(&output.stderr));
}
