//! The names of Kani's attributes that the harnesses use, for the type-checker only. Both hand the item back unchanged.

use proc_macro::TokenStream;

/// Marks a harness.
#[proc_macro_attribute]
pub fn proof(_: TokenStream, item: TokenStream) -> TokenStream {
    item
}

/// Bounds the number of iterations of every loop.
#[proc_macro_attribute]
pub fn unwind(_: TokenStream, item: TokenStream) -> TokenStream {
    item
}
