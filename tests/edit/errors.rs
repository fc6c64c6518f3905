//! Each refusal, with what it names.
