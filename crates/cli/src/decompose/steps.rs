//! An animated picture of the steps of a decomposition.

use crate::output::grouped;
use std::fmt::{self, Write as _};
use twinedge::dcel::{FaceKey, HalfEdge};
use twinedge_algorithm::convex::{ConvexError, is_essential, remove_inessential, triangulate};
use twinedge_geometry::Point;
use twinedge_map::PlanarMap;

/// The maximal number of diagonals.
const MOST: usize = 2_000;
const SIZE: f64 = 800.0;
/// The seconds before the first diagonal is looked at, and between two diagonals.
const BEFORE: f64 = 2.0;
const STEP: f64 = 0.6;

#[derive(Debug, thiserror::Error)]
pub(super) enum StepsError {
    #[error(transparent)]
    Convex(#[from] ConvexError),
    #[error("{} diagonals are too many to look at one by one; choose one feature with --feature", grouped(*.0))]
    TooMany(usize),
    #[error(transparent)]
    Write(#[from] fmt::Error),
}

/// A straight line, and whether it was essential when examined.
struct Diagonal {
    ends: [Point; 2],
    essential: bool,
}

/// Draws the triangulation of some faces and each diagonal as it is examined: it turns orange, and then green if it is
/// essential, or else vanishes.
pub(super) fn picture(map: &PlanarMap, faces: &[FaceKey]) -> Result<String, StepsError> {
    let mut map = map.clone();
    let ends =
        |map: &PlanarMap, h: HalfEdge<'_>| [h.origin(), h.target()].map(|v| map.position(v.key()).unwrap_or_default());
    let half_edges = faces.iter().filter_map(|face| map.dcel().face(*face).ok()).flat_map(|face| face.half_edges());
    let borders: Vec<[Point; 2]> = half_edges.map(|h| ends(&map, h)).collect();
    let triangulations = triangulate(&mut map, faces.iter().copied())?;
    let count = triangulations.iter().map(|one| one.diagonals.len()).sum();
    if count > MOST {
        return Err(StepsError::TooMany(count));
    }
    let mut diagonals = Vec::with_capacity(count);
    for key in triangulations.iter().flat_map(|one| &one.diagonals) {
        let h = map.dcel().half_edge(*key).map_err(ConvexError::from)?;
        let (ends, essential) = (ends(&map, h), is_essential(&map, *key).map_err(ConvexError::from)?);
        diagonals.push(Diagonal { ends, essential });
        remove_inessential(&mut map, &[*key]).map_err(ConvexError::from)?;
    }
    Ok(svg(&borders, &diagonals)?)
}

fn svg(borders: &[[Point; 2]], diagonals: &[Diagonal]) -> Result<String, fmt::Error> {
    let mut points = borders.iter().flatten();
    let first = points.next().copied().unwrap_or_default();
    let (mut low, mut high) = (first, first);
    for p in points {
        (low.x, low.y) = (low.x.min(p.x), low.y.min(p.y));
        (high.x, high.y) = (high.x.max(p.x), high.y.max(p.y));
    }
    let longer = (high.x - low.x).max(high.y - low.y);
    let scale = if longer > 0.0 && longer.is_finite() { SIZE / longer } else { 1.0 };
    let at = |p: Point| [(p.x - low.x) * scale + 10.0, (high.y - p.y) * scale + 10.0];
    let [width, height] = [high.x - low.x, high.y - low.y].map(|side| side * scale + 20.0);
    let mut out = String::new();
    writeln!(
        out,
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.1} {height:.1}" width="{width:.0}" height="{height:.0}">
<title>Hertel and Mehlhorn: each diagonal is looked at once; it stays, green, if it is essential, and goes if not</title>
<rect width="100%" height="100%" fill="white"/>
<g stroke="silver" stroke-width="1.5" stroke-linecap="round">"#
    )?;
    for (i, Diagonal { ends, essential }) in diagonals.iter().enumerate() {
        let [[x1, y1], [x2, y2]] = ends.map(at);
        let begin = BEFORE + STEP * i as f64;
        let then = begin + STEP * 0.8;
        let outcome = if *essential {
            format!(r#"<set attributeName="stroke" to="seagreen" begin="{then:.2}s"/>"#)
        } else {
            format!(r#"<set attributeName="visibility" to="hidden" begin="{then:.2}s"/>"#)
        };
        writeln!(
            out,
            r#"<line x1="{x1:.2}" y1="{y1:.2}" x2="{x2:.2}" y2="{y2:.2}"><set attributeName="stroke" to="orange" begin="{begin:.2}s"/>{outcome}</line>"#
        )?;
    }
    writeln!(
        out,
        r#"</g>
<g stroke="black" stroke-width="2" stroke-linecap="round">"#
    )?;
    for ends in borders {
        let [[x1, y1], [x2, y2]] = ends.map(at);
        writeln!(out, r#"<line x1="{x1:.2}" y1="{y1:.2}" x2="{x2:.2}" y2="{y2:.2}"/>"#)?;
    }
    writeln!(out, "</g>\n</svg>")?;
    Ok(out)
}
