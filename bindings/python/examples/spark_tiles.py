"""Audits a partitioned layer of GeoParquet on Spark, tile by tile: each fault once, with its place, also where it lies across partitions.

    pip install ./bindings/python pyspark "pandas>=2.2" pyarrow shapely
    python python/examples/spark_tiles.py

It also needs a Java runtime. In real use the layer is there; here it is a grid of parcels and a road, in five files, with overlaps, a gap, a
duplicate and a corner in the border of a neighbour. The road lies in five tiles, many parcels lie in two, and borders of tiles cut most of the faults.

Each feature needs a number. The rows go to the tiles that they meet (`assign`), the rows of a tile to one worker (`repartition` and
`mapInArrow`). Where borders cross, they are cut alike in all tiles: in a few rounds workers find where (`search_tiles`), and what all of them found is
taken here. Then one row comes back from each tile: its summary. Summaries are merged in pairs, on the workers, and the last one is finished here.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
from collections.abc import Iterator

import pyarrow as pa
import pyarrow.parquet as pq
import shapely
from pyspark.sql import SparkSession
from pyspark.sql import functions as f

import twinedge
from twinedge import tiles

LIMITS = {"gap_width": 0.3, "lake_width": 10.0, "sliver_area": 0.001}
ACROSS = 12


def parcels() -> list[shapely.Polygon]:
    """Squares in rows. Every sixteenth has half of its right neighbour, too, and their borders cross or touch."""
    squares = []
    for at in range(ACROSS * ACROSS):
        x, y = at % ACROSS, at // ACROSS
        squares.append(shapely.box(x, y, x + (1.5 if at % 16 == 5 and x + 1 < ACROSS else 1), y + 1))
    # Four parcels whose common corner is cut off: a gap.
    for at, (dx, dy) in [(50, (1, 1)), (51, (-1, 1)), (62, (1, -1)), (63, (-1, -1))]:
        x, y = 3, 5
        squares[at] = squares[at].difference(shapely.Polygon([(x - 0.4, y), (x, y - 0.4), (x + 0.4, y), (x, y + 0.4)]))
    # A road along the upper side, a plot that overlaps a part of it, and a duplicate parcel.
    road = shapely.segmentize(shapely.box(0, ACROSS, ACROSS, ACROSS + 0.4), 1)
    return [*squares, road, shapely.box(4.5, ACROSS, 5.5, ACROSS + 0.4), squares[100]]


def write(layer: list[shapely.Polygon], folder: str) -> None:
    """The layer in five files, as geopandas and others write them, each with rows from all over it."""
    for part in range(5):
        numbers = [*range(part, len(layer), 5)]
        boxes = [dict(zip(("xmin", "ymin", "xmax", "ymax"), layer[number].bounds)) for number in numbers]
        covering = {"bbox": {side: ["bbox", side] for side in boxes[0]}}
        geo = {"version": "1.1.0", "primary_column": "geometry"}
        geo["columns"] = {"geometry": {"encoding": "WKB", "geometry_types": ["Polygon"], "covering": covering}}
        columns = {"parcel": numbers, "geometry": [layer[number].wkb for number in numbers], "bbox": boxes}
        pq.write_table(pa.table(columns).replace_schema_metadata({"geo": json.dumps(geo)}), f"{folder}/part-{part}.parquet")


def is_cut(finding: twinedge.Finding, layer: list[shapely.Polygon], grid: tiles.Grid) -> bool:
    """True if a line between tiles runs through the place that several features claim together."""
    if finding.rule not in ("C1", "C5"):
        return False
    shared = shapely.intersection_all([layer[feature] for feature in finding.features])
    x0, y0, x1, y1 = grid.box
    upright = [x0 + (x1 - x0) * i / grid.columns for i in range(1, grid.columns)]
    level = [y0 + (y1 - y0) * i / grid.rows for i in range(1, grid.rows)]
    lines = [shapely.LineString([(x, y0), (x, y1)]) for x in upright] + [shapely.LineString([(x0, y), (x1, y)]) for y in level]
    return any(shapely.relate_pattern(line, shared, "T********") for line in lines)


def main() -> None:
    # The workers import the modules that this program imports.
    os.environ.setdefault("PYSPARK_PYTHON", sys.executable)
    layer, folder = parcels(), tempfile.mkdtemp()
    write(layer, folder)
    spark = (
        SparkSession.builder.master("local[2]")
        .appName("tiles")
        .config("spark.ui.enabled", "false")
        .config("spark.sql.shuffle.partitions", "4")
        .getOrCreate()
    )
    try:
        frame = spark.read.parquet(folder)
        # A layer without numbers of its own gets some by `frame.rdd.zipWithIndex()`, once and for all: rows have no order.
        features = frame.select(f.col("parcel").alias("feature"), "geometry")
        low = frame.agg(f.min("bbox.xmin"), f.min("bbox.ymin"), f.max("bbox.xmax"), f.max("bbox.ymax")).first()
        box = tuple(low)
        grid, cuts = tiles.Grid(box, 5, 5), tiles.Cuts(box)

        def assign(batches: Iterator[pa.RecordBatch], cuts: tiles.Cuts = cuts) -> Iterator[pa.RecordBatch]:
            return tiles.assign(batches, grid, cuts)

        assigned = features.mapInArrow(assign, "tile long, feature long, geometry binary").repartition(8, "tile").persist()
        while cuts.tiles(grid):

            def search(batches: Iterator[pa.RecordBatch], cuts: tiles.Cuts = cuts) -> Iterator[pa.RecordBatch]:
                return cuts.search_tiles(batches, grid)

            cuts = cuts.take(assigned.mapInArrow(search, "found binary").toArrow())

        def audit(batches: Iterator[pa.RecordBatch]) -> Iterator[pa.RecordBatch]:
            return tiles.audit_tiles(batches, grid, cuts=cuts, **LIMITS)

        def batch(row) -> pa.RecordBatch:
            return pa.RecordBatch.from_pylist([{"summary": bytes(row.summary)}], tiles.schema())

        summaries = assigned.mapInArrow(audit, "summary binary")
        report = tiles.finish(summaries.rdd.map(batch).treeReduce(tiles.merge), grid=grid, coverage=True, **LIMITS)
    finally:
        spark.stop()
    for finding in report.findings:
        print(finding.rule, finding.kind, finding.features, finding.at, finding.area)
    whole = twinedge.audit(layer, coverage=True, **LIMITS)
    found, expected = ({finding.id for finding in one.findings} for one in (report, whole))
    if (report.verdict, report.finding_count, found) != (whole.verdict, whole.finding_count, expected):
        raise SystemExit(f"not the same as on one machine: {report} and {whole}")
    cut = sum(is_cut(finding, layer, grid) for finding in report.findings)
    print(f"the same as on one machine: {report.finding_count} findings, {cut} overlaps and duplicates across borders of tiles")


if __name__ == "__main__":
    main()
