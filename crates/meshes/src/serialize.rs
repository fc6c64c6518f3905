//! An audit as one object: a report in the form of the library, with findings and further counts.

use super::{Finding, MeshAudit};
use serde::ser::{Serialize, Serializer};
use twinedge_diagnosis::{Diagnosis, Document};

impl Serialize for MeshAudit {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let unexplained = |all: Vec<Diagnosis>| all.into_iter().map(Diagnosis::unexplained).collect::<Vec<_>>();
        let findings = unexplained(self.findings().list().iter().map(Diagnosis::from).collect());
        let violations = unexplained(self.report().violations().iter().map(Diagnosis::from).collect());
        Document::new(self.is_valid(), self.counts(), &self.rules())
            .findings(&findings, self.findings().total() as u64)
            .violations(&violations, self.report().violation_count())
            .serialize(serializer)
    }
}

impl Serialize for Finding {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Diagnosis::from(self).unexplained().serialize(serializer)
    }
}
