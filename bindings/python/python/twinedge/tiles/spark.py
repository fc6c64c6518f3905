"""Audits of layers on Spark."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from typing import Any

from . import Audited, merge, schema
from ._engine import Plan, Survey, columns, survey


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
    """Audits a layer in a DataFrame of Spark as :func:`twinedge.audit` does the whole, with ``coverage=True``.

    Spark divides the features, gives each tile to a task, and merges the summaries of the tiles in pairs; this program gets one summary, and the ids of the
    features that the report names. The rows and the pieces are persisted meanwhile. A task that runs again makes the same bytes. If the rows of a partition
    differ between two passes, as after the layer was replaced, the job fails and says so. What is replaced while the first pass reads it is not noticed:
    read a snapshot. Causes are as in tiles of the program: a finding is not known to follow from another one that it touches.

    Parameters
    ----------
    frame
        The DataFrame.
    geometry
        The column of geometries as well-known binary. Of Sedona's geometries, select ``ST_AsBinary``.
    id
        The column of ids, which are read as strings. ``findings`` names features by them.
    vertices
        The number of vertices of a tile, about. A task takes some 1,000 bytes for each.
    accept, list, crs, limits
        As for :func:`twinedge.tiles.finish`. Summaries are smaller if ``gap_width`` and ``sliver_area`` are given.

    Raises ``ValueError`` and ``TypeError`` as :func:`twinedge.tiles.divide`, inside of Spark's error if a worker raised it.
    """
    import numpy as np
    import pyarrow as pa

    if not hasattr(frame, "mapInArrow"):
        raise TypeError(f"expected a DataFrame of Spark, not {type(frame).__name__}")
    columns(frame.columns, geometry, id)
    # Checking the types of this module does not take pyspark.
    TaskContext: Any = import_module("pyspark").TaskContext
    f: Any = import_module("pyspark.sql.functions")

    def column(name: str) -> Any:
        return f.col("`" + name.replace("`", "``") + "`")

    def partition() -> int:
        context = TaskContext.get()
        assert context is not None
        return int(context.partitionId())

    of_survey = pa.schema([("at", pa.int64()), ("rows", pa.int64()), ("box", pa.list_(pa.float64())), ("digest", pa.binary()), ("sample", pa.binary())])

    def surveyed(batches: Iterator[pa.RecordBatch]) -> Iterator[pa.RecordBatch]:
        found = survey(batches)
        row = {"at": partition(), "rows": found.rows, "box": found.box, "digest": found.digest, "sample": found.sample.tobytes()}
        yield pa.RecordBatch.from_pylist([row], of_survey)

    # The same rows have the same order whenever a partition is made again.
    rows = frame.select(column(id).cast("string").alias("id"), column(geometry).alias("geometry")).sortWithinPartitions("id", "geometry").persist()
    pieces = None
    try:
        partitions = rows.mapInArrow(surveyed, "at long, rows long, box array<double>, digest binary, sample binary").collect()
        surveys = {row.at: Survey(row.rows, row.box and tuple(row.box), bytes(row.digest), np.frombuffer(bytes(row.sample)).reshape(-1, 2)) for row in partitions}
        empty = survey([])
        plan = Plan.of([surveys.get(at, empty) for at in range(max(surveys, default=-1) + 1)], vertices, limits)

        def divide(batches: Iterator[pa.RecordBatch], plan: Plan = plan) -> Iterator[pa.RecordBatch]:
            return plan.divide(batches, partition())

        pieces = rows.mapInArrow(divide, "tile long, piece binary").repartition(min(len(plan.grid), 10_000), "tile").persist()
        while not plan.is_complete():

            def search(batches: Iterator[pa.RecordBatch], plan: Plan = plan) -> Iterator[pa.RecordBatch]:
                return plan.search(batches)

            cuts = [bytes(row.found) for row in pieces.mapInArrow(search, "found binary").collect()]
            plan = plan.with_cuts(pa.table({"found": pa.array(cuts, pa.binary())}))

        def summaries(batches: Iterator[pa.RecordBatch], plan: Plan = plan) -> Iterator[pa.RecordBatch]:
            return plan.summaries(batches)

        def batch(summary: bytes) -> pa.RecordBatch:
            return pa.RecordBatch.from_pylist([{"summary": summary}], schema())

        def both(one: bytes, other: bytes) -> bytes:
            (sum,) = merge(batch(one), batch(other))["summary"].to_pylist()
            return bytes(sum)

        found = pieces.mapInArrow(summaries, "summary binary").rdd.map(lambda row: bytes(row.summary))
        # Partitions without pieces have no summaries.
        whole = [] if found.isEmpty() else batch(found.treeReduce(both))

        def ids_of(wanted: set[int]) -> pa.Table:
            def ids(batches: Iterator[pa.RecordBatch], plan: Plan = plan) -> Iterator[pa.RecordBatch]:
                return plan.ids(batches, partition(), wanted)

            named = rows.mapInArrow(ids, "feature long, id string").collect() if wanted else []
            return pa.table({"feature": [row.feature for row in named], "id": [row.id for row in named]})

        report, findings = plan.audited(whole, ids_of, accept=accept, list=list, crs=crs)
    finally:
        rows.unpersist()
        if pieces is not None:
            pieces.unpersist()
    kinds = "rule string, kind string, features array<long>, x double, y double, area double, width double, length double, id string, message string"
    return Audited(report, frame.sparkSession.createDataFrame([tuple(row.values()) for row in findings.to_pylist()], kinds + ", ids array<string>"))
