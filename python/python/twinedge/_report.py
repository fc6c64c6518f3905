"""The findings of a validation."""

from __future__ import annotations

import html
import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from . import _twinedge
from ._names import Names
from ._remedies import REMEDIES

if TYPE_CHECKING:
    import pandas as pd

#: The number of violations that ``repr`` shows.
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
    #: The number of violations, listed or not.
    violations: int
    #: The reason why it was not checked on all records, as in the JSON form of reports; ``None`` if it was.
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
    #: The values that the violation is about, by name, as ``{"half_edge": 3, "twin": 4, "found": None}``.
    fields: dict[str, Any]
    #: Points, for a map.
    at: tuple[tuple[float, float], ...] = ()
    #: The positions of the features concerned, for a map.
    features: tuple[int, ...] = ()
    #: The names of the records, in their order, if the structure has some: of ``networkx`` a node, or a pair of nodes for a
    #: half-edge; of a list of faces a :class:`Side` for a half-edge. See :meth:`Report.name`.
    names: tuple[Any, ...] = ()
    #: The labels of ``features``, in their order, if the layer has some. See ``name`` of :func:`twinedge.audit`.
    labels: tuple[Any, ...] = ()

    def _explained(self) -> tuple[str, str]:
        entry: dict[str, Any] = {"kind": self.kind}
        if self.fields:
            entry["fields"] = self.fields
        return _twinedge.explain(json.dumps(entry))

    @property
    def cause(self) -> str:
        """The usual cause."""
        return self._explained()[0]

    @property
    def remedy(self) -> str:
        """The remedy, in the arguments of this package."""
        return REMEDIES.get(self.kind) or self._explained()[1]

    def __str__(self) -> str:
        called = [f"{record} is {_told(name)}" for record, name in zip(self.records, self.names, strict=False) if name != record.index]
        return f"{self.rule}: {self.message}{_aside(called)}{_labelled(self.labels)}"


def _told(name: Any) -> str:
    return str(name) if hasattr(name, "_fields") else repr(name)


def _aside(parts: list[str]) -> str:
    return f" ({', '.join(parts)})" if parts else ""


def _labelled(labels: tuple[Any, ...]) -> str:
    return _aside([f"feature{'s' if len(labels) > 1 else ''} {', '.join(map(repr, labels))}"] if labels else [])


@dataclass(frozen=True)
class Finding:
    """A fault of a list of faces, or of the polygons of a map as a coverage (rules C1 to C7).

    Lengths and areas are in the units of the coordinates.
    """

    #: One of :data:`twinedge.FINDING_KINDS`, as ``"non_manifold_vertex"`` of a mesh, ``"near_miss"`` of a coverage.
    kind: str
    #: A sentence.
    message: str
    #: All keys of the JSON form, with their values there: ``kind`` of C3 and C6 is ``"near miss"`` and ``"OGC validity"`` in it.
    fields: dict[str, Any]
    #: ``"C1"`` to ``"C7"`` of a coverage; ``None`` of a mesh.
    rule: str | None = None
    #: The positions of the features concerned, of a coverage.
    features: tuple[int, ...] = ()
    #: The labels of ``features``, in their order, if the layer has some. See ``name`` of :func:`twinedge.audit`.
    labels: tuple[Any, ...] = ()
    #: The faces concerned, of a mesh.
    faces: tuple[int, ...] = ()
    #: The vertices concerned, of a mesh.
    vertices: tuple[int, ...] = ()
    #: A point inside it, of a coverage.
    at: tuple[float, float] | None = None
    #: The area: of the overlap, the gap, the sliver, one duplicate, or the space of a near miss. ``None`` for C6, C7 and meshes.
    area: float | None = None
    #: The *mean* width, ``2 * area / length``: the width of a strip, half of the side of a square.
    width: float | None = None
    #: The length of the borders: all around the area, both sides of a near miss, or the segments that lack a vertex.
    length: float | None = None

    def __str__(self) -> str:
        return f"{self.rule or self.kind}: {self.message}{_labelled(self.labels)}"


