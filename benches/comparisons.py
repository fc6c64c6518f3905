"""Inputs of docs/comparisons.md, as GeoJSON on standard output, and GEOS on them where shapely is installed.

    python benches/comparisons.py lake 8000 > lake.geojson          # geos #1503
    python benches/comparisons.py border > border.geojson           # geos #1525
    python benches/comparisons.py cells 81000 > cells.geojson       # QGIS #45498
    python benches/comparisons.py --geos lake 8000                  # the answer of GEOS, and its time
"""

import json
import random
import sys
import time


def square(x, y, size):
    return [[x, y], [x + size, y], [x + size, y + size], [x, y + size], [x, y]]


def lake(count):
    """A polygon with so many holes, and a polygon in each."""
    width = int(count**0.5) + 1
    islands = [square(2 * (i % width) + 1, 2 * (i // width) + 1, 1) for i in range(count)]
    outer = square(0, 0, 2 * width + 3)
    return [[outer, *(ring[::-1] for ring in islands)], *([ring] for ring in islands)]


def border():
    """Two polygons side by side, of which one has a vertex on their border that the other has not."""
    return [[[[1, 0], [1, 1], [1, 3], [4, 0], [1, 0]]], [[[0, 4], [1, 3], [1, 0], [0, 4]]]]


def cells(count):
    """A grid of so many quadrilaterals, with its corners moved at random: a coverage."""
    width = int(count**0.5)
    noise = random.Random(1)
    corners = [
        [[x + noise.uniform(-0.3, 0.3), y + noise.uniform(-0.3, 0.3)] for x in range(width + 1)]
        for y in range(-(-count // width) + 1)
    ]
    places = (divmod(i, width) for i in range(count))
    rings = ([corners[y][x], corners[y][x + 1], corners[y + 1][x + 1], corners[y + 1][x]] for y, x in places)
    return [[[*ring, ring[0]]] for ring in rings]


def geojson(polygons):
    geometries = ({"type": "Polygon", "coordinates": polygon} for polygon in polygons)
    features = [{"type": "Feature", "id": i, "properties": {}, "geometry": g} for i, g in enumerate(geometries)]
    return {"type": "FeatureCollection", "features": features}


def geos(polygons):
    import shapely

    shapes = [shapely.Polygon(outer, holes) for outer, *holes in polygons]
    begin = time.process_time()
    valid = shapely.coverage_is_valid(shapes)
    print(f"GEOS {shapely.geos_version_string}: valid: {valid}, {time.process_time() - begin:.2f} s of processor time")
    if len(shapes) == 2:
        cleaned = shapely.coverage_clean(shapes, snapping_distance=0)
        print("cleaned:", ", ".join(f"{shape.wkt} (area {shape.area})" for shape in cleaned))


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--geos"]
    makers = {"lake": lake, "border": border, "cells": cells}
    if not words or words[0] not in makers:
        sys.exit(__doc__)
    polygons = makers[words[0]](*map(int, words[1:]))
    if "--geos" in sys.argv:
        geos(polygons)
    else:
        json.dump(geojson(polygons), sys.stdout)
