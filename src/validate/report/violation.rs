//! Every way of breaking a rule, with the records involved, its usual cause and its remedy.

use super::names::{Ends, Field, Name, Names, Number, PlaceText, Record};
use crate::validate::catalogue::catalogue;
use crate::validate::rule::Rule;
use crate::validate::structure::{BoundaryPlace, Link};
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

macro_rules! violations {
    // The type of this kind of field.
    (@type half_edge_link) => { Link };
    (@type boundary_link) => { Link };
    (@type face_link) => { Link };
    (@type record) => { Record };
    (@type sided) => { Record };
    (@type outer) => { Record };
    (@type inner) => { Record };
    (@type field) => { Field };
    (@type place) => { Option<BoundaryPlace> };
    (@type list_place) => { BoundaryPlace };
    (@type ends) => { [usize; 2] };
    // The index of a record, or a number.
    (@type $index:ident) => { usize };

    // The text of this kind of field in sentences.
    (@words vertex $names:ident $value:ident) => {
        $names.vertex($value)
    };
    (@words half_edge $names:ident $value:ident) => {
        $names.half_edge($value)
    };
    (@words boundary $names:ident $value:ident) => {
        $names.boundary($value)
    };
    (@words face $names:ident $value:ident) => {
        $names.face($value)
    };
    (@words half_edge_link $names:ident $value:ident) => {
        $names.link(Record::HalfEdge, $value)
    };
    (@words boundary_link $names:ident $value:ident) => {
        $names.link(Record::Boundary, $value)
    };
    (@words face_link $names:ident $value:ident) => {
        $names.link(Record::Face, $value)
    };
    (@words record $names:ident $value:ident) => {
        $names.record($value)
    };
    (@words sided $names:ident $value:ident) => {
        $names.cycle_of($value)
    };
    (@words outer $names:ident $value:ident) => {
        $names.component("outer", $value)
    };
    (@words inner $names:ident $value:ident) => {
        $names.component("inner", $value)
    };
    (@words place $names:ident $value:ident) => {
        PlaceText($value)
    };
    (@words list_place $names:ident $value:ident) => {
        PlaceText(Some($value))
    };
    (@words ends $names:ident $value:ident) => {
        Ends($value.map(|v| $names.vertex(v)))
    };
    (@words dangling $names:ident $value:ident) => {
        Dangling($value)
    };
    (@words $other:ident $names:ident $value:ident) => {
        $value
    };

    // The record that this kind of field names, if any.
    (@record vertex $value:ident) => {
        Some(Record::Vertex($value))
    };
    (@record half_edge $value:ident) => {
        Some(Record::HalfEdge($value))
    };
    (@record boundary $value:ident) => {
        Some(Record::Boundary($value))
    };
    (@record face $value:ident) => {
        Some(Record::Face($value))
    };
    (@record record $value:ident) => {
        Some($value)
    };
    (@record sided $value:ident) => {
        Some($value)
    };
    (@record outer $value:ident) => {
        Some($value)
    };
    (@record inner $value:ident) => {
        Some($value)
    };
    (@record $other:ident $value:ident) => {
        None
    };

    // The rows of the catalogue.
    ($($(#[doc = $more:literal])* $rule:ident $name:literal counts $one:literal $many:literal
        $statement:literal in $file:literal broken by $tests:literal $test:literal {
        $($variant:ident $({ $($field:ident: $kind:ident),+ })? $word:literal
            says $sentence:literal $(with |$names:ident| { $($extra:ident = $expression:expr),+ })?
            cause $cause:literal remedy $remedy:literal;)*
    })*) => {
        /// One broken rule, with the records that break it. `Display` prints the id of the rule, and a sentence about the fault and
        /// its consequence.
        ///
        /// Numbers are the indices of the [`View`](crate::validate::View).
        ///
        /// ```
        /// use twinedge::validate::{Collect, Expectation, Table, Violation, validate};
        /// // A loop that is its own twin.
        /// let table: Table = "V 1 0 - H 1 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
        /// let report = validate(&table, &Expectation::plane(), Collect::All);
        /// let violation = report.first().unwrap();
        /// assert_eq!(violation, &Violation::TwinIsSelf { half_edge: 0 });
        /// assert_eq!(violation.kind(), "twin_is_self");
        /// assert_eq!(violation.to_string(), "L1: half-edge 0 is its own twin, so its edge has one side only");
        /// assert_eq!(violation.message(), "half-edge 0 is its own twin, so its edge has one side only");
        /// assert!(violation.remedy().starts_with("create both half-edges of an edge together"));
        /// # Ok::<(), twinedge::validate::ParseTableError>(())
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde", serde(tag = "kind", content = "fields", rename_all = "snake_case"))]
        #[non_exhaustive]
        #[allow(missing_docs, reason = "the fields are named after the words of the design, and each variant has its sentence")]
        pub enum Violation {
            $($(
                #[doc = concat!(stringify!($rule), ": ", $sentence, ".")]
                #[doc = concat!("\n\n*Usual cause:* ", $cause, ".")]
                #[doc = concat!("\n\n*Remedy:* ", $remedy, ".")]
                $variant $({ $($field: violations!(@type $kind)),+ })?,
            )*)*
        }

        impl Violation {
            /// The names of all violations, in the order of the rules: see [`kind`](Self::kind).
            pub const KINDS: &[&str] = &[$($($word),*),*];

            /// Returns the name of the violation, in snake case. Names do not change between versions.
            #[must_use]
            pub const fn kind(&self) -> &'static str {
                match self { $($(Self::$variant { .. } => $word,)*)* }
            }

            /// Returns the broken rule.
            #[must_use]
            pub const fn rule(&self) -> Rule {
                match self { $($(Self::$variant { .. } => Rule::$rule,)*)* }
            }

            /// Returns the usual cause of such a violation, as part of a sentence.
            #[must_use]
            pub const fn cause(&self) -> &'static str {
                match self { $($(Self::$variant { .. } => $cause,)*)* }
            }

            /// Returns the fix, as part of a sentence.
            #[must_use]
            pub const fn remedy(&self) -> &'static str {
                match self { $($(Self::$variant { .. } => $remedy,)*)* }
            }

            /// Returns the records involved, the one at fault first; at most two, or no record if the whole structure is at fault.
            #[must_use]
            #[allow(unused_variables, reason = "some fields name no record")]
            pub fn records(&self) -> [Option<Record>; 2] {
                let mut records: [Option<Record>; 4] = [None; 4];
                match *self {
                    $($(Self::$variant $({ $($field),+ })? => {
                        $(for (to, record) in records.iter_mut().zip([$(violations!(@record $kind $field)),+]) { *to = record; })?
                    })*)*
                }
                let mut named = records.into_iter().flatten();
                [named.next(), named.next()]
            }

            /// Returns the sentence alone, without the id of the rule.
            #[must_use]
            pub fn message(&self) -> String {
                Sentence(self, Names::INDICES).to_string()
            }

            #[allow(unused_variables, reason = "some fields are said in other words")]
            fn write(&self, names: Names<'_>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match *self {
                    $($(Self::$variant $({ $($field),+ })? => {
                        $(let $names = names; $(let $extra = $expression;)+)?
                        $($(let $field = violations!(@words $kind names $field);)+)?
                        write!(f, $sentence)
                    })*)*
                }
            }
        }
    };
}

