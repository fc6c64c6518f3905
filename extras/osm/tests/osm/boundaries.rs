//! Boundaries of OpenStreetMap: rings of ways, and the rules O1 … O5.

use crate::pbf::{File, Members};
use quickcheck::{QuickCheck, TestResult};
use twinedge_algorithm::area::ring_area;
use twinedge_coverage::defects;
use twinedge_diagnosis::Diagnosis;
use twinedge_geometry::Point;
use twinedge_layers::io::ReadSummary;
use twinedge_layers::{Crs, Feature, Position, Shape, to_map};
use twinedge_map::Shape as MapShape;
use twinedge_osm::{Boundaries, InvalidFilter, OsmError, TagFilter, read};

/// Two adjacent squares, west and east of way 10, and a third one around both with them as its hole.
fn squares() -> File {
    let mut file = File::default();
    let nodes = [(1, 0, 0), (2, 1, 0), (3, 1, 1), (4, 0, 1), (5, 2, 0), (6, 2, 1)];
    let around = [(7, -1, -1), (8, 3, -1), (9, 3, 2), (10, -1, 2)];
    for (id, x, y) in nodes.into_iter().chain(around) {
        file.node(id, x, y);
    }
    file.way(10, &[2, 3]);
    file.way(11, &[3, 4, 1, 2]);
    file.way(12, &[2, 5, 6, 3]);
    file.way(13, &[7, 8, 9, 10, 7]);
    file.relation(100, "6", "West", &[(10, "outer"), (11, "outer")]);
    file.relation(200, "6", "East", &[(12, ""), (10, "")]);
    file.relation(300, "6", "Around", &[(13, "outer"), (11, "inner"), (12, "inner")]);
    file.relation(400, "8", "Another level", &[(99, "outer")]);
    file
}

fn boundaries(file: &File) -> Boundaries {
    let written = file.written();
    read(written.path(), &"admin_level=6".parse().unwrap(), 100).unwrap()
}

/// The kind of a finding, the rule that it follows from, and the ids of its features.
type Found = (&'static str, Option<&'static str>, Vec<String>);

fn found(file: &File) -> Vec<Found> {
    let Boundaries { rules, findings, .. } = boundaries(file);
    let violations: u64 = rules.iter().map(|rule| rule.violations).sum();
    assert_eq!(violations, findings.len() as u64);
    for one in &findings {
        let of_rule = rules.iter().find(|rule| Some(rule.id) == one.rule).unwrap();
        assert!(of_rule.violations > 0 && one.is_violation && one.cause.is_some() && one.remedy.is_some());
    }
    let ids = |one: &Diagnosis| one.features.iter().flatten().map(|feature| feature.id.clone().unwrap()).collect();
    findings.iter().map(|one| (one.kind.name(), one.follows_from, ids(one))).collect()
}

fn ids<const N: usize>(ids: [u32; N]) -> Vec<String> {
    ids.map(|id| format!("relation/{id}")).to_vec()
}

fn rings(feature: &Feature) -> Vec<Vec<(f64, f64)>> {
    let Some(Shape::Polygon(rings)) = feature.geometry.as_ref().map(|geometry| &geometry.shape) else {
        panic!("no polygon: {feature:?}")
    };
    let points = |ring: &Vec<Position>| ring.iter().map(|p| (p.x, p.y)).collect();
    rings.iter().map(points).collect()
}

#[test]
fn ways_make_polygons_whichever_way_they_run() {
    let Boundaries { layer, rules, findings, .. } = boundaries(&squares());
    assert!(findings.is_empty(), "{findings:?}");
    let checked: Vec<_> = rules.iter().map(|rule| (rule.id, rule.checked)).collect();
    assert_eq!(checked, [("O1", 7), ("O2", 3), ("O3", 7), ("O4", 7), ("O5", 4)]);
    assert_eq!(layer.header.crs, Some(Crs::epsg(4326)));
    let [west, east, around] = &layer.features[..] else { panic!("{layer:?}") };
    assert_eq!(west.id.as_ref().unwrap().to_string(), "relation/100");
    assert_eq!((west.name().as_deref(), east.name().as_deref()), (Some("West"), Some("East")));
    assert_eq!(east.get("admin_level").and_then(|level| level.text()).as_deref(), Some("6"));
    assert_eq!(rings(west), [[(1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0), (1.0, 0.0)]]);
    assert_eq!(rings(east), [[(1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 0.0)]]);
    let of_around = rings(around);
    assert_eq!(of_around.iter().map(Vec::len).collect::<Vec<_>>(), [5, 7]);
    assert_eq!(of_around[0][0], (-1.0, -1.0));
}

#[test]
fn relations_of_two_types_are_made_of_borders() {
    let squares = |kind| File { type_of_relations: kind, ..squares() }.written();
    let read = |kind| read(squares(kind).path(), &"admin_level=6".parse().unwrap(), 100);
    assert_eq!(read("multipolygon").unwrap().layer.features.len(), 3);
    assert!(matches!(read("route").unwrap_err(), OsmError::None(_)));
}

