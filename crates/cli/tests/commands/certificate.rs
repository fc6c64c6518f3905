//! `twinedge certify` and `twinedge check`, compared with the checker that is proved in Coq if that is built.

use crate::shared::{TOWN, broken_town};
use crate::support::{Folder, crossing, root};
use parquet::basic::Repetition;
use parquet::file::reader::{FileReader as _, SerializedFileReader};
use parquet::record::Field;
use std::collections::BTreeSet;
use std::fs;
use std::process::Command;

/// Returns the tests named at the beginnings of lines.
fn failed_tests(printed: &str) -> BTreeSet<&str> {
    printed.lines().skip(1).map(|line| line.split(':').next().unwrap()).collect()
}

/// Checks the certificate in the folder `c`, and asserts that the proved checker agrees, if it is built. Returns the exit status and the output.
fn checked(folder: &Folder) -> (Option<i32>, String) {
    let ran = folder.run("check c");
    let proved = Command::new(root("proofs/coq/certified")).arg(folder.path("c")).output();
    if let Some(proved) = proved.ok().filter(|proved| proved.status.code() != Some(3)) {
        let printed = String::from_utf8(proved.stdout).unwrap();
        assert_eq!(ran.status, proved.status.code(), "{ran:?}\n{printed}");
        // The component of a missing half-edge is nil for one checker and 0 for the other; other tests fail for it as well.
        assert!(failed_tests(&printed).is_subset(&failed_tests(&ran.out)), "{ran:?}\n{printed}");
        assert!(ran.status != Some(0) || ran.out == printed, "{ran:?}\n{printed}");
    }
    (ran.status, ran.out)
}

#[track_caller]
fn is_valid(folder: &Folder, what: &str) {
    assert_eq!(checked(folder), (Some(0), format!("valid: {what}\n")));
}

/// A folder with a certificate of this input in the folder `c`.
fn certified(input: &str, words: &str) -> Folder {
    let folder = Folder::new(&[("in", input)]);
    folder.ok(&format!("certify - {words} -o c < in"));
    folder
}

fn parcels(words: &str) -> Folder {
    certified(&fs::read_to_string(root("docs/parcels.geojson")).unwrap(), words)
}

const DRAWN: &str = "a plane subdivision, drawn without crossings";
const EDGE: &str = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0";

