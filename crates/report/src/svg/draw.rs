//! The picture as a whole.

use super::fill::Fills;
use super::frame::Frame;
use super::layout::{Layout, SPACE};
use super::options::Options;
use super::text::put;
use super::{detail, lines, marks, names};
use twinedge_map::PlanarMap;

const STYLE: &str = "\
.sea,.free{fill:#f6f8fa}.hatch{fill:url(#hatch)}.gap{fill:url(#gap)}\
.tiny{fill:none;stroke:#7c3aed;stroke-width:1.2;stroke-dasharray:3 2}\
.edges{fill:none;stroke:#444;stroke-width:.6;stroke-linejoin:round;stroke-linecap:round}\
.point{fill:#222}.name{fill:#333;font-size:9px;text-anchor:middle}.leader{fill:none;stroke:#333;stroke-width:.5}\
.inset{fill:none;stroke:#94a3b8}.note{fill:#475569;font-size:9px}\
.detail .edges{stroke:#999;stroke-width:1.2}.detail .gap{fill:#f6f8fa}\
.half{fill:none;stroke:#1d4ed8;stroke-width:1}.next{fill:none;stroke:#64748b;stroke-width:.7;stroke-dasharray:2 1.5}\
.hname{fill:#1d4ed8;font-size:9px;text-anchor:middle;dominant-baseline:central}\
.vertex{fill:#fff;stroke:#111}.vname{fill:#111;font-size:10px;font-weight:bold;text-anchor:middle;dominant-baseline:central}\
.fname{fill:#57534e;font-size:12px;font-style:italic;text-anchor:middle;dominant-baseline:central}\
.bad{fill:none;stroke:#dc2626;stroke-width:1.6}.thin{stroke-width:.8}\
.rule{fill:#dc2626;font-size:11px;font-weight:bold}.legend{fill:#b91c1c;font-size:11px}\
.halo{stroke:#fff;stroke-width:3px;stroke-opacity:.85;stroke-linejoin:round}";

const DEFINITIONS: &str = "<defs>\
<pattern id=\"hatch\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">\
<path d=\"M0 0V5\" stroke=\"#111\" stroke-width=\"1.6\" stroke-opacity=\".6\"/></pattern>\n\
<pattern id=\"gap\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\"><path d=\"M0 0H6V6H0Z\" fill=\"#f6f8fa\"/>\
<circle cx=\"3\" cy=\"3\" r=\".9\" fill=\"#7c3aed\" fill-opacity=\".45\"/></pattern>\n\
<marker id=\"head\" orient=\"auto\" markerUnits=\"userSpaceOnUse\" markerWidth=\"8\" markerHeight=\"8\" refX=\"6\" refY=\"3\">\
<path d=\"M0 0L6 3L0 6L1.5 3Z\" fill=\"#1d4ed8\"/></marker>\n\
<marker id=\"tip\" orient=\"auto\" markerUnits=\"userSpaceOnUse\" markerWidth=\"6\" markerHeight=\"6\" refX=\"4\" refY=\"2\">\
<path d=\"M0 0L4 2L0 4Z\" fill=\"#64748b\"/></marker></defs>\n";

/// Draws a map, plane or not. O(n log n) time and O(n) text for a map of size n, and O(v² + m²) time for v violations, m names.
///
/// ```
/// use twinedge_map::{Builder, Shape};
/// use twinedge_report::svg::{self, Options};
///
/// let mut builder = Builder::new();
/// builder.shape(&Shape::polygon([[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]]))?;
/// let map = builder.build()?;
/// let picture = svg::draw(&map, &Options { detail: true, ..Options::default() });
/// assert!(picture.starts_with("<svg ") && picture.contains(">h5</text>"));
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[must_use]
pub fn draw(map: &PlanarMap, options: &Options<'_>) -> String {
    let Layout { main, insets, left_out } = Layout::new(map, options);
    let fills = Fills::of(map);
    let [main_width, main_height] = main.size;
    let inset_row = insets.first().map_or(0.0, |inset| inset.size[1] + SPACE);
    let insets_end: f64 = insets.iter().map(|inset| inset.size[0] + SPACE).sum();
    let width = main_width.max(if insets.is_empty() { 0.0 } else { SPACE + insets_end });
    let legend = main_height + inset_row;
    let height = legend + marks::legend_height(options.violations.len());
    let mut out = String::new();
    put(
        &mut out,
        format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
viewBox=\"0 0 {width:.0} {height:.0}\" font-family=\"Helvetica, Arial, sans-serif\">\n<style>{STYLE}</style>\n{DEFINITIONS}\
<rect class=\"sea\" width=\"100%\" height=\"100%\"/>\n"
        ),
    );
    put(&mut out, format_args!("<g class=\"{}\">\n", if options.detail { "detail" } else { "map" }));
    panel(&mut out, map, &main, [0.0, 0.0], &fills, options);
    let mut left = SPACE;
    for inset in &insets {
        let [width, height] = inset.size;
        panel(&mut out, map, inset, [left, main_height], &fills, options);
        let (x, y, times) = (left + 4.0, main_height + height - 4.0, inset.scale / main.scale);
        put(
            &mut out,
            format_args!(
                "<rect class=\"inset\" x=\"{left:.1}\" y=\"{main_height:.1}\" width=\"{width:.1}\" height=\"{height:.1}\"/>\n\
<text class=\"note\" x=\"{x:.1}\" y=\"{y:.1}\">{times:.2} × the scale</text>\n"
            ),
        );
        left += width + SPACE;
    }
    if left_out > 0 {
        let y = main_height - 4.0;
        put(
            &mut out,
            format_args!("<text class=\"note\" x=\"{SPACE}\" y=\"{y:.1}\">{left_out} more parts lie far away</text>\n"),
        );
    }
    marks::legend(&mut out, options.violations, [SPACE, legend], width);
    out.push_str("</g>\n</svg>\n");
    out
}

/// Draws a part of the map into a panel, clipped at its border.
fn panel(out: &mut String, map: &PlanarMap, frame: &Frame, [x, y]: [f64; 2], fills: &Fills, options: &Options<'_>) {
    let [width, height] = frame.size;
    put(out, format_args!("<svg x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\">\n"));
    fills.draw(out, map, frame);
    lines::draw(out, map, frame);
    if options.detail {
        detail::draw(out, map, frame);
    } else {
        names::draw(out, map, frame, &fills.outlines);
    }
    marks::draw(out, map, frame, options.violations);
    out.push_str("</svg>\n");
}
