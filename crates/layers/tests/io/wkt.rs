//! Text that the reader of well-known text accepts or refuses, and the line of each error.

use crate::check;
use quickcheck::{Arbitrary, Gen};
use twinedge_geometry::Point;
use twinedge_layers::io::{MAX_NESTED_COLLECTIONS, ReadCause, ReadError, ReadSummary, TextPlace, wkt};
use twinedge_layers::{Format, read_for_map, to_map};
use twinedge_map::{Feature, Shape};

/// Reads a text for a map. Returns the features before the error, if there is one.
fn reading(text: &[u8]) -> (Vec<Feature>, Result<ReadSummary, ReadError>) {
    let (mut features, mut summary) = (Vec::new(), ReadSummary::default());
    let outcome = twinedge_layers::read(&mut { text }, None, &crate::options(Format::Wkt), &mut |feature| {
        features.push(to_map(&feature, &mut summary));
        Ok(())
    });
    match outcome {
        Ok(_) => (features, Ok(summary)),
        Err(twinedge_layers::ReadError::Text(error)) => (features, Err(error)),
        Err(other) => panic!("{other}"),
    }
}

fn read(text: impl AsRef<[u8]>) -> Result<(Vec<Feature>, ReadSummary), ReadError> {
    let (features, summary) = reading(text.as_ref());
    Ok((features, summary?))
}

fn shapes(text: &str) -> Vec<Shape> {
    let (features, _) = read(text).unwrap();
    assert_eq!(features.len(), 1);
    features.into_iter().next().unwrap().shapes
}

#[test]
fn lines_without_a_geometry_are_skipped() {
    let text = "\u{FEFF}# parcels\r\n\r\n  POINT(1 2)  \r\n\t\n # another\nPOINT(3 4)";
    let (features, summary) = read(text).unwrap();
    assert_eq!(features.len(), 2);
    assert!(features.iter().all(|feature| feature.name.is_none() && feature.id.is_none()));
    assert_eq!((summary.features, summary.points, summary.positions), (2, 2, 2));
    assert_eq!(read("").unwrap(), (vec![], ReadSummary::default()));
    assert_eq!(read("\n\n#\n").unwrap(), (vec![], ReadSummary::default()));
}

#[test]
fn dimensions_without_a_letter_are_those_of_the_first_position() {
    let written = |text: &str| {
        let mut written = Vec::new();
        wkt::read_geometries(text.as_bytes(), |line| {
            written.push(line.geometry.to_string());
            Ok::<_, ReadError>(())
        })?;
        Ok::<_, ReadError>(written.concat())
    };
    for (text, expected) in [
        ("POINT(1 2 3)", "POINT Z(1 2 3)"),
        ("POINT (1 2 3 4)", "POINT ZM(1 2 3 4)"),
        ("POINTM(1 2 3)", "POINT M(1 2 3)"),
        ("MULTIPOINT(1 2 3,4 5 6)", "MULTIPOINT Z((1 2 3),(4 5 6))"),
        ("POLYGON(( 0 0 1,1 0 1,1 1 1,0 0 1))", "POLYGON Z((0 0 1,1 0 1,1 1 1,0 0 1))"),
        ("GEOMETRYCOLLECTION(POINT EMPTY,POINT(1 2 3))", "GEOMETRYCOLLECTION Z(POINT EMPTY,POINT Z(1 2 3))"),
        ("GEOMETRYCOLLECTION(POINT(1 2),POINT(1 2 3))", "GEOMETRYCOLLECTION(POINT(1 2),POINT Z(1 2 3))"),
        ("GEOMETRYCOLLECTION(POINT M(1 2 3))", "GEOMETRYCOLLECTION(POINT M(1 2 3))"),
    ] {
        assert_eq!(written(text).unwrap(), expected, "{text}");
    }
}

#[test]
fn empty_points_of_a_multi_point_are_left_out() {
    let p = |x, y| Shape::Point(Point { x, y });
    assert_eq!(shapes("MULTIPOINT((1 1),EMPTY)"), [p(1.0, 1.0)]);
    assert_eq!(shapes("multipoint z (empty , (1 1 5), EMPTY,2 2 5)"), [p(1.0, 1.0), p(2.0, 2.0)]);
    assert_eq!(shapes("GEOMETRYCOLLECTION(MULTIPOINT(EMPTY),POINT(3 3))"), [p(3.0, 3.0)]);
    assert_eq!(shapes("MULTIPOINT(EMPTY,EMPTY)"), []);
}

