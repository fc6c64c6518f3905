//! A diagnosis as JSON. `docs/report.md` describes the keys.

use super::{Diagnosis, FeatureName, Flaw, Kind, MissingVertex, Position, Reason, Records, Sql};
use serde::{Serialize, Serializer};

/// The entry of a list of violations or findings.
#[derive(Serialize)]
struct Entry<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rule: Option<&'static str>,
    #[serde(flatten)]
    kind: Kind,
    #[serde(flatten)]
    records: &'a Records,
    #[serde(skip_serializing_if = "Option::is_none")]
    features: Option<Features<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    others: Option<&'a [FeatureName]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    feature_numbers: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    area: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    width: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    length: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<Places>,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    defects: &'a [Flaw],
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    missing: &'a [MissingVertex],
    #[serde(skip_serializing_if = "Option::is_none")]
    snapping: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    iso_19157: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    accepted: Option<&'a str>,
    message: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    sentence: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    follows_from: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    follows_from_id: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cause: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    remedy: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sql: Option<&'a Sql>,
}

/// A violation has the names of the features; a finding of a coverage also has their numbers and ids.
#[derive(Serialize)]
#[serde(untagged)]
enum Features<'a> {
    Titles(Vec<String>),
    Numbered(&'a [FeatureName]),
}

/// A violation has all places of its records; a finding of a coverage has the place to look at.
#[derive(Serialize)]
#[serde(untagged)]
enum Places {
    All(Vec<Position>),
    One(Position),
}

fn unsigned_zero(x: f64) -> f64 {
    x + 0.0
}

impl Serialize for Diagnosis {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let is_coverage = matches!(self.records, Records::None {});
        let features = self.features.as_ref();
        let one = self.look.filter(|_| is_coverage).map(|at| Places::One(at.map(unsigned_zero)));
        let all = || self.places.as_ref().map(|all| all.iter().map(|at| at.map(unsigned_zero)).collect());
        Entry {
            id: self.id.as_deref(),
            line: self.line,
            rule: self.rule,
            kind: self.kind,
            records: &self.records,
            features: features.map(|all| {
                let titles = || all.iter().map(FeatureName::title).collect();
                if is_coverage { Features::Numbered(all) } else { Features::Titles(titles()) }
            }),
            others: self.others.as_deref(),
            feature_numbers: features.filter(|_| !is_coverage).map(|all| all.iter().map(|one| one.number).collect()),
            area: self.measures.area.map(unsigned_zero),
            width: self.measures.width.map(unsigned_zero),
            length: self.measures.length.map(unsigned_zero),
            at: one.or_else(|| all().map(Places::All)),
            defects: &self.defects,
            missing: &self.missing,
            snapping: self.snapping,
            iso_19157: self.iso,
            accepted: self.accepted.as_deref(),
            message: &self.message,
            sentence: self.sentence.as_deref(),
            follows_from: self.follows_from,
            follows_from_id: self.follows_from_id.as_deref(),
            cause: self.cause,
            remedy: self.remedy,
            sql: self.sql.as_ref(),
        }
        .serialize(serializer)
    }
}

impl Serialize for Reason {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        #[serde(rename_all = "snake_case")]
        enum Form {
            Broken(&'static str),
            NotClosed,
            NotLocated,
            NotConvex,
        }
        match self {
            Self::Validator(why) => why.serialize(serializer),
            Self::Broken(rule) => Form::Broken(rule).serialize(serializer),
            Self::NotClosed => Form::NotClosed.serialize(serializer),
            Self::NotLocated => Form::NotLocated.serialize(serializer),
            Self::NotConvex => Form::NotConvex.serialize(serializer),
        }
    }
}
