pub(crate) mod oracle;
pub(crate) mod shapes;
pub(crate) mod soup;
pub(crate) mod write;
