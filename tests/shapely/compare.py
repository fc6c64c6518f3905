"""C1 … C7 of `twinedge audit` beside shapely, on random coverages, random polygons and the maps of the repository.

    compare.py PROGRAM [--seed N] [--cases N] [--self-test]

PROGRAM is the program `twinedge`. What is compared:

* no overlap, no duplicate and no edges that meet elsewhere than at shared ends, if and only if `coverage_is_valid`;
* features with `coverage_invalid_edges` are in an overlap, and each overlap has a feature with such edges;
* the area of all overlaps, and that of all gaps, with those of intersections and unions;
* the features with near misses, with the `coverage_invalid_edges` that a `gap_width` adds, for strips of constant width that
  are open to the outside or to a lake, and for notches;
* validity by the OGC: `is_valid` of every feature, and that the reason that GEOS stops at is among those found.

Exit status: 0 all agree (with --self-test: dropped findings are noticed); 1 otherwise.
"""

import argparse
import itertools
import json
import pathlib
import random
import subprocess
import sys
import tempfile

import shapely
from shapely import affinity
from shapely.geometry import MultiPolygon, Polygon, mapping, shape
from shapely.ops import polygonize

ROOT = pathlib.Path(__file__).resolve().parents[2]
MAPS = ["crates/cli/data/world-110m.geojson", "tests/data/world-110m-crossing.geojson", "tests/data/world-50m.geojson"]
ALL = "1000000"


class Comparison:
    def __init__(self, program, forgets=False):
        self.program = program
        # True to drop the first finding of each rule, to see that the comparison notices.
        self.forgets = forgets
        self.compared = {}
        self.differing = []

    def audit(self, geometries, *options):
        """The report of `audit` on these geometries."""
        features = [{"type": "Feature", "id": i, "properties": {}, "geometry": mapping(g)} for i, g in enumerate(geometries)]
        with tempfile.NamedTemporaryFile("w", suffix=".geojson") as file:
            json.dump({"type": "FeatureCollection", "features": features}, file)
            file.flush()
            return self.audit_file(file.name, *options)

    def audit_file(self, name, *options):
        command = [self.program, "audit", "--format", "json", "--list", ALL, *options, str(name)]
        output = subprocess.run(command, capture_output=True, text=True, check=False)
        if output.returncode not in (0, 1):
            raise SystemExit(f"{' '.join(command)}: {output.stderr}")
        report = json.loads(output.stdout)
        if self.forgets:
            listed = report["coverage"]["findings"]
            report["coverage"]["findings"] = [b for a, b in zip([{"rule": None}, *listed], listed) if a["rule"] == b["rule"]]
        return report

    def same(self, what, case, ours, theirs):
        self.compared[what] = self.compared.get(what, 0) + 1
        if ours != theirs:
            self.differing.append(f"{what}: {case}: twinedge has {ours}, shapely has {theirs}")

    def close(self, what, case, ours, theirs, scale):
        """`scale`: the area of everything."""
        self.compared[what] = self.compared.get(what, 0) + 1
        if abs(ours - theirs) > 1e-10 * scale:
            self.differing.append(f"{what}: {case}: twinedge has {ours}, shapely has {theirs}")


def findings(report, *rules):
    return [f for f in report["coverage"]["findings"] if f["rule"] in rules]


def numbers(found):
    return {feature["number"] for finding in found for feature in finding["features"]}


def is_noded(report):
    return not any(rule["violations"] for rule in report["rules"] if rule["id"] == "G4")


def cells(rng, columns, rows):
    """A grid whose vertices were moved: a sound coverage of quadrilaterals."""
    at = {
        (x, y): (10 * x + rng.uniform(-3, 3), 10 * y + rng.uniform(-3, 3))
        for x in range(columns + 1)
        for y in range(rows + 1)
    }
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    return [
        Polygon([at[x + dx, y + dy] for dx, dy in square]) for x, y in itertools.product(range(columns), range(rows))
    ]


def plant(rng, coverage, kind):
    """A coverage with something wrong in it, except for the kinds `sound` and `lake`, in which nothing overlaps."""
    coverage = list(coverage)
    chosen = rng.randrange(len(coverage))
    polygon = coverage[chosen]
    size = 10 ** rng.uniform(-6, -0.5)
    if kind == "grown":
        coverage[chosen] = polygon.buffer(size, join_style="mitre")
    elif kind == "shrunk":
        coverage[chosen] = polygon.buffer(-size, join_style="mitre")
    elif kind == "shifted":
        coverage[chosen] = affinity.translate(polygon, rng.uniform(-size, size), rng.uniform(-size, size))
    elif kind == "moved vertex":
        points = list(polygon.exterior.coords)[:-1]
        moved = rng.randrange(len(points))
        points[moved] = (points[moved][0] + rng.uniform(-size, size), points[moved][1] + rng.uniform(-size, size))
        coverage[chosen] = Polygon(points)
    elif kind == "duplicate":
        coverage.append(polygon)
    elif kind == "lake":
        del coverage[chosen]
    elif kind == "lid":
        coverage.append(affinity.scale(polygon, 0.5, 0.5))
    return coverage


