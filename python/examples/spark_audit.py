"""Audits a layer that is partitioned over the workers of Spark: one report for each partition, as a row.

    pip install ./python pyspark "pandas>=2.2" pyarrow shapely
    python python/examples/spark_audit.py

It also needs a Java runtime. Spark asks for pandas and pyarrow when the frame is made, and does not install them.

A partition goes to its worker as Arrow batches of WKB (``DataFrame.mapInArrow``), is audited there, and one row comes back: the number of
the partition, how many features it has, whether it is valid, and the report as JSON. In real use the frame is read from Parquet, and
repartitioned by place, so that neighbours are together; here it is a grid of parcels in four partitions, of which one has a parcel
that overlaps its neighbour.

What this does not say: whether *all* partitions together are valid. A feature of one may cross a feature of another, and a hole of one may
be filled by another. A verdict over all would need certificates that add up: for each partition, with its counts, the edges on the
outside of its cells in a canonical form, so that two neighbours can be compared along the cut, and the components that reach the cut, so that
components, cycles and Euler's formula can be summed. Reports have no such part yet.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterator

import pyarrow as pa
import shapely
from pyspark import TaskContext
from pyspark.sql import SparkSession

SCHEMA = "partition int, features long, valid boolean, report string"


def audit_partition(batches: Iterator[pa.RecordBatch]) -> Iterator[pa.RecordBatch]:
    """One row with the report of the polygons in all batches."""
    import twinedge

    polygons = [shapely.from_wkb(wkb) for batch in batches for wkb in batch.column("geometry").to_pylist()]
    report = twinedge.audit(polygons, coverage=True)
    context = TaskContext.get()
    yield pa.RecordBatch.from_pylist(
        [
            {
                "partition": context.partitionId() if context else -1,
                "features": len(polygons),
                "valid": report.valid,
                "report": report.to_json(),
            }
        ],
        pa.schema([("partition", pa.int32()), ("features", pa.int64()), ("valid", pa.bool_()), ("report", pa.string())]),
    )


def parcels() -> list[tuple[int, bytearray]]:
    """Four blocks of nine parcels. In block 2, one is a tenth too wide."""
    rows = []
    for block in range(4):
        for i in range(9):
            x, y = 10 * block + i % 3, i // 3
            width = 1.1 if (block, i) == (2, 4) else 1.0
            rows.append((block, bytearray(shapely.to_wkb(shapely.box(x, y, x + width, y + 1)))))
    return rows


def main() -> list[dict[str, object]]:
    # The workers import what this program imports.
    os.environ.setdefault("PYSPARK_PYTHON", sys.executable)
    spark = (
        SparkSession.builder.master("local[2]")
        .appName("audit")
        .config("spark.ui.enabled", "false")
        .config("spark.sql.shuffle.partitions", "4")
        # Batches of a partition stay one partition: a block each.
        .config("spark.sql.adaptive.enabled", "false")
        .getOrCreate()
    )
    try:
        frame = spark.createDataFrame(parcels(), "block int, geometry binary")
        by_block = frame.repartitionByRange(4, "block").select("geometry")
        found = by_block.mapInArrow(audit_partition, SCHEMA).collect()
    finally:
        spark.stop()
    rows = sorted((row.asDict() for row in found), key=lambda row: row["partition"])
    for row in rows:
        report = json.loads(row["report"])
        findings = [finding["message"] for finding in report["findings"]]
        print(f"partition {row['partition']}: {row['features']} features, {'valid' if row['valid'] else 'not valid'}", *findings, sep="\n  ")
    return rows


if __name__ == "__main__":
    main()
