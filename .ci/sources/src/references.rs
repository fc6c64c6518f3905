//! The paths that code names, and the imports that follow from them.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::graph::{Import, Imports};
use crate::modules::{Code, Forest, ModuleId, line};
use crate::names::Target;

pub(crate) fn imports(forest: &Forest) -> Imports {
    let mut imports = Imports::default();
    for id in 0..forest.modules.len() {
        for code in &forest.modules[id].code {
            let mut paths = Vec::new();
            match code {
                Code::Use(named) => paths.clone_from(named),
                Code::Tokens(tokens) => scan(tokens.clone(), &mut paths),
            }
            for (path, line) in paths {
                record(forest, id, &path, line, &mut imports);
            }
        }
    }
    imports
}

/// A module that is named alone is no import: the paths that go on from it are.
fn record(forest: &Forest, from: ModuleId, path: &[String], line: usize, imports: &mut Imports) {
    for target in forest.resolve(from, path) {
        if let Target::Item(to, name) = target {
            let (from, to) = (forest.file_of(from).to_path_buf(), forest.file_of(to).to_path_buf());
            imports.add(Import { from, to, name, line });
        }
    }
}

/// All paths in these tokens, those of `use` trees inside functions included.
fn scan(tokens: TokenStream, paths: &mut Vec<(Vec<String>, usize)>) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let mut at = 0;
    while at < trees.len() {
        match &trees[at] {
            TokenTree::Group(group) => {
                scan(group.stream(), paths);
                at += 1;
            }
            // `.name` is a field or a method, `'name` a lifetime.
            TokenTree::Punct(punct) if matches!(punct.as_char(), '.' | '\'') => {
                let range = punct.as_char() == '.' && is_punct(trees.get(at + 1), '.');
                let skipped = !range && matches!(trees.get(at + 1), Some(TokenTree::Ident(_)));
                at += if range || skipped { 2 } else { 1 };
            }
            TokenTree::Ident(_) => at = path(&trees, at, &[], paths),
            _ if is_separator(&trees, at) => match trees.get(at + 2) {
                Some(TokenTree::Ident(_)) => at = path(&trees, at + 2, &[String::new()], paths),
                _ => at += 2,
            },
            _ => at += 1,
        }
    }
}

/// Reads the path that begins at this identifier, and says where it ends.
fn path(trees: &[TokenTree], start: usize, prefix: &[String], paths: &mut Vec<(Vec<String>, usize)>) -> usize {
    let mut path = prefix.to_vec();
    let mut at = start;
    let mut place = 1;
    while let Some(TokenTree::Ident(ident)) = trees.get(at) {
        let dollar = at > 0 && is_punct(trees.get(at - 1), '$') && ident == "crate";
        path.push(if dollar { "$crate".to_owned() } else { ident.to_string() });
        place = line(ident.span());
        at += 1;
        if !is_separator(trees, at) {
            break;
        }
        match trees.get(at + 2) {
            Some(TokenTree::Ident(_)) => at += 2,
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => {
                branches(&path, group.stream(), paths);
                return at + 3;
            }
            // `*`, or the `<` of type arguments.
            _ => break,
        }
    }
    let alone = path.len() == 1;
    let called = is_separator(trees, at)
        || is_punct(trees.get(at), '!')
        || matches!(trees.get(at), Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis);
    let capital = path[0].starts_with(|c: char| c.is_uppercase());
    // A single small letter word that is not called is a variable, more often than not.
    let field = alone && is_punct(trees.get(at), ':') && !is_separator(trees, at);
    let defined = start > 0
        && matches!(&trees[start - 1], TokenTree::Ident(before)
            if ["fn", "let", "mut", "struct", "enum", "trait", "type", "mod", "macro_rules"].iter().any(|word| before == word));
    if !(alone && (defined || field || !(capital || called))) {
        paths.push((path, place));
    }
    at
}

/// The branches of a `use` tree, each a path of its own.
fn branches(prefix: &[String], stream: TokenStream, paths: &mut Vec<(Vec<String>, usize)>) {
    let trees: Vec<TokenTree> = stream.into_iter().collect();
    for branch in trees.split(|tree| is_punct(Some(tree), ',')) {
        match branch.first() {
            Some(TokenTree::Ident(ident)) if ident == "self" && branch.len() == 1 => {
                paths.push((prefix.to_vec(), line(ident.span())));
            }
            Some(TokenTree::Ident(_)) => {
                path(branch, 0, prefix, paths);
            }

            _ => {}
        }
    }
}

fn is_separator(trees: &[TokenTree], at: usize) -> bool {
    is_punct(trees.get(at), ':') && is_punct(trees.get(at + 1), ':')
}

fn is_punct(tree: Option<&TokenTree>, wanted: char) -> bool {
    matches!(tree, Some(TokenTree::Punct(punct)) if punct.as_char() == wanted)
}
