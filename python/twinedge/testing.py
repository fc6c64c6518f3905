"""Hypothesis strategies of sound and broken half-edge structures, and a slow judge to compare with.

A structure is a dictionary of lists, the keyword arguments of :func:`twinedge.validate`::

    @hypothesis.given(twinedge.testing.surfaces())
    def test_my_checker(structure):
        assert my_checker(**structure)

Needs Hypothesis.
"""

from __future__ import annotations

from typing import Any

import hypothesis.strategies as st
from hypothesis import assume

__all__ = ["broken", "is_surface", "surfaces"]

#: Columns by name, and counts.
Structure = dict[str, Any]


def _orbits(step: list[int]) -> list[int]:
    """The number of the orbit of each element of a permutation, in order of their first elements."""
    number = [-1] * len(step)
    orbits = 0
    for start in range(len(step)):
        if number[start] < 0:
            at = start
            while number[at] < 0:
                number[at] = orbits
                at = step[at]
            orbits += 1
    return number


@st.composite
def surfaces(draw: st.DrawFn, *, max_edges: int = 12, faces: bool = True, prev: bool = True) -> Structure:
    """Closed surfaces of any genus and any number of components, with loops and parallel edges.

    Any permutation of an even number of half-edges is the ``next`` of one, and every one is drawn. Examples shrink to fewer edges.
    """
    edges = draw(st.integers(0, max_edges))
    next_ = draw(st.permutations(range(2 * edges)))
    twin = [h ^ 1 for h in range(2 * edges)]
    structure: Structure = {
        "origin": _orbits([next_[twin[h]] for h in range(2 * edges)]),
        "twin": twin,
        "next": [*next_],
    }
    if prev:
        before = [0] * (2 * edges)
        for h, follows in enumerate(next_):
            before[follows] = h
        structure["prev"] = before
    if faces:
        structure["face"] = _orbits([*next_])
    return structure


@st.composite
def broken(draw: st.DrawFn, *, max_edges: int = 12) -> Structure:
    """A surface of which one link has another value, so that it is none: each breaks a rule. ``vertices`` and ``faces`` are its counts."""
    structure: Structure = draw(surfaces(max_edges=max_edges).filter(lambda s: len(s["next"]) > 0))
    name = draw(st.sampled_from(sorted(structure)))
    at = draw(st.integers(0, len(structure["next"]) - 1))
    value = draw(st.integers(-2, 2 * max_edges))
    changed: Structure = {key: [*links] for key, links in structure.items()}
    changed[name][at] = value
    changed["vertices"] = max(structure["origin"]) + 1
    changed["faces"] = max(structure["face"]) + 1
    assume(not is_surface(**changed))
    return changed


def is_surface(
    *,
    origin: list[int],
    twin: list[int],
    next: list[int],
    prev: list[int] | None = None,
    face: list[int] | None = None,
    vertices: int | None = None,
    faces: int | None = None,
    **_: Any,
) -> bool:
    """Whether the lists are a closed surface: the rules in sets and quantifiers. Slow."""
    halves = range(len(next))
    vertices = max(origin, default=-1) + 1 if vertices is None else vertices
    links = [(origin, vertices), (twin, len(next)), (next, len(next)), (prev or [], len(next))]
    if face is not None:
        faces = max(face, default=-1) + 1 if faces is None else faces
        links.append((face, faces))
    if any(not 0 <= link < count for column, count in links for link in column):
        return False
    if any(twin[twin[h]] != h or twin[h] == h for h in halves):
        return False
    if len({*next}) < len(next) or (prev is not None and any(prev[next[h]] != h for h in halves)):
        return False
    if any(origin[next[h]] != origin[twin[h]] for h in halves):
        return False
    rotations = _orbits([next[twin[h]] for h in halves])
    if any((rotations[g] == rotations[h]) != (origin[g] == origin[h]) for g in halves for h in halves):
        return False
    if face is not None:
        cycles = _orbits(next)
        if any((cycles[g] == cycles[h]) != (face[g] == face[h]) for g in halves for h in halves):
            return False
        if {*face} != {*range(faces or 0)}:
            return False
    return True
