"""The validator over arrays: verdicts, types, errors, threads and signals."""

import pickle
import signal
import threading
import time

import numpy as np
import pytest

import twinedge


def test_a_triangle_is_valid_and_counted(triangle):
    report = twinedge.validate(**triangle, plane=True)
    assert report.valid and report.violations == [] and report.broken_rules == []
    assert {k: report.counts[k] for k in ["vertices", "edges", "components", "genus"]} == {
        "vertices": 3, "edges": 3, "components": 1, "genus": 0,
    }
    assert report.raise_if_invalid() is report
    assert repr(report) == "<twinedge.Report valid (vertices 3, edges 3, faces 0, components 1, genus 0)>"


def test_a_wrong_twin_is_named(triangle):
    triangle["twin"][0] = 2
    report = twinedge.validate(**triangle)
    assert not report.valid
    first = report.violations[0]
    assert (first.rule, first.kind, first.fields) == ("L1", "twin_not_mutual", {"half_edge": 0, "twin": 2, "found": 3})
    assert first.records == (twinedge.Record("half_edge", 0), twinedge.Record("half_edge", 2))
    assert str(first.records[0]) == "half-edge 0" and "twin" in first.message
    assert "faces" in first.cause and first.remedy
    with pytest.raises(twinedge.InvalidStructure, match="L1") as raised:
        report.raise_if_invalid()
    assert raised.value.report == report
    assert pickle.loads(pickle.dumps(raised.value)).report == report


def test_what_is_asked_for_is_checked(triangle):
    for asked, rule in [
        ({"genus": 1}, "M7"), ({"components": 2}, "M5"), ({"borders": 1}, "M6"), ({"sides": 4}, "M3"),
        ({"vertices": 4, "used": True}, "M1"),
    ]:
        assert twinedge.validate(**triangle, **asked).broken_rules == [rule], asked
    assert twinedge.validate(**triangle, genus=0, components=1, borders=0, sides=3, simple=True, used=True).valid
    # One half-edge per edge: a border.
    open_triangle = {"origin": [0, 1, 2], "twin": [-1, -1, -1], "next": [1, 2, 0], "face": [0, 0, 0]}
    assert twinedge.validate(**open_triangle).broken_rules == ["R1"]
    assert twinedge.validate(**open_triangle, open=True, borders=1).valid
    assert twinedge.validate(**open_triangle, open=True, closed=True).broken_rules == ["M4"]
    assert twinedge.validate(**open_triangle, preset="trimesh").valid
    # Twins without face, and a vertex that keeps an inner half-edge.
    both = {
        "origin": [0, 1, 2, 1, 2, 0], "twin": [3, 4, 5, 0, 1, 2], "next": [1, 2, 0, 5, 3, 4],
        "face": [0, 0, 0, -1, -1, -1], "face_half_edge": [0], "leaving": [5, 3, 4],
    }
    assert twinedge.validate(**both, preset="openmesh").valid
    both["leaving"][0] = 0
    report = twinedge.validate(**both, preset="openmesh")
    assert [v.kind for v in report.violations] == ["kept_inside"]
    assert twinedge.validate(**both, preset="surface_mesh").valid
    assert twinedge.validate(**both, preset="surface_mesh", border_kept=True).broken_rules == ["M8"]


def test_the_preset_of_networkx_checks_both_orders(triangle):
    triangle["prev"] = [4, 3, 0, 5, 2, 1]
    assert twinedge.validate(**triangle, preset="networkx").valid
    triangle["prev"][0] = 2
    assert twinedge.validate(**triangle, preset="networkx").broken_rules == ["L2"]


def test_targets_pairs_and_labels(triangle):
    pillow = {"next": [2, 5, 4, 1, 0, 3], "face": [0, 1, 0, 1, 0, 1]}
    assert twinedge.validate(origin=[0, 1, 1, 2, 2, 0], **pillow, genus=0).valid
    assert twinedge.validate(target=[1, 0, 2, 1, 0, 2], **pillow, genus=0).valid
    pillow["face"][2] = 1
    assert twinedge.validate(target=[1, 0, 2, 1, 0, 2], **pillow).broken_rules[0] == "B1"


