//! The reference validator: a second implementation of the rules, slow and obvious.
//!
//! Each rule is one function, headed by its sentence, and its body is that sentence in sets and quantifiers. It shares
//! nothing with [`validate`](super::validate) but the answers of a [`View`](super::View), so that where both agree on
//! all small structures, a fault would have to be in both of them. [`compare`] runs both.
//!
//! It is exact about two things: a structure is valid if and only if no rule is broken; and the *first* broken rule, in
//! the order of [`Rule::ALL`](super::Rule::ALL), is the same for both validators. A later rule says what its sentence
//! says, also where an earlier one that it relies on is broken, while the fast validator then declines to check it.
//!
//! It always ends: nil is followed to nil, no walk goes on once it reaches what it has seen, and nothing recurses. But it
//! is cubic and worse, and reads every slot and every list entry that the view claims: it is for small structures only.

mod compare;
mod rules;
mod structure;

pub use super::validator::rule_by_rule;
pub use compare::{Disagreement, compare, compare_first, disagreement};
pub use rules::{broken_rules, first_broken_of, first_broken_rule};
