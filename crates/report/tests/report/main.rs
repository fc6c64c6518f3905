//! Reports on all kinds of inputs, from bytes to the forms that people and machines read.
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands properties their input by value")]

mod shared;
mod support;

mod between;
mod by_tiles;
mod causes;
mod cleaned;
mod coverage;
mod drawn;
mod forms;
mod gate;
mod great_circles;
mod maps;
mod meshes;
mod options;
mod structures;
mod svg;
mod textbook;
