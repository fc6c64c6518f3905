//! Pictures: the drawn elements, their number and places.

use quickcheck::{Gen, QuickCheck};
use twinedge::validate::{Field, Record, Violation};
use twinedge_geometry::{MAX_COORDINATE, MIN_COORDINATE, Point};
use twinedge_map::{Builder, Feature, Noding, PlanarMap, Shape};
use twinedge_report::svg::{Options, draw, half_edges_in};

fn polygon(name: &str, ring: &[[f64; 2]]) -> Feature {
    let ring = ring.iter().copied().map(Point::from).collect();
    Feature { name: Some(name.to_owned()), shapes: vec![Shape::Polygon(vec![ring])], ..Feature::default() }
}

fn built(features: &[Feature]) -> PlanarMap {
    let mut builder = Builder::new();
    for feature in features {
        builder.feature(feature).expect("in range");
    }
    builder.build().expect("fits")
}

/// Two rectangles that overlap in a third one, and a point.
fn estates() -> PlanarMap {
    let west = [[0.0, 0.0], [3.0, 0.0], [4.0, 0.0], [4.0, 4.0], [3.0, 4.0], [0.0, 4.0]];
    let east = [[3.0, 0.0], [4.0, 0.0], [8.0, 0.0], [8.0, 4.0], [4.0, 4.0], [3.0, 4.0]];
    let well = Feature { shapes: vec![Shape::Point(Point::new(1.0, 1.0))], ..Feature::default() };
    built(&[polygon("A <b> & \"c\"", &west), polygon("East", &east), well])
}

/// Returns true if XML 1.0 allows a character in a document (section 2.2, production 2).
fn is_xml_char(c: char) -> bool {
    matches!(c, '\t' | '\n' | '\r' | ' '..='\u{D7FF}' | '\u{E000}'..='\u{FFFD}' | '\u{10000}'..)
}

/// Returns true if tags nest, attributes are quoted, and all characters are allowed: enough of XML for these pictures.
fn is_well_formed(text: &str) -> bool {
    if !text.chars().all(is_xml_char) {
        return false;
    }
    let mut open = Vec::new();
    for piece in text.split('<').skip(1) {
        let Some((tag, rest)) = piece.split_once('>') else { return false };
        if tag.matches('"').count() % 2 == 1 || rest.contains('"') && !rest.is_ascii() {
            return false;
        }
        let name = tag.split([' ', '/']).next().unwrap_or_default();
        if let Some(closed) = tag.strip_prefix('/') {
            if open.pop() != Some(closed) {
                return false;
            }
        } else if !tag.ends_with('/') {
            open.push(name);
        }
    }
    open.is_empty() && !text.contains("NaN") && !text.contains("inf")
}

/// The numbers in the attribute `d` of each path of this class.
fn paths(text: &str, class: &str) -> Vec<Vec<f64>> {
    let start = format!("<path class=\"{class}\"");
    let outlines = text.lines().filter(|line| line.starts_with(&start)).filter_map(|line| line.split(" d=\"").nth(1));
    let numbers = |d: &str| {
        let d = d.split('"').next().unwrap_or_default();
        d.split(|c: char| c.is_ascii_alphabetic() || c == ' ').filter_map(|n| n.parse().ok()).collect()
    };
    outlines.map(numbers).collect()
}

#[test]
fn faces_have_colours_names_and_hatches() {
    let map = estates();
    let text = draw(&map, &Options::default());
    assert!(is_well_formed(&text), "{text}");
    assert_eq!(text.matches("fill-rule").count(), 4, "three faces, one of them twice");
    assert_eq!(text.matches("class=\"hatch\"").count(), 1);
    assert!(text.contains("<title>f3: A &lt;b&gt; &amp; &quot;c&quot;, East</title>"), "{text}");
    assert!(text.contains(">East</text>") && text.contains("class=\"point\""));
    // Neighbours differ in colour; an overlap has the colour of the first feature.
    let fills: std::collections::BTreeSet<&str> = text.split("<path fill=\"").skip(1).map(|p| &p[..7]).collect();
    assert_eq!(fills.len(), 2);
    // 8 units on 1000 pixels, with margins of 12: the upper left corner is at (12, 12).
    assert!(text.contains("width=\"1000\" height=\"512\"") && text.contains("M12 500L378 500"), "{text}");
}

