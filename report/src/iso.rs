//! The measures of ISO 19157 used in quality metadata.
//!
//! Sources: ISO 19157:2013, annex D, for the measures and their counts; ISO/TS 19139:2007, `gmd/dataQuality.xsd`, for the XML. ISO 19157 has no
//! measure for gaps (C2), for features that cover the same place, whatever their attributes (C5), or for the rules between layers.

use crate::coverage_words::statement;
use crate::iso_measure::{FAULTY_CONNECTION, OVERLAP, SELF_INTERSECT, SLIVER, UNDERSHOOT, measure_of};
use crate::report::AuditReport;
use crate::words::escaped;
use serde::Serialize;
use std::fmt::Write as _;
use twinedge_coverage::CoverageRule;

#[derive(Debug, Serialize)]
pub(crate) struct Quality<'a> {
    standard: &'static str,
    input: &'a str,
    version: &'static str,
    measures: Vec<Measure>,
    without_measure: Vec<Unmeasured>,
}

#[derive(Debug, Serialize)]
struct Measure {
    id: u32,
    name: &'static str,
    element: &'static str,
    rule: &'static str,
    /// `None` means that the rule was not checked.
    value: Option<usize>,
    parameters: Vec<Parameter>,
    /// The basis of the count, in words.
    #[serde(skip)]
    counted: String,
}

#[derive(Debug, Serialize)]
struct Parameter {
    name: &'static str,
    value: f64,
}

#[derive(Debug, Serialize)]
struct Unmeasured {
    rule: &'static str,
    name: &'static str,
    findings: Option<usize>,
}

const TOPOLOGICAL: &str = "DQ_TopologicalConsistency";
const CONCEPTUAL: &str = "DQ_ConceptualConsistency";

impl<'a> Quality<'a> {
    /// Counts the unaccepted findings; every finding must be listed. Returns `None` if the input is not a map.
    pub(crate) fn of(report: &'a AuditReport) -> Option<Self> {
        let coverage = report.coverage.as_ref()?;
        let open = |rule: CoverageRule| {
            let all = coverage.findings().iter().filter(move |one| one.rule == Some(rule.id()));
            all.filter(|one| one.accepted.is_none())
        };
        let measure = |id, name, element, rule: CoverageRule, value, parameters, counted: &str| Measure {
            id,
            name,
            element,
            rule: rule.id(),
            value,
            parameters,
            counted: format!("{counted}; {}: {}", rule.id(), statement(rule)),
        };
        let is_checked = |rule| coverage.why_not(rule).is_none();
        let count = |rule| is_checked(rule).then(|| open(rule).count());
        let parameter = |name, value: Option<f64>| value.map(|value| Parameter { name, value });
        let missing = open(CoverageRule::Mismatch).map(|one| one.missing.len()).sum();
        let (width, area, thinness) = coverage.limits();
        let measures = vec![
            measure(
                OVERLAP,
                "number of invalid overlaps of surfaces",
                CONCEPTUAL,
                CoverageRule::Overlap,
                count(CoverageRule::Overlap),
                Vec::new(),
                "connected places that two or more features cover",
            ),
            measure(
                FAULTY_CONNECTION,
                "number of faulty point-curve connections",
                TOPOLOGICAL,
                CoverageRule::Mismatch,
                is_checked(CoverageRule::Mismatch).then_some(missing),
                Vec::new(),
                "vertices of a border that the border of a neighbour lacks",
            ),
            measure(
                UNDERSHOOT,
                "number of missing connections due to undershoots",
                TOPOLOGICAL,
                CoverageRule::NearMiss,
                count(CoverageRule::NearMiss),
                parameter("search distance", width).into_iter().collect(),
                "stretches along which the borders of two features do not meet",
            ),
            measure(
                SLIVER,
                "number of invalid slivers",
                TOPOLOGICAL,
                CoverageRule::Sliver,
                count(CoverageRule::Sliver),
                parameter("maximum sliver area size", area)
                    .into_iter()
                    .chain(parameter("thickness quotient", Some(thinness)))
                    .collect(),
                "parts of features that are small and thin",
            ),
            measure(
                SELF_INTERSECT,
                "number of invalid self-intersect errors",
                TOPOLOGICAL,
                CoverageRule::Validity,
                is_checked(CoverageRule::Validity).then(|| {
                    open(CoverageRule::Validity).filter(|one| measure_of(one) == Some(SELF_INTERSECT)).count()
                }),
                Vec::new(),
                "features with a ring that crosses or touches itself or another ring",
            ),
            measure(
                27,
                "number of invalid self-overlap errors",
                TOPOLOGICAL,
                CoverageRule::Validity,
                is_checked(CoverageRule::Validity).then(|| coverage.kickbacks()),
                Vec::new(),
                "features with a ring that turns straight back to the point from which it came",
            ),
        ];
        let of_coverage = [CoverageRule::Gap, CoverageRule::Duplicate].map(|rule| Unmeasured {
            rule: rule.id(),
            name: rule.name(),
            findings: count(rule),
        });
        let between = report.rules.iter().filter(|rule| rule.id.starts_with('X'));
        let between =
            between.map(|rule| Unmeasured { rule: rule.id, name: rule.name, findings: Some(rule.violations as usize) });
        Some(Self {
            standard: "ISO 19157:2013",
            input: &report.input,
            version: env!("CARGO_PKG_VERSION"),
            measures,
            without_measure: of_coverage.into_iter().chain(between).collect(),
        })
    }