@pytest.mark.parametrize("dtype", ["i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", ">i4", "<i8", ">u8"])
def test_every_type_of_integer_has_the_same_verdict(triangle, dtype):
    links = {name: column.astype(dtype) for name, column in triangle.items()}
    assert twinedge.validate(**links, plane=True).valid
    nil = np.iinfo(dtype).max if np.dtype(dtype).kind == "u" else -1
    links["twin"][4] = nil
    report = twinedge.validate(**links, plane=True)
    assert report.violations[0].kind == "nil" and report.violations[0].records[0].index == 4
    # Mixed types are copied.
    links["next"] = triangle["next"].astype("u2" if dtype != "u2" else "i8")
    assert twinedge.validate(**links, plane=True) == report


def test_strides_of_all_kinds_are_read(triangle):
    n = 6
    records = np.zeros(n, [("next", "i8"), ("origin", "i8"), ("twin", "i8")])
    packed = np.zeros(n, [("flag", "i1"), ("next", "i8"), ("origin", "i8"), ("twin", "i8")])
    for name, column in triangle.items():
        records[name] = packed[name] = column
    assert records["twin"].strides == (24,) and not packed["twin"].flags.aligned
    for array in [records, packed]:
        assert twinedge.validate(**{name: array[name] for name in triangle}, plane=True).valid
        array["twin"][5] = 5
        report = twinedge.validate(**{name: array[name] for name in triangle}, plane=True)
        assert "twin_is_self" in {v.kind for v in report.violations}
    backwards = {name: column[::-1].copy()[::-1] for name, column in triangle.items()}
    assert backwards["next"].strides == (-8,) and twinedge.validate(**backwards, plane=True).valid
    read_only = {name: column.copy() for name, column in triangle.items()}
    for column in read_only.values():
        column.flags.writeable = False
    assert twinedge.validate(**read_only, plane=True).valid
    # One element repeated: a loop whose only half-edge is its own twin.
    same = np.broadcast_to(np.zeros(1, np.int64), 4)
    assert "twin_is_self" in {v.kind for v in twinedge.validate(origin=same, twin=same, next=same).violations}


def test_the_empty_structure_is_valid():
    assert twinedge.validate(origin=[], twin=[], next=[]).valid
    assert twinedge.validate(origin=[], next=np.empty(0, np.int32), plane=True).valid


@pytest.mark.parametrize(
    ("change", "error", "told"),
    [
        ({"twin": [1, 0, 3, 2, 5]}, ValueError, "differ in length: .*`twin` 5"),
        ({"origin": [0] * 7}, ValueError, "differ in length: .*`origin` 7"),
        ({"prev": [0]}, ValueError, "differ in length: .*`prev` 1"),
        ({"face": []}, ValueError, "differ in length: .*`face` 0"),
        ({"next": [2, 5, 4, 1, 0]}, ValueError, "differ in length: `origin` 6, `twin` 6, `next` 5$"),
        ({"next": None}, TypeError, "next is required"),
        ({"twin": np.ma.masked_array([1, 0, 3, 2, 5, 4], [0, 0, 0, 0, 0, 1])}, TypeError, "twin: the mask of a masked array"),
        ({"vertices": 10**30}, ValueError, "vertices: 1000000000000000000000000000000 is more than 4,294,967,294"),
        ({"faces": 2**32, "face": [0] * 6}, ValueError, "faces: 4294967296 is more than 4,294,967,294"),
        ({"list": 10**30}, ValueError, "list: 1000000000000000000000000000000 is more"),
        ({"preset": ["trimesh"]}, TypeError, "preset: expected a name, one of surface_mesh, .*, not list"),
        ({"leaving": [0, 1], "vertices": 3}, ValueError, "the column `leaving` has length 2, where 3 is expected"),
        ({"next": [[0, 1], [2, 3]]}, ValueError, r"next: expected one dimension, not the shape \(2, 2\)"),
        ({"next": [0.0] * 6}, TypeError, "next: expected integers, not float64"),
        ({"twin": ["a"] * 6}, TypeError, "twin: expected integers, not <U1"),
        ({"twin": [None] * 6}, TypeError, "twin: expected integers, not object"),
        ({"twin": np.zeros(6, bool)}, TypeError, "twin: expected integers, not bool"),
        ({"target": [0] * 6}, TypeError, "give either origin or target"),
        ({"origin": None}, TypeError, "give either origin or target"),
        ({"face_half_edge": [0]}, TypeError, "face_half_edge: needs face"),
        ({"faces": 1}, TypeError, "faces: needs face"),
        ({"vertices": -1}, ValueError, "vertices: -1 is negative"),
        ({"genus": 0.5}, TypeError, "genus: expected a number, not float"),
        ({"genus": True}, TypeError, "genus: expected a number, not bool"),
        ({"preset": "cgal"}, ValueError, 'preset: there is none named "cgal"; there are surface_mesh, '),
        ({"preset": "openmesh", "plane": True}, ValueError, "plane: a preset"),
    ],
)
def test_what_is_wrong_with_the_arguments_is_said(triangle, change, error, told):
    with pytest.raises(error, match=told):
        twinedge.validate(**{**triangle, **change})


