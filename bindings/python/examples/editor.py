"""The core of an editor of parcels: one is split by a line, a corner is moved, two are merged, and all of it is undone and redone.

Both parts of a split parcel have its owners, and its tax is shared out by area; a merged parcel has the owners of both, and the sum.

    python python/examples/editor.py
"""

from twinedge import Editor


def both(kept, dropped):
    if (kept is None) != (dropped is None):
        raise PermissionError("nobody owns what is outside")
    return kept | dropped if kept else None


city = Editor()
city.ids("parcel")
city.attribute("owners", split="copy", merge=both)
city.attribute("tax", split="share", merge="sum")


def parcels():
    owned = city.values("owners").items()
    return sorted((city.get("parcel", face), sorted(names), city.area(face), city.get("tax", face)) for face, names in owned)


def draw():
    inside = city.insert_ring([(0, 0), (4, 0), (4, 4), (0, 4)]).faces_split[0][1]
    city.set("owners", inside, {"Ada"})
    city.set("tax", inside, 160)


city.change("draw a parcel", draw)
fence = city.insert_segment((1, 0), (3, 4))
assert parcels() == [(1, ["Ada"], 8, 80), (2, ["Ada"], 8, 80)]
city.set("owners", fence.faces_split[0][1], {"Bob"})
city.move_vertex(fence.vertices[0], (2, -1))
divided = parcels()
print("divided:", divided)
assert sorted(area for _, _, area, _ in divided) == [6.5, 11.5]

border = next(edge for edge in city.edges if edge != fence.way[0])
try:
    city.remove_edge(border)
except PermissionError as error:
    print("refused:", error)
assert parcels() == divided

city.remove_edge(fence.way[0])
merged = parcels()
print("merged:", merged)
assert [(owners, area, tax) for _, owners, area, tax in merged] == [(["Ada", "Bob"], 18, 160)]

print("undo:", city.undo_name)
assert city.undo() and parcels() == divided
assert city.redo() and parcels() == merged
