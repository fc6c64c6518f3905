//! A request and its answer.
//!
//! A request is `{"op": …}` with the arguments of the operation; `{"buffer": 3}` in it stands for bytes. The answer is
//! `{"ok": …}` or `{"error": …}`.

use crate::error::CallError;
use crate::{audit, check, clean, convert, neighbours, validate, voronoi};
use serde::Deserialize;
use serde_json::{Value, json};
use twinedge_web_bridge::{Buffers, Id};

#[derive(Deserialize)]
#[serde(tag = "op", rename_all = "snake_case")]
enum Request {
    Audit(audit::Request),
    Clean(clean::Request),
    Convert(convert::Request),
    Neighbours(neighbours::Request),
    Voronoi(voronoi::Request),
    Validate(validate::Request),
    Check(check::Request),
}

/// Answers a request whose JSON is in a buffer. Takes the request and the buffers that it names, and leaves the answer
/// in another buffer.
///
/// # Panics
/// If the answer cannot be written as JSON, which does not happen.
pub(crate) fn call(buffers: &mut Buffers, request: Id, stage: &mut dyn FnMut(&'static str)) -> Id {
    let json = buffers.take(request);
    let answer = match answer(buffers, &json, stage) {
        Ok(ok) => json!({ "ok": ok }),
        Err(error) => {
            // Drops the buffers written before the error, which nobody reads.
            *buffers = Buffers::default();
            json!({ "error": error.json() })
        }
    };
    buffers.add(answer.to_string().into_bytes())
}

fn answer(buffers: &mut Buffers, json: &[u8], stage: &mut dyn FnMut(&'static str)) -> Result<Value, CallError> {
    let request = serde_json::from_slice(json).map_err(|error| {
        // The position in the request means nothing to callers who wrote no JSON.
        let text = error.to_string();
        CallError::option(text.split(" at line ").next().unwrap_or(&text))
    })?;
    match request {
        Request::Audit(asked) => audit::answer(asked, buffers, stage),
        Request::Clean(asked) => clean::answer(asked, buffers, stage),
        Request::Convert(asked) => convert::answer(asked, buffers),
        Request::Neighbours(asked) => neighbours::answer(asked, buffers, stage),
        Request::Voronoi(asked) => voronoi::answer(asked, buffers),
        Request::Validate(asked) => validate::answer(asked, buffers),
        Request::Check(asked) => check::answer(asked, buffers),
    }
}
