"""Audits in tiles: the same result as that of the whole, on each engine."""

import json
import multiprocessing
import pickle
import random

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import shapely
from layers import FAULTS, parcels, told

import twinedge
from twinedge import _columns, tiles

LAYER = parcels()
#: Lines of it run through faults, along borders and next to them.
GRID = tiles.Grid((0, 0, 12, 8), 3, 2)
LIMITS = {"gap_width": 0.6, "lake_width": 2.0, "sliver_area": 0.01}


def divided(features, grid):
    """The pieces of each tile."""
    return tiles.divided(features, grid, tiles.Cuts(tiles.bounds(features)))


def divide(features, grid):
    """The pieces of all tiles."""
    return pa.Table.from_batches(tiles.divide(features, grid, tiles.Cuts(tiles.bounds(features))))


@pytest.fixture(scope="module")
def whole():
    report = twinedge.audit(LAYER, coverage=True, **LIMITS)
    found = sorted((finding.rule, finding.features) for finding in report.findings)
    assert report.verdict == "invalid" and found == sorted(FAULTS)
    return report


@pytest.fixture(scope="module")
def features():
    return tiles.table(LAYER)


def summary(given):
    part, tile = given
    return tiles.audit_tile(part, GRID, tile, **LIMITS)


def test_plain_loops_say_what_the_audit_of_the_whole_says(whole, features):
    parts = [summary((part, tile)) for tile, part in divided(features, GRID).items()]
    assert len(parts) == len(GRID) == 6
    report = tiles.finish(parts, coverage=True)
    assert told(report) == told(whole) and report.first.rule == whole.first.rule
    # In any order, and merged in any way, down to the bytes.
    merged = tiles.merge(parts)
    for seed in range(5):
        shuffled = random.Random(seed).sample(parts, len(parts))
        one, other = tiles.merge(shuffled[:3]), tiles.merge(*shuffled[3:])
        assert tiles.merge(other, one) == merged
    assert told(tiles.finish(merged, coverage=True)) == told(whole)


def test_the_report_is_that_of_the_audit_with_the_same_labels(features):
    labels = [f"parcel {number}" for number in range(len(LAYER))]
    layer = {"type": "FeatureCollection", "features": [
        {"type": "Feature", "id": label, "properties": {}, "geometry": shapely.geometry.mapping(shape)} for label, shape in zip(labels, LAYER)
    ]}
    parts = [summary(given[::-1]) for given in divided(features, GRID).items()]
    audit = twinedge.audit(layer, coverage=True, explain=True, **LIMITS)
    report = tiles.finish(parts, labels=np.array(labels), coverage=True, explain=True, **LIMITS)
    # What is known of the input only, the size of the grid, and the time.
    found, whole = ({name: value for name, value in one.to_dict().items() if name not in ("input", "judged", "import", "tiles", "elapsed_ms")} for one in (report, audit))
    assert found == whole and twinedge.diff(audit, report) == ([], [], [], len(FAULTS)) and report.to_dict()["elapsed_ms"] > 0
    assert [finding.labels for finding in report.findings] == [finding.labels for finding in audit.findings]
    # Lists of accepted findings serve both.
    for one, other in [(audit, report), (report, audit)]:
        accept = one.accept_all("as surveyed", "2026-11-29")
        assert twinedge.audit(layer, coverage=True, accept=accept, **LIMITS).valid and tiles.finish(parts, labels=labels, coverage=True, accept=accept).valid
        assert other.accept_all("as surveyed", "2026-11-29") == accept
    assert tiles.finish(parts, coverage=True, accept=accept).verdict == "invalid"
    with pytest.raises(ValueError, match="the tiles were made of another layer: theirs has a feature 26, and this one has 5 features"):
        tiles.finish(parts, labels=labels[:5])


@pytest.mark.parametrize(
    "grid",
    [tiles.Grid((0, 0, 12, 8), 1, 1), tiles.Grid((0, 0, 12, 8), 12, 8), tiles.Grid((-3, -1, 25.5, 31), 7, 5), tiles.Grid((2.5, 1.5, 9.1, 6.3), 4, 4)],
)
def test_every_grid_says_the_same(whole, features, grid):
    parts = [tiles.audit_tile(part, grid, tile, **LIMITS) for tile, part in divided(features, grid).items()]
    assert told(tiles.finish(parts, coverage=True)) == told(whole)


