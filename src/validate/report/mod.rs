//! The result of a validation: rule outcomes, violations, counts, and on success the figures of the structure.

mod names;
#[cfg(feature = "serde")]
mod saved;
mod text;
mod violation;

pub use names::{Field, Record};
#[cfg(feature = "serde")]
pub use saved::{Described, REPORT_SCHEMA};
pub use text::Named;
pub use violation::Violation;
pub(super) use violation::keep_some_of_each;

use super::rule::Rule;
use super::structure::Part;
use alloc::boxed::Box;
use alloc::vec::Vec;
use core::fmt;

/// The number of violations to keep. Except with `First`, all violations of each rule are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Collect {
    /// Stop at the first violation of the first broken rule.
    First,
    /// Keep up to [`Collect::DEFAULT_CAP`] violations, some of each broken rule.
    #[default]
    All,
    /// Keep up to this number of violations, some of each broken rule, or if it is too small, one of each of the first broken rules.
    /// With 0 they are only counted.
    AtMost(usize),
}

impl Collect {
    /// The maximum kept by `All`.
    pub const DEFAULT_CAP: usize = 1000;

    pub(crate) const fn cap(self) -> usize {
        match self {
            Self::First => 1,
            Self::All => Self::DEFAULT_CAP,
            Self::AtMost(n) => n,
        }
    }
}

/// The reason why a rule was not checked, or not on every record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Unchecked {
    /// It relies on this broken rule.
    Broken(Rule),
    /// The structure does not store this part.
    Lacks(Part),
    /// It is a [rule of the plane](Rule::is_planar), but the structure may lie on any surface. Reports in text omit the rule.
    PlaneOnly,
    /// It only applies to simple maps with at least three vertices: there are loops, parallel edges or fewer vertices.
    NotSimple,
    /// The run ended with the first violation, as requested.
    Stopped,
    /// The structure claims more than `u32::MAX - 1` records of one kind.
    TooLarge,
    /// Memory ran out.
    OutOfMemory,
    /// The lists of the faces have more entries than twice the number of boundary components plus 16; the rest of the lists was not
    /// read.
    ListTooLong,
}

impl Unchecked {
    /// Returns true if a structure can be valid although the rule was not checked: it does not store the part that the rule is
    /// about, or the rule does not apply to it.
    #[must_use]
    pub const fn is_by_design(self) -> bool {
        matches!(self, Self::Lacks(_) | Self::PlaneOnly | Self::NotSimple)
    }
}

impl fmt::Display for Unchecked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Broken(rule) => write!(f, "needs {rule}, which is broken"),
            Self::Lacks(part) => write!(f, "the structure stores no {}", part.name()),
            Self::PlaneOnly => f.write_str("a rule of the plane only"),
            Self::NotSimple => f.write_str("applies to simple maps with at least 3 vertices"),
            Self::Stopped => f.write_str("stopped at the first violation"),
            Self::TooLarge => f.write_str("more than 4,294,967,294 records of one kind"),
            Self::OutOfMemory => f.write_str("not enough memory"),
            Self::ListTooLong => f.write_str("the lists of the faces are too long to be read to the end"),
        }
    }
}

/// The outcome of one rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RuleOutcome {
    /// The number of checks, in the [unit](Rule::unit) of the rule.
    pub checked: u64,
    /// The number of violations found, kept or not.
    pub violations: u64,
    /// The reason why the rule was not checked, or not on every record.
    pub unchecked: Option<Unchecked>,
}

/// The numbers of a valid structure: no violation was found, and every applicable rule was checked.
///
/// Adding up T3 over all components, with one cycle for each isolated vertex, yields `vertices − edges + cycles + borders +
/// isolated_vertices = 2 · components − 2 · genus`.
///
/// No number depends on the representation of borders: half-edges without face, or edges with only one half-edge.
///
/// ```
/// use twinedge::validate::{Collect, Expectation, Table, validate};
/// // A triangle. Half-edges 0, 1 and 2 run around its face; then their twins are there, and have none.
/// let one_half_edge: Table = "P 3 prev leaving faces V 3 0 - 1 - 2 - H 3 0 - 1 2 - 1 - 2 0 - 2 - 0 1 - B 0 F 1 - 0 HF 3 0 0 0 FH 1 0 0".parse()?;
/// let no_face: Table = "P 3 prev leaving faces V 3 0 - 1 - 2 - H 6 0 3 1 2 - 1 4 2 0 - 2 5 0 1 - 1 0 5 4 - 2 1 3 5 - 0 2 4 3 - B 0 F 1 - 0 \
///     HF 6 0 0 0 - - - FH 1 0 0".parse()?;
/// let expectation = Expectation::surface().open().borders(1);
/// for table in [one_half_edge, no_face] {
///     let found = validate(&table, &expectation, Collect::All).into_result()?;
///     assert_eq!((found.edges, found.faces, found.cycles, found.borders, found.euler_characteristic), (3, 1, 1, 1, 1));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Figures {
    /// V.
    pub vertices: usize,
    /// E.
    pub edges: usize,
    /// F, including the unbounded face.
    pub faces: usize,
    /// C.
    pub components: usize,
    /// Cycles of `next`, not counting border loops.
    pub cycles: usize,
    /// Border loops: cycles of half-edges without face, and cycles that missing twins would form.
    pub borders: usize,
    /// Vertices that no half-edge leaves.
    pub isolated_vertices: usize,
    /// The sum of the genera of the components: 0 in the plane.
    pub genus: usize,
    /// χ = V − E + F, as in [`Counts::euler_characteristic`].
    pub euler_characteristic: isize,
    /// The bounds of T4, if the map is simple and has at least three vertices.
    pub bounds: Option<Bounds>,
    /// The rules that do not apply to this structure, with the reason.
    pub not_checked: Vec<(Rule, Unchecked)>,
}

