"""Overlays in tiles: the pieces of the whole, each once and whole."""

import pickle

import geopandas
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pytest
import shapely

import twinedge
from twinedge import tiles

GRIDS = [
    tiles.Grid((0, 0, 8, 8), 1, 1),
    tiles.Grid((0, 0, 8, 8), 5, 4),
    tiles.Grid((-3.3, 1.7, 6.1, 4.4), 3, 7),
    tiles.Grid((2, 2, 40, 40), 9, 9),
]


def coverage(seed, columns):
    """Cells with noisy borders that neighbours share. Some are missing, and some make up one feature, which lies all over."""
    random = np.random.default_rng(seed)
    places = np.stack(np.meshgrid(np.arange(columns + 1), np.arange(columns + 1)), -1)
    corners = places + random.uniform(-0.2, 0.2, places.shape)
    bends = random.uniform(-0.04, 0.04, (2, *places.shape))

    def border(y, x, upright):
        start, end = corners[y, x], corners[y + upright, x + 1 - upright]
        return [start, (start + end) / 2 + bends[upright, y, x], end]

    cells = []
    for y, x in np.ndindex(columns, columns):
        sides = [border(y, x, 0), border(y, x + 1, 1), border(y + 1, x, 0)[::-1], border(y, x, 1)[::-1]]
        cells.append(shapely.Polygon([point * 8 / columns for side in sides for point in side[:2]]))
    kinds = random.integers(0, 8, len(cells))
    return [*np.array(cells)[kinds > 2], shapely.union_all(np.array(cells)[kinds == 0])]


def clutter(seed):
    """Triangles that overlap and cross, one of them twice, a road across all of them, a line, a point, and a feature without geometry."""
    random = np.random.default_rng(seed)
    triangles = [shapely.Polygon(at + random.uniform(-1.5, 1.5, (3, 2))) for at in random.uniform(0, 8, (20, 2))]
    road = shapely.LineString([(-1, random.uniform(0, 8)), (9, random.uniform(0, 8))]).buffer(0.1)
    return [*triangles, road, triangles[3], shapely.LineString([(0, 0), (7, 8)]), shapely.Point(1, 1), None]


def plan(layers, grid):
    return tiles.Overlay(grid, [[*tiles.extents(layer, grid)] for layer in layers])


def in_tiles(left, right, grid, how="union"):
    """The pieces of all tiles, by the features that cover them."""
    layers = [tiles.table(layer) for layer in (left, right)]
    worker = pickle.loads(pickle.dumps(plan([layer.to_batches(max_chunksize=9) for layer in layers], grid)))
    assert worker == plan(layers[::-1], grid)
    schema = pa.schema([("tile", pa.int64()), *layers[0].schema])
    rows = [pa.Table.from_batches(worker.assign(layer.to_batches(max_chunksize=9)), schema) for layer in layers]
    found = {}
    for tile in range(len(grid)):
        parts = [of_layer.filter(pc.equal(of_layer["tile"], tile)) for of_layer in rows]
        pieces = worker.pieces(*parts, tile, how)
        # As after a worker was lost, with the rows in another order.
        assert worker.pieces(*[part.take(np.arange(len(part))[::-1]) for part in parts], tile, how) == pieces
        for piece in pieces.to_pylist():
            features = (*piece["left"],), (*piece["right"],)
            assert features not in found, "a piece came twice"
            found[features] = shapely.from_wkb(piece["geometry"])
    return found


def of_whole(left, right, how="union"):
    pieces = twinedge.overlay(*(geopandas.GeoDataFrame(geometry=layer) for layer in (left, right)), how)
    return {(piece.left, piece.right): piece.geometry for piece in pieces.itertuples()}


def assert_same(found, expected):
    """The same features, and the same coordinates to the last bit."""
    assert found.keys() == expected.keys()
    for features, geometry in expected.items():
        one, other = (shapely.MultiPolygon(shapely.get_parts(of).tolist()).normalize() for of in (found[features], geometry))
        assert one == other, features


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("grid", GRIDS)
def test_pieces_are_those_of_the_whole(seed, grid):
    left, right = coverage(seed, 7), coverage(seed + 10, 6)
    expected = of_whole(left, right)
    assert len(expected) > 80
    assert_same(in_tiles(left, right, grid), expected)


