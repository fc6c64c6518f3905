//! What mends a violation of a map, by the commands of this program.

use twinedge::validate::{Rule, Violation};

/// The remedy of a violation of a map. Those of the library name its own functions where the map does not lie in the plane.
pub(super) fn remedy(violation: &Violation) -> &'static str {
    match violation.rule() {
        Rule::T3 => "mend the crossings (G4), from which it follows",
        Rule::G4 => {
            "`twinedge clean` repairs a layer of polygons; `--snap auto` cuts borders where they meet, and the rest is audited as if they were cut"
        }
        _ => violation.remedy(),
    }
}
