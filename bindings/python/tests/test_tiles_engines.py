"""One call on each engine: the report of the whole, and the user's own ids."""

import numpy as np
import pyarrow as pa
import pytest
import shapely
from layers import FAULTS, parcels, told

import twinedge
from twinedge import tiles

LAYER = parcels()
LIMITS = {"gap_width": 0.6, "lake_width": 2.0, "sliver_area": 0.01}
#: Ids as those of Overture: text without order.
IDS = [f"{number * 7919 % 10007:05x}-gers" for number in range(len(LAYER))]


@pytest.fixture(scope="module")
def whole():
    return twinedge.audit(LAYER, coverage=True, **LIMITS)


@pytest.fixture(scope="module")
def layer():
    return pa.table({"id": IDS, "shape": pa.array(shapely.to_wkb(LAYER), pa.binary())})


def said(findings):
    """Rules and ids, in the order of rules."""
    return sorted((row["rule"], *sorted(row["ids"])) for row in findings if row["rule"].startswith("C"))


EXPECTED = sorted((rule, *sorted(IDS[feature] for feature in features)) for rule, features in FAULTS)


@pytest.mark.parametrize("vertices", [64, 100_000])
def test_duckdb(whole, layer, vertices):
    duckdb = pytest.importorskip("duckdb", reason="duckdb is not installed")
    connection = duckdb.connect()
    relation = connection.from_arrow(layer)
    report, findings = tiles.duckdb.audit(relation, "shape", connection=connection, vertices=vertices, **LIMITS)
    # The order of rows, and so the numbers of features, are those of the relation, and findings have the ids of one machine.
    frame = {"type": "FeatureCollection", "features": [{"type": "Feature", "id": at, "geometry": shape.__geo_interface__} for at, shape in zip(IDS, LAYER)]}
    named = twinedge.audit(frame, coverage=True, **LIMITS)
    assert told(report) == told(whole) and [one.id for one in report.findings] == [one.id for one in named.findings]
    assert said(findings.to_arrow_table().to_pylist()) == EXPECTED
    # Nothing is left behind, and the findings are a relation.
    assert connection.sql("SELECT count(*) FROM duckdb_tables() WHERE table_name LIKE 'twinedge%'").fetchall() == [(0,)]


def test_duckdb_reads_files(whole, layer, tmp_path):
    duckdb = pytest.importorskip("duckdb", reason="duckdb is not installed")
    import pyarrow.parquet as pq

    pq.write_table(layer.rename_columns(["gers id", "geometry"]), tmp_path / "layer.parquet")
    report, findings = tiles.duckdb.audit(duckdb.read_parquet(str(tmp_path / "layer.parquet")), id="gers id", **LIMITS)
    assert told(report) == told(whole) and said(findings.to_arrow_table().to_pylist()) == EXPECTED


@pytest.mark.parametrize("as_binary", [True, False])
def test_dask(whole, layer, as_binary):
    frames = pytest.importorskip("dask.dataframe", reason="dask is not installed")
    import dask

    # Texts stay as they are, and bytes too.
    with dask.config.set({"dataframe.convert-string": False}):
        shapes = layer["shape"].to_pylist() if as_binary else LAYER
        column = np.empty(len(shapes), object)
        column[:] = shapes
        import pandas

        frame = frames.from_pandas(pandas.DataFrame({"id": IDS, "shape": column}), npartitions=4)
        report, findings = tiles.dask.audit(frame, "shape", vertices=64, **LIMITS)
    assert told(report) == told(whole) and said(findings.to_dict("records")) == EXPECTED


def test_a_layer_that_changes_between_two_passes_is_refused(layer):
    from twinedge.tiles._engine import Plan, survey

    rows = layer.rename_columns(["id", "geometry"])
    plan = Plan.of([survey(rows)], 64, LIMITS)
    # The same rows in other batches are the same.
    pieces = [*plan.divide(rows.to_batches(max_chunksize=3), 0)]
    assert pa.Table.from_batches(pieces) == pa.Table.from_batches(plan.divide(rows, 0))
    assert survey(rows.to_batches(max_chunksize=2)).digest == survey(rows).digest
    for other in (rows.slice(1), rows.take(np.arange(len(rows))[::-1]), rows.set_column(0, "id", rows["id"].take(np.arange(len(rows))[::-1]))):
        with pytest.raises(ValueError, match="the layer changed while it was audited: partition 0 has other rows than before"):
            [*plan.divide(other, 0)]
    # Tiles of two states are not put together.
    after = Plan.of([survey(rows.slice(1))], 64, LIMITS)
    assert after.cuts.source != plan.cuts.source


def test_a_task_that_runs_twice_makes_the_same_bytes(whole, layer):
    from twinedge.tiles._engine import Plan, survey

    rows = layer.rename_columns(["id", "geometry"])
    halves = [rows.slice(0, 9), rows.slice(9)]
    plan = Plan.of([survey(half) for half in halves], 64, LIMITS)
    runs = []
    for order in (1, -1):
        pieces = pa.concat_tables([pa.Table.from_batches(plan.divide(half, at)) for at, half in enumerate(halves)][::order])
        state = plan
        while not state.is_complete():
            found = [*state.search(pieces)]
            # A worker was lost after it had searched, and another one searched again.
            state = state.with_cuts([*found, *found[:1]])
        runs.append([*state.summaries(pieces)])
    assert runs[0] == runs[1]
    ids = pa.table({"feature": pa.array(range(len(IDS))), "id": IDS})
    report, findings = state.audited(runs[0], lambda _: ids)
    assert told(report) == told(whole) and said(findings.to_pylist()) == EXPECTED


