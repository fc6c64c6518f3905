//! Mesh files: reading, joining and findings.
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands properties their input by value")]

mod errors;
mod formats;
mod golden;
mod hostile;
mod output;
mod random;
mod second_opinions;
mod space;
mod support {
    pub(crate) mod oracle;
    pub(crate) mod shapes;
    pub(crate) mod soup;
    pub(crate) mod write;
}
