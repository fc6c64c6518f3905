//! Writing elements.

use std::fmt::Write as _;

/// Writes to a string, which cannot fail.
pub(super) fn put(out: &mut String, what: std::fmt::Arguments<'_>) {
    let _ = out.write_fmt(what);
}

/// Writes text with a light halo, which is drawn first: not every program can put a stroke behind its letters.
pub(super) fn text(out: &mut String, class: &str, [x, y]: [f64; 2], what: &str) {
    let what = escaped(what);
    for class in [&format!("{class} halo"), class] {
        put(out, format_args!("<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{what}</text>\n"));
    }
}

/// Returns text that is valid in an element, without control characters and the characters that XML 1.0 does not allow there.
pub(super) fn escaped(text: &str) -> String {
    let allowed = text.chars().filter(|c| !c.is_control() && !matches!(c, '\u{FFFE}' | '\u{FFFF}'));
    allowed.collect::<String>().replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