def test_a_world_without_limits_is_the_same(features):
    report = twinedge.audit(LAYER)
    parts = [tiles.audit_tile(part, GRID, tile) for tile, part in divided(features, GRID).items()]
    assert told(tiles.finish(parts)) == told(report)


def test_a_table_of_findings_has_a_row_for_each_with_its_place(features):
    parts = [summary(given[::-1]) for given in divided(features, GRID).items()]
    found = tiles.finish(parts, coverage=True).to_arrow().to_pylist()
    assert sorted((row["rule"], tuple(row["features"])) for row in found) == sorted(FAULTS)
    gap = next(row for row in found if row["rule"] == "C2")
    assert shapely.Point(6, 4).distance(shapely.Point(gap["x"], gap["y"])) < 0.5 and gap["area"] == 0.5 and gap["id"].startswith("C2-")


def test_findings_are_a_layer_of_their_places(whole, features):
    pytest.importorskip("geopandas", reason="geopandas is not installed")
    parts = [summary(given[::-1]) for given in divided(features, GRID).items()]
    frame = tiles.finish(parts, coverage=True, crs="EPSG:2056").to_geodataframe()
    places = sorted(zip(frame["rule"], zip(frame["x"], frame["y"])))
    assert {*frame.geom_type} <= {"Point", "MultiPoint"} and frame.crs == "EPSG:2056" and places == sorted((finding.rule, finding.at) for finding in whole.findings)


def test_processes_and_a_tile_that_is_made_again(whole, features):
    given = [(part, tile) for tile, part in divided(features, GRID).items()]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        parts = pool.map(summary, given)
    assert told(tiles.finish(parts, coverage=True)) == told(whole)
    # As after a worker was lost: in another order, in batches, and with pieces of other tiles.
    for part, tile in given:
        again = part.take(np.arange(len(part))[::-1]).to_batches(max_chunksize=2)
        assert summary((again, tile)) == summary((divide(features, GRID), tile)) == parts[tile]


def test_duckdb_without_its_spatial_extension(whole, features, tmp_path):
    duckdb = pytest.importorskip("duckdb", reason="duckdb is not installed")
    pq.write_table(features, tmp_path / "parcels.parquet", row_group_size=5)
    db = duckdb.connect()
    read = db.sql(f"SELECT feature, geometry FROM read_parquet('{tmp_path}/parcels.parquet')").to_arrow_reader(8)
    db.register("pieces", pa.Table.from_batches(tiles.divide(read, GRID, tiles.Cuts(tiles.bounds(features)))))
    parts = []
    for (tile,) in db.execute("SELECT DISTINCT tile FROM pieces").fetchall():
        part = db.sql("SELECT piece FROM pieces WHERE tile = ?", params=[tile]).to_arrow_reader(4)
        parts.append(tiles.audit_tile(part, GRID, tile, **LIMITS))
    report = tiles.finish(parts, grid=GRID, coverage=True, **LIMITS)
    assert told(report) == told(whole)
    # The findings meet the features again by their numbers.
    findings = report.to_arrow()  # noqa: F841
    rows = db.execute(
        "SELECT rule, count(*) FROM (SELECT rule, unnest(features) AS feature FROM findings) JOIN features USING (feature) GROUP BY rule"
    ).fetchall()
    assert {rule for rule, _ in rows} == {rule for rule, _ in FAULTS}


def test_dask(whole, features):
    bag = pytest.importorskip("dask.bag", reason="dask is not installed")
    batches = bag.from_sequence(features.to_batches(max_chunksize=5), npartitions=3)
    cuts = tiles.Cuts(tiles.bounds(features))
    pieces = batches.map(lambda batch: pa.Table.from_batches(tiles.divide(batch, GRID, cuts)))
    rows = pieces.map(lambda table: table.to_pylist()).flatten().groupby(lambda row: row["tile"])
    parts = rows.starmap(lambda tile, rows: tiles.audit_tile(pa.Table.from_pylist(rows), GRID, tile, **LIMITS))
    one = parts.fold(tiles.merge, initial=tiles.merge()).compute(scheduler="threads")
    assert told(tiles.finish(one, grid=GRID, coverage=True, **LIMITS)) == told(whole)


def test_tiles_without_pieces_are_made_at_the_end(whole, features):
    grid = tiles.Grid((0, 0, 48, 48), 8, 8)
    parts = [*tiles.audit_tiles(divide(features, grid), grid, **LIMITS)]
    assert len(parts) == 10
    with pytest.raises(ValueError, match=r"54 tiles are missing: 3, "):
        tiles.finish(parts)
    assert told(tiles.finish(parts, grid=grid, coverage=True, **LIMITS)) == told(whole)