def test_rows_that_cannot_be_read_are_findings_and_none_is_lost():
    frames, duckdb = pytest.importorskip("dask.dataframe", reason="dask is not installed"), pytest.importorskip("duckdb", reason="duckdb is not installed")
    import dask
    import pandas

    square = shapely.box(0, 0, 1, 1).wkb
    nan = shapely.to_wkb(shapely.LinearRing([(0, 0), (1, 0), (1, float("nan")), (0, 0)]))
    given = {
        "whole": square,
        "null": None,
        "empty": shapely.Polygon().wkb,
        "cut short": square[:-5],
        "not finite": nan,
        "too large": shapely.box(0, 0, 1, 1e300).wkb,
        "of no type": b"\x01\x63\x00\x00\x00",
        "bow tie": shapely.Polygon([(5, 5), (6, 6), (6, 5), (5, 6)]).wkb,
    }
    wanted = {"cut short": "cannot be read", "not finite": "finite", "too large": "out of range", "of no type": "cannot be read", "bow tie": "Self-intersection"}
    with dask.config.set({"dataframe.convert-string": False}):
        of_dask = tiles.dask.audit(frames.from_pandas(pandas.DataFrame({"id": [*given], "geometry": [*given.values()]}), npartitions=3))
    table = pa.table({"id": [*given], "geometry": pa.array([*given.values()], pa.binary())})
    of_duckdb = tiles.duckdb.audit(duckdb.from_arrow(table))
    for report, rows in ((of_dask.report, of_dask.findings.to_dict("records")), (of_duckdb.report, of_duckdb.findings.to_arrow_table().to_pylist())):
        found = {row["ids"][0]: row["message"] for row in rows if row["rule"] == "C6"}
        assert found.keys() == wanted.keys() and all(wanted[id] in message for id, message in found.items()), found
        assert report.verdict == "invalid" and report.to_dict()["without_geometry"] == [1, 2]


def test_reports_that_list_a_part_of_the_findings_are_whole_reports():
    # Regression: the report was refused if a finding that is not listed was about a feature after all that are.
    duckdb = pytest.importorskip("duckdb", reason="duckdb is not installed")
    layer = [shapely.box(x, y, x + 1.1, y + 1) for x in range(4) for y in range(4)]
    table = pa.table({"id": [f"k{at}" for at in range(16)], "geometry": pa.array(shapely.to_wkb(layer), pa.binary())})
    for listed in (1, 2, 1000):
        report, findings = tiles.duckdb.audit(duckdb.from_arrow(table), list=listed)
        rows = findings.filter("rule LIKE 'C%'").to_arrow_table().to_pylist()
        assert report.finding_count == twinedge.audit(layer, coverage=True).finding_count
        assert 0 < len(rows) <= report.finding_count and all(all(row["ids"]) for row in rows)


def test_layers_without_features_are_valid_as_on_one_machine():
    duckdb = pytest.importorskip("duckdb", reason="duckdb is not installed")
    for given in ([], [None], [shapely.Polygon().wkb]):
        table = pa.table({"id": pa.array(range(len(given)), pa.int64()), "geometry": pa.array(given, pa.binary())})
        report = tiles.duckdb.audit(duckdb.from_arrow(table)).report
        assert report.valid and report.to_dict().get("without_geometry", []) == [*range(len(given))]


def test_duckdb_in_a_transaction_and_of_another_connection(layer, whole):
    duckdb = pytest.importorskip("duckdb", reason="duckdb is not installed")
    connection = duckdb.connect()
    connection.execute("BEGIN")
    connection.from_arrow(layer).create("layer")
    report, _ = tiles.duckdb.audit(connection.table("layer"), "shape", connection=connection, **LIMITS)
    assert told(report) == told(whole)
    connection.execute("COMMIT")
    # Regression: the error named a table that nobody had made, and left one behind.
    for _ in range(2):
        with pytest.raises(ValueError, match="the relation is that of another connection"):
            tiles.duckdb.audit(connection.table("layer"), "shape")
    assert connection.sql("SELECT count(*) FROM duckdb_tables() WHERE table_name LIKE 'twinedge%'").fetchall() == [(0,)]


def test_arguments_that_are_wrong_are_named(layer):
    duckdb, frames = pytest.importorskip("duckdb", reason="duckdb is not installed"), pytest.importorskip("dask.dataframe", reason="dask is not installed")
    import dask
    import pandas

    rows = pandas.DataFrame({"id": ["a"], "shape": [LAYER[0].wkb]})
    with dask.config.set({"dataframe.convert-string": False}):
        of_dask = frames.from_pandas(rows, npartitions=1)
    for audit, frame in ((tiles.duckdb.audit, duckdb.from_arrow(layer)), (tiles.dask.audit, of_dask)):
        with pytest.raises(ValueError, match="there is no column 'geometry'; there are id, shape"):
            audit(frame)
        with pytest.raises(ValueError, match="'id' is one column, and the geometry and the id are two"):
            audit(frame, "id")
        with pytest.raises(TypeError, match="expected a .* of .*, not DataFrame"):
            audit(rows, "shape")
        with pytest.raises(TypeError, match="gap"):
            audit(frame, "shape", gap=0.1)
        with pytest.raises((TypeError, ValueError), match="vertices"):
            audit(frame, "shape", vertices="many")
