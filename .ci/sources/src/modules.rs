//! The modules of a crate, with the names that each defines, imports and mentions.

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use syn::{Attribute, Expr, ExprLit, Item, ItemMod, Lit, Meta, UseTree, Visibility};

use crate::Crate;

/// The place of a module in [`Forest::modules`].
pub(crate) type ModuleId = usize;

/// The meaning of a name in a module.
#[derive(Clone, Debug)]
pub(crate) enum Meaning {
    /// Something that this module defines.
    Defined(ModuleId),
    /// A module in it.
    Module(ModuleId),
    /// The target of this path.
    Imported(Vec<String>),
}

/// Part of the code of a module.
#[derive(Clone, Debug)]
pub(crate) enum Code {
    /// A `use`: these paths are named, whether or not the code mentions them again.
    Use(Vec<(Vec<String>, usize)>),
    /// Anything else.
    Tokens(TokenStream),
}

/// A module, in a file of its own or in that of its parent.
#[derive(Debug)]
pub(crate) struct Module {
    pub file: PathBuf,
    pub parent: Option<ModuleId>,
    pub root: ModuleId,
    pub names: BTreeMap<String, Vec<Meaning>>,
    pub globs: Vec<Vec<String>>,
    pub code: Vec<Code>,
}

/// The modules of all crates.
#[derive(Debug, Default)]
pub(crate) struct Forest {
    pub modules: Vec<Module>,
    pub libraries: BTreeMap<String, ModuleId>,
}

/// A source that cannot be read.
#[derive(Debug)]
#[non_exhaustive]
pub enum Unreadable {
    /// There is no file for the module `name` of this file.
    Missing {
        /// The file with the declaration, or the root of a crate.
        file: PathBuf,
        /// The module.
        name: String,
    },
    /// The file is not Rust.
    Syntax {
        /// The file.
        file: PathBuf,
        /// The error of the parser.
        error: syn::Error,
    },
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing { file, name } => write!(f, "{}: no file for module {name}", file.display()),
            Self::Syntax { file, error } => {
                write!(f, "{}:{}: {error}", file.display(), error.span().start().line)
            }
        }
    }
}

impl std::error::Error for Unreadable {}

type Read<'a> = &'a dyn Fn(&Path) -> Option<String>;

pub(crate) fn read(crates: &[Crate], read: Read<'_>) -> Result<Forest, Unreadable> {
    let mut forest = Forest::default();
    for each in crates {
        let directory = each.root.parent().map(Path::to_path_buf).unwrap_or_default();
        let text = read(&each.root)
            .ok_or_else(|| Unreadable::Missing { file: each.root.clone(), name: "crate".to_owned() })?;
        let root = forest.file(&each.root, &directory, &text, None, read)?;
        if each.is_library {
            forest.libraries.insert(each.name.clone(), root);
        }
    }
    Ok(forest)
}

impl Forest {
    fn add(&mut self, file: &Path, parent: Option<ModuleId>) -> ModuleId {
        let id = self.modules.len();
        let root = parent.map_or(id, |parent| self.modules[parent].root);
        let file = file.to_path_buf();
        let (names, globs, code) = (BTreeMap::new(), Vec::new(), Vec::new());
        self.modules.push(Module { file, parent, root, names, globs, code });
        id
    }

    /// `directory` is where the files of the modules declared here are.
    fn file(
        &mut self,
        file: &Path,
        directory: &Path,
        text: &str,
        parent: Option<ModuleId>,
        read: Read<'_>,
    ) -> Result<ModuleId, Unreadable> {
        let syntax = |error| Unreadable::Syntax { file: file.to_path_buf(), error };
        let items = syn::parse_file(text).map_err(syntax)?.items;
        let id = self.add(file, parent);
        self.items(id, directory, &items, read)?;
        Ok(id)
    }

    fn items(&mut self, id: ModuleId, directory: &Path, items: &[Item], read: Read<'_>) -> Result<(), Unreadable> {
        for item in items {
            match item {
                Item::Mod(module) => self.module(id, directory, module, read)?,
                Item::Use(import) => {
                    let mut leaves = Leaves::default();
                    let start = if import.leading_colon.is_some() { vec![String::new()] } else { Vec::new() };
                    leaves.tree(&start, &import.tree);
                    let module = &mut self.modules[id];
                    for (name, path) in leaves.names {
                        module.names.entry(name).or_default().push(Meaning::Imported(path));
                    }
                    module.globs.extend(leaves.globs);
                    if matches!(import.vis, Visibility::Inherited) {
                        module.code.push(Code::Use(leaves.all));
                    }
                }
                other => {
                    if let Some(name) = defined(other) {
                        // A macro that is exported has its name in the root.
                        let is_exported = matches!(other, Item::Macro(item) if item.attrs.iter().any(|a| a.path().is_ident("macro_export")));
                        let at = if is_exported { self.modules[id].root } else { id };
                        self.modules[at].names.entry(name).or_default().push(Meaning::Defined(id));
                    }
                    self.modules[id].code.push(Code::Tokens(other.to_token_stream()));
                }
            }
        }
        Ok(())
    }

