//! The engine of choices, and the macro that makes a harness and its broken twin.

/// All sequences of choices at once, to a model checker.
#[cfg(kani)]
#[derive(Debug)]
pub(crate) struct Symbolic;

#[cfg(kani)]
impl twinedge::program::choose::Choose for Symbolic {
    fn choose(&mut self, n: usize) -> usize {
        if n <= 1 {
            return 0;
        }
        let k = kani::any();
        kani::assume(k < n);
        k
    }
}

/// Runs a body over every sequence of choices. At least one case must be relevant, which a model checker reports as
/// covered.
#[cfg(kani)]
pub(crate) fn run(_: &str, body: impl Fn(&mut Symbolic) -> bool) {
    let to_the_point = body(&mut Symbolic);
    kani::cover!(to_the_point, "a case is to the point");
}

/// Runs a body over every sequence of choices, one after the other, and prints the numbers of all cases and of relevant
/// ones.
///
/// # Panics
/// If the body does, after printing the choices that made it, or if no case was relevant.
#[cfg(all(test, not(kani)))]
#[allow(clippy::print_stdout, clippy::print_stderr, reason = "the counts are part of the result")]
pub(crate) fn run(name: &str, body: impl Fn(&mut twinedge::program::choose::Odometer) -> bool) {
    use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
    let mut to_the_point = 0_u64;
    let count =
        twinedge::program::choose::for_each_choice(|source| match catch_unwind(AssertUnwindSafe(|| body(source))) {
            Ok(spoken_about) => to_the_point += u64::from(spoken_about),
            Err(panic) => {
                eprintln!("{name} fails with the choices {:?}", source.answers().collect::<Vec<_>>());
                resume_unwind(panic);
            }
        });
    assert!(to_the_point > 0, "{name} is about nothing");
    println!("{name}: {count} cases, {to_the_point} to the point");
}

/// Turns each entry into a harness, and into a twin of the same name in the module `broken`, which must fail with the
/// given message when the given fault is planted. An entry without a twin does not parse.
///
/// The harness is a test where there is no Kani and a proof where there is.
macro_rules! harnesses {
    ($(
        $name:ident (unwind $unwind:literal) = |$subject:ident, $source:ident| $body:expr;
        with $right:expr, but $message:literal with $wrong:expr;
    )*) => {
        $(
            #[cfg_attr(kani, kani::proof)]
            #[cfg_attr(kani, kani::unwind($unwind))]
            #[cfg_attr(not(kani), test)]
            #[allow(missing_docs, reason = "the name says it")]
            pub fn $name() {
                crate::engine::run(stringify!($name), |$source| {
                    let $subject = $right;
                    $body
                });
            }
        )*

        /// The twins: each harness fails where its property is broken.
        #[cfg(all(test, not(kani)))]
        mod broken {
            use super::*;

            $(
                #[test]
                #[should_panic(expected = $message)]
                fn $name() {
                    crate::engine::run(stringify!($name), |$source| {
                        let $subject = $wrong;
                        $body
                    });
                }
            )*
        }
    };
}
pub(crate) use harnesses;
