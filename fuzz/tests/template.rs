//! The project written by `twinedge-trials fuzz-template` builds, runs, and finds a planted bug.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize().expect("the folder above")
}

fn cargo(folder: &Path, target: &Path) -> Command {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(folder).env("CARGO_TARGET_DIR", target).env("RUSTFLAGS", "--cfg fuzzing");
    // If this test is linted while it is built, a user's project is not.
    cargo.env_remove("RUSTC_WORKSPACE_WRAPPER");
    cargo
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
}

/// A package with a structure, and the template for it.
fn template(folder: &Path, subject: &str) {
    let root = root();
    let _ = fs::remove_dir_all(folder);
    fs::create_dir_all(folder.join("src")).expect("a folder of the test's own");
    let trials = root.join("crates/trials");
    let manifest = format!(
        "[package]\nname = \"mesh\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[dependencies]\ntwinedge-trials = {{ path = \"{}\", default-features = false }}\n",
        trials.display()
    );
    fs::write(folder.join("Cargo.toml"), manifest).expect("it is written");
    fs::write(folder.join("src/lib.rs"), "pub use twinedge_trials::planted::Planted;\n").expect("it is written");
    // TRIALS names a program that is already built.
    let mut program = if let Some(path) = std::env::var_os("TRIALS") {
        Command::new(path)
    } else {
        let mut cargo = Command::new(env!("CARGO"));
        // The program requires no `cfg(fuzzing)`: any earlier build will do.
        cargo.env_remove("RUSTFLAGS").env_remove("RUSTC_WORKSPACE_WRAPPER").args([
            "run",
            "--quiet",
            "-p",
            "twinedge-trials",
            "--",
        ]);
        cargo
    };
    let written = program
        .current_dir(&root)
        .arg("fuzz-template")
        .arg(folder.join("fuzz"))
        .args(["--subject", subject])
        .output()
        .expect("it runs");
    assert!(written.status.success(), "{}", said(&written));
    // The versions locked here have been downloaded already.
    fs::copy(root.join("fuzz/Cargo.lock"), folder.join("fuzz/Cargo.lock")).expect("it is copied");
}

#[test]
fn the_project_is_built_and_finds_planted_bugs_and_panics() {
    let own = Path::new(env!("CARGO_TARGET_TMPDIR"));
    // Reuse the packages that are built already.
    let target = own.parent().expect("it is in the folder of what is built");
    let folder = own.join("mesh");
    // An edge flipped the wrong way keeps every rule, so only the comparison with the reference finds it.
    template(&folder, "mesh::Planted::<false>::default()");
    let fuzz = folder.join("fuzz");
    let run = |corpus: &Path| {
        let built = cargo(&fuzz, target).args(["build", "--offline"]).output().expect("cargo runs");
        assert!(built.status.success(), "{}", said(&built));
        let mut binary = Command::new(target.join("debug/conforms"));
        let options = ["-runs=5000", "-seed=1", "-len_control=0", "-max_len=400", "-artifact_prefix=artifact-"];
        binary.current_dir(&fuzz).args(options).arg(corpus).output().expect("it runs")
    };
    // The operators of the program in the output.
    let shown = || {
        let found = run(&fuzz.join("corpus/conforms"));
        let text = said(&found);
        assert!(!found.status.success(), "{text}");
        let (_, program) =
            text.split_once("twinedge program 1\n").unwrap_or_else(|| panic!("no program is printed\n{text}"));
        let ops = program.lines().take_while(|line| line.contains(" # "));
        (ops.map(|line| line.split(' ').next().unwrap_or_default().to_owned()).collect::<Vec<_>>(), text)
    };
    let (ops, text) = shown();
    assert!(ops.last().is_some_and(|last| last == "flip_edge") && ops.len() <= 8, "{text}");

    // libFuzzer ends the program at a panic, before it is caught, unless a hook has been installed first.
    let conforms = fuzz.join("fuzz_targets/conforms.rs");
    let replace = |from: &str, to: &str| {
        let target = fs::read_to_string(&conforms).expect("it was written");
        fs::write(&conforms, target.replace(from, to)).expect("it is written");
    };
    replace("Planted::<false>", "Planted::<true>");
    let (ops, text) = shown();
    assert!(ops.last().is_some_and(|last| last == "move_inner") && ops.len() <= 3, "{text}");
    assert!(text.contains("panicked: a planted panic ("), "{text}");

    // The structure without a bug passes.
    replace("mesh::Planted::<true>::default()", "twinedge::dcel::Dcel::new()");
    let nothing = run(&fuzz.join("corpus/conforms"));
    assert!(nothing.status.success(), "{}", said(&nothing));
}