    fn module(
        &mut self,
        parent: ModuleId,
        directory: &Path,
        module: &ItemMod,
        read: Read<'_>,
    ) -> Result<(), Unreadable> {
        let name = module.ident.to_string();
        let file = self.modules[parent].file.clone();
        let child = if let Some((_, items)) = &module.content {
            let id = self.add(&file, Some(parent));
            self.items(id, &directory.join(&name), items, read)?;
            id
        } else {
            let is_inline =
                |module: ModuleId| self.modules[module].parent.is_some_and(|p| self.modules[p].file == file);
            let beside = if is_inline(parent) { Some(directory) } else { file.parent() }.unwrap_or(Path::new(""));
            let named = path_attribute(&module.attrs).map(|path| normal(&beside.join(path)));
            let candidates = match named {
                Some(path) => {
                    let directory = path.parent().map(Path::to_path_buf).unwrap_or_default();
                    vec![(path, directory)]
                }
                None => vec![
                    (directory.join(format!("{name}.rs")), directory.join(&name)),
                    (directory.join(&name).join("mod.rs"), directory.join(&name)),
                ],
            };
            let found = candidates.into_iter().find_map(|(path, inner)| read(&path).map(|text| (path, inner, text)));
            let Some((path, inner, text)) = found else {
                return Err(Unreadable::Missing { file, name });
            };
            self.file(&path, &inner, &text, Some(parent), read)?
        };
        self.modules[parent].names.entry(name).or_default().push(Meaning::Module(child));
        Ok(())
    }
}

/// `a/b/../c` is `a/c`.
fn normal(path: &Path) -> PathBuf {
    let mut normal = PathBuf::new();
    for part in path.components() {
        match part {
            std::path::Component::ParentDir if normal.file_name().is_some() => {
                normal.pop();
            }
            other => normal.push(other),
        }
    }
    normal
}

fn path_attribute(attributes: &[Attribute]) -> Option<String> {
    attributes.iter().find(|attribute| attribute.path().is_ident("path")).and_then(|attribute| match &attribute.meta {
        Meta::NameValue(pair) => text(&pair.value),
        _ => None,
    })
}

fn text(value: &Expr) -> Option<String> {
    match value {
        Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => Some(text.value()),
        _ => None,
    }
}

fn defined(item: &Item) -> Option<String> {
    let ident = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::TraitAlias(item) => &item.ident,
        Item::Type(item) => &item.ident,
        Item::Union(item) => &item.ident,
        _ => return None,
    };
    Some(ident.to_string())
}

/// The leaves of a `use` tree.
#[derive(Default)]
struct Leaves {
    names: Vec<(String, Vec<String>)>,
    globs: Vec<Vec<String>>,
    all: Vec<(Vec<String>, usize)>,
}

impl Leaves {
    fn tree(&mut self, prefix: &[String], tree: &UseTree) {
        match tree {
            UseTree::Path(path) => self.tree(&extended(prefix, &path.ident.to_string()), &path.tree),
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.tree(prefix, tree)),
            UseTree::Name(name) => self.leaf(prefix, &name.ident.to_string(), None, name.ident.span()),
            UseTree::Rename(rename) => {
                let new = rename.rename.to_string();
                self.leaf(prefix, &rename.ident.to_string(), Some(new), rename.ident.span());
            }
            UseTree::Glob(_) => self.globs.push(prefix.to_vec()),
        }
    }

    /// `use a::b::{self}` imports `b` from `a`.
    fn leaf(&mut self, prefix: &[String], name: &str, new: Option<String>, span: Span) {
        let path = if name == "self" && !prefix.is_empty() { prefix.to_vec() } else { extended(prefix, name) };
        let name = new.or_else(|| path.last().cloned()).unwrap_or_default();
        self.all.push((path.clone(), line(span)));
        self.names.push((name, path));
    }
}

fn extended(prefix: &[String], name: &str) -> Vec<String> {
    prefix.iter().cloned().chain([name.to_owned()]).collect()
}

/// The line where this begins, counted from 1.
pub(crate) fn line(span: Span) -> usize {
    span.start().line
}
