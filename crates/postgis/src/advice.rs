//! Causes and remedies of broken rules, in the words of PostGIS.

use twinedge::validate::Rule;

/// Returns the usual cause of a violation of this rule of the validator, and the remedy.
pub(super) const fn advice(rule: Rule) -> [&'static str; 2] {
    match rule {
        Rule::R1 => [
            "a row was deleted, or an id was changed, with foreign keys switched off",
            "restore the row, or set the column to the record that the line and the edges around it show",
        ],
        Rule::L2 | Rule::L3 => [
            "an edge was inserted, deleted or attached to another node by plain SQL, and the edges beside it were not linked anew",
            "set the column to the edge that follows clockwise around the node; edit by `ST_AddEdgeModFace` and `ST_RemEdgeModFace`",
        ],
        Rule::V2 | Rule::T3 => [
            "the next edges at a node were set in another order than that of the lines around it",
            "set them to the edges that follow clockwise around the node",
        ],
        Rule::B1 => [
            "`left_face` or `right_face` was set by hand, or not at all edges of a face that was split or merged",
            "set the column to the face that the other edges of the ring name",
        ],
        Rule::B2 => [
            "the last edge of a node was deleted by plain SQL, or its `containing_face` was set to null",
            "set `containing_face` to the result of `GetFaceContainingPoint`, or remove the node by `ST_RemoveIsoNode`",
        ],
        Rule::F1 | Rule::F2 | Rule::T1 | Rule::T2 => [
            "the row of face 0 was deleted, or the edges of a ring name the face on its other side, or two faces got one id",
            "restore the row, or give each face an id of its own and set `left_face` and `right_face` of its edges to it",
        ],
        Rule::G1 => [
            "a coordinate was computed by an expression that failed, or the points of a line were merged",
            "restore the line by `ST_ChangeEdgeGeom` or the node by `ST_MoveIsoNode`, or remove the edge by `ST_RemEdgeModFace`",
        ],
        Rule::G2 => [
            "a line or a node was moved by plain SQL to another side of an edge",
            "restore the line, or set the next edges at the node to those that follow clockwise",
        ],
        Rule::G3 => [
            "`left_face` and `right_face` of a ring were exchanged, or its line was reversed",
            "exchange the two columns, or reverse the line",
        ],
        Rule::G4 => [
            "lines were loaded, simplified or moved by plain SQL instead of `TopoGeo_AddLineString` and `ST_ChangeEdgeGeom`",
            "restore the lines, or remove the edges and add their lines by `TopoGeo_AddLineString`, which splits lines where they meet",
        ],
        Rule::G5 => [
            "the face of a hole or the `containing_face` of a node was set by hand, or the hole or the node was moved",
            "set it to the face around the hole or the node, or move them back",
        ],
        _ => ["rows were changed while they were read", "write the topology to a file, and audit it again"],
    }
}
