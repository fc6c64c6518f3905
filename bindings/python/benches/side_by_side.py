"""The validator beside the checkers of networkx and GEOS, in one run. Times are the best of several."""

import sys
import time
from pathlib import Path

import geopandas
import networkx as nx
import numpy as np
import shapely

import twinedge
from twinedge import _audit, _twinedge, adapters
from twinedge._validate import _asked

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
from conftest import planar_grid  # noqa: E402

DATA = Path(__file__).parents[3] / "tests" / "data"


def best(function, times=5):
    found = []
    for _ in range(times):
        start = time.process_time()
        function()
        found.append(time.process_time() - start)
    return min(found) * 1000


def row(name, milliseconds, baseline):
    print(f"| {name} | {milliseconds:,.0f} | {milliseconds / baseline:.2f} |")


def main():
    grid = planar_grid(245)
    count = grid.number_of_edges()
    columns = adapters.networkx_columns(grid)
    theirs = best(grid.check_structure, 3)
    print(f"networkx {nx.__version__}, {count:,} half-edges\n\n| | ms | ratio |\n| --- | --- | --- |")
    row("`check_structure`", theirs, theirs)
    row("conversion", best(lambda: adapters.networkx_columns(grid)), theirs)
    judge = lambda: twinedge.validate(**columns.links, vertices=len(columns.vertices), plane=True, simple=True)  # noqa: E731
    assert judge().valid
    row("validation", best(judge), theirs)

    layer = geopandas.read_file(DATA / "world-50m.geojson")
    polygons = layer.geometry.values
    array = np.asarray(polygons)
    theirs = best(lambda: shapely.coverage_is_valid(array))
    print(f"\nGEOS {shapely.geos_version_string}, {len(array)} features, {len(shapely.get_coordinates(array)):,} points\n")
    print("| | ms | ratio |\n| --- | --- | --- |")
    row("`coverage_is_valid`", theirs, theirs)
    row("`is_valid` of each polygon", best(lambda: shapely.is_valid(array)), theirs)
    convert = lambda: _audit._source(layer)  # noqa: E731
    row("conversion to GeoJSON", best(convert), theirs)
    source = convert()
    asked = {"coverage": True, "limits": _audit._limits(), "snap": None, "name": None, "accept": None, "list": 10}
    row("the audit: building the map, all rules, C1 to C7", best(lambda: _twinedge.audit(source, asked, _asked(), None)), theirs)


if __name__ == "__main__":
    main()
