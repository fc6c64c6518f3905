//! Numbers, names, tiles and the summary of noding in text for people, and JSON output.

use serde_json::Value;
use std::fmt::Write as _;
use twinedge_coverage::tile::Tile;
use twinedge_geometry::noding::NodingSummary;

/// Formats a number with grouped thousands.
#[must_use]
pub fn grouped(n: impl TryInto<u64>) -> String {
    let digits = n.try_into().unwrap_or_default().to_string();
    let mut out = String::with_capacity(digits.len() * 4 / 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

/// Formats a count with its noun, singular or plural.
#[must_use]
pub fn counted(n: usize, name: &str) -> String {
    let plural = match name.strip_suffix("ex") {
        _ if n == 1 => name.to_owned(),
        Some(stem) => format!("{stem}ices"),
        None => format!("{name}s"),
    };
    format!("{} {plural}", grouped(n))
}

/// A suffix for a verdict with the number of unchecked rules; empty if all were checked.
pub(crate) fn not_checked(rules: usize) -> String {
    if rules == 0 { String::new() } else { format!("; {} not checked", counted(rules, "rule")) }
}

/// Formats a measure with four decimal places, or with four significant digits if these would show nothing.
#[must_use]
pub fn measure(x: f64) -> String {
    if x != 0.0 && !(1e-3..1e12).contains(&x.abs()) { format!("{x:.3e}") } else { format!("{x:.4}") }
}

/// Returns the number of decimal places for coordinates on a map: a ten-millionth of the greatest coordinate.
#[must_use]
pub fn decimals(greatest: f64) -> usize {
    let before = if greatest > 0.0 && greatest.is_finite() { greatest.log10().ceil() } else { 0.0 };
    (0_u8..15).take_while(|places| f64::from(*places) < 7.0 - before).count()
}

/// Returns the number of decimal places at which a point stays inside something of this width.
#[must_use]
pub fn decimals_of(width: Option<f64>) -> usize {
    let width = width.filter(|width| *width > 0.0).unwrap_or(f64::INFINITY);
    (0..17).take_while(|places| 10_f64.powi(-places) > width / 100.0).count()
}

/// Formats a place with at most `decimals` decimal places.
#[must_use]
pub fn place([x, y]: [f64; 2], decimals: usize) -> String {
    let [x, y] = [x, y].map(|x| {
        // Shows no more digits than the number has.
        let [rounded, own] = [format!("{x:.decimals$}"), x.to_string()];
        let text = if own.len() < rounded.len() { own } else { rounded };
        let short = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        if short == "-0" { "0".to_owned() } else { short.to_owned() }
    });
    format!("({x}, {y})")
}

/// Removes control characters from a text of a map or the command line, because they could break lines or act as commands to a terminal.
#[must_use]
pub fn plain(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect()
}

/// Escapes text for an element or an attribute of XML 1.0.
pub(crate) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' => out.push_str("&#10;"),
            // XML cannot represent the others.
            c if (c < ' ' && c != '\t') || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

/// Formats a value as indented JSON in which 0 has no sign.
///
/// # Errors
/// Returns the value's error, if it cannot be serialized.
pub fn json(value: &impl serde::Serialize) -> serde_json::Result<Vec<u8>> {
    let mut value = serde_json::to_value(value)?;
    drop_signs_of_zero(&mut value);
    let mut out = serde_json::to_vec_pretty(&value)?;
    out.push(b'\n');
    Ok(out)
}

fn drop_signs_of_zero(value: &mut Value) {
    match value {
        Value::Number(number) if number.as_f64() == Some(0.0) && number.is_f64() => *value = 0.0.into(),
        Value::Array(items) => items.iter_mut().for_each(drop_signs_of_zero),
        Value::Object(members) => members.values_mut().for_each(drop_signs_of_zero),
        _ => {}
    }
}

/// The colours of results; off if the output is not a terminal.
pub mod style {
    use anstyle::{AnsiColor, Style};

    /// For valid results.
    pub const GOOD: Style = AnsiColor::Green.on_default().bold();
    /// For invalid results.
    pub const BAD: Style = AnsiColor::Red.on_default().bold();
    /// For a valid structure with other findings.
    pub const DOUBTFUL: Style = AnsiColor::Yellow.on_default().bold();
    /// For secondary text.
    pub const QUIET: Style = AnsiColor::BrightBlack.on_default();
}

/// The number of tiles named in a message.
pub(crate) const NAMED: usize = 10;

/// Names the first tiles, and counts the rest of `count`.
pub(crate) fn in_words(tiles: &[Tile], count: u64) -> String {
    let named = tiles.iter().take(NAMED).map(Tile::to_string);
    let mut named: Vec<String> = named.collect();
    let more = count.saturating_sub(named.len() as u64);
    named.extend((more > 0).then(|| format!("{} more", grouped(more))));
    let last = named.pop().unwrap_or_default();
    if named.is_empty() { last } else { format!("{} and {last}", named.join(", ")) }
}

pub(crate) fn of_tiles(tiles: &[Tile]) -> String {
    format!("tile{} {}", if tiles.len() == 1 { "" } else { "s" }, in_words(tiles, tiles.len() as u64))
}

/// A sentence about tiles made without cuts.
pub(crate) fn made_without(tiles: &[Tile]) -> String {
    format!("{} {} made without cuts", of_tiles(tiles), if tiles.len() == 1 { "was" } else { "were" })
}

/// Returns the summary of noding in one line.
#[must_use]
pub(crate) fn noding_line(noding: &NodingSummary) -> String {
    let cut = counted(noding.split, "segment");
    let exponent = noding.cell.log2();
    let cell = if exponent.fract() == 0.0 { format!("2^{exponent}") } else { noding.cell.to_string() };
    let mut line = format!("snapped to a grid of {cell}: {cut} cut");
    for (count, name, what) in [
        (noding.crossings, "vertex", "made at crossings"),
        (noding.merged, "point", "merged with others"),
        (noding.collapsed, "segment", "collapsed"),
        (noding.duplicates, "segment", "repeated"),
    ] {
        if count > 0 {
            let _ = write!(line, ", {} {what}", counted(count, name));
        }
    }
    let [x, y] = noding.largest_move;
    let _ = write!(line, "; points moved by at most {x:.2e} in x and {y:.2e} in y");
    line
}

#[cfg(test)]
mod tests {
    use super::{counted, decimals, decimals_of, grouped, json, measure, place, plain};

    #[test]
    fn json_has_no_zero_with_a_sign() {
        let value = serde_json::json!({ "at": [-0.0, [-1.5]], "none": {} });
        let mut usual = serde_json::to_string_pretty(&value).unwrap().replace("-0.0", "0.0");
        usual.push('\n');
        assert_eq!(String::from_utf8(json(&value).unwrap()).unwrap(), usual);
    }

    #[test]
    fn numbers_agree_with_their_nouns() {
        assert_eq!(counted(1, "map"), "1 map");
        assert_eq!(counted(0, "violation"), "0 violations");
        assert_eq!(counted(1_200, "vertex"), "1,200 vertices");
    }

    #[test]
    fn thousands_are_set_off() {
        assert_eq!(grouped(0_u64), "0");
        assert_eq!(grouped(999_usize), "999");
        assert_eq!(grouped(1_000_u32), "1,000");
        assert_eq!(grouped(1_876_446_u64), "1,876,446");
    }

    #[test]
    fn control_characters_are_replaced() {
        assert_eq!(plain("C\u{f4}te d'Ivoire"), "C\u{f4}te d'Ivoire");
        assert_eq!(plain("a\x1b[31mb\nc\u{9b}d"), "a\u{fffd}[31mb\u{fffd}c\u{fffd}d");
    }

    #[test]
    fn places_are_as_exact_as_the_map() {
        assert_eq!(place([54_575.620_276_214_504, 31_614.149_999_999_965], decimals(98_064.0)), "(54575.62, 31614.15)");
        assert_eq!(place([7.5, -1e-12], decimals(180.0)), "(7.5, 0)");
        assert_eq!(place([1e9, 100.0], decimals(1e9)), "(1000000000, 100)");
        assert_eq!(decimals(0.0), 7);
        assert_eq!(place([4.52, 0.1], decimals_of(Some(2e-16))), "(4.52, 0.1)");
        assert_eq!([None, Some(2.5), Some(0.003), Some(1e300)].map(decimals_of), [0, 2, 5, 0]);
    }

    #[test]
    fn measures_show_digits() {
        assert_eq!(measure(2.5), "2.5000");
        assert_eq!(measure(0.0), "0.0000");
        assert_eq!(measure(-0.000_012_34), "-1.234e-5");
        assert_eq!(measure(1.5e300), "1.500e300");
    }
}
