"""A layer with planted faults, most of them across the seams of any grid."""

import numpy as np
import shapely

#: The rules of the faults, each with the features that it is between.
FAULTS = [("C1", (7, 25)), ("C2", (8, 9, 14, 15)), ("C5", (10, 24)), ("C6", (26,))]


def parcels():
    """Six by four squares of two units, with vertices where their neighbours have some, and faults.

    Feature 24 repeats feature 10. Feature 25 covers the right half of feature 7, whose sides have vertices there. Between features 8, 9, 14 and 15 a
    square is missing. Feature 26 is apart, and its hole lies outside of it.
    """
    squares = []
    for row in range(4):
        for column in range(6):
            x, y = 2 * column, 2 * row
            ring = [(x, y), (x + 1, y), (x + 2, y), (x + 2, y + 2), (x + 1, y + 2), (x, y + 2)]
            squares.append(ring)
    # The corner (6, 4) belongs to four squares, which are cut there.
    for number, corner in [(8, (6, 4)), (9, (6, 4)), (14, (6, 4)), (15, (6, 4))]:
        ring = squares[number]
        at = ring.index(corner)
        before, after = ring[at - 1], ring[(at + 1) % len(ring)]
        toward = [tuple(np.add(corner, np.sign(np.subtract(end, corner)) * 0.5)) for end in (before, after)]
        squares[number] = [*ring[:at], *toward, *ring[at + 1 :]]
    polygons = [shapely.Polygon(ring) for ring in squares]
    polygons.append(polygons[10])
    polygons.append(shapely.Polygon([(3, 2), (4, 2), (4, 4), (3, 4)]))
    polygons.append(shapely.Polygon(shapely.box(20, 20, 22, 22).exterior, [shapely.box(24, 24, 25, 25).exterior.coords]))
    return polygons


def told(report):
    """What a report says, apart from the numbers of records, and rounding."""
    findings = sorted((f.rule, f.features, f.at, round(f.area or 0, 9), round(f.length or 0, 9)) for f in report.findings)
    counts = {name: report.counts[name] for name in ("vertices", "edges", "cycles", "faces", "components", "isolated_vertices")}
    return report.verdict, counts, findings
