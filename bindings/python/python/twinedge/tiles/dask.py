"""Audits of layers on Dask."""

from __future__ import annotations

from collections.abc import Iterable
from importlib import import_module
from typing import TYPE_CHECKING, Any

from .._columns import _by_tile
from . import Audited, merge
from ._engine import Plan, columns, survey

if TYPE_CHECKING:
    import pyarrow as pa


def audit(
    frame: Any,
    geometry: str = "geometry",
    id: str = "id",
    *,
    vertices: int = 100_000,
    accept: Any = None,
    list: int | None = None,
    crs: Any = None,
    **limits: Any,
) -> Audited:
    """Audits a layer in a DataFrame of Dask as :func:`twinedge.audit` does the whole, with ``coverage=True``.

    Dask divides the features of each partition, gives each tile to a task, and merges the summaries in pairs; this program gets one summary, and the ids of the
    features that the report names. A task that runs again makes the same bytes. If the rows of a partition differ between two passes, as after the layer
    was replaced, an error says so.

    Parameters
    ----------
    frame
        The DataFrame, also one of dask-geopandas.
    geometry
        The column of geometries: well-known binary, or those of shapely.
    id
        The column of ids, which are read as strings. ``findings`` names features by them.
    vertices, accept, list, crs, limits
        As for :func:`twinedge.tiles.spark.audit`.

    Raises ``ValueError`` and ``TypeError`` as :func:`twinedge.tiles.divide`.
    """
    import pyarrow as pa

    # Dask declares only some types.
    dask: Any = import_module("dask")
    bag: Any = import_module("dask.bag")

    if not hasattr(frame, "to_delayed"):
        raise TypeError(f"expected a DataFrame of Dask, not {type(frame).__name__}")
    columns(frame.columns, geometry, id)
    # Threads, unless there is a client: bags would take processes.
    scheduler = import_module("dask.base").get_scheduler(collections=[frame])
    crs = getattr(frame, "crs", None) if crs is None else crs
    rows = [dask.delayed(_rows)(part, geometry, id) for part in frame[[id, geometry]].to_delayed()]
    plan = Plan.of([*dask.compute(*(dask.delayed(survey)(part) for part in rows), scheduler=scheduler)], vertices, limits)
    divided = [dask.delayed(_divided)(plan, part, at) for at, part in enumerate(rows)]
    of_tiles = bag.from_delayed(divided).groupby(lambda one: one[0]).map(_table).persist(scheduler=scheduler)
    while not plan.is_complete():
        plan = plan.with_cuts(of_tiles.map(_searched, plan).compute(scheduler=scheduler))
    sums = of_tiles.map(_summed, plan).fold(merge, initial=merge())

    def ids_of(wanted: set[int]) -> pa.Table:
        ids = dask.compute(*(dask.delayed(_ids)(plan, part, at, wanted) for at, part in enumerate(rows)), scheduler=scheduler)
        return pa.concat_tables(ids)

    report, findings = plan.audited(sums.compute(scheduler=scheduler), ids_of, accept=accept, list=list, crs=crs)
    return Audited(report, findings.to_pandas())


def _rows(part: Any, geometry: str, id: str) -> pa.Table:
    """The rows of a partition, which is a DataFrame of pandas or geopandas."""
    import pyarrow as pa
    import shapely

    column = part[geometry].to_numpy(object)
    if any(shapely.is_geometry(column)):
        column = shapely.to_wkb(column, flavor="iso")
    ids = pa.array([None if one is None else one.decode(errors="replace") if isinstance(one, bytes) else str(one) for one in part[id]], pa.string())
    return pa.table({"id": ids, "geometry": pa.array(column, pa.binary())})


def _divided(plan: Plan, part: pa.Table, at: int) -> list[tuple[int, pa.Table]]:
    return [*_by_tile(plan.divide(part, at))]


def _table(of_tile: tuple[int, list[tuple[int, pa.Table]]]) -> pa.Table:
    import pyarrow as pa

    return pa.concat_tables([table for _, table in of_tile[1]])


def _searched(of_tile: pa.Table, plan: Plan) -> list[pa.RecordBatch]:
    return [*plan.search(of_tile)]


def _summed(of_tile: pa.Table, plan: Plan) -> pa.RecordBatch:
    (summary,) = plan.summaries(of_tile)
    return summary


def _ids(plan: Plan, part: pa.Table, at: int, wanted: Iterable[int]) -> pa.Table:
    import pyarrow as pa

    return pa.Table.from_batches(plan.ids(part, at, wanted), pa.schema([("feature", pa.int64()), ("id", pa.string())]))
