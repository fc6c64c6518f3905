//! The rules between layers, X1 … X6, in the report of `audit`.

use crate::diagnosis_text::size;
use crate::error::Error;
use crate::imported::Imported;
use crate::input::Input;
use crate::names::named;
use crate::noted::Keep;
use crate::options::{MapOptions, Options, ParentColumn};
use crate::report::AuditReport;
use crate::trace::{of_extent, position};
use crate::units::Units;
use crate::words::{grouped, measure, plain};
use serde::Serialize;
use serde_json::json;
use std::collections::HashMap;
use twinedge_coverage::layers::{Deviation, LayerFinding, LayerRule, Parent, Piece, check, check_parents, pieces};
use twinedge_diagnosis::{Diagnosis, FeatureName, Kind, Measures, RuleLine};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::{Builder, Feature, FeatureId, Noding, PlanarMap, Shape};

pub(crate) struct Other {
    imported: Imported,
    features: Vec<Feature>,
}

impl Other {
    pub(crate) fn read(input: Input, options: &Options) -> Result<Self, Error> {
        let columns: Vec<String> = options
            .parent_column
            .iter()
            .map(|parent| parent.key.clone().unwrap_or_else(|| parent.column.clone()))
            .collect();
        let mut map = options.map.clone();
        map.name_from = None;
        let keep = Keep { columns: &columns, ..Keep::default() };
        let name = plain(&input.name);
        let mut features = Vec::new();
        let mut put = |feature| {
            features.push(feature);
            Ok(())
        };
        let imported = Imported::features(input, &map, keep, &mut put)
            .map_err(|why| Error::Against { input: name, why: Box::new(why) })?;
        if imported.read.polygons == 0 {
            return Err(Error::NoAreas(plain(&imported.name)));
        }
        Ok(Self { imported, features })
    }
}

/// Judges a map by another layer, or by parents among its own features, and adds the findings to the report.
pub(crate) fn judge(
    imported: &Imported,
    other: Option<&Other>,
    options: &Options,
    report: &mut AuditReport,
    stage: &mut dyn FnMut(&'static str),
) -> Result<(), Error> {
    stage("comparing the layers");
    let count = imported.features.len();
    let both = Both { imported, other, map: noded(imported, other, options.map.snap)? };
    let units = Units::of(imported, options.measured.geodesic)?;
    let mut found = Vec::new();
    let mut rules = Vec::new();
    if other.is_some() {
        let points = both.points();
        // A noded map is plane.
        found.extend(check(&both.map, count, &points)?);
        rules.extend(both.rules(points.len()));
    }
    if let Some(asked) = &options.parent_column {
        let parents = both.parents(asked)?;
        let complete: Vec<FeatureId> = both.map.features().skip(count).collect();
        let of_parents = check_parents(&both.map, &parents, &complete)?;
        found.extend(of_parents);
        let parts = parents.iter().filter(|parent| **parent != Parent::None).count();
        rules.push((LayerRule::Parent, parts, "parts"));
    }
    rules.sort_by_key(|(rule, ..)| *rule);
    found.sort_by_key(LayerFinding::rule);
    for (rule, checked, unit) in rules {
        let of_rule = || found.iter().filter(|one| one.rule() == rule);
        report.rules.push(RuleLine {
            id: rule.id(),
            name: rule.name(),
            statement: rule.statement(),
            checked: checked as u64,
            unit,
            violations: of_rule().count() as u64,
            unchecked: None,
            left_out: None,
        });
        report.findings.extend(of_rule().take(options.most()).map(|one| both.diagnosis(one.clone(), &units)));
    }
    report.finding_count += found.len() as u64;
    report.json.has_findings = true;
    if let Some(Other { imported, features }) = other {
        report.options.insert("against".to_owned(), json!(imported.name));
        let against = json!({ "input": imported.name, "features": features.len() });
        report.json.extra.insert("against".to_owned(), against);
    }
    Ok(())
}

/// The common area of a feature of one layer and a feature of another, or the area that only one of them covers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Shared {
    /// The feature of the first layer.
    pub first: Option<FeatureName>,
    /// The feature of the other layer.
    pub second: Option<FeatureName>,
    /// The area.
    pub area: f64,
}

