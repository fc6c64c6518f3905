//! The rules by name.

use super::catalogue::catalogue;
use core::fmt;

macro_rules! rules {
    ($($(#[doc = $more:literal])* $rule:ident $name:literal counts $one:literal $many:literal
        $statement:literal in $file:literal broken by $tests:literal $test:literal { $($violations:tt)* })*) => {
        /// A rule of the structure. The order follows dependencies: each rule makes sense only if the rules before it hold.
        ///
        /// The [reference](mod@crate::validate::reference) states each rule except G1 … G5 again, in a function of the same name.
        ///
        /// ```
        /// use twinedge::validate::Rule;
        /// let rule = Rule::L1;
        /// assert_eq!((rule.id(), rule.name()), ("L1", "twin"));
        /// assert_eq!(rule.statement(), "`twin(twin(h)) = h` and `twin(h) ≠ h`");
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[non_exhaustive]
        pub enum Rule {
            $(
                #[doc = concat!("**", stringify!($rule), " ", $name, "**: ", $statement, ".\n")]
                $(#[doc = $more])*
                #[doc = concat!(
                    "\n\nChecked in `", $file, ".rs`; broken alone by `", $test,
                    "` in `", $tests, ".rs`."
                )]
                $rule,
            )*
        }

        impl Rule {
            /// All rules, in order.
            pub const ALL: &[Self] = &[$(Self::$rule),*];

            /// Returns the id: `R1` … `G5`.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self { $(Self::$rule => stringify!($rule),)* }
            }

            /// Returns the name, one word or two.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$rule => $name,)* }
            }

            /// Returns the noun for `count` records that the rule is checked on: `vertex`, `vertices`.
            #[must_use]
            pub const fn unit(self, count: u64) -> &'static str {
                match self { $(Self::$rule => if count == 1 { $one } else { $many },)* }
            }

            /// Returns the rule as one sentence.
            #[must_use]
            pub const fn statement(self) -> &'static str {
                match self { $(Self::$rule => $statement,)* }
            }
        }
    };
}

catalogue! { rules }

impl Rule {
    /// Returns true if the rule is about coordinates (G1 … G5).
    #[must_use]
    pub const fn is_geometric(self) -> bool {
        self.id().as_bytes()[0] == b'G'
    }

    /// Returns true if the rule is checked only on request (M1 … M8).
    #[must_use]
    pub const fn is_optional(self) -> bool {
        self.id().as_bytes()[0] == b'M'
    }

    /// Returns true if the rule is checked only in the plane: B2, T1, T2 and T4.
    #[must_use]
    pub const fn is_planar(self) -> bool {
        matches!(self, Self::B2 | Self::T1 | Self::T2 | Self::T4)
    }

    /// Returns the position in [`Rule::ALL`].
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}