#[test]
fn certificates_of_all_inputs_are_valid() {
    let folder = parcels("--snap auto");
    is_valid(&folder, DRAWN);
    let claim = folder.text("c/claim.txt");
    assert!(claim.starts_with("twinedge certificate 1\ndrawing\n"), "{claim}");
    assert_eq!(folder.names("c").len(), 1 + 15 + 9 + 2);
    // The folder once more, without coordinates.
    folder.ok("certify in --topology-only -o c");
    is_valid(&folder, "a plane subdivision");

    let folder = certified(&format!("# expect: plane\n{EDGE} = ok\n"), "--table");
    is_valid(&folder, "a plane subdivision");
    assert_eq!(folder.read("c/half_edge_next.u32"), [1, 0, 0, 0, 0, 0, 0, 0]);
    let triangle = "V 3 0 - 1 - 2 - H 3 0 - 1 2 - 1 - 2 0 - 2 - 0 1 - B 0 F 1 - 0 HF 3 0 0 0 FH 1 0 0";
    let table = format!("# expect: surface open asking borders 1 genus 0\nP 3 prev leaving faces {triangle}\n");
    is_valid(&certified(&table, ""), "a surface of genus 0 with 1 component, open at 1 hole");
    let textbook = fs::read_to_string(root("examples/tables/five_faces.txt")).unwrap();
    is_valid(&certified(&textbook, ""), "a plane subdivision");

    let folder = Folder::new(&[]);
    folder.write("town.copy", TOWN);
    let text = folder.ok("certify --postgis - -o c < town.copy");
    assert!(text.ends_with(" is a plane subdivision: 16 vertices, 28 half-edges, 8 faces\n"), "{text}");
    is_valid(&folder, "a plane subdivision");
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

#[test]
fn meshes_are_certified_with_genus_components_and_holes() {
    for (left_out, border, faces) in [
        (&[][..], "closed", 22),
        (&[0], "open at 1 hole", 21),
        (&[4, 5, 11], "open at 1 hole", 19),
        (&[0, 14], "open at 2 holes", 20),
    ] {
        let folder = certified(&torus_and_tetrahedron(left_out), "");
        is_valid(&folder, &format!("a surface of genus 1 with 2 components, {border}"));
        let claim = folder.text("c/claim.txt");
        let begins = "twinedge certificate 1\nsurface\nof standard input\ncounts 13 vertices, ";
        assert!(claim.starts_with(begins) && claim.contains(&format!("edges, {faces} faces\n")), "{claim}");
        assert_eq!(folder.names("c").len(), 1 + 14);
    }
}

/// Changes some numbers in each column; both checkers agree, and some statuses are 0, 1 and 2.
#[test]
fn corruptions_are_judged_as_by_the_proved_checker() {
    for (folder, [valid, invalid, unreadable]) in [
        (parcels("--snap auto"), [11, 141, 3]),
        (certified(&torus_and_tetrahedron(&[]), ""), [3, 91, 0]),
        (certified(&torus_and_tetrahedron(&[4, 5, 11]), ""), [3, 91, 0]),
    ] {
        let mut statuses = [0, 0, 0];
        for file in folder.names("c").iter().filter(|file| file.ends_with("32") || file.ends_with("64")) {
            let file = format!("c/{file}");
            let right = folder.read(&file);
            let width = if file.ends_with("i64") { 8 } else { 4 };
            for row in [0, right.len() / width / 2] {
                for value in [0, 1, (row + 1) as u64, u64::MAX, 1 << 53] {
                    let mut wrong = right.clone();
                    wrong[row * width..][..width].copy_from_slice(&value.to_le_bytes()[..width]);
                    folder.write(&file, &wrong);
                    statuses[usize::try_from(checked(&folder).0.unwrap()).unwrap()] += 1;
                }
            }
            folder.write(&file, &right);
        }
        assert!(statuses[0] >= valid && statuses[1] >= invalid && statuses[2] >= unreadable, "{statuses:?}");
        assert!(unreadable > 0 || statuses[2] == 0, "{statuses:?}");
    }
}

/// The fault is named, with every test that fails and the numbers of their records, and nothing is written.
#[test]
fn what_is_not_valid_is_not_certified() {
    let points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 0 2 0\n";
    let triangle =
        "P 3 prev leaving faces V 3 0 - 1 - 2 - H 3 0 - 1 2 - 1 - 2 0 - 2 - 0 1 - B 0 F 1 - 0 HF 3 0 0 0 FH 1 0 0\n";
    let folder = Folder::new(&[
        ("fans", &format!("{points}f 1 2 3\nf 1 4 5\n")),
        ("flipped", &format!("{points}f 1 2 3\nf 1 2 4\n")),
        ("surface", &format!("# expect: surface\n{triangle}")),
        ("closed", &format!("# expect: surface open asking closed\n{triangle}")),
        ("sides", &format!("# expect: surface open asking sides 4\n{triangle}")),
        ("open plane", &format!("# expect: plane open\n{triangle}")),
        ("torus", &torus_and_tetrahedron(&[])),
        // Another vertex's half-edge as `leaving`.
        ("leaving", "V 2 0 - 0 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0 = V1"),
        // Each half of the first test fails at one of the half-edges.
        ("next", "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 1 0 0 B 1 0 h0 i0 F 1 - 1 0"),
        ("start", "V 1 - 0 H 0 B 1 1 v0 o F 2 - 0 0 0"),
        // The half-edges name another face, which is in no column of a certificate.
        (
            "loop",
            "P 5 prev leaving faces holes unbounded_face V 1 0 - H 2 0 1 0 0 - 0 0 1 1 - B 0 F 2 - 0 - 0 HF 2 1 1 FH 2 0 0 - 1 h1",
        ),
    ]);
    folder.write("town", broken_town());
    std::fs::create_dir(folder.path("c")).unwrap();
    folder.transcript(&format!(
        "
certify - -o c < fans => 1 standard input: not valid, nothing is written\\n2 fans of faces meet at vertex 1 and share no edge there; one face of each: 1, 2
certify - -o c < flipped => 1 standard input: not valid, nothing is written ++ one of them is flipped
certify - -o c < surface => 1 standard input: not valid, nothing is written\\nR1:
certify - -o c < closed => 1 standard input: not valid, nothing is written\\nM4:
certify - -o c < sides => 1 standard input: not valid, nothing is written\\nM3:
certify --table - -o c < leaving => 1 vertex_ok: 1 of the vertices, the first is 1
certify --table - -o c < next => 1 nothing is written\\nnext_ok: 2 of the half-edges, the first is 0\\ntarget_ok: 1 of the half-edges, the first is 1\\nL2:
certify --table - -o c < start => 1 nothing is written\\nstart_ok: 1 of the boundary components, the first is 0\\nF1:
certify - -o c < loop => 1 face_name_ok: ++ B1:
audit - < loop => 1
certify - --postgis -o c < town => 1 next_left_edge of edge 1 is 99, and there is no such edge
# Crossing edges make a handle of the countries around them.
certify {} --topology-only -o c => 1 : not valid, nothing is written\\neuler_ok\\nT3:
# Decimal coordinates lie on no grid.
certify {} -o c => 2 on no grid ++ --snap auto
certify - -o c < open plane => 2 open boundary have no certificates
certify - --snap auto -o c < torus => 2 --snap is for maps, and this is a mesh
certify --table next --layer auto -o c => 2
certify --table next --snap auto -o c => 2
",
        crossing(),
        root("docs/parcels.geojson")
    ));
    assert_eq!(folder.names("c").len(), 0);
}

#[test]
fn the_test_and_the_record_are_named() {
    let folder = parcels("--topology-only");
    let mut wrong = folder.read("c/half_edge_next.u32");
    wrong[12..16].copy_from_slice(&3_u32.to_le_bytes());
    folder.write("c/half_edge_next.u32", wrong);
    let (status, printed) = checked(&folder);
    assert!(
        status == Some(1) && printed.starts_with("not valid\nnext_ok: 2 of the half-edges, the first is 3\n"),
        "{printed}"
    );

    // A mirrored drawing reverses every triangle, including the outer one; if all points lie on a line, every triangle is flat.
    let folder = parcels("--snap auto");
    let triangles = folder.read("c/dart_twin.u32").len() / 12;
    let points = folder.read("c/point_x.i64");
    for factor in [-1, 0] {
        let moved = points.as_chunks().0.iter().flat_map(|x| (factor * i64::from_le_bytes(*x)).to_le_bytes());
        folder.write("c/point_x.i64", moved.collect::<Vec<_>>());
        let line = format!("triangle_ok: {triangles} of the triangles, the first is 0\n");
        assert_eq!(checked(&folder), (Some(1), format!("not valid\n{line}")));
    }
}

/// One page of each column is in memory at a time.
#[test]
fn with_little_memory_a_certificate_is_judged_the_same() {
    let folder = Folder::new(&[]);
    folder.ok(&format!("certify {} --snap auto -o c", crossing()));
    let paged = || {
        let ran = folder.run("check c --memory 0");
        (ran.status, ran.out)
    };
    assert_eq!(paged(), (Some(0), format!("valid: {DRAWN}\n")));
    for column in ["half_edge_next", "half_edge_rank", "dart_twin", "dart_rank", "dart_point"] {
        let file = format!("c/{column}.u32");
        let right = folder.read(&file);
        // The file has more than one page.
        assert!(right.len() > 2 * 4 * 4096, "{file}");
        let place = right.len() / 8 * 7 / 8 * 8;
        let mut wrong = right.clone();
        wrong[place..place + 4].fill(0);
        folder.write(&file, &wrong);
        let ran = folder.run("check c");
        assert_eq!((Some(1), paged()), (ran.status, (ran.status, ran.out)), "{file}");
        folder.write(&file, &right);
    }
    for (memory, status) in
        [("''", 2), ("'a lot'", 2), ("20000000000G", 2), ("20000", 0), ("64K", 0), ("1M", 0), ("2G", 0)]
    {
        folder.transcript(&format!("check c --memory {memory} => {status}"));
    }
}

/// A change of a certificate, and the error.
type Damage<'a> = (&'a dyn Fn(&Folder), &'a str);

#[test]
fn what_is_unreadable_is_said_in_one_line() {
    let append = |name: &'static str, bytes: &'static [u8]| {
        move |folder: &Folder| folder.write(name, [&*folder.read(name), bytes].concat())
    };
    let remove = |folder: &Folder| fs::remove_file(folder.path("c/face_end.u32")).unwrap();
    let claim = |claim: &'static str| move |folder: &Folder| folder.write("c/claim.txt", claim);
    let cases: [Damage<'_>; 7] = [
        (&remove, "face_end.u32"),
        (&append("c/face_end.u32", b"x"), "in the middle of a number"),
        (&append("c/face_end.u32", b"four"), "different lengths"),
        (&append("c/point_y.i64", b"12345678"), "different lengths"),
        (&append("c/dart_rank.u32", b"four"), "length of a column"),
        (&claim("twinedge certificate 1\nsphere\n"), "no claim that is known"),
        // An incomplete folder has no claim yet.
        (&claim("twinedge certificate 1\n"), ""),
    ];
    for (change, why) in cases {
        let folder = parcels("--snap auto");
        change(&folder);
        folder.transcript(&format!("check c => 2 {why}"));
        assert_eq!(checked(&folder).0, Some(2));
        // It can be written again, unless it is no certificate.
        if why.is_empty() {
            folder.ok("certify in --topology-only -o c");
            is_valid(&folder, "a plane subdivision");
        }
    }
    let folder = parcels("--topology-only");
    folder.transcript("check missing => 2");
    // A folder can be opened as a file, but not read.
    if cfg!(target_os = "linux") {
        fs::remove_file(folder.path("c/face_inner.u32")).unwrap();
        fs::create_dir(folder.path("c/face_inner.u32")).unwrap();
        folder.transcript("check c => 2 face_inner.u32");
    }
}

/// The columns of a table in Parquet: the name, whether it is nullable, and the values.
type Columns = Vec<(String, bool, Vec<Option<i64>>)>;

fn parquet_table(folder: &Folder, name: &str) -> (Columns, Vec<(String, String)>) {
    let file = fs::File::open(folder.path(&format!("c/{name}.parquet"))).unwrap();
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

#[test]
fn tables_in_parquet_say_which_columns_are_never_null() {
    let map = parcels("--snap auto --sql duckdb");
    assert!(!map.path("c/half_edges.csv").exists());
    let surface = certified(&torus_and_tetrahedron(&[0]), "--sql spark");
    for (folder, table, expected) in [
        (&map, "half_edges", ""),
        (&map, "entries", ""),
        (&map, "points", ""),
        (&map, "vertices", "leaving isolated"),
        (&map, "boundaries", "start_half_edge vertex place"),
        (&map, "faces", "outer_boundary"),
        (&map, "sides", "half_edge"),
        (&surface, "half_edges", ""),
        (&surface, "faces", ""),
        (&surface, "vertices", "leaving border"),
        (&surface, "boundaries", "face"),
    ] {
        let columns = parquet_table(folder, table).0.into_iter();
        let nullable: Vec<_> = columns.filter(|column| column.1).map(|column| column.0).collect();
        assert_eq!(nullable.join(" "), expected, "{table}");
    }
}

#[test]
fn no_row_is_lost_where_a_table_has_several_row_groups() {
    let folder = Folder::new(&[]);
    folder.ok(&format!("certify {} --topology-only --sql spark -o c", root("tests/data/world-50m.geojson")));
    for (table, prefix) in [("half_edges", "half_edge_"), ("vertices", "vertex_"), ("boundaries", "boundary_")] {
        let (columns, _) = parquet_table(&folder, table);
        for (name, _, values) in &columns[1..] {
            let name = name.trim_end_matches("_half_edge").trim_start_matches("half_edge_");
            let bytes = folder.read(&format!("c/{prefix}{name}.u32"));
            let slots: Vec<u32> = bytes.as_chunks().0.iter().map(|number| u32::from_le_bytes(*number)).collect();
            let slot = |i: &Option<i64>| slots[usize::try_from(i.unwrap()).unwrap()];
            let rows: Vec<_> =
                columns[0].2.iter().map(|i| Some(slot(i)).filter(|n| *n != u32::MAX).map(i64::from)).collect();
            assert!(*values == rows, "{table}.{name}");
        }
    }
    // All half-edges of the map; a group holds 131,072.
    assert_eq!(parquet_table(&folder, "half_edges").0[0].2.len(), 2 * 75_863);
}

/// The expected hash is the output of `sha256sum`.
#[test]
fn a_certificate_says_of_what_file_it_is() {
    let folder = Folder::new(&[("edge.txt", &format!("{EDGE}\n"))]);
    folder.ok("certify --table edge.txt --sql duckdb -o c");
    let sha256 = "bd8610e6a380fcfa1553736f71cf087a95205aebe8f4227f779d79675e369085";
    let by = concat!("twinedge ", env!("CARGO_PKG_VERSION"));
    let counts = "2 vertices, 2 half-edges, 1 face";
    let claim = format!("twinedge certificate 1\nplane\nof edge.txt\nsha256 {sha256}\ncounts {counts}\nby {by}\n");
    assert_eq!(folder.text("c/claim.txt"), claim);
    let notes =
        [("schema", "1"), ("claim", "plane"), ("of", "edge.txt"), ("sha256", sha256), ("counts", counts), ("by", by)];
    let notes = notes.map(|(key, value)| (format!("twinedge.{key}"), value.to_owned()));
    for table in ["half_edges", "vertices", "boundaries", "faces", "entries"] {
        assert_eq!(parquet_table(&folder, table).1, notes, "{table}");
    }
    // Standard input can only be read once.
    folder.ok("certify --table - -o c < edge.txt");
    assert!(!folder.text("c/claim.txt").contains("sha256"));
}

#[test]
fn a_folder_with_other_files_is_not_written_to() {
    let folder = Folder::new(&[]);
    let refused = |why: &str| {
        let before = folder.names("c");
        folder.transcript(&format!("certify --topology-only -o c => 2 {why}"));
        assert_eq!(folder.names("c"), before);
    };
    fs::create_dir(folder.path("c")).unwrap();
    folder.write("c/letter.txt", "dear");
    refused("letter.txt is no file of a certificate");
    // The folder also contains a certificate.
    fs::remove_file(folder.path("c/letter.txt")).unwrap();
    folder.ok("certify --topology-only -o c");
    folder.write("c/letter.txt", "dear");
    refused("letter.txt is no file of a certificate");
    // The names alone do not make a certificate.
    fs::remove_dir_all(folder.path("c")).unwrap();
    fs::create_dir(folder.path("c")).unwrap();
    folder.write("c/check.sql", "SELECT 1");
    refused("no certificate");
    folder.write("c/claim.txt", "I was there first");
    refused("no certificate");
}

/// Remaining queries would judge tables of the previous certificate.
#[test]
fn no_file_of_the_certificate_before_stays() {
    let folder = parcels("--snap auto --sql postgres");
    assert!(folder.names("c").contains("sides.csv"));
    folder.ok("certify in --topology-only --sql duckdb -o c");
    let names = folder.names("c");
    let tables = ["half_edges", "vertices", "boundaries", "faces", "entries"].map(|name| format!("{name}.parquet"));
    assert!(tables.iter().all(|table| names.contains(table)) && names.len() == 1 + 15 + 5 + 1, "{names:?}");
    folder.ok("certify in --topology-only -o c");
    assert_eq!(folder.names("c").len(), 1 + 15);
}
