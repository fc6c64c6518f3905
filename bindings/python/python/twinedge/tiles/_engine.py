"""Steps that all engines share. Each takes batches of rows, and runs on some worker, once or more often.

A layer is partitioned in some way. A first pass surveys each partition. It says how many rows there are, so that features are numbered without moving
them, where they are, and what they are: a digest of the ids and geometries, by which all later passes notice whether the layer changed meanwhile.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import accumulate
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _twinedge
from .._columns import _batches, _binary, _column
from .._options import _limits
from .._report import Report
from . import Cuts, Grid, audit_tiles, divide, finish, merge

if TYPE_CHECKING:
    import pyarrow as pa

#: The columns of rows: the id of each feature, and its geometry as well-known binary.
COLUMNS = ("id", "geometry")


@dataclass(frozen=True)
class Survey:
    """Facts about the rows of a partition."""

    rows: int
    box: tuple[float, float, float, float] | None
    digest: bytes
    sample: Any


def survey(batches: Any) -> Survey:
    """Surveys the rows of a partition, in order. O(points)."""
    rows, digest = 0, _Digest()
    boxes: list[Any] = []
    samples: list[Any] = [np.empty((0, 2))]
    for batch in _batches(batches):
        digest.add(batch)
        rows += len(batch)
        _, box, sample = _twinedge.survey(_binary(batch, "geometry"))
        boxes.extend(() if box is None else (box,))
        samples.append(sample)
    return Survey(rows, _joined(boxes), digest.digest(), np.concatenate(samples))


class _Digest:
    """A digest of rows that does not depend on how they are batched."""

    def __init__(self) -> None:
        self._parts = [hashlib.sha256() for _ in range(4)]

    def add(self, batch: pa.RecordBatch) -> None:
        for place, name in enumerate(COLUMNS):
            values, lengths = self._parts[2 * place : 2 * place + 2]
            column = _binary(_as_bytes(batch, name), name)
            ends = column["ends"]
            values.update(column["data"][int(ends[0]) : int(ends[-1])])
            lengths.update(np.diff(ends).astype("<i8"))

    def digest(self) -> bytes:
        return b"".join(part.digest() for part in self._parts)


def _as_bytes(batch: pa.RecordBatch, name: str) -> pa.RecordBatch:
    import pyarrow as pa

    column = _column(batch, name)
    if pa.types.is_string(column.type) or pa.types.is_large_string(column.type):
        column = column.cast(pa.large_binary())
    return pa.RecordBatch.from_arrays([column], names=[name])


def _joined(boxes: list[Any]) -> tuple[float, float, float, float] | None:
    if not boxes:
        return None
    low, high = np.min(boxes, axis=0), np.max(boxes, axis=0)
    return (float(low[0]), float(low[1]), float(high[2]), float(high[3]))


@dataclass(frozen=True)
class Plan:
    """How a layer is audited: what workers get."""

    grid: Grid
    cuts: Cuts
    #: The number of the first feature of each partition, and the digest of the partition.
    starts: list[int]
    digests: list[bytes]
    limits: dict[str, Any]

    @classmethod
    def of(cls, surveys: list[Survey], vertices: int, limits: dict[str, Any]) -> Plan:
        """The plan for partitions, in order, with about ``vertices`` vertices in each tile."""
        # Wrong limits are refused here, and not by the first worker.
        _limits(**limits)
        box = _joined([one.box for one in surveys if one.box is not None])
        rows = [one.rows for one in surveys]
        if sum(rows) > 2**32:
            raise ValueError("the layer has more than 4,294,967,296 features")
        digests = [one.digest for one in surveys]
        source = "sha256 of the ids and geometries " + hashlib.sha256(b"".join(digests)).hexdigest()
        grid = Grid._of_sample([one.sample for one in surveys], vertices)
        return cls(grid, Cuts(box or (0, 0, 0, 0), source=source), [*accumulate(rows, initial=0)], digests, limits)

    def divide(self, batches: Any, partition: int) -> Iterator[pa.RecordBatch]:
        """The pieces of the features of a partition.

        Raises ``ValueError`` if these are not the rows that were surveyed.
        """
        for batch in self._numbered(batches, partition):
            yield from divide(batch, self.grid, self.cuts)

    def ids(self, batches: Any, partition: int, wanted: Iterable[int]) -> Iterator[pa.RecordBatch]:
        """The ids of the wanted features of a partition: the columns ``feature`` and ``id``."""
        import pyarrow as pa
        import pyarrow.compute as pc

        numbers = pa.array(sorted(wanted), pa.uint32())
        for batch in self._numbered(batches, partition):
            found = batch.filter(pc.is_in(batch["feature"], numbers))
            yield pa.RecordBatch.from_arrays([found["feature"].cast(pa.int64()), found["id"].cast(pa.string())], names=["feature", "id"])

    def _numbered(self, batches: Any, partition: int) -> Iterator[pa.RecordBatch]:
        import pyarrow as pa

        number, digest = self.starts[partition], _Digest()
        for batch in _batches(batches):
            digest.add(batch)
            numbers = pa.array(np.arange(number, number + len(batch), dtype=np.uint32))
            number += len(batch)
            yield pa.RecordBatch.from_arrays([numbers, batch["id"], batch["geometry"]], names=["feature", *COLUMNS])
        if digest.digest() != self.digests[partition]:
            raise ValueError(f"the layer changed while it was audited: partition {partition} has other rows than before, or in another order")

    def search(self, batches: Any) -> Iterator[pa.RecordBatch]:
        """The cuts that tiles find in this round."""
        return self.cuts.search_tiles(batches, self.grid)

    def with_cuts(self, found: Any) -> Plan:
        """The plan after a round of cuts."""
        # A layer without features has no pieces, and so no finds: one of nothing ends the round.
        nothing = self.cuts.search([], self.grid, 0)
        return Plan(self.grid, self.cuts.take(found, nothing), self.starts, self.digests, self.limits)

    def is_complete(self) -> bool:
        """True if all cuts are found."""
        return not self.cuts.tiles(self.grid)

    def summaries(self, batches: Any) -> Iterator[pa.RecordBatch]:
        """The summaries of tiles, merged. A partition has all pieces of its tiles."""
        yield merge(*audit_tiles(batches, self.grid, cuts=self.cuts, **self.limits))

    def audited(self, summaries: Any, ids_of: Callable[[set[int]], Any], **options: Any) -> tuple[Report, pa.Table]:
        """The report, and its findings and violations with the ids of features.

        ``ids_of`` returns the features with these numbers: a table with the columns ``feature`` and ``id``.
        """
        import pyarrow as pa

        options = {"grid": self.grid, "coverage": True, **options, **self.limits}
        rows = finish(summaries, **options).to_arrow()["features"].to_pylist()
        wanted = {feature for features in rows for feature in features or ()}
        found = ids_of(wanted)
        known = dict(zip(found["feature"].to_pylist(), found["id"].to_pylist()))
        # Ids of findings depend on the ids of their features, as on one machine.
        report = finish(summaries, labels=known, **options)
        table = report.to_arrow()
        lists = [[known.get(feature) for feature in features or ()] for features in rows]
        return report, table.append_column("ids", pa.array(lists, pa.list_(pa.string())))


def columns(known: Iterable[str], *names: str) -> None:
    """Refuses columns that a layer does not have, or that are the same."""
    has = [*known]
    for name in names:
        if name not in has:
            raise ValueError(f"there is no column {name!r}; there are {', '.join(map(str, has)) or 'none'}")
    if len({*names}) < len(names):
        raise ValueError(f"{names[0]!r} is one column, and the geometry and the id are two")
