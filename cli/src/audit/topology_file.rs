//! Auditing a topology of PostGIS, as `psql` wrote it.

use crate::input::Input;
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, counted, grouped, plain, print, print_json};
use crate::status::{Failure, Verdict};
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::time::Instant;
use twinedge_formats::postgis::{self, TopologyAudit, TopologyRule, TopologyViolation};

#[derive(Debug, Serialize)]
struct Json<'a> {
    input: &'a str,
    #[serde(flatten)]
    audit: &'a TopologyAudit,
    elapsed_ms: f64,
}

/// Reads the streams and prints what was found. At most `list` violations are listed.
pub(super) fn audit(
    Input { name, reader, .. }: Input,
    list: usize,
    explain: bool,
    output: Format,
) -> Result<Verdict, Failure> {
    let start = Instant::now();
    let failed = |error| Failure(format!("{name}: {error}"));
    let topology = postgis::read(reader, list).map_err(failed)?;
    let audit = postgis::audit(&topology, list).map_err(failed)?;
    let elapsed_ms = start.elapsed().as_secs_f64() * 1000.0;
    match output {
        Format::Text => print(&text(&name, &audit, explain, elapsed_ms)?)?,
        Format::Json => {
            let json = Json { input: &name, audit: &audit, elapsed_ms };
            if explain { print_json(&explained(&json)?)? } else { print_json(&json)? }
        }
    }
    Ok(if audit.is_valid() { Verdict::Sound } else { Verdict::Wrong })
}

/// The same, with the usual cause and the remedy of each violation.
fn explained(json: &Json<'_>) -> Result<serde_json::Value, Failure> {
    let mut value = serde_json::to_value(json)?;
    let listed = value["violations"].as_array_mut().into_iter().flatten();
    for (object, violation) in listed.zip(json.audit.violations()) {
        object["cause"] = violation.cause.into();
        object["remedy"] = violation.remedy.into();
    }
    Ok(value)
}

fn text(name: &str, audit: &TopologyAudit, explain: bool, elapsed_ms: f64) -> Result<String, std::fmt::Error> {
    let mut out = String::new();
    let counts = audit.counts();
    writeln!(out, "{name}\n{QUIET}a topology of PostGIS; records have the ids of the database{QUIET:#}\n")?;
    for (what, count) in [
        ("nodes (V)", grouped(counts.nodes)),
        ("edges (E)", grouped(counts.edges)),
        ("faces (F), face 0 included", grouped(counts.faces)),
        ("components (C)", counts.components.map_or_else(|| "unknown".to_owned(), grouped)),
        ("isolated nodes", grouped(counts.isolated_nodes)),
        ("bends", grouped(counts.bends)),
        ("repeated points, which are legal", grouped(counts.repeated_points)),
    ] {
        writeln!(out, "  {what:38} {count:>12}")?;
    }
    out.push('\n');
    for TopologyRule { id, name, checked, unit, violations, unchecked } in audit.rules() {
        let checked = grouped(*checked);
        write!(out, "  {id:2}  {name:10} ")?;
        match (violations, unchecked) {
            (0, None) => writeln!(out, "{GOOD}ok{GOOD:#}      {checked} {unit}")?,
            (0, Some(why)) => writeln!(out, "{QUIET}not checked: {why}{QUIET:#}")?,
            (n, why) => {
                let why = why.as_ref().map_or_else(String::new, |why| format!("; not checked {why}"));
                writeln!(out, "{BAD}BROKEN{BAD:#}  {} in {checked} {unit}{why}", counted(*n as usize, "violation"))?;
            }
        }
    }
    out.push('\n');
    for TopologyViolation { rule, message, at, .. } in audit.violations() {
        writeln!(out, "{BAD}{rule}{BAD:#} {}", plain(message))?;
        let at: Vec<_> = at.iter().map(|[x, y]| format!("({x}, {y})")).collect();
        if !at.is_empty() {
            writeln!(out, "   at {}", at.join(" "))?;
        }
    }
    let more = audit.violation_count().saturating_sub(audit.violations().len() as u64);
    if more > 0 {
        writeln!(out, "… and {} more; see --list", grouped(more))?;
    }
    if explain {
        let explained = audit.violations().iter().map(|one| (one.rule, one.cause, one.remedy));
        for (rule, cause, remedy) in explained.collect::<BTreeSet<_>>() {
            writeln!(out, "{rule}: usual cause: {cause}; remedy: {remedy}")?;
        }
    }
    if audit.is_valid() {
        writeln!(out, "{GOOD}valid{GOOD:#}: every rule that applies holds ({elapsed_ms:.0} ms)")?;
    } else {
        let count = counted(audit.violation_count() as usize, "violation");
        writeln!(out, "{BAD}not valid{BAD:#}: {count} ({elapsed_ms:.0} ms)")?;
    }
    Ok(out)
}
