//! The faults that only a topology of PostGIS can have.

use super::error::TableName;
use super::ewkb::kind_name;
use std::fmt;
use twinedge_diagnosis::{Diagnosis, Kind, Records};

macro_rules! findings {
    ($($rule:literal $variant:ident { $($field:ident: $type:ty),+ } $kind:literal
        says ($($says:tt)+) $what:literal
        cause $cause:literal remedy $remedy:literal;)*) => {
        /// One broken rule P0 … P4, with the ids of the database. `Display` states the fault in a sentence.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        #[allow(missing_docs, reason = "the fields are named after tables and columns, and each variant says what they are")]
        pub enum Finding {
            $(#[doc = concat!($rule, ": ", $what)] $variant { $($field: $type),+ },)*
        }

        impl Finding {
            /// Returns the rule: `P0` and so on.
            #[must_use]
            pub const fn rule(&self) -> &'static str {
                match self { $(Self::$variant { .. } => $rule,)* }
            }

            /// Returns the name of the finding, in snake case. Names do not change between versions.
            #[must_use]
            pub const fn kind(&self) -> &'static str {
                match self { $(Self::$variant { .. } => $kind,)* }
            }

            /// Returns the usual cause.
            #[must_use]
            pub const fn cause(&self) -> &'static str {
                match self { $(Self::$variant { .. } => $cause,)* }
            }

            /// Returns the remedy.
            #[must_use]
            pub const fn remedy(&self) -> &'static str {
                match self { $(Self::$variant { .. } => $remedy,)* }
            }
        }

        impl fmt::Display for Finding {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match *self { $(Self::$variant { $($field),+ } => write!(f, $($says)+),)* }
            }
        }
    };
}

