"""Holds `twinedge clean` beside mapshaper's `-clean`, on counties with planted faults and on those of the United States.

    compare.py TWINEDGE MAPSHAPER COUNTIES.topojson FOLDER

Prints a table: features left, features changed, area moved, points, invalid polygons, processor time. Needs shapely. See `run`.
"""

import hashlib
import json
import math
import pathlib
import random
import resource
import subprocess
import sys

import shapely
from shapely.geometry import MultiPoint, Point, Polygon, box, mapping, shape
from shapely.ops import voronoi_diagram


def counties():
    """240 cells with winding borders, and what is planted: overlaps and gaps of three widths, a duplicate, a bow tie."""
    draw = random.Random(7)
    frame = box(0, 0, 100_000, 60_000)
    sites = MultiPoint([Point(draw.uniform(0, 100_000), draw.uniform(0, 60_000)) for _ in range(240)])
    cells = [shapely.set_precision(cell.intersection(frame), 0.01) for cell in voronoi_diagram(sites, envelope=frame).geoms]
    polygons = {f"C{i:03}": Polygon(winding(cell)) for i, cell in enumerate(cells)}
    names = sorted(polygons)
    corners = {name: set(polygons[name].exterior.coords) for name in names}
    pairs = [(a, b) for i, a in enumerate(names) for b in names[i + 1 :] if len(corners[a] & corners[b]) >= 4]
    draw.shuffle(pairs)
    used = set()
    for distance in (300, 25, 0.5, -300, -40, -0.5):
        a, b, ring = next(found for pair in pairs if not used & set(pair) and (found := moved(polygons, *pair, distance)))
        polygons[a] = Polygon(ring)
        used |= {a, b}
    free = (name for name in names if name not in used)
    polygons["C900"] = polygons[next(free)]
    bow = next(free)
    ring = list(polygons[bow].exterior.coords)[:-1]
    middle = len(ring) // 2
    ring[middle], ring[middle + 1] = ring[middle + 1], ring[middle]
    polygons[bow] = Polygon(ring)
    return collection(polygons)


def winding(cell):
    """The ring of a cell with more points, each moved by what its place says, so that neighbours agree."""
    ring = []
    corners = list(cell.exterior.coords)
    for a, b in zip(corners, corners[1:]):
        low, high = min(a, b), max(a, b)
        parts = max(1, int(math.dist(a, b) // 900))
        between = [tuple(round(low[k] + (high[k] - low[k]) * i / parts, 2) for k in (0, 1)) for i in range(parts + 1)]
        ring += (between if a == low else between[::-1])[:-1]
    return [somewhere_near(*point) for point in ring]


def somewhere_near(x, y):
    if x <= 0 or y <= 0 or x >= 100_000 or y >= 60_000:
        return (x, y)
    digest = hashlib.md5(f"{x:.2f},{y:.2f}".encode()).digest()
    return (round(x + (digest[0] - 128) * 0.4, 2), round(y + (digest[1] - 128) * 0.4, 2))


def moved(polygons, a, b, distance):
    """The ring of the first, with a point of the common border moved towards the second; nothing if it would not be valid."""
    ring = list(polygons[a].exterior.coords)[:-1]
    others = set(polygons[b].exterior.coords)
    inner = [k for k in range(len(ring)) if {ring[k - 1], ring[k], ring[(k + 1) % len(ring)]} <= others]
    if not inner:
        return None
    k = inner[len(inner) // 2]
    (x, y), to = ring[k], polygons[b].representative_point()
    length = math.dist((x, y), (to.x, to.y))
    ring[k] = (round(x + distance * (to.x - x) / length, 2), round(y + distance * (to.y - y) / length, 2))
    return (a, b, ring) if Polygon(ring).is_valid else None


def collection(polygons):
    features = [
        {"type": "Feature", "properties": {"name": name}, "geometry": mapping(polygon)} for name, polygon in sorted(polygons.items())
    ]
    return {"type": "FeatureCollection", "features": features}


def timed(*command):
    """Runs a command; its processor time in seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(list(map(str, command)), check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def geometries(file):
    """By name, what shapely makes of each; rings of less than four points enclose nothing."""

    def closed(polygons):
        rings = [[ring for ring in polygon if len(ring) >= 4] for polygon in polygons]
        return {"type": "MultiPolygon", "coordinates": [polygon for polygon in rings if polygon]}

    found = {}
    for feature in json.loads(file.read_text())["features"]:
        geometry = feature["geometry"]
        if geometry:
            parts = [geometry["coordinates"]] if geometry["type"] == "Polygon" else geometry["coordinates"]
            found[feature.get("id") or feature["properties"]["name"]] = shape(closed(parts))
    return found


def row(before, after, seconds):
    area_moved, changed = 0.0, 0
    for name, was in before.items():
        was, now = shapely.make_valid(was), shapely.make_valid(after.get(name, Polygon()))
        moved_here = was.symmetric_difference(now).area
        area_moved += moved_here
        changed += moved_here > 1e-9 * max(was.area, 1e-6)
    points = shapely.get_num_coordinates(list(after.values())).sum()
    invalid = sum(not geometry.is_valid for geometry in after.values())
    return f"{len(after)} | {changed} | {area_moved:.6g} | {points} | {invalid} | {seconds:.2f} s"


def main():
    twinedge, mapshaper, atlas, folder = sys.argv[1:]
    folder = pathlib.Path(folder)
    planted, states = folder / "planted.geojson", folder / "us.geojson"
    planted.write_text(json.dumps(counties()))
    timed(twinedge, "convert", atlas, "--layer", "counties", "-o", states)
    print("| layer | program | features left | changed | area moved | points | invalid | processor time |")
    print("| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    for name, file, width in (("240 counties with 8 faults", planted, 150), ("counties of the United States", states, None)):
        before = geometries(file)
        points = shapely.get_num_coordinates(list(before.values())).sum()
        print(f"| {name} | before | {len(before)} | | | {points} | {sum(not g.is_valid for g in before.values())} | |")
        options = [] if width is None else ["--gap-width", width]
        ours = folder / "ours.geojson"
        seconds = timed(twinedge, "clean", file, "-o", ours, *options)
        print(f"| | `twinedge clean` | {row(before, geometries(ours), seconds)} |")
        options = [] if width is None else [f"gap-width={2 * width}"]
        theirs = folder / "theirs.geojson"
        seconds = timed(mapshaper, file, "-clean", *options, "-o", theirs, "force")
        print(f"| | `mapshaper -clean` | {row(before, geometries(theirs), seconds)} |")


if __name__ == "__main__":
    main()