#[test]
fn rings_that_touch_at_a_node_are_told_apart() {
    let mut file = squares();
    for (id, x, y) in [(20, 3, 0), (21, 3, 1)] {
        file.node(id, x, y);
    }
    // Two triangles that meet at node 2, from ways that all end there or at another corner.
    file.way(21, &[1, 2]);
    file.way(22, &[2, 20, 21]);
    file.way(23, &[4, 1]);
    file.way(24, &[2, 4]);
    file.way(25, &[21, 2]);
    file.relation(500, "4", "Both", &[(21, ""), (22, ""), (23, ""), (24, ""), (25, "")]);
    let both = read(file.written().path(), &"admin_level=4".parse().unwrap(), 100).unwrap();
    assert_eq!(both.violation_count(), 0);
    let shape = &both.layer.features[0].geometry.as_ref().unwrap().shape;
    let Shape::MultiPolygon(polygons) = shape else { panic!("{shape:?}") };
    assert_eq!(
        polygons.iter().map(|rings| rings.iter().map(Vec::len).collect::<Vec<_>>()).collect::<Vec<_>>(),
        [[4], [4]]
    );
}

/// Twice the area of the polygons of the only relation, which must be valid by the rules of the OGC.
fn twice_the_area(file: &File) -> i64 {
    let found = read(file.written().path(), &"admin_level=4".parse().unwrap(), 100).unwrap();
    let feature = to_map(&found.layer.features[0], &mut ReadSummary::default());
    assert_eq!(defects(&feature.shapes), [], "{:?}", feature.shapes);
    let of_ring = |ring: &Vec<Point>| ring_area(ring.iter().copied());
    let of_shape = |shape: &MapShape| match shape {
        MapShape::Polygon(rings) => rings.iter().map(of_ring).sum(),
        _ => 0.0,
    };
    (2.0 * feature.shapes.iter().map(of_shape).sum::<f64>()) as i64
}

#[test]
fn rings_are_cut_where_they_touch_and_segments_that_occur_twice_bound_nothing() {
    let grid = || {
        let mut file = File::default();
        for (x, y) in (0..5).flat_map(|x| (0..5).map(move |y| (x, y))) {
            file.node(1 + 10 * x + y, x, y);
        }
        file
    };
    // A square of 4 by 4 whose way continues, from the middle of a side, around an inner square, through its corner.
    let mut touching = grid();
    touching.way(1, &[1, 21, 32, 23, 12, 21, 41, 45, 5, 1]);
    touching.relation(1, "4", "A", &[(1, "outer")]);
    assert_eq!(twice_the_area(&touching), 28);
    // Two holes with a common side, and a hole that touches one of them at a corner.
    let mut holes = grid();
    holes.way(1, &[1, 41, 45, 5, 1]);
    holes.way(2, &[12, 22, 23, 13, 12]);
    holes.way(3, &[22, 32, 33, 23, 22]);
    holes.way(4, &[33, 34, 24, 33]);
    let members = [(1, "outer"), (2, "inner"), (3, "inner"), (4, "inner")];
    holes.relation(1, "4", "A", &members);
    assert_eq!(twice_the_area(&holes), 27);
    // Two adjacent whole squares.
    let mut beside = grid();
    beside.way(1, &[1, 21, 22, 2, 1]);
    beside.way(2, &[21, 31, 32, 22, 21]);
    beside.relation(1, "4", "A", &[(1, "outer"), (2, "outer")]);
    assert_eq!(twice_the_area(&beside), 6);
}

/// The borders of random sets of cells, as ways in any order and direction. Some ways are drawn twice, from both sides.
#[test]
fn borders_of_cells_are_valid_and_have_their_area() {
    const SIDE: i64 = 4;
    fn law(cells: Vec<bool>, cuts: Vec<(u8, bool)>, whole: bool) -> TestResult {
        let is_in = |x: i64, y: i64| {
            (0..SIDE).contains(&x)
                && (0..SIDE).contains(&y)
                && usize::try_from(SIDE * x + y).ok().and_then(|cell| cells.get(cell)) == Some(&true)
        };
        let node = |x: i64, y: i64| 1 + 10 * x + y;
        let mut ways: Vec<Vec<i64>> = Vec::new();
        let mut area = 0;
        for (x, y) in (0..SIDE).flat_map(|x| (0..SIDE).map(move |y| (x, y))).filter(|(x, y)| is_in(*x, *y)) {
            area += 2;
            let corners = [node(x, y), node(x + 1, y), node(x + 1, y + 1), node(x, y + 1)];
            if whole {
                ways.push([&corners[..], &corners[..1]].concat());
                continue;
            }
            let beside = [is_in(x, y - 1), is_in(x + 1, y), is_in(x, y + 1), is_in(x - 1, y)];
            for side in (0..4).filter(|side| !beside[*side]) {
                ways.push(vec![corners[side], corners[(side + 1) % 4]]);
            }
        }
        if ways.is_empty() {
            return TestResult::discard();
        }
        // Joins ways end to end, reversing some.
        for (at, turned) in &cuts {
            let at = usize::from(*at) % ways.len();
            if *turned {
                ways[at].reverse();
            }
            let end = ways[at][ways[at].len() - 1];
            if let Some(next) = (0..ways.len()).find(|next| *next != at && ways[*next][0] == end) {
                let next = ways[next].clone();
                ways.retain(|way| *way != next);
                if let Some(way) = ways.iter_mut().find(|way| way[way.len() - 1] == end) {
                    way.extend(&next[1..]);
                } else {
                    ways.push(next);
                }
            }
        }
        let mut file = File::default();
        for (x, y) in (0..=SIDE).flat_map(|x| (0..=SIDE).map(move |y| (x, y))) {
            file.node(node(x, y), x, y);
        }
        let mut members = Vec::new();
        for (id, way) in (1..).zip(&ways) {
            file.way(id, way);
            members.push((id, ""));
        }
        file.relation(1, "4", "Cells", &members);
        TestResult::from_bool(twice_the_area(&file) == area)
    }
    QuickCheck::new().tests(300).quickcheck(law as fn(Vec<bool>, Vec<(u8, bool)>, bool) -> TestResult);
}

