//! An audit as one object: a report in the form of the library, with findings and other counts.

use super::{Finding, MeshAudit, MeshCounts};
use serde::ser::{Serialize, SerializeStruct, Serializer};
use twinedge::validate::{Described, REPORT_SCHEMA, Rule, RuleOutcome};

impl Serialize for MeshAudit {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        struct Object<'a> {
            schema: &'static str,
            valid: bool,
            counts: &'a MeshCounts,
            finding_count: usize,
            findings: &'a [Finding],
            rules: Vec<Entry>,
            violation_count: u64,
            violations: Vec<Described<'a>>,
        }
        #[derive(serde::Serialize)]
        struct Entry {
            id: Rule,
            #[serde(flatten)]
            outcome: RuleOutcome,
        }
        Object {
            schema: REPORT_SCHEMA,
            valid: self.is_valid(),
            counts: self.counts(),
            finding_count: self.findings().total(),
            findings: self.findings().list(),
            rules: self.report().outcomes().map(|(id, outcome)| Entry { id, outcome }).collect(),
            violation_count: self.report().violation_count(),
            violations: self.report().violations().iter().map(Described).collect(),
        }
        .serialize(serializer)
    }
}

impl Serialize for Finding {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_struct("Finding", 4)?;
        object.serialize_field("kind", self.kind().name())?;
        object.serialize_field("faces", &self.faces())?;
        object.serialize_field("vertices", &self.vertices())?;
        object.serialize_field("message", &self.to_string())?;
        object.end()
    }
}
