//! A program as data: operators with small numbers, so that all crates share one generator, one text form and one
//! shrinker. The adapter interprets the numbers, modulo the number of records.

use std::fmt::Write;

/// An operator of a crate.
#[derive(Clone, Copy, Debug)]
pub struct Operator {
    /// Its name in programs.
    pub name: &'static str,
    /// The number of arguments, which are numbers.
    pub arguments: usize,
    /// The relative frequency with which it is drawn.
    pub weight: u32,
    /// True if the numbers are places in lists of records, which move down when an earlier record is not made.
    pub places: bool,
}

impl Operator {
    /// An operator whose numbers are places in lists of records.
    #[must_use]
    pub const fn on_records(name: &'static str, arguments: usize, weight: u32) -> Self {
        Self { name, arguments, weight, places: true }
    }

    /// An operator whose numbers are values: coordinates, counts.
    #[must_use]
    pub const fn with_values(name: &'static str, arguments: usize, weight: u32) -> Self {
        Self { name, arguments, weight, places: false }
    }
}

/// One call.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// The operator, by its place in the crate's list.
    pub operator: usize,
    /// Its arguments.
    pub arguments: Vec<u32>,
}

/// Calls, in order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Program(pub Vec<Step>);

/// The bound of arguments.
const ARGUMENTS: u32 = 64;

impl Program {
    /// Returns the random program with this number, of at most `steps` steps. Equal numbers yield equal programs.
    #[must_use]
    pub fn random(operators: &[Operator], seed: u64, number: u64, steps: usize) -> Self {
        let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ number.wrapping_mul(0xd1b5_4a32_d192_ed03));
        let total = operators.iter().map(|operator| operator.weight).sum::<u32>();
        let length = 1 + random.below(steps as u32);
        let step = |_| {
            let mut draw = random.below(total);
            let mut drawn = 0;
            while draw >= operators[drawn].weight {
                draw -= operators[drawn].weight;
                drawn += 1;
            }
            let arguments = (0..operators[drawn].arguments).map(|_| random.below(ARGUMENTS)).collect();
            Step { operator: drawn, arguments }
        };
        Self((0..length).map(step).collect())
    }

    /// Writes the program as text, such as `insert 3 4; remove 0`.
    #[must_use]
    pub fn to_text(&self, operators: &[Operator]) -> String {
        let step = |step: &Step| {
            step.arguments.iter().fold(operators[step.operator].name.to_owned(), |mut text, argument| {
                let _ = write!(text, " {argument}");
                text
            })
        };
        self.0.iter().map(step).collect::<Vec<_>>().join("; ")
    }

    /// Parses a program.
    ///
    /// # Errors
    /// Describes the unreadable part.
    pub fn parse(text: &str, operators: &[Operator]) -> Result<Self, String> {
        let step = |text: &str| {
            let mut words = text.split_whitespace();
            let name = words.next().unwrap_or_default();
            let place = operators.iter().position(|operator| operator.name == name);
            let operator = place.ok_or_else(|| format!("there is no operator '{name}'"))?;
            let arguments = words.map(str::parse).collect::<Result<Vec<u32>, _>>();
            let arguments = arguments.map_err(|error| format!("'{text}': {error}"))?;
            let expected = operators[operator].arguments;
            if arguments.len() == expected {
                Ok(Step { operator, arguments })
            } else {
                Err(format!("'{name}' takes {expected} numbers"))
            }
        };
        text.split(';').filter(|text| !text.trim().is_empty()).map(step).collect::<Result<_, _>>().map(Self)
    }
}

/// `SplitMix64`.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: u32) -> u32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((u64::from((z ^ (z >> 31)) as u32) * u64::from(bound)) >> 32) as u32
    }
}