findings! {
    "P0" IdMissing { table: TableName, row: u64 } "id_missing"
        says ("row {row} of table {table} has no id")
        "a row has no id. It is left out. Rows are counted from 1 in the order of the stream."
        cause "the primary key was dropped" remedy "delete the row, or give it an id, and restore the primary key";
    "P0" IdRepeated { table: TableName, id: i64 } "id_repeated"
        says ("two rows of table {table} have the id {id}")
        "two rows have the same id. The second is left out."
        cause "the primary key was dropped, or its index is corrupt" remedy "delete one of the rows, and restore the primary key";
    "P0" EdgeIdNotPositive { edge: i64 } "edge_id_not_positive"
        says ("edge {edge} has an id that is not positive")
        "the id of an edge is 0 or negative, so a sign cannot say which side is meant. The edge is left out."
        cause "ids were assigned by hand, or the sequence was reset" remedy "give the edge a new id, and change what refers to it";
    "P1" NodeWithoutPoint { node: i64 } "node_without_point"
        says ("node {node} has no point")
        "the geometry of a node is null, or a point without coordinates."
        cause "the column was updated by an expression that is null" remedy "set it to the end of an edge of the node";
    "P1" NodeNotPoint { node: i64, geometry: u32 } "node_not_point"
        says ("the geometry of node {node} is {}, no point", kind_name(geometry))
        "the geometry of a node is of another type."
        cause "the type of the column was changed" remedy "set it to the end of an edge of the node";
    "P1" EdgeWithoutCurve { edge: i64 } "edge_without_curve"
        says ("edge {edge} has no line of two points or more")
        "the geometry of an edge is null, or has fewer than two points."
        cause "the column was updated by an expression that is null" remedy "restore the line, or remove the edge by `ST_RemEdgeModFace`";
    "P1" EdgeNotCurve { edge: i64, geometry: u32 } "edge_not_curve"
        says ("the geometry of edge {edge} is {}, no line", kind_name(geometry))
        "the geometry of an edge is no line."
        cause "the type of the column was changed" remedy "restore the line";
    "P1" StartsElsewhere { edge: i64, node: i64 } "starts_elsewhere"
        says ("the line of edge {edge} starts elsewhere than at its start node {node}")
        "the line of an edge does not start at its start node."
        cause "a line or a node was moved by a plain UPDATE, or the line was reversed" remedy "use `ST_ChangeEdgeGeom` and `ST_MoveIsoNode`";
    "P1" EndsElsewhere { edge: i64, node: i64 } "ends_elsewhere"
        says ("the line of edge {edge} ends elsewhere than at its end node {node}")
        "the line of an edge does not end at its end node."
        cause "a line or a node was moved by a plain UPDATE, or the line was reversed" remedy "use `ST_ChangeEdgeGeom` and `ST_MoveIsoNode`";
    "P1" OtherReferenceSystem { table: TableName, id: i64, srid: u32, first: u32 } "other_reference_system"
        says ("{} of {table} {id} has the reference system {srid}, where the first geometry has {first}", geometry_column(table))
        "a geometry has another reference system than the first one of the topology."
        cause "a geometry was written without `ST_Transform`" remedy "transform it, or set the number by `ST_SetSRID` if only that is wrong";
    "P2" ConnectedHasContainingFace { node: i64, face: i64 } "connected_has_containing_face"
        says ("node {node} has edges, but its containing_face is {face} instead of null")
        "a node with edges has a `containing_face`."
        cause "an edge was inserted by hand at an isolated node" remedy "set `containing_face` to null";
    "P2" NoSuchContainingFace { node: i64, face: i64 } "no_such_containing_face"
        says ("the containing_face of node {node} is {face}, and there is no such face with edges")
        "the `containing_face` of a node is no face."
        cause "the face was deleted, with its foreign key switched off" remedy "set it to the result of `GetFaceContainingPoint`";
    "P2" LiesElsewhere { node: i64, face: i64, lies_in: Option<i64> } "lies_elsewhere"
        says ("node {node} {} by the lines around it, and its containing_face is {face}", lies(face, lies_in))
        "a node does not lie in its `containing_face`, by the lines and the faces that these name. It is reported where links are broken; otherwise G5 says so."
        cause "`containing_face` was set by hand, or not updated with the edges around it" remedy "set it to the result of `GetFaceContainingPoint`";
    "P3" FaceWithoutEdges { face: i64 } "face_without_edges"
        says ("no edge names face {face} as its left or right face")
        "no edge names the face."
        cause "a face was inserted by hand, or its edges were relabelled" remedy "delete the row, or restore `left_face` and `right_face` of its edges";
    "P4" MbrMissing { face: i64 } "mbr_missing"
        says ("the mbr of face {face} is null")
        "the `mbr` of a face is null."
        cause "the row was inserted by hand" remedy "set it to `ST_Envelope(ST_GetFaceGeometry(topology, face))`";
    "P4" MbrNotBox { face: i64 } "mbr_not_box"
        says ("the mbr of face {face} is no rectangle along the axes")
        "the `mbr` of a face is no rectangle along the axes."
        cause "the column was updated by hand" remedy "set it to `ST_Envelope(ST_GetFaceGeometry(topology, face))`";
    "P4" MbrWrong { face: i64 } "mbr_wrong"
        says ("the mbr of face {face} is not the box around its edges")
        "the `mbr` of a face is not the box around the edges that name it."
        cause "an edge was moved, and the column was not updated" remedy "set it to `ST_Envelope(ST_GetFaceGeometry(topology, face))`";
    "P4" UniverseHasMbr { face: i64 } "universe_has_mbr"
        says ("the mbr of face {face}, which has no outside, is not null")
        "the `mbr` of face 0 is not null."
        cause "the column of all faces was updated" remedy "set it to null";
    "P4" AbsNextDiffers { edge: i64, column: TopologyColumn, found: Option<i64> } "abs_next_differs"
        says ("{column} of edge {edge} is {}, not the absolute value of the link beside it", or_null(found))
        "an `abs_next_…` column is not the absolute value of the column that it belongs to."
        cause "a link was updated, and the column beside it was not" remedy "set it to `abs(next_left_edge)` or `abs(next_right_edge)`";
}

