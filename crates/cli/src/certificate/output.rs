//! The output folder of a certificate.

use super::folder::{self, CLAIM_FILE, Claim, Notes, write_file};
use super::sql::{self, Engine};
use crate::output::Failure;
use std::ffi::OsString;
use std::path::Path;
use std::{fs, io};
use twinedge_report::certificate::FIRST_LINE;

/// Writes all columns, the tables if requested, and then the claim with these notes. Replaces an existing certificate.
pub(super) fn write(folder: &Path, claim: &Claim, notes: &Notes, sql: Option<Engine>) -> Result<(), Failure> {
    if let Some(engine) = sql {
        sql::check(engine)?;
    }
    clear(folder)?;
    claim.write_columns(folder)?;
    if let Some(engine) = sql {
        sql::write(folder, claim, notes, engine)?;
    }
    claim.write_claim(folder, notes)
}

/// Creates the folder, or removes the certificate in it. A folder with other files is left alone.
fn clear(path: &Path) -> Result<(), Failure> {
    let name = path.display();
    let failed = |error: io::Error| Failure(format!("{name}: {error}"));
    fs::create_dir_all(path).map_err(failed)?;
    let entries = fs::read_dir(path).map_err(failed)?;
    let there: Vec<OsString> = entries.map(|entry| Ok(entry?.file_name())).collect::<Result<_, _>>().map_err(failed)?;
    let claim = path.join(CLAIM_FILE);
    if there.is_empty() {
        return Ok(());
    }
    let may_be_there: Vec<OsString> = folder::file_names().chain(sql::file_names()).map(OsString::from).collect();
    if let Some(other) = there.iter().find(|file| !may_be_there.contains(file)) {
        let other = other.display();
        return Err(Failure(format!("{name}: {other} is no file of a certificate, so the folder is not written to")));
    }
    if !fs::read(&claim).is_ok_and(|claim| claim.starts_with(FIRST_LINE.as_bytes())) {
        return Err(Failure(format!("{name}: this folder has files and no certificate, and is not written to")));
    }
    // Without its second line, an incomplete folder is unreadable, and can be written again.
    write_file(&claim, FIRST_LINE.as_bytes())?;
    for file in there.iter().filter(|file| *file != CLAIM_FILE) {
        fs::remove_file(path.join(file)).map_err(failed)?;
    }
    Ok(())
}
