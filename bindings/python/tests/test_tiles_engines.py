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
    with pytest.raises(ValueError, match="the layer has no geometries"):
        Plan.of([survey([])], 64, LIMITS)


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
    report, findings = state.audited(runs[0], lambda _: ids, None, None)
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
