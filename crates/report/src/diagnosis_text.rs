//! Diagnoses as text for people.

use crate::words::style::{BAD, GOOD, QUIET};
use crate::words::{counted, decimals_of, grouped, measure, place, plain};
use std::collections::HashSet;
use std::fmt::{Result, Write as _};
use twinedge_diagnosis::{Diagnosis, FeatureName, Measures, Position, Records, RuleLine};

/// Writes a finding and its place. Coordinates of a coverage have at most `decimals` decimal places.
///
/// # Errors
/// Never: writing to a string does not fail.
pub fn write(out: &mut String, one: &Diagnosis, decimals: usize) -> Result {
    let rule = one.rule.unwrap_or(one.kind.name());
    if let (Records::None {}, Some(at)) = (&one.records, one.look) {
        let labels: Vec<&str> = one.features.iter().flatten().map(|feature| &*feature.label).collect();
        let (few, more) = labels.split_at(labels.len().min(4));
        let more = if more.is_empty() { String::new() } else { format!(" and {} more", more.len()) };
        let who = if few.is_empty() { String::new() } else { format!(": {}{more}", few.join(", ")) };
        return writeln!(
            out,
            "{rule} {}{who}; {}; at {}{}",
            one.kind.name(),
            one.message,
            place(at, decimals.max(decimals_of(one.measures.width))),
            by_snapping(one)
        );
    }
    if let Some(line) = one.line {
        write!(out, "{QUIET}line {line}{QUIET:#}  ")?;
    }
    match &one.sentence {
        Some(sentence) => writeln!(out, "{BAD}{rule}{BAD:#} {sentence}\n   {QUIET}{}{QUIET:#}", plain(&one.message))?,
        None => writeln!(out, "{BAD}{rule}{BAD:#} {}", plain(&one.message))?,
    }
    let at: Vec<_> = one.places.iter().flatten().map(|[x, y]| format!("({x}, {y})")).collect();
    if !at.is_empty() {
        writeln!(out, "   at {}", at.join(" "))?;
    }
    let features: Vec<String> = one.features.iter().flatten().map(FeatureName::title).collect();
    if !features.is_empty() && one.sentence.is_none() {
        writeln!(out, "   on the border of {}", features.join(", "))?;
    }
    if let Some(sql) = &one.sql {
        writeln!(out, "   {QUIET}rows: {QUIET:#}{}", sql.show)?;
        sql.mend.iter().try_for_each(|mend| writeln!(out, "   {QUIET}mend: {QUIET:#}{mend}"))?;
    }
    Ok(())
}

/// Returns the words for a finding that snapping removed or created.
pub(crate) fn by_snapping(one: &Diagnosis) -> String {
    one.snapping.map_or_else(String::new, |what| format!(" ({what} by snapping)"))
}

/// Returns the message, including the effect of snapping.
pub(crate) fn message(one: &Diagnosis) -> String {
    format!("{}{}", one.message, by_snapping(one))
}

/// Returns the message, in terms of features if there are any, with the id of the finding's cause.
pub(crate) fn full_message(one: &Diagnosis) -> String {
    let source = one.follows_from_id.as_deref().or(one.follows_from);
    let follows = source.map_or_else(String::new, |source| format!(", which follows from {source}"));
    format!("{}{follows}{}", one.sentence.as_deref().unwrap_or(&one.message), by_snapping(one))
}

/// The size of a finding of a coverage, in words.
pub(crate) fn size(Measures { area, width, length }: Measures) -> Option<String> {
    let [area, width, length] = [area?, width?, length?].map(measure);
    Some(format!("area {area}, width {width}, borders of {length}"))
}

/// Writes the number of findings that are not listed.
pub(crate) fn write_more(out: &mut String, total: u64, listed: usize) -> Result {
    match total.saturating_sub(listed as u64) {
        0 => Ok(()),
        more => writeln!(out, "… and {} more; see --list", grouped(more)),
    }
}

pub(crate) fn write_explanations<'a>(out: &mut String, all: impl IntoIterator<Item = &'a Diagnosis>) -> Result {
    let mut told = HashSet::new();
    for one in all {
        let rule = one.rule.unwrap_or(one.kind.name());
        if let (Some(cause), Some(remedy)) = (one.cause, one.remedy)
            && told.insert((rule, cause, remedy))
        {
            writeln!(out, "{rule}: usual cause: {cause}; remedy: {remedy}")?;
        }
    }
    Ok(())
}

pub(crate) fn write_rule(out: &mut String, rule: &RuleLine) -> Result {
    write!(out, "  {:2}  {:10} ", rule.id, rule.name)?;
    let checked = format!("{} {}", grouped(rule.checked), rule.unit);
    match (rule.violations, rule.not_checked()) {
        (0, None) => writeln!(out, "{GOOD}ok{GOOD:#}      {checked}"),
        (0, Some(why)) if rule.is_in_part() => writeln!(out, "{GOOD}ok{GOOD:#}      {checked}; {why}"),
        (0, Some(why)) => writeln!(out, "{QUIET}{why}{QUIET:#}"),
        (n, why) => {
            let why = why.map_or_else(String::new, |why| format!("; {why}"));
            writeln!(out, "{BAD}BROKEN{BAD:#}  {} in {checked}{why}", counted(n as usize, "violation"))
        }
    }
}

/// The number of features named.
const NAMED: usize = 3;

/// Returns the sentence; `None` for other violations, and if no feature is known. Coordinates have at most `decimals` decimal places.
pub(crate) fn sentence(one: &Diagnosis, decimals: usize) -> Option<String> {
    let features = one.features.as_deref().filter(|features| !features.is_empty())?;
    let at = place(one.look?, decimals);
    let (alone, together, where_) = match one.kind.name() {
        "cross" | "segments_cross" => ("crosses itself", "cross", format!("at {at}")),
        "overlap" | "segments_overlap" => {
            let [from, to] = common(one.places.as_deref()?)?.map(|end| place(end, decimals));
            ("overlaps itself", "overlap", format!("from {from} to {to}"))
        }
        "touch" | "vertex_in_segment" | "bend_in_segment" => {
            ("touches itself", "touch", format!("at {at}, where only one has a vertex"))
        }
        _ => return None,
    };
    let names: Vec<String> = features.iter().map(FeatureName::title).collect();
    Some(match &names[..] {
        [name] => format!("the border of {name} {alone} {where_}"),
        _ => format!("the borders of {} {together} {where_}", listed(&names)),
    })
}

/// Joins names with commas and `and`.
fn listed(names: &[String]) -> String {
    let (named, more) = names.split_at(names.len().min(NAMED));
    match (named, more.len()) {
        ([all @ .., last], 0) => format!("{} and {last}", all.join(", ")),
        (_, more) => format!("{} and {more} more", named.join(", ")),
    }
}

/// Returns the ends of the common part of two segments on one line, given their four ends.
pub(crate) fn common(ends: &[Position]) -> Option<[Position; 2]> {
    let mut ends: [Position; 4] = ends.try_into().ok()?;
    let span = |axis: usize| ends.iter().map(|p| (p[axis] - ends[0][axis]).abs()).fold(0.0, f64::max);
    let axis = usize::from(span(1) > span(0));
    ends.sort_by(|a, b| a[axis].total_cmp(&b[axis]));
    Some([ends[1], ends[2]])
}
