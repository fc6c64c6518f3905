//! Imports between files, and the loops in them.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::path::{Path, PathBuf};

/// One name that a file takes from another.
#[derive(Clone, Debug, Eq, Ord, PartialEq, PartialOrd)]
pub struct Import {
    /// The file that names it.
    pub from: PathBuf,
    /// The file that defines it.
    pub to: PathBuf,
    /// The name.
    pub name: String,
    /// The first line that names it.
    pub line: usize,
}

impl fmt::Display for Import {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { from, line, name, to, .. } = self;
        write!(f, "{}:{line} imports {name} from {}", from.display(), to.display())
    }
}

/// The imports between files, each name once.
#[derive(Clone, Debug, Default)]
pub struct Imports {
    files: BTreeMap<PathBuf, BTreeMap<PathBuf, BTreeMap<String, usize>>>,
}

/// Files that import each other in a loop: each leads to all others.
#[derive(Clone, Debug)]
pub struct Loop {
    /// The files.
    pub files: Vec<PathBuf>,
    /// The imports between them.
    pub imports: Vec<Import>,
}

impl fmt::Display for Loop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} files import each other:", self.files.len())?;
        self.imports.iter().try_for_each(|import| writeln!(f, "  {import}"))
    }
}

impl Imports {
    pub(crate) fn add(&mut self, import: Import) {
        let Import { from, to, name, line } = import;
        if from == to {
            return;
        }
        let first = self.files.entry(from).or_default().entry(to).or_default().entry(name).or_insert(line);
        *first = line.min(*first);
    }

    /// All imports, in order of the files.
    pub fn iter(&self) -> impl Iterator<Item = Import> {
        self.files.iter().flat_map(|(from, targets)| {
            targets.iter().flat_map(move |(to, names)| {
                names.iter().map(move |(name, line)| Import {
                    from: from.clone(),
                    to: to.clone(),
                    name: name.clone(),
                    line: *line,
                })
            })
        })
    }

    /// The groups of files that import each other in a loop. O(n²) for n files.
    #[must_use]
    pub fn loops(&self) -> Vec<Loop> {
        let reached: BTreeMap<&Path, BTreeSet<&Path>> =
            self.files.keys().map(|file| (file.as_path(), self.reached_from(file))).collect();
        let mut seen = BTreeSet::new();
        let mut loops = Vec::new();
        for (file, targets) in &reached {
            if !targets.contains(file) || seen.contains(file) {
                continue;
            }
            let files: BTreeSet<&Path> =
                targets.iter().copied().filter(|to| reached.get(to).is_some_and(|back| back.contains(file))).collect();
            seen.extend(files.iter().copied());
            let within = |import: &Import| files.contains(&*import.from) && files.contains(&*import.to);
            loops.push(Loop {
                files: files.iter().map(|file| file.to_path_buf()).collect(),
                imports: self.iter().filter(within).collect(),
            });
        }
        loops
    }

    fn reached_from(&self, start: &Path) -> BTreeSet<&Path> {
        let mut reached = BTreeSet::new();
        let mut waiting = vec![start];
        while let Some(file) = waiting.pop() {
            for to in self.files.get(file).into_iter().flat_map(BTreeMap::keys) {
                if reached.insert(to.as_path()) {
                    waiting.push(to);
                }
            }
        }
        reached
    }
}
