//! The commands for `psql` to write a topology.

/// Returns commands for `psql` that write the nodes, faces and edges of a topology to standard output, as binary COPY streams.
///
/// They run in one read-only transaction, on one snapshot, unharmed by edits. They need the right to SELECT from the tables, and
/// run on replicas. At the first error `psql` stops, and the stream ends early, which [`read`](super::read) reports.
///
/// The name is quoted, so any name is allowed.
///
/// ```
/// use twinedge_postgis::sql;
/// let commands = sql("the \"old\" town");
/// assert!(commands.contains("COPY \"the \"\"old\"\" town\".node (node_id, containing_face, geom) TO STDOUT (FORMAT binary);"));
/// ```
#[must_use]
pub fn sql(topology: &str) -> String {
    let schema = topology.replace('"', "\"\"");
    let copy =
        |table: &str, columns: &str| format!("COPY \"{schema}\".{table} ({columns}) TO STDOUT (FORMAT binary);\n");
    let edge_columns = "edge_id, start_node, end_node, next_left_edge, abs_next_left_edge, next_right_edge, \
                        abs_next_right_edge, left_face, right_face, geom";
    [
        "\\set QUIET on\n\\set ON_ERROR_STOP on\n".to_owned(),
        "BEGIN TRANSACTION ISOLATION LEVEL REPEATABLE READ READ ONLY;\n".to_owned(),
        copy("node", "node_id, containing_face, geom"),
        copy("face", "face_id, mbr"),
        copy("edge_data", edge_columns),
        "COMMIT;\n".to_owned(),
    ]
    .concat()
}
