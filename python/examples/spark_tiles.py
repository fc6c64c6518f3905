"""Audits a layer on Spark, tile by tile: each fault once, with its place, also where it lies across partitions.

    pip install ./python pyspark "pandas>=2.2" pyarrow shapely
    python python/examples/spark_tiles.py

It also needs a Java runtime. In real use the frame is read from (Geo)Parquet with a column of well-known binary, and each feature has a
number of 32 bits; here it is a grid of parcels and a road, with ten overlaps. The road lies in five tiles, many parcels lie in two, and six of the overlaps
are cut by borders of tiles, one of them into four.

The rows go to the tiles that they meet (`assign`), the rows of a tile to one worker (`applyInPandas` or, as here, `repartition` and
`mapInArrow`), and one row comes back from each tile: its summary. Summaries are merged in pairs, on the workers, and the last one is finished here.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator

import pyarrow as pa
import shapely
from pyspark.sql import SparkSession

import twinedge
from twinedge import tiles

LIMITS = {"gap_width": 0.01, "lake_width": 10.0, "sliver_area": 0.001}


def parcels(across: int = 12) -> list[shapely.Polygon]:
    """Squares in rows, with a vertex in the middle of each side. Every sixteenth has half of its right neighbour, too."""
    squares = []
    for at in range(across * across):
        x, y = at % across, at // across
        wide = 1.5 if at % 16 == 5 and x + 1 < across else 1.0
        right = [(x + wide, y), (x + wide, y + 0.5), (x + wide, y + 1)] if wide == 1.0 else [(x + wide, y), (x + wide, y + 1)]
        below, above = [(x, y), (x + 0.5, y)], [(x + 0.5, y + 1), (x, y + 1), (x, y + 0.5)]
        middle = [[(x + 1, y)], [(x + 1, y + 1)]] if wide > 1.0 else [[], []]
        squares.append(shapely.Polygon([*below, *middle[0], *right, *middle[1], *above]))
    # A road along the upper side, and a plot that has a part of it.
    low, high = [(x / 2, across) for x in range(2 * across + 1)], [(x / 2, across + 0.4) for x in range(2 * across + 1)]
    plot = [*low[9:12], *high[11:8:-1]]
    return [*squares, shapely.Polygon([*low, *high[::-1]]), shapely.Polygon(plot)]


def is_cut(finding: twinedge.Finding, layer: list[shapely.Polygon], grid: tiles.Grid) -> bool:
    """True if a line between tiles runs through the place that the features claim together."""
    shared = shapely.intersection_all([layer[feature] for feature in finding.features])
    lines = [shapely.LineString([(12 * i / grid.columns, 0), (12 * i / grid.columns, 13)]) for i in range(1, grid.columns)]
    lines += [shapely.LineString([(0, 12 * i / grid.rows), (13, 12 * i / grid.rows)]) for i in range(1, grid.rows)]
    return any(shapely.relate_pattern(line, shared, "T********") for line in lines)


def main() -> None:
    # The workers import what this program imports.
    os.environ.setdefault("PYSPARK_PYTHON", sys.executable)
    layer = parcels()
    spark = (
        SparkSession.builder.master("local[2]")
        .appName("tiles")
        .config("spark.ui.enabled", "false")
        .config("spark.sql.shuffle.partitions", "4")
        .getOrCreate()
    )
    try:
        rows = [(number, bytearray(shapely.to_wkb(polygon))) for number, polygon in enumerate(layer)]
        frame = spark.createDataFrame(rows, "feature long, geometry binary").repartition(5)
        # Any box will do, as long as all workers have the same one.
        grid = tiles.Grid((0.0, 0.0, 12.0, 12.0), 5, 5)

        def assign(batches: Iterator[pa.RecordBatch]) -> Iterator[pa.RecordBatch]:
            return tiles.assign(batches, grid)

        def audit(batches: Iterator[pa.RecordBatch]) -> Iterator[pa.RecordBatch]:
            return tiles.audit_tiles(batches, grid, **LIMITS)

        assigned = frame.mapInArrow(assign, "tile long, feature long, geometry binary")
        summaries = assigned.repartition(8, "tile").mapInArrow(audit, "summary binary, cut binary")
        # These parcels meet at vertices only, so there are no cuts.
        batches = summaries.rdd.map(lambda row: pa.RecordBatch.from_pylist([{"summary": bytes(row.summary)}], tiles.schema()))
        report = tiles.finish(batches.treeReduce(tiles.merge), grid=grid, coverage=True, **LIMITS)
    finally:
        spark.stop()
    for finding in report.findings:
        print(finding.rule, finding.kind, finding.features, finding.at, finding.area)
    whole = twinedge.audit(layer, coverage=True, **LIMITS)
    found, expected = ({(f.rule, f.features, f.at) for f in one.findings} for one in (report, whole))
    if (report.verdict, report.finding_count, found) != (whole.verdict, whole.finding_count, expected):
        raise SystemExit(f"not the same as on one machine: {report} and {whole}")
    cut = sum(is_cut(finding, layer, grid) for finding in report.findings)
    print(f"the same as on one machine: {report.finding_count} findings, {cut} of them across borders of tiles")


if __name__ == "__main__":
    main()
