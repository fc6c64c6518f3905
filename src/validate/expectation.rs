//! The claims to which a structure is held: the surface on which it lies, open boundaries, and the rules M1 … M8.

use super::rule::Rule;
use super::structure::{Part, Parts};

/// The surface on which the structure is to lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Surface {
    /// The plane: every component has genus 0 and containment is a tree rooted at the unbounded face.
    Plane,
    /// Orientable surfaces of any genus, one per component.
    Any,
}

/// The claims to which a structure is held. What it *stores*, [`View::parts`](super::View::parts) says.
///
/// ```
/// use twinedge::validate::Expectation;
/// // A mesh with a border, whose half-edges have no face or no twin.
/// let mesh = Expectation::surface().open();
/// assert!(mesh.is_open());
/// // The same, and a disc of triangles.
/// let disc = mesh.triangles().components(1).borders(1).genus(0);
/// ```
///
/// # What can be asked for
///
/// A structure keeps R1 … T4, or it is broken. M1 … M8 say what else it is to be. Each is checked, and in the report, only if it
/// is asked for; it needs the rules before it, and where they are broken it is reported as not checked.
///
/// | rule | asked for by |
/// | --- | --- |
/// | M1 used | [`no_unused_vertices`](Self::no_unused_vertices) |
/// | M2 simple | [`simple`](Self::simple) |
/// | M3 sides | [`sides`](Self::sides), [`triangles`](Self::triangles) |
/// | M4 closed | [`closed`](Self::closed) |
/// | M5 connected | [`components`](Self::components) |
/// | M6 borders | [`borders`](Self::borders) |
/// | M7 genus | [`genus`](Self::genus) |
/// | M8 kept | [`border_kept`](Self::border_kept) |
///
/// Most programs that work with triangle meshes take `surface().no_unused_vertices().simple().triangles()` for granted, with
/// `.open().borders(n)` for a mesh with `n` border loops. M8 is a promise of some libraries, and no more usual than its absence.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Expectation {
    surface: Surface,
    open: bool,
    /// A bit for each optional rule that is asked for.
    asked: u32,
    /// The numbers of M3, M5, M6 and M7; 0 where they are not asked for.
    numbers: [usize; NUMBERS],
}

/// The number of rules that are asked for with a number.
const NUMBERS: usize = 4;

impl Expectation {
    /// A planar subdivision. Where no unbounded face is stored ([`Part::UnboundedFace`]), a sphere is one, too: any of its faces can be
    /// the unbounded one.
    #[must_use]
    pub const fn plane() -> Self {
        Self { surface: Surface::Plane, open: false, asked: 0, numbers: [0; NUMBERS] }
    }

    /// A subdivision of closed orientable surfaces, in which each face has one cycle. An unbounded face and lists of holes, where they are
    /// stored, are not looked at.
    #[must_use]
    pub const fn surface() -> Self {
        Self { surface: Surface::Any, open: false, asked: 0, numbers: [0; NUMBERS] }
    }

    /// The same, but open boundaries are legal. At an edge of an open boundary one side is missing, in one of two ways:
    ///
    /// - There is one half-edge. It has a face, and no twin.
    /// - There are two half-edges, twins of each other. The one along the boundary has no face (no boundary component,
    ///   where there are records for these).
    ///
    /// Both half-edges of an edge may lack a face. A half-edge with neither twin nor face bounds nothing, and breaks R1. If the
    /// structure lacks faces, there is nothing to check of that.
    ///
    /// The outside of a component may be an open boundary, and then it has no inner boundary component.
    #[must_use]
    pub const fn open(mut self) -> Self {
        self.open = true;
        self
    }

    /// The same, and some half-edge leaves every vertex (M1).
    #[must_use]
    pub const fn no_unused_vertices(self) -> Self {
        self.ask(Rule::M1, 0)
    }

    /// The same, without loops and parallel edges (M2).
    #[must_use]
    pub const fn simple(self) -> Self {
        self.ask(Rule::M2, 0)
    }

    /// The same, and every bounded face has so many sides (M3).
    #[must_use]
    pub const fn sides(self, count: usize) -> Self {
        self.ask(Rule::M3, count)
    }

    /// The same, and every bounded face has three sides (M3).
    #[must_use]
    pub const fn triangles(self) -> Self {
        self.sides(3)
    }

    /// The same, without border (M4). Together with [`open`](Self::open), each half-edge at a border is reported as that;
    /// without, R1 is broken, as links are missing.
    ///
    /// ```
    /// use twinedge::validate::{Collect, Expectation, Table, Violation, validate};
    /// // A triangle of three half-edges.
    /// let table: Table = "P 3 prev leaving faces V 3 0 - 1 - 2 - H 3 0 - 1 2 - 1 - 2 0 - 2 - 0 1 - B 0 F 1 - 0 HF 3 0 0 0 FH 1 0 0".parse()?;
    /// let expectation = Expectation::surface().open().closed();
    /// let report = validate(&table, &expectation, Collect::All);
    /// assert_eq!(report.violations().len(), 3);
    /// assert_eq!(
    ///     report.violations()[0].to_string(),
    ///     "M4: half-edge 0, from vertex 0 to vertex 1, has no twin: the surface has a border there"
    /// );
    /// # Ok::<(), twinedge::validate::ParseTableError>(())
    /// ```
    #[must_use]
    pub const fn closed(self) -> Self {
        self.ask(Rule::M4, 0)
    }