/// The result of a validation.
///
/// ```
/// use twinedge::validate::{Collect, Expectation, Table, validate};
/// // Two half-edges, each the twin of the other; both cycles have one half-edge. That is a loop at one vertex, not at two.
/// let table: Table = "P 0 V 2 - - - - H 2 0 1 0 - - 1 0 1 - - B 0 F 0".parse()?;
/// let report = validate(&table, &Expectation::plane(), Collect::All);
/// assert!(!report.is_valid());
/// assert!(report.to_string().starts_with(
///     "R1 live      ok, 6 links\n\
///      L1 twin      ok, 2 half-edges\n\
///      L2 next/prev ok, 2 half-edges\n\
///      L3 target    BROKEN, 2 violations in 2 half-edges\n\
///      V1 leaving   not checked: the structure stores no leaving half-edges\n\
///      V2 rotation  not checked: needs L3, which is broken\n"
/// ));
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
#[derive(Clone, PartialEq, Eq)]
pub struct Report {
    pub(crate) outcomes: Vec<(Rule, RuleOutcome)>,
    pub(crate) violations: Vec<Violation>,
    pub(crate) counts: Counts,
    pub(crate) bounds: Option<Bounds>,
}

impl Report {
    /// Returns the rules of this validation, in order, with their outcomes.
    #[must_use]
    pub fn outcomes(&self) -> impl ExactSizeIterator<Item = (Rule, RuleOutcome)> + '_ {
        self.outcomes.iter().copied()
    }

    /// Returns the outcome of this rule; `None` for a rule that is not part of this validation (G without coordinates, M without a
    /// request).
    #[must_use]
    pub fn outcome(&self, rule: Rule) -> Option<RuleOutcome> {
        self.outcomes.iter().find(|(r, _)| *r == rule).map(|(_, o)| *o)
    }

    /// Returns the broken rules, in order. All but the first may be consequences of it.
    ///
    /// ```
    /// use twinedge::validate::{Collect, Expectation, Rule, Table, validate};
    /// // A loop that is its own twin.
    /// let table: Table = "V 1 0 - H 1 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
    /// let report = validate(&table, &Expectation::plane(), Collect::All);
    /// assert_eq!(report.broken_rules().next(), Some(Rule::L1));
    /// # Ok::<(), twinedge::validate::ParseTableError>(())
    /// ```
    pub fn broken_rules(&self) -> impl Iterator<Item = Rule> + '_ {
        self.outcomes.iter().filter(|(_, outcome)| outcome.violations > 0).map(|(rule, _)| *rule)
    }

    /// Returns the kept violations, in the order of the rules: some of each broken rule.
    #[must_use]
    pub fn violations(&self) -> &[Violation] {
        &self.violations
    }

    /// Returns the first violation of the first broken rule, which may have caused the others. `None` if the structure is valid, or
    /// if violations are only counted.
    ///
    /// ```
    /// use twinedge::validate::{Collect, Expectation, Table, Violation, validate};
    /// // A loop that is its own twin.
    /// let table: Table = "V 1 0 - H 1 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
    /// let report = validate(&table, &Expectation::plane(), Collect::All);
    /// assert_eq!(report.first(), Some(&Violation::TwinIsSelf { half_edge: 0 }));
    /// # Ok::<(), twinedge::validate::ParseTableError>(())
    /// ```
    #[must_use]
    pub fn first(&self) -> Option<&Violation> {
        self.violations.first()
    }

    /// Appends the outcomes and violations of later rules. O(violations).
    pub fn append(&mut self, later: Self, collect: Collect) {
        self.outcomes.extend(later.outcomes);
        self.violations.extend(later.violations);
        keep_some_of_each(&mut self.violations, collect.cap());
    }

    /// Returns the number of violations found, kept or not.
    #[must_use]
    pub fn violation_count(&self) -> u64 {
        self.outcomes.iter().map(|(_, o)| o.violations).sum()
    }

    fn violations_left_out(&self) -> u64 {
        self.violation_count().saturating_sub(self.violations.len() as u64)
    }

    /// Returns the numbers of records, components, cycles, borders and handles.
    #[must_use]
    pub const fn counts(&self) -> &Counts {
        &self.counts
    }

    /// Returns true if no violation was found and every applicable rule was checked.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        self.outcomes.iter().all(|(_, o)| o.violations == 0 && o.unchecked.is_none_or(Unchecked::is_by_design))
    }

    /// Returns the figures of a valid structure.
    ///
    /// # Errors
    /// The report, if a violation was found or an applicable rule was not checked.
    ///
    /// ```
    /// use twinedge::validate::{Collect, Expectation, Rule, Table, validate};
    /// // An isolated vertex.
    /// let mut table: Table = "V 1 - 0 H 0 B 1 0 v0 i0 F 1 - 1 0".parse()?;
    /// let figures = validate(&table, &Expectation::plane(), Collect::All).into_result()?;
    /// assert_eq!((figures.vertices, figures.components), (1, 1));
    ///
    /// table.faces.push(None);
    /// table.vertices[0].as_mut().unwrap().isolated = None;
    /// let report = validate(&table, &Expectation::plane(), Collect::All).into_result().unwrap_err();
    /// assert_eq!(report.broken_rules().collect::<Vec<_>>(), [Rule::B2]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn into_result(self) -> Result<Figures, Box<Self>> {
        match self.figures() {
            Some(figures) => Ok(figures),
            None => Err(Box::new(self)),
        }
    }

    /// Returns the figures, if the structure is valid.
    #[must_use]
    pub fn figures(&self) -> Option<Figures> {
        let Counts { vertices, edges, faces, isolated_vertices, .. } = self.counts;
        if !self.is_valid() {
            return None;
        }
        Some(Figures {
            vertices,
            edges,
            faces,
            components: self.counts.components?,
            cycles: self.counts.cycles?,
            borders: self.counts.borders?,
            isolated_vertices,
            genus: self.counts.genus?,
            euler_characteristic: self.counts.euler_characteristic()?,
            bounds: self.bounds,
            not_checked: self.outcomes.iter().filter_map(|(r, o)| Some((*r, o.unchecked?))).collect(),
        })
    }
}

