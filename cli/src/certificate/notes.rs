//! Notes that go with a certificate, for whoever wants to know of what it is. No checker reads them.

/// Keys and values, in order.
pub(super) struct Notes(Vec<(&'static str, String)>);

impl Notes {
    /// The notes on a certificate of an input of this name: the SHA-256 of its file if it is one, the numbers of records, and the
    /// grid of its coordinates, whose unit is two to this exponent.
    pub(super) fn new(name: &str, sha256: Option<String>, counts: &str, exponent: Option<i32>) -> Self {
        let mut notes = vec![("of", name.escape_debug().to_string())];
        notes.extend(sha256.map(|sha256| ("sha256", sha256)));
        notes.push(("counts", counts.to_owned()));
        notes.extend(exponent.map(|exponent| ("unit", format!("2^{exponent}"))));
        notes.push(("by", concat!("twinedge ", env!("CARGO_PKG_VERSION")).to_owned()));
        Self(notes)
    }

    pub(super) fn entries(&self) -> impl Iterator<Item = (&'static str, &str)> {
        self.0.iter().map(|(key, value)| (*key, value.as_str()))
    }

    /// A line for each.
    pub(super) fn lines(&self) -> String {
        self.entries().fold(String::new(), |lines, (key, value)| format!("{lines}{key} {value}\n"))
    }
}
