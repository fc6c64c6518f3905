//! Giving each face to at most one feature.

use super::change::{Change, ChangeKind, Options, Winner};
use super::heirs::Heirs;
use super::ownership::{Ownership, Region};
use crate::CoverageError;
use crate::gap::accepted_faces;
use crate::region::{connected, mean_width, point_inside};
use crate::sliver::median;
use core::f64::consts::PI;
use rustc_hash::{FxHashMap, FxHashSet};
use twinedge::dcel::{Face, FaceKey};
use twinedge_algorithm::claims::features_of;
use twinedge_map::{FeatureId, PlanarMap};

/// The divisor of the median area of all parts that yields the default sliver area.
const OF_MEDIAN: f64 = 1_000.0;

/// The fraction of its area with which a feature must lie within another one.
const WITHIN: f64 = 0.9;

/// A coverage made from the features of a map.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Cleaned {
    /// The faces of each feature, by [`FeatureId::index`], in order of their indices.
    pub faces: Vec<Vec<FaceKey>>,
    /// The faces that changed hands, in order. A face may appear several times.
    pub changes: Vec<Change>,
    /// The area of slivers, as requested or finally chosen.
    pub sliver_area: f64,
}

/// Gives each face to at most one feature: see [the module](super).
///
/// O(r · n log n) for n half-edges and faces, each counted once for each feature that covers it, and (few) r rounds.
///
/// ```
/// use twinedge_coverage::clean::{ChangeKind, Options, clean};
/// use twinedge_map::{Builder, Noding, Shape};
///
/// // Two parcels; the right one begins half a unit inside the left one.
/// let parcel = |x: f64, width: f64| [[x, 0.0], [x + width, 0.0], [x + width, 10.0], [x, 10.0]];
/// let mut builder = Builder::new();
/// let left = builder.shape(&Shape::polygon(parcel(0.0, 10.0)))?;
/// let right = builder.shape(&Shape::polygon(parcel(9.5, 8.0)))?;
/// let map = builder.build_with(Noding::Exact)?;
/// let cleaned = clean(&map, &Options::default())?;
/// let [change] = &cleaned.changes[..] else { unreachable!("nothing else is wrong") };
/// assert_eq!((change.kind, change.area), (ChangeKind::Overlap, 5.0));
/// assert_eq!((&change.from[..], change.to), (&[left, right][..], Some(left)));
/// assert_eq!((cleaned.faces[0].len(), cleaned.faces[1].len()), (2, 1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`CoverageError::NotPlane`]; build such a map [with snapping](twinedge_map::Noding::Snap).
pub fn clean(map: &PlanarMap, options: &Options) -> Result<Cleaned, CoverageError> {
    clean_with_fillers(map, options, map.features().count())
}

