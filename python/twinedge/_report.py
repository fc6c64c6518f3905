"""What a validation found."""

from __future__ import annotations

import html
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from . import _twinedge

if TYPE_CHECKING:
    import pandas as pd

#: How many violations ``repr`` shows.
_SHOWN = 5


@dataclass(frozen=True)
class Record:
    """A record, by its kind and its index."""

    #: ``"vertex"``, ``"half_edge"``, ``"boundary"`` or ``"face"``.
    kind: str
    #: Its position in the arrays.
    index: int

    def __str__(self) -> str:
        return f"{self.kind.replace('_', '-')} {self.index}"


@dataclass(frozen=True)
class Rule:
    """The outcome of one rule."""

    #: As ``"L1"``.
    id: str
    #: On how many records it was checked.
    checked: int
    #: How many violations were found, listed or not.
    violations: int
    #: Why it was not checked on all records, as in the JSON form of reports; ``None`` if it was.
    unchecked: str | dict[str, str] | None


@dataclass(frozen=True)
class Violation:
    """One broken rule, with the records that break it."""

    #: The id of the rule, as ``"L1"``.
    rule: str
    #: The stable name, one of :data:`twinedge.KINDS`.
    kind: str
    #: At most two, the one at fault first.
    records: tuple[Record, ...]
    #: A sentence.
    message: str
    #: What the violation is about, by name, as ``{"half_edge": 3, "twin": 4, "found": None}``.
    fields: dict[str, Any]
    #: Points, for a map.
    at: tuple[tuple[float, float], ...] = ()
    #: The positions of the features concerned, for a map.
    features: tuple[int, ...] = ()

    def _explained(self) -> tuple[str, str]:
        entry: dict[str, Any] = {"kind": self.kind}
        if self.fields:
            entry["fields"] = self.fields
        return _twinedge.explain(json.dumps(entry))

    @property
    def cause(self) -> str:
        """What usually causes it."""
        return self._explained()[0]

    @property
    def remedy(self) -> str:
        """What mends it."""
        return self._explained()[1]

    def __str__(self) -> str:
        return f"{self.rule}: {self.message}"


@dataclass(frozen=True)
class Finding:
    """What is wrong with a list of faces, or with the polygons of a map as a coverage (rules C1 to C6)."""

    #: As ``"non_manifold_vertex"`` of a mesh, ``"overlap"`` of a coverage.
    kind: str
    #: A sentence.
    message: str
    #: All keys of the JSON form: ``faces`` and ``vertices`` of a mesh; ``rule``, ``features``, ``at``, ``area`` of a map.
    fields: dict[str, Any]

    def __str__(self) -> str:
        return f"{self.kind}: {self.message}"


class InvalidStructure(ValueError):
    """What :meth:`Report.raise_if_invalid` raises. Its report is the attribute ``report``."""

    def __init__(self, report: Report) -> None:
        super().__init__(str(report))
        self.report = report

    def __reduce__(self) -> tuple[Any, ...]:
        return (InvalidStructure, (self.report,))


