//! The kinds of inputs.

use crate::error::Error;
use crate::input::Input;
use crate::tables::is_table_file;
use crate::textbook_audit::is_textbook;
use twinedge_meshes::Format as MeshFormat;
use twinedge_postgis::is_copy;

/// The kind of an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InputKind {
    /// A layer to build a map of.
    Map,
    /// A mesh.
    Mesh(MeshFormat),
    /// The three tables of a textbook.
    Textbook,
    /// A table on each line.
    Tables,
    /// A topology of PostGIS.
    Postgis,
    /// The arcs of TopoJSON.
    Arcs,
}

impl InputKind {
    /// Returns the kind: a topology of PostGIS or arcs if requested, or else by the beginning of the input.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn of(postgis: bool, arcs: bool, input: &mut Input) -> Result<Self, Error> {
        Ok(if postgis || is_copy(input.beginning()?) {
            Self::Postgis
        } else if arcs {
            Self::Arcs
        } else if is_textbook(input.beginning()?) {
            Self::Textbook
        } else if is_table_file(input.beginning()?) {
            Self::Tables
        } else {
            input.mesh_format()?.map_or(Self::Map, Self::Mesh)
        })
    }

    /// Returns the kind in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Map => "a map",
            Self::Mesh(_) => "a mesh",
            Self::Textbook => "a textbook's tables",
            Self::Tables => "a file of tables",
            Self::Postgis => "a topology of PostGIS",
            Self::Arcs => "audited arc by arc",
        }
    }
}