def finding_kind(name: str) -> str:
    """The kind of a finding, in snake case as those of violations, from its name in the JSON form."""
    return name.lower().replace(" ", "_")


_KINDS = ("vertex", "half_edge", "boundary", "face")


def _row_types() -> dict[str, str]:
    """The columns of a frame, and their types."""
    return {
        **dict.fromkeys(("rule", "kind"), "object"),
        **dict.fromkeys(_KINDS, "Int64"),
        **dict.fromkeys(("features", "names"), "object"),
        **dict.fromkeys(("x", "y", "area", "width", "length"), "float64"),
    }


def _row(one: Violation | Finding) -> dict[str, Any]:
    row: dict[str, Any] = {"rule": one.rule, "kind": one.kind, "features": one.features, "message": one.message}
    if isinstance(one, Violation):
        row |= {record.kind: record.index for record in reversed(one.records)}
        places: tuple[tuple[float, float], ...] = one.at
        row["names"] = one.labels or one.names
    else:
        row |= {"vertex": next(iter(one.vertices), None), "face": next(iter(one.faces), None)}
        row |= {"area": one.area, "width": one.width, "length": one.length, "names": one.labels}
        places = () if one.at is None else (one.at,)
    return row | (dict(zip("xy", places[0], strict=True)) if places else {})


class InvalidStructure(ValueError):
    """The exception that :meth:`Report.raise_if_invalid` raises. Its report is the attribute ``report``."""

    def __init__(self, report: Report) -> None:
        super().__init__(str(report))
        self.report = report

    def __reduce__(self) -> tuple[Any, ...]:
        return (InvalidStructure, (self.report,))


