//! The findings as a layer of GeoJSON.

use crate::diagnosis_text::full_message;
use crate::error::Error;
use crate::report::AuditReport;
use crate::trace::has_place;
use crate::verdict::Verdict;
use crate::words::plain;
use serde_json::json;
use std::sync::Arc;
use twinedge_diagnosis::{Diagnosis, FeatureName, Measures, Position as Place, Trace};
use twinedge_layers::{
    Crs, Dimensions, Feature, Format, Geometry, Header, Id, Layer, Members, Position, Shape, Value, losses, write,
};

/// Returns one feature for each finding, all with the same columns, and warnings.
pub(crate) fn layer(report: &AuditReport) -> Result<(Vec<u8>, Vec<String>), Error> {
    let mut members = Members::new();
    members.insert("valid".to_owned(), (report.verdict() == Verdict::Valid).into());
    members.insert("verdict".to_owned(), report.sentence().into());
    members.insert("found".to_owned(), report.total().into());
    let columns = Columns::new();
    let layer = Layer {
        header: Header {
            name: Some(format!("findings in {}", report.input)),
            // Longitudes and latitudes need no reference system.
            crs: report.crs.clone().filter(Crs::is_other),
            members,
            ..Header::default()
        },
        features: report.listed().zip(1..).map(|(one, number)| columns.feature(report, one, number)).collect(),
    };
    let mut warnings = Vec::new();
    if report.crs.is_none() && !layer.features.iter().all(looks_like_degrees) {
        warnings.push(
            "no coordinate reference system is known, and the coordinates are no longitudes and latitudes, for which a reader of GeoJSON \
will take them: set the reference system of the layer by hand"
                .to_owned(),
        );
    }
    let lost = losses(&layer, Format::GeoJson).into_iter();
    warnings.extend(lost.map(|loss| format!("{} does not hold {}", Format::GeoJson, plain(&loss.to_string()))));
    let mut bytes = Vec::new();
    write(&layer, &mut bytes, Format::GeoJson)?;
    Ok((bytes, warnings))
}

/// Returns true if all positions of a feature can be longitudes and latitudes in degrees.
fn looks_like_degrees(feature: &Feature) -> bool {
    let mut all = true;
    if let Some(geometry) = &feature.geometry {
        geometry.shape.visit(&mut |position| all &= position.x.abs() <= 360.0 && position.y.abs() <= 90.0);
    }
    all
}

struct Columns([Arc<str>; 22]);

impl Columns {
    fn new() -> Self {
        Self(
            [
                "rule",
                "name",
                "kind",
                "message",
                "violation",
                "records",
                "features",
                "feature_ids",
                "feature_names",
                "area",
                "width",
                "length",
                "unit",
                "x",
                "y",
                "cause",
                "remedy",
                "accepted",
                "others",
                "id",
                "follows_from",
                "follows_from_id",
            ]
            .map(Arc::from),
        )
    }

    fn feature(&self, report: &AuditReport, one: &Diagnosis, number: u64) -> Feature {
        let text = |text: &str| Value::Text(text.to_owned());
        let number_of = |value: Option<f64>| value.filter(|x| x.is_finite()).map_or(Value::Null, Value::Real);
        let features = one.features.as_deref().unwrap_or_default();
        let list = |each: fn(&FeatureName) -> String| Value::Json(features.iter().map(each).collect());
        let Measures { area, width, length } = one.measures;
        let has_measure = area.or(width).or(length).is_some();
        let [x, y] = one.look.map_or([None; 2], |at| at.map(Some));
        let values = [
            text(one.rule.unwrap_or_default()),
            text(report.name_of_rule(one)),
            text(one.kind.name()),
            text(&full_message(one)),
            Value::Bool(one.is_violation),
            Value::Json(json!(one.records.names())),
            list(|feature| feature.label.clone()),
            list(FeatureName::key),
            list(|feature| feature.name.clone().unwrap_or_default()),
            number_of(area),
            number_of(width),
            number_of(length),
            report.unit().filter(|_| has_measure).map_or(Value::Null, text),
            number_of(x),
            number_of(y),
            one.cause.map_or(Value::Null, text),
            one.remedy.map_or(Value::Null, text),
            one.accepted.as_deref().map_or(Value::Null, text),
            one.others.as_ref().map_or(Value::Null, |all| Value::Json(all.iter().map(FeatureName::key).collect())),
            one.id.as_deref().map_or(Value::Null, text),
            one.follows_from.map_or(Value::Null, text),
            one.follows_from_id.as_deref().map_or(Value::Null, text),
        ];
        Feature {
            id: Some(Id::Number(number.into())),
            geometry: shape(&one.trace, one.look)
                .filter(|_| has_place(one))
                .map(|shape| Geometry::new(Dimensions::default(), shape)),
            attributes: self.0.iter().cloned().zip(values).collect(),
            members: Members::new(),
        }
    }
}

/// The shape of a finding: its polygons, or else its lines, its points, or the place to look at.
fn shape(trace: &Trace, at: Option<Place>) -> Option<Shape> {
    let position = |p: &Place| Position::new(p[0], p[1]);
    let line = |line: &Vec<Place>| line.iter().map(position).collect::<Vec<_>>();
    let polygon = |rings: &Vec<Vec<Place>>| rings.iter().map(line).collect::<Vec<_>>();
    Some(match (&trace.polygons[..], &trace.lines[..], &trace.points[..]) {
        ([one], ..) => Shape::Polygon(polygon(one)),
        ([], [one], _) => Shape::Line(line(one)),
        ([], [], [one]) => Shape::Point(Some(position(one))),
        ([], [], []) => Shape::Point(Some(position(&at?))),
        ([], [], several) => Shape::MultiPoint(several.iter().map(position).map(Some).collect()),
        ([], several, _) => Shape::MultiLine(several.iter().map(line).collect()),
        (several, ..) => Shape::MultiPolygon(several.iter().map(polygon).collect()),
    })
}
