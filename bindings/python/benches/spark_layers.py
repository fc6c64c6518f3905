"""Two layers through tiles on Spark, on two cores of one machine, beside the program: the audit of each layer, and their overlay.

    cargo run --release -p twinedge-benches --bin cadastre -- 6500 540 0 plane > a.geojsonl
    cargo run --release -p twinedge-benches --bin cadastre -- 6500 540 0 plane shifted > b.geojsonl
    python bindings/python/benches/spark_layers.py a.geojsonl b.geojsonl --tiles 4 --program target/release/twinedge

It needs what `examples/spark_tiles.py` needs, and Linux. The layers are first written as eight files of GeoParquet each, which is not measured. Both
ways must say the same: verdict, counts and findings of the audits, number and area of the pieces (of layers that do not overlap themselves: of
others the program makes a piece for each pair of features). Seconds are those of the clock and of
the processor, in all processes; memory is the peak of their proportional share.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.dataset as ds
import shapely
from pyspark.sql import DataFrame, SparkSession
from pyspark.sql import functions as f

import twinedge
from twinedge import tiles

FILES = 8
#: With limits, the size of a tile's summary follows its findings and the cuts of its border, not all possible findings.
LIMITS = {"gap_width": 0.1, "sliver_area": 1.0}
COUNTS = ("vertices", "edges", "cycles", "faces", "components", "isolated_vertices")


def processes(root: int) -> tuple[float, int]:
    """The seconds of the processor that a process and its children have used, and the bytes of memory that they use now."""
    parents, ticks = {}, {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            fields = (folder / "stat").read_text().rpartition(")")[2].split()
        except OSError:
            continue
        parents[int(folder.name)], ticks[int(folder.name)] = int(fields[1]), sum(map(int, fields[11:15]))
    family = [root]
    for member in family:
        family += [child for child, parent in parents.items() if parent == member]
    memory = 0
    for member in family:
        try:
            rollup = Path(f"/proc/{member}/smaps_rollup").read_text()
        except OSError:
            continue
        memory += next((int(line.split()[1]) for line in rollup.splitlines() if line.startswith("Pss:")), 0) * 1024
    return sum(ticks[member] for member in family) / os.sysconf("SC_CLK_TCK"), memory


def measured(name: str, work: Callable[[], Any]) -> Any:
    """The outcome of the work. Prints what it took."""
    done, peak = threading.Event(), [0]
    start, (before, idle) = time.monotonic(), processes(os.getpid())

    def watch() -> None:
        while not done.wait(0.25):
            peak[0] = max(peak[0], processes(os.getpid())[1])

    watcher = threading.Thread(target=watch)
    watcher.start()
    try:
        outcome = work()
    finally:
        done.set()
        watcher.join()
    seconds = processes(os.getpid())[0] - before
    # The separate program uses none of the idle memory of this one.
    used = peak[0] - idle if "one process" in name else peak[0]
    print(f"| {name} | {time.monotonic() - start:.1f} s | {seconds:.1f} s | {used / 1e6:,.0f} MB |", flush=True)
    return outcome


def in_files(source: Path, folder: Path, program: str) -> Path:
    """A folder with the layer in several files of GeoParquet."""
    folder.mkdir()
    parts = [folder / f"{part}.geojsonl" for part in range(FILES)]
    outs = [part.open("wb") for part in parts]
    with source.open("rb") as lines:
        for number, line in enumerate(lines):
            # Neighbours are mostly in one file, as in a layer exported by districts.
            outs[number // 64 % FILES].write(line)
    for part, out in zip(parts, outs):
        out.close()
        subprocess.run([program, "convert", part, "-o", part.with_suffix(".parquet"), "--quiet"], check=True)
        part.unlink()
    return folder


def layer(spark: SparkSession, folder: Path) -> tuple[DataFrame, tuple[float, ...]]:
    """The features with their numbers, and the box around them."""
    frame = spark.read.parquet(str(folder))
    box = frame.agg(f.min("bbox.xmin"), f.min("bbox.ymin"), f.max("bbox.xmax"), f.max("bbox.ymax")).first()
    return frame.select(f.col("id").cast("long").alias("feature"), "geometry"), tuple(box)


def audit(spark: SparkSession, folder: Path) -> twinedge.Report:
    return tiles.spark.audit(spark.read.parquet(str(folder)), **LIMITS).report


def overlay(spark: SparkSession, folders: list[Path], side: int, to: Path) -> None:
    (left, box), (right, other) = (layer(spark, folder) for folder in folders)
    grid = tiles.Grid((*map(min, box[:2], other[:2]), *map(max, box[2:], other[2:])), side, side)

    def extents(batches: Iterator[pa.RecordBatch]) -> Iterator[pa.RecordBatch]:
        return tiles.extents(batches, grid)

    found = left.union(right).mapInArrow(extents, "tile long, x0 double, y0 double, x1 double, y1 double").toArrow()
    plan = tiles.Overlay(grid, found)

    def pieces(key: tuple[pa.Scalar, ...], left: pa.Table, right: pa.Table) -> pa.Table:
        return plan.pieces(left, right, key[0].as_py(), "union")

    left, right = (one.mapInArrow(plan.assign, "tile long, feature long, geometry binary").groupBy("tile") for one in (left, right))
    left.cogroup(right).applyInArrow(pieces, "left array<long>, right array<long>, geometry binary").write.parquet(str(to))


def said(report: dict[str, Any]) -> tuple[Any, ...]:
    """What an audit says, apart from the numbers of records and of features."""
    return report["verdict"], {name: report["counts"][name] for name in COUNTS}, sorted(one["id"] for one in report["coverage"]["findings"])


def covered(path: Path) -> tuple[int, float]:
    """The number of pieces, and their area."""
    count, area = 0, 0.0
    for batch in ds.dataset(path, format="parquet").to_batches(columns=["geometry"], batch_size=1000):
        count, area = count + len(batch), area + shapely.area(shapely.from_wkb(batch["geometry"].to_numpy(zero_copy_only=False))).sum()
    return count, area


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("layers", nargs=2, type=Path, help="newline-delimited GeoJSON whose ids are numbers")
    arguments.add_argument("--tiles", type=int, default=4, help="the number of columns and of rows")
    arguments.add_argument("--program", default=shutil.which("twinedge"))
    arguments.add_argument("--memory", default="1g", help="the most that Java may take")
    asked = arguments.parse_args()
    # The workers import the modules that this program imports.
    os.environ.setdefault("PYSPARK_PYTHON", sys.executable)
    with tempfile.TemporaryDirectory() as made:
        scratch = Path(made)
        folders = [in_files(source, scratch / str(number), asked.program) for number, source in enumerate(asked.layers)]
        print("| | clock | processor | memory |\n| --- | ---: | ---: | ---: |")

        def alone(*command: str | Path) -> Callable[[], Any]:
            return lambda: subprocess.run([asked.program, *command, "--quiet"], check=False)

        whole = []
        for number, source in enumerate(asked.layers):
            limits = [f"--gap-width={LIMITS['gap_width']}", f"--sliver={LIMITS['sliver_area']}"]
            measured(f"audit of {source.name}, one process", alone("audit", source, *limits, "-o", scratch / f"{number}.json"))
            whole.append(json.loads((scratch / f"{number}.json").read_text()))
        measured("overlay, one process", alone("overlay", *asked.layers, "-o", scratch / "pieces.parquet"))
        builder = SparkSession.builder.master("local[2]").appName("layers").config("spark.ui.enabled", "false")
        builder = builder.config("spark.driver.memory", asked.memory).config("spark.local.dir", made)
        builder = builder.config("spark.sql.shuffle.partitions", str(asked.tiles**2))
        # A row is some kilobytes.
        builder = builder.config("spark.sql.execution.arrow.maxRecordsPerBatch", "1000")
        spark = measured("start of Spark", builder.getOrCreate)
        try:
            for expected, folder, source in zip(whole, folders, asked.layers):
                report = measured(f"audit of {source.name}, Spark", lambda folder=folder: audit(spark, folder))
                assert said(report.to_dict()) == said(expected), source
            measured("overlay, Spark", lambda: overlay(spark, folders, asked.tiles, scratch / "pieces"))
        finally:
            spark.stop()
        (count, area), (pieces, expected_area) = covered(scratch / "pieces"), covered(scratch / "pieces.parquet")
        assert count == pieces and abs(area - expected_area) < 1e-9 * expected_area, (count, pieces, area, expected_area)
        print(f"\n{count:,} pieces of the area {area:,.3f}, and the same audits, both ways")


if __name__ == "__main__":
    main()
