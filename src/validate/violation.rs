//! Every way of breaking a rule, with the records involved.

use super::{BoundaryPlace, Link, Rule};
use core::fmt;

/// A record, by its kind and its index in the [`View`](super::View).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Record {
    /// A vertex.
    Vertex(usize),
    /// A half-edge.
    HalfEdge(usize),
    /// A boundary component.
    Boundary(usize),
    /// A face.
    Face(usize),
}

impl fmt::Display for Record {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vertex(i) => write!(f, "vertex {i}"),
            Self::HalfEdge(i) => write!(f, "half-edge {i}"),
            Self::Boundary(i) => write!(f, "boundary component {i}"),
            Self::Face(i) => write!(f, "face {i}"),
        }
    }
}

/// A field of a record that holds a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Field {
    /// `origin` of a half-edge.
    Origin,
    /// `twin` of a half-edge.
    Twin,
    /// `next` of a half-edge.
    Next,
    /// `prev` of a half-edge.
    Prev,
    /// `boundary` of a half-edge.
    Boundary,
    /// `face` of a half-edge or of a boundary component.
    Face,
    /// `leaving` of a vertex.
    Leaving,
    /// `isolated` of a vertex.
    Isolated,
    /// `start` of a boundary component.
    Start,
    /// `outer` of a face.
    Outer,
    /// The entry at this position of the inner list of a face.
    Inner(usize),
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Origin => "origin",
            Self::Twin => "twin",
            Self::Next => "next",
            Self::Prev => "prev",
            Self::Boundary => "boundary component",
            Self::Face => "face",
            Self::Leaving => "leaving half-edge",
            Self::Isolated => "isolated link",
            Self::Start => "start",
            Self::Outer => "outer boundary component",
            Self::Inner(i) => return write!(f, "inner boundary component at position {i}"),
        })
    }
}

/// One broken rule, with the records that break it. `Display` says in a sentence what is wrong and why it matters.
///
/// Numbers are the indices of the [`View`](super::View).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[allow(missing_docs, reason = "the fields are named after the design's words, and each variant says what they are")]
pub enum Violation {
    /// R1: a link that the record needs is nil.
    Nil { record: Record, field: Field },
    /// R1: a link leads past the end or to a vacant slot.
    Dangling { record: Record, field: Field, value: usize },
    /// R1: the faces up to this one list more than twice as many inner boundary components as there are, and 16. The rest of
    /// the lists was not read, so its links cannot be said to be live.
    ListTooLong { face: usize, claimed: usize },

    /// L1: a half-edge is its own twin.
    TwinIsSelf { half_edge: usize },
    /// L1: the twin's twin is another half-edge, or nil.
    TwinNotMutual { half_edge: usize, twin: usize, found: Link },
    /// L2: `prev(next(h))` is not `h`.
    PrevOfNext { half_edge: usize, next: usize, found: usize },
    /// L2: `next(prev(h))` is not `h`.
    NextOfPrev { half_edge: usize, prev: usize, found: usize },
    /// L2, for structures without `prev`: two half-edges have the same next.
    NextShared { first: usize, second: usize, next: usize },
    /// L3: the next half-edge starts elsewhere than at the target.
    Target { half_edge: usize, next: usize, target: usize, found: usize },

    /// V1: the half-edge kept by a vertex starts at another vertex.
    NotLeaving { vertex: usize, half_edge: usize, origin: usize },
    /// V2: the rotation does not reach all half-edges with that origin.
    SplitRotation { vertex: usize, half_edge: usize, reached: usize, degree: usize },

