//! Meeting arcs, and edges that are not arcs, as violations.

use super::lines::lines;
use crate::coverage::Coverage;
use crate::imported::Imported;
use crate::names::all_named;
use crate::trace::position;
use std::collections::BTreeSet;
use twinedge::validate::Rule;
use twinedge_coverage::CoverageRule;
use twinedge_diagnosis::{Diagnosis, Kind, Records, Trace};
use twinedge_geometry::Point;
use twinedge_sphere::{Clash, Drawing, Undrawn};

pub(super) fn antipodal(imported: &Imported, one: &Undrawn) -> Diagnosis {
    let places = one.ends.map(position);
    Diagnosis {
        message: "an edge joins antipodes, between which no way is the shortest".to_owned(),
        features: Some(all_named(imported, [one.feature])),
        records: Records::Names { records: vec![edge(one.ends)] },
        places: Some(places.to_vec()),
        look: places.first().copied(),
        trace: Trace { points: places.to_vec(), ..Trace::default() },
        cause: Some("an edge goes around half of the globe"),
        remedy: Some("add a vertex between its ends"),
        ..of_rule(Rule::G1, "antipodal")
    }
}

pub(super) fn clashing(imported: &Imported, drawing: &Drawing, clash: &Clash, coverage: &Coverage) -> Diagnosis {
    let (kind, arcs, message) = match *clash {
        Clash::Cross { arcs } => ("cross", arcs.to_vec(), "two edges cross on the globe"),
        Clash::Overlap { arcs } => ("overlap", arcs.to_vec(), "two edges have more than a point in common"),
        Clash::Touch { arc, .. } => ("touch", vec![arc], "a vertex lies inside an edge"),
    };
    let at = position(clash.at(drawing));
    let ends = |arc: &u32| drawing.arcs()[*arc as usize].ends.map(|end| drawing.degrees(end));
    let edges: Vec<[Point; 2]> = arcs.iter().map(ends).collect();
    let of_arcs = arcs.iter().flat_map(|arc| drawing.arcs()[*arc as usize].features.iter().copied());
    let of_place = match *clash {
        Clash::Touch { place, .. } => {
            let has = drawing.arcs().iter().filter(|arc| arc.ends.contains(&place));
            has.flat_map(|arc| arc.features.iter().copied()).collect()
        }
        _ => Vec::new(),
    };
    let features: BTreeSet<u32> = of_arcs.chain(of_place).collect();
    let numbers = features.iter().map(|feature| *feature as usize).collect();
    let is_mismatch = !matches!(clash, Clash::Cross { .. }) && coverage.lacks_any(&[clash.at(drawing)], &numbers);
    let (cause, remedy) = if is_mismatch {
        ("borders have different vertices", "add the vertices that are missing (C7), from which it follows")
    } else {
        (
            "borders that are drawn with different vertices run along different great circles",
            "draw both borders with the same vertices; a border that is straight on the map needs more of them",
        )
    };
    Diagnosis {
        message: message.to_owned(),
        features: Some(all_named(imported, features)),
        records: Records::Names { records: edges.iter().map(|ends| edge(*ends)).collect() },
        places: Some(vec![at]),
        look: Some(at),
        trace: Trace { lines: lines(&edges), ..Trace::default() },
        cause: Some(cause),
        remedy: Some(remedy),
        follows_from: is_mismatch.then_some(CoverageRule::Mismatch.id()),
        ..of_rule(Rule::G4, kind)
    }
}

fn of_rule(rule: Rule, kind: &'static str) -> Diagnosis {
    Diagnosis { rule: Some(rule.id()), kind: Kind::Named { kind }, is_violation: true, ..Diagnosis::default() }
}

fn edge([a, b]: [Point; 2]) -> String {
    format!("edge ({}, {}) to ({}, {})", a.x, a.y, b.x, b.y)
}
