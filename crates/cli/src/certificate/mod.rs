//! Certificates: `twinedge certify` writes them, `twinedge check` checks them.

mod certify;
mod check;
mod folder;
mod output;
mod paged;
mod source;
mod sql;

pub(crate) use certify::Certify;
pub(crate) use check::Check;
