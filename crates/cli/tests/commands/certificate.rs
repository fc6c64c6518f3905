//! `twinedge certify` and `twinedge check`, compared with the checker that is proved in Coq if that is built.

use crate::postgis::{TOWN, broken as broken_town};
use crate::support::{complaint, scratch_folder, twinedge, twinedge_reading};
use parquet::basic::Repetition;
use parquet::file::reader::{FileReader as _, SerializedFileReader};
use parquet::record::Field;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn parcels() -> String {
    format!("{}/../../docs/parcels.geojson", env!("CARGO_MANIFEST_DIR"))
}

/// A certificate of the parcels, with or without their drawing.
fn certified(name: &str, more: &[&str]) -> PathBuf {
    let folder = scratch_folder(name);
    let output = twinedge(&[&["certify", &parcels(), "--snap", "auto", "-o", folder.to_str().unwrap()], more].concat());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    folder
}

/// Returns the exit status and the output of `check`.
fn check(folder: &Path) -> (Option<i32>, String) {
    let output = twinedge(&["check", folder.to_str().unwrap()]);
    (output.status.code(), String::from_utf8(output.stdout).unwrap())
}

/// Returns the exit status and the output of Coq's checker; `None` if it is not built.
fn proved(folder: &Path) -> Option<(Option<i32>, String)> {
    let checker = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../proofs/coq/certified"));
    let output = Command::new(checker).arg(folder).output().ok()?;
    (output.status.code() != Some(3)).then(|| (output.status.code(), String::from_utf8(output.stdout).unwrap()))
}

/// Returns the tests named at the beginnings of lines.
fn failed_tests(printed: &str) -> BTreeSet<&str> {
    printed.lines().skip(1).map(|line| line.split(':').next().unwrap()).collect()
}

/// Asserts that both checkers agree. Returns the exit status.
fn agreed(folder: &Path, what: &str) -> Option<i32> {
    let (status, printed) = check(folder);
    if let Some((proved_status, proved_printed)) = proved(folder) {
        assert_eq!(status, proved_status, "{what}\n{printed}\n{proved_printed}");
        // The component of a missing half-edge is nil for one checker and 0 for the other; other tests fail for it as well.
        let (ours, theirs) = (failed_tests(&printed), failed_tests(&proved_printed));
        assert!(theirs.is_subset(&ours), "{what}\n{printed}\n{proved_printed}");
        if status == Some(0) {
            assert_eq!(printed, proved_printed);
        }
    }
    status
}

#[test]
fn a_map_is_certified_and_checked() {
    let folder = certified("certified", &[]);
    assert_eq!(check(&folder), (Some(0), "valid: a plane subdivision, drawn without crossings\n".to_owned()));
    assert_eq!(agreed(&folder, "right"), Some(0));
    let claim = fs::read_to_string(folder.join("claim.txt")).unwrap();
    assert!(claim.starts_with("twinedge certificate 1\ndrawing\n"), "{claim}");
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1 + 15 + 9 + 2);
    // The folder once more, without coordinates.
    let name = folder.to_str().unwrap();
    let output = twinedge(&["certify", &parcels(), "--topology-only", "-o", name]);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(check(&folder), (Some(0), "valid: a plane subdivision\n".to_owned()));
    assert_eq!(agreed(&folder, "right, without coordinates"), Some(0));
}

/// Changes some numbers in each column. Returns the counts of the exit statuses 0, 1 and 2 on which both checkers agree.
fn corrupted(folder: &Path) -> [usize; 3] {
    let mut files: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let mut statuses = [0, 0, 0];
    for file in files.iter().filter(|file| file.extension().is_some_and(|extension| extension != "txt")) {
        let right = fs::read(file).unwrap();
        let width = if file.extension().unwrap() == "i64" { 8 } else { 4 };
        let rows = right.len() / width;
        for row in [0, rows / 2] {
            for value in [0, 1, (row + 1) as u64, u64::MAX, 1 << 53] {
                let mut wrong = right.clone();
                wrong[row * width..][..width].copy_from_slice(&value.to_le_bytes()[..width]);
                fs::write(file, &wrong).unwrap();
                let status = agreed(folder, &format!("{}, row {row}: {value}", file.display()));
                statuses[usize::try_from(status.unwrap()).unwrap()] += 1;
            }
        }
        fs::write(file, &right).unwrap();
    }
    statuses
}

