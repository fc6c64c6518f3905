//! Notes on a certificate's origin, for people. No checker reads them.

pub(super) struct Notes(Vec<(&'static str, String)>);

impl Notes {
    /// Creates the notes on the certificate of the named input: the SHA-256 of its file if it is one, the numbers of records, and the exponent of the
    /// coordinates' unit, a power of two.
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

    pub(super) fn lines(&self) -> String {
        self.entries().fold(String::new(), |lines, (key, value)| format!("{lines}{key} {value}\n"))
    }
}
