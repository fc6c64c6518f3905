//! Runs programs in a child process, to detect programs that never end, take all memory or overflow the stack.

use crate::entry::Entry;
use crate::program::Program;
use crate::run::{Finding, Verdict};
use std::io::{BufRead, BufReader, Write};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// The time limit of a program. Programs take milliseconds.
const PATIENCE: Duration = Duration::from_secs(5);
/// The memory limit of the child in KiB, where the shell supports it.
const MEMORY: &str = "4000000";

/// A child process that runs programs of one crate.
pub struct Judge {
    entry: Entry,
    executable: PathBuf,
    child: Option<(Child, Receiver<String>)>,
}

impl Judge {
    /// Creates a judge for this crate, whose child runs `EXECUTABLE worker CRATE`: the program of this package.
    #[must_use]
    pub const fn new(entry: Entry, executable: PathBuf) -> Self {
        Self { entry, executable, child: None }
    }

    /// Runs a program in the child process, and returns its verdict.
    ///
    /// # Errors
    /// If no child can be started.
    pub fn run(&mut self, program: &Program) -> std::io::Result<Verdict> {
        let (child, answers) = match &mut self.child {
            Some(child) => child,
            none => none.insert(start(&self.executable, self.entry.name)?),
        };
        let text = program.to_text(self.entry.operators);
        let sent =
            child.stdin.as_mut().is_some_and(|input| writeln!(input, "{text}").and_then(|()| input.flush()).is_ok());
        let mut last = String::new();
        loop {
            let answer = if sent { answers.recv_timeout(PATIENCE) } else { Err(RecvTimeoutError::Disconnected) };
            let what = match answer.as_deref().map(read) {
                Ok(Answer::Calls(operator)) => {
                    operator.clone_into(&mut last);
                    continue;
                }
                Ok(Answer::Verdict(verdict)) => return Ok(verdict),
                Err(RecvTimeoutError::Timeout) => "does not return",
                Err(RecvTimeoutError::Disconnected) => "ends the process",
            };
            self.stop();
            return Ok(Verdict::Finding(Finding { operator: last, what: what.to_owned(), detail: String::new() }));
        }
    }

    fn stop(&mut self) {
        if let Some((mut child, _)) = self.child.take() {
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

impl Drop for Judge {
    fn drop(&mut self) {
        self.stop();
    }
}

fn start(executable: &PathBuf, name: &str) -> std::io::Result<(Child, Receiver<String>)> {
    let mut command = if cfg!(unix) {
        let mut shell = Command::new("sh");
        shell.arg("-c").arg(format!("ulimit -v {MEMORY} 2>/dev/null; exec \"$0\" \"$@\"")).arg(executable);
        shell
    } else {
        Command::new(executable)
    };
    command.arg("worker").arg(name).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null());
    let mut child = command.spawn()?;
    let output = child.stdout.take().ok_or_else(|| std::io::Error::other("the child has no output"))?;
    let (sender, answers) = channel();
    std::thread::spawn(move || {
        for line in BufReader::new(output).lines().map_while(Result::ok) {
            if sender.send(line).is_err() {
                break;
            }
        }
    });
    Ok((child, answers))
}

enum Answer<'a> {
    /// The next call is of this operator.
    Calls(&'a str),
    /// The program has ended.
    Verdict(Verdict),
}

fn read(line: &str) -> Answer<'_> {
    let fields = line.split('\t').collect::<Vec<_>>();
    match fields[..] {
        ["calls", operator] => Answer::Calls(operator),
        ["sound", done, refused, skipped] => {
            let [done, refused, skipped] = [done, refused, skipped].map(|count| count.parse().unwrap_or_default());
            Answer::Verdict(Verdict::Sound { done, refused, skipped })
        }
        ["finding", operator, what, detail] => {
            let [operator, what, detail] = [operator, what, detail].map(str::to_owned);
            Answer::Verdict(Verdict::Finding(Finding { operator, what, detail }))
        }
        _ => Answer::Calls(""),
    }
}

/// Reads programs, one per line, and answers with one line for each call and one for the verdict.
///
/// # Errors
/// If the input cannot be read, or the output not written.
pub fn serve(entry: &Entry) -> std::io::Result<()> {
    for line in std::io::stdin().lines() {
        let program = Program::parse(&line?, entry.operators).map_err(std::io::Error::other)?;
        let answer = match (entry.run)(&program, &mut |operator| println!("calls\t{operator}")) {
            Verdict::Sound { done, refused, skipped } => format!("sound\t{done}\t{refused}\t{skipped}"),
            Verdict::Finding(Finding { operator, what, detail }) => {
                format!("finding\t{operator}\t{what}\t{}", detail.replace(['\n', '\t'], " "))
            }
        };
        println!("{answer}");
    }
    Ok(())
}