#[test]
fn each_rule_is_broken_alone() {
    type Breaking = fn(&mut File);
    let cases: [(Breaking, Vec<Found>); 7] = [
        (|file| file.ways.retain(|(way, _)| *way != 13), vec![("way_missing", None, ids([300]))]),
        (|file| file.nodes.retain(|(node, ..)| *node != 9), vec![("node_missing", None, ids([300]))]),
        (|file| file.members(100).truncate(1), vec![("open_ring", None, ids([100]))]),
        (|file| file.members(100).clear(), vec![("no_ways", None, ids([100]))]),
        (|file| file.members(200).push((12, "outer")), vec![("way_repeated", None, ids([200]))]),
        (
            |file| file.relation(600, "6", "West again", &[(11, ""), (10, "")]),
            vec![("same_side", None, ids([100, 600]))],
        ),
        (|file| file.members(300)[1].1 = "outer", vec![("wrong_role", None, ids([300]))]),
    ];
    for (breaking, expected) in cases {
        let mut file = squares();
        breaking(&mut file);
        assert_eq!(found(&file), expected);
    }
}

#[test]
fn a_ring_that_is_open_as_a_way_is_missing_follows_from_that() {
    let mut file = squares();
    file.ways.retain(|(way, _)| *way != 12);
    let open = |id| ("open_ring", Some("O1"), ids([id]));
    let missing = |id| ("way_missing", None, ids([id]));
    assert_eq!(found(&file), [missing(200), missing(300), open(200), open(300)]);
    // The closed rings are kept.
    assert_eq!(rings(&boundaries(&file).layer.features[2]).len(), 1);
}

#[test]
fn findings_beyond_the_limit_are_counted() {
    let mut file = squares();
    file.ways.clear();
    let found = read(file.written().path(), &"admin_level".parse().unwrap(), 2).unwrap();
    assert_eq!((found.rules[0].violations, found.findings.len(), found.violation_count()), (8, 2, 8));
}

#[test]
fn files_that_are_not_read() {
    let filter: TagFilter = "admin_level=6".parse().unwrap();
    let error = |bytes: &[u8]| {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), bytes).unwrap();
        read(file.path(), &filter, 100).unwrap_err()
    };
    assert!(matches!(error(b""), OsmError::Content(_)));
    assert!(matches!(error(b"{\"type\": \"FeatureCollection\"}"), OsmError::Content(_)));
    let bytes = squares().bytes();
    let cut = error(&bytes[..bytes.len() - 10]);
    assert!(matches!(cut, OsmError::Content(_)), "{cut}");
    let history = File { needs: Some("HistoricalInformation"), ..squares() };
    assert!(matches!(error(&history.bytes()), OsmError::Needs(what) if what == "HistoricalInformation"));
    let none = read(squares().written().path(), &"admin_level=2,name=Nowhere".parse().unwrap(), 100).unwrap_err();
    assert!(none.to_string().contains("admin_level=2,name=Nowhere"), "{none}");
    assert!(matches!(none, OsmError::None(_)));
    assert!(matches!(read("/nowhere".as_ref(), &filter, 100), Err(OsmError::Io(_))));
    let invalid: InvalidFilter = "admin_level=6,=4".parse::<TagFilter>().unwrap_err();
    assert!(invalid.to_string().contains("admin_level=6,=4"));
}

/// An invalid type of a member makes the underlying crate panic.
#[test]
fn an_unknown_type_of_a_member_is_an_error() {
    let file = File { type_of_members: 7, ..squares() };
    let error = read(file.written().path(), &"admin_level".parse().unwrap(), 100).unwrap_err();
    assert!(matches!(error, OsmError::Content(_)), "{error}");
}

impl File {
    fn members(&mut self, relation: i64) -> &mut Members {
        &mut self.relations.iter_mut().find(|(id, ..)| *id == relation).unwrap().3
    }
}
