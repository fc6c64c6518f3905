//! Violations in words: a sentence each, that says what is wrong and why it matters.

use super::record::{Field, Record};
use super::view::{BoundaryPlace, Link};
use super::violation::Violation;
use super::words::Number;
use core::fmt;

/// A link in words.
struct LinkText(Link);

impl fmt::Display for LinkText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(i) => write!(f, "{i}"),
            None => f.write_str("nil"),
        }
    }
}

/// A boundary component in words: by its own record, or by the half-edge or vertex by which its face lists it.
struct BoundaryText(&'static str, Record);

impl fmt::Display for BoundaryText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(kind, record) = self;
        match record {
            Record::Boundary(b) => write!(f, "the {kind} boundary component {b}"),
            at => write!(f, "the {kind} boundary component at {at}"),
        }
    }
}

/// A place in words.
struct PlaceText(Option<BoundaryPlace>);

impl fmt::Display for PlaceText {
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
            V::Nil { record, field } => write!(f, "the {field} of {record} is nil, but the record needs one"),
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
                LinkText(found)
            ),
            V::PrevOfNext { half_edge, next, found } => write!(
                f,
                "half-edge {half_edge} has next {next}, whose prev is {found}: a walk back along the cycle leaves it"
            ),
            V::NextOfPrev { half_edge, prev, found } => write!(
                f,
                "half-edge {half_edge} has prev {prev}, whose next is {found}: a walk along the cycle leaves it"
            ),
            V::NextShared { first, second, next } => {
                write!(f, "half-edges {first} and {second} both have next {next}, so one of their cycles never closes")
            }
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
                 leave it: several fans share the vertex, and no walk around it reaches them all"
            ),
            V::BoundaryChanges { half_edge, next, boundary, found } => write!(
                f,
                "half-edge {half_edge} belongs to boundary component {}, its next {next} to {}: one cycle belongs to two boundary components",
                LinkText(boundary),
                LinkText(found)
            ),
            V::StartElsewhere { boundary, half_edge, found } => write!(
                f,
                "boundary component {boundary} starts at half-edge {half_edge}, which belongs to {}: a walk along it is a walk along another one",
                LinkText(found)
            ),
            V::SecondCycle { boundary, cycle, half_edges } => write!(
                f,
                "boundary component {boundary} has {}, but the cycle of its start has {cycle}: the others lie on a cycle at which no \
                 boundary component starts",
                Number(half_edges as u64, "half-edge", "half-edges")
            ),
            V::FaceChanges { half_edge, next, face, found } => write!(
                f,
                "half-edge {half_edge} bounds face {}, its next {next} bounds {}: the face changes along one cycle",
                LinkText(face),
                LinkText(found)
            ),
            V::ListedElsewhere { face, half_edge, found } => write!(
                f,
                "face {face} lists half-edge {half_edge}, which bounds face {}: a walk around the one is a walk around the other",
                LinkText(found)
            ),
            V::IsolatedUnclaimed { vertex } => write!(
                f,
                "no half-edge leaves vertex {vertex} and no boundary component starts at it: no walk over the faces reaches it"
            ),
            V::IsolatedTwice { vertex, first, second } => write!(
                f,
                "{first} and {second} both start at isolated vertex {vertex}, so the vertex lies in two places at once"
            ),
            V::StartsAtConnected { record, vertex } => {
                write!(f, "{record} starts at vertex {vertex} as if it were isolated, but half-edges leave it")
            }
            V::IsolatedMismatch { vertex, boundary, found } => write!(
                f,
                "boundary component {boundary} starts at isolated vertex {vertex}, which names {} instead: its face is not determined",
                LinkText(found)
            ),
            V::ConnectedNamesBoundary { vertex, boundary } => write!(
                f,
                "vertex {vertex} names boundary component {boundary} as if it were isolated, but half-edges leave it"
            ),
            V::NoUnboundedFace => f.write_str(
                "every face has an outer boundary component, but one face of a plane is unbounded and has none",
            ),
            V::SecondUnboundedFace { first, second } => write!(
                f,
                "faces {first} and {second} both have no outer boundary component, but only one face of a plane is unbounded"
            ),
            V::NoOuter { face } => {
                write!(
                    f,
                    "face {face} has no outer boundary component, but every face of this structure needs one: `outer` (or, without \
                     boundary component records, `outer_half_edge`) is nil"
                )
            }
            V::OuterIsVertex { face, boundary } => write!(
                f,
                "the outer boundary component {boundary} of face {face} is an isolated vertex, which encloses nothing"
            ),
            V::NotListed { boundary, face } => write!(
                f,
                "boundary component {boundary} names face {}, but no face lists it: a walk over the faces never reaches it",
                LinkText(face)
            ),
            V::CycleNotListed { half_edge } => {
                write!(f, "no face lists the cycle of half-edge {half_edge}: a walk over the faces never reaches it")
            }
            V::ListedTwice { record, face } => {
                write!(f, "face {face} lists {record}, which was listed before: a walk over the faces reaches it twice")
            }
            V::ListedByOther { boundary, face, found } => write!(
                f,
                "face {face} lists boundary component {boundary}, which names face {}: the two directions disagree",
                LinkText(found)
            ),
            V::WrongPlace { boundary, place, listed } => write!(
                f,
                "boundary component {boundary} says that it is {}, but its face lists it as {}: to remove it would remove another one",
                PlaceText(place),
                PlaceText(Some(listed))
            ),
            V::ListTooLong { face, claimed } => write!(
                f,
                "face {face} claims {claimed} inner boundary components, far more than there can be: the lists were not read to the end"
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
                 no path leads from it out to the unbounded face"
            ),
            V::Genus { vertex, vertices, edges, cycles, genus } => write!(
                f,
                "the component of vertex {vertex} has V − E + cycles = {vertices} − {edges} + {cycles}, genus {genus}: it can \
                 only be drawn on a surface with {}, not in the plane",
                Number(genus as u64, "handle", "handles")
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
                "the map is simple and has {faces} faces on {vertices} vertices, more than 2V − 4 = {}: some face has no boundary of its own",
                vertices.saturating_mul(2).saturating_sub(4)
            ),
            V::UnusedVertex { vertex } => {
                write!(f, "no half-edge leaves vertex {vertex}: no edge and no face uses it")
            }
            V::LoopEdge { half_edge, vertex } => {
                write!(f, "half-edge {half_edge} starts and ends at vertex {vertex}: its edge is a loop")
            }
            V::ParallelEdges { first, second, vertices: [u, v] } => write!(
                f,
                "half-edges {first} and {second} belong to two edges that both join vertices {u} and {v}: the ends do not tell \
                 which edge is meant"
            ),
            V::WrongSides { record: Record::HalfEdge(h), sides, expected } => write!(
                f,
                "the cycle of half-edge {h} has {}, where {expected} are expected",
                Number(sides as u64, "side", "sides")
            ),
            V::WrongSides { record, sides, expected } => {
                write!(f, "{record} has {}, where {expected} are expected", Number(sides as u64, "side", "sides"))
            }
            V::OnBorder { half_edge, vertices: [u, v], lacks } => {
                let lack = if lacks == Field::Twin { "has no twin" } else { "bounds no face" };
                write!(
                    f,
                    "half-edge {half_edge}, from vertex {u} to vertex {v}, {lack}: the surface has a border there"
                )
            }
            V::WrongComponents { found, expected } => write!(
                f,
                "the structure has {} with an edge, where {expected} are expected",
                Number(found as u64, "component", "components")
            ),
            V::WrongBorders { found, expected } => write!(
                f,
                "the structure has {}, where {expected} are expected",
                Number(found as u64, "border loop", "border loops")
            ),
            V::WrongGenus { found, expected } => {
                write!(f, "the components have genus {found} together, where {expected} is expected")
            }
            V::NotFinite { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is not finite, or out of range")
            }
            V::ZeroLength { half_edge } => {
                write!(f, "half-edge {half_edge} starts and ends at the same point: it has no direction")
            }
            V::OutOfOrder { vertex, half_edge, found } => write!(
                f,
                "at vertex {vertex}, half-edge {found} follows half-edge {half_edge} in the rotation, but another lies between: \
                 the coordinates and the links disagree"
            ),
            V::OuterClockwise { boundary } => {
                write!(f, "{} turns clockwise, so its face would lie outside it", BoundaryText("outer", boundary))
            }
            V::InnerCounterClockwise { boundary } => {
                write!(
                    f,
                    "{} turns counter-clockwise, so its face would lie inside it",
                    BoundaryText("inner", boundary)
                )
            }
            V::Cross { first, second } => {
                write!(f, "half-edges {first} and {second} cross where no vertex is: the map is not plane")
            }
            V::Touch { vertex, half_edge } => {
                write!(f, "vertex {vertex} lies inside half-edge {half_edge}, which does not end there")
            }
            V::Overlap { first, second } => {
                write!(f, "half-edges {first} and {second} overlap: they have more than a point in common")
            }
            V::SamePlace { first, second } => {
                write!(f, "vertices {first} and {second} lie at the same point but are not joined")
            }
            V::WrongFace { boundary, face, found } => {
                write!(f, "{} is listed by face {face}, but lies in ", BoundaryText("inner", boundary))?;
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