    /// The same, with so many components that have an edge (M5).
    #[must_use]
    pub const fn components(self, count: usize) -> Self {
        self.ask(Rule::M5, count)
    }

    /// The same, with so many border loops over all components (M6). A structure has them only if it is
    /// [`open`](Self::open). With 0 it asks for what [`closed`](Self::closed) asks for, but counts the loops and does not name
    /// half-edges.
    #[must_use]
    pub const fn borders(self, count: usize) -> Self {
        self.ask(Rule::M6, count)
    }

    /// The same, with this genus, added up over all components (M7): how many handles there are.
    #[must_use]
    pub const fn genus(self, genus: usize) -> Self {
        self.ask(Rule::M7, genus)
    }

    /// The same, and a vertex on the border keeps a half-edge of the border (M8): one without face, or, where the edges of the
    /// border have one half-edge only, one without twin. Libraries that tell a border vertex by the half-edge that it keeps rely
    /// on this.
    ///
    /// ```
    /// use twinedge::validate::{Collect, Expectation, Table, Violation, validate};
    /// // A triangle of which the twins 3, 4 and 5 have no face. Vertex 0 keeps half-edge 0, which has one.
    /// let table: Table = "P 3 prev leaving faces V 3 0 - 3 - 4 - H 6 0 3 1 2 - 1 4 2 0 - 2 5 0 1 - 1 0 5 4 - 2 1 3 5 - 0 2 4 3 - B 0 F 1 - 0 \
    ///     HF 6 0 0 0 - - - FH 1 0 0".parse()?;
    /// let expectation = Expectation::surface().open();
    /// assert!(validate(&table, &expectation, Collect::All).is_valid());
    /// let report = validate(&table, &expectation.border_kept(), Collect::All);
    /// assert_eq!(report.violations(), [Violation::KeptInside { vertex: 0, half_edge: 0, border: 5 }]);
    /// # Ok::<(), twinedge::validate::ParseTableError>(())
    /// ```
    #[must_use]
    pub const fn border_kept(self) -> Self {
        self.ask(Rule::M8, 0)
    }

    const fn ask(mut self, rule: Rule, number: usize) -> Self {
        self.asked |= Self::bit(rule);
        if let Some(place) = Self::place(rule) {
            self.numbers[place] = number;
        }
        self
    }

    /// The bit of an optional rule.
    const fn bit(rule: Rule) -> u32 {
        1 << (rule.index() - Rule::M1.index())
    }

    /// Returns the place of the number of a rule, if it has one.
    const fn place(rule: Rule) -> Option<usize> {
        match rule {
            Rule::M3 => Some(0),
            Rule::M5 => Some(1),
            Rule::M6 => Some(2),
            Rule::M7 => Some(3),
            _ => None,
        }
    }

    /// True if the rule is asked for. A rule that is not [optional](Rule::is_optional) always is.
    ///
    /// ```
    /// use twinedge::validate::{Expectation, Rule};
    /// let expectation = Expectation::surface().sides(4);
    /// assert!(expectation.asks_for(Rule::M3) && !expectation.asks_for(Rule::M7));
    /// assert_eq!(expectation.expected_count(Rule::M3), Some(4));
    /// ```
    #[must_use]
    pub const fn asks_for(&self, rule: Rule) -> bool {
        !rule.is_optional() || self.asked & Self::bit(rule) != 0
    }

    /// The number that M3, M5, M6 or M7 is asked to find; `None` if it is not asked for, and for all other rules.
    #[must_use]
    pub const fn expected_count(&self, rule: Rule) -> Option<usize> {
        match Self::place(rule) {
            Some(place) if self.asks_for(rule) => Some(self.numbers[place]),
            _ => None,
        }
    }

    /// The surface on which the structure is to lie.
    #[must_use]
    pub const fn surface_kind(&self) -> Surface {
        self.surface
    }

    /// True if open boundaries are legal.
    #[must_use]
    pub const fn is_open(&self) -> bool {
        self.open
    }

    /// The parts that are looked at, of those that a structure stores: all in the plane; on surfaces no lists of holes, and no
    /// unbounded face.
    #[must_use]
    pub const fn looks_at(&self, stored: Parts) -> Parts {
        match self.surface {
            Surface::Plane => stored,
            Surface::Any => stored.without(Part::Holes),
        }
    }
}

/// Every optional rule has a bit, and the numbers of rules have places.
const _: () = {
    let mut i = 0;
    while i < Rule::ALL.len() {
        assert!(matches!(Expectation::place(Rule::ALL[i]), None | Some(0..NUMBERS)));
        assert!(!Rule::ALL[i].is_optional() || Rule::ALL[i].index() - Rule::M1.index() < u32::BITS as usize);
        i += 1;
    }
};