def test_what_is_missing_or_twice_is_named(features):
    parts = [summary(given[::-1]) for given in divided(features, GRID).items()]
    with pytest.raises(ValueError, match=r"1 tile is missing: 4"):
        tiles.finish(parts[:4], parts[5:])
    with pytest.raises(ValueError, match="both summaries have tile 0"):
        tiles.merge(parts, parts[0])
    with pytest.raises(ValueError, match="the grid is 3x2 between .* for the first and 2x2 between .* for the second"):
        tiles.merge(parts[0], tiles.audit_tile([], tiles.Grid((0, 0, 1, 1), 2, 2), 1, **LIMITS))
    with pytest.raises(ValueError, match="gap_width is 0.6 for the first and none for the second"):
        tiles.merge(parts[0], tiles.audit_tile([], GRID, 1))
    with pytest.raises(ValueError, match="there is no summary"):
        tiles.finish()
    with pytest.raises(ValueError, match="summary 0: "):
        tiles.merge(pa.table({"summary": [b"{}"]}))
    assert tiles.merge().num_rows == 0


def test_a_feature_that_a_tile_was_not_given_is_found(features):
    without = features.filter(pa.array([number != 9 for number in range(len(features))]))
    parts = [tiles.audit_tile(divide(without if tile == 1 else features, GRID), GRID, tile, **LIMITS) for tile in range(6)]
    report = tiles.finish(parts)
    assert report.verdict == "invalid" and {rule for rule in report.broken_rules if rule[0] == "S"}


def test_edges_that_cross_are_named_and_the_rest_is_not_called_checked():
    layer = [shapely.box(0, 0, 2, 2), shapely.box(1, 1, 3, 3), shapely.box(5, 0, 6, 1)]
    grid = tiles.Grid((0, 0, 6, 3), 3, 2)
    parts = [tiles.audit_tile(part, grid, tile) for tile, part in divided(tiles.table(layer), grid).items()]
    report = tiles.finish(parts, coverage=True)
    assert report.verdict == "invalid" and report.first.rule == "G4"
    assert {v.kind for v in report.violations if v.rule == "G4"} == {"cross"} and "not_checked" in report.to_dict()["coverage"]
    # Each crossing once, as in the whole.
    whole = twinedge.audit(layer, coverage=True)
    assert [sum(v.rule == "G4" for v in one.violations) for one in (report, whole)] == [2, 2]


#: Layers whose edges meet elsewhere than at vertices, on the seams x = 2 and y = 2 and across them, and rules that are broken there.
MEETING = {
    "an overlap across a seam": ([shapely.box(0.25, 0.25, 2.5, 1.25), shapely.box(1.5, 0.5, 3.75, 1.75)], {"C1"}),
    "an overlap on the corner of four tiles": ([shapely.box(0, 0, 2.5, 2.5), shapely.box(1.5, 1.5, 4, 4)], {"C1"}),
    "a vertex on a seam": ([shapely.box(0, 0, 2, 4), shapely.box(2, 0, 4, 1.5), shapely.box(2, 1.5, 4, 4)], {"C7"}),
    "a vertex in an edge across a seam": ([shapely.box(0, 0, 4, 1), shapely.box(0, 1, 2.5, 3), shapely.box(2.5, 1, 4, 3)], {"C7"}),
    "triangles that cross where no double is": (
        [shapely.Polygon([(0, 0), (4, 0.1), (1, 3.7)]), shapely.Polygon([(3.9, 0), (0.1, 1.3), (3.3, 4)]), shapely.box(1.9, 1.7, 2.3, 2.1)],
        {"C1"},
    ),
}
QUARTERS = tiles.Grid((0, 0, 4, 4), 2, 2)


def rounds(features, grid):
    """All cuts, and the rows of the tiles. Each search is repeated by another worker, with rows in another order, and one is taken twice."""
    cuts = tiles.Cuts(tiles.bounds(features))
    parts = tiles.divided(features, grid, cuts)
    while wanted := cuts.tiles(grid):
        found = [cuts.search(parts[tile], grid, tile) for tile in wanted]
        worker = pickle.loads(pickle.dumps(cuts))
        assert worker == cuts
        assert [worker.search(parts[tile].take(np.arange(len(parts[tile]))[::-1]), grid, tile) for tile in wanted] == found
        assert [*worker.search_tiles(tiles.divide(features.to_batches(max_chunksize=1), grid, worker), grid)] == [
            one for one, tile in zip(found, wanted, strict=True) if len(parts[tile])
        ]
        cuts = cuts.take(found)
        assert worker.take(*found[::-1], found[0]) == cuts
    return cuts, parts


