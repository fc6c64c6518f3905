//! `twinedge prove`.

use crate::support::{complaint, json, twinedge};

#[test]
fn the_maps_of_up_to_four_edges_are_as_many_as_published() {
    let (status, found) = json(&["prove", "--edges", "4", "--format", "json"]);
    assert_eq!(status, Some(0));
    assert_eq!((&found["ok"], &found["interrupted"]), (&true.into(), &false.into()));
    let column = |name: &str| -> Vec<u64> {
        found["edges"].as_array().unwrap().iter().map(|row| row[name].as_u64().unwrap()).collect()
    };
    assert_eq!(column("n"), [0, 1, 2, 3, 4]);
    // OEIS A000168, A006384 and A103937.
    for (name, published) in
        [("rooted", [1, 2, 9, 54, 378]), ("sensed", [1, 2, 4, 14, 57]), ("plane", [1, 2, 6, 26, 150])]
    {
        assert_eq!(column(name), published);
        assert_eq!(column(&format!("{name}_published")), published);
    }
    assert_eq!(column("violations"), [0; 5]);
    assert!(column("applications").iter().zip(column("refused")).all(|(applied, refused)| *applied > 0 && refused > 0));
    // A000168, A006300 and A006298.
    let by_genus = [vec![1], vec![2], vec![9, 1], vec![54, 20], vec![378, 307, 21]];
    for (row, expected) in found["genus"].as_array().unwrap().iter().zip(by_genus) {
        assert_eq!(row["by_genus"], serde_json::json!(expected));
    }
    let nested = found["nested"].as_array().unwrap();
    assert!(nested.iter().all(|row| row["maps"] == row["recounted"] && row["violations"] == 0));
    // Two edges on three vertices, or a loop with two more: counted by hand.
    let maps = |edges: u64, vertices: u64| {
        nested.iter().find(|row| row["edges"] == edges && row["vertices"] == vertices).map(|row| row["maps"].clone())
    };
    assert_eq!((maps(0, 3), maps(1, 2), maps(1, 3)), (Some(1.into()), Some(3.into()), Some(4.into())));
}

#[test]
fn small_triangulated_discs_are_as_many_as_published_and_operators_do_what_the_steps_do() {
    let (status, found) = json(&["prove", "--meshes", "4", "--format", "json"]);
    assert_eq!((status, &found["ok"]), (Some(0), &true.into()));
    let rows = found["rows"].as_array().unwrap();
    // A triangle; a triangle with a vertex inside; a square with either diagonal (Brown 1964).
    let rooted: Vec<_> = rows.iter().map(|row| (&row["rooted"], &row["rooted_published"])).collect();
    let [one, two] = [1, 2].map(serde_json::Value::from);
    assert_eq!(rooted, [(&one, &one), (&one, &one), (&two, &two)]);
    assert!(rows.iter().all(|row| row["differences"] == 0));
    let applied = |name: &str| {
        let row = found["operators"].as_array().unwrap().iter().find(|row| row["operator"] == name).unwrap();
        row["applied"].as_u64().unwrap()
    };
    let names = ["mesh_flip_edge", "mesh_split_edge", "mesh_split_face", "mesh_collapse_edge", "connect", "flip_edge"];
    assert!(names.into_iter().all(|name| applied(name) > 0), "{found}");

    let output = twinedge(&["prove", "--meshes", "4", "--on", "planted"]);
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("not as defined") && text.contains("flip_edge h"), "{text}");
    // Both kinds of work at once, and more work than there is time for.
    for arguments in
        [&["prove", "--meshes", "4", "--edges", "2"][..], &["prove", "--meshes", "2"], &["prove", "--meshes", "9"]]
    {
        assert_eq!(twinedge(arguments).status.code(), Some(2), "{arguments:?}");
    }
}

#[test]
fn people_get_a_table_and_a_verdict() {
    let output = twinedge(&["prove", "--edges", "2", "--threads", "2"]);
    assert_eq!(output.status.code(), Some(0));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("exhausted up to 2 edges: all counts agree"), "{text}");
    assert!(!text.contains('≠') && !text.contains('\u{1b}'), "{text}");
}

#[test]
fn what_would_not_finish_is_refused() {
    let output = twinedge(&["prove", "--edges", "12"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(message.lines().count(), 1, "{message}");
    assert!(message.contains("operators to try") && message.contains("--force"), "{message}");
}

#[test]
fn more_threads_than_cores_do_not_make_too_much_work_less() {
    let complaint = |more: &[&str]| complaint(&twinedge(&[&["prove", "--edges", "12"], more].concat()));
    assert_eq!(complaint(&["--threads", "256"]), complaint(&[]));
}

#[test]
fn scripts_can_tell_a_refusal_from_misuse() {
    for arguments in [
        &["prove", "--edges", "12"][..],
        &["corrupt", "--edges", "8"],
        &["tables", "--half-edges", "10"],
        &["soak", "--programs", "4000000000"],
    ] {
        let output = twinedge(&[arguments, &["--format", "json"]].concat());
        assert_eq!(output.status.code(), Some(2));
        let found: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(found["ok"], false);
        let told = complaint(&output);
        assert!(told.contains("--force") && told.contains(found["refused"].as_str().unwrap()), "{told}");
    }
    let output = twinedge(&["prove", "--edges", "many", "--format", "json"]);
    assert!(output.status.code() == Some(2) && output.stdout.is_empty());
}

#[test]
fn misuse_has_its_own_status() {
    for arguments in [&["prove", "--edges", "many"][..], &["prove", "--edges", "99"], &["prove", "extra"], &["proove"]]
    {
        let output = twinedge(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty() && !output.stderr.is_empty());
    }
}
