"""The findings of a validation."""

from __future__ import annotations

import html
import json
import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from datetime import date as _date
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _twinedge
from ._names import Names
from ._remedies import ON_GLOBE, REMEDIES

if TYPE_CHECKING:
    import geopandas as gpd
    import pandas as pd
    import pyarrow as pa

#: The number of causes that ``repr`` shows.
_SHOWN = 5

#: The most edges of a map that a notebook shows.
_DRAWN = 20_000


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
    #: half-edge; of a list of faces a :class:`Side` for a half-edge. See :meth:`Report.name`. Of a map of great circles the
    #: edges by their ends; there are no :attr:`records` then.
    names: tuple[Any, ...] = ()
    #: The labels of ``features``, in their order, if the layer has some. See ``name`` of :func:`twinedge.audit`.
    labels: tuple[Any, ...] = ()
    #: An id that is the same from run to run, and whatever the order of the features; ``None`` for links in arrays.
    id: str | None = None
    #: The id of the rule of the finding from which this one follows, as ``"C7"``; ``None`` if it does not.
    follows_from: str | None = None
    #: The id of that finding, if it is known.
    follows_from_id: str | None = None
    #: The message in words about features, of a clash of borders of a map.
    sentence: str | None = None
    #: The reason for which the finding was accepted from which this one follows; ``None`` if it was not.
    accepted: str | None = None

    def _explained(self) -> tuple[str, str]:
        if not self.records and self.kind in ON_GLOBE:
            return ON_GLOBE[self.kind]
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
        own = REMEDIES.get(self.kind) if self.records else None
        return own or self._explained()[1]

    def __str__(self) -> str:
        if self.sentence is not None:
            return f"{self.rule}: {self.sentence}"
        called = [f"{record} is {_told(name)}" for record, name in zip(self.records, self.names, strict=False) if name != record.index]
        return f"{self.rule}: {self.message}{_aside(called)}{_aside([*map(str, self.labels)])}"


def _told(name: Any) -> str:
    return str(name) if hasattr(name, "_fields") else repr(name)


def _aside(parts: list[str]) -> str:
    return f" ({', '.join(parts)})" if parts else ""


def _labelled(labels: tuple[Any, ...]) -> str:
    return f" of {', '.join(map(str, labels))}" if labels else ""


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
    #: ``"C1"`` to ``"C7"`` of a coverage, ``"X4"`` of parts and parents; ``None`` of a mesh.
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
    #: An id that is the same from run to run, and whatever the order of the features.
    id: str | None = None
    #: The reason for which it was accepted; ``None`` if it was not.
    accepted: str | None = None
    #: The id of the rule of the finding from which this one follows; ``None`` if it is a cause itself.
    follows_from: str | None = None
    #: The id of that finding.
    follows_from_id: str | None = None

    def __str__(self) -> str:
        if self.rule is None:
            return f"{self.kind}: {self.message}"
        of = _labelled(self.labels) or (f" of features {[*self.features]}" if self.features else "")
        return f"{self.rule}: {self.fields['kind']}{of}, {self.message}"


def finding_kind(name: str) -> str:
    """The kind of a finding, in snake case as those of violations, from its name in the JSON form."""
    return name.lower().replace(" ", "_")


_KINDS = ("vertex", "half_edge", "boundary", "face")


def _row_types() -> dict[str, str]:
    """The columns of a frame, and their types."""
    return {
        **dict.fromkeys(("rule", "kind"), "object"),
        **dict.fromkeys(_KINDS, "Int64"),
        **dict.fromkeys(("features", "names", "follows_from"), "object"),
        **dict.fromkeys(("x", "y", "area", "width", "length"), "float64"),
    }


def _row(one: Violation | Finding) -> dict[str, Any]:
    row: dict[str, Any] = {
        "rule": one.rule, "kind": one.kind, "features": one.features, "follows_from": one.follows_from, "message": one.message,
    }
    if isinstance(one, Violation):
        row |= {record.kind: record.index for record in reversed(one.records)}
        places: tuple[tuple[float, float], ...] = one.at
        row["names"] = one.labels or one.names
    else:
        row |= {"vertex": next(iter(one.vertices), None), "face": next(iter(one.faces), None)}
        row |= {"area": one.area, "width": one.width, "length": one.length, "names": one.labels}
        places = () if one.at is None else (one.at,)
    return row | (dict(zip("xy", places[0], strict=True)) if places else {})