@pytest.mark.parametrize("grid", [QUARTERS, tiles.Grid((0, 0, 4, 4), 7, 5), tiles.Grid((-4, -4, 12, 12), 8, 8)])
@pytest.mark.parametrize("name", MEETING)
def test_edges_that_meet_elsewhere_than_at_vertices_are_cut_alike_in_all_tiles(name, grid):
    layer, rules = MEETING[name]
    whole, features = twinedge.audit(layer, coverage=True), tiles.table(layer)
    assert whole.verdict == "invalid" and {finding.rule for finding in whole.findings} >= rules
    cuts, parts = rounds(features, grid)
    summaries = [tiles.audit_tile(part, grid, tile, cuts=cuts) for tile, part in parts.items()]
    assert all(one.schema == tiles.schema() and one["summary"].null_count == 0 for one in summaries)
    merged = tiles.merge(summaries[3:], tiles.merge(*summaries[:3]))
    some = [*tiles.audit_tiles(tiles.divide(features, grid, cuts), grid, cuts=cuts)]
    for report in (tiles.finish(merged, coverage=True), tiles.finish(some, grid=grid, coverage=True)):
        assert told(report) == told(whole) and "not_checked" not in report.to_dict()["coverage"]
        assert sorted(finding.id for finding in report.findings) == sorted(finding.id for finding in whole.findings)
        assert [violation.rule for violation in report.violations] == [violation.rule for violation in whole.violations]


def test_processes_search_for_cuts():
    layer = MEETING["an overlap on the corner of four tiles"][0]
    cuts, features = tiles.Cuts((0, 0, 4, 4)), tiles.table(layer)
    pieces = tiles.divided(features, QUARTERS, cuts)
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        while wanted := cuts.tiles(QUARTERS):
            cuts = cuts.take(pool.starmap(cuts.search, [(pieces[tile], QUARTERS, tile) for tile in wanted]))
    assert cuts == rounds(features, QUARTERS)[0]


def test_cuts_that_are_wrong_are_refused(features):
    layer = tiles.table(MEETING["an overlap on the corner of four tiles"][0])
    cuts, pieces = tiles.Cuts(tiles.bounds(layer)), divide(layer, QUARTERS)
    # Boundaries cross at (2.5, 1.5) and (1.5, 2.5).
    found = cuts.search(pieces, QUARTERS, 1)
    with pytest.raises(ValueError, match="cuts: not all of them are found yet"):
        tiles.audit_tile(pieces, QUARTERS, 0, cuts=cuts)
    with pytest.raises(ValueError, match="there is nothing that a tile found"):
        cuts.take()
    after = cuts.take(found)
    for other in (after, tiles.Cuts((0, 0, 5, 5))):
        with pytest.raises(ValueError, match="found in another round, or are those of another map"):
            other.take(found)
    with pytest.raises(ValueError, match=r"\(5, 0\) lies farther out than the box of the cuts"):
        [*tiles.divide(features, QUARTERS, cuts)]
    with pytest.raises(ValueError, match="tile"):
        cuts.search(pieces, QUARTERS, 4)
    # Damaged on the way, anywhere.
    (whole,) = found["found"].to_pylist()
    for damaged in (b"", b"{}", whole[:-1], *changed(whole)):
        with pytest.raises(ValueError, match="found 0: "):
            cuts.take(pa.table({"found": [damaged]}))
    for damaged in (b"{}", after.state[:-1], *changed(after.state, 7)):
        wrong = tiles.Cuts(after.box, damaged)
        for use in (
            lambda cuts: cuts.tiles(QUARTERS),
            lambda cuts: cuts.search(pieces, QUARTERS, 0),
            lambda cuts: cuts.take(found),
            lambda cuts: tiles.audit_tile(pieces, QUARTERS, 0, cuts=cuts),
            lambda cuts: [*tiles.divide(layer, QUARTERS, cuts)],
        ):
            with pytest.raises(ValueError, match="cuts: "):
                use(wrong)
    for box in [(0, 0, 1), (0, 0, 1, float("nan")), (0, 0, 1, float("inf"))]:
        with pytest.raises(ValueError, match=r"box|reach|range"):
            tiles.Cuts(box)
    complete, _ = rounds(layer, QUARTERS)
    parts = [tiles.audit_tile(pieces, QUARTERS, tile, cuts=None if tile in (1, 2) else complete) for tile in range(4)]
    for add in (tiles.merge, tiles.finish):
        with pytest.raises(ValueError, match=r"tiles 1 and 2 were made without cuts, and others with cuts"):
            add(parts)


