"""Audits a partitioned layer of GeoParquet on Spark, tile by tile: each fault once, with its place, also where it lies across partitions.

    pip install ./bindings/python pyspark "pandas>=2.2" pyarrow shapely
    python python/examples/spark_tiles.py

It also needs a Java runtime. In real use the layer is there; here it is a grid of parcels and a road, in five files, with overlaps, a gap, a
duplicate and a corner in the border of a neighbour. The road lies in five tiles, many parcels lie in two, and borders of tiles cut most of the faults.

Spark divides the features into the pieces that tiles need, gives each tile to a task and merges the summaries of the tiles; the features are named by
their own ids.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile

import pyarrow as pa
import pyarrow.parquet as pq
import shapely
from pyspark.sql import SparkSession

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
        columns = {"parcel": [f"p{number:03}" for number in numbers], "geometry": [layer[number].wkb for number in numbers], "bbox": boxes}
        pq.write_table(pa.table(columns).replace_schema_metadata({"geo": json.dumps(geo)}), f"{folder}/part-{part}.parquet")


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
        report, findings = tiles.spark.audit(spark.read.parquet(folder), id="parcel", vertices=64, **LIMITS)
        for row in findings.filter("rule LIKE 'C%'").select("rule", "kind", "ids", "x", "y", "area").collect():
            print(*row)
    finally:
        spark.stop()
    whole = twinedge.audit(layer, coverage=True, **LIMITS)
    found, expected = ({finding.id for finding in one.findings} for one in (report, whole))
    if (report.verdict, report.finding_count, found) != (whole.verdict, whole.finding_count, expected):
        raise SystemExit(f"not the same as on one machine: {report} and {whole}")
    print(f"the same as on one machine: {report.finding_count} findings")


if __name__ == "__main__":
    main()
