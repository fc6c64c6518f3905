"""Maps that are edited: undone, redone, with values that follow."""

import gc
import subprocess
import sys
import weakref
from pathlib import Path

import pytest

import twinedge

EXAMPLE = Path(__file__).parents[1] / "examples" / "editor.py"
SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]


def square(**attributes):
    """An editor with one parcel, and its face."""
    city = twinedge.Editor()
    for name, rules in attributes.items():
        city.attribute(name, **rules)
    return city, city.insert_ring(SQUARE).faces_split[0][1]


def test_the_example_runs():
    done = subprocess.run([sys.executable, "-P", str(EXAMPLE)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[1:2] == ["refused: nobody owns what is outside"]
    assert len(EXAMPLE.read_text(encoding="utf-8").splitlines()) < 60


def test_edits_say_what_they_did_and_are_undone_with_their_keys():
    city, inside = square()
    fence = city.insert_segment((1, 0), (3, 4))
    assert (len(fence.vertices_made), len(fence.edges_split), len(fence.way)) == (2, 2, 1)
    assert fence.faces_split[0][0] == inside and city.at((2, 2)) == ("edge", fence.way[0])
    assert city.undo_name == "insert a segment" and city.undo() and city.redo_name == "insert a segment"
    with pytest.raises(KeyError):
        city.position(fence.vertices[0])
    assert city.redo() and city.position(fence.vertices[0]) == (1, 0) and not city.redo()
    assert city.remove_vertex(fence.vertices[0]).faces_merged and city.area(city.unbounded) == float("inf")
    assert sorted(map(len, city.rings(city.unbounded))) == [1, 5] or len(city.rings(city.unbounded)) == 1
    assert len(city.faces) == 1 and repr(city).startswith("<twinedge.Editor of 5 vertices")


def test_edits_of_one_change_are_done_together_or_not_at_all():
    city, inside = square(owner={"split": "copy"})
    city.set("owner", inside, "Ada")

    def divide():
        fence = city.insert_segment((1, 0), (1, 4))
        city.set("owner", fence.faces_split[0][1], "Bob")
        with pytest.raises(RuntimeError, match="a change is being made"):
            city.undo()
        with pytest.raises(RuntimeError, match="a change is being made"):
            city.change("inner", lambda: None)
        return fence

    fence = city.change("divide and sell", divide)
    assert sorted(city.values("owner").values()) == ["Ada", "Bob"] and city.undo_name == "divide and sell"

    def fail():
        city.remove_edge(fence.way[0])
        city.insert_segment((2, 2), (9, 9))
        city.insert_segment((9, 2), (2, 9))

    with pytest.raises(ValueError, match="would cross"):
        city.change("fail", fail)
    assert sorted(city.values("owner").values()) == ["Ada", "Bob"] and city.undo_name == "divide and sell"
    assert city.undo() and list(city.values("owner").values()) == ["Ada"] and len(city.vertices) == 4


def test_policies_by_name_and_function():
    rules = {
        "tax": {"split": "share", "merge": "sum"},
        "owner": {"split": "copy", "merge": "equal"},
        "note": {},
        "parts": {"split": lambda value: (value[:1], value[1:]), "merge": lambda kept, dropped: (kept or "") + (dropped or "")},
        "height": {"of": "vertices", "split": "between"},
        "width": {"of": "edges", "split": "share"},
        "kind": {"of": "edges", "split": "copy"},
    }
    city, inside = square(**rules)
    assert city.get("tax", inside) is None
    for name, value in {"tax": 100, "owner": "Ada", "note": {"seen": True}, "parts": "xyz"}.items():
        city.set(name, inside, value)
    corners = {city.position(v): v for v in city.vertices}
    for at, height in [((0, 0), 10), ((4, 0), 30)]:
        city.set("height", corners[at], height)
    for edge in city.edges:
        city.set("width", edge, 8)
        city.set("kind", edge, "border")
    fence = city.insert_segment((1, 0), (1, 4))
    kept, made = fence.faces_split[0]
    assert sorted(city.values("tax").values()) == [25, 75]
    assert [city.get("owner", face) for face in (kept, made)] == ["Ada", "Ada"]
    assert [city.get("note", face) for face in (kept, made)] == [{"seen": True}, None]
    assert [city.get("parts", face) for face in (kept, made)] == ["x", "yz"]
    assert city.get("height", fence.vertices[0]) == 15 and city.get("height", fence.vertices[1]) is None
    assert sorted(city.values("width").values()) == [2, 2, 6, 6, 8, 8] and len(city.values("kind")) == 6

    city.set("owner", made, "Bob")
    with pytest.raises(ValueError, match="the values of the merged records differ"):
        city.remove_edge(fence.way[0])
    city.set("owner", made, "Ada")
    merged = city.remove_edge(fence.way[0]).faces_merged[0][0]
    assert (city.get("tax", merged), sorted(city.get("parts", merged))) == (100, ["x", "y", "z"])
    city.set("owner", merged, None)
    assert city.values("owner") == {}


def test_none_is_no_value_wherever_a_policy_returns_it():
    parts = {(None, "b"): [None, "b"], ("a", None): ["a", None], (None, None): [None, None]}
    for returned, expected in parts.items():
        city, inside = square(owner={"split": lambda value, returned=returned: returned, "merge": lambda kept, dropped: None})
        city.set("owner", inside, "Ada")
        fence = city.insert_segment((1, 0), (1, 4))
        faces = fence.faces_split[0]
        assert [city.get("owner", face) for face in faces] == expected
        assert city.values("owner") == {face: value for face, value in zip(faces, expected) if value is not None}
        city.remove_edge(fence.way[0])
        assert city.values("owner") == {}


def test_a_function_that_raises_refuses_the_edit_and_its_exception_is_seen():
    def refuse(*values):
        raise LookupError(f"no {values}")

    for rules in [{"split": refuse}, {"split": lambda value: value}, {"split": lambda value: city.undo()}]:
        city, inside = square(owner=rules)
        city.set("owner", inside, 7)
        with pytest.raises((LookupError, TypeError, ValueError, RuntimeError)) as raised:
            city.insert_segment((1, 0), (1, 4))
        assert "an attribute does not allow it" not in str(raised.value)
        assert (len(city.vertices), city.values("owner")) == (4, {inside: 7}) and city.undo_name == "set a value"

    class Unlike:
        def __eq__(self, other):
            raise LookupError("not to be compared")

    city, inside = square(owner={"split": "copy", "merge": "equal"})
    city.set("owner", inside, Unlike())
    fence = city.insert_segment((1, 0), (1, 4))
    with pytest.raises(LookupError, match="not to be compared"):
        city.remove_edge(fence.way[0])
    assert len(city.faces) == 3


def test_ids_last():
    city = twinedge.Editor()
    city.ids("parcel", first=10)
    city.ids("corner", of="vertices", first=1)
    city.insert_ring(SQUARE)
    fence = city.insert_segment((1, 0), (1, 4))
    assert sorted(city.values("parcel").values()) == [10, 11] and sorted(city.values("corner").values()) == [1, 2, 3, 4, 5, 6]
    made = fence.faces_split[0][1]
    assert city.find("parcel", 11) == made and city.find("parcel", 99) is None
    city.undo()
    assert city.find("parcel", 11) is None
    # No number is assigned twice.
    city.insert_segment((2, 0), (2, 4))
    assert sorted(city.values("parcel").values()) == [10, 12]


def test_misuse_is_told():
    city, inside = square(tax={"merge": "sum"})
    for rules, message in [
        ({"of": "halves"}, "of: .halves. is none of faces, edges, vertices"),
        ({"split": "best"}, "split: .best. is none of keep, copy"),
        ({"merge": "best"}, "merge: .best. is none of keep, equal"),
        ({"of": "vertices", "split": "share"}, "split: .share. is none of"),
        ({"split": "share", "merge": max}, "merge: .a function. is none of"),
    ]:
        with pytest.raises(ValueError, match=message):
            twinedge.Editor().attribute("x", **rules)
    with pytest.raises(ValueError, match="before the first change"):
        city.attribute("late")
    with pytest.raises(ValueError, match="there is an attribute"):
        city.attribute("tax")
    with pytest.raises(KeyError, match="no attribute .rent."):
        city.get("rent", inside)
    with pytest.raises(TypeError):
        city.set("tax", inside, "much")
    with pytest.raises(KeyError):
        city.set("tax", 12345, 1)
    with pytest.raises(ValueError, match="finite"):
        city.insert_point((float("nan"), 0))
    with pytest.raises(TypeError):
        city.insert_segment((0, 0), None)
    assert city.values("tax") == {}


def test_objects_live_as_long_as_they_can_be_brought_back():
    class Owner:
        pass

    city, inside = square(owner={})
    owner = Owner()
    seen = weakref.ref(owner)
    city.set("owner", inside, owner)
    del owner
    assert isinstance(city.get("owner", inside), Owner)
    city.undo()
    gc.collect()
    assert seen() is not None and city.redo() and isinstance(city.get("owner", inside), Owner)