def changed(of, step=1):
    """Bytes with one bit changed, at some places."""
    for place in range(0, len(of), step):
        yield of[:place] + bytes([of[place] ^ 1 << place % 8]) + of[place + 1 :]


def test_damaged_pieces_and_pieces_that_come_twice_are_refused(features):
    pieces = divide(features, GRID)
    (whole,) = pieces["piece"][:1].to_pylist()
    for damaged in (b"", whole[:-1], *changed(whole)):
        with pytest.raises(ValueError, match="piece 0: "):
            tiles.audit_tile(pa.table({"piece": [damaged]}), GRID, 0)
    with pytest.raises(ValueError, match="two features have the number 0, or one was given twice"):
        tiles.audit_tile([pieces, pieces], GRID, 0)


def test_a_tile_that_is_left_out_of_a_round_of_cuts_is_named():
    layer = tiles.table(MEETING["an overlap on the corner of four tiles"][0])
    cuts, pieces = tiles.Cuts(tiles.bounds(layer)), divide(layer, QUARTERS)
    # Boundaries cross at (2.5, 1.5), in tile 1, and at (1.5, 2.5), in tile 2.
    while wanted := cuts.tiles(QUARTERS):
        cuts = cuts.take(*[cuts.search(pieces, QUARTERS, tile) for tile in wanted if tile != 2])
    parts = [tiles.audit_tile(pieces, QUARTERS, tile, cuts=cuts) for tile in range(4)]
    report = tiles.finish(parts, coverage=True)
    why = report.to_dict()["coverage"]["not_checked"]
    assert report.verdict == "invalid" and why.startswith("borders cross, and tile 2: edges still meet elsewhere than at vertices there")


@pytest.mark.parametrize("most", [64, 640])
def test_a_grid_that_fits_the_layer_says_the_same(most):
    # A town between fields, with some lots that overlap.
    fields = [shapely.box(x, y, x + 64, y + 64) for x in range(0, 512, 64) for y in range(0, 512, 64) if (x, y) != (192, 320)]
    lots = [shapely.box(192 + x, 320 + y, 192 + x + (1.5 if (x, y) in ((7, 9), (40, 41)) else 1), 321 + y) for x in range(64) for y in range(64)]
    features = tiles.table([*fields, *lots])
    grid = tiles.Grid.fitted(features.to_batches(max_chunksize=100), most)
    assert grid == tiles.Grid.fitted(features, most) == pickle.loads(pickle.dumps(grid)) and len(grid) > 4
    # Most tiles lie in the town.
    in_town = [box for box in grid.boxes() if box[0] >= 192 and box[2] <= 256 and box[1] >= 320 and box[3] <= 384]
    assert len(in_town) > len(grid) / 4
    cuts, parts = rounds(features, grid)
    pieces = [len(part) for part in parts.values()]
    summaries = [tiles.audit_tile(part, grid, tile, cuts=cuts) for tile, part in parts.items()]
    whole = twinedge.audit([*fields, *lots], coverage=True)
    assert told(tiles.finish(summaries, coverage=True)) == told(whole) and whole.verdict == "invalid"
    assert max(pieces) < 8 * max(1, sum(pieces) / len(pieces))


def test_more_cuts_than_can_be_judged_are_said_to_be():
    lines = [line for at in range(1, 801) for line in (shapely.LineString([(at, 0), (at, 801)]), shapely.LineString([(0, at), (801, at)]))]
    cuts, grid = tiles.Cuts((0, 0, 801, 801)), tiles.Grid((0, 0, 801, 801), 1, 1)
    with pytest.raises(ValueError, match="the coverage cannot be judged in tiles"):
        cuts.search(pa.Table.from_batches(tiles.divide(tiles.table(lines), grid, cuts)), grid, 0)


