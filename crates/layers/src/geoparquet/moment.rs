//! Days and times: the numbers of Parquet, and the texts of a layer.

use chrono::{DateTime, NaiveDate, NaiveDateTime, SecondsFormat};

const DAY: &str = "%Y-%m-%d";

const SECOND: i128 = 1_000_000_000;

/// Returns the day `days` days after 1 January 1970; `None` beyond the years 0 to 9999.
pub(super) fn day(days: i64) -> Option<String> {
    let moment = DateTime::from_timestamp(days.checked_mul(86_400)?, 0)?;
    Some(moment.format(DAY).to_string()).filter(|text| is_usual(text))
}

/// Returns the number of a day in the notation of [`day`].
pub(super) fn days(text: &str) -> Option<i32> {
    let date = NaiveDate::parse_from_str(text, DAY).ok()?;
    let days = date.signed_duration_since(NaiveDate::default()).num_days();
    i32::try_from(days).ok().filter(|_| day(days).as_deref() == Some(text))
}

/// Returns the moment `nanoseconds` after the beginning of 1970, with the necessary digits: in UTC, or in an unspecified local
/// time.
pub(super) fn moment(nanoseconds: i128, is_utc: bool) -> Option<String> {
    let seconds = i64::try_from(nanoseconds.div_euclid(SECOND)).ok()?;
    let moment = DateTime::from_timestamp(seconds, nanoseconds.rem_euclid(SECOND) as u32)?;
    let text = moment.to_rfc3339_opts(SecondsFormat::AutoSi, true);
    let text = if is_utc { text } else { text.trim_end_matches('Z').to_owned() };
    Some(text).filter(|text| is_usual(text))
}

/// Returns the microseconds of a moment since the beginning of 1970, and whether it is in UTC, if written as in [`moment`].
pub(super) fn microseconds(text: &str) -> Option<(i64, bool)> {
    let is_utc = text.ends_with('Z');
    let parsed = NaiveDateTime::parse_from_str(text.trim_end_matches('Z'), "%Y-%m-%dT%H:%M:%S%.f").ok()?;
    let microseconds = parsed.and_utc().timestamp_micros();
    let again = moment(i128::from(microseconds) * 1_000, is_utc);
    (again.as_deref() == Some(text)).then_some((microseconds, is_utc))
}

/// Returns true if the year has four digits and no sign.
fn is_usual(text: &str) -> bool {
    text.as_bytes().get(..5).is_some_and(|year| year[..4].iter().all(u8::is_ascii_digit) && year[4] == b'-')
}