    /// Returns the measures as an element `gmd:DQ_DataQuality` of ISO/TS 19139.
    ///
    /// # Errors
    /// Never: writing to a string does not fail.
    pub(crate) fn xml(&self) -> Result<String, std::fmt::Error> {
        const CODES: &str = "http://standards.iso.org/iso/19139/resources/gmxCodelists.xml";
        let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        writeln!(
            out,
            "<gmd:DQ_DataQuality xmlns:gmd=\"http://www.isotc211.org/2005/gmd\" xmlns:gco=\"http://www.isotc211.org/2005/gco\">"
        )?;
        writeln!(out, "  <!-- {} -->", self.remark())?;
        writeln!(
            out,
            "  <gmd:scope><gmd:DQ_Scope><gmd:level><gmd:MD_ScopeCode codeList=\"{CODES}#MD_ScopeCode\" codeListValue=\"dataset\">dataset</gmd:MD_ScopeCode></gmd:level></gmd:DQ_Scope></gmd:scope>"
        )?;
        for measure in &self.measures {
            let Measure { id, name, element, counted, .. } = measure;
            let text = |text: &str| format!("<gco:CharacterString>{}</gco:CharacterString>", escaped(text));
            let parameters: Vec<String> =
                measure.parameters.iter().map(|Parameter { name, value }| format!("{name} {value}")).collect();
            let with = if parameters.is_empty() { String::new() } else { format!("; {}", parameters.join(", ")) };
            writeln!(out, "  <gmd:report>\n    <gmd:{element}>")?;
            writeln!(out, "      <gmd:nameOfMeasure>{}</gmd:nameOfMeasure>", text(name))?;
            writeln!(
                out,
                "      <gmd:measureIdentification><gmd:RS_Identifier><gmd:code>{}</gmd:code><gmd:codeSpace>{}</gmd:codeSpace></gmd:RS_Identifier></gmd:measureIdentification>",
                text(&id.to_string()),
                text("ISO 19157")
            )?;
            writeln!(
                out,
                "      <gmd:measureDescription>{}</gmd:measureDescription>",
                text(&format!("{counted}{with}"))
            )?;
            writeln!(
                out,
                "      <gmd:evaluationMethodType><gmd:DQ_EvaluationMethodTypeCode codeList=\"{CODES}#DQ_EvaluationMethodTypeCode\" codeListValue=\"directInternal\">directInternal</gmd:DQ_EvaluationMethodTypeCode></gmd:evaluationMethodType>"
            )?;
            writeln!(
                out,
                "      <gmd:evaluationMethodDescription>{}</gmd:evaluationMethodDescription>",
                text(&format!("twinedge {}, full inspection", self.version))
            )?;
            let value = match measure.value {
                Some(value) => format!("<gmd:value><gco:Record>{value}</gco:Record></gmd:value>"),
                None => "<gmd:value gco:nilReason=\"unknown\"/>".to_owned(),
            };
            writeln!(
                out,
                "      <gmd:result><gmd:DQ_QuantitativeResult><gmd:valueUnit gco:nilReason=\"inapplicable\"/>{value}</gmd:DQ_QuantitativeResult></gmd:result>"
            )?;
            writeln!(out, "    </gmd:{element}>\n  </gmd:report>")?;
        }
        out.push_str("</gmd:DQ_DataQuality>\n");
        Ok(out)
    }

    /// The findings without a measure, escaped for a comment.
    fn remark(&self) -> String {
        let of = |one: &Unmeasured| {
            let findings = one.findings.map_or_else(|| "not checked".to_owned(), |count| count.to_string());
            format!("{} {} {findings}", one.rule, one.name)
        };
        let all: Vec<String> = self.without_measure.iter().map(of).collect();
        format!("no measure of {} counts these findings: {}", self.standard, all.join(", "))
    }
}