#[test]
fn corruptions_are_judged_as_by_the_proved_checker() {
    let statuses = corrupted(&certified("corrupted", &[]));
    let [valid, invalid, unreadable] = statuses;
    assert!(valid > 10 && invalid > 140 && unreadable > 2, "{statuses:?}");
}

/// A torus of nine vertices without some of its triangles, and a separate tetrahedron.
fn torus_and_tetrahedron(left_out: &[usize]) -> String {
    let at = |x: usize, y: usize| x % 3 + 3 * (y % 3);
    let corners = (0..9).map(|i| (i / 3, i % 3)).map(|(x, y)| [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]);
    let triangles = corners.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).enumerate();
    let torus = triangles.filter(|(i, _)| !left_out.contains(i)).map(|(_, triangle)| triangle);
    let all = torus.chain([[9, 10, 11], [9, 12, 10], [10, 12, 11], [9, 11, 12]]);
    let points = (0..13).map(|i| format!("v {i} {} 0\n", i * i));
    points.chain(all.map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1))).collect()
}

fn certified_mesh(name: &str, mesh: &str, more: &[&str]) -> PathBuf {
    let folder = scratch_folder(name);
    let arguments = [&["certify", "-", "-o", folder.to_str().unwrap()], more].concat();
    let output = twinedge_reading(&arguments, mesh.as_bytes());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    folder
}

#[test]
fn meshes_are_certified_with_genus_components_and_holes() {
    for (left_out, border, faces) in [
        (&[][..], "closed", 22),
        (&[0], "open at 1 hole", 21),
        (&[4, 5, 11], "open at 1 hole", 19),
        (&[0, 14], "open at 2 holes", 20),
    ] {
        let folder = certified_mesh("certified-mesh", &torus_and_tetrahedron(left_out), &[]);
        let valid = format!("valid: a surface of genus 1 with 2 components, {border}\n");
        assert_eq!(check(&folder), (Some(0), valid));
        assert_eq!(agreed(&folder, "mesh"), Some(0));
        let claim = fs::read_to_string(folder.join("claim.txt")).unwrap();
        assert!(
            claim.starts_with("twinedge certificate 1\nsurface\nof standard input\ncounts 13 vertices, "),
            "{claim}"
        );
        assert!(claim.contains(&format!("edges, {faces} faces\n")), "{claim}");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1 + 14);
    }
}

#[test]
fn corruptions_of_surfaces_are_judged_as_by_the_proved_checker() {
    for (left_out, name) in [(&[][..], "corrupted-surface"), (&[4, 5, 11], "corrupted-open-surface")] {
        let statuses = corrupted(&certified_mesh(name, &torus_and_tetrahedron(left_out), &[]));
        let [valid, invalid, unreadable] = statuses;
        assert!(valid > 2 && invalid > 90 && unreadable == 0, "{statuses:?}");
    }
}