catalogue! { violations }

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.rule(), Sentence(self, Names::INDICES))
    }
}

/// The sentence of a violation, with these names.
pub(super) struct Sentence<'a>(pub(super) &'a Violation, pub(super) Names<'a>);

impl fmt::Display for Sentence<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.write(self.1, f)
    }
}

/// An index that no live record has. For an unknown id it is the largest possible index.
struct Dangling(usize);

impl fmt::Display for Dangling {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            usize::MAX => f.write_str("leads to no record at all"),
            index => write!(f, "is {index}, which is no live record"),
        }
    }
}

enum Place<'a> {
    In(Name<'a>),
    Nowhere,
}

impl fmt::Display for Place<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::In(face) => write!(f, "face {face}"),
            Self::Nowhere => f.write_str("no face"),
        }
    }
}

/// Keeps at most `cap` violations, which are in the order of the rules. Each broken rule keeps its first ones, with an equal share
/// for every rule; the unused share of rules with few goes to earlier rules. If there are more rules than `cap`, the first rules keep
/// one each.
pub(crate) fn keep_some_of_each(violations: &mut Vec<Violation>, cap: usize) {
    if violations.len() <= cap {
        return;
    }
    let mut found = [0_usize; Rule::ALL.len()];
    for violation in violations.iter() {
        found[violation.rule().index()] += 1;
    }
    let broken = found.iter().filter(|count| **count > 0).count();
    let share = (cap / broken).max(1);
    let mut rest = cap.saturating_sub(found.iter().map(|count| *count.min(&share)).sum());
    let mut left = cap;
    let mut kept = found.map(|count| {
        let more = count.saturating_sub(share).min(rest);
        rest -= more;
        let kept = (count.min(share) + more).min(left);
        left -= kept;
        kept
    });
    violations.retain(|violation| {
        let kept = &mut kept[violation.rule().index()];
        let is_kept = *kept > 0;
        *kept = kept.saturating_sub(1);
        is_kept
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the numbers of violations of L1, L2 and L3 that are kept.
    fn kept(found: [usize; 3], cap: usize) -> [usize; 3] {
        let of = [
            Violation::TwinIsSelf { half_edge: 0 },
            Violation::NextShared { first: 0, second: 0, next: 0 },
            Violation::Target { half_edge: 0, next: 0, target: 0, found: 0 },
        ];
        let mut violations: Vec<_> = of.iter().zip(found).flat_map(|(one, n)| core::iter::repeat_n(*one, n)).collect();
        keep_some_of_each(&mut violations, cap);
        assert!(violations.is_sorted_by_key(Violation::rule));
        of.map(|one| violations.iter().filter(|violation| violation.rule() == one.rule()).count())
    }

    #[test]
    fn each_broken_rule_keeps_some_of_its_violations() {
        assert_eq!(kept([1, 0, 1600], 1000), [1, 0, 999]);
        assert_eq!(kept([1600, 0, 1], 1000), [999, 0, 1]);
        assert_eq!(kept([9, 9, 9], 10), [4, 3, 3]);
        assert_eq!(kept([9, 1, 2], 10), [7, 1, 2]);
        assert_eq!(kept([9, 9, 9], 2), [1, 1, 0]);
        assert_eq!(kept([0, 5, 5], 1), [0, 1, 0]);
        assert_eq!(kept([3, 3, 3], 0), [0, 0, 0]);
        assert_eq!(kept([3, 3, 3], 9), [3, 3, 3]);
    }
}