class Report:
    """The findings of a validation. Reports compare equal if their JSON does.

    ``bool(report)`` is an error, as it would be read in two ways: ask for :attr:`valid`.
    """

    def __init__(self, document: str | Mapping[str, Any], names: Mapping[str, Names] | None = None) -> None:
        """From the JSON form, which ``docs/report.md`` of the project describes.

        ``names`` has what the records of some kinds are called, by position: ``"vertex"``, ``"half_edge"``, ``"face"``,
        ``"feature"``. It is no part of the JSON form. Raises ``ValueError`` if the form has another version.
        """
        found = json.loads(document) if isinstance(document, str) else dict(document)
        if found.get("schema") != _twinedge.REPORT_SCHEMA:
            raise ValueError(f"expected the schema {_twinedge.REPORT_SCHEMA}, not {found.get('schema')!r}")
        self._document: dict[str, Any] = found
        self._names: dict[str, Names] = dict(names or {})

    @property
    def valid(self) -> bool:
        """True if no violation was found, every rule that applies was checked, and no finding is a fault.

        Findings of a mesh are faults, but for ``unused_vertex``. Those of a coverage are if it was asked for, by
        ``coverage=True`` or by ``adapters.shapely`` and ``adapters.geopandas``: then ``violations`` may be empty where ``findings``
        are the reason. :meth:`to_frame` has both.
        """
        return bool(self._document["valid"])

    def name(self, record: Record) -> Any:
        """Returns the name of a record in the structure that was judged; its index, if it has no name.

        Of ``adapters.networkx`` a node, or for a half-edge a pair of nodes, origin and target; of ``adapters.compas`` the keys of
        the mesh likewise; of a list of faces a :class:`Side` for a half-edge, with ``face`` and ``corner``.
        """
        names = self._names.get(record.kind, ())
        return names[record.index] if 0 <= record.index < len(names) else record.index

    def _record_names(self, records: tuple[Record, ...]) -> tuple[Any, ...]:
        return tuple(map(self.name, records)) if any(record.kind in self._names for record in records) else ()

    def _labels(self, features: Iterable[int]) -> tuple[Any, ...]:
        labels = self._names.get("feature")
        return () if labels is None else tuple(labels[feature] for feature in features)

    def _named(self, names: Mapping[str, Names]) -> Report:
        return Report(self._document, names)

    @property
    def counts(self) -> dict[str, Any]:
        """The numbers of ``vertices``, ``edges``, ``faces``, ``components``, ``genus`` and others.

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
        """The violations that are listed, in the order of the rules. A report that is not valid may have :attr:`findings` only."""
        return [*map(self._violation, self._document["violations"])]

    def _violation(self, entry: dict[str, Any]) -> Violation:
        records = tuple(Record(kind, index) for r in entry["records"] for kind, index in r.items())
        features = tuple(entry.get("features", ()))
        return Violation(
            rule=entry["rule"],
            kind=entry["kind"],
            records=records,
            message=entry["message"],
            fields=dict(entry.get("fields", {})),
            at=tuple((x, y) for x, y in entry.get("at", ())),
            features=features,
            names=self._record_names(records),
            labels=self._labels(features),
        )

    @property
    def violation_count(self) -> int:
        """The number of violations, listed or not."""
        return int(self._document["violation_count"])

    @property
    def findings(self) -> list[Finding]:
        """The findings about a list of faces, or a map as a coverage; empty for arrays."""
        return [*map(self._finding, self._document.get("findings", ()))]

    def _finding(self, entry: dict[str, Any]) -> Finding:
        features = tuple(entry.get("features", ()))
        return Finding(
            kind=finding_kind(entry["kind"]),
            message=entry["message"],
            fields=dict(entry),
            rule=entry.get("rule"),
            features=features,
            labels=self._labels(features),
            faces=tuple(entry.get("faces", ())),
            vertices=tuple(entry.get("vertices", ())),
            at=(entry["at"][0], entry["at"][1]) if "at" in entry else None,
            area=entry.get("area"),
            width=entry.get("width"),
            length=entry.get("length"),
        )

    @property
    def finding_count(self) -> int:
        """The number of findings, listed or not."""
        return int(self._document.get("finding_count", 0))

    @property
    def wider_gaps(self) -> int:
        """The number of gaps that are wider than ``lake_width``, or ``gap_width``, where one was given: they are no findings."""
        return int(self._document.get("wider_gaps", 0))

    @property
    def accepted_gaps(self) -> int:
        """The number of gaps that were accepted by their place (``accept_gaps``): they are no findings."""
        return int(self._document.get("accepted_gaps", 0))

    @property
    def without_geometry(self) -> list[int]:
        """The positions of the features of a map whose geometry is missing or empty: nothing of them is judged."""
        return [*self._document.get("without_geometry", ())]

    def to_dict(self) -> dict[str, Any]:
        """The JSON form, as objects."""
        found: dict[str, Any] = json.loads(self.to_json())
        return found

    def to_json(self) -> str:
        """The JSON form: ``twinedge-report/1``."""
        return json.dumps(self._document)

    def to_frame(self) -> pd.DataFrame:
        """The violations and the findings that are listed as a pandas frame, a row for each, violations first.

        The columns are ``rule`` (missing for findings of a mesh), ``kind``, ``vertex``, ``half_edge``, ``boundary``, ``face`` (the first record
        of each kind, or missing), ``features`` (positions), ``names`` (the labels of the features, or the names of the records, if
        there are some), ``x``, ``y`` (the first place, or missing), ``area``, ``width``, ``length`` (of findings of a coverage), and
        ``message``. Needs pandas.
        """
        import pandas as pd

        rows = [*map(_row, self.violations), *map(_row, self.findings)]
        frame = pd.DataFrame(rows, columns=[*_row_types(), "message"])
        return frame.astype(_row_types())

    def raise_if_invalid(self) -> Report:
        """The report itself, if it is valid.

        Raises :class:`InvalidStructure`, a ``ValueError``, if not.
        """
        if not self.valid:
            raise InvalidStructure(self)
        return self

    def _verdict(self) -> str:
        missing = len(self.without_geometry)
        aside = f"; {missing:,} feature{'s have' if missing != 1 else ' has'} no geometry" if missing else ""
        if self.valid:
            return f"valid{aside}"
        counted = [
            f"{n:,} {name}{'s' if n != 1 else ''}"
            for n, name in [(self.violation_count, "violation"), (self.finding_count, "finding")]
            if n
        ]
        return "not valid: " + (", ".join(counted) or "a rule could not be checked") + aside

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
        return (Report, (self._document, self._names))