/// A border that meets itself at a vertex, and a flipped face: there is no certificate, and the fault is named.
#[test]
fn what_is_no_surface_is_not_certified() {
    let folder = scratch_folder("no-surface");
    let refused = |more: &[&str], input: &str| {
        let arguments = [&["certify", "-", "-o", folder.to_str().unwrap()], more].concat();
        let output = twinedge_reading(&arguments, input.as_bytes());
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0, "{input}");
        (output.status.code(), String::from_utf8([output.stdout, output.stderr].concat()).unwrap())
    };
    let nothing = "standard input: not valid, nothing is written\n";
    let points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 0 2 0\n";
    let (status, printed) = refused(&[], &format!("{points}f 1 2 3\nf 1 4 5\n"));
    let expected = "2 fans of faces meet at vertex 1 and share no edge there; one face of each: 1, 2\n";
    assert_eq!((status, printed), (Some(1), format!("{nothing}{expected}")));
    let (status, printed) = refused(&[], &format!("{points}f 1 2 3\nf 1 2 4\n"));
    assert!(
        status == Some(1) && printed.starts_with(nothing) && printed.contains("one of them is flipped"),
        "{printed}"
    );
    let triangle =
        "P 3 prev leaving faces V 3 0 - 1 - 2 - H 3 0 - 1 2 - 1 - 2 0 - 2 - 0 1 - B 0 F 1 - 0 HF 3 0 0 0 FH 1 0 0";
    for (expect, rule) in
        [("surface", "R1"), ("surface open asking closed", "M4"), ("surface open asking sides 4", "M3")]
    {
        let (status, printed) = refused(&[], &format!("# expect: {expect}\n{triangle}\n"));
        assert!(status == Some(1) && printed.starts_with(&format!("{nothing}{rule}: ")), "{printed}");
    }
    let (status, printed) = refused(&[], &format!("# expect: plane open\n{triangle}\n"));
    assert!(status == Some(2) && printed.contains("open boundary have no certificates"), "{printed}");
    let mesh = torus_and_tetrahedron(&[]);
    let (status, printed) = refused(&["--snap", "auto"], &mesh);
    assert!(status == Some(2) && printed.contains("--snap is for maps, and this is a mesh"), "{printed}");
}

#[test]
fn a_table_of_an_open_surface_is_certified() {
    let triangle = "V 3 0 - 1 - 2 - H 3 0 - 1 2 - 1 - 2 0 - 2 - 0 1 - B 0 F 1 - 0 HF 3 0 0 0 FH 1 0 0";
    let table = format!("# expect: surface open asking borders 1 genus 0\nP 3 prev leaving faces {triangle}\n");
    let folder = certified_mesh("certified-open-table", &table, &[]);
    assert_eq!(check(&folder), (Some(0), "valid: a surface of genus 0 with 1 component, open at 1 hole\n".to_owned()));
    assert_eq!(agreed(&folder, "open table"), Some(0));
}

#[test]
fn a_topology_of_postgis_is_certified() {
    let folder = scratch_folder("certified-topology");
    let arguments = ["certify", "--postgis", "-", "-o", folder.to_str().unwrap()];
    let output = twinedge_reading(&arguments, TOWN);
    let printed = String::from_utf8(output.stdout).unwrap();
    assert!(printed.ends_with(" is a plane subdivision: 16 vertices, 28 half-edges, 8 faces\n"), "{printed}");
    assert_eq!(check(&folder), (Some(0), "valid: a plane subdivision\n".to_owned()));
    assert_eq!(agreed(&folder, "topology"), Some(0));
    let output = twinedge_reading(&arguments, &broken_town());
    assert_eq!(output.status.code(), Some(1));
    let printed = String::from_utf8(output.stdout).unwrap();
    assert!(printed.contains("next_left_edge of edge 1 is 99, and there is no such edge\n"), "{printed}");
}

#[test]
fn the_test_and_the_record_are_named() {
    let folder = certified("named", &["--topology-only"]);
    let next = folder.join("half_edge_next.u32");
    let mut wrong = fs::read(&next).unwrap();
    wrong[12..16].copy_from_slice(&3_u32.to_le_bytes());
    fs::write(&next, wrong).unwrap();
    let (status, printed) = check(&folder);
    assert_eq!(status, Some(1));
    assert!(printed.starts_with("not valid\nnext_ok: 2 of the half-edges, the first is 3\n"), "{printed}");
}

