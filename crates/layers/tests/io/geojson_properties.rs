//! Laws of the reader of GeoJSON: written data is read back, and reading feature by feature makes no difference.

use crate::{check, read_geojson as read};
use geojson::{GeoJson, GeometryValue};
use quickcheck::{Arbitrary, Gen};
use twinedge_geometry::Point;
use twinedge_layers::io::{ReadCause, ReadError};
use twinedge_map::{Feature, Shape};

/// A document, with the expected result of reading it.
#[derive(Clone, Debug)]
struct Document {
    text: String,
    features: Vec<Feature>,
    with_extra_dimensions: usize,
}

/// Writes a document in one of many equivalent ways.
struct Writer<'g> {
    g: &'g mut Gen,
    with_extra_dimensions: usize,
}

impl Writer<'_> {
    fn flip(&mut self) -> bool {
        bool::arbitrary(self.g)
    }

    fn below(&mut self, bound: usize) -> usize {
        usize::arbitrary(self.g) % bound
    }

    fn space(&mut self) -> &'static str {
        self.g.choose(&["", "", "", " ", "\n", "\t\r\n "]).unwrap()
    }

    fn array<T>(
        &mut self,
        items: impl IntoIterator<Item = T>,
        mut write: impl FnMut(&mut Self, T) -> String,
    ) -> String {
        let mut out = Vec::new();
        for item in items {
            let item = write(self, item);
            out.push(self.space().to_owned() + &item + self.space());
        }
        format!("[{}]", out.join(","))
    }

    /// An object with these members, in any order.
    fn object(&mut self, mut members: Vec<(&str, String)>) -> String {
        if self.flip() {
            members.push(("foreign", r#"{"type":"Point","coordinates":[[],{}]}"#.into()));
        }
        if self.flip() {
            members.push(("bbox", "[-1,-2,3.5,4]".into()));
        }
        for i in (1..members.len()).rev() {
            let j = self.below(i + 1);
            members.swap(i, j);
        }
        let mut out = Vec::new();
        for (key, value) in members {
            out.push(format!("{}\"{key}\"{}:{}{value}", self.space(), self.space(), self.space()));
        }
        format!("{{{}{}}}", out.join(","), self.space())
    }

    fn position(&mut self, p: Point) -> String {
        let extra = self.below(8);
        self.with_extra_dimensions += usize::from(extra > 5);
        // The shortest digits that parse to the same float.
        let mut numbers = vec![format!("{:?}", p.x), format!("{:?}", p.y)];
        numbers.extend((5..extra).map(|_| "7.5".into()));
        self.array(numbers, |_, number| number)
    }

    fn line(&mut self, points: &[Point]) -> String {
        self.array(points, |w, &point| w.position(point))
    }

    fn rings(&mut self, rings: &[Vec<Point>]) -> String {
        self.array(rings, |w, ring| w.line(ring))
    }

    /// A geometry of these shapes: a single one, a multi-geometry if the shapes are of one kind, or a collection.
    fn geometry(&mut self, shapes: &[Shape], depth: usize) -> String {
        let lines: Vec<_> = shapes.iter().filter_map(|s| if let Shape::Line(l) = s { Some(l) } else { None }).collect();
        let polygons: Vec<_> =
            shapes.iter().filter_map(|s| if let Shape::Polygon(r) = s { Some(r) } else { None }).collect();
        let points: Vec<_> =
            shapes.iter().filter_map(|s| if let Shape::Point(p) = s { Some(*p) } else { None }).collect();
        let (kind, coordinates) = match shapes {
            [Shape::Point(point)] if self.flip() => ("Point", self.position(*point)),
            [Shape::Line(line)] if self.flip() => ("LineString", self.line(line)),
            [Shape::Polygon(rings)] if self.flip() => ("Polygon", self.rings(rings)),
            _ if points.len() == shapes.len() && self.flip() => ("MultiPoint", self.line(&points)),
            _ if lines.len() == shapes.len() && self.flip() => ("MultiLineString", self.array(lines, |w, l| w.line(l))),
            _ if polygons.len() == shapes.len() && self.flip() => {
                ("MultiPolygon", self.array(polygons, |w, r| w.rings(r)))
            }
            _ => {
                let mut parts = Vec::new();
                let mut rest = shapes;
                while !rest.is_empty() {
                    let len = if depth < 4 { 1 + self.below(rest.len()) } else { 1 };
                    parts.push(&rest[..len]);
                    rest = &rest[len..];
                }
                let geometries = self.array(parts, |w, part| w.geometry(part, depth + 1));
                return self.object(vec![("type", "\"GeometryCollection\"".into()), ("geometries", geometries)]);
            }
        };
        self.object(vec![("type", format!("\"{kind}\"")), ("coordinates", coordinates)])
    }

    fn feature(&mut self, feature: &Feature) -> String {
        let mut members = vec![("type", "\"Feature\"".into())];
        if feature.shapes.is_empty() && self.flip() {
            members.push(("geometry", "null".into()));
        } else if !feature.shapes.is_empty() {
            members.push(("geometry", self.geometry(&feature.shapes, 0)));
        }
        if let Some(name) = &feature.name {
            let key = *self.g.choose(&["name", "NAME", "Name", "ADMIN", "admin", "title", "id"]).unwrap();
            let properties = self.object(vec![(key, quoted(name)), ("other", "[{\"name\":1}]".into())]);
            members.push(("properties", properties));
        }
        members.extend(feature.id.as_ref().map(|id| ("id", quoted(id))));
        self.object(members)
    }
}

/// A JSON string in ASCII only.
fn quoted(text: &str) -> String {
    let units: Vec<_> = text.encode_utf16().map(|unit| format!("\\u{unit:04x}")).collect();
    format!("\"{}\"", units.concat())
}

fn some_point(g: &mut Gen) -> Point {
    let mut number = || {
        let any = f64::from_bits(u64::arbitrary(g));
        let near = f64::from(i16::arbitrary(g)) / 64.0;
        if any.is_finite() && bool::arbitrary(g) { any } else { near }
    };
    Point { x: number(), y: number() }
}

fn some_line(g: &mut Gen) -> Vec<Point> {
    (0..=u8::arbitrary(g) % 5).map(|_| some_point(g)).collect()
}

fn some_feature(g: &mut Gen) -> Feature {
    let mut shapes = Vec::new();
    let kinds: &[u8] = g.choose(&[&[0][..], &[1], &[2], &[0, 1, 2]]).unwrap();
    for _ in 0..u8::arbitrary(g) % 4 {
        shapes.push(match g.choose(kinds).unwrap() {
            0 => Shape::Point(some_point(g)),
            1 => Shape::Line(some_line(g)),
            _ => Shape::Polygon((0..=u8::arbitrary(g) % 3).map(|_| some_line(g)).collect()),
        });
    }
    Feature { name: Option::arbitrary(g), id: Option::arbitrary(g), shapes }
}

impl Arbitrary for Document {
    fn arbitrary(g: &mut Gen) -> Self {
        let mut features: Vec<_> = (0..u8::arbitrary(g) % 4).map(|_| some_feature(g)).collect();
        let mut w = Writer { g, with_extra_dimensions: 0 };
        let text = match &mut features[..] {
            [one] if w.flip() => w.feature(one),
            [one] if w.flip() && !one.shapes.is_empty() => {
                (one.name, one.id) = (None, None);
                w.geometry(&one.shapes, 0)
            }
            all => {
                let all = w.array(all, |w, feature| w.feature(feature));
                w.object(vec![("type", "\"FeatureCollection\"".into()), ("features", all)])
            }
        };
        let text = w.space().to_owned() + &text + w.space();
        Self { text, with_extra_dimensions: w.with_extra_dimensions, features }
    }
}

#[test]
fn what_was_written_is_read() {
    fn law(document: Document) -> bool {
        let (features, summary) = read(document.text.as_bytes()).unwrap();
        let all = || features.iter().flat_map(|feature| &feature.shapes);
        let positions = all().map(|shape| match shape {
            Shape::Polygon(rings) => rings.iter().map(Vec::len).sum(),
            Shape::Line(points) => points.len(),
            Shape::Point(_) => 1,
        });
        features == document.features
            && summary.features == features.len()
            && summary.without_geometry == features.iter().filter(|feature| feature.shapes.is_empty()).count()
            && summary.polygons == all().filter(|shape| matches!(shape, Shape::Polygon(_))).count()
            && summary.lines == all().filter(|shape| matches!(shape, Shape::Line(_))).count()
            && summary.points == all().filter(|shape| matches!(shape, Shape::Point(_))).count()
            && summary.positions == positions.sum::<usize>()
            && summary.with_extra_dimensions == document.with_extra_dimensions
    }
    check(2_000, 1).quickcheck(law as fn(Document) -> bool);
}

/// A document with one to three bytes replaced, removed or doubled.
#[derive(Clone, Debug)]
struct Damaged(Vec<u8>);

impl Arbitrary for Damaged {
    fn arbitrary(g: &mut Gen) -> Self {
        let mut text = Document::arbitrary(g).text.into_bytes();
        for _ in 0..=u8::arbitrary(g) % 3 {
            let at = usize::arbitrary(g) % text.len();
            match u8::arbitrary(g) % 4 {
                0 => text[at] = *g.choose(b"[]{},:\"0123456789eE+-. ntfx").unwrap(),
                1 => drop(text.remove(at)),
                2 => text.insert(at, text[at]),
                _ => text.insert(at, *g.choose(b"[]{},:\"0123456789eE+-. ntfx").unwrap()),
            }
        }
        Self(text)
    }
}

/// Returns the features of a document that the `geojson` crate reads as a whole.
fn whole(text: &[u8]) -> Option<Vec<Feature>> {
    fn draw(value: &GeometryValue, shapes: &mut Vec<Shape>) {
        let point = |p: &geojson::Position| Point { x: p[0], y: p[1] };
        let line = |l: &Vec<geojson::Position>| -> Vec<Point> { l.iter().map(point).collect() };
        let rings = |rings: &Vec<Vec<geojson::Position>>| Shape::Polygon(rings.iter().map(line).collect());
        match value {
            GeometryValue::Point { coordinates } => shapes.push(Shape::Point(point(coordinates))),
            GeometryValue::MultiPoint { coordinates } => shapes.extend(coordinates.iter().map(point).map(Shape::Point)),
            GeometryValue::LineString { coordinates } => shapes.push(Shape::Line(line(coordinates))),
            GeometryValue::MultiLineString { coordinates } => {
                shapes.extend(coordinates.iter().map(line).map(Shape::Line));
            }
            GeometryValue::Polygon { coordinates } => shapes.push(rings(coordinates)),
            GeometryValue::MultiPolygon { coordinates } => shapes.extend(coordinates.iter().map(rings)),
            GeometryValue::GeometryCollection { geometries } => {
                for geometry in geometries {
                    draw(&geometry.value, shapes);
                }
            }
        }
    }
    fn label(value: &serde_json::Value) -> Option<String> {
        value.as_str().map(str::to_owned).or_else(|| value.as_number().map(ToString::to_string))
    }
    let feature = |feature: geojson::Feature| {
        let mut shapes = Vec::new();
        feature.geometry.iter().for_each(|geometry| draw(&geometry.value, &mut shapes));
        shapes.retain(|shape| match shape {
            Shape::Polygon(rings) => !rings.is_empty(),
            Shape::Line(points) => !points.is_empty(),
            Shape::Point(_) => true,
        });
        let keys = ["name", "NAME", "Name", "ADMIN", "admin", "title", "id"];
        let name = keys.into_iter().find_map(|key| feature.property(key).and_then(label));
        let id = feature.id.map(|id| match id {
            geojson::feature::Id::String(id) => id,
            geojson::feature::Id::Number(id) => id.to_string(),
        });
        Feature { name, id, shapes }
    };
    Some(match GeoJson::from_reader(text).ok()? {
        GeoJson::FeatureCollection(all) => all.features.into_iter().map(feature).collect(),
        GeoJson::Feature(one) => vec![feature(one)],
        GeoJson::Geometry(geometry) => vec![feature(geometry.into())],
    })
}

/// Reading feature by feature and with the crate's reader of whole documents accepts the same documents, with equal
/// results. But the crate also accepts positions of fewer than two numbers, and is stricter about `bbox`.
#[test]
fn damaged_documents_are_read_as_they_are_when_read_whole() {
    fn law(Damaged(text): Damaged) -> bool {
        let ours = read(&text);
        if let Err(ReadError { cause: ReadCause::ShortPosition { numbers: 0 | 1 }, .. }) = ours {
            return true;
        }
        match (ours, whole(&text)) {
            (Ok((ours, _)), Some(theirs)) => ours == theirs,
            (Err(_), Some(_)) => false,
            (Ok(_), None) => serde_json::from_slice::<serde_json::Value>(&text).is_ok(),
            (Err(_), None) => true,
        }
    }
    check(5_000, 2).quickcheck(law as fn(Damaged) -> bool);
}

#[test]
fn the_world_is_read_as_it_is_when_read_whole() {
    let text = include_bytes!("../../../cli/data/world-110m.geojson");
    assert_eq!(read(text).unwrap().0, whole(text).unwrap());
}

/// For arbitrary bytes, errors are placed inside the text, and only JSON is accepted.
#[test]
fn any_bytes() {
    fn law(text: Vec<u8>, documents: Vec<Document>) -> bool {
        let texts = documents.iter().map(|document| document.text.as_bytes());
        [&text[..]].into_iter().chain(texts.clone()).all(is_told_apart)
            && is_told_apart(&texts.collect::<Vec<_>>().concat())
    }
    fn is_told_apart(text: &[u8]) -> bool {
        let place = match read(text) {
            Ok(_) => return serde_json::from_slice::<serde_json::Value>(text).is_ok(),
            Err(error) => error.place,
        };
        let lines: Vec<_> = text.split(|&byte| byte == b'\n').collect();
        (1..=lines.len()).contains(&place.line)
            && place.column.is_some_and(|column| column <= lines[place.line - 1].len())
    }
    check(1_000, 3).quickcheck(law as fn(Vec<u8>, Vec<Document>) -> bool);
}