def test_dangling_links_of_any_size_make_no_records(triangle):
    for value in [6, 2**40, 2**62, -2, -(2**63)]:
        for name in triangle:
            links = {key: column.copy() for key, column in triangle.items()}
            links[name][3] = value
            report = twinedge.validate(**links, list=1)
            assert "dangling" in {v.kind for v in report.violations} or value == 6 and name == "origin", (name, value)
            assert report.counts["vertices"] <= 6


def big(n):
    """n loops, each at its own vertex."""
    h = np.arange(2 * n)
    return {"origin": h // 2, "twin": h ^ 1, "next": h}


def test_the_lock_is_released_and_a_change_is_an_error():
    links = big(2_000_000)
    assert twinedge.validate(**links).valid
    ticks, done = [], threading.Event()

    def write():
        while not done.is_set():
            links["next"][len(ticks) % 1000 * 7] += 1
            ticks.append(time.perf_counter())
            time.sleep(0.0005)

    writer = threading.Thread(target=write)
    writer.start()
    start = time.perf_counter()
    try:
        with pytest.raises(RuntimeError, match="an array changed while it was validated"):
            twinedge.validate(**links)
    finally:
        end = time.perf_counter()
        done.set()
        writer.join()
    # The thread ran during the call, not only between two calls.
    assert sum(start < tick < end for tick in ticks) >= 3


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="signals")
def test_signals_are_handled_during_a_validation_and_end_it_if_they_raise():
    links = big(6_000_000)
    calls = []

    def count(*_):
        calls.append(None)
        if len(calls) == limit:
            raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, count)
    try:
        limit = None
        signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)
        assert twinedge.validate(**links).valid
        signal.setitimer(signal.ITIMER_REAL, 0)
        # A signal that waits for the end of a call is handled once.
        whole = len(calls)
        assert whole >= 6
        calls.clear()
        limit = 3
        signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)
        with pytest.raises(KeyboardInterrupt):
            twinedge.validate(**links)
        signal.setitimer(signal.ITIMER_REAL, 0)
        assert 3 <= len(calls) < whole
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert twinedge.validate(**big(3)).valid


def test_types_without_a_sign_are_seen_with_one_where_that_bit_is_not_needed(triangle):
    from twinedge._links import _columns

    for unsigned, signed in [("u4", "i4"), ("u8", "i8")]:
        links = {name: column.astype(unsigned) for name, column in triangle.items()}
        seen = _columns(links, None, 3)
        assert {array.dtype for array in seen.values()} == {np.dtype(signed)}
        assert all(np.shares_memory(seen[name], links[name]) for name in links)
        # More than 2 to the power of 31 records leave no room for the sign, so arrays are copied
        # to 64 bits.
        many = _columns(links, 2**31 + 1)
        assert {array.dtype for array in many.values()} == {np.dtype("i8")} and not np.shares_memory(many["next"], links["next"])
        links["twin"][0] = 2**31
        dangling = twinedge.validate(**links).violations[0]
        assert dangling.kind == "dangling" and dangling.fields["value"] == (2**64 - 1 if unsigned == "u4" else 2**31)