    /// B1: a half-edge and its next belong to different boundary components.
    BoundaryChanges { half_edge: usize, next: usize, boundary: Link, found: Link },
    /// B1: the start of a boundary component belongs to another one.
    StartElsewhere { boundary: usize, half_edge: usize, found: Link },
    /// B1: a boundary component has more half-edges than the cycle of its start.
    SecondCycle { boundary: usize, cycle: usize, half_edges: usize },
    /// B1, for structures without boundary components: a half-edge and its next name different faces.
    FaceChanges { half_edge: usize, next: usize, face: Link, found: Link },
    /// B1, for structures without boundary components: a face lists a half-edge that names another face.
    ListedElsewhere { face: usize, half_edge: usize, found: Link },
    /// B2: no boundary component starts at a vertex without half-edges.
    IsolatedUnclaimed { vertex: usize },
    /// B2: two boundary components start at one vertex.
    IsolatedTwice { vertex: usize, first: Record, second: Record },
    /// B2: a boundary component starts at a vertex that has half-edges.
    StartsAtConnected { record: Record, vertex: usize },
    /// B2: an isolated vertex names another boundary component than the one that starts at it.
    IsolatedMismatch { vertex: usize, boundary: usize, found: Link },
    /// B2: a vertex that has half-edges says that it is an isolated boundary component.
    ConnectedNamesBoundary { vertex: usize, boundary: usize },

    /// F1: every face has an outer boundary component.
    NoUnboundedFace,
    /// F1: two faces have no outer boundary component.
    SecondUnboundedFace { first: usize, second: usize },
    /// F1, where there is no unbounded face: a face without outer boundary component.
    NoOuter { face: usize },
    /// F1: the outer boundary component of a face is an isolated vertex.
    OuterIsVertex { face: usize, boundary: usize },
    /// F2: no face lists the boundary component.
    NotListed { boundary: usize, face: Link },
    /// F2, for structures without boundary components: no face lists the cycle of this half-edge.
    CycleNotListed { half_edge: usize },
    /// F2: a boundary component (or, without records for them, the cycle of this half-edge) is listed again.
    ListedTwice { record: Record, face: usize },
    /// F2: a boundary component is listed by another face than the one that it names.
    ListedByOther { boundary: usize, face: usize, found: Link },
    /// F2: a boundary component is listed at another place than it says.
    WrongPlace { boundary: usize, place: Option<BoundaryPlace>, listed: BoundaryPlace },

    /// T1: all boundary components of a component are outer.
    NoOutside { vertex: usize },
    /// T1: a component has two inner boundary components; these are where they start.
    TwoOutsides { vertex: usize, first: Record, second: Record },
    /// T2: a component lies, through others, inside itself.
    NestedInItself { vertex: usize, face: usize },
    /// T3: a component has handles.
    Genus { vertex: usize, vertices: usize, edges: usize, cycles: usize, genus: usize },
    /// T3: no surface has this Euler characteristic.
    NoSuchSurface { vertex: usize, vertices: usize, edges: usize, cycles: usize },
    /// T4: more edges than a simple planar map can have.
    TooManyEdges { vertices: usize, edges: usize },
    /// T4: more faces than a simple planar map can have.
    TooManyFaces { vertices: usize, faces: usize },

    /// G1: a coordinate is NaN or infinite, or out of the range of the exact predicates.
    NotFinite { vertex: usize },
    /// G1: both ends of an edge lie at the same point.
    ZeroLength { half_edge: usize },
    /// G2: `next` is not the next half-edge clockwise at the target.
    OutOfOrder { vertex: usize, half_edge: usize, found: usize },
    /// G3: an outer cycle turns clockwise.
    OuterClockwise { boundary: Record },
    /// G3: an inner cycle turns counter-clockwise.
    InnerCounterClockwise { boundary: Record },
    /// G4: two edges cross.
    Cross { first: usize, second: usize },
    /// G4: a vertex lies inside an edge.
    Touch { vertex: usize, half_edge: usize },
    /// G4: two edges have more than a point in common.
    Overlap { first: usize, second: usize },
    /// G4: two vertices lie at the same point.
    SamePlace { first: usize, second: usize },
    /// G5: an inner boundary component lies in another face than the one that lists it, or in none.
    WrongFace { boundary: Record, face: usize, found: Link },
    /// G5: a component without inner boundary component lies in a face, not outside everything.
    Unlisted { vertex: usize, face: usize },
}

