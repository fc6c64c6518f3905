//! Each rule is stated once: `docs/rules.md`, the files of the rules, the reference and the diagram repeat the statement, and all
//! names in the documentation of a rule exist.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use twinedge::validate::{Rule, Violation};

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Returns, as one line, the consecutive comment lines from the first that starts with `start`.
fn comment(text: &str, marker: &str, start: &str) -> Option<String> {
    let lines = text.lines().map(str::trim).skip_while(|line| !line.starts_with(&format!("{marker} {start}")));
    let words: Vec<&str> =
        lines.map_while(|line| line.strip_prefix(marker)).map(str::trim).take_while(|line| !line.is_empty()).collect();
    (!words.is_empty()).then(|| words.join(" "))
}

/// The table of rules and violations, in order.
fn catalogue() -> String {
    read("src/validate/catalogue.rs")
}

/// For each rule: its file, and the file and name of the test that breaks it, as documented.
fn documented() -> Vec<(Rule, String, String, String)> {
    let source = catalogue();
    let entries: Vec<_> = source.lines().filter_map(|line| line.trim().strip_prefix("in \"")).collect();
    assert_eq!(entries.len(), Rule::ALL.len());
    let quoted = |entry: &str, n: usize| entry.split('"').nth(n).unwrap().to_owned();
    let one = |(rule, entry): (&Rule, &&str)| (*rule, quoted(entry, 0), quoted(entry, 2), quoted(entry, 4));
    Rule::ALL.iter().zip(&entries).map(one).collect()
}

#[test]
fn the_page_of_the_rules_states_each_in_the_same_words() {
    let page = read("docs/rules.md");
    for rule in Rule::ALL {
        let row = format!("| {rule} {} | {} |", rule.name(), rule.statement());
        assert!(page.lines().any(|line| line == row), "docs/rules.md has no line\n{row}");
    }
}

#[test]
fn the_check_of_each_rule_is_headed_by_its_statement() {
    for (rule, file, _, _) in documented() {
        let text = read(&format!("{file}.rs"));
        let head = comment(&text, "///", &format!("{rule} {}", rule.name()));
        assert_eq!(head, Some(format!("{rule} {}: {}.", rule.name(), rule.statement())), "{file}.rs");
    }
}

#[test]
fn the_reference_states_each_rule_in_the_same_words() {
    let text = read("src/validate/reference/rules.rs");
    for rule in Rule::ALL.iter().filter(|rule| !rule.is_geometric()) {
        let head = comment(&text, "///", &format!("{rule} "));
        assert_eq!(head, Some(format!("{rule} {}: {}.", rule.name(), rule.statement())));
        assert!(
            text.contains(&format!("\nfn {}(", rule.id().to_lowercase())),
            "the reference has no function for {rule}"
        );
    }
}

#[test]
fn each_rule_is_in_the_diagram() {
    let module = read("src/validate/mod.rs");
    for rule in Rule::ALL {
        let name = rule.name();
        assert!(module.contains(&format!("{rule} {name}")), "the diagram of mod.rs lacks {rule} {name}");
    }
}

#[test]
fn the_test_that_breaks_each_rule_is_there() {
    for (rule, _, file, test) in documented() {
        assert!(test.starts_with(&format!("{}_", rule.id().to_lowercase())), "{rule}: {test}");
        let tests = read(&format!("{file}.rs"));
        assert!(tests.contains(&format!("#[test]\nfn {test}()")), "{file}.rs has no test {test}");
    }
}

/// For example, `TwinIsSelf` is `twin_is_self`.
#[test]
fn each_kind_of_violation_is_its_name_in_snake_case() {
    let source = catalogue();
    // The line before the sentence has the variant, its fields and its kind.
    let lines: Vec<&str> = source.lines().map(str::trim).collect();
    let heads = lines.windows(2).filter(|pair| pair[1].starts_with("says \""));
    let variants: Vec<&str> = heads.filter_map(|pair| pair[0].split_whitespace().next()).collect();
    assert_eq!(variants.len(), Violation::KINDS.len());
    for (variant, kind) in variants.iter().zip(Violation::KINDS) {
        let camel: String = kind.split('_').map(|word| word[..1].to_uppercase() + &word[1..]).collect();
        assert_eq!(*variant, camel);
    }
}

#[test]
fn causes_and_remedies_are_parts_of_sentences() {
    for violation in [
        Violation::TwinIsSelf { half_edge: 0 },
        Violation::NoUnboundedFace,
        Violation::Touch { vertex: 0, half_edge: 0 },
    ] {
        for text in [violation.cause(), violation.remedy()] {
            assert!(text.starts_with(char::is_lowercase) && !text.ends_with('.'), "{text}");
        }
    }
}

/// The names match `docs/report.md`, and are unique.
#[test]
fn every_kind_of_violation_is_documented_once() {
    let kinds: BTreeSet<_> = Violation::KINDS.iter().collect();
    assert_eq!(kinds.len(), Violation::KINDS.len());
    let page = read("docs/report.md");
    let rows: Vec<_> = page
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split('`').next())
        .filter(|name| kinds.contains(name))
        .collect();
    assert_eq!(rows, Violation::KINDS);
}