class First(NamedTuple):
    """The first thing that is wrong. What follows from something else is not first."""

    #: The id of the rule; ``None`` of a mesh.
    rule: str | None
    #: The id of the violation or finding.
    id: str | None
    #: A place, of a map.
    at: tuple[float, float] | None


class Judged(NamedTuple):
    """The bytes that were judged: of a file, or of the text in the form of GeoJSON that was made of a layer in memory."""

    sha256: str
    bytes: int


class Difference(NamedTuple):
    """The findings of two reports by their ids, each list sorted."""

    #: Those that only the newer one has.
    new: list[str]
    #: Those that only the older one has.
    gone: list[str]
    #: Those that have other measures now.
    changed: list[str]
    #: The number of the others.
    same: int


def diff(old: Any, new: Any) -> Difference:
    """What a newer report has and an older one has not, and the other way round.

    Both are reports of :func:`twinedge.audit`, or paths to their JSON, or what was read of it. O(n log n).

    Raises
    ------
    ValueError
        One of them is no report, does not list all that was found (give a greater ``list``), or was not finished in time.
    """
    return Difference(*_twinedge.diff(_json(old), _json(new)))


def _json(report: Any) -> str:
    if isinstance(report, Report):
        return report.to_json()
    if isinstance(report, (str, os.PathLike)):
        return Path(report).read_text(encoding="utf-8")
    return json.dumps(report)


class InvalidStructure(ValueError):
    """The exception that :meth:`Report.raise_if_invalid` raises. Its report is the attribute ``report``."""

    def __init__(self, report: Report) -> None:
        super().__init__(str(report))
        self.report = report

    def __reduce__(self) -> tuple[Any, ...]:
        return (InvalidStructure, (self.report,))


#: The numbers of findings of a coverage.
_COUNTS = ("overlaps", "gaps", "near_misses", "slivers", "duplicates", "ogc_invalid", "mismatches")


def _own_names(features: Iterable[Mapping[str, Any]]) -> tuple[Any, ...]:
    """The names, or else ids, that features have in a file; nothing, if none has one."""
    names = tuple(feature.get("name") or feature.get("id") for feature in features)
    return names if any(name is not None for name in names) else ()


def _own_titles(features: tuple[int, ...], titles: Iterable[str]) -> tuple[Any, ...]:
    """The titles of features in a file; nothing, if these say only their numbers."""
    found = tuple(titles)
    return () if found == tuple(f"feature {number}" for number in features) else found


class _Layer(NamedTuple):
    """The findings as a text in the form of GeoJSON."""

    text: str
    #: The coordinates are in a reference system that the text names, or are longitudes and latitudes.
    has_crs: bool
    crs: Any

    def frame(self) -> gpd.GeoDataFrame:
        import geopandas as gpd

        found = json.loads(self.text)
        crs = self.crs
        if crs is None and self.has_crs:
            crs = found.get("crs", {}).get("properties", {}).get("name", "EPSG:4326")
        if found["features"]:
            return gpd.GeoDataFrame.from_features(found["features"], crs=crs)
        return gpd.GeoDataFrame({name: [] for name in ("rule", "kind", "message")}, geometry=[], crs=crs)


def _again(document: Mapping[str, Any], names: Mapping[str, Names], layer: _Layer | None, acceptable: str | None) -> Report:
    report = Report(document, names)
    report._layer, report._acceptable = layer, acceptable
    return report


