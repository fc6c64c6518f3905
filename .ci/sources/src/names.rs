//! Resolution of paths.

use std::collections::BTreeSet;
use std::path::Path;

use crate::modules::{Forest, Meaning, ModuleId};

/// The target of a path.
#[derive(Clone, Debug, Eq, Ord, PartialEq, PartialOrd)]
pub(crate) enum Target {
    Module(ModuleId),
    /// Something that this module defines by this name.
    Item(ModuleId, String),
}

type Visited = BTreeSet<(ModuleId, String)>;

impl Forest {
    /// Returns the targets of a path that is written in this module. A name can have several, as a type, a value, a macro and a
    /// module have names of their own. Items outside the crates that were read are no targets.
    pub(crate) fn resolve(&self, module: ModuleId, path: &[String]) -> BTreeSet<Target> {
        self.follow(module, path, &mut Visited::new())
    }

    /// The file that holds this module.
    pub(crate) fn file_of(&self, module: ModuleId) -> &Path {
        &self.modules[module].file
    }

    fn follow(&self, module: ModuleId, path: &[String], visited: &mut Visited) -> BTreeSet<Target> {
        let Some((first, mut rest)) = path.split_first() else {
            return BTreeSet::new();
        };
        let mut reached = match first.as_str() {
            "crate" | "$crate" => BTreeSet::from([Target::Module(self.modules[module].root)]),
            "self" => BTreeSet::from([Target::Module(module)]),
            "super" => self.modules[module].parent.map(Target::Module).into_iter().collect(),
            // `::name`
            "" => match rest.split_first() {
                Some((name, after)) => {
                    rest = after;
                    self.library(name)
                }
                None => BTreeSet::new(),
            },
            name => {
                let here = self.look_up(module, name, visited);
                if here.is_empty() { self.library(name) } else { here }
            }
        };
        for name in rest {
            // A path does not go on from a function that has the name of a module.
            if reached.iter().any(|target| matches!(target, Target::Module(_))) {
                reached.retain(|target| matches!(target, Target::Module(_)));
            }
            let mut next = BTreeSet::new();
            for target in reached {
                match target {
                    Target::Module(id) if name == "super" => next.extend(self.modules[id].parent.map(Target::Module)),
                    Target::Module(id) => {
                        let found = self.look_up(id, name, visited);
                        // An item that a macro defines has no name here, but its path says where it is.
                        if found.is_empty() {
                            next.insert(Target::Item(id, name.clone()));
                        }
                        next.extend(found);
                    }
                    // A variant, a constant or a function of a type.
                    item @ Target::Item(..) => {
                        next.insert(item);
                    }
                }
            }
            reached = next;
        }
        reached
    }

    fn library(&self, name: &str) -> BTreeSet<Target> {
        self.libraries.get(name).map(|root| Target::Module(*root)).into_iter().collect()
    }

    fn look_up(&self, id: ModuleId, name: &str, visited: &mut Visited) -> BTreeSet<Target> {
        if !visited.insert((id, name.to_owned())) {
            return BTreeSet::new();
        }
        let module = &self.modules[id];
        let mut found = BTreeSet::new();
        for meaning in module.names.get(name).into_iter().flatten() {
            match meaning {
                Meaning::Defined(at) => {
                    found.insert(Target::Item(*at, name.to_owned()));
                }
                Meaning::Module(child) => {
                    found.insert(Target::Module(*child));
                }
                Meaning::Imported(path) => found.extend(self.follow_import(id, name, path, visited)),
            }
        }
        if found.is_empty() {
            for glob in &module.globs {
                for target in self.follow(id, glob, visited) {
                    if let Target::Module(from) = target {
                        found.extend(self.look_up(from, name, visited));
                    }
                }
            }
        }
        visited.remove(&(id, name.to_owned()));
        found
    }

    /// `use name::…` in a module that imports `name` means a library, not itself.
    fn follow_import(&self, id: ModuleId, name: &str, path: &[String], visited: &mut Visited) -> BTreeSet<Target> {
        if path.first().is_some_and(|first| first == name) && path.len() == 1 {
            return self.library(name);
        }
        self.follow(id, path, visited)
    }
}
