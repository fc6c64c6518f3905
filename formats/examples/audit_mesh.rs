//! Audits a mesh file, or, without one, a cube with two faults.
//!
//!     cargo run -p twinedge-formats --example audit_mesh
//!     cargo run -p twinedge-formats --example audit_mesh -- bunny.ply
//!     cargo run -p twinedge-formats --example audit_mesh -- bunny.ply --json

use std::process::ExitCode;
use twinedge::validate::Collect;
use twinedge_formats::mesh::{HalfEdgeMesh, audit, read_bytes, read_path};

/// The face at x = 0 is missing, and that at x = 1 is flipped.
const CUBE: &str = "
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 3 4 8 7
f 2 6 7 3
";

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let (options, names): (Vec<_>, Vec<_>) = arguments.iter().partition(|argument| argument.starts_with("--"));
    let file = match names.first() {
        Some(name) => read_path(name)?,
        None => read_bytes(CUBE.as_bytes(), None)?,
    };
    let audit = audit(&file.mesh, &HalfEdgeMesh::expectation().closed(), Collect::AtMost(20));
    if options.iter().any(|option| *option == "--json") {
        println!("{}", serde_json::to_string_pretty(&audit)?);
    } else {
        for dropped in &file.dropped {
            println!("not used: {} {}", dropped.count, dropped.what);
        }
        println!("{audit}");
    }
    Ok(if audit.is_valid() || names.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
