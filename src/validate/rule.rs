//! The rules by name.

use core::fmt;

macro_rules! rules {
    ($($variant:ident $id:literal $name:literal $unit:literal $statement:literal;)*) => {
        /// A rule of the structure. The order is that of the ladder: each rule makes sense once those before it hold.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Rule {
            $(#[doc = concat!("**", $id, " ", $name, "**: ", $statement)] $variant,)*
        }

        impl Rule {
            /// All rules, in order.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// The id: `R1` … `G5`.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self { $(Self::$variant => $id,)* }
            }

            /// The name in one word or two.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }

            /// What is counted when it is said how much was checked.
            #[must_use]
            pub const fn unit(self) -> &'static str {
                match self { $(Self::$variant => $unit,)* }
            }

            /// The rule in one sentence.
            #[must_use]
            pub const fn statement(self) -> &'static str {
                match self { $(Self::$variant => $statement,)* }
            }
        }
    };
}

rules! {
    R1 "R1" "live" "links" "every link that a record needs is there, and every link leads to a live record";
    L1 "L1" "twin" "half-edges" "`twin(twin(h)) = h` and `twin(h) ≠ h`";
    L2 "L2" "next/prev" "half-edges" "`prev(next(h)) = h` and `next(prev(h)) = h`";
    L3 "L3" "target" "half-edges" "`origin(next(h)) = origin(twin(h))`";
    V1 "V1" "leaving" "vertices" "the half-edge kept by a vertex leaves that vertex";
    V2 "V2" "rotation" "vertices" "the rotation of a vertex is all half-edges with that origin";
    B1 "B1" "cycle" "half-edges" "the boundary component is constant along `next`, its start is on its own cycle, and it has one cycle";
    B2 "B2" "isolated" "vertices" "a vertex has no half-edge if and only if exactly one boundary component starts at it, and they name each other";
    F1 "F1" "outer" "faces" "a bounded face has exactly one outer boundary component, a cycle; the one unbounded face has none";
    F2 "F2" "listed" "boundary components" "every boundary component is listed exactly once, by the face it names, at the place it says";
    T1 "T1" "outside" "components" "each component has exactly one inner boundary component, its outside";
    T2 "T2" "nesting" "components" "containment is a tree rooted at the unbounded face";
    T3 "T3" "Euler" "components" "per component `V − E + cycles = 2 − 2g`, with `g = 0` in the plane";
    T4 "T4" "bounds" "maps" "a simple map with `V ≥ 3` has `E ≤ 3V − 6` and `F ≤ 2V − 4`";
    G1 "G1" "finite" "vertices" "coordinates are finite, and no edge has zero length";
    G2 "G2" "angles" "vertices" "half-edges around a vertex are in angular order";
    G3 "G3" "winding" "cycles" "outer cycles turn counter-clockwise, inner ones clockwise";
    G4 "G4" "disjoint" "edges" "edges meet only at shared endpoints";
    G5 "G5" "inside" "boundary components" "each inner boundary component lies in the face that lists it";
}

impl Rule {
    /// Whether the rule speaks of coordinates (G1 … G5).
    #[must_use]
    pub const fn is_geometric(self) -> bool {
        matches!(self, Self::G1 | Self::G2 | Self::G3 | Self::G4 | Self::G5)
    }

    /// The position in [`Rule::ALL`].
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