/// One page of each column is in memory at a time.
#[test]
fn with_little_memory_a_certificate_is_judged_the_same() {
    let folder = scratch_folder("paged");
    let map = format!("{}/../../tests/data/world-110m-crossing.geojson", env!("CARGO_MANIFEST_DIR"));
    let output = twinedge(&["certify", &map, "--snap", "auto", "-o", folder.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let paged = || {
        let output = twinedge(&["check", folder.to_str().unwrap(), "--memory", "0"]);
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    assert_eq!(paged(), (Some(0), "valid: a plane subdivision, drawn without crossings\n".to_owned()));
    let columns = ["half_edge_next.u32", "half_edge_rank.u32", "dart_twin.u32", "dart_rank.u32", "dart_point.u32"];
    for file in columns.map(|name| folder.join(name)) {
        let right = fs::read(&file).unwrap();
        // The file has more than one page.
        assert!(right.len() > 2 * 4 * 4096, "{}", file.display());
        let place = right.len() / 8 * 7 / 8 * 8;
        let mut wrong = right.clone();
        wrong[place..place + 4].fill(0);
        fs::write(&file, &wrong).unwrap();
        let (status, printed) = paged();
        assert_eq!(status, Some(1), "{}", file.display());
        assert_eq!((status, printed), check(&folder), "{}", file.display());
        fs::write(&file, &right).unwrap();
    }
    for (memory, status) in [("", 2), ("a lot", 2), ("20000000000G", 2), ("20000", 0), ("64K", 0), ("1M", 0), ("2G", 0)]
    {
        let output = twinedge(&["check", folder.to_str().unwrap(), "--memory", memory]);
        assert_eq!(output.status.code(), Some(status), "{memory}");
    }
}

/// A folder can be opened as a file, but not read.
#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_read_while_it_is_checked_gives_no_verdict() {
    let folder = certified("not_a_file", &["--topology-only"]);
    let list = folder.join("face_inner.u32");
    fs::remove_file(&list).unwrap();
    fs::create_dir(&list).unwrap();
    let output = twinedge(&["check", folder.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2), "{}", String::from_utf8_lossy(&output.stdout));
    assert!(complaint(&output).contains("face_inner.u32"));
    assert!(output.stdout.is_empty());
}

#[test]
fn what_is_unreadable_is_said_in_one_line() {
    let unreadable = |change: &dyn Fn(&Path)| {
        let folder = certified("unreadable", &[]);
        change(&folder);
        let output = twinedge(&["check", folder.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(2));
        assert!(agreed(&folder, "unreadable") == Some(2));
        complaint(&output)
    };
    let append = |name: &'static str, bytes: &'static [u8]| {
        move |folder: &Path| {
            let content = fs::read(folder.join(name)).unwrap();
            fs::write(folder.join(name), [&content, bytes].concat()).unwrap();
        }
    };
    assert!(unreadable(&|folder| fs::remove_file(folder.join("face_end.u32")).unwrap()).contains("face_end.u32"));
    assert!(unreadable(&append("face_end.u32", b"x")).contains("in the middle of a number"));
    assert!(unreadable(&append("face_end.u32", b"four")).contains("different lengths"));
    assert!(unreadable(&append("point_y.i64", b"12345678")).contains("different lengths"));
    assert!(unreadable(&append("dart_rank.u32", b"four")).contains("length of a column"));
    let sphere = |folder: &Path| fs::write(folder.join("claim.txt"), "twinedge certificate 1\nsphere\n").unwrap();
    assert!(unreadable(&sphere).contains("no claim that is known"));
    assert_eq!(twinedge(&["check", "/no/such/folder"]).status.code(), Some(2));
}

#[test]
fn what_is_not_valid_is_not_certified() {
    let folder = scratch_folder("not-certified");
    let name = folder.to_str().unwrap();
    // Decimal coordinates lie on no grid.
    let output = twinedge(&["certify", &parcels(), "-o", name]);
    assert_eq!(output.status.code(), Some(2));
    let said = complaint(&output);
    assert!(said.contains("on no grid") && said.contains("--snap auto") && !said.contains("audit"), "{said}");
    let crossing = format!("{}/../../tests/data/world-110m-crossing.geojson", env!("CARGO_MANIFEST_DIR"));
    // Crossing edges make a handle of the countries around them.
    let output = twinedge(&["certify", &crossing, "--topology-only", "-o", name]);
    assert_eq!(output.status.code(), Some(1));
    let printed = String::from_utf8(output.stdout).unwrap();
    assert!(printed.contains(": not valid, nothing is written\neuler_ok\nT3: "), "{printed}");
    // A vertex with another vertex's half-edge as `leaving`.
    let table = b"V 2 0 - 0 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0 = V1";
    let output = twinedge_reading(&["certify", "--table", "-", "-o", name], table);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stdout).unwrap().contains("vertex_ok: 1 of the vertices, the first is 1"));
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
}

/// All failing tests are named, with the numbers of their records.
#[test]
fn a_table_is_refused_with_every_test_that_fails() {
    let folder = scratch_folder("refused-table");
    for (table, lines, rule) in [
        // Each half of the first test fails at one of the half-edges.
        (
            "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 1 0 0 B 1 0 h0 i0 F 1 - 1 0",
            "next_ok: 2 of the half-edges, the first is 0\ntarget_ok: 1 of the half-edges, the first is 1\n",
            "L2",
        ),
        ("V 1 - 0 H 0 B 1 1 v0 o F 2 - 0 0 0", "start_ok: 1 of the boundary components, the first is 0\n", "F1"),
    ] {
        let output = twinedge_reading(&["certify", "--table", "-", "-o", folder.to_str().unwrap()], table.as_bytes());
        assert_eq!(output.status.code(), Some(1));
        let printed = String::from_utf8(output.stdout).unwrap();
        let expected = format!("standard input: not valid, nothing is written\n{lines}{rule}: ");
        assert!(printed.starts_with(&expected), "{printed}");
    }
}

/// Two adjacent squares in a textbook's tables; e3,1, the third half-edge of face f2, names `face`.
fn two_squares(face: &str) -> String {
    let half_edges = [
        "e1,1 v1 e1,2 f2 e2,1 e4,2",
        "e1,2 v2 e1,1 f1 e4,1 e5,2",
        "e2,1 v2 e2,2 f2 e3,1 e1,1",
        "e2,2 v3 e2,1 f3 e5,1 e7,2",
        &format!("e3,1 v3 e3,2 {face} e4,2 e2,1"),
        "e3,2 v4 e3,1 f1 e7,1 e4,1",
        "e4,1 v1 e4,2 f1 e3,2 e1,2",
        "e4,2 v4 e4,1 f2 e1,1 e3,1",
        "e5,1 v2 e5,2 f3 e6,1 e2,2",
        "e5,2 v5 e5,1 f1 e1,2 e6,2",
        "e6,1 v5 e6,2 f3 e7,2 e5,1",
        "e6,2 v6 e6,1 f1 e5,2 e7,1",
        "e7,1 v3 e7,2 f1 e6,2 e3,2",
        "e7,2 v6 e7,1 f3 e2,2 e6,1",
    ];
    let vertices = "v1 (0, 0) e1,1\nv2 (4, 0) e5,1\nv3 (4, 4) e7,1\nv4 (0, 4) e3,2\nv5 (8, 0) e6,1\nv6 (8, 4) e7,2";
    let faces = "f1 nil e1,2\nf2 e1,1 nil\nf3 e2,2 nil";
    let tables = [
        ("Vertex Coordinates IncidentEdge", vertices),
        ("Face OuterComponent InnerComponents", faces),
        ("Half-edge Origin Twin IncidentFace Next Prev", &half_edges.join("\n")),
    ];
    tables.map(|(head, rows)| format!("{head}\n{rows}\n\n")).concat()
}

/// The names by which half-edges and faces refer to each other are in no column of a certificate.
#[test]
fn nothing_is_certified_that_the_audit_calls_invalid() {
    let folder = scratch_folder("wrong-names");
    let certify = |input: &str| twinedge_reading(&["certify", "-", "-o", folder.to_str().unwrap()], input.as_bytes());
    let loop_in_one_face = "P 5 prev leaving faces holes unbounded_face V 1 0 - H 2 0 1 0 0 - 0 0 1 1 - B 0 \
                            F 2 - 0 - 0 HF 2 1 1 FH 2 0 0 - 1 h1";
    let outer_without_half_edges = "P 5 prev leaving faces holes unbounded_face V 4 - 0 - 1 x x H 0 B 3 2 v0 i0 2 v1 i1 x F 3 x x - 2 0 1 \
         FH 3 x x 0 2 v0 v1";
    for (input, test, rule) in [
        (loop_in_one_face, "face_name_ok", "B1"),
        (outer_without_half_edges, "face_starts_ok", "R1"),
        (&two_squares("f3"), "face_name_ok", "B1"),
    ] {
        let audited = twinedge_reading(&["audit", "-"], input.as_bytes());
        assert_eq!(audited.status.code(), Some(1), "{input}");
        let output = certify(input);
        let printed = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(1), "{printed}");
        assert!(printed.contains(&format!("\n{test}: ")) && printed.contains(&format!("\n{rule}: ")), "{printed}");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
    }
    assert_eq!(certify(&two_squares("f2")).status.code(), Some(0));
    assert_eq!(agreed(&folder, "two squares"), Some(0));
}

