//! `twinedge-trials fuzz-template`: a folder for cargo-fuzz that tests the user's structure.

use crate::output::{Failure, Verdict, named, print};
use std::fs;
use std::path::{Path, PathBuf};

const MANIFEST: &str = include_str!("Cargo.toml.txt");
const TARGET: &str = include_str!("conforms.rs.txt");

/// The library's folder at build time.
const SOURCE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The number of seed files, and the bytes in each.
const SEEDS: (u64, usize) = (16, 400);

/// Write a folder for cargo-fuzz that tests a structure of your own.
///
/// The structure must implement `twinedge::program::Subject`. The target runs random programs of operators on it and on the
/// reference in step, and prints the smallest program that it can find where they differ. The folder has a manifest, the target
/// and a few inputs to begin with; nothing is overwritten.
///
/// The folder is a crate of its own. So the library of your package must implement `View` and `Subject`, for example behind a
/// feature, which the manifest then names; a dev-dependency on twinedge is not enough.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge-trials fuzz-template
  twinedge-trials fuzz-template fuzz --subject 'mesh::Mesh::new()'

Exit status: 0 the folder is written; 2 it exists already, or there is no package to test.")]
pub(crate) struct FuzzTemplate {
    /// The folder to write.
    #[arg(default_value = "fuzz", value_name = "DIR")]
    folder: PathBuf,

    /// A Rust expression that makes the structure to begin with: empty, or any valid one. Default: a placeholder, to be replaced in
    /// the target.
    #[arg(long, value_name = "EXPRESSION")]
    subject: Option<String>,

    /// The folder of the package that has the structure. Default: the package around DIR.
    #[arg(long, value_name = "PATH")]
    package: Option<PathBuf>,

    /// The folder of this library. Default: the one from which this program was built; if that is gone, the library comes from the
    /// registry.
    #[arg(long, value_name = "PATH")]
    twinedge: Option<PathBuf>,
}

impl FuzzTemplate {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let folder = &self.folder;
        let shown = folder.display();
        if folder.exists() {
            return Err(Failure(format!("{shown} exists already")));
        }
        let parent = folder.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let package = self.package.as_deref().unwrap_or(parent);
        let name = package_name(package)?;
        let path = match &self.package {
            Some(package) => quoted(&absolute(package)?),
            None => "\"..\"".to_owned(),
        };
        let source = Path::new(SOURCE);
        let library = self.twinedge.as_deref().or_else(|| source.join("Cargo.toml").is_file().then_some(source));
        let twinedge = match library {
            Some(library) => format!("path = {}", quoted(&absolute(library)?)),
            None => concat!("version = \"", env!("CARGO_PKG_VERSION"), "\"").to_owned(),
        };
        let imported = name.replace('-', "_");
        let placeholder = "todo!(\"your structure\")";
        let manifest = MANIFEST.replace("{package}", &name).replace("{path}", &path).replace("{twinedge}", &twinedge);
        let subject = self.subject.as_deref().unwrap_or(placeholder);
        let target = TARGET.replace("{crate}", &format!("`{imported}`")).replace("{subject}", subject);

        write(&folder.join("Cargo.toml"), manifest.as_bytes())?;
        write(&folder.join("fuzz_targets/conforms.rs"), target.as_bytes())?;
        write(&folder.join(".gitignore"), b"target\nartifacts\ncoverage\ncrash-*\n")?;
        let (seeds, bytes) = SEEDS;
        for seed in 0..seeds {
            write(&folder.join(format!("corpus/conforms/seed-{seed}")), &noise(seed, bytes))?;
        }

        let replace = match self.subject {
            Some(_) => String::new(),
            None => format!(
                "Put your structure, empty or any valid one, in the place of `{placeholder}` in\n  \
                 {shown}/fuzz_targets/conforms.rs\n\n"
            ),
        };
        print(&format!(
            "{shown}/ is written.\n\n{replace}\
             With cargo-fuzz (cargo install cargo-fuzz) and a nightly toolchain:\n  \
             cargo +nightly fuzz run --fuzz-dir {shown} conforms -- -max_len=400\n\n\
             On stable Rust, without AddressSanitizer:\n  \
             cargo fuzz run --sanitizer none --fuzz-dir {shown} conforms -- -max_len=400\n\n\
             Without cargo-fuzz, and without feedback from coverage:\n  \
             RUSTFLAGS='--cfg fuzzing' cargo run --release --manifest-path {shown}/Cargo.toml -- \
             -runs=100000 -len_control=0 -max_len=400 -artifact_prefix={shown}/ {shown}/corpus/conforms\n\n\
             A failure prints the smallest program that was found, as text. Keep it in a test:\n  \
             let program: twinedge::program::Program = \"…\".parse().unwrap();\n  \
             The documentation of `Program` explains the notation.\n"
        ))?;
        Ok(Verdict::Sound)
    }
}

fn package_name(folder: &Path) -> Result<String, Failure> {
    let manifest = folder.join("Cargo.toml");
    let shown = manifest.display();
    let text = fs::read_to_string(&manifest).map_err(named(&shown))?;
    let section = text.lines().map(str::trim).skip_while(|line| *line != "[package]").skip(1);
    let mut keys = section.take_while(|line| !line.starts_with('[')).filter_map(|line| line.split_once('='));
    let name = keys.find(|(key, _)| key.trim() == "name").and_then(|(_, value)| value.split('"').nth(1));
    name.map(str::to_owned).ok_or_else(|| Failure(format!("{shown} names no package")))
}

fn absolute(path: &Path) -> Result<PathBuf, Failure> {
    fs::canonicalize(path).map_err(named(path.display()))
}

/// Quotes a path as a string of JSON, which is also a basic string of TOML.
fn quoted(path: &Path) -> String {
    serde_json::Value::from(path.display().to_string()).to_string()
}

fn write(path: &Path, contents: &[u8]) -> Result<(), Failure> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(named(path.display()))?;
    }
    fs::write(path, contents).map_err(named(path.display()))
}

fn noise(seed: u64, count: usize) -> Vec<u8> {
    let mut state = seed;
    let mut byte = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 56) as u8
    };
    (0..count).map(|_| byte()).collect()
}

#[cfg(test)]
mod tests {
    use super::quoted;
    use std::path::Path;

    #[test]
    fn paths_are_strings_of_toml() {
        // Rust writes a combining accent as `\u{301}`, which TOML does not know.
        let strings = ["a\u{301}/it's", "a\\b\"c"].map(|path| quoted(Path::new(path)));
        assert_eq!(strings, ["\"a\u{301}/it's\"", r#""a\\b\"c""#]);
    }
}
