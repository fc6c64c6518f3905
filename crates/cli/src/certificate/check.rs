//! `twinedge check` checks a certificate.

use super::folder;
use crate::output::{Failure, Verdict, print};
use std::path::PathBuf;
use twinedge_certificate::{Failure as FailedTest, Test};

/// Check a certificate: whether a folder holds a planar subdivision, or a surface.
///
/// The check is a scan that looks at each record once. It shares no code with `twinedge audit`, and prints the same lines as the checker
/// that is proved in Coq (`proofs/coq/certified`).
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge certify parcels.geojson -o parcels.cert
  twinedge check parcels.cert
  twinedge check planet.cert --memory 256M

Exit status: 0 it is certified; 1 it is not, and the tests that fail are printed, each with the first record that fails it; 2 the \
folder could not be read.")]
pub(crate) struct Check {
    /// The folder of the certificate.
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,

    /// Memory for the columns. What does not fit is read again where it is needed, so that certificates of any size can be checked
    #[arg(long, value_name = "SIZE", default_value = "1G", value_parser = crate::input::size)]
    memory: u64,
}

impl Check {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        match folder::check(&self.folder, self.memory)? {
            Ok(claim) => {
                print(&format!("valid: {claim}\n"))?;
                Ok(Verdict::Sound)
            }
            Err(failures) if failures.iter().any(|failure| failure.test() == Test::Readable) => {
                let name = self.folder.display();
                Err(Failure(format!(
                    "{name}: the length of a column is wrong or too large, a point is not there, or a coordinate is out of range"
                )))
            }
            Err(failures) => {
                print(&format!("not valid\n{}", lines(&failures)))?;
                Ok(Verdict::Wrong)
            }
        }
    }
}

pub(super) fn lines(failures: &[FailedTest]) -> String {
    failures.iter().fold(String::new(), |lines, failure| lines + &failure.to_string() + "\n")
}