class Report:
    """The findings of a validation. Reports compare equal if their JSON does, apart from the time that they took.

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
        self._layer: _Layer | None = None
        self._acceptable: str | None = None
        # Draws the layer; dropped when a report is pickled.
        self._picture: Callable[[], str] | None = None

    @classmethod
    def _told(cls, told: tuple[str, str | None, list[str], str], names: Mapping[str, Names] | None = None, crs: Any = None) -> Report:
        document, layer, warnings, acceptable = told
        report = cls(document, names)
        report._layer = None if layer is None else _Layer(layer, not warnings, crs)
        report._acceptable = acceptable
        return report

    @property
    def verdict(self) -> str:
        """``"valid"``: every rule that applies was checked, and holds; ``"invalid"``: something is wrong; ``"unknown"``: nothing wrong
        was found, and not everything was checked, for the reasons in :attr:`unknown`. Nothing is valid by default."""
        found = self._document.get("verdict")
        if found is None:
            found = "valid" if self.valid else "invalid" if self.violation_count or self.findings else "unknown"
        return str(found)

    @property
    def unknown(self) -> list[str]:
        """The reasons why the verdict is not known, in sentences."""
        return [*self._document.get("unknown", ())]

    @property
    def first(self) -> First | None:
        """The first thing that is wrong; ``None`` if the verdict is another one, and for links in arrays."""
        found = self._document.get("first")
        if found is None:
            return None
        return First(found["rule"], found["id"], None if found["at"] is None else (found["at"][0], found["at"][1]))

    @property
    def judged(self) -> Judged | None:
        """The SHA-256 and the number of the bytes that were judged; ``None`` for links and faces in arrays, and for tiles."""
        found = self._document.get("judged")
        return None if found is None else Judged(found["sha256"], found["bytes"])

    @property
    def valid(self) -> bool:
        """True if the :attr:`verdict` is ``"valid"``: no violation was found, every rule that applies was checked, and no finding is a fault.

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

        ``None`` is what could not be counted because a rule that the counting relies on is broken. Empty, if the audit was not finished in time.
        """
        return dict(self._document["counts"] or {})

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
        named = tuple(record for record in entry["records"] if isinstance(record, str))
        records = tuple(Record(kind, index) for r in entry["records"] if r not in named for kind, index in r.items())
        features = tuple(entry.get("feature_numbers", ()))
        return Violation(
            rule=entry["rule"],
            kind=entry["kind"],
            records=records,
            message=entry["message"],
            fields=dict(entry.get("fields", {})),
            at=tuple((x, y) for x, y in entry.get("at", ())),
            features=features,
            names=named or self._record_names(records),
            labels=self._labels(features) or _own_titles(features, entry.get("features", ())),
            id=entry.get("id"),
            follows_from=entry.get("follows_from"),
            follows_from_id=entry.get("follows_from_id"),
            sentence=entry.get("sentence"),
            accepted=entry.get("accepted"),
        )

    @property
    def violation_count(self) -> int:
        """The number of violations, listed or not."""
        return int(self._document["violation_count"])

    @property
    def findings(self) -> list[Finding]:
        """The findings about a list of faces, or about a map as a coverage and about parts and their parents; empty for arrays."""
        return [*map(self._finding, [*self._coverage.get("findings", ()), *self._document.get("findings", ())])]

    @property
    def _coverage(self) -> dict[str, Any]:
        found: dict[str, Any] = self._document.get("coverage", {})
        return found

    def _finding(self, entry: dict[str, Any]) -> Finding:
        named = entry.get("features", ())
        features = tuple(feature["number"] for feature in named)
        return Finding(
            kind=finding_kind(entry["kind"]),
            message=entry["message"],
            fields=dict(entry),
            rule=entry.get("rule"),
            features=features,
            labels=self._labels(features) or _own_names(named),
            faces=tuple(entry.get("faces", ())),
            vertices=tuple(entry.get("vertices", ())),
            at=(entry["at"][0], entry["at"][1]) if "at" in entry else None,
            area=entry.get("area"),
            width=entry.get("width"),
            length=entry.get("length"),
            id=entry.get("id"),
            accepted=entry.get("accepted"),
            follows_from=entry.get("follows_from"),
            follows_from_id=entry.get("follows_from_id"),
        )

    @property
    def causes(self) -> list[Violation | Finding]:
        """The listed findings and violations that follow from no other one and are not accepted, findings first.

        ``len(report.causes)`` is the number of the headline, if all are listed.
        """
        return [one for one in self._both() if one.follows_from is None and one.accepted is None]

    def consequences(self, cause: Violation | Finding) -> list[Violation | Finding]:
        """The listed findings and violations that follow from one."""
        return [one for one in self._both() if cause.id is not None and one.follows_from_id == cause.id and one.accepted is None]

    def _listed(self) -> list[Violation | Finding]:
        """All that is listed: causes, then what follows from them; findings first."""
        return sorted(self._both(), key=lambda one: one.follows_from is not None)

    def _both(self) -> list[Violation | Finding]:
        return [*self.findings, *self.violations]

    @property
    def finding_count(self) -> int:
        """The number of findings, listed or not."""
        of_coverage = sum(int(self._coverage.get(count) or 0) for count in _COUNTS)
        return of_coverage + int(self._document.get("finding_count", 0))

    @property
    def wider_gaps(self) -> int:
        """The number of gaps that are wider than ``lake_width``, or ``gap_width``, where one was given: they are no findings."""
        return int(self._coverage.get("wider_gaps", 0))

    @property
    def accepted_gaps(self) -> int:
        """The number of gaps that were accepted by their place (``accept_gaps``): they are no findings."""
        return int(self._coverage.get("accepted_gaps", 0))

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
        """The violations and the findings that are listed as a pandas frame, a row for each: causes first, then what follows from them.

        The columns are ``rule`` (missing for findings of a mesh), ``kind``, ``vertex``, ``half_edge``, ``boundary``, ``face`` (the first record
        of each kind, or missing), ``features`` (positions), ``names`` (the labels of the features, or the names of the records, if
        there are some), ``follows_from`` (the rule of the cause, or missing), ``x``, ``y`` (the first place, or missing), ``area``, ``width``, ``length`` (of findings of a coverage), and
        ``message``. Needs pandas.
        """
        import pandas as pd

        rows = [*map(_row, self._listed())]
        frame = pd.DataFrame(rows, columns=[*_row_types(), "message"])
        return frame.astype(_row_types())

    def to_arrow(self) -> pa.Table:
        """What :meth:`to_frame` has, as a table of Arrow: ``rule``, ``kind``, ``features``, ``x``, ``y``, ``area``, ``width``, ``length``,
        ``id``, ``message``. Needs pyarrow."""
        import pyarrow as pa

        real = dict.fromkeys(("x", "y", "area", "width", "length"), pa.float64())
        columns = {"rule": pa.string(), "kind": pa.string(), "features": pa.list_(pa.int64()), **real, "id": pa.string(), "message": pa.string()}
        rows = [_row(one) | {"id": one.id} for one in self._listed()]
        return pa.Table.from_pylist([{name: row.get(name) for name in columns} for row in rows], pa.schema([*columns.items()]))

    def to_geodataframe(self) -> gpd.GeoDataFrame:
        """The violations and the findings that are listed as a layer, a row for each, with their shapes.

        These are the overlaps, the gaps, the lines and vertices at fault. The columns are those of the layer of findings that the program writes, as ``rule``, ``kind``,
        ``message``, ``features``, ``area``, ``accepted``. The reference system is that of the layer. Needs geopandas.

        Raises ``ValueError`` for what has no places: arrays and meshes, and reports that were made from JSON.
        """
        if self._layer is None:
            raise ValueError("the findings have no places: this is no report of twinedge.audit of a map")
        return self._layer.frame()

    def accept_all(self, reason: str, date: str | None = None) -> dict[str, Any]:
        """The findings of C1 to C7 as a list of accepted ones, for ``accept`` of :func:`twinedge.audit` and ``--accept`` of the program.

        Those that were accepted before keep their reason and date. ``date`` is that of today by default, as ``"2026-11-25"``.

        Raises ``ValueError`` if not all are listed (give a greater ``list``), or if the report was made from JSON.
        """
        if self._acceptable is None:
            raise ValueError("this is no report of twinedge.audit: what was read from JSON can be judged again")
        if len(self.findings) < self.finding_count:
            raise ValueError(f"{len(self.findings):,} of {self.finding_count:,} findings are listed: audit again with a greater list")
        found: dict[str, Any] = json.loads(self._acceptable)
        today = date or _date.today().isoformat()
        for entry in found["accepted"]:
            entry["reason"] = entry["reason"] or reason
            entry["date"] = entry["date"] or today
        return found

    def raise_if_invalid(self) -> Report:
        """The report itself, if it is valid.

        Raises :class:`InvalidStructure`, a ``ValueError``, if not.
        """
        if not self.valid:
            raise InvalidStructure(self)
        return self

    @property
    def headline(self) -> str:
        """The verdict in a sentence, with the number of causes; of a map on the structure and on the coverage."""
        missing = len(self.without_geometry)
        aside = f"; {missing:,} feature{'s have' if missing != 1 else ' has'} no geometry" if missing else ""
        found = self._document.get("headline")
        if found is None:
            count = self.violation_count
            words = f"not valid: {count:,} violation{'s' if count != 1 else ''}" if count else "not valid: a rule could not be checked"
            found = "valid" if self.valid else words
        return f"{found}{aside}"

    def _counted(self) -> str:
        names = ["vertices", "edges", "faces", "components", "genus"]
        known = [(name, self.counts.get(name)) for name in names]
        return ", ".join(f"{name} {count:,}" for name, count in known if count is not None)

    def _shown(self) -> tuple[list[str], int]:
        causes = self.causes
        lines = []
        for one in causes[:_SHOWN]:
            count = len(self.consequences(one))
            lines.append(str(one) + (f"; {count:,} {'follows' if count == 1 else 'follow'} from it" if count else ""))
        unlisted = self.violation_count + self.finding_count - len(self.violations) - len(self.findings)
        return lines, len(causes) - len(lines) + unlisted

    def __str__(self) -> str:
        lines, more = self._shown()
        text = [self.headline, *lines] + ([f"… and {more:,} more"] if more > 0 else [])
        return "\n".join(text)

    def __repr__(self) -> str:
        head, _, rest = str(self).partition("\n")
        body = "\n  ".join(["", *rest.split("\n")]) if rest else ""
        return f"<twinedge.Report {head} ({self._counted()}){body}>"

    def _repr_html_(self) -> str:
        lines, more = self._shown()
        is_doubtful = self.valid and bool(self.causes)
        colour = "#8a5a00" if is_doubtful else "#1a7f37" if self.valid else "#cf222e"
        rules = "".join(
            f"<tr><td>{rule.id}</td><td>{'broken' if rule.violations else 'not checked' if rule.unchecked else 'ok'}</td>"
            f"<td>{rule.checked:,}</td><td>{rule.violations:,}</td></tr>"
            for rule in self.rules
        )
        items = "".join(f"<li>{html.escape(line)}</li>" for line in lines)
        items += f"<li>… and {more:,} more</li>" if more > 0 else ""
        return (
            f"<div><b style='color:{colour}'>{html.escape(self.headline)}</b> {html.escape(self._counted())}"
            f"<ul>{items}</ul>{self._svg()}<details><summary>rules</summary><table><thead><tr><th>rule</th><th></th><th>checked</th>"
            f"<th>violations</th></tr></thead><tbody>{rules}</tbody></table></details></div>"
        )

    def _svg(self) -> str:
        """A small picture of a map, if it has not too many edges."""
        if self._picture is None or not 0 < (self.counts.get("edges") or 0) <= _DRAWN:
            return ""
        return self._picture()

    def __bool__(self) -> bool:
        raise TypeError("the truth of a report is ambiguous: ask for report.valid")

    def __eq__(self, other: object) -> bool:
        return self._untimed() == other._untimed() if isinstance(other, Report) else NotImplemented

    def _untimed(self) -> dict[str, Any]:
        return {key: value for key, value in self._document.items() if key != "elapsed_ms"}

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        return (_again, (self._document, self._names, self._layer, self._acceptable))
