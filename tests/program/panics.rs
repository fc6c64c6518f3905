//! Panics of a structure under test, caught.

use twinedge::program::panics::catch;

#[test]
fn the_message_of_a_panic_is_kept_in_one_line() {
    assert_eq!(catch(|| 7), Ok(7));
    let said = catch(|| panic!("first\nsecond")).unwrap_err();
    assert!(said.starts_with("first second (") && said.contains("panics.rs:"), "{said}");
    let said = catch(|| std::panic::panic_any(7)).unwrap_err();
    assert!(said.starts_with("no message ("), "{said}");
}

#[test]
fn catching_can_be_nested() {
    let said = catch(|| {
        assert!(catch(|| panic!("inner")).is_err());
        panic!("outer")
    });
    assert!(said.unwrap_err().starts_with("outer ("));
}
