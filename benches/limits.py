#!/usr/bin/env python3
"""The table "At the limit" of benches/README.md, from one run: a row for each kind of work, with its baseline or peer beside it.

    cargo build --release -p twinedge-cli --features full
    cargo bench -p twinedge-benches --bench build --bench certificate --bench traversal --bench edit --bench near
    g++ -std=c++17 -O3 -DNDEBUG -DCGAL_DISABLE_GMP benches/peers.cpp -o target/peers    # where CGAL is installed
    python benches/limits.py [FOLDER OF CRITERION]

Needs shapely, geopandas and the package of this project for the rows that name GEOS. A row whose results are missing is left out.
"""

import contextlib
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

import comparisons

ROOT = pathlib.Path(__file__).resolve().parent.parent
#: Runs a program that must end well, and prints its processor time and its peak of memory in kilobytes.
MEASURE = """
import resource, subprocess, sys
subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL)
usage = resource.getrusage(resource.RUSAGE_CHILDREN)
print(usage.ru_utime + usage.ru_stime, usage.ru_maxrss)
"""
#: Work, group, function, baseline, the word for it, and what was asked of the ratio or of the time per item.
ROWS = [
    ("gather and build `world-50m`, per segment", "build world-50m", "twinedge", "sort the ring segments", "sorting its segments", "2"),
    ("the same, snapped", "build world-50m", "twinedge, snapped", "twinedge", "not snapped", "1.7"),
    ("check of a plane's certificate, per half-edge", "certify a grid", "plane: check", "floor: L3 alone on plain u32 arrays", "one pass", "4"),
    ("check of a mesh of genus 0, that answers", "certify a grid", "mesh: check", "floor: L3 alone on plain u32 arrays", "one pass", "2.5"),
    ("its labels and their check", "certify a grid", "mesh: labels, and their check", "mesh: validate", "`validate`", "1.5"),
    ("`Face::half_edges` of all faces, per half-edge", "face loops", "Face::half_edges", "plain u32 arrays", "plain columns", "1.2"),
    ("`Audited` at places in the cache, per operator", "split and join an edge", "validated locally", "not validated", "not validated", ""),
    ("`Audited` at places not in the cache", "split and join an edge", "validated locally, cold", "validated locally", "in the cache", "1,000 ns"),
]


def results(folder):
    """Nanoseconds per item, by group and function; of several sizes the largest."""
    found = {}
    for file in folder.glob("**/new/benchmark.json"):
        about = json.loads(file.read_text())
        items = (about.get("throughput") or {}).get("Elements", 1)
        middle = json.loads((file.parent / "estimates.json").read_text())["median"]["point_estimate"]
        key, size = (about["group_id"], about["function_id"]), int(about.get("value_str") or 0)
        found[key] = max(found.get(key, (-1, 0.0)), (size, middle / items))
    return {key: ns for key, (_, ns) in found.items()}


def rounded(ns):
    return f"{ns:,.0f}" if ns >= 100 else f"{ns:.3g}"


def rows_of(found):
    for what, group, function, baseline, word, asked in ROWS:
        ours, theirs = found.get((group, function)), found.get((group, baseline))
        if ours and theirs:
            yield what, f"{rounded(ours)} ns", f"{word}: {rounded(theirs)} ns", ours / theirs, asked
    peers = ROOT / "target/peers"
    if peers.exists():
        said = subprocess.run([peers, "400"], check=True, capture_output=True, text=True).stdout
        for what, ours, theirs in [("`remove_edge` at random places", "remove_edge", "join_face"), ("`connect`, splitting faces at random places", "connect", "split_face")]:
            ns = found.get(("pairs of triangles", ours))
            best = min(map(float, re.findall(rf"{theirs} ([\d.]+) ns", said)))
            if ns:
                yield what, f"{rounded(ns)} ns", f"CGAL's `{theirs}`: {rounded(best)} ns", ns / best, "1"


def audits():
    """The program on a file, against GEOS in memory: processor time by turns, and the bytes at the peak."""
    import shapely

    polygons = comparisons.cells(320_000)
    shapes = [shapely.Polygon(outer) for (outer,) in polygons]
    positions = 5 * len(polygons)
    with tempfile.NamedTemporaryFile("w", suffix=".geojson") as file:
        json.dump(comparisons.geojson(polygons), file)
        file.flush()
        ours, theirs, peaks = [], [], []
        for _ in range(5):
            # Started by a small process: what is forked from this one begins with its peak of memory.
            run = [sys.executable, "-c", MEASURE, str(ROOT / "target/release/twinedge"), "audit", file.name, "--coverage"]
            seconds, peak = map(float, subprocess.run(run, check=True, capture_output=True, text=True).stdout.split())
            ours.append(seconds)
            peaks.append(1024 * peak)
            begin = time.process_time()
            assert shapely.coverage_is_valid(shapes)
            theirs.append(time.process_time() - begin)
    peer = f"GEOS {shapely.geos_version_string}, `coverage_is_valid` in memory"
    yield "audit of a GeoJSON file of 1.6 million positions, reading included", f"{min(ours):.2f} s", f"{peer}: {min(theirs):.2f} s", min(ours) / min(theirs), "0.6"
    bytes_each = (statistics.median(peaks) - 18e6) / positions
    yield "its bytes at the peak, less 18 MB, per position", f"{bytes_each:.0f}", "", None, "80"


def frames():
    import geopandas
    import shapely

    import twinedge

    frame = geopandas.read_file(ROOT / "tests/data/world-50m.geojson")
    ours, theirs = [], []
    for _ in range(7):
        for times, work in [(ours, lambda: twinedge.audit(frame, coverage=True)), (theirs, lambda: shapely.coverage_is_valid(frame.geometry.values))]:
            begin = time.process_time()
            work()
            times.append(1000 * (time.process_time() - begin))
    yield "`twinedge.audit` of a GeoDataFrame, `world-50m`", f"{min(ours):.0f} ms", f"`shapely.coverage_is_valid`: {min(theirs):.0f} ms", min(ours) / min(theirs), "1"


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "target/criterion"
    print("| work | twinedge | beside it | ratio | asked |\n| --- | --: | --- | --: | --: |")
    for rows in (audits(), rows_of(results(folder)), frames()):
        with contextlib.suppress(ImportError, FileNotFoundError):
            for what, ours, theirs, ratio, asked in rows:
                print(f"| {what} | {ours} | {theirs} | {f'{ratio:.2g}' if ratio else ''} | {asked} |", flush=True)


if __name__ == "__main__":
    main()
