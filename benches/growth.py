#!/usr/bin/env python3
"""The results of `cargo bench --bench growth` as a table and a picture.

    benches/growth.py [FOLDER OF CRITERION]

reads `target/criterion` (or the folder given), and writes `benches/growth.csv` and `benches/growth.svg`. Needs matplotlib.
"""

import csv
import json
import math
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
# Draws identical pictures from identical numbers.
matplotlib.rcParams.update({"svg.hashsalt": "twinedge", "svg.fonttype": "none", "font.family": "sans-serif"})
import matplotlib.pyplot as plt  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
PER_POINT = {"node": "ns per segment", "edit": "ns per operator"}


def results(folder):
    """Rows of workload, way, size and nanoseconds per item, in order."""
    rows = []
    for file in sorted(folder.glob("*/*/*/new/benchmark.json")):
        about = json.loads(file.read_text())
        workload = about["group_id"].removeprefix("growth: ")
        if workload == about["group_id"]:
            continue
        items = about["throughput"]["Elements"]
        middle = json.loads((file.parent / "estimates.json").read_text())["median"]["point_estimate"]
        rows.append((workload, about["function_id"], int(about["value_str"]), round(middle / items, 2)))
    return sorted(rows)


def power_of(size):
    """The nearest power of ten."""
    return round(math.log10(size))


def table(rows):
    """The results in Markdown, a row for each workload and way, a column for each power of ten."""
    powers = sorted({power_of(size) for _, _, size, _ in rows})
    lines = ["| workload | way | " + " | ".join(f"10^{power}" for power in powers) + " |"]
    lines.append("| --- | --- | " + " | ".join("---:" for _ in powers) + " |")
    for workload, way in dict.fromkeys((row[0], row[1]) for row in rows):
        of = {power_of(size): ns for w, o, size, ns in rows if (w, o) == (workload, way)}
        cells = [f"{of[power]:.3g}" if power in of else "" for power in powers]
        lines.append(f"| {workload} | {way} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def draw(rows, to):
    workloads = sorted({row[0] for row in rows})
    columns = 4
    lines = -(-len(workloads) // columns)
    figure, axes = plt.subplots(lines, columns, figsize=(4 * columns, 3.4 * lines), layout="constrained", squeeze=False)
    for axis, workload in zip(axes.flat, workloads, strict=False):
        others = iter(("#c1440e", "#7a7a7a", "#3a7d2c"))
        for way in sorted({row[1] for row in rows if row[0] == workload}, key=lambda way: ("twinedge" in way, way)):
            points = sorted((size, ns) for w, of, size, ns in rows if (w, of) == (workload, way))
            ours = way.startswith("twinedge")
            style = {"color": "#0b6e99", "linewidth": 2} if ours else {"color": next(others), "linewidth": 1.2}
            if "threads" in way:
                style["linestyle"] = "--"
            axis.plot(*zip(*points, strict=True), marker="o", markersize=3, label=way, **style)
        axis.set(title=workload, xscale="log", yscale="log", xlabel="size", ylabel=PER_POINT.get(workload, "ns per half-edge"))
        found = [ns for of, _, _, ns in rows if of == workload]
        axis.set_ylim(10 ** math.floor(math.log10(min(found))), 10 ** math.ceil(math.log10(max(found))))
        axis.minorticks_off()
        axis.grid(True, alpha=0.3)
        axis.legend(fontsize=7)
    for axis in axes.flat[len(workloads) :]:
        axis.set_axis_off()
    figure.savefig(to, metadata={"Date": None})


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE.parent / "target" / "criterion"
    rows = results(folder)
    if not rows:
        sys.exit(f"no results in {folder}: run `cargo bench --bench growth` first")
    with (HERE / "growth.csv").open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["workload", "way", "size", "ns per item"])
        writer.writerows(rows)
    draw(rows, HERE / "growth.svg")
    print(table(rows))
    print(f"{len(rows)} results in {HERE / 'growth.csv'} and {HERE / 'growth.svg'}", file=sys.stderr)


if __name__ == "__main__":
    main()