def compare_coverage(comparison, case, coverage):
    report = comparison.audit(coverage)
    if not all(polygon.is_valid for polygon in coverage):
        return
    valid = bool(shapely.coverage_is_valid(coverage))
    claimed_twice = findings(report, "C1", "C5")
    comparison.same("coverage_is_valid", case, not claimed_twice and is_noded(report), valid)
    edges = shapely.coverage_invalid_edges(coverage)
    invalid = {i for i, found in enumerate(edges) if not found.is_empty}
    # Of an overlap, shapely marks the edges that lie inside another feature: those of one of the two may be all there are.
    comparison.same("features with invalid edges", case, invalid - numbers(claimed_twice), set())
    unmarked = [f for f in claimed_twice if not numbers([f]) & invalid]
    comparison.same("overlaps without invalid edges", case, unmarked, [])
    compare_areas(comparison, case, coverage, report)


def compare_areas(comparison, case, coverage, report):
    tree = shapely.STRtree(coverage)
    pairs = [(i, j) for i, j in zip(*tree.query(coverage, predicate="intersects")) if i < j]
    twice = shapely.union_all([shapely.intersection(coverage[i], coverage[j]) for i, j in pairs])
    union = shapely.union_all(coverage)
    # A gap may lie between two parts that touch at points, so what the borders enclose is filled, and not each part.
    filled = shapely.union_all(list(polygonize(shapely.get_parts(shapely.union_all([union.boundary])))))
    ours = sum(f["area"] for f in findings(report, "C1"))
    # The faces of duplicates are overlaps as well, if nothing else overlaps there.
    ours += sum(f["area"] for f in findings(report, "C5"))
    comparison.close("area of overlaps", case, ours, twice.area, union.area)
    gaps = sum(f["area"] for f in findings(report, "C2"))
    comparison.close("area of gaps", case, gaps, filled.area - union.area, union.area)


def compare_strips(comparison, case, rng):
    """Columns side by side, with strips of constant width between them that are open at both ends."""
    limit = rng.uniform(0.01, 0.5)
    x, columns, narrow = 0.0, [], set()
    for i in range(6):
        if i > 0:
            width = rng.choice([0.0, rng.uniform(0.2, 0.9) * limit, rng.uniform(1.1, 5.0) * limit])
            narrow |= {i - 1, i} if 0 < width < limit else set()
            x += width
        columns.append(shapely.box(x, 0, x + 10, 30))
        x += 10
    if rng.random() < 0.5:
        # The strips open into a lake, and not to the outside.
        columns.append(shapely.box(-10, -10, x + 10, 40) - shapely.box(-5, -5, x + 5, 35))
    angle = rng.uniform(0, 360)
    columns = [affinity.rotate(column, angle, origin=(0, 0)) for column in columns]
    # Columns without a strip between them may have become uneven by a rounding; these are no near misses of any width.
    report = comparison.audit(columns, "--gap-width", str(limit))
    ours = numbers(f for f in findings(report, "C3") if f["width"] > 1e-9)
    without = shapely.coverage_invalid_edges(columns)
    with_gaps = shapely.coverage_invalid_edges(columns, gap_width=limit)
    touching = {i for i, found in enumerate(without) if not found.is_empty}
    theirs = {i for i, found in enumerate(with_gaps) if not found.is_empty}
    comparison.same("gap_width, as planted", case, ours, narrow)
    comparison.same("gap_width, as shapely sees it", case, ours | touching, theirs | (narrow & touching))


def compare_notches(comparison, case, rng):
    """Two polygons that part at a vertex: a near miss from about the width of the mouth on."""
    mouth, deep = rng.uniform(0.5, 20), rng.uniform(40, 60)
    west = Polygon([(0, 0), (50, 0), (50, 100 - deep), (50 - mouth / 2, 100), (0, 100)])
    east = Polygon([(50, 0), (100, 0), (100, 100), (50 + mouth / 2, 100), (50, 100 - deep)])
    angle = rng.uniform(0, 360)
    notch = [affinity.rotate(polygon, angle, origin=(0, 0)) for polygon in (west, east)]
    for width in [10 ** rng.uniform(-6, 0) * mouth, rng.uniform(1.01, 1.5) * mouth]:
        ours = numbers(findings(comparison.audit(notch, "--gap-width", str(width)), "C3"))
        theirs = {i for i, found in enumerate(shapely.coverage_invalid_edges(notch, gap_width=width)) if not found.is_empty}
        comparison.same("gap_width, notches", f"{case}, {width} of {mouth}", ours, theirs)