impl Shared {
    /// Returns the row of a table: both features by id, or else name, and the area.
    #[must_use]
    pub fn row(&self) -> (String, String, f64) {
        let key = |one: &Option<FeatureName>| one.as_ref().map(FeatureName::key).unwrap_or_default();
        (key(&self.first), key(&self.second), self.area)
    }
}

/// Returns the common areas of a map's features and another layer's features. The map must have been read with its features kept.
///
/// O((n + k) log n) for n segments of both that meet k times.
///
/// # Errors
/// [`Error`], if the other layer cannot be read or the layers cannot be compared.
pub fn shared(
    imported: &Imported,
    other: Input,
    options: &MapOptions,
    units: &Units,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Vec<Shared>, Error> {
    let other = Other::read(other, &Options { map: options.clone(), ..Options::default() })?;
    stage("comparing the layers");
    let both = Both { imported, other: Some(&other), map: noded(imported, Some(&other), options.snap)? };
    let of = |piece: Piece| {
        let faces = piece.faces.iter().filter_map(|face| both.map.dcel().face(*face).ok());
        Shared {
            first: piece.first.map(|one| both.named(one)),
            second: piece.second.map(|one| both.named(one)),
            area: faces.map(|face| units.area(&both.map, face)).sum(),
        }
    };
    Ok(pieces(&both.map, imported.features.len())?.into_iter().map(of).collect())
}

/// Builds the map of both layers, with edges cut where they meet.
fn noded(imported: &Imported, other: Option<&Other>, snap: Option<Snap>) -> Result<PlanarMap, Error> {
    let mut builder = Builder::new();
    for feature in imported.features.iter().chain(other.iter().flat_map(|other| &other.features)) {
        builder.feature(feature)?;
    }
    if let Some(snap) = snap {
        return Ok(builder.build_with(Noding::Snap(snap))?);
    }
    Ok(match builder.build_keeping()? {
        (_, Some(kept)) => kept.build_with(Noding::Snap(Snap::Auto))?,
        (map, None) => map,
    })
}

/// Both layers on one map: first the features of the audited layer, then the features of the other.
struct Both<'a> {
    imported: &'a Imported,
    other: Option<&'a Other>,
    map: PlanarMap,
}

