//! A request and its answer.

use crate::error::LessonError;
use crate::lesson::{Lesson, Operator};
use crate::state::State;
use serde::Deserialize;
use serde_json::json;
use std::cell::RefCell;
use twinedge::validate::Record;
use twinedge_web_bridge::{Buffers, Id};

thread_local! {
    static LESSON: RefCell<Lesson> = RefCell::default();
}

#[derive(Deserialize)]
struct Head {
    op: String,
}

#[derive(Deserialize)]
struct Set {
    record: Record,
    field: String,
    value: String,
}

fn read<'a, T: Deserialize<'a>>(json: &'a [u8]) -> Result<T, LessonError> {
    serde_json::from_slice(json).map_err(|error| LessonError::Request(error.to_string()))
}

/// Answers the request in a buffer, and drops it. The answer is in another buffer.
///
/// # Panics
/// If the answer cannot be written as JSON, which does not happen.
pub(crate) fn call(buffers: &mut Buffers, request: Id) -> Id {
    let json = buffers.take(request);
    let answer = match LESSON.with_borrow_mut(|lesson| answer(lesson, &json)) {
        Ok(state) => json!({ "ok": state }),
        Err(error) => json!({ "error": { "code": error.code(), "message": error.to_string(), "place": null } }),
    };
    buffers.add(answer.to_string().into_bytes())
}

fn answer(lesson: &mut Lesson, json: &[u8]) -> Result<State, LessonError> {
    match read::<Head>(json)?.op.as_str() {
        "clear" => *lesson = Lesson::default(),
        "state" => {}
        "undo" => lesson.undo(),
        "redo" => lesson.redo(),
        "forget" => lesson.forget(),
        "set" => {
            let Set { record, field, value } = read(json)?;
            lesson.set(record, &field, &value)?;
        }
        _ => lesson.operate(read::<Operator>(json)?)?,
    }
    Ok(lesson.state())
}