#[test]
fn details_show_every_half_edge_to_the_left_of_its_edge() {
    let map = estates();
    let text = draw(&map, &Options { detail: true, ..Options::default() });
    assert!(is_well_formed(&text), "{text}");
    let arrows = paths(&text, "half");
    assert_eq!((arrows.len(), paths(&text, "next").len()), (20, 20));
    let scale = (1000.0 - 2.0 * 40.0) / 8.0;
    let pixel = |p: Point| [40.0 + p.x * scale, 40.0 + (4.0 - p.y) * scale];
    let at = |v: twinedge::dcel::Vertex<'_>| pixel(map.position(v.key()).expect("live"));
    for ((h, arrow), next) in map.dcel().half_edges().zip(&arrows).zip(paths(&text, "next")) {
        let (a, b) = (at(h.origin()), at(h.target()));
        let side = |p: [f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        let (tail, head) = ([arrow[0], arrow[1]], [arrow[2], arrow[3]]);
        // Pixels count downwards, so the left is negative.
        assert!(side(tail) < 0.0 && (side(tail) - side(head)).abs() < 0.1 * (b[0] - a[0]).hypot(b[1] - a[1]) + 1e-9);
        assert!((b[0] - a[0]) * (head[0] - tail[0]) + (b[1] - a[1]) * (head[1] - tail[1]) > 0.0);
        // The link leads from its head to the tail of the next.
        assert_eq!(next[..2], arrow[2..]);
        let order = map.dcel().half_edges().position(|other| other == h.next()).expect("live");
        assert_eq!(next[4..], arrows[order][..2]);
        assert!(text.contains(&format!(">h{}</text>", h.index())));
    }
    assert!(map.dcel().vertices().all(|v| text.contains(&format!(">v{}</text>", v.index()))));
    assert!(map.dcel().faces().all(|f| text.contains(&format!(">f{}</text>", f.index()))));
}

#[test]
fn violations_are_marked_where_they_are() {
    let mut builder = Builder::new();
    builder.segment([0.0, 0.0], [2.0, 2.0]).expect("in range");
    builder.segment([0.0, 2.0], [2.0, 0.0]).expect("in range");
    let map = builder.build().expect("fits");
    let report = map.validate();
    let text = draw(&map, &Options { violations: report.violations(), ..Options::default() });
    assert!(is_well_formed(&text), "{text}");
    assert!(text.contains("<circle class=\"bad\" cx=\"500.00\" cy=\"500.00\""), "{text}");
    let edges: Vec<usize> = map.dcel().edges().map(|h| h.index()).collect();
    assert!(text.contains(&format!("1  G4 half-edges {} and {} cross", edges[0], edges[1])), "{text}");
    assert!(text.contains(">1</text>") && paths(&text, "bad").contains(&vec![12.0, 988.0, 988.0, 12.0]), "{text}");
    assert!(!draw(&map, &Options::default()).contains("class=\"bad\""));
}

/// A field of 4 by 4 squares, and three islands: two far to the right, and one far below.
fn archipelago() -> PlanarMap {
    let square = |x: f64, y: f64, side: f64| [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
    let mut features: Vec<Feature> =
        (0..16).map(|i| polygon("field", &square(f64::from(i % 4), f64::from(i / 4), 1.0))).collect();
    features.push(polygon("Near", &square(40.0, 0.0, 2.0)));
    features.push(polygon("Next", &square(42.2, 0.0, 2.0)));
    features.push(polygon("Deep", &square(0.0, -60.0, 1.0)));
    built(&features)
}

/// The part with the most vertices is as large as without islands.
#[test]
fn islands_far_away_are_drawn_in_insets() {
    let map = archipelago();
    let text = draw(&map, &Options::default());
    assert!(is_well_formed(&text), "{text}");
    assert_eq!((text.matches("class=\"inset\"").count(), text.matches("<svg ").count()), (2, 4), "{text}");
    assert!(text.contains("viewBox=\"0 0 1000 1162\"") && text.contains("M12 988L256 988"), "{text}");
    // Each face and each name is in one panel; two neighbouring islands share an inset.
    assert_eq!(text.matches("fill-rule").count(), 19);
    let inset = text.split("<svg ").find(|panel| panel.contains("Near")).expect("is drawn");
    assert!(inset.contains("Next") && !inset.contains("Deep"), "{inset}");
    let scale: Vec<&str> = text.split(" × the scale").filter_map(|before| before.rsplit('>').next()).take(2).collect();
    // 176 pixels for 4.2 units and 126 for 1, against 976 for 4.
    assert_eq!(scale, ["0.17", "0.52"]);
    let whole = draw(&map, &Options { insets: false, ..Options::default() });
    assert!(!whole.contains("inset\" x") && whole.matches("<svg ").count() == 2, "{whole}");
    let window = Some([Point::new(-1.0, -1.0), Point::new(5.0, 5.0)]);
    assert!(!draw(&map, &Options { window, ..Options::default() }).contains("× the scale"));
}

/// A nearby part needs no inset, and of many far parts only some have one; the rest is counted.
#[test]
fn insets_are_few() {
    let square = |x: f64, y: f64| [[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]];
    let near: Vec<Feature> = (0..20).map(|i| polygon("", &square(1.4 * f64::from(i), 0.0))).collect();
    assert!(!draw(&built(&near), &Options::default()).contains("× the scale"));
    let far: Vec<Feature> = (0..10).map(|i| polygon("", &square(3.0_f64.powi(i), 0.0))).collect();
    let text = draw(&built(&far), &Options::default());
    let counted = text.split(" more parts lie far away").next().and_then(|before| before.rsplit('>').next());
    assert_eq!((text.matches("× the scale").count(), counted), (6, Some("2")), "{text}");
}

/// Lines become thinner with their number, so that they cover a bounded part of the picture.
#[test]
fn lines_thin_with_their_number() {
    let width = |n: u32| {
        let mut builder = Builder::new();
        for i in 0..=n {
            let at = f64::from(i) / f64::from(n);
            builder.segment([at, 0.0], [at, 1.0]).expect("in range");
        }
        let text = draw(&builder.build().expect("fits"), &Options::default());
        text.split("class=\"edges\" style=\"stroke-width:")
            .nth(1)
            .and_then(|rest| rest.split('"').next()?.parse::<f64>().ok())
    };
    assert_eq!(width(10), None);
    // 401 lines of 976 pixels, and eight hundredths of a thousand by a thousand.
    assert_eq!([width(400), width(100_000)], [Some(0.20), Some(0.05)]);
}

/// Names that do not fit into their faces are placed outside with a leader line, and cover no other name.
#[test]
fn names_that_do_not_fit_have_lines() {
    let narrow = |i: u32| {
        let x = 40.0 * f64::from(i);
        polygon(&format!("Narrow valley {i}"), &[[x, 0.0], [x + 2.0, 0.0], [x + 2.0, 50.0], [x, 50.0]])
    };
    let text = draw(&built(&(0..10).map(narrow).collect::<Vec<_>>()), &Options { insets: false, ..Options::default() });
    assert!(is_well_formed(&text), "{text}");
    assert_eq!(text.matches("class=\"leader\"").count(), 7, "one to 20,000 square pixels of 1000 by 159");
    let place = |line: &str, attribute: &str| -> f64 {
        let value = line.split(&format!(" {attribute}=\"")).nth(1).and_then(|rest| rest.split('"').next());
        value.and_then(|value| value.parse().ok()).expect("has it")
    };
    let names: Vec<[f64; 2]> = text
        .lines()
        .filter(|l| l.starts_with("<text class=\"name\""))
        .map(|l| ["x", "y"].map(|a| place(l, a)))
        .collect();
    assert_eq!(names.len(), 7);
    for (i, a) in names.iter().enumerate() {
        assert!(names[..i].iter().all(|b| (a[0] - b[0]).abs() > 78.0 || (a[1] - b[1]).abs() >= 11.0), "{names:?}");
    }
}

/// If a map is not plane, the area of a feature is unknown, and its own outline is filled.
#[test]
fn features_of_a_map_that_is_not_plane_are_filled() {
    let square = |x: f64| [[x, x], [x + 2.0, x], [x + 2.0, x + 2.0], [x, x + 2.0]];
    let mut builder = Builder::new();
    for (name, x) in [("a", 0.0), ("b", 1.0)] {
        builder.feature(&polygon(name, &square(x))).expect("in range");
    }
    let map = builder.build_with(Noding::None).expect("fits");
    assert!(!map.is_plane());
    let text = draw(&map, &Options::default());
    let filled: Vec<Vec<f64>> = ["#8ecae6", "#f4b88a"].iter().flat_map(|fill| filled(&text, fill)).collect();
    // 3 units on 976 pixels.
    assert_eq!(filled.len(), 2, "{text}");
    let low = |path: &Vec<f64>| path.iter().copied().step_by(2).fold(f64::INFINITY, f64::min);
    let mut lows: Vec<f64> = filled.iter().filter(|path| path.len() == 8).map(low).collect();
    lows.sort_by(f64::total_cmp);
    assert_eq!(lows, [12.0, 337.33], "{text}");
}

#[test]
fn a_spike_leaves_no_feature_white_and_nameless() {
    // The spike of the first feature runs into the second; the hole of the third is drawn as one ring with a slit.
    let spiked = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [7.0, 3.0], [4.0, 2.0], [4.0, 4.0], [0.0, 4.0]];
    let square = [[5.0, 0.0], [9.0, 0.0], [9.0, 4.0], [5.0, 4.0]];
    let slit = [[0, 5], [9, 5], [9, 9], [0, 9], [0, 5], [1, 6], [1, 8], [2, 8], [2, 6], [1, 6]]
        .map(|p: [i32; 2]| p.map(f64::from));
    let mut builder = Builder::new();
    for (name, ring) in [("spiked", &spiked[..]), ("square", &square), ("slit", &slit)] {
        builder.feature(&polygon(name, ring)).expect("in range");
    }
    let map = builder.build_with(Noding::None).expect("fits");
    assert!(!map.is_plane());
    let text = draw(&map, &Options::default());
    let points = |fill: &str| filled(&text, fill).concat().len() / 2;
    let fills = ["#8ecae6", "#f4b88a", "#a8d5a2", "#f2a9bb"];
    // The corners of the squares and of both rings.
    assert_eq!(fills.map(points).iter().sum::<usize>(), 5 + 4 + 8, "{text}");
    for name in ["spiked", "square", "slit"] {
        assert!(text.contains(&format!(">{name}</text>")), "{text}");
    }
}

/// The numbers in the outlines with this fill.
fn filled(text: &str, fill: &str) -> Vec<Vec<f64>> {
    let lines = text.replace(&format!("<path fill=\"{fill}\""), "<path class=\"filled\"");
    paths(&lines, "filled")
}

/// Gaps are dotted; tiny gaps and overlaps have a ring.
#[test]
fn tiny_gaps_and_overlaps_are_ringed() {
    let mut builder = Builder::new();
    let ring = |ring: &[[f64; 2]]| ring.iter().map(|p| Point::from(*p)).collect::<Vec<_>>();
    let square = |x: f64, side: f64| ring(&[[x, x], [x + side, x], [x + side, x + side], [x, x + side]]);
    builder.shape(&Shape::Polygon(vec![square(0.0, 100.0), square(10.0, 0.5), square(20.0, 30.0)])).expect("in range");
    builder.shape(&Shape::Polygon(vec![square(60.0, 0.5)])).expect("in range");
    let text = draw(&builder.build().expect("fits"), &Options::default());
    let count = |class: &str| text.matches(&format!("class=\"{class}\"")).count();
    assert_eq!((count("gap"), count("hatch"), count("tiny")), (2, 1, 2), "{text}");
    // A map without areas has no gaps.
    let mut lines = PlanarMap::new();
    lines.insert_ring([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]).expect("in range");
    let text = draw(&lines, &Options::default());
    assert!(text.contains("class=\"free\"") && !text.contains("class=\"gap\""));
}

#[test]
fn a_window_shows_a_part() {
    let map = estates();
    let window = Some([Point::new(9.0, -1.0), Point::new(5.0, 5.0)]);
    assert_eq!((half_edges_in(&map, None), half_edges_in(&map, window)), (20, 6));
    let text = draw(&map, &Options { window, detail: true, ..Options::default() });
    assert_eq!((paths(&text, "half").len(), text.matches("fill-rule").count()), (6, 1));
    // An invalid window shows everything.
    for bad in [f64::NAN, f64::INFINITY, 0.0] {
        let window = Some([Point::new(0.0, 0.0), Point::new(bad, 1.0)]);
        assert_eq!(half_edges_in(&map, window), 20);
        assert_eq!(draw(&map, &Options { window, ..Options::default() }), draw(&map, &Options::default()));
    }
}

#[test]
fn what_is_very_large_or_small_is_drawn_too() {
    for scale in [MAX_COORDINATE, MIN_COORDINATE] {
        let map = built(&[polygon("", &[[-scale, -scale], [scale, -scale], [scale, scale]])]);
        for detail in [false, true] {
            for size in [1000.0, f64::NAN, f64::INFINITY, -1.0] {
                let text = draw(&map, &Options { detail, size, ..Options::default() });
                assert!(is_well_formed(&text) && text.matches("fill-rule").count() == 1, "{text}");
            }
        }
    }
    let empty = Builder::new().build().expect("fits");
    assert!(is_well_formed(&draw(&empty, &Options { detail: true, ..Options::default() })));
    let point = built(&[Feature { shapes: vec![Shape::Point(Point::new(7.0, 7.0))], ..Feature::default() }]);
    assert!(draw(&point, &Options::default()).contains("cx=\"12.00\""));
}

/// Arbitrary segments, crossing or not, produce a picture with every half-edge and a mark for every violation.
fn anything_is_drawn(segments: Vec<((u8, u8), (u8, u8))>) -> bool {
    let mut builder = Builder::new();
    for ((a, b), (c, d)) in segments {
        let [a, b, c, d] = [a, b, c, d].map(|i| f64::from(i % 5));
        builder.segment([a, b], [c, d]).expect("in range");
    }
    let map = builder.build().expect("fits");
    let report = map.validate();
    let text = draw(&map, &Options { detail: true, violations: report.violations(), ..Options::default() });
    let bounded = map.dcel().face_count() - 1;
    is_well_formed(&text)
        && paths(&text, "half").len() == map.dcel().half_edge_count()
        && text.matches("fill-rule").count() == bounded
        && text.matches("class=\"rule\"").count() == report.violations().len()
        && text.matches("class=\"legend\"").count() == report.violations().len().min(41)
}

#[test]
fn names_keep_only_characters_that_xml_allows() {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let name: String =
        ('\0'..='\u{FF}').chain(['\u{D7FF}', '\u{E000}', '\u{FFFD}', '\u{FFFE}', '\u{FFFF}', '\u{1F600}']).collect();
    for name in [name.as_str(), "]]>", "&amp;", "<!--", "a\u{FFFF}b"] {
        let map = built(&[polygon(name, &square)]);
        for detail in [false, true] {
            let text = draw(&map, &Options { detail, size: 1e5, ..Options::default() });
            assert!(is_well_formed(&text), "{text}");
        }
    }
    let text = draw(&built(&[polygon("a\u{FFFF}\u{FFFE}b\u{1F600}", &square)]), &Options::default());
    assert!(text.contains("f2: ab\u{1F600}<"), "{text}");
}

#[test]
fn any_options_will_do() {
    let map = estates();
    let extremes = [0.0, 5e-324, 1e-300, 1e-130, 1.0, MAX_COORDINATE, f64::MAX];
    let violations: Vec<Violation> = [0, 1, 7, usize::MAX]
        .into_iter()
        .flat_map(|i| {
            [
                Violation::TwinIsSelf { half_edge: i },
                Violation::Nil { record: Record::Vertex(i), field: Field::Leaving },
            ]
        })
        .collect();
    for from in extremes {
        for to in extremes {
            let window = Some([Point::new(-from, from), Point::new(to, -to)]);
            let options = Options { window, detail: true, violations: &violations, ..Options::default() };
            let text = draw(&map, &options);
            assert!(is_well_formed(&text), "{window:?}");
        }
    }
}

#[test]
fn any_map_can_be_drawn() {
    QuickCheck::new()
        .rng(Gen::new(12))
        .tests(500)
        .quickcheck(anything_is_drawn as fn(Vec<((u8, u8), (u8, u8))>) -> bool);
}