/// Four half-edges around a vertex, each its own twin: the counts are as for a torus.
#[test]
fn half_edges_that_are_their_own_twins_are_no_handle() {
    let folder = scratch_folder("own-twins");
    let columns: [(&str, &[u32]); 14] = [
        ("half_edge_origin", &[0; 4]),
        ("half_edge_twin", &[0, 1, 2, 3]),
        ("half_edge_next", &[1, 2, 3, 0]),
        ("half_edge_prev", &[3, 0, 1, 2]),
        ("half_edge_boundary", &[0; 4]),
        ("half_edge_turn", &[0, 1, 2, 3]),
        ("half_edge_step", &[0, 1, 2, 3]),
        ("half_edge_component", &[0; 4]),
        ("half_edge_rank", &[0, 1, 2, 3]),
        ("vertex_leaving", &[0]),
        ("vertex_border", &[u32::MAX]),
        ("boundary_face", &[0]),
        ("boundary_start", &[0]),
        ("face_outer", &[0]),
    ];
    for (name, numbers) in columns {
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        fs::write(folder.join(name).with_extension("u32"), bytes).unwrap();
    }
    fs::write(folder.join("claim.txt"), "twinedge certificate 1\nsurface\n").unwrap();
    assert_eq!(check(&folder), (Some(1), "not valid\ntwin_ok: 4 of the half-edges, the first is 0\n".to_owned()));
    assert_eq!(agreed(&folder, "own twins"), Some(1));
}