impl Violation {
    /// The rule that is broken.
    #[must_use]
    pub const fn rule(&self) -> Rule {
        use Violation as V;
        match self {
            V::Nil { .. } | V::Dangling { .. } | V::ListTooLong { .. } => Rule::R1,
            V::TwinIsSelf { .. } | V::TwinNotMutual { .. } => Rule::L1,
            V::PrevOfNext { .. } | V::NextOfPrev { .. } | V::NextShared { .. } => Rule::L2,
            V::Target { .. } => Rule::L3,
            V::NotLeaving { .. } => Rule::V1,
            V::SplitRotation { .. } => Rule::V2,
            V::BoundaryChanges { .. }
            | V::StartElsewhere { .. }
            | V::SecondCycle { .. }
            | V::FaceChanges { .. }
            | V::ListedElsewhere { .. } => Rule::B1,
            V::IsolatedUnclaimed { .. }
            | V::IsolatedTwice { .. }
            | V::StartsAtConnected { .. }
            | V::IsolatedMismatch { .. }
            | V::ConnectedNamesBoundary { .. } => Rule::B2,
            V::NoUnboundedFace | V::SecondUnboundedFace { .. } | V::NoOuter { .. } | V::OuterIsVertex { .. } => {
                Rule::F1
            }
            V::NotListed { .. }
            | V::CycleNotListed { .. }
            | V::ListedTwice { .. }
            | V::ListedByOther { .. }
            | V::WrongPlace { .. } => Rule::F2,
            V::NoOutside { .. } | V::TwoOutsides { .. } => Rule::T1,
            V::NestedInItself { .. } => Rule::T2,
            V::Genus { .. } | V::NoSuchSurface { .. } => Rule::T3,
            V::TooManyEdges { .. } | V::TooManyFaces { .. } => Rule::T4,
            V::NotFinite { .. } | V::ZeroLength { .. } => Rule::G1,
            V::OutOfOrder { .. } => Rule::G2,
            V::OuterClockwise { .. } | V::InnerCounterClockwise { .. } => Rule::G3,
            V::Cross { .. } | V::Touch { .. } | V::Overlap { .. } | V::SamePlace { .. } => Rule::G4,
            V::WrongFace { .. } | V::Unlisted { .. } => Rule::G5,
        }
    }

