//! Replaces the crate of this name: browsers and Node have its tables, which are a tenth of the compressed module.
//!
//! It has the items that this module and the crate `codepage` use. Labels and errors follow the Encoding Standard, like
//! `TextDecoder`.

use std::borrow::Cow;

/// A character set, by one of its labels.
#[derive(Debug, PartialEq, Eq)]
pub struct Encoding {
    label: Cow<'static, str>,
}

macro_rules! encodings {
    ($($name:ident = $label:literal,)*) => {
        $(
            #[doc = $label]
            pub static $name: Encoding = Encoding { label: Cow::Borrowed($label) };
        )*
    };
}

encodings! {
    BIG5_INIT = "Big5",
    EUC_JP_INIT = "EUC-JP",
    EUC_KR_INIT = "EUC-KR",
    GB18030_INIT = "gb18030",
    GBK_INIT = "GBK",
    IBM866_INIT = "IBM866",
    ISO_2022_JP_INIT = "ISO-2022-JP",
    ISO_8859_2_INIT = "ISO-8859-2",
    ISO_8859_3_INIT = "ISO-8859-3",
    ISO_8859_4_INIT = "ISO-8859-4",
    ISO_8859_5_INIT = "ISO-8859-5",
    ISO_8859_6_INIT = "ISO-8859-6",
    ISO_8859_7_INIT = "ISO-8859-7",
    ISO_8859_8_INIT = "ISO-8859-8",
    ISO_8859_8_I_INIT = "ISO-8859-8-I",
    ISO_8859_10_INIT = "ISO-8859-10",
    ISO_8859_13_INIT = "ISO-8859-13",
    ISO_8859_14_INIT = "ISO-8859-14",
    ISO_8859_15_INIT = "ISO-8859-15",
    ISO_8859_16_INIT = "ISO-8859-16",
    KOI8_R_INIT = "KOI8-R",
    KOI8_U_INIT = "KOI8-U",
    MACINTOSH_INIT = "macintosh",
    SHIFT_JIS_INIT = "Shift_JIS",
    UTF_16BE_INIT = "UTF-16BE",
    UTF_16LE_INIT = "UTF-16LE",
    UTF_8_INIT = "UTF-8",
    WINDOWS_874_INIT = "windows-874",
    WINDOWS_1250_INIT = "windows-1250",
    WINDOWS_1251_INIT = "windows-1251",
    WINDOWS_1252_INIT = "windows-1252",
    WINDOWS_1253_INIT = "windows-1253",
    WINDOWS_1254_INIT = "windows-1254",
    WINDOWS_1255_INIT = "windows-1255",
    WINDOWS_1256_INIT = "windows-1256",
    WINDOWS_1257_INIT = "windows-1257",
    WINDOWS_1258_INIT = "windows-1258",
    X_MAC_CYRILLIC_INIT = "x-mac-cyrillic",
    REPLACEMENT_INIT = "replacement",
}

/// The encoding that decodes no text.
pub static REPLACEMENT: &Encoding = &REPLACEMENT_INIT;

/// The encoding of texts that name none.
pub static WINDOWS_1252: &Encoding = &WINDOWS_1252_INIT;

impl Encoding {
    /// Returns the encoding of this label. Each encoding leaks a few bytes.
    #[must_use]
    pub fn for_label(label: &[u8]) -> Option<&'static Self> {
        let label = str::from_utf8(label).ok()?;
        host::decode(label, &[])?;
        Some(Box::leak(Box::new(Self { label: Cow::Owned(label.to_owned()) })))
    }

    /// Returns the label.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.label
    }

    /// Decodes bytes; returns `None` if they are not of this encoding. O(their number).
    #[must_use]
    pub fn decode_without_bom_handling_and_without_replacement<'a>(
        &'static self,
        bytes: &'a [u8],
    ) -> Option<Cow<'a, str>> {
        host::decode(&self.label, bytes).map(Cow::Owned)
    }

    /// Decodes bytes, and returns whether any of them are not of this encoding: then the text is UTF-8 with
    /// replacements. O(their number).
    #[must_use]
    pub fn decode_without_bom_handling<'a>(&'static self, bytes: &'a [u8]) -> (Cow<'a, str>, bool) {
        match host::decode(&self.label, bytes) {
            Some(text) => (text.into(), false),
            None => (String::from_utf8_lossy(bytes), true),
        }
    }
}

/// The functions of JavaScript.
#[cfg(target_family = "wasm")]
mod host {
    #[link(wasm_import_module = "twinedge")]
    unsafe extern "C" {
        #[link_name = "decode"]
        safe fn decode_at(label: *const u8, label_length: usize, bytes: *const u8, length: usize) -> i32;
        #[link_name = "decoded"]
        safe fn decoded_at(text: *mut u8);
    }

    /// Decodes bytes in the encoding of this label; `None` if the label is unknown, or the bytes are not of this
    /// encoding.
    pub(super) fn decode(label: &str, bytes: &[u8]) -> Option<String> {
        let length = decode_at(label.as_ptr(), label.len(), bytes.as_ptr(), bytes.len());
        let mut text = vec![0; usize::try_from(length).ok()?];
        decoded_at(text.as_mut_ptr());
        String::from_utf8(text).ok()
    }
}

/// On other targets, for the lints.
#[cfg(not(target_family = "wasm"))]
mod host {
    pub(super) fn decode(_: &str, bytes: &[u8]) -> Option<String> {
        str::from_utf8(bytes).ok().map(str::to_owned)
    }
}