/// A mirrored drawing reverses every triangle, including the outer one; if all points lie on a line, every triangle is flat.
#[test]
fn every_triangle_of_a_mirrored_or_flat_drawing_is_wrong() {
    let folder = certified("mirrored", &[]);
    let file = folder.join("point_x.i64");
    let triangles = fs::read(folder.join("dart_twin.u32")).unwrap().len() / 12;
    let points = fs::read(&file).unwrap();
    for factor in [-1, 0] {
        let moved = points.as_chunks().0.iter().flat_map(|x| (factor * i64::from_le_bytes(*x)).to_le_bytes());
        fs::write(&file, moved.collect::<Vec<_>>()).unwrap();
        let line = format!("triangle_ok: {triangles} of the triangles, the first is 0\n");
        assert_eq!(check(&folder), (Some(1), format!("not valid\n{line}")));
        assert_eq!(agreed(&folder, "mirrored or flat"), Some(1));
    }
}

#[test]
fn a_table_is_certified() {
    let folder = scratch_folder("certified-table");
    let table = b"# expect: plane\nV 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0 = ok\n";
    let output = twinedge_reading(&["certify", "--table", "-", "-o", folder.to_str().unwrap()], table);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(agreed(&folder, "table"), Some(0));
    assert_eq!(fs::read(folder.join("half_edge_next.u32")).unwrap(), [1, 0, 0, 0, 0, 0, 0, 0]);
}

/// The columns of a table in Parquet: the name, whether it is nullable, and the values.
type Columns = Vec<(String, bool, Vec<Option<i64>>)>;

