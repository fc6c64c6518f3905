//! The maps that `validator_total` corrupts are valid from the start, in every form.

use std::fs;
use std::path::Path;
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{Collect, validate};
use twinedge_fuzz_cases::right_map;
use twinedge_trials::forms::{Form, forms};

#[test]
fn the_maps_to_corrupt_are_right_in_every_form() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../corpus");
    let (mut judged, mut open) = (0, 0);
    for target in ["programs", "validator_total"] {
        for file in fs::read_dir(folder.join(target)).unwrap() {
            let mut bytes = fs::read(file.unwrap().path()).unwrap();
            for (form, last) in forms().into_iter().flat_map(|one| [(one, 0), (one, 1), (one, 2)]) {
                let Form { expectation, .. } = form;
                // The last consumed byte chooses another form.
                bytes.push(last);
                let table = right_map(&bytes, &form);
                bytes.pop();
                let report = validate(&table, &expectation, Collect::First);
                assert!(report.is_valid(), "{table}\n{expectation:?}\n{report}");
                if table.half_edges.len() <= 12 {
                    assert_eq!(first_broken_rule(&table, &expectation), None, "{table}\n{expectation:?}");
                }
                judged += 1;
                open += usize::from(table.half_edges.iter().flatten().any(|row| row.twin.is_none()));
            }
        }
    }
    assert!(judged > 10_000 && open > 10, "{judged} {open}");
}
