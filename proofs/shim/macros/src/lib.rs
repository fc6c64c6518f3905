//! The names of Kani's attributes that the harnesses use.

use proc_macro::{TokenStream, TokenTree};

/// Marks a harness: the function as it is, and a test that runs it over every choice.
#[proc_macro_attribute]
pub fn proof(_: TokenStream, item: TokenStream) -> TokenStream {
    let mut after_fn = item.clone().into_iter().skip_while(|token| token.to_string() != "fn").skip(1);
    let Some(TokenTree::Ident(name)) = after_fn.next() else {
        return "compile_error!(\"a harness is a function\");".parse().unwrap_or_default();
    };
    let test = format!("#[cfg(test)] #[test] fn executed_{name}() {{ kani::check(stringify!({name}), {name}); }}");
    [item, test.parse().unwrap_or_default()].into_iter().collect()
}

/// Bounds the number of iterations of every loop.
#[proc_macro_attribute]
pub fn unwind(_: TokenStream, item: TokenStream) -> TokenStream {
    item
}