fn parquet_table(folder: &Path, name: &str) -> (Columns, Vec<(String, String)>) {
    let file = fs::File::open(folder.join(name).with_extension("parquet")).unwrap();
    let reader = SerializedFileReader::new(file).unwrap();
    let metadata = reader.metadata().file_metadata();
    let notes = metadata.key_value_metadata().unwrap().iter();
    let notes = notes.map(|note| (note.key.clone(), note.value.clone().unwrap())).collect();
    let fields = metadata.schema().get_fields().iter();
    let mut columns: Columns = fields
        .map(|field| (field.name().to_owned(), field.get_basic_info().repetition() == Repetition::OPTIONAL, Vec::new()))
        .collect();
    for row in reader.get_row_iter(None).unwrap() {
        for (column, (_, field)) in columns.iter_mut().zip(row.unwrap().get_column_iter()) {
            column.2.push(match field {
                Field::Long(number) => Some(*number),
                Field::Null => None,
                other => panic!("{other:?}"),
            });
        }
    }
    (columns, notes)
}

fn folder_column(folder: &Path, name: &str) -> Vec<Option<i64>> {
    let bytes = fs::read(folder.join(name).with_extension("u32")).unwrap();
    let numbers = bytes.as_chunks().0.iter().map(|number| u32::from_le_bytes(*number));
    numbers.map(|number| Some(number).filter(|number| *number != u32::MAX).map(i64::from)).collect()
}

#[test]
fn tables_in_parquet_say_which_columns_are_never_null() {
    let nullable = |folder: &Path, table| {
        let columns = parquet_table(folder, table).0.into_iter();
        columns.filter(|column| column.1).map(|column| column.0).collect::<Vec<_>>()
    };
    let folder = certified("parquet", &["--sql", "duckdb"]);
    for table in ["half_edges", "entries", "points"] {
        assert_eq!(nullable(&folder, table), [""; 0], "{table}");
    }
    assert_eq!(nullable(&folder, "vertices"), ["leaving", "isolated"]);
    assert_eq!(nullable(&folder, "boundaries"), ["start_half_edge", "vertex", "place"]);
    assert_eq!(nullable(&folder, "faces"), ["outer_boundary"]);
    assert_eq!(nullable(&folder, "sides"), ["half_edge"]);
    assert!(!folder.join("half_edges.csv").exists());
    let folder = certified_mesh("parquet-surface", &torus_and_tetrahedron(&[0]), &["--sql", "spark"]);
    for table in ["half_edges", "faces"] {
        assert_eq!(nullable(&folder, table), [""; 0], "{table}");
    }
    assert_eq!(nullable(&folder, "vertices"), ["leaving", "border"]);
    assert_eq!(nullable(&folder, "boundaries"), ["face"]);
}

#[test]
fn no_row_is_lost_where_a_table_has_several_row_groups() {
    let world = format!("{}/../../tests/data/world-50m.geojson", env!("CARGO_MANIFEST_DIR"));
    let folder = scratch_folder("row-groups");
    let name = folder.to_str().unwrap();
    let output = twinedge(&["certify", &world, "--topology-only", "--sql", "spark", "-o", name]);
    assert_eq!(output.status.code(), Some(0), "{}", complaint(&output));
    for (table, prefix) in [("half_edges", "half_edge_"), ("vertices", "vertex_"), ("boundaries", "boundary_")] {
        let (columns, _) = parquet_table(&folder, table);
        for (name, _, values) in &columns[1..] {
            let name = name.trim_end_matches("_half_edge").trim_start_matches("half_edge_");
            let slots = folder_column(&folder, &format!("{prefix}{name}"));
            let rows: Vec<_> = columns[0].2.iter().map(|i| slots[usize::try_from(i.unwrap()).unwrap()]).collect();
            assert!(*values == rows, "{table}.{name}");
        }
    }
    // All half-edges of the map; a group holds 131,072.
    assert_eq!(parquet_table(&folder, "half_edges").0[0].2.len(), 2 * 75_863);
}

