//! What a structure is held to: the surface on which it lies, the parts that it has, and what is asked for beyond that.

use super::rule::Rule;

/// A part that a structure may lack. Rules about a part that it lacks are not checked, and the report says so.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Part {
    /// `prev` links.
    Prev,
    /// A half-edge kept by each vertex.
    Leaving,
    /// Faces. Without them the structure is a combinatorial map: B and F do not apply.
    Faces,
    /// Records for boundary components. Without them half-edges name their face and faces name half-edges.
    BoundaryComponents,
    /// The place of a boundary component in the list of its face, as stored in the boundary component.
    Places,
    /// Lists of inner boundary components. Without them each face has one cycle, as in a mesh, and containment (T1, T2)
    /// is not represented. Nor is where an isolated vertex lies: `isolated` is not read, and B2 is not checked.
    Holes,
    /// The one face without outer boundary component. Without it, a component that lies outside all others lies in no
    /// face: it has no inner boundary component, and if it is an isolated vertex, no boundary component starts there.
    UnboundedFace,
}

impl Part {
    const fn bit(self) -> u8 {
        1 << self as u8
    }

    /// The name of the part, without article.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Prev => "prev links",
            Self::Leaving => "leaving half-edges",
            Self::Faces => "faces",
            Self::BoundaryComponents => "boundary component records",
            Self::Places => "places in the list of the face",
            Self::Holes => "lists of inner boundary components",
            Self::UnboundedFace => "unbounded face",
        }
    }
}

/// The surface on which the structure is to lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Surface {
    /// The plane: every component has genus 0 and containment is a tree rooted at the unbounded face.
    Plane,
    /// Orientable surfaces of any genus, one per component.
    Any,
}

/// What a structure is held to.
///
/// ```
/// use twinedge::validate::{Expectation, Part};
/// // A triangle mesh: no holes in faces, no unbounded face, a border whose half-edges have no face or no twin.
/// let mesh = Expectation::surface().without(Part::BoundaryComponents).without(Part::Prev).open();
/// assert!(!mesh.has(Part::Prev));
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
/// What most programs that work with triangle meshes take for granted is
/// `surface().without(Part::BoundaryComponents).no_unused_vertices().simple().triangles()`, with `.open().borders(n)` for a mesh with
/// `n` border loops. M8 is a promise of some libraries, and no more usual than its absence.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Expectation {
    surface: Surface,
    open: bool,
    lacks: u8,
    /// A bit for each of M1 … M8 that is asked for.
    asked: u8,
    /// The numbers of M3, M5, M6 and M7; 0 where they are not asked for.
    numbers: [usize; 4],
}

impl Expectation {
    /// A planar subdivision with every part.
    #[must_use]
    pub const fn plane() -> Self {
        Self { surface: Surface::Plane, open: false, lacks: 0, asked: 0, numbers: [0; 4] }
    }

    /// A subdivision of closed orientable surfaces: no unbounded face, no holes in faces.
    #[must_use]
    pub const fn surface() -> Self {
        let lacks = Part::Holes.bit() | Part::UnboundedFace.bit();
        Self { surface: Surface::Any, open: false, lacks, asked: 0, numbers: [0; 4] }
    }

    /// The same, for a structure that lacks this part, and the parts that depend on it.
    #[must_use]
    pub const fn without(mut self, part: Part) -> Self {
        self.lacks |= part.bit();
        self.lacks |= match part {
            Part::Faces => {
                Part::BoundaryComponents.bit() | Part::Places.bit() | Part::Holes.bit() | Part::UnboundedFace.bit()
            }
            Part::BoundaryComponents => Part::Places.bit(),
            // An unbounded face has inner boundary components only.
            Part::Holes => Part::UnboundedFace.bit(),
            _ => 0,
        };
        self
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
    /// use twinedge::validate::{Collect, Expectation, Part, Table, Violation, validate};
    /// // A triangle of three half-edges.
    /// let table: Table = "V 3 0 - 1 - 2 - H 3 0 - 1 2 - 1 - 2 0 - 2 - 0 1 - B 0 F 1 - 0 HF 3 0 0 0 FH 1 0 0".parse()?;
    /// let expectation = Expectation::surface().without(Part::BoundaryComponents).open().closed();
    /// let report = validate(&table, &expectation, Collect::All);
    /// assert_eq!(report.violations().len(), 3);
    /// assert_eq!(
    ///     report.violations()[0].to_string(),
    ///     "half-edge 0, from vertex 0 to vertex 1, has no twin: the surface has a border there"
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
    /// use twinedge::validate::{Collect, Expectation, Part, Table, Violation, validate};
    /// // A triangle of which the twins 3, 4 and 5 have no face. Vertex 0 keeps half-edge 0, which has one.
    /// let table: Table = "V 3 0 - 3 - 4 - H 6 0 3 1 2 - 1 4 2 0 - 2 5 0 1 - 1 0 5 4 - 2 1 3 5 - 0 2 4 3 - B 0 F 1 - 0 \
    ///     HF 6 0 0 0 - - - FH 1 0 0".parse()?;
    /// let expectation = Expectation::surface().without(Part::BoundaryComponents).open();
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
    const fn bit(rule: Rule) -> u8 {
        1 << (rule.index() - Rule::M1.index())
    }

    /// Where the number of a rule is, if it has one.
    const fn place(rule: Rule) -> Option<usize> {
        match rule {
            Rule::M3 => Some(0),
            Rule::M5 => Some(1),
            Rule::M6 => Some(2),
            Rule::M7 => Some(3),
            _ => None,
        }
    }

    /// Whether the rule is asked for. A rule that is not [optional](Rule::is_optional) always is.
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

    /// Whether open boundaries are legal.
    #[must_use]
    pub const fn is_open(&self) -> bool {
        self.open
    }

    /// Whether the structure has this part.
    #[must_use]
    pub const fn has(&self, part: Part) -> bool {
        self.lacks & part.bit() == 0
    }
}
