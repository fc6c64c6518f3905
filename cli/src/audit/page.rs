//! The page: one file with its style, its script and its data.
//!
//! A policy in the page forbids it to load anything. What comes from the input is in a block of JSON without `<`, `>` and `&`, and
//! the script sets it as text.

use super::document::Document;
use super::packed::Map;
use crate::output::plain;
use crate::status::Failure;
use serde::Serialize;
use std::fmt::Write as _;

const PAGE: &str = include_str!("html/page.html");
const STYLE: &str = include_str!("html/style.css");

/// In the order in which they are run.
const SCRIPTS: [&str; 9] = [
    include_str!("html/unpack.js"),
    include_str!("html/colours.js"),
    include_str!("html/view.js"),
    include_str!("html/faces.js"),
    include_str!("html/half_edges.js"),
    include_str!("html/names.js"),
    include_str!("html/findings.js"),
    include_str!("html/list.js"),
    include_str!("html/main.js"),
];

#[derive(Serialize)]
struct Data<'a> {
    #[serde(flatten)]
    document: &'a Document,
    map: &'a Map,
}

/// The page.
pub(super) fn page(document: &Document, map: &Map) -> Result<String, Failure> {
    let data = in_script(&serde_json::to_string(&Data { document, map })?);
    let title = in_element(&plain(&document.input));
    let verdict = in_element(&plain(&document.verdict));
    let script = SCRIPTS.concat();
    let mut page = String::with_capacity(data.len() + script.len() + 20_000);
    let mut rest = PAGE;
    for (mark, text) in
        [("{title}", &*title), ("{style}", STYLE), ("{verdict}", &*verdict), ("{data}", &*data), ("{script}", &*script)]
    {
        let (before, after) = rest.split_once(mark).unwrap_or((rest, ""));
        page.push_str(before);
        page.push_str(text);
        rest = after;
    }
    page.push_str(rest);
    Ok(page)
}

/// JSON as it may stand in an element `script`: it has none of these characters outside of texts.
fn in_script(json: &str) -> String {
    let mut out = String::with_capacity(json.len());
    for c in json.chars() {
        match c {
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' => {
                // Writing to a string cannot fail.
                let _ = write!(out, "\\u{:04x}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out
}

/// Text as it may stand in an element.
fn in_element(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::{Document, Map, page};
    use serde_json::Value;

    #[test]
    fn what_comes_from_the_input_ends_no_element() {
        let hostile = "</script><script>alert(1)</script><!--\u{2028}\"'&amp; {data} \u{1b}[31m";
        let document = Document { input: hostile.to_owned(), verdict: hostile.to_owned(), ..Document::default() };
        let page = page(&document, &Map::default()).expect("it can be written");
        assert_eq!(page.matches("</script>").count(), 2);
        assert!(!page.contains("alert(1)</script>") && !page.contains("{script}") && !page.contains('\u{1b}'));
        let (_, data) = page.split_once("type=\"application/json\">").expect("the data are there");
        let (data, _) = data.split_once("</script>").expect("they end");
        assert!(!data.contains(['<', '>', '&', '\u{2028}']), "{data}");
        let data: Value = serde_json::from_str(data).expect("it is JSON");
        assert_eq!(data["input"], hostile);
    }
}