/// The expected hash is the output of `sha256sum`.
#[test]
fn a_certificate_says_of_what_file_it_is() {
    let folder = scratch_folder("of-file");
    let input = scratch_folder("of-file-input").join("edge.txt");
    fs::write(&input, "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0\n").unwrap();
    let (name, input) = (folder.to_str().unwrap(), input.to_str().unwrap());
    let output = twinedge(&["certify", "--table", input, "--sql", "duckdb", "-o", name]);
    assert_eq!(output.status.code(), Some(0), "{}", complaint(&output));
    let sha256 = "bd8610e6a380fcfa1553736f71cf087a95205aebe8f4227f779d79675e369085";
    let by = concat!("twinedge ", env!("CARGO_PKG_VERSION"));
    let counts = "2 vertices, 2 half-edges, 1 face";
    let claim = fs::read_to_string(folder.join("claim.txt")).unwrap();
    assert_eq!(
        claim,
        format!("twinedge certificate 1\nplane\nof {input}\nsha256 {sha256}\ncounts {counts}\nby {by}\n")
    );
    let notes =
        [("schema", "1"), ("claim", "plane"), ("of", input), ("sha256", sha256), ("counts", counts), ("by", by)];
    let notes = notes.map(|(key, value)| (format!("twinedge.{key}"), value.to_owned()));
    for table in ["half_edges", "vertices", "boundaries", "faces", "entries"] {
        assert_eq!(parquet_table(&folder, table).1, notes, "{table}");
    }
    // Standard input can only be read once.
    let table = fs::read(input).unwrap();
    twinedge_reading(&["certify", "--table", "-", "-o", name], &table);
    assert!(!fs::read_to_string(folder.join("claim.txt")).unwrap().contains("sha256"));
}

fn files(folder: &Path) -> BTreeSet<String> {
    fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

#[test]
fn a_folder_with_other_files_is_not_written_to() {
    let written = |folder: &Path| twinedge(&["certify", "--topology-only", "-o", folder.to_str().unwrap()]);
    let refused = |folder: &Path, words| {
        let before = files(folder);
        let output = written(folder);
        assert_eq!((output.status.code(), files(folder)), (Some(2), before));
        assert!(complaint(&output).contains(words), "{}", complaint(&output));
    };
    let folder = scratch_folder("other-files");
    fs::write(folder.join("letter.txt"), "dear").unwrap();
    refused(&folder, "letter.txt is no file of a certificate");
    // The folder also contains a certificate.
    fs::remove_file(folder.join("letter.txt")).unwrap();
    assert_eq!(written(&folder).status.code(), Some(0));
    fs::write(folder.join("letter.txt"), "dear").unwrap();
    refused(&folder, "letter.txt is no file of a certificate");
    // The names alone do not make a certificate.
    let folder = scratch_folder("other-query");
    fs::write(folder.join("check.sql"), "SELECT 1").unwrap();
    refused(&folder, "no certificate");
    fs::write(folder.join("claim.txt"), "I was there first").unwrap();
    refused(&folder, "no certificate");
}

/// Remaining queries would judge tables of the previous certificate.
#[test]
fn no_file_of_the_certificate_before_stays() {
    let folder = certified("replaced", &["--sql", "postgres"]);
    assert!(files(&folder).contains("sides.csv"));
    let again = |more: &[&str]| {
        let input = parcels();
        let arguments = [&["certify", &input, "--topology-only", "-o", folder.to_str().unwrap()], more].concat();
        assert_eq!(twinedge(&arguments).status.code(), Some(0));
        files(&folder)
    };
    let tables = ["half_edges", "vertices", "boundaries", "faces", "entries"].map(|name| format!("{name}.parquet"));
    let of_topology = again(&["--sql", "duckdb"]);
    assert_eq!(of_topology.len(), 1 + 15 + tables.len() + 1);
    assert!(tables.iter().all(|table| of_topology.contains(table)), "{of_topology:?}");
    assert_eq!(again(&[]).len(), 1 + 15);
}

/// An incomplete folder has no claim yet: it is unreadable, and can be written again.
#[test]
fn an_unfinished_certificate_is_replaced() {
    let folder = certified("unfinished", &[]);
    fs::write(folder.join("claim.txt"), "twinedge certificate 1\n").unwrap();
    assert_eq!(check(&folder).0, Some(2));
    let output = twinedge(&["certify", "--topology-only", "-o", folder.to_str().unwrap()]);
    assert_eq!((output.status.code(), check(&folder).0), (Some(0), Some(0)));
}