/// Allows `?` after [`Report::into_result`].
impl core::error::Error for Report {}

/// The numbers of records, components, cycles, borders and handles. A number is `None` if a rule that its counting relies on is
/// broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Counts {
    /// V.
    pub vertices: usize,
    /// Half-edges.
    pub half_edges: usize,
    /// E: pairs of twins, plus half-edges without twin at open boundaries.
    pub edges: usize,
    /// F: face records, including the unbounded face.
    pub faces: usize,
    /// Boundary components listed as outer.
    pub outer_boundaries: usize,
    /// Boundary components listed as inner, including isolated vertices.
    pub inner_boundaries: usize,
    /// Vertices that no half-edge leaves.
    pub isolated_vertices: usize,
    /// C: connected components.
    pub components: Option<usize>,
    /// Cycles of `next`, not counting border loops. Without faces, all cycles.
    pub cycles: Option<usize>,
    /// Border loops, which T3 counts with the cycles: cycles of half-edges without face, and cycles that missing twins would
    /// form. Both representations of a border yield the same number.
    pub borders: Option<usize>,
    /// The sum of the genera of the components.
    pub genus: Option<usize>,
}

impl Counts {
    pub(crate) const NOTHING: Self = Self {
        vertices: 0,
        half_edges: 0,
        edges: 0,
        faces: 0,
        outer_boundaries: 0,
        inner_boundaries: 0,
        isolated_vertices: 0,
        components: None,
        cycles: None,
        borders: None,
        genus: None,
    };

    /// χ = V − E + F of the whole, where F is the number of faces, or without faces the number of cycles that are not border
    /// loops. `None` if components could not be counted.
    ///
    /// If each face has one cycle, the sum of T3 over all components is `χ = 2 · components − isolated_vertices − 2 · genus −
    /// borders`. For a map in the plane with its unbounded face, `χ = 1 + components`. It does not depend on the representation
    /// of borders.
    ///
    /// ```
    /// use twinedge::validate::{Collect, Expectation, Table, validate};
    /// // An edge in the unbounded face.
    /// let table: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
    /// let report = validate(&table, &Expectation::plane(), Collect::All);
    /// assert_eq!(report.counts().euler_characteristic(), Some(2));
    /// # Ok::<(), twinedge::validate::ParseTableError>(())
    /// ```
    #[must_use]
    pub fn euler_characteristic(&self) -> Option<isize> {
        self.components?;
        let faces = if self.faces > 0 { self.faces } else { self.cycles? };
        let [vertices, edges, faces] = [self.vertices, self.edges, faces].map(|n| isize::try_from(n).ok());
        vertices?.checked_sub(edges?)?.checked_add(faces?)
    }
}

/// The bounds of T4: the maximum numbers of edges and faces of a simple map with this number of vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Bounds {
    /// `3V − 6`, the maximum number of edges.
    pub most_edges: usize,
    /// `2V − 4`, the maximum number of faces.
    pub most_faces: usize,
}
