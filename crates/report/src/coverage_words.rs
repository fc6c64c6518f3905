//! The statements of the rules of a coverage, the usual causes of findings, and their remedies.

use twinedge_coverage::CoverageRule;

pub(crate) const fn statement(rule: CoverageRule) -> &'static str {
    match rule {
        CoverageRule::Overlap => "no face is claimed by two features",
        CoverageRule::Gap => "no bounded face is unclaimed",
        CoverageRule::NearMiss => "borders of two features coincide or are farther apart than a given width",
        CoverageRule::Sliver => "no part of a feature is both small and thin",
        CoverageRule::Duplicate => "no two features claim the same faces",
        CoverageRule::Mismatch => "where borders of two features meet, both have a vertex",
        _ => "the polygons of each feature are valid by the rules of the OGC",
    }
}

pub(crate) const fn explanation(rule: CoverageRule) -> (&'static str, &'static str) {
    match rule {
        CoverageRule::Overlap => (
            "a border was drawn twice, or a feature was moved or comes from another source",
            "`twinedge clean` gives the place to one of the features, as `--overlap` says",
        ),
        CoverageRule::Gap => (
            "borders were drawn one by one and do not meet, or the gap is meant: a lake, a road",
            "`twinedge clean --gap-width W` fills gaps up to that mean width; `--lake-width W` accepts wider ones, `--accept-gap X,Y` the one at a place",
        ),
        CoverageRule::NearMiss => (
            "borders were drawn one by one and do not meet",
            "`twinedge clean --gap-width W` fills the space between them; `--snap SIZE` joins points within a cell",
        ),
        CoverageRule::Sliver => (
            "it is left over from an overlay, or a border was drawn twice",
            "`twinedge clean` gives it to a neighbour; `--sliver A` is the area",
        ),
        CoverageRule::Duplicate => (
            "a feature was copied or imported twice",
            "delete one of them; `twinedge clean` leaves the geometry to the first and the attributes to all",
        ),
        CoverageRule::Mismatch => (
            "borders were drawn or simplified one by one, or a neighbour was split later",
            "`twinedge clean` adds the vertices, and changes nothing else; `--snap auto` audits the map as if they were there",
        ),
        _ => (
            "a ring crosses or touches itself, as points are in the wrong order or borders run back",
            "`twinedge clean` makes the polygons anew",
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::statement;
    use twinedge_coverage::CoverageRule;
    use twinedge_coverage::layers::LayerRule;
    use twinedge_meshes::SpaceRule;

    #[test]
    fn the_page_of_the_rules_states_each() {
        let page = include_str!("../../../docs/rules.md");
        let of_coverage = CoverageRule::ALL.iter().map(|rule| (rule.id(), rule.name(), statement(*rule)));
        let of_layers = LayerRule::ALL.iter().map(|rule| (rule.id(), rule.name(), rule.statement()));
        let of_meshes = SpaceRule::ALL.iter().map(|rule| (rule.id(), rule.name(), rule.statement()));
        for (id, name, statement) in of_coverage.chain(of_layers).chain(of_meshes) {
            let row = format!("| {id} {name} | {statement} |");
            assert!(page.lines().any(|line| line == row), "docs/rules.md has no line\n{row}");
        }
    }
}