def test_tiles_of_two_states_of_a_layer_are_not_put_together(features):
    # Two squares alike on the left, or on the right: tile 0 of one layer and tile 1 of the other would add up to a valid one.
    grid, left, right = tiles.Grid((0, 0, 2, 1), 2, 1), *(tiles.table([shapely.box(x, 0, x + 1, 1) for x in at]) for at in ((0, 0, 1), (0, 1, 1)))
    layers = (shapely.from_wkb(layer["geometry"].to_pylist()) for layer in (left, right))
    assert {twinedge.audit(layer, coverage=True).verdict for layer in layers} == {"invalid"}
    left, right = (divide(layer, grid) for layer in (left, right))
    parts = tiles.audit_tile(left, grid, 1, source="snapshot 7"), tiles.audit_tile(right, grid, 0, source="snapshot 8")
    for add in (tiles.merge, tiles.finish):
        with pytest.raises(ValueError, match="source is snapshot 7 for the first and snapshot 8 for the second"):
            add(*parts)
    # Made again of the same state, a tile has the same bytes.
    assert tiles.audit_tile(left, grid, 1, source="snapshot 7") == parts[0]
    seven, eight = (tiles.Cuts((0, 0, 2, 1), source=f"snapshot {number}") for number in (7, 8))
    with pytest.raises(ValueError, match="those of another map"):
        seven.take(seven.search(left, grid, 0), eight.search(right, grid, 1))
    with pytest.raises(ValueError, match="the cuts are those of 'snapshot 7', not of 'snapshot 8'"):
        tiles.audit_tile(left, grid, 0, cuts=seven, source="snapshot 8")


def test_a_damaged_summary_is_noticed_wherever_it_is_changed():
    grid = tiles.Grid((0, 0, 2, 1), 2, 1)
    (whole,) = tiles.audit_tile(divide(tiles.table([shapely.box(0, 0, 1.5, 1)]), grid), grid, 0)["summary"].to_pylist()
    for damaged in changed(whole):
        with pytest.raises(ValueError, match="summary 0: "):
            tiles.merge(pa.table({"summary": [damaged]}))


def test_edges_that_meet_within_one_cell_are_judged_as_in_the_whole():
    ulp = 2.0**-52
    layer = [shapely.box(0, 0, 1, 1), shapely.box(1, ulp, 2, 1 + ulp)]
    whole, grid = twinedge.audit(layer, coverage=True), tiles.Grid((0, 0, 2, 1), 2, 1)
    cuts, parts = rounds(tiles.table(layer), grid)
    report = tiles.finish([tiles.audit_tile(part, grid, tile, cuts=cuts) for tile, part in parts.items()], coverage=True)
    assert told(report) == told(whole) and [finding.rule for finding in report.findings] == ["C7"]


def ragged(geometries, width=2):
    """Geometries of one type as GeoArrow: apart, and interleaved with so many numbers."""
    kind, coordinates, offsets = shapely.to_ragged_array(geometries, include_z=False)
    name = f"geoarrow.{kind.name.lower()}"
    filled = np.zeros((len(coordinates), width))
    filled[:, :2] = coordinates
    apart = pa.StructArray.from_arrays([pa.array(column) for column in coordinates.T.copy()], ["x", "y"])
    interleaved = pa.FixedSizeListArray.from_arrays(pa.array(filled.ravel()), width)
    columns = []
    for inner, list_array in ((apart, pa.ListArray), (interleaved, pa.LargeListArray)):
        for level in offsets:
            whole = pa.int32() if list_array is pa.ListArray else pa.int64()
            inner = list_array.from_arrays(pa.array(level, whole), inner)
        columns.append(inner)
    return name, columns


def with_column(name, column, numbers=None):
    field = pa.field("geometry", column.type, metadata={"ARROW:extension:name": name, "ARROW:extension:metadata": '{"crs": "EPSG:2056"}'})
    numbers = pa.array(range(len(column)) if numbers is None else numbers, pa.uint32())
    return pa.table([numbers, column], schema=pa.schema([pa.field("feature", pa.uint32()), field], {"of": "parcels"}))