impl Both<'_> {
    fn points(&self) -> Vec<(FeatureId, Point)> {
        let of = |(id, feature): (FeatureId, &Feature)| {
            let points = feature.shapes.iter().filter_map(|shape| match shape {
                Shape::Point(point) => Some(*point),
                _ => None,
            });
            points.map(move |point| (id, point)).collect::<Vec<_>>()
        };
        self.map.features().zip(&self.imported.features).flat_map(of).collect()
    }

    /// Returns the rules that apply to the audited layer, with the number and kind of judged items.
    fn rules(&self, points: usize) -> Vec<(LayerRule, usize, &'static str)> {
        let has = |is: fn(&Shape) -> bool| {
            self.imported.features.iter().filter(|feature| feature.shapes.iter().any(is)).count()
        };
        let areas = has(|shape| matches!(shape, Shape::Polygon(_)));
        let lines = has(|shape| matches!(shape, Shape::Line(_)));
        let (faces, edges) = (self.map.dcel().face_count(), self.map.dcel().edge_count());
        let all = [
            (areas > 0, LayerRule::Within, areas, "features"),
            (areas > 0, LayerRule::Cover, faces, "faces"),
            (areas + lines > 0, LayerRule::Border, edges, "edges"),
            (lines > 0, LayerRule::Line, lines, "features"),
            (points > 0, LayerRule::Point, points, "points"),
        ];
        all.into_iter().filter(|(is_asked, ..)| *is_asked).map(|(_, rule, count, unit)| (rule, count, unit)).collect()
    }

    fn parents(&self, asked: &ParentColumn) -> Result<Vec<Parent>, Error> {
        let ParentColumn { column, key } = asked;
        let own = &self.imported.noted;
        let is_given = |values: &&Vec<Option<String>>| values.iter().any(Option::is_some);
        let Some(of_parts) = own.values.first().filter(is_given) else { return Err(own.no_column(column)) };
        let (first, noted, names) = match self.other {
            Some(other) => (own.ids.len(), &other.imported.noted, &other.imported.map),
            None => (0, own, &self.imported.map),
        };
        let of_column = match self.other {
            Some(_) => noted.values.first(),
            None => noted.values.get(1),
        };
        let of_column = of_column.filter(is_given);
        let (keys, word) = match (key, of_column) {
            (Some(key), None) => return Err(noted.no_column(key)),
            (_, Some(values)) => (values.clone(), key.as_ref().unwrap_or(column).clone()),
            _ if noted.ids.iter().any(Option::is_some) => (noted.ids.clone(), "id".to_owned()),
            _ => (names.features().map(|one| names.name(one).map(str::to_owned)).collect(), "name".to_owned()),
        };
        let mut known: HashMap<&str, FeatureId> = HashMap::new();
        let mut twice = HashMap::new();
        for (value, feature) in keys.iter().zip(self.map.features().skip(first)) {
            if let Some(value) = value
                && known.insert(value, feature).is_some()
            {
                twice.insert(value.as_str(), feature);
            }
        }
        let parent = |value: &Option<String>| match value {
            Some(value) => known.get(&**value).map_or(Parent::Unknown, |parent| Parent::Feature(*parent)),
            None if self.other.is_some() => Parent::Unknown,
            None => Parent::None,
        };
        let ambiguous = of_parts.iter().flatten().find(|value| twice.contains_key(&***value));
        if let Some(value) = ambiguous {
            return Err(Error::TwoParents { key: plain(&word), value: plain(value) });
        }
        let parents: Vec<Parent> = of_parts.iter().map(parent).collect();
        if !parents.iter().any(|parent| matches!(parent, Parent::Feature(_))) {
            return Err(Error::NoParents { column: plain(column), key: plain(&word) });
        }
        Ok(parents)
    }

    /// Returns a feature's names in its layer.
    fn named(&self, feature: FeatureId) -> FeatureName {
        let of_other = feature.index().checked_sub(self.imported.features.len()).zip(self.other);
        let in_other =
            of_other.and_then(|(number, other)| Some((&other.imported, other.imported.map.feature(number)?)));
        in_other.map_or_else(|| named(self.imported, feature), |(imported, id)| named(imported, id))
    }

    fn diagnosis(&self, mut finding: LayerFinding, units: &Units) -> Diagnosis {
        units.convert_between(&self.map, &mut finding);
        let (has_faces, has_length) = (!finding.faces.is_empty(), !finding.stretches.is_empty());
        let measures = Measures {
            area: has_faces.then_some(finding.area),
            width: has_faces.then_some(finding.width),
            length: (has_faces || has_length).then_some(finding.length),
        };
        let features: Vec<FeatureName> = finding.features.iter().map(|one| self.named(*one)).collect();
        let others: Vec<FeatureName> = finding.others.iter().map(|one| self.named(*one)).collect();
        let mut message = self.message(&finding, &features, &others);
        let how_large =
            size(measures).or_else(|| has_length.then(|| format!("a length of {}", measure(finding.length))));
        if let Some(how_large) = how_large {
            message = format!("{message}; {how_large}");
        }
        // A part without area has no face to point at.
        let at = if finding.deviation == Deviation::UnknownParent && !has_faces {
            finding.features.first().and_then(|part| self.first_point(*part))
        } else {
            Some(finding.at)
        };
        let trace = at.map(|at| of_extent(&self.map, &finding.faces, &finding.stretches, at)).unwrap_or_default();
        let (cause, remedy) = explanation(finding.deviation);
        Diagnosis {
            rule: Some(finding.rule().id()),
            kind: Kind::Named { kind: finding.deviation.name() },
            message,
            cause: Some(cause),
            remedy: Some(remedy),
            features: Some(features),
            others: Some(others),
            look: at.map(position),
            trace,
            measures,
            is_violation: true,
            ..Diagnosis::default()
        }
    }

    /// Returns the first point of a feature of the audited layer.
    fn first_point(&self, feature: FeatureId) -> Option<Point> {
        self.imported.features.get(feature.index())?.shapes.iter().find_map(|shape| match shape {
            Shape::Polygon(rings) => rings.first()?.first().copied(),
            Shape::Line(points) => points.first().copied(),
            Shape::Point(point) => Some(*point),
        })
    }

    /// Describes the finding, including the features of the other layer.
    fn message(&self, finding: &LayerFinding, features: &[FeatureName], others: &[FeatureName]) -> String {
        let layer = self.other.map_or_else(|| "this layer".to_owned(), |other| plain(&other.imported.name));
        let names = listed(others);
        let value = |feature: &FeatureName| {
            let values = self.imported.noted.values.first();
            values.and_then(|values| values.get(feature.number)).cloned().flatten()
        };
        match finding.deviation {
            Deviation::NotWithin => match others {
                [] => format!("it lies in no feature of {layer}"),
                [one] => format!("it lies in {} of {layer} and outside of it", one.label),
                [one, ..] => format!("it lies in {names} of {layer}; outside {}", one.label),
            },
            Deviation::OnlyHere => format!("{layer} does not cover this"),
            Deviation::OnlyThere => format!("only {names} of {layer} covers this"),
            Deviation::NoBorder => format!("no border runs along that of {names} of {layer}"),
            Deviation::OutsideParent => format!("it lies outside {names}, which is its parent"),
            Deviation::ParentNotCovered => format!("none of its parts covers this of {names}"),
            Deviation::UnknownParent => match features.first().and_then(value) {
                Some(value) => format!("its parent {} is not known", plain(&value)),
                None => "it names no parent".to_owned(),
            },
            Deviation::OffBorder => format!("it runs along no border of {layer}"),
            _ if others.is_empty() => format!("it lies in no feature of {layer}"),
            _ => format!("it lies on the border of {names} of {layer}"),
        }
    }
}