/// Cleans like [`clean`], treating all features from number `fillers` on as fillers. Fillers get nothing: faces that only fillers
/// claim go to the neighbour with the longest common border. This closes gaps open to the outside, by drawing the area to fill.
///
/// ```
/// use twinedge_coverage::clean::{Options, clean_with_fillers};
/// use twinedge_map::{Builder, Noding, Shape};
///
/// let box_of = |x0: f64, x1: f64| [[x0, 0.0], [x1, 0.0], [x1, 9.0], [x0, 9.0]];
/// let mut builder = Builder::new();
/// builder.shape(&Shape::polygon(box_of(0.0, 5.0)))?;
/// builder.shape(&Shape::polygon(box_of(5.1, 9.0)))?;
/// builder.shape(&Shape::polygon(box_of(5.0, 5.1)))?;
/// let cleaned = clean_with_fillers(&builder.build_with(Noding::Exact)?, &Options::default(), 2)?;
/// let sizes: Vec<usize> = cleaned.faces.iter().map(Vec::len).collect();
/// assert_eq!(sizes, [2, 1, 0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As for [`clean`].
pub fn clean_with_fillers(map: &PlanarMap, options: &Options, fillers: usize) -> Result<Cleaned, CoverageError> {
    map.plane()?;
    let mut ownership = Ownership::new(map, options.window);
    let mut changes = overlaps(map, &mut ownership, options.winner, fillers);
    let heirs = Heirs::new(map, &options.gaps_to);
    fill(&mut ownership, fillers, &heirs, &mut changes);
    let accepted = accepted_faces(map, &options.accepted_gaps);
    let sliver_area = loop {
        let regions = ownership.regions();
        let limit = options.sliver_area.unwrap_or_else(|| {
            let parts = regions.iter().filter(|region| region.owner.is_some());
            median(parts.map(|region| region.area).collect()) / OF_MEDIAN
        });
        let before = changes.len();
        let is_accepted = |face: &Face<'_>| accepted.contains(&face.index());
        let gaps = regions.iter().filter(|region| region.is_gap() && !region.faces.iter().any(is_accepted));
        fill_gaps(
            &mut ownership,
            gaps,
            &heirs,
            |area, width| area < limit || options.gap_width.is_some_and(|greatest| width <= greatest),
            &mut changes,
        );
        // Filled gaps have changed their neighbours.
        if changes.len() == before {
            let is_sliver = |region: &Region<'_>| {
                let is_thin = 4.0 * PI * region.area < options.thinness * region.length * region.length;
                !region.is_outside
                    && region.area < limit
                    && is_thin
                    && region.owner.is_some_and(|owner| !heirs.has(owner))
            };
            give_slivers(&mut ownership, &regions, is_sliver, &mut changes);
        }
        if changes.len() == before {
            break limit;
        }
    };
    let mut faces = vec![Vec::new(); map.features().count()];
    for face in map.dcel().faces() {
        if let Some(owner) = ownership.owner(face) {
            faces[owner.index()].push(face.key());
        }
    }
    Ok(Cleaned { faces, changes, sliver_area })
}

/// Gives each face to one of the features that claim it, and returns the faces with several claimants.
pub(super) fn overlaps(map: &PlanarMap, ownership: &mut Ownership<'_>, winner: Winner, fillers: usize) -> Vec<Change> {
    let mut sizes = vec![0.0; map.features().count()];
    for face in map.dcel().faces() {
        for feature in features_of(map, face) {
            sizes[feature.index()] += ownership.area(&[face]);
        }
    }
    let nested = if winner == Winner::Inner { nested(ownership, &sizes) } else { FxHashSet::default() };
    let claims = |face: Face<'_>| {
        let claimed = features_of(map, face).filter(|feature| feature.index() < fillers);
        Some(claimed.collect::<Vec<_>>()).filter(|all| !all.is_empty())
    };
    let mut changes = Vec::new();
    for faces in connected(map.dcel().faces(), claims) {
        let from: Vec<FeatureId> = faces.first().copied().and_then(claims).unwrap_or_default();
        let size = |feature: &FeatureId| sizes[feature.index()];
        let by_area = |a: FeatureId, b: FeatureId, is_better: fn(&f64, &f64) -> bool| {
            if is_better(&size(&b), &size(&a)) { b } else { a }
        };
        let larger = || from.iter().copied().reduce(|a, b| by_area(a, b, f64::gt));
        let to = match winner {
            Winner::Inner => {
                let is_inner = |a: &FeatureId| from.iter().any(|b| nested.contains(&(*a, *b)));
                from.iter().copied().filter(is_inner).reduce(|a, b| by_area(a, b, f64::lt)).or_else(larger)
            }
            Winner::Larger => larger(),
            Winner::Smaller => from.iter().copied().reduce(|a, b| by_area(a, b, f64::lt)),
            Winner::First => from.first().copied(),
            Winner::Last => from.last().copied(),
        };
        ownership.give(&faces, to);
        if from.len() > 1 {
            changes.push((faces, from, to));
        }
    }
    let regions = changes.into_iter().map(|(faces, from, to)| {
        let region = ownership.region(faces);
        change(map, ChangeKind::Overlap, from, to, &region)
    });
    regions.collect()
}

