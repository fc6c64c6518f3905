"""Tables of Arrow: their batches, the tiles of rows, geometries and the numbers of features."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import pyarrow as pa

#: The types of GeoArrow that are read without copying, and the lists around their coordinates.
_DEPTHS = {"point": 0, "linestring": 1, "multipoint": 1, "polygon": 2, "multilinestring": 2, "multipolygon": 3}

#: The most bytes that go into one batch: offsets of 32 bits reach no farther.
_MOST = 2**31 - 1


def _with_tiles(batch: pa.RecordBatch, rows: Any, tiles: Any) -> Iterator[pa.RecordBatch]:
    """These rows of a batch, with their tiles in a column before the others."""
    import pyarrow as pa

    schema = pa.schema([pa.field("tile", pa.int64()), *batch.schema], batch.schema.metadata)
    for part in _parts(batch, rows):
        taken = batch.take(pa.array(rows[part]))
        columns = [pa.array(tiles[part].astype(np.int64)), *taken.columns]
        yield pa.RecordBatch.from_arrays(columns, schema=schema)


def _parts(batch: pa.RecordBatch, rows: Any) -> Iterator[slice]:
    """The stretches of some rows of a batch, in order, each of which fits into one batch. O(rows + values of the batch)."""
    ends = np.cumsum(sum(map(_sizes, batch.columns), np.zeros(len(batch), np.int64))[rows])
    start = 0
    while start < len(rows) or start == 0:
        before = ends[start - 1] if start else 0
        end = max(int(np.searchsorted(ends, before + _MOST, "right")), start + 1)
        yield slice(start, end)
        start = end


def _sizes(column: pa.Array) -> Any:
    """The number of bytes of each value, or more."""
    import pyarrow as pa
    import pyarrow.compute as pc

    kind, count = column.type, len(column)
    if isinstance(kind, pa.BaseExtensionType):
        return _sizes(column.storage)
    if pa.types.is_struct(kind):
        return sum((_sizes(column.field(place)) for place in range(kind.num_fields)), np.ones(count, np.int64))
    if pa.types.is_fixed_size_list(kind):
        step = kind.list_size
        return 1 + _sizes(column.values.slice(column.offset * step, count * step)).reshape(count, step).sum(axis=1)
    if pa.types.is_list(kind) or pa.types.is_large_list(kind) or pa.types.is_map(kind):
        before = np.concatenate([[0], np.cumsum(_sizes(column.values))])
        return 8 + np.diff(before[column.offsets.to_numpy()])
    if any(is_of(kind) for is_of in (pa.types.is_binary, pa.types.is_large_binary, pa.types.is_string, pa.types.is_large_string)):
        return 8 + pc.binary_length(column).fill_null(0).to_numpy(zero_copy_only=False).astype(np.int64)
    return np.full(count, 16)


def _by_tile(batches: Any) -> Iterator[tuple[int, pa.Table]]:
    """The rows of each tile that has some, in order. O(n log n)."""
    import pyarrow as pa

    parts: dict[int, list[pa.RecordBatch]] = {}
    for batch in _batches(batches):
        tiles = batch["tile"].to_numpy(zero_copy_only=False)
        order = np.argsort(tiles, kind="stable")
        found, starts = np.unique(tiles[order], return_index=True)
        for tile, rows in zip(found.tolist(), np.split(order, starts[1:])):
            parts.setdefault(tile, []).append(batch.take(pa.array(rows)))
    for tile in sorted(parts):
        yield tile, pa.Table.from_batches(parts.pop(tile))


def _batches(given: Any) -> Iterator[pa.RecordBatch]:
    import pyarrow as pa

    if isinstance(given, pa.RecordBatch):
        yield given
    elif isinstance(given, pa.Table):
        yield from given.to_batches()
    elif isinstance(given, dict) or not hasattr(given, "__iter__"):
        raise TypeError(f"expected a table, a batch or an iterable of batches, not {type(given).__name__}")
    else:
        for one in given:
            yield from _batches(one)


def _column(batch: pa.RecordBatch, name: str) -> pa.Array:
    at = batch.schema.get_field_index(name)
    if at < 0:
        raise ValueError(f"there is no column {name!r}; there are {', '.join(batch.schema.names) or 'none'}")
    return batch.column(at)


def _geometries(batch: pa.RecordBatch, name: str) -> dict[str, Any]:
    """The geometries: well-known binary, or the arrays of GeoArrow. They are not copied."""
    column, field = _column(batch, name), batch.schema.field(name)
    extension: str | None = getattr(field.type, "extension_name", None)
    about = field.type.__arrow_ext_serialize__() if extension is not None else b""
    if extension is None and field.metadata:
        extension = field.metadata.get(b"ARROW:extension:name", b"").decode()
        about = field.metadata.get(b"ARROW:extension:metadata", b"")
    of_file = (batch.schema.metadata or {}).get(b"geo", b"")
    said = [_said(about), _said(of_file).get("columns", {}).get(name, {})]
    edges = next((one["edges"] for one in said if one.get("edges") not in (None, "planar")), None)
    if edges is not None:
        raise ValueError(f"{name}: the metadata say that edges are {edges}; tiles take edges as straight, also of this column if it is given without these metadata")
    kind = (extension or "").removeprefix("geoarrow.")
    if kind not in _DEPTHS:
        return _binary(batch, name)
    inner = getattr(column, "storage", column)
    missing = inner.is_null().to_numpy(zero_copy_only=False) if inner.null_count else None
    length, offsets = len(inner), []
    for _ in range(_DEPTHS[kind]):
        if not hasattr(inner, "offsets"):
            raise TypeError(f"{name}: expected the lists of {extension}, not {inner.type}")
        offsets.append(inner.offsets.to_numpy())
        inner = inner.values
    x, y = _coordinates(inner, kind == "point", f"{name}: expected the coordinates of {extension}, not {inner.type}")
    return {"kind": kind, "offsets": offsets, "x": x, "y": y, "length": length, "missing": missing}


def _said(metadata: bytes) -> dict[str, Any]:
    """The members of metadata, if they are JSON."""
    try:
        found = json.loads(metadata or b"{}")
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def _coordinates(points: pa.Array, may_lack: bool, wrong: str) -> tuple[Any, Any]:
    """The coordinates of points, which are apart or interleaved. Points that are missing may lack them."""
    import pyarrow as pa

    if pa.types.is_fixed_size_list(points.type) and points.type.list_size >= 2:
        step = points.type.list_size
        values = points.values.slice(points.offset * step, len(points) * step)
        sides = [values, values]
    elif pa.types.is_struct(points.type) and points.type.get_field_index("x") >= 0 and points.type.get_field_index("y") >= 0:
        step, sides = 1, [points.field("x"), points.field("y")]
    else:
        raise TypeError(wrong)
    if any(side.type != pa.float64() or (side.null_count and not may_lack) for side in sides):
        raise TypeError(wrong)
    sides = [side.fill_null(np.nan) if side.null_count else side for side in sides]
    x, y = (side.to_numpy() for side in sides)
    return (x, y) if step == 1 else (x[::step], y[1::step])


def _binary(batch: pa.RecordBatch, name: str) -> dict[str, Any]:
    """The values of a binary column, which are not copied, unless they are in a form without offsets."""
    import pyarrow as pa

    column = _column(batch, name)
    column = getattr(column, "storage", column)
    if pa.types.is_null(column.type) or pa.types.is_fixed_size_binary(column.type) or pa.types.is_binary_view(column.type):
        column = column.cast(pa.large_binary())
    if not (pa.types.is_binary(column.type) or pa.types.is_large_binary(column.type)):
        raise TypeError(f"{name}: expected binary values, such as well-known binary, not {column.type}")
    width = np.int64 if pa.types.is_large_binary(column.type) else np.int32
    _, offsets, data = column.buffers()
    ends = np.frombuffer(offsets, width)[column.offset : column.offset + len(column) + 1] if offsets and len(column) else np.zeros(1)
    return {
        "data": np.frombuffer(data, np.uint8) if data else np.empty(0, np.uint8),
        "ends": ends.astype(np.int64),
        "missing": column.is_null().to_numpy(zero_copy_only=False) if column.null_count else None,
    }


def _bytes(batches: Any, name: str) -> list[bytes]:
    """The values of a binary column in several batches or tables that are not null."""
    found = [one for given in batches for batch in _batches(given) for one in _column(batch, name).to_pylist()]
    wrong = next((one for one in found if not isinstance(one, (bytes, type(None)))), None)
    if wrong is not None:
        raise TypeError(f"{name}: expected bytes, not {type(wrong).__name__}")
    return [one for one in found if one is not None]


def _slices(ends: Any, data: bytes) -> Iterator[tuple[slice, pa.Array]]:
    """Binary values, given by their ends, in stretches that each fit into one column."""
    import pyarrow as pa

    start, last = 0, len(ends) - 1
    while start < last or start == 0:
        end = min(max(int(np.searchsorted(ends, ends[start] + _MOST, "right")) - 1, start + 1), last)
        offsets = (ends[start : end + 1] - ends[start]).astype(np.int32)
        values = pa.py_buffer(data).slice(int(ends[start]), int(ends[end] - ends[start]))
        yield slice(start, end), pa.Array.from_buffers(pa.binary(), end - start, [None, pa.py_buffer(offsets.tobytes()), values])
        if end == last:
            return
        start = end


def _numbers(batch: pa.RecordBatch, name: str) -> Any:
    column = _column(batch, name)
    if column.null_count:
        raise ValueError(f"{name}: a feature has no number")
    numbers = column.to_numpy(zero_copy_only=False)
    if numbers.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected integers, not {column.type}")
    if numbers.size and not (0 <= numbers.min() and numbers.max() < 2**32):
        raise ValueError(f"{name}: expected numbers from 0 to 4,294,967,295, not up to {numbers.max()}")
    return numbers.astype(np.uint32)