/// A column that keeps the absolute value of another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are those of the columns")]
pub enum TopologyColumn {
    AbsNextLeftEdge,
    AbsNextRightEdge,
}

impl fmt::Display for TopologyColumn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::AbsNextLeftEdge => "abs_next_left_edge",
            Self::AbsNextRightEdge => "abs_next_right_edge",
        })
    }
}

fn geometry_column(table: TableName) -> &'static str {
    if table == TableName::Face { "mbr" } else { "geom" }
}

fn lies(face: i64, lies_in: Option<i64>) -> String {
    lies_in.map_or_else(|| format!("does not lie in face {face}"), |other| format!("lies in face {other}"))
}

fn or_null(value: Option<i64>) -> String {
    value.map_or_else(|| "null".to_owned(), |value| value.to_string())
}

impl Finding {
    pub(super) const fn edge(&self) -> Option<i64> {
        match *self {
            Self::EdgeWithoutCurve { edge }
            | Self::EdgeNotCurve { edge, .. }
            | Self::StartsElsewhere { edge, .. }
            | Self::EndsElsewhere { edge, .. }
            | Self::AbsNextDiffers { edge, .. }
            | Self::EdgeIdNotPositive { edge } => Some(edge),
            _ => None,
        }
    }

    /// Returns the record of the finding, by its table and its id.
    pub(super) fn record(&self) -> Option<String> {
        match *self {
            Self::NodeWithoutPoint { node }
            | Self::NodeNotPoint { node, .. }
            | Self::ConnectedHasContainingFace { node, .. }
            | Self::NoSuchContainingFace { node, .. }
            | Self::LiesElsewhere { node, .. } => Some(format!("node {node}")),
            Self::FaceWithoutEdges { face }
            | Self::MbrMissing { face }
            | Self::MbrNotBox { face }
            | Self::MbrWrong { face }
            | Self::UniverseHasMbr { face } => Some(format!("face {face}")),
            Self::IdRepeated { table, id } | Self::OtherReferenceSystem { table, id, .. } => {
                Some(format!("{table} {id}"))
            }
            _ => self.edge().map(|edge| format!("edge {edge}")),
        }
    }
}

/// The findings: the number for each rule, and the kept ones.
#[derive(Clone, Debug, Default)]
pub(super) struct Findings {
    pub(super) kept: Vec<Finding>,
    pub(super) counts: [u64; 5],
    cap: usize,
}

/// The rules: id, name, unit, statement.
pub(super) const RULES: [[&str; 4]; 5] = [
    ["P0", "ids", "rows", "ids are there and unique, and those of edges are positive"],
    [
        "P1",
        "ends",
        "nodes and edges",
        "every edge is a line from its start node to its end node, all in one reference system",
    ],
    [
        "P2",
        "containing",
        "nodes",
        "nodes with edges have no `containing_face`; those of the others are faces in which they lie",
    ],
    ["P3", "edges", "faces", "every face but face 0 has edges"],
    ["P4", "cached", "values", "`mbr` and the `abs_next_…` columns are what they are computed of"],
];

impl From<&Finding> for Diagnosis {
    fn from(finding: &Finding) -> Self {
        Self {
            rule: Some(finding.rule()),
            kind: Kind::Named { kind: finding.kind() },
            message: finding.to_string(),
            cause: Some(finding.cause()),
            remedy: Some(finding.remedy()),
            records: Records::Names { records: finding.record().into_iter().collect() },
            is_violation: true,
            ..Self::default()
        }
    }
}

impl Findings {
    /// Keeps up to `cap` findings of each rule.
    pub(super) fn new(cap: usize) -> Self {
        Self { cap, ..Self::default() }
    }

    pub(super) fn add(&mut self, finding: Finding) {
        let rule = RULES.iter().position(|[id, ..]| *id == finding.rule()).unwrap_or_default();
        self.counts[rule] += 1;
        if self.counts[rule] <= self.cap as u64 {
            self.kept.push(finding);
        }
    }
}
