//! Character sets of tables, by their names and numbers in files.

use super::super::error::Cause;
use encoding_rs::{Encoding, WINDOWS_1252};
use oem_cp::code_table::DECODING_TABLE_CP_MAP;
use oem_cp::code_table_type::TableType;

const PREFIXES: [&str; 7] = ["CP", "OEM", "ANSI", "WINDOWS", "IBM", "ISO", "MS"];

#[derive(Clone, Debug)]
pub(super) enum Charset {
    /// A set that browsers support.
    Encoding(&'static Encoding),
    /// A code page of DOS, by its number.
    Oem(u16, &'static TableType),
    /// An unknown name or number. ASCII is the same in all sets.
    Unknown(String),
    /// The file names none: a text is UTF-8 if it is valid as such, and otherwise Windows-1252.
    Unnamed,
}

impl Charset {
    /// Returns the set from the content of `.cpg`, or else from the mark in the table.
    pub(super) fn of(label: Option<&str>, mark: u8) -> Self {
        match label.map(str::trim).filter(|label| !label.is_empty()) {
            Some(label) => Self::of_label(label).unwrap_or_else(|| Self::Unknown(label.to_owned())),
            None if mark == 0 => Self::Unnamed,
            None => code_page(mark)
                .and_then(Self::of_code_page)
                .unwrap_or_else(|| Self::Unknown(format!("language driver 0x{mark:02X}"))),
        }
    }

    fn of_label(label: &str) -> Option<Self> {
        if let Some(encoding) = Encoding::for_label(label.as_bytes()) {
            return Some(Self::Encoding(encoding));
        }
        // `CP932`, `OEM 850`, `ANSI 1252`, `ISO 8859-2`: the number decides.
        let separators = [' ', '-', '_'];
        let upper = label.to_ascii_uppercase();
        let prefix = PREFIXES.iter().find_map(|prefix| upper.strip_prefix(prefix));
        let number = prefix.unwrap_or(&upper).trim_start_matches(separators);
        match number.strip_prefix("8859") {
            Some(part) => {
                let part = part.trim_start_matches(separators);
                Encoding::for_label(format!("iso-8859-{part}").as_bytes()).map(Self::Encoding)
            }
            None => number.parse().ok().and_then(Self::of_code_page),
        }
    }

    fn of_code_page(number: u16) -> Option<Self> {
        let of_dos = || Some(Self::Oem(number, DECODING_TABLE_CP_MAP.get(&number)?));
        codepage::to_encoding_no_replacement(number).map(Self::Encoding).or_else(of_dos)
    }

    pub(super) fn decode(&self, bytes: &[u8]) -> Result<String, Cause> {
        let text = match self {
            Self::Encoding(encoding) => encoding.decode_without_bom_handling_and_without_replacement(bytes),
            Self::Oem(_, TableType::Complete(table)) => {
                return Ok(oem_cp::decode_string_complete_table(bytes, table));
            }
            Self::Oem(_, TableType::Incomplete(table)) => {
                oem_cp::decode_string_incomplete_table_checked(bytes, table).map(Into::into)
            }
            Self::Unknown(_) => str::from_utf8(bytes).ok().filter(|text| text.is_ascii()).map(Into::into),
            Self::Unnamed => Some(match str::from_utf8(bytes) {
                Ok(text) => text.into(),
                Err(_) => WINDOWS_1252.decode_without_bom_handling(bytes).0,
            }),
        };
        text.map(|text| text.into_owned()).ok_or_else(|| match self {
            Self::Encoding(encoding) => Cause::Charset(encoding.name().to_owned()),
            Self::Oem(number, _) => Cause::Charset(format!("of the code page {number}")),
            Self::Unknown(label) => Cause::UnknownCharset(label.clone()),
            Self::Unnamed => Cause::Charset("UTF-8".to_owned()),
        })
    }
}

/// Returns the code page of a mark (language driver id). The numbers follow dBASE and Esri, as in `dbfopen` of GDAL.
const fn code_page(mark: u8) -> Option<u16> {
    Some(match mark {
        0x01 | 0x09 | 0x0B | 0x0D | 0x0F | 0x11 | 0x15 | 0x18 | 0x19 | 0x1B => 437,
        0x02 | 0x0A | 0x0E | 0x10 | 0x12 | 0x14 | 0x16 | 0x1A | 0x1D | 0x25 | 0x37 => 850,
        0x03 | 0x57 | 0x58 | 0x59 => 1252,
        0x04 => 10_000,
        0x08 | 0x17 | 0x66 => 865,
        0x13 | 0x7B => 932,
        0x1C | 0x6C => 863,
        0x1F | 0x22 | 0x23 | 0x40 | 0x64 | 0x87 => 852,
        0x24 => 860,
        0x26 | 0x65 => 866,
        0x4D | 0x7A => 936,
        0x4E | 0x79 => 949,
        0x4F | 0x78 => 950,
        0x50 | 0x7C => 874,
        0x67 => 861,
        0x6A | 0x86 => 737,
        0x6B | 0x88 => 857,
        0x7D => 1255,
        0x7E => 1256,
        0x96 => 10_007,
        0xC8 => 1250,
        0xC9 => 1251,
        0xCA => 1254,
        0xCB => 1253,
        0xCC => 1257,
        _ => return None,
    })
}
