//! The differences between two reports.

use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// The relative difference below which two measures are equal, since they are rounded.
const ROUNDING: f64 = 1e-9;

/// The findings of two reports, compared by id; each list is sorted.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Difference {
    /// Ids that only the second report has.
    pub new: Vec<String>,
    /// Ids that only the first report has.
    pub gone: Vec<String>,
    /// Ids with different measures.
    pub changed: Vec<String>,
    /// The number of unchanged findings.
    pub same: usize,
}

/// The reason why a report cannot be compared.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DifferenceError {
    /// The value is not a report, or its findings have no ids.
    #[error("no report of `twinedge audit --format json`: {0}")]
    NoReport(&'static str),
    /// The report does not list all findings.
    #[error("it lists {listed} of {found} findings; audit again with a greater --list")]
    NotAll {
        /// The number of listed findings.
        listed: u64,
        /// The number of all findings.
        found: u64,
    },
    /// The audit did not finish.
    #[error("its audit did not end")]
    Unfinished,
}

/// A parsed report: its findings by id.
#[derive(Clone, Debug)]
pub struct Compared(BTreeMap<String, Value>);

/// The keys of the coverage that count findings.
const COUNTS: [&str; 7] = ["overlaps", "gaps", "near_misses", "slivers", "duplicates", "ogc_invalid", "mismatches"];

impl Compared {
    /// Parses a report from JSON.
    ///
    /// # Errors
    /// [`DifferenceError`].
    pub fn new(report: &Value) -> Result<Self, DifferenceError> {
        use DifferenceError::NoReport;
        let counts = report.get("counts").ok_or(NoReport("it has no counts"))?;
        if counts.is_null() {
            return Err(DifferenceError::Unfinished);
        }
        let number = |value: &Value| value.as_u64().unwrap_or_default();
        let coverage = &report["coverage"];
        let of_coverage = COUNTS.iter().map(|count| number(&coverage[count])).sum::<u64>();
        let lists = [
            (&report["violations"], number(&report["violation_count"])),
            (&report["findings"], number(&report["finding_count"])),
            (&coverage["findings"], of_coverage),
        ];
        let mut all = BTreeMap::new();
        let (mut listed, mut found) = (0, 0);
        for (list, count) in lists {
            let list = list.as_array().map(Vec::as_slice).unwrap_or_default();
            listed += list.len() as u64;
            found += count;
            for one in list {
                let id = one["id"].as_str().ok_or(NoReport("a finding has no id"))?;
                all.insert(id.to_owned(), one.clone());
            }
        }
        if listed < found {
            return Err(DifferenceError::NotAll { listed, found });
        }
        Ok(Self(all))
    }

    /// Returns the JSON of a finding.
    #[must_use]
    pub fn get(&self, id: &str) -> Option<&Value> {
        self.0.get(id)
    }

    /// Compares this report with a newer one. O(n log n).
    ///
    /// ```
    /// use serde_json::json;
    /// use twinedge_report::Compared;
    ///
    /// let report = |findings: &[(&str, f64)]| {
    ///     let list: Vec<_> = findings.iter().map(|(id, area)| json!({"id": id, "area": area})).collect();
    ///     Compared::new(&json!({"counts": {}, "violation_count": list.len(), "violations": list}))
    /// };
    /// let (old, new) = (report(&[("a", 1.0), ("b", 1.0), ("c", 1.0)])?, report(&[("b", 1.0), ("c", 2.0), ("d", 1.0)])?);
    /// let found = old.difference(&new);
    /// assert_eq!((&found.new[..], &found.gone[..]), (&["d".to_owned()][..], &["a".to_owned()][..]));
    /// assert_eq!((&found.changed[..], found.same), (&["c".to_owned()][..], 1));
    /// # Ok::<(), twinedge_report::DifferenceError>(())
    /// ```
    #[must_use]
    pub fn difference(&self, newer: &Self) -> Difference {
        let mut found = Difference::default();
        for (id, one) in &newer.0 {
            match self.0.get(id) {
                None => found.new.push(id.clone()),
                Some(before) if is_same(before, one) => found.same += 1,
                Some(_) => found.changed.push(id.clone()),
            }
        }
        found.gone = self.0.keys().filter(|id| !newer.0.contains_key(*id)).cloned().collect();
        found
    }
}

fn is_same(before: &Value, after: &Value) -> bool {
    let measures = ["area", "width", "length"].iter().all(|key| match (before[key].as_f64(), after[key].as_f64()) {
        (Some(a), Some(b)) => (a - b).abs() <= ROUNDING * a.abs().max(b.abs()),
        (a, b) => a == b,
    });
    let count = |one: &Value, list: &str| one[list].as_array().map_or(0, Vec::len);
    measures && ["missing", "defects"].iter().all(|list| count(before, list) == count(after, list))
}