/// The first names, and the number of further ones.
fn listed(features: &[FeatureName]) -> String {
    let labels: Vec<&str> = features.iter().map(|one| &*one.label).collect();
    match labels.split_at(labels.len().min(3)) {
        (few, []) => few.join(", "),
        (few, more) => format!("{} and {} more", few.join(", "), grouped(more.len())),
    }
}

const fn explanation(deviation: Deviation) -> (&'static str, &'static str) {
    match deviation {
        Deviation::NotWithin | Deviation::NoBorder | Deviation::OffBorder => (
            "the layers were drawn, simplified or revised one by one",
            "take the borders of one layer for the other; `--snap SIZE` judges the layers as if borders within a cell were one",
        ),
        Deviation::OnlyHere | Deviation::OnlyThere => (
            "a feature is missing in one of the layers, or their coasts were drawn one by one",
            "add the feature, or clip both layers by one outline",
        ),
        Deviation::OutsideParent => (
            "it names the wrong parent, or its border was not moved with that of the parent",
            "correct the column, or take the border of the parent",
        ),
        Deviation::ParentNotCovered => (
            "a part is missing, names another parent, or ends before the border of the parent",
            "add the part, or correct its parent or its border",
        ),
        Deviation::UnknownParent => {
            ("the parent was renamed or is not in the layer", "correct the column, or add the parent")
        }
        _ => ("its coordinates or its feature were revised", "move the point, or delete it"),
    }
}