@pytest.mark.parametrize("how", ["union", "intersection", "difference", "symmetric_difference", "identity"])
def test_the_pieces_to_keep_are_chosen_as_for_the_whole(how):
    left, right = coverage(5, 4), coverage(6, 3)
    assert_same(in_tiles(left, right, GRIDS[1], how), of_whole(left, right, how))


@pytest.mark.parametrize("seed", range(3))
def test_layers_that_overlap_themselves(seed):
    left, right = clutter(seed), clutter(seed + 10)
    one = in_tiles(left, right, GRIDS[0])
    for grid in GRIDS[1:]:
        found = in_tiles(left, right, grid)
        assert list(map(shapely.to_wkb, map(found.get, one))) == list(map(shapely.to_wkb, one.values())) and len(found) == len(one)
    # The whole cuts each layer first, which rounds once more.
    pieces = twinedge.Map(left, snap="auto").overlay(twinedge.Map(right, snap="auto"), "union")
    areas = {(piece.left, piece.right): shapely.geometry.shape(piece.geometry).area for piece in pieces}
    assert {features: area for features, area in areas.items() if area > 1e-9} == pytest.approx(
        {features: geometry.area for features, geometry in one.items() if geometry.area > 1e-9}
    )
    assert max(len(features) for of_both in areas for features in of_both) > 1


def test_a_layer_without_anything_and_one_feature_over_all_tiles():
    left = coverage(1, 5)
    for grid in GRIDS:
        assert_same(in_tiles(left, [], grid), of_whole(left, []))
        assert_same(in_tiles([], left, grid), of_whole([], left))
        assert in_tiles([], [None, shapely.Point(0, 0)], grid) == {}
        assert_same(in_tiles(left, [shapely.box(-5, -5, 50, 50)], grid), of_whole(left, [shapely.box(-5, -5, 50, 50)]))


def test_tiles_round_as_the_whole_does_however_small_their_coordinates_are():
    far = shapely.box(900_000, 900_000, 1_000_000, 1_000_000)
    left, right = [*coverage(3, 4), far], coverage(4, 4)
    grid = tiles.Grid((0, 0, 8, 8), 3, 3)
    assert_same(in_tiles(left, right, grid), of_whole(left, right))


@pytest.mark.parametrize("unit", [1.0, 2.0**-370])
def test_what_is_nearer_than_a_cell_belongs_to_the_tile(unit):
    # The triangle lies a quarter of a cell from the square, whose side gets a vertex at its corner.
    beside = 2 * unit + max(2.0**-40 * unit, 2.0**-400) / 4
    left = [shapely.box(unit, 0, 2 * unit, 2 * unit), shapely.box(900 * unit, 900 * unit, 1024 * unit, 1024 * unit)]
    right = [shapely.Polygon([(beside, unit), (3 * unit, 0), (3 * unit, 2 * unit)])]
    expected = of_whole(left, right)
    assert len(expected[(0,), ()].geoms[0].exterior.coords) == 6
    assert_same(in_tiles(left, right, tiles.Grid((0, 0, 4 * unit, 4 * unit), 4, 4)), expected)


def test_tables_that_are_wrong_are_refused():
    grid = GRIDS[1]
    left, right = (tiles.table(coverage(seed, 4)) for seed in (1, 2))
    of_left, both = plan([left], grid), plan([left, right], grid)
    with pytest.raises(ValueError, match=r"geometry \d+: .*extents are those of all features of both layers"):
        [*of_left.assign(right)]
    with pytest.raises(ValueError, match="there is no column 'x1'; there are tile"):
        tiles.Overlay(grid, both.extents.drop_columns("x1"))
    with pytest.raises(ValueError, match="how: 'clip' is none of union"):
        both.pieces(left, right, 0, "clip")
    with pytest.raises(ValueError, match="tile: the grid has no tile 20"):
        both.pieces(left, right, 20)
    with pytest.raises(ValueError, match="two features have the number 0"):
        both.pieces(pa.concat_tables([left, left]), right, 0)
    with pytest.raises(ValueError, match="there is no column 'feature'"):
        both.pieces(left, right.drop_columns("feature"), 0)
    with pytest.raises(ValueError, match="geometry 0: "):
        both.pieces(left, pa.table({"feature": [0], "geometry": [b"\x01\x03"]}), 0)