#[test]
fn a_reference_system_before_a_geometry_is_read() {
    let text = "srid=2056; POINT(3 4)\nSRID=4326;POINT(1 2)\nPOINT(5 6)\n";
    let (features, summary) = read_for_map(&mut text.as_bytes(), &crate::options(Format::Wkt)).unwrap();
    assert_eq!(features.len(), 3);
    // The first line decides, and has an unusual reference system.
    assert_eq!(summary.other_crs, 1);
}

/// Every error is reported with its line, the third, after the preceding geometry was handed over.
fn fault_of(text: impl AsRef<[u8]>) -> ReadCause {
    let all = [b"# first\nPOINT(1 2)\n", text.as_ref(), b"\nPOINT(5 6)\n"].concat();
    let (features, outcome) = reading(&all);
    assert_eq!(features.len(), 1);
    let error = outcome.unwrap_err();
    assert_eq!((error.place, &error.feature), (TextPlace::line(3), &None));
    assert!(error.to_string().starts_with("line 3: "), "{error}");
    error.cause
}

#[test]
fn syntax() {
    let texts = "POINT|POINT(|POINT(1)|POINT(1 2|POINT((1 2))|POINT(1 2 3 4 5)|LINESTRING(1 2 3,4 5)|POINT(1 2, 3 4)|\
        POINT(1 x)|POLYGON(0 0,1 0,1 1)|POLYGON((0 0,1 0,1 1)|LINESTRING(1 2,)|LINESTRING()|CIRCLE(1 2)|\
        GEOMETRYCOLLECTION(1 2)|SRID=;POINT(1 2)|SRID=4326|SRID=4326;|SRID=x;POINT(1 2)|SRID=-1;POINT(1 2)|\
        (1 2)|EMPTY|POINT EMPTY,|POINT EMPTY)|POINT EMPTY\0|42|Ünsinn(1 2)|{\"type\":\"Point\"}";
    for text in texts.split('|') {
        let error = fault_of(text);
        assert!(matches!(error, ReadCause::Syntax { .. }), "{text}: {error:?}");
    }
    assert_eq!(fault_of("42").to_string(), "syntax error: expected the type of a geometry");
}

#[test]
fn trailing() {
    let texts = "POINT(1 2) x|POINT(1 2))|POINT(1 2),POINT(3 4)|POINT(1 2) POINT(3 4)|POINT(1 2)\0|POINT EMPTY EMPTY|\
        POINT EMPTY(1 2)|POINT(1 2);SRID=4326|POINT EMPTY POINT(1 2)";
    for text in texts.split('|') {
        let error = fault_of(text);
        assert!(matches!(error, ReadCause::Trailing { .. }), "{text}: {error:?}");
    }
}

#[test]
fn out_of_range() {
    for text in
        ["POINT(1 1e400)", "POINT(NaN 1)", "POINT(-inf 1)", "LINESTRING(1 2,3 +infinity)", "POLYGON((0 0,-nan 1,1 1))"]
    {
        let error = fault_of(text);
        assert!(matches!(error, ReadCause::OutOfRange), "{text}: {error:?}");
    }
}

#[test]
fn not_utf8() {
    assert!(matches!(fault_of(b"POINT(1 \xFF)"), ReadCause::NotUtf8));
    assert!(matches!(fault_of(b"# caf\xE9"), ReadCause::NotUtf8));
}

#[test]
fn deep_nesting_is_an_error() {
    let nested = |depth: usize, inner: &str| "GEOMETRYCOLLECTION(".repeat(depth) + inner + &")".repeat(depth);
    let polygons = "MULTIPOLYGON(((0 0,1 0,1 1)))";
    assert_eq!(shapes(&nested(MAX_NESTED_COLLECTIONS, polygons)).len(), 1);
    // Brackets are counted: a multi-polygon has three of its own, a point one or none.
    for depth in [1, 4, 10_000, 100_000].map(|more| MAX_NESTED_COLLECTIONS + more) {
        let alone = depth == MAX_NESTED_COLLECTIONS + 1;
        for inner in [polygons, "POINT(1 2)", "POINT EMPTY"].into_iter().take(if alone { 1 } else { 3 }) {
            let error = fault_of(nested(depth, inner));
            assert!(matches!(error, ReadCause::TooDeep), "{depth} {inner}: {error:?}");
        }
    }
    assert!(matches!(fault_of("POINT".to_owned() + &"(".repeat(100_000)), ReadCause::TooDeep));
}