def test_geoarrow_is_read_where_it_is_and_says_the_same(whole, features):
    multi = [shapely.MultiPolygon([polygon]) for polygon in LAYER]
    for layer in (LAYER, multi):
        name, columns = ragged(layer, 3)
        for column in columns:
            table = with_column(name, column)
            assert tiles.bounds(table) == tiles.bounds(features)
            # Batches are slices, whose offsets do not begin at 0.
            batches = table.to_batches(max_chunksize=5)
            parts = [*tiles.audit_tiles(tiles.divide(batches, GRID, tiles.Cuts(tiles.bounds(features))), GRID, **LIMITS)]
            assert parts == [*tiles.audit_tiles(divide(features, GRID), GRID, **LIMITS)]
            assert told(tiles.finish(parts, grid=GRID, coverage=True, **LIMITS)) == told(whole)


def test_all_types_of_geoarrow_are_divided_as_well_known_binary_is():
    lines = [shapely.LineString([(x, 0), (x + 1.5, 2)]) for x in range(6)]
    for layer in (
        [shapely.Point(x, x % 2) for x in range(6)],
        [shapely.MultiPoint([(x, 0), (x + 1, 1)]) for x in range(6)],
        lines,
        [shapely.MultiLineString([line, [(9, 9), (9, 8)]]) for line in lines],
    ):
        expected = divide(tiles.table(layer), GRID)
        name, columns = ragged(layer)
        for column in columns:
            assert divide(with_column(name, column), GRID) == expected, name


def test_missing_geometries_and_wrong_ones_of_geoarrow():
    name, (apart, interleaved) = ragged([shapely.box(0, 0, 1, 1), shapely.box(5, 5, 6, 6)])
    for column in (apart, interleaved):
        holed = column.take(pa.array([0, None, 1]))
        holes, rest = with_column(name, holed), with_column(name, holed.take(pa.array([0, 2])), [0, 2])
        missing = pa.table({"feature": pa.array([1], pa.uint32()), "geometry": pa.array([None], pa.binary())})
        cuts = tiles.Cuts(tiles.bounds(holes))
        expected = [*tiles.divide(rest, GRID, cuts), *tiles.divide(missing, GRID, cuts)]
        assert sorted(divide(holes, GRID)["piece"].to_pylist()) == sorted(pa.Table.from_batches(expected)["piece"].to_pylist())
    points = pa.array([{"x": 1.0, "y": 1.0}, None, {"x": float("nan"), "y": float("nan")}], pa.struct([("x", pa.float64()), ("y", pa.float64())]))
    # A point, a missing one and an empty one.
    assert len(divide(with_column("geoarrow.point", points), GRID)) == 3
    flat = pa.ListArray.from_arrays(pa.array([0, 1], pa.int32()), points.slice(2))
    backwards = pa.ListArray.from_arrays(pa.array([0, 2, 1, 2], pa.int32()), points.slice(0, 1).take(pa.array([0, 0])))
    for column, kind, error, text in [
        (apart, "point", TypeError, "geometry: expected the coordinates of geoarrow.point, not list"),
        (points, "polygon", TypeError, "geometry: expected the lists of geoarrow.polygon, not struct"),
        (apart, "geometry", TypeError, "geometry: expected binary values, such as well-known binary, not list"),
    ]:
        with pytest.raises(error, match=text):
            tiles.bounds(with_column(f"geoarrow.{kind}", column))
    for column, lost in [(flat, 0), (backwards, 1)]:
        report = tiles.finish([*tiles.audit_tiles(tiles.divide(with_column("geoarrow.linestring", column), GRID, tiles.Cuts((0, 0, 12, 8))), GRID)], grid=GRID, coverage=True)
        of_feature = {finding.features: finding.message for finding in report.findings if finding.rule == "C6"}
        assert "its offsets are out of order, or a coordinate is not finite" in of_feature[(lost,)], of_feature


def test_a_table_says_that_it_is_geoarrow_and_names_the_reference_system():
    geopandas = pytest.importorskip("geopandas", reason="geopandas is not installed")
    frame = geopandas.GeoDataFrame(geometry=LAYER, crs="EPSG:2056")
    metadata = tiles.table(frame).schema.field("geometry").metadata
    assert metadata[b"ARROW:extension:name"] == b"geoarrow.wkb"
    assert json.loads(metadata[b"ARROW:extension:metadata"])["crs"]["id"] == {"authority": "EPSG", "code": 2056}
    # In the form that geopandas makes.
    for encoding in ("WKB", "geoarrow"):
        table = pa.table(frame.to_arrow(geometry_encoding=encoding, index=False)).append_column("feature", pa.array(range(len(LAYER)), pa.uint32()))
        assert divide(table, GRID) == divide(tiles.table(frame), GRID)