/// Returns the pairs of features whose first lies within the second, larger one. O(faces · log + pairs of features that claim the
/// same face, for each face), expected.
fn nested(ownership: &Ownership<'_>, sizes: &[f64]) -> FxHashSet<(FeatureId, FeatureId)> {
    let mut common: FxHashMap<(FeatureId, FeatureId), f64> = FxHashMap::default();
    for face in ownership.map.dcel().faces() {
        let claiming: Vec<FeatureId> = features_of(ownership.map, face).collect();
        for (a, b) in claiming.iter().flat_map(|a| claiming.iter().map(move |b| (*a, *b))) {
            *common.entry((a, b)).or_default() += ownership.area(&[face]);
        }
    }
    let is_nested = |((a, b), area): &((FeatureId, FeatureId), f64)| {
        let (size, around) = (sizes[a.index()], sizes[b.index()]);
        size < around && *area >= WITHIN * size
    };
    common.into_iter().filter(is_nested).map(|(pair, _)| pair).collect()
}

/// Gives faces that only fillers claim to neighbours.
fn fill(ownership: &mut Ownership<'_>, fillers: usize, heirs: &Heirs, changes: &mut Vec<Change>) {
    let map = ownership.map;
    let is_filled = |face: Face<'_>| {
        let is_free = ownership.owner(face).is_none() && !face.is_unbounded();
        (is_free && features_of(map, face).any(|feature| feature.index() >= fillers)).then_some(())
    };
    for faces in connected(map.dcel().faces(), is_filled) {
        let region = ownership.region(faces);
        if let Some(to) = heirs.of_gap(ownership, &region) {
            ownership.give(&region.faces, Some(to));
            changes.push(change(map, ChangeKind::Gap, Vec::new(), Some(to), &region));
        }
    }
}

fn change(
    map: &PlanarMap,
    kind: ChangeKind,
    from: Vec<FeatureId>,
    to: Option<FeatureId>,
    region: &Region<'_>,
) -> Change {
    let largest = region.faces.iter().max_by(|a, b| {
        let area = |face: &Face<'_>| twinedge_algorithm::area::face_area(map, face.key()).unwrap_or_default();
        area(a).total_cmp(&area(b))
    });
    Change {
        kind,
        from,
        to,
        area: region.area,
        width: mean_width(region.area, region.length),
        at: largest.and_then(|face| point_inside(map, *face)).unwrap_or_default(),
        faces: region.faces.iter().map(|face| face.key()).collect(),
    }
}

/// Gives gaps to their neighbours. Two gaps are never neighbours, so the regions remain valid meanwhile.
fn fill_gaps<'r, 'm: 'r>(
    ownership: &mut Ownership<'_>,
    gaps: impl Iterator<Item = &'r Region<'m>>,
    heirs: &Heirs,
    is_filled: impl Fn(f64, f64) -> bool,
    changes: &mut Vec<Change>,
) {
    for region in gaps.filter(|region| is_filled(region.area, mean_width(region.area, region.length))) {
        let Some(to) = heirs.of_gap(ownership, region) else { continue };
        ownership.give(&region.faces, Some(to));
        changes.push(change(ownership.map, ChangeKind::Gap, Vec::new(), Some(to), region));
    }
}

/// Gives slivers to their neighbours, the smallest first, but skips neighbours of a sliver already given away in this round: they
/// may now be part of something larger.
fn give_slivers(
    ownership: &mut Ownership<'_>,
    regions: &[Region<'_>],
    is_sliver: impl Fn(&Region<'_>) -> bool,
    changes: &mut Vec<Change>,
) {
    let mut parts = vec![0_usize; ownership.map.features().count()];
    for owner in regions.iter().filter_map(|region| region.owner) {
        parts[owner.index()] += 1;
    }
    let mut slivers: Vec<&Region<'_>> = regions.iter().filter(|region| is_sliver(region)).collect();
    slivers.sort_by(|a, b| a.area.total_cmp(&b.area));
    let mut changed: FxHashSet<usize> = FxHashSet::default();
    for region in slivers {
        let Some(owner) = region.owner else { continue };
        let is_beside = region.faces.iter().any(|face| changed.contains(&face.index()));
        // The last part of a feature stays, or the feature would be empty.
        if is_beside || parts[owner.index()] == 1 {
            continue;
        }
        let to = ownership.neighbour(region, |_| true);
        ownership.give(&region.faces, to);
        parts[owner.index()] -= 1;
        for face in &region.faces {
            changed.insert(face.index());
            changed.extend(face.neighbours().map(|other| other.index()));
        }
        changes.push(change(ownership.map, ChangeKind::Sliver, vec![owner], to, region));
    }
}