/// The shapes of one line, and the line.
#[derive(Clone, Debug)]
struct Written {
    shapes: Vec<Shape>,
    text: String,
}

impl Arbitrary for Written {
    fn arbitrary(g: &mut Gen) -> Self {
        fn row(points: &[Point]) -> String {
            // The shortest digits that parse to the same float.
            points.iter().map(|p| format!("{:?} {:?}", p.x, p.y)).collect::<Vec<_>>().join(" , ")
        }
        fn some_row(g: &mut Gen) -> Vec<Point> {
            let number = |g: &mut Gen| Some(f64::from_bits(u64::arbitrary(g))).filter(|x| x.is_finite()).unwrap_or(0.5);
            (0..=u8::arbitrary(g) % 4).map(|_| Point { x: number(g), y: number(g) }).collect()
        }
        let mut shapes = Vec::new();
        let mut texts = Vec::new();
        for _ in 0..u8::arbitrary(g) % 4 {
            let rings: Vec<_> = (0..=u8::arbitrary(g) % 3).map(|_| some_row(g)).collect();
            let bracketed = rings.iter().map(|ring| format!("({})", row(ring))).collect::<Vec<_>>().join(",");
            let (drawn, text) = match u8::arbitrary(g) % 6 {
                0 => (vec![Shape::Point(rings[0][0])], format!("POINT({})", row(&rings[0][..1]))),
                1 => (rings[0].iter().copied().map(Shape::Point).collect(), format!("MultiPoint({})", row(&rings[0]))),
                2 => (vec![Shape::Line(rings[0].clone())], format!("LINESTRING  ({})", row(&rings[0]))),
                3 => (rings.iter().cloned().map(Shape::Line).collect(), format!("MULTILINESTRING({bracketed})")),
                4 => (vec![Shape::Polygon(rings)], format!("POLYGON({bracketed})")),
                _ => (vec![Shape::Polygon(rings)], format!("MULTIPOLYGON(EMPTY,( {bracketed} ))")),
            };
            shapes.extend(drawn);
            texts.push(text);
        }
        let text = match &texts[..] {
            [] => "GEOMETRYCOLLECTION EMPTY".into(),
            [one] => one.clone(),
            all => format!("GEOMETRYCOLLECTION({})", all.join(",")),
        };
        Self { shapes, text }
    }
}

#[test]
fn what_was_written_is_read() {
    fn law(all: Vec<Written>) -> bool {
        let text: Vec<_> = all.iter().map(|written| written.text.as_str()).collect();
        let (features, summary) = read(text.join("\n")).unwrap();
        summary.features == all.len()
            && features.iter().map(|f| &f.shapes).eq(all.iter().map(|written| &written.shapes))
    }
    check(1_000, 1).quickcheck(law as fn(Vec<Written>) -> bool);
}

/// Every proper prefix of a line is an error on that line.
#[test]
fn truncated_anywhere() {
    fn law(written: Written) -> bool {
        let ends = 1..written.text.len();
        ends.clone().all(|end| {
            matches!(
                read(&written.text[..end]),
                Err(ReadError { place: TextPlace { line: 1, .. }, cause: ReadCause::Syntax { .. }, .. })
            )
        })
    }
    check(300, 2).quickcheck(law as fn(Written) -> bool);
}

/// For arbitrary bytes, errors name a line of the text, and every accepted line reads the same alone.
#[test]
fn damaged_lines() {
    fn law(written: Vec<Written>, damage: Vec<(usize, u8)>) -> bool {
        let mut text = written.iter().map(|written| written.text.as_str()).collect::<Vec<_>>().join("\n").into_bytes();
        for (at, byte) in damage {
            let at = at % (text.len() + 1);
            text.insert(at, b"(), .-eE019NMZ\n#\xFF\0"[usize::from(byte) % 18]);
        }
        let lines: Vec<_> = text.split(|&byte| byte == b'\n').collect();
        let alone = lines.iter().map_while(|line| read(line).ok()).flat_map(|(features, _)| features);
        let alone: Vec<_> = alone.collect();
        match read(&text) {
            Ok((features, _)) => features == alone,
            Err(error) => {
                let (last, before) = lines[..error.place.line].split_last().unwrap();
                before.iter().all(|line| read(line).is_ok()) && read(last).is_err()
            }
        }
    }
    check(2_000, 3).quickcheck(law as fn(Vec<Written>, Vec<(usize, u8)>) -> bool);
}
