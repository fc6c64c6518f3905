"""Audits of layers in DuckDB."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any
from uuid import uuid4

from . import Audited
from ._engine import Plan, columns, survey

if TYPE_CHECKING:
    import pyarrow as pa

#: The rows of a batch.
_ROWS = 10_000


def audit(
    relation: Any,
    geometry: str = "geometry",
    id: str = "id",
    *,
    connection: Any = None,
    vertices: int = 100_000,
    accept: Any = None,
    list: int | None = None,
    crs: Any = None,
    **limits: Any,
) -> Audited:
    """Audits a layer in a relation of DuckDB as :func:`twinedge.audit` does the whole, with ``coverage=True``.

    DuckDB holds the rows and the pieces of tiles in temporary tables, and writes to disk what does not fit into its memory; this program holds the pieces of
    one tile and the summaries. So the layer may be larger than memory.

    Parameters
    ----------
    relation
        The relation, as :func:`duckdb.sql` returns it.
    geometry
        The column of geometries: well-known binary, or DuckDB's own type, for which its spatial extension must be loaded.
    id
        The column of ids, which are read as strings. ``findings`` names features by them.
    connection
        The connection of the relation, if that is not DuckDB's default connection.
    vertices, accept, list, crs, limits
        As for :func:`twinedge.tiles.spark.audit`.

    Raises ``ValueError`` and ``TypeError`` as :func:`twinedge.tiles.divide`.
    """
    import duckdb
    import pyarrow as pa

    if not hasattr(relation, "project"):
        raise TypeError(f"expected a relation of DuckDB, not {type(relation).__name__}")
    columns(relation.columns, geometry, id)
    database = duckdb.default_connection() if connection is None else connection
    place, name = (f'"{column.replace(chr(34), chr(34) * 2)}"' for column in (geometry, id))
    kinds = dict(zip(relation.columns, map(str, relation.types)))
    as_binary = f"ST_AsWKB({place})::BLOB" if kinds.get(geometry, "").startswith("GEOMETRY") else place
    tables = [f"twinedge_{one}_{uuid4().hex}" for one in ("rows", "pieces")]
    rows, pieces = tables
    try:
        numbered = f"CREATE TEMP TABLE {rows} AS SELECT row_number() OVER () - 1 AS number, * FROM given"
        relation.project(f"{name}::VARCHAR AS id, {as_binary} AS geometry").query("given", numbered)
        try:
            # Results are fetched whole, as none may be open while another statement runs.
            ((count,),) = database.execute(f"SELECT count(*) FROM {rows}").fetchall()
        except duckdb.CatalogException:
            relation.limit(0).query("given", f"DROP TABLE {rows}")
            raise ValueError("connection: the relation is that of another connection") from None

        def read() -> Iterator[pa.Table]:
            for start in range(0, count, _ROWS):
                yield database.sql(f"SELECT id, geometry FROM {rows} WHERE number >= {start} AND number < {start + _ROWS} ORDER BY number").to_arrow_table()

        plan = Plan.of([survey(read())], vertices, limits)
        database.execute(f"CREATE TEMP TABLE {pieces} (tile BIGINT, piece BLOB)")
        for batch in plan.divide(read(), 0):
            database.from_arrow(pa.Table.from_batches([batch])).query("given", f"INSERT INTO {pieces} SELECT * FROM given")
        tiles = [tile for (tile,) in database.execute(f"SELECT DISTINCT tile FROM {pieces} ORDER BY tile").fetchall()]

        def of_tile(tile: int) -> Any:
            return database.sql(f"SELECT tile, piece FROM {pieces} WHERE tile = {tile}").to_arrow_table()

        while not plan.is_complete():
            wanted = {*plan.cuts.tiles(plan.grid)}
            plan = plan.with_cuts([plan.cuts.search(of_tile(tile), plan.grid, tile) for tile in tiles if tile in wanted])
        whole = [summary for tile in tiles for summary in plan.summaries(of_tile(tile))]

        def ids_of(wanted: set[int]) -> pa.Table:
            return pa.Table.from_batches(plan.ids(read(), 0, wanted), pa.schema([("feature", pa.int64()), ("id", pa.string())]))

        report, findings = plan.audited(whole, ids_of, accept=accept, list=list, crs=crs)
    finally:
        for one in tables:
            database.execute(f"DROP TABLE IF EXISTS {one}")
    return Audited(report, database.from_arrow(findings))
