//! An audit as one object.

use super::{Finding, MeshAudit, MeshCounts};
use serde::ser::{Serialize, SerializeStruct, Serializer};

impl Serialize for MeshAudit {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        struct Object<'a> {
            valid: bool,
            counts: &'a MeshCounts,
            finding_count: usize,
            findings: &'a [Finding],
            rules: Vec<Rule>,
            violations: Vec<Violation>,
        }
        #[derive(serde::Serialize)]
        struct Rule {
            id: &'static str,
            violations: u64,
            checked: u64,
            unchecked: Option<String>,
        }
        #[derive(serde::Serialize)]
        struct Violation {
            rule: &'static str,
            message: String,
        }
        let rules = self.report().outcomes().map(|(rule, outcome)| Rule {
            id: rule.id(),
            violations: outcome.violations,
            checked: outcome.checked,
            unchecked: outcome.unchecked.map(|why| why.to_string()),
        });
        let violations = self
            .report()
            .violations()
            .iter()
            .map(|violation| Violation { rule: violation.rule().id(), message: violation.to_string() });
        Object {
            valid: self.is_valid(),
            counts: self.counts(),
            finding_count: self.findings().total(),
            findings: self.findings().list(),
            rules: rules.collect(),
            violations: violations.collect(),
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
