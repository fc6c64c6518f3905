//! Numbers, text and JSON as the commands print them.

use clap::{ColorChoice, ValueEnum};
use serde_json::Value;
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use twinedge_trials::Shard;

/// The output format.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Text, coloured on a terminal.
    #[default]
    Text,
    /// One JSON object.
    Json,
}

/// True if no report is to be printed.
static IS_QUIET: AtomicBool = AtomicBool::new(false);

/// Turns reports off, or on.
pub(crate) fn set_quiet(quiet: bool) {
    IS_QUIET.store(quiet, Ordering::Relaxed);
}

/// Turns colours on or off.
pub(crate) fn set_color(choice: ColorChoice) {
    match choice {
        ColorChoice::Auto => anstream::ColorChoice::Auto,
        ColorChoice::Always => anstream::ColorChoice::Always,
        ColorChoice::Never => anstream::ColorChoice::Never,
    }
    .write_global();
}

/// A number with its thousands set off.
pub(crate) fn grouped(n: impl TryInto<u64>) -> String {
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

/// A number of things, with their name in the singular or in the plural.
pub(crate) fn counted(n: usize, name: &str) -> String {
    let plural = match name.strip_suffix("ex") {
        _ if n == 1 => name.to_owned(),
        Some(stem) => format!("{stem}ices"),
        None => format!("{name}s"),
    };
    format!("{} {plural}", grouped(n))
}

/// The number of rules that were not checked, to be added to a verdict; nothing if all were.
pub(crate) fn not_checked(rules: usize) -> String {
    if rules == 0 { String::new() } else { format!("; {} not checked", counted(rules, "rule")) }
}

/// A number that should be 0, marked if it is not.
pub(crate) fn zero(found: u64) -> String {
    use style::BAD;
    if found == 0 { "0".to_owned() } else { format!("{BAD}{}{BAD:#}", grouped(found)) }
}

/// A line that says which part of the work was done; none if it was all of it.
pub(crate) fn part_line(shard: Shard) -> String {
    if shard.is_whole() {
        return String::new();
    }
    format!("Part {shard}, counted from 0; `twinedge sum` adds up the JSON output of all parts\n\n")
}

/// A measure with four decimal places, or with four digits where these would show none.
pub(crate) fn measure(x: f64) -> String {
    if x != 0.0 && !(1e-3..1e12).contains(&x.abs()) { format!("{x:.3e}") } else { format!("{x:.4}") }
}

/// The number of decimal places of a place on a map in text: to a ten-millionth of the greatest coordinate.
pub(crate) fn decimals(greatest: f64) -> usize {
    let before = if greatest > 0.0 && greatest.is_finite() { greatest.log10().ceil() } else { 0.0 };
    (0_u8..15).take_while(|places| f64::from(*places) < 7.0 - before).count()
}

/// A place in text, with so many decimal places at most.
pub(crate) fn place([x, y]: [f64; 2], decimals: usize) -> String {
    let [x, y] = [x, y].map(|x| {
        let text = format!("{x:.decimals$}");
        let short = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        if short == "-0" { "0".to_owned() } else { short.to_owned() }
    });
    format!("({x}, {y})")
}

/// A text from a map or the command line as it may stand on a terminal: without control characters, which could break lines
/// or pass for commands to it.
pub(crate) fn plain(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect()
}

/// Prints to standard output. That nobody reads on (`… | head`) is no error.
pub(crate) fn print_answer(text: &str) -> Result<(), crate::status::Failure> {
    let mut out = anstream::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

/// Prints a report, unless none is wanted.
pub(crate) fn print(text: &str) -> Result<(), crate::status::Failure> {
    if IS_QUIET.load(Ordering::Relaxed) { Ok(()) } else { print_answer(text) }
}

/// A value as indented JSON, in which 0 has no sign.
pub(crate) fn json(value: &impl serde::Serialize) -> serde_json::Result<Vec<u8>> {
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

/// Prints one JSON object. That nobody reads on is no error.
pub(crate) fn print_json(value: &impl serde::Serialize) -> Result<(), crate::status::Failure> {
    print_bytes(&json(value)?)
}

/// Prints bytes as they are. That nobody reads on is no error.
pub(crate) fn print_bytes(bytes: &[u8]) -> Result<(), crate::status::Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

/// The colours of results; off where the output is no terminal.
pub(crate) mod style {
    use anstyle::{AnsiColor, Style};

    pub(crate) const GOOD: Style = AnsiColor::Green.on_default().bold();
    pub(crate) const BAD: Style = AnsiColor::Red.on_default().bold();
    pub(crate) const QUIET: Style = AnsiColor::BrightBlack.on_default();
}

#[cfg(test)]
mod tests {
    use super::{counted, decimals, grouped, json, measure, place, plain};

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
    }

    #[test]
    fn measures_show_digits() {
        assert_eq!(measure(2.5), "2.5000");
        assert_eq!(measure(0.0), "0.0000");
        assert_eq!(measure(-0.000_012_34), "-1.234e-5");
        assert_eq!(measure(1.5e300), "1.500e300");
    }
}
