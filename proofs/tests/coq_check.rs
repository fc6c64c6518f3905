//! `coq/check` reports whether the proof was checked: with other versions it was not, which is no
//! failure.

#![cfg(unix)]

use std::fs;
use std::os::unix::fs::PermissionsExt as _;
use std::process::Command;

#[test]
fn another_version_of_coq_is_not_a_failed_proof() {
    let folder = std::env::temp_dir().join(format!("twinedge-coq-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let coqc = folder.join("coqc");
    fs::write(&coqc, "#!/bin/sh\necho 8.20.0 4.14.1\n").unwrap();
    fs::set_permissions(&coqc, fs::Permissions::from_mode(0o755)).unwrap();
    let path = format!("{}:{}", folder.display(), std::env::var("PATH").unwrap());
    let check = concat!(env!("CARGO_MANIFEST_DIR"), "/coq/check");
    let output = Command::new("bash").arg(check).env("PATH", path).output().unwrap();
    fs::remove_dir_all(&folder).unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(3), "{said}");
    assert!(said.contains("not run: this proof is for Coq 8.16, and this is Coq 8.20.0"), "{said}");
}