def random_polygon(rng):
    """Rings of a few points on a small grid, so that they touch, cross, nest and run along each other often."""
    size = rng.choice([4, 6, 10])

    def ring():
        if rng.random() < 0.5:
            x, y, w, h = rng.randrange(size), rng.randrange(size), rng.randint(1, size), rng.randint(1, size)
            return [(x, y), (x + w, y), (x + w, y + h), (x, y + h), (x, y)]
        points = [(rng.randrange(size), rng.randrange(size)) for _ in range(rng.randint(3, 6))]
        return [*points, points[0]]

    polygons = [Polygon(ring(), [ring() for _ in range(rng.choice([0, 0, 1, 2]))]) for _ in range(rng.choice([1, 1, 2]))]
    return polygons[0] if len(polygons) == 1 else MultiPolygon(polygons)


def touching_polygon(rng):
    """A large shell with triangles in it that touch each other and the shell at vertices: the inside may fall apart."""
    at = lambda: (rng.randrange(1, 6), rng.randrange(1, 6))
    holes = [[at(), at(), at()] for _ in range(rng.randint(1, 4))]
    edge = [(0, y) for y in range(6, -1, -1)] + [(x, 0) for x in range(1, 7)] + [(6, y) for y in range(1, 7)]
    for hole in holes:
        if rng.random() < 0.7:
            hole[0] = rng.choice(edge)
    return Polygon(edge, holes)


def compare_validity(comparison, case, geometries, report):
    ours = {f["features"][0]["number"]: [d["reason"] for d in f["defects"]] for f in findings(report, "C6")}
    for i, geometry in enumerate(geometries):
        reason = shapely.is_valid_reason(geometry).partition("[")[0]
        comparison.same("is_valid", f"{case}, {geometry.wkt[:200]}", i not in ours, bool(geometry.is_valid))
        if not geometry.is_valid and i in ours:
            # GEOS takes rings with the same points as a kind of their own; here they run along each other.
            reason = {"Duplicate Rings": "Self-intersection"}.get(reason, reason)
            # If rings run along each other GEOS may stop at the disconnected inside, or at a hole outside of its shell.
            later = {"Interior is disconnected", "Hole lies outside shell"}
            if reason in later and set(ours[i]) == {"Self-intersection"}:
                reason = "Self-intersection"
            comparison.same(f"reason {reason}", f"{case}, {geometry.wkt[:200]}: {ours[i]}", reason in ours[i], True)


def compare_map(comparison, name):
    report = comparison.audit_file(ROOT / name)
    features = json.loads((ROOT / name).read_text())["features"]
    geometries = [shape(feature["geometry"]) for feature in features]
    compare_validity(comparison, name, geometries, report)
    sound = [geometry if geometry.is_valid else shapely.make_valid(geometry) for geometry in geometries]
    polygons = [g for g in sound if g.geom_type in ("Polygon", "MultiPolygon")]
    if len(polygons) == len(sound) and is_noded(report) and all(g.is_valid for g in geometries):
        claimed_twice = findings(report, "C1", "C5")
        comparison.same("coverage_is_valid", name, not claimed_twice, bool(shapely.coverage_is_valid(polygons)))
    compare_areas(comparison, name, [shapely.union_all([g]) for g in sound if g.area > 0], report)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("program")
    arguments.add_argument("--seed", type=int, default=14)
    arguments.add_argument("--cases", type=int, default=20, help="random coverages of each kind")
    arguments.add_argument("--self-test", action="store_true", help="drop findings, and fail unless all of it is noticed")
    arguments = arguments.parse_args()
    rng = random.Random(arguments.seed)
    comparison = Comparison(arguments.program, arguments.self_test)
    for kind in ["sound", "grown", "shrunk", "shifted", "moved vertex", "duplicate", "lake", "lid"]:
        for n in range(arguments.cases):
            coverage = plant(rng, cells(rng, rng.randint(2, 5), rng.randint(2, 5)), kind)
            compare_coverage(comparison, f"{kind} {n}", coverage)
    for n in range(arguments.cases):
        compare_strips(comparison, f"strips {n}", rng)
        compare_notches(comparison, f"notch {n}", rng)
    for n, make in itertools.product(range(arguments.cases), [random_polygon, touching_polygon]):
        geometries = [make(rng) for _ in range(100)]
        compare_validity(comparison, f"polygons {n}", geometries, comparison.audit(geometries))
    for name in [] if arguments.self_test else MAPS:
        compare_map(comparison, name)
    print(f"shapely {shapely.__version__}, GEOS {shapely.geos_version_string}")
    for what, count in sorted(comparison.compared.items()):
        print(f"{count:7} {what}")
    for line in comparison.differing[:40]:
        print(line)
    print(f"{len(comparison.differing)} differ")
    if arguments.self_test:
        noticed = {line.partition(":")[0] for line in comparison.differing}
        expected = {"coverage_is_valid", "area of overlaps", "area of gaps", "gap_width, as planted", "is_valid"}
        missing = expected - noticed
        print("the comparison notices what is dropped" if not missing else f"not noticed: {missing}")
        return 1 if missing else 0
    return 1 if comparison.differing else 0


if __name__ == "__main__":
    sys.exit(main())
