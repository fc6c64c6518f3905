"""Remedies in the words of this package, for the kinds of violations whose remedy in the library names something of Rust."""

from __future__ import annotations

from typing import Final

REMEDIES: Final[dict[str, str]] = {
    "nil": "set the link, or retire the record; if the structure has no such links at all, leave the column out; for a mesh with"
    " a border pass `open=True`",
    "dangling": "find what links to a record before it is removed; if all such links dangle, pass the number of records"
    " (`vertices=`, `faces=`)",
    "twin_is_self": "create both half-edges of an edge together; at an open boundary let the twin be nil (-1), and pass `open=True`",
    "no_unbounded_face": "leave out `plane=True` for a mesh",
    "second_unbounded_face": "set the outer boundary component of one of the two faces, or merge the unbounded faces",
    "no_outer": "set `face_half_edge` of the face, or retire the face",
    "wrong_place": "update the place of the entry that is moved",
    "no_outside": "list the outside of each component as an inner boundary component of the face in which it lies; leave out"
    " `plane=True` for a mesh",
    "genus": "split edges where they cross (`snap=` of `audit`), sort the half-edges around each vertex by angle, or pass"
    " `plane=False` for a surface with handles",
    "unused_vertex": "delete the vertex, or do not ask for `used`",
    "cross": "split both edges where they cross: `audit(layer, snap=\"auto\")`, or the size of a grid as `snap=`, does so before it judges",
    "touch": "split the edge at the vertex: `audit(layer, snap=\"auto\")`, or the size of a grid as `snap=`, does so before it judges",
}
"""The remedy of each of these kinds, as part of a sentence."""

#: Cause and remedy of the faults of edges along great circles.
ON_GLOBE: Final[dict[str, tuple[str, str]]] = {
    "antipodal": ("an edge goes around half of the globe", "add a vertex between its ends"),
    **dict.fromkeys(
        ("cross", "overlap", "touch"),
        (
            "borders that are drawn with different vertices run along different great circles",
            "draw both borders with the same vertices; a border that is straight on the map needs more of them",
        ),
    ),
}