class Report:
    """What a validation found. Reports compare equal if their JSON does.

    ``bool(report)`` is an error, as it would be read in two ways: ask for :attr:`valid`.
    """

    def __init__(self, document: str | Mapping[str, Any]) -> None:
        """From the JSON form, which ``docs/report.md`` of the project describes.

        Raises ``ValueError`` if it has another version.
        """
        found = json.loads(document) if isinstance(document, str) else dict(document)
        if found.get("schema") != _twinedge.REPORT_SCHEMA:
            raise ValueError(f"expected the schema {_twinedge.REPORT_SCHEMA}, not {found.get('schema')!r}")
        self._document: dict[str, Any] = found

    @property
    def valid(self) -> bool:
        """Whether no violation was found and every rule that applies was checked."""
        return bool(self._document["valid"])

    @property
    def counts(self) -> dict[str, Any]:
        """How many there are: ``vertices``, ``edges``, ``faces``, ``components``, ``genus`` and others.

        ``None`` is what could not be counted because a rule that the counting relies on is broken.
        """
        return dict(self._document["counts"])

    @property
    def rules(self) -> list[Rule]:
        """The outcome of each rule, in order."""
        return [Rule(r["id"], r["checked"], r["violations"], r["unchecked"]) for r in self._document["rules"]]

    @property
    def broken_rules(self) -> list[str]:
        """The ids of the rules of which a violation was found. All but the first may be consequences of it."""
        return [rule.id for rule in self.rules if rule.violations]

    @property
    def violations(self) -> list[Violation]:
        """The violations that are listed, in the order of the rules."""
        return [
            Violation(
                rule=v["rule"],
                kind=v["kind"],
                records=tuple(Record(kind, index) for r in v["records"] for kind, index in r.items()),
                message=v["message"],
                fields=dict(v.get("fields", {})),
                at=tuple((x, y) for x, y in v.get("at", ())),
                features=tuple(v.get("features", ())),
            )
            for v in self._document["violations"]
        ]

    @property
    def violation_count(self) -> int:
        """How many violations were found, listed or not."""
        return int(self._document["violation_count"])

    @property
    def findings(self) -> list[Finding]:
        """What is wrong with a list of faces, or with a map as a coverage; empty for arrays."""
        return [Finding(f["kind"], f["message"], dict(f)) for f in self._document.get("findings", ())]

    @property
    def finding_count(self) -> int:
        """How many findings there are, listed or not."""
        return int(self._document.get("finding_count", 0))

    def to_dict(self) -> dict[str, Any]:
        """The JSON form, as objects."""
        found: dict[str, Any] = json.loads(self.to_json())
        return found

    def to_json(self) -> str:
        """The JSON form: ``twinedge-report/1``."""
        return json.dumps(self._document)

    def to_frame(self) -> pd.DataFrame:
        """The violations that are listed as a pandas frame, a row for each.

        The columns are ``rule``, ``kind``, ``vertex``, ``half_edge``, ``boundary``, ``face`` (the first record of each kind, or
        missing) and ``message``. Needs pandas.
        """
        import pandas as pd

        kinds = ["vertex", "half_edge", "boundary", "face"]
        rows = []
        for violation in self.violations:
            row: dict[str, Any] = {"rule": violation.rule, "kind": violation.kind, **dict.fromkeys(kinds)}
            for record in reversed(violation.records):
                row[record.kind] = record.index
            rows.append(row | {"message": violation.message})
        frame = pd.DataFrame(rows, columns=["rule", "kind", *kinds, "message"])
        return frame.astype(dict.fromkeys(kinds, "Int64"))

    def raise_if_invalid(self) -> Report:
        """The report itself, if it is valid.

        Raises :class:`InvalidStructure`, a ``ValueError``, if not.
        """
        if not self.valid:
            raise InvalidStructure(self)
        return self

    def _verdict(self) -> str:
        if self.valid:
            return "valid"
        counted = [
            f"{n:,} {name}{'s' if n != 1 else ''}"
            for n, name in [(self.violation_count, "violation"), (self.finding_count, "finding")]
            if n
        ]
        return "not valid: " + (", ".join(counted) or "a rule could not be checked")

    def _counted(self) -> str:
        names = ["vertices", "edges", "faces", "components", "genus"]
        known = [(name, self.counts.get(name)) for name in names]
        return ", ".join(f"{name} {count:,}" for name, count in known if count is not None)

    def _shown(self) -> tuple[list[str], int]:
        lines = [str(v) for v in self.violations] + [str(f) for f in self.findings]
        return lines[:_SHOWN], self.violation_count + self.finding_count - len(lines[:_SHOWN])

    def __str__(self) -> str:
        lines, more = self._shown()
        text = [self._verdict(), *lines] + ([f"… and {more:,} more"] if more > 0 else [])
        return "\n".join(text)

    def __repr__(self) -> str:
        head, _, rest = str(self).partition("\n")
        body = "\n  ".join(["", *rest.split("\n")]) if rest else ""
        return f"<twinedge.Report {head} ({self._counted()}){body}>"

    def _repr_html_(self) -> str:
        lines, more = self._shown()
        colour = "#1a7f37" if self.valid else "#cf222e"
        rules = "".join(
            f"<tr><td>{rule.id}</td><td>{'broken' if rule.violations else 'not checked' if rule.unchecked else 'ok'}</td>"
            f"<td>{rule.checked:,}</td><td>{rule.violations:,}</td></tr>"
            for rule in self.rules
        )
        items = "".join(f"<li>{html.escape(line)}</li>" for line in lines)
        items += f"<li>… and {more:,} more</li>" if more > 0 else ""
        return (
            f"<div><b style='color:{colour}'>{html.escape(self._verdict())}</b> {html.escape(self._counted())}"
            f"<ul>{items}</ul><details><summary>rules</summary><table><thead><tr><th>rule</th><th></th><th>checked</th>"
            f"<th>violations</th></tr></thead><tbody>{rules}</tbody></table></details></div>"
        )

    def __bool__(self) -> bool:
        raise TypeError("the truth of a report is ambiguous: ask for report.valid")

    def __eq__(self, other: object) -> bool:
        return self._document == other._document if isinstance(other, Report) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        return (Report, (self._document,))