    /// The records that are involved, the one at fault first; two at the most, none where the whole structure is meant.
    #[must_use]
    pub const fn records(&self) -> [Option<Record>; 2] {
        use Record::{Boundary as B, Face as F, HalfEdge as H, Vertex as X};
        use Violation as V;
        match *self {
            V::Nil { record, .. } | V::Dangling { record, .. } => [Some(record), None],
            V::TwinIsSelf { half_edge } | V::CycleNotListed { half_edge } | V::ZeroLength { half_edge } => {
                [Some(H(half_edge)), None]
            }
            V::TwinNotMutual { half_edge, twin, .. } => [Some(H(half_edge)), Some(H(twin))],
            V::PrevOfNext { half_edge, next, .. }
            | V::Target { half_edge, next, .. }
            | V::BoundaryChanges { half_edge, next, .. }
            | V::FaceChanges { half_edge, next, .. } => [Some(H(half_edge)), Some(H(next))],
            V::NextOfPrev { half_edge, prev, .. } => [Some(H(half_edge)), Some(H(prev))],
            V::NextShared { first, second, .. } | V::Cross { first, second } | V::Overlap { first, second } => {
                [Some(H(first)), Some(H(second))]
            }
            V::NotLeaving { vertex, half_edge, .. }
            | V::SplitRotation { vertex, half_edge, .. }
            | V::OutOfOrder { vertex, half_edge, .. }
            | V::Touch { vertex, half_edge } => [Some(X(vertex)), Some(H(half_edge))],
            V::StartElsewhere { boundary, half_edge, .. } => [Some(B(boundary)), Some(H(half_edge))],
            V::SecondCycle { boundary, .. } | V::WrongPlace { boundary, .. } | V::NotListed { boundary, .. } => {
                [Some(B(boundary)), None]
            }
            V::OuterClockwise { boundary } | V::InnerCounterClockwise { boundary } => [Some(boundary), None],
            V::ListedElsewhere { face, half_edge, .. } => [Some(F(face)), Some(H(half_edge))],
            V::IsolatedUnclaimed { vertex }
            | V::NoOutside { vertex }
            | V::TwoOutsides { vertex, .. }
            | V::Genus { vertex, .. }
            | V::NoSuchSurface { vertex, .. }
            | V::NotFinite { vertex } => [Some(X(vertex)), None],
            V::IsolatedTwice { vertex, second, .. } => [Some(X(vertex)), Some(second)],
            V::StartsAtConnected { record, vertex } => [Some(record), Some(X(vertex))],
            V::IsolatedMismatch { vertex, boundary, .. } | V::ConnectedNamesBoundary { vertex, boundary } => {
                [Some(X(vertex)), Some(B(boundary))]
            }
            V::SecondUnboundedFace { first, second } => [Some(F(second)), Some(F(first))],
            V::NoOuter { face } | V::ListTooLong { face, .. } => [Some(F(face)), None],
            V::OuterIsVertex { face, boundary } => [Some(F(face)), Some(B(boundary))],
            V::ListedTwice { record, face } => [Some(record), Some(F(face))],
            V::ListedByOther { boundary, face, .. } => [Some(B(boundary)), Some(F(face))],
            V::WrongFace { boundary, face, .. } => [Some(boundary), Some(F(face))],
            V::NestedInItself { vertex, face } | V::Unlisted { vertex, face } => [Some(X(vertex)), Some(F(face))],
            V::SamePlace { first, second } => [Some(X(first)), Some(X(second))],
            V::NoUnboundedFace | V::TooManyEdges { .. } | V::TooManyFaces { .. } => [None, None],
        }
    }
}

/// A link in words.
struct Shown(Link);

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(i) => write!(f, "{i}"),
            None => f.write_str("nil"),
        }
    }
}

/// A boundary component in words: by its own record, or by the half-edge or vertex by which its face lists it.
struct Named(&'static str, Record);

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(kind, record) = self;
        match record {
            Record::Boundary(b) => write!(f, "the {kind} boundary component {b}"),
            at => write!(f, "the {kind} boundary component at {at}"),
        }
    }
}

/// A place in words.
struct ShownPlace(Option<BoundaryPlace>);

impl fmt::Display for ShownPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(BoundaryPlace::Outer) => f.write_str("the outer one"),
            Some(BoundaryPlace::Inner(i)) => write!(f, "inner position {i}"),
            None => f.write_str("no place"),
        }
    }
}

