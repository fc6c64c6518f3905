//! The audit of the three tables of a textbook.

use crate::error::Error;
use crate::input::Input;
use crate::options::Options;
use crate::packed::{Beside, Map, Names, Picture};
use crate::report::{AuditReport, JsonForm, Note, counts};
use crate::textbook::Textbook;
use crate::trace::placed;
use serde_json::json;
use std::io::Read;
use twinedge::validate::{Collect, Counts, Expectation, Record, View, Violation, validate};
use twinedge_diagnosis::{Diagnosis, Records, RuleLine};
use twinedge_map::validate_embedding;

/// Returns true if a file with this beginning has the three tables of a textbook: its first word outside comments is a heading, or the name of a
/// vertex, a half-edge or a face.
pub(crate) fn is_textbook(beginning: &[u8]) -> bool {
    let text = String::from_utf8_lossy(beginning);
    let mut lines = text.lines().map(|line| line.split('#').next().unwrap_or_default());
    let word = lines.find_map(|line| line.split([' ', '\t', '|']).find(|word| !word.is_empty()));
    let word = word.unwrap_or_default().to_lowercase();
    let is_name = |letter| {
        let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        word.strip_prefix(letter).is_some_and(|rest| rest.splitn(2, ',').all(digits))
    };
    ["vertex", "face", "half-edge", "halfedge"].contains(&word.as_str()) || ['v', 'e', 'f'].into_iter().any(is_name)
}

pub(crate) fn audit(Input { name, mut reader, .. }: Input, asked: &Options) -> Result<(AuditReport, Textbook), Error> {
    let mut text = String::new();
    reader.read_to_string(&mut text)?;
    let tables: Textbook = text.parse()?;
    let (expectation, collect) = (Expectation::plane(), Collect::AtMost(asked.most()));
    let report = if tables.has_coordinates() {
        validate_embedding(&tables, &expectation, collect)
    } else {
        validate(&tables, &expectation, collect)
    };
    let no_places = "the tables have no coordinates, so there is nothing to draw and G1 to G5 are not checked";
    let notes = [Some("the three tables of a textbook"), (!tables.has_coordinates()).then_some(no_places)];
    let Counts { vertices, edges, half_edges, faces, components, .. } = *report.counts();
    let json = json!({
        "vertices": vertices, "edges": edges, "half_edges": half_edges, "faces": faces, "components": components,
    });
    let report = AuditReport {
        valid: report.is_valid(),
        notes: notes.into_iter().flatten().map(|note| Note::Plain(note.to_owned())).collect(),
        counts: counts(report.counts()),
        rules: RuleLine::of(&report),
        violations: report.violations().iter().map(|violation| diagnosis(&tables, violation)).collect(),
        violation_count: report.violation_count(),
        json: JsonForm { counts: json, is_named: true, ..JsonForm::default() },
        ..AuditReport::new(&name)
    };
    Ok((report, tables))
}

fn diagnosis(tables: &Textbook, violation: &Violation) -> Diagnosis {
    let places = tables.has_coordinates().then(|| placed(tables, violation));
    let records: Vec<Record> = violation.records().into_iter().flatten().collect();
    let name = |record: &Record| tables.name(*record).map_or_else(|| record.to_string(), str::to_owned);
    Diagnosis {
        message: with_names(&violation.message(), tables),
        records: Records::Both { names: records.iter().map(name).collect(), records },
        ..places.unwrap_or_else(|| violation.into())
    }
}

pub(crate) fn picture(tables: &Textbook, report: &AuditReport) -> Picture {
    let name = |record: Record| tables.name(record).unwrap_or_default().to_owned();
    let half_edges = 0..tables.half_edge_slots();
    let mutual = |h: &usize| tables.twin(*h).filter(|t| half_edges.contains(t) && tables.twin(*t) == Some(*h));
    let names = Names::Own {
        vertices: (0..tables.vertex_slots()).map(|v| name(Record::Vertex(v))).collect(),
        half_edges: half_edges.clone().map(|h| name(Record::HalfEdge(h))).collect(),
        faces: (0..tables.face_slots()).map(|f| name(Record::Face(f))).collect(),
        twins: half_edges.clone().map(|h| mutual(&h)).collect(),
    };
    let map = Map::pack(tables, Beside { features: &|_| Vec::new(), names, windows: &report.windows() });
    Picture { map, ..Picture::default() }
}

type ToRecord = fn(usize) -> Record;

/// Words before the index of a record in messages of the validator, possibly of two indices joined by `and`.
const BEFORE_INDEX: [(&str, ToRecord); 12] = [
    ("half-edge ", Record::HalfEdge),
    ("half-edges ", Record::HalfEdge),
    ("twin ", Record::HalfEdge),
    ("twin is ", Record::HalfEdge),
    ("next ", Record::HalfEdge),
    ("next is ", Record::HalfEdge),
    ("prev ", Record::HalfEdge),
    ("prev is ", Record::HalfEdge),
    ("vertex ", Record::Vertex),
    ("face ", Record::Face),
    ("faces ", Record::Face),
    ("bounds ", Record::Face),
];

fn with_names(message: &str, tables: &Textbook) -> String {
    let mut out = String::new();
    // The meaning of the word before the last one, after an index.
    let mut kind: Option<ToRecord> = None;
    for (i, word) in message.split(' ').enumerate() {
        let digits = word.bytes().take_while(u8::is_ascii_digit).count();
        let (number, after) = word.split_at(digits);
        let before = BEFORE_INDEX.iter().find(|(words, _)| {
            out.strip_suffix(words.trim_end()).is_some_and(|rest| rest.is_empty() || rest.ends_with([' ', '(']))
        });
        let record = before.map(|(_, record)| *record).or(kind.filter(|_| out.ends_with(" and")));
        let named = record.zip(number.parse().ok()).and_then(|(record, index)| tables.name(record(index)));
        if i > 0 {
            out.push(' ');
        }
        out.push_str(named.unwrap_or(number));
        out.push_str(after);
        kind = record.filter(|_| named.is_some()).or(kind.filter(|_| word == "and"));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{is_textbook, with_names};
    use crate::textbook::Textbook;

    #[test]
    fn tables_are_told_from_other_files() {
        for text in ["v1 e1,1", "# a\n\n| Vertex | IncidentEdge |", "e1,2 v1", "F3 nil", "Half-edge Origin"] {
            assert!(is_textbook(text.as_bytes()), "{text}");
        }
        for text in ["", "{}", "V 1 - 0 H 0 B 0 F 0", "POINT (1 2)", "vertices", "e", "v1x"] {
            assert!(!is_textbook(text.as_bytes()), "{text}");
        }
    }

    #[test]
    fn messages_have_the_names_of_the_tables() {
        let tables: Textbook = "V7 e3,1\nf9 nil e3,1\ne3,1 V7 e3,1 f9 e3,1 e3,1".parse().unwrap();
        for (message, expected) in [
            ("half-edge 0: vertex 0 is not vertex 12, face 0", "half-edge e3,1: vertex V7 is not vertex 12, face f9"),
            ("half-edge 0 has twin 0, whose twin is 0: both", "half-edge e3,1 has twin e3,1, whose twin is e3,1: both"),
            ("faces 0 and 0 both have 0 edges", "faces f9 and f9 both have 0 edges"),
            ("3 − 0 + 0 half-edges in 0 faces", "3 − 0 + 0 half-edges in 0 faces"),
        ] {
            assert_eq!(with_names(message, &tables), expected);
        }
    }
}
