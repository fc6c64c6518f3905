//! An audit as one object.

use super::{Finding, MeshAudit, MeshCounts, Unmet};
use serde::ser::{Serialize, SerializeStruct, Serializer};

impl Serialize for MeshAudit {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        struct Object<'a> {
            valid: bool,
            counts: &'a MeshCounts,
            unmet: &'a [Unmet],
            finding_count: usize,
            findings: &'a [Finding],
            rules: Vec<Rule>,
        }
        #[derive(serde::Serialize)]
        struct Rule {
            id: &'static str,
            violations: u64,
            checked: u64,
            unchecked: Option<String>,
        }
        let rules = self.report().outcomes().map(|(rule, outcome)| Rule {
            id: rule.id(),
            violations: outcome.violations,
            checked: outcome.checked,
            unchecked: outcome.unchecked.map(|why| why.to_string()),
        });
        Object {
            valid: self.is_valid(),
            counts: self.counts(),
            unmet: self.unmet(),
            finding_count: self.findings().total(),
            findings: self.findings().list(),
            rules: rules.collect(),
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

impl Serialize for Unmet {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_struct("Unmet", 2)?;
        object.serialize_field("name", self.name())?;
        object.serialize_field("message", &self.to_string())?;
        object.end()
    }
}
