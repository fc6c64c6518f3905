//! The plan of a validation: the caller's description of a structure.

use crate::callbacks::{Callback, InnerOf, LinkOf};
use crate::cells::{Cells, Width};
use crate::failure::{Failure, Status};
use crate::names::{Expect, Link, Record};
use std::collections::BTreeMap;
use twinedge::validate::{Collect, Expectation};
use twinedge_columns::Preset;

/// The expectation of the caller.
#[derive(Clone, Debug, Default)]
pub(crate) struct Claims {
    preset: Option<Preset>,
    plane: bool,
    open: bool,
    /// The optional rules, by their words, with their numbers.
    asked: BTreeMap<&'static str, Option<usize>>,
    list: Option<usize>,
}

impl Claims {
    pub(crate) fn set(&mut self, what: Expect, number: usize) {
        let is_asked = number != 0;
        let (word, number) = match what {
            Expect::Plane => return self.plane = is_asked,
            Expect::Open => return self.open = is_asked,
            Expect::List => return self.list = Some(number),
            Expect::Simple => ("simple", None),
            Expect::Closed => ("closed", None),
            Expect::Used => ("no-unused-vertices", None),
            Expect::BorderKept => ("border-kept", None),
            Expect::Sides => ("sides", Some(number)),
            Expect::Components => ("components", Some(number)),
            Expect::Borders => ("borders", Some(number)),
            Expect::Genus => ("genus", Some(number)),
        };
        if is_asked || number.is_some() {
            self.asked.insert(word, number);
        } else {
            self.asked.remove(word);
        }
    }

    pub(crate) fn preset(&mut self, name: &str) -> Result<(), Failure> {
        let preset = Preset::from_name(name).ok_or_else(|| {
            let names: Vec<_> = Preset::ALL.iter().map(|preset| preset.name()).collect();
            let message = format!("preset: there is none named {name:?}; there are {}", names.join(", "));
            Failure::new(Status::Unknown, message)
        })?;
        self.preset = Some(preset);
        Ok(())
    }

    /// Returns the number of violations to list.
    pub(crate) fn collect(&self) -> Collect {
        self.list.map_or(Collect::All, Collect::AtMost)
    }

    pub(crate) fn expectation(&self) -> Result<Expectation, Failure> {
        let mut expectation = match (self.preset, self.plane) {
            (None, false) => Expectation::surface(),
            (None, true) => Expectation::plane(),
            (Some(preset), false) => preset.expectation(),
            (Some(_), true) => {
                return Err(Failure::new(Status::Conflict, "plane: a preset says on which surface the structure lies"));
            }
        };
        if self.open {
            expectation = expectation.open();
        }
        for (word, number) in &self.asked {
            let asked = expectation.asking(word, *number);
            expectation = asked.map_err(|error| Failure::new(Status::Unknown, error.to_string()))?;
        }
        Ok(expectation)
    }
}

/// A structure as the caller describes it. It owns no memory of the caller.
#[derive(Clone, Debug, Default)]
pub(crate) struct Plan {
    pub(crate) width: Option<Width>,
    pub(crate) columns: [Option<Cells>; Link::KINDS],
    pub(crate) live: [Option<Cells>; Record::KINDS],
    pub(crate) counts: [Option<usize>; Record::KINDS],
    pub(crate) records: [Option<Cells>; Record::KINDS],
    pub(crate) links: [Option<Callback<LinkOf>>; Link::KINDS],
    pub(crate) inner: Option<Callback<InnerOf>>,
    pub(crate) asked: Claims,
}

impl Plan {
    pub(crate) fn column(&mut self, link: Link, width: Width, cells: Cells) -> Result<(), Failure> {
        if self.width.is_some_and(|other| other != width) {
            let message = format!("{}: the columns before are of another type", link.name());
            return Err(Failure::new(Status::Type, message));
        }
        self.width = Some(width);
        self.columns[link as usize] = Some(cells);
        Ok(())
    }

    /// Returns true if the structure is one of pointers.
    pub(crate) fn is_of_pointers(&self) -> Result<bool, Failure> {
        let pointers =
            self.records.iter().any(Option::is_some) || self.links.iter().any(Option::is_some) || self.inner.is_some();
        if pointers && self.width.is_some() {
            return Err(Failure::new(Status::Conflict, "give either columns or records with functions"));
        }
        Ok(pointers)
    }

    /// Returns true if the caller gave the link: by a column, or by a function.
    pub(crate) fn gives(&self, link: Link) -> bool {
        let by_list = matches!(link, Link::InnerFirst | Link::Inner) && self.inner.is_some();
        by_list || self.columns[link as usize].is_some() || self.links[link as usize].is_some()
    }

    /// Checks that a structure of pointers has the required links, and the lists of all records that links join.
    pub(crate) fn pointers_are_complete(&self) -> Result<(), Failure> {
        let listed = |link: Link, kind: Record| {
            if self.records[kind as usize].is_some() {
                return Ok(());
            }
            let message = format!("{}: needs the list of {} (`twinedge_pointers`)", link.name(), kind.names());
            Err(Failure::new(Status::Missing, message))
        };
        for (link, _) in Link::ALL.into_iter().zip(&self.links).filter(|(_, function)| function.is_some()) {
            if let Some((from, to)) = link.ends() {
                listed(link, from)?;
                listed(link, to)?;
            }
        }
        if self.inner.is_some() {
            listed(Link::Inner, Record::Face)?;
            listed(Link::Inner, Record::Boundary)?;
        }
        for link in [Link::Next, Link::Twin] {
            if !self.gives(link) {
                return Err(Failure::new(Status::Missing, format!("{}: missing", link.name())));
            }
        }
        Ok(())
    }
}
