//! `if let … && …`, which Rust before 1.88 does not know, and which no lint finds.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::modules::line;

/// The lines of this source on which a condition joins a `let` to something else by `&&`.
///
/// # Errors
/// If the text is not made of Rust's tokens.
pub fn let_chains(source: &str) -> Result<Vec<usize>, proc_macro2::LexError> {
    let mut lines = Vec::new();
    conditions(source.parse()?, &mut lines);
    Ok(lines)
}

fn conditions(tokens: TokenStream, lines: &mut Vec<usize>) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    for (at, tree) in trees.iter().enumerate() {
        match tree {
            TokenTree::Group(group) => conditions(group.stream(), lines),
            TokenTree::Ident(word) if word == "if" || word == "while" => {
                let rest = &trees[at + 1..];
                let condition = &rest[..condition_end(rest)];
                let has_let = condition.iter().any(|tree| matches!(tree, TokenTree::Ident(word) if word == "let"));
                if has_let && (0..condition.len()).any(|at| are(condition, at, ['&', '&'])) {
                    lines.push(line(word.span()));
                }
            }
            _ => {}
        }
    }
}

/// A condition ends at its block, the guard of a match arm at the arrow.
fn condition_end(trees: &[TokenTree]) -> usize {
    let is_block = |tree: &TokenTree| matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    (0..trees.len()).find(|at| is_block(&trees[*at]) || are(trees, *at, ['=', '>'])).unwrap_or(trees.len())
}

fn are(trees: &[TokenTree], at: usize, wanted: [char; 2]) -> bool {
    let is = |at, wanted| matches!(trees.get(at), Some(TokenTree::Punct(punct)) if punct.as_char() == wanted);
    is(at, wanted[0]) && is(at + 1, wanted[1])
}