impl fmt::Display for Violation {
    #[allow(clippy::too_many_lines, reason = "one sentence per variant, together so that they read alike")]
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use Violation as V;
        match *self {
            V::Nil { record, field } => write!(f, "{record} has no {field}, so what hangs on it cannot be reached"),
            V::Dangling { record, field, value } => {
                write!(
                    f,
                    "the {field} of {record} is {value}, which is no live record: following it reads something else"
                )
            }
            V::TwinIsSelf { half_edge } => {
                write!(f, "half-edge {half_edge} is its own twin, so its edge has one side only")
            }
            V::TwinNotMutual { half_edge, twin, found } => write!(
                f,
                "half-edge {half_edge} has twin {twin}, whose twin is {}: the two sides disagree about their edge",
                Shown(found)
            ),
            V::PrevOfNext { half_edge, next, found } => write!(
                f,
                "half-edge {half_edge} has next {next}, whose prev is {found}: walking back along the cycle goes astray"
            ),
            V::NextOfPrev { half_edge, prev, found } => write!(
                f,
                "half-edge {half_edge} has prev {prev}, whose next is {found}: walking on along the cycle goes astray"
            ),
            V::NextShared { first, second, next } => write!(
                f,
                "half-edges {first} and {second} both have next {next}, so their cycles run into each other and one never closes"
            ),
            V::Target { half_edge, next, target, found } => write!(
                f,
                "half-edge {half_edge} ends at vertex {target}, but its next {next} starts at vertex {found}: the cycle jumps"
            ),
            V::NotLeaving { vertex, half_edge, origin } => write!(
                f,
                "vertex {vertex} keeps half-edge {half_edge}, which leaves vertex {origin}: its rotation is that of another vertex"
            ),
            V::SplitRotation { vertex, half_edge, reached, degree } => write!(
                f,
                "from half-edge {half_edge} the rotation of vertex {vertex} reaches {reached} of the {degree} half-edges that \
                 leave it: several fans share the vertex and no walk around it sees them all"
            ),
            V::BoundaryChanges { half_edge, next, boundary, found } => write!(
                f,
                "half-edge {half_edge} belongs to boundary component {}, its next {next} to {}: one cycle has two owners",
                Shown(boundary),
                Shown(found)
            ),
            V::StartElsewhere { boundary, half_edge, found } => write!(
                f,
                "boundary component {boundary} starts at half-edge {half_edge}, which belongs to {}: walking it walks another",
                Shown(found)
            ),
            V::SecondCycle { boundary, cycle, half_edges } => write!(
                f,
                "boundary component {boundary} has {half_edges} half-edges, but the cycle of its start has {cycle}: the others \
                 lie on a cycle that nobody starts at"
            ),
            V::FaceChanges { half_edge, next, face, found } => write!(
                f,
                "half-edge {half_edge} bounds face {}, its next {next} bounds {}: the face changes along one cycle",
                Shown(face),
                Shown(found)
            ),
            V::ListedElsewhere { face, half_edge, found } => write!(
                f,
                "face {face} lists half-edge {half_edge}, which bounds face {}: walking one face walks another",
                Shown(found)
            ),
            V::IsolatedUnclaimed { vertex } => write!(
                f,
                "no half-edge leaves vertex {vertex} and no boundary component starts at it: no face knows that it is there"
            ),
            V::IsolatedTwice { vertex, first, second } => write!(
                f,
                "{first} and {second} both start at isolated vertex {vertex}, so it would lie in two places at once"
            ),
            V::StartsAtConnected { record, vertex } => {
                write!(f, "{record} starts at vertex {vertex} as if it were isolated, but half-edges leave it")
            }
            V::IsolatedMismatch { vertex, boundary, found } => write!(
                f,
                "boundary component {boundary} starts at isolated vertex {vertex}, which names {} instead: its face cannot be told",
                Shown(found)
            ),
            V::ConnectedNamesBoundary { vertex, boundary } => write!(
                f,
                "vertex {vertex} says that it is the isolated boundary component {boundary}, but half-edges leave it"
            ),
            V::NoUnboundedFace => f.write_str(
                "every face has an outer boundary component, so nothing is outside: a plane has one unbounded face",
            ),
            V::SecondUnboundedFace { first, second } => write!(
                f,
                "faces {first} and {second} both have no outer boundary component, but only one face of a plane is unbounded"
            ),
            V::NoOuter { face } => write!(f, "face {face} has no boundary, so it cannot be walked"),
            V::OuterIsVertex { face, boundary } => write!(
                f,
                "the outer boundary component {boundary} of face {face} is an isolated vertex, which encloses nothing"
            ),
            V::NotListed { boundary, face } => write!(
                f,
                "boundary component {boundary} names face {}, but no face lists it: walking the faces never meets it",
                Shown(face)
            ),
            V::CycleNotListed { half_edge } => {
                write!(f, "no face lists the cycle of half-edge {half_edge}: walking the faces never meets it")
            }
            V::ListedTwice { record, face } => {
                write!(f, "face {face} lists {record}, which was listed before: walking the faces meets it twice")
            }
            V::ListedByOther { boundary, face, found } => write!(
                f,
                "face {face} lists boundary component {boundary}, which names face {}: the two directions disagree",
                Shown(found)
            ),
            V::WrongPlace { boundary, place, listed } => write!(
                f,
                "boundary component {boundary} says that it is {}, but its face lists it as {}: taking it out would take another",
                ShownPlace(place),
                ShownPlace(Some(listed))
            ),
            V::ListTooLong { face, claimed } => write!(
                f,
                "face {face} claims {claimed} inner boundary components, more than there are: the lists were not read to the end"
            ),
            V::NoOutside { vertex } => write!(
                f,
                "the component of vertex {vertex} has only outer boundary components, so it lies in no face at all"
            ),
            V::TwoOutsides { vertex, first, second } => write!(
                f,
                "the component of vertex {vertex} has two inner boundary components, at {first} and at {second}: it would lie \
                 in two faces at once"
            ),
            V::NestedInItself { vertex, face } => write!(
                f,
                "the component of vertex {vertex} lies in face {face}, which lies, through others, inside that component: \
                 nothing joins it to the unbounded face"
            ),
            V::Genus { vertex, vertices, edges, cycles, genus } => write!(
                f,
                "the component of vertex {vertex} has V − E + cycles = {vertices} − {edges} + {cycles}, genus {genus}: it can \
                 only be drawn on a surface with {genus} handle(s), not in the plane"
            ),
            V::NoSuchSurface { vertex, vertices, edges, cycles } => write!(
                f,
                "the component of vertex {vertex} has V − E + cycles = {vertices} − {edges} + {cycles}, which no orientable \
                 surface has"
            ),
            V::TooManyEdges { vertices, edges } => write!(
                f,
                "the map is simple and has {edges} edges on {vertices} vertices, more than 3V − 6 = {}: it is not planar",
                vertices.saturating_mul(3).saturating_sub(6)
            ),
            V::TooManyFaces { vertices, faces } => write!(
                f,
                "the map is simple and has {faces} faces on {vertices} vertices, more than 2V − 4 = {}: some face bounds nothing",
                vertices.saturating_mul(2).saturating_sub(4)
            ),
            V::NotFinite { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is not finite or out of range: it lies nowhere")
            }
            V::ZeroLength { half_edge } => {
                write!(f, "half-edge {half_edge} starts and ends at the same point: it has no direction")
            }
            V::OutOfOrder { vertex, half_edge, found } => write!(
                f,
                "at vertex {vertex}, half-edge {found} follows half-edge {half_edge} in the rotation, but another lies between: \
                 the drawing and the links disagree"
            ),
            V::OuterClockwise { boundary } => {
                write!(f, "{} turns clockwise, so its face would lie outside it", Named("outer", boundary))
            }
            V::InnerCounterClockwise { boundary } => {
                write!(f, "{} turns counter-clockwise, so its face would lie inside it", Named("inner", boundary))
            }
            V::Cross { first, second } => {
                write!(f, "half-edges {first} and {second} cross where no vertex is: the map is not plane")
            }
            V::Touch { vertex, half_edge } => {
                write!(f, "vertex {vertex} lies inside half-edge {half_edge}, which does not end there")
            }
            V::Overlap { first, second } => {
                write!(f, "half-edges {first} and {second} overlap: what lies between them is no face")
            }
            V::SamePlace { first, second } => {
                write!(f, "vertices {first} and {second} lie at the same point but are not joined")
            }
            V::WrongFace { boundary, face, found } => {
                write!(f, "{} is listed by face {face}, but lies in ", Named("inner", boundary))?;
                match found {
                    Some(found) => write!(f, "face {found}"),
                    None => f.write_str("no face"),
                }
            }
            V::Unlisted { vertex, face } => {
                write!(f, "the component of vertex {vertex} lies in face {face}, which does not list it")
            }
        }
    }
}
