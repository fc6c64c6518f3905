//! Choosing the width up to which gaps are filled.

use super::change::Options;
use super::ownership::{Ownership, Region};
use super::resolve::overlaps;
use crate::CoverageError;
use crate::gap::accepted_faces;
use crate::region::mean_width;
use crate::sliver::median;
use twinedge_map::PlanarMap;

/// The minimum ratio between the width of the next wider gap and the widest filled gap.
const STEP: f64 = 10.0;

/// A chosen width.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ChosenWidth {
    /// The width of the widest erroneous gap, rounded up to two digits.
    pub width: f64,
    /// The number of gaps of at most this width.
    pub gaps: usize,
    /// The width of the next wider gap, or the median width of the parts of features if there is none.
    pub next: f64,
}

/// Chooses the width up to which gaps are errors, by the mean widths of gaps and of the parts of features. `None` if unclear.
///
/// The widths are sorted, with the median width of the parts of features at the upper end. Going down, gaps are lakes until a
/// width is ten times as large as the next one; all gaps below this step are errors. This is single linkage of the logarithms of
/// the widths. A layer cleaned with this width no longer has such a step.
///
/// O(n log n).
///
/// ```
/// use twinedge_coverage::clean::{Options, choose_gap_width};
/// use twinedge_map::{Builder, Shape};
///
/// // A parcel with a crack, a hundredth wide, and a lake, in it.
/// let box_of = |x: f64, width: f64| {
///     [[x, 1.0], [x + width, 1.0], [x + width, 9.0], [x, 9.0], [x, 1.0]].map(Into::into).to_vec()
/// };
/// let mut builder = Builder::new();
/// let outer = [[0.0, 0.0], [20.0, 0.0], [20.0, 10.0], [0.0, 10.0], [0.0, 0.0]].map(Into::into).to_vec();
/// builder.shape(&Shape::Polygon(vec![outer, box_of(1.0, 0.01), box_of(9.0, 2.0)]))?;
/// let chosen = choose_gap_width(&builder.build()?, &Options::default())?.expect("the lake is more than ten times as wide");
/// assert_eq!((chosen.width, chosen.gaps, chosen.next), (0.01, 1, 1.6));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Source: J. C. Gower, G. J. S. Ross, "Minimum Spanning Trees and Single Linkage Cluster Analysis", Applied Statistics 18
/// (1969), 54–64.
///
/// # Errors
/// [`CoverageError::NotPlane`].
pub fn choose_gap_width(map: &PlanarMap, options: &Options) -> Result<Option<ChosenWidth>, CoverageError> {
    map.plane()?;
    let mut ownership = Ownership::new(map, options.window);
    drop(overlaps(map, &mut ownership, options.winner, map.features().count()));
    let accepted = accepted_faces(map, &options.accepted_gaps);
    let width = |region: &Region<'_>| mean_width(region.area, region.length);
    let regions = ownership.regions();
    let mut next = median(regions.iter().filter(|region| region.owner.is_some()).map(width).collect());
    let is_accepted = |region: &&Region<'_>| region.faces.iter().any(|face| accepted.contains(&face.index()));
    let gaps = regions.iter().filter(|region| region.is_gap() && !is_accepted(region));
    let mut widths: Vec<f64> = gaps.map(width).filter(|width| *width < next).collect();
    widths.sort_by(f64::total_cmp);
    while let Some(width) = widths.pop() {
        if width * STEP <= next {
            return Ok(Some(ChosenWidth { width: rounded_up(width), gaps: widths.len() + 1, next }));
        }
        next = width;
    }
    Ok(None)
}

/// Rounds up to a number with two digits.
fn rounded_up(width: f64) -> f64 {
    let unit = 10_f64.powf(width.log10().floor() - 1.0);
    let with = |units: f64| format!("{:.1e}", units * unit).parse().ok().filter(|rounded| *rounded >= width);
    let units = (width / unit).ceil();
    with(units).or_else(|| with(units + 1.0)).unwrap_or(width)
}