def test_tables_that_are_wrong_are_refused(features):
    for table, error, text in [
        (features.drop_columns("geometry"), ValueError, "there is no column 'geometry'; there are feature"),
        (features.drop_columns("feature"), ValueError, "there is no column 'feature'"),
        (features.set_column(0, "feature", pa.array([str(n) for n in range(27)])), TypeError, "feature: expected integers"),
        (features.set_column(0, "feature", pa.array([*range(26), None], pa.int64())), ValueError, "a feature has no number"),
        (features.set_column(0, "feature", pa.array([*range(26), 2**32])), ValueError, "not up to 4294967296"),
        (features.set_column(1, "geometry", pa.array(["POINT(0 0)"] * 27)), TypeError, "expected binary values, such as well-known binary, not string"),
        (7, TypeError, "expected a table"),
    ]:
        with pytest.raises(error, match=text):
            [*tiles.divide(table, GRID, tiles.Cuts((0, 0, 12, 8)))]
    alike = features.set_column(0, "feature", pa.array([0, *range(26)]))
    with pytest.raises(ValueError, match="two features have the number 0"):
        tiles.audit_tile(divide(alike, GRID), GRID, 0)
    for tile, error in [(6, ValueError), (-1, ValueError), (0.5, TypeError)]:
        with pytest.raises(error, match="tile"):
            tiles.audit_tile([], GRID, tile)
    with pytest.raises(ValueError, match="lines of the grid are not distinct"):
        tiles.Grid((0, 0, 0, 1), 3, 2)
    with pytest.raises(ValueError, match="a grid has 1 to 1,048,576 tiles"):
        tiles.Grid((0, 0, 1, 1), 2, 2**20)


def test_pieces_that_do_not_fit_into_one_batch_are_several(features, monkeypatch):
    cuts = tiles.Cuts(tiles.bounds(features))
    (whole,) = tiles.divide(features, GRID, cuts)
    # As if offsets reached no farther than some pieces, or than no piece.
    for most in (2000, 1):
        monkeypatch.setattr(_columns, "_MOST", most)
        parts = [*tiles.divide(features, GRID, cuts)]
        assert pa.Table.from_batches(parts) == pa.Table.from_batches([whole]) and all(part.schema == whole.schema for part in parts)
        assert len(parts) > 4 and max(map(len, parts)) > 1 if most > 1 else len(parts) == len(whole)
        assert all(sum(map(len, part["piece"].to_pylist())) <= most or len(part) == 1 for part in parts)
    monkeypatch.undo()
    (empty,) = tiles.divide(pa.RecordBatch.from_pylist([], features.schema), GRID, cuts)
    assert empty.column_names == ["tile", "piece"] and len(empty) == 0


def test_edges_that_are_not_straight_are_refused(features):
    column = features.schema.field("geometry")
    said = {"ARROW:extension:name": "geoarrow.wkb", "ARROW:extension:metadata": '{"edges": "spherical"}'}
    in_field = pa.table(features.columns, schema=pa.schema([features.schema.field(0), column.with_metadata(said)]))
    geo = {"primary_column": "geometry", "columns": {"geometry": {"encoding": "WKB", "edges": "spherical"}}}
    in_file = features.replace_schema_metadata({"geo": json.dumps(geo)})
    for table in (in_field, in_file):
        for use in (tiles.bounds, lambda table: [*tiles.divide(table, GRID, tiles.Cuts((0, 0, 12, 8)))], lambda table: tiles.Grid.fitted(table, 9)):
            with pytest.raises(ValueError, match="geometry: the metadata say that edges are spherical; tiles take edges as straight"):
                use(table)
    planar = features.replace_schema_metadata({"geo": json.dumps(geo).replace("spherical", "planar")})
    assert tiles.bounds(planar) == tiles.bounds(features)


def test_boxes_and_missing_geometries():
    table = tiles.table([None, shapely.Point(3, 1), shapely.Polygon(), shapely.box(-1, 2, 0, 5)])
    assert tiles.bounds(table) == (-1, 1, 3, 5)
    rows = divide(table, tiles.Grid((-1, 1, 3, 5), 2, 2))
    # Features without points are with the first tile.
    assert rows.column_names == ["tile", "piece"] and rows["tile"].to_pylist() == [0, 1, 0, 0, 2]
    with pytest.raises(ValueError, match="there are no points"):
        tiles.bounds(tiles.table([None]))
