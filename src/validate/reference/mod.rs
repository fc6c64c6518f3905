//! The reference validator: a second implementation of the rules, slow and obvious.
//!
//! Each rule is one function, headed by its sentence, whose body is that sentence in sets and quantifiers. It shares
//! nothing with [`validate`](super::validate) but the answers of a [`View`](super::View), so if both agree on all small
//! structures, a fault would have to be in both. `opinions` of the crate `twinedge-trials` runs both.
//!
//! It is exact in two respects: a structure is valid if and only if no rule is broken; and the *first* broken rule, in
//! the order of [`Rule::ALL`](super::Rule::ALL), is the same for both validators. A later rule means its sentence even if
//! an earlier rule that it relies on is broken; the fast validator then does not check it.
//!
//! It always terminates: nil leads to nil, walks stop at records already seen, and nothing recurses. But it is cubic and
//! worse, and reads every slot and every list entry that the view claims: use it only for small structures.

mod rules;
mod structure;

pub use super::validator::rule_by_rule;
pub use rules::{broken_rules, first_broken_of, first_broken_rule};
