"""Maps that are asked, overlaid and drawn, and layers that are cleaned."""

import xml.etree.ElementTree as ET
from pathlib import Path

import geopandas
import numpy as np
import pytest
import shapely

import twinedge

PARCELS = Path(__file__).parents[3] / "docs" / "parcels.geojson"
WORLD = Path(__file__).parents[3] / "crates" / "cli" / "data" / "world-110m.geojson"
#: Three squares in a row, the middle one a step down, and a point.
ROW = geopandas.GeoDataFrame(
    {"name": ["a", "b", "c", "d"]},
    geometry=[
        shapely.Polygon([(0, 0), (2, 0), (2, 1), (2, 2), (0, 2)]),
        shapely.Polygon([(2, -1), (4, -1), (4, 0), (4, 1), (2, 1), (2, 0)]),
        shapely.Polygon([(4, 0), (6, 0), (6, 2), (4, 2), (4, 1)]),
        shapely.Point(9, 9),
    ],
    crs="EPSG:2056",
)


def test_neighbours_share_borders():
    found = twinedge.Map(ROW).neighbours()
    assert [(one.feature, one.other, one.length, one.shared, one.lines, one.overlap) for one in found] == [(0, 1, 1, 1, 1, 0), (1, 2, 1, 1, 1, 0)]
    assert [one.other for one in twinedge.Map(ROW).neighbours(1)] == [0, 2] and not twinedge.Map(ROW).neighbours(3)
    # GEOS measures the same values.
    world = geopandas.read_file(PARCELS)
    for one in twinedge.Map(world).neighbours():
        shared = world.geometry.iloc[one.feature].intersection(world.geometry.iloc[one.other]).length
        assert one.length == pytest.approx(shared)


def test_places_are_exact():
    below = np.nextafter(2.0, 0.0)
    found = twinedge.Map(ROW).at([(1, 1), (3, 0), (2, 0.5), (2, 1), (below, 0.5), (9, 9), (-1, 0)])
    assert [(one.kind, one.features) for one in found] == [
        ("face", (0,)), ("face", (1,)), ("edge", (0, 1)), ("vertex", (0, 1)), ("face", (0,)), ("vertex", ()), ("face", ()),
    ]
    with pytest.raises(ValueError, match="finite|range"):
        twinedge.Map(ROW).at([(float("nan"), 0)])


def test_contours_have_no_borders_inside():
    world = twinedge.Map(ROW)
    outline = shapely.geometry.shape(world.contour(0, 1, 2))
    assert outline.is_valid and outline.equals(ROW.geometry.iloc[:3].union_all())
    assert shapely.geometry.shape(world.contour(1)).equals(ROW.geometry.iloc[1])
    with pytest.raises(IndexError, match="there is no feature 4"):
        world.contour(4)


@pytest.mark.parametrize("how", ["intersection", "union", "difference", "symmetric_difference", "identity"])
def test_overlays_are_those_of_geopandas(how):
    squares = geopandas.GeoDataFrame(geometry=[shapely.box(1, 0, 3, 3), shapely.box(3, 0, 5, 3)], crs=ROW.crs, index=["x", "y"])
    polygons = ROW.iloc[:3]
    mine, theirs = twinedge.overlay(polygons, squares, how), geopandas.overlay(polygons, squares, how)
    assert mine.crs == ROW.crs and mine.area.sum() == pytest.approx(theirs.area.sum())
    assert sorted(mine.area.round(9)) == sorted(theirs.area.round(9)) and mine.is_valid.all()
    if how == "intersection":
        assert set(zip(mine["left"], mine["right"], strict=True)) == {((0,), ("x",)), ((1,), ("x",)), ((1,), ("y",)), ((2,), ("y",))}


def test_overlays_that_cannot_be_made_say_why():
    with pytest.raises(ValueError, match=r"right\.to_crs\(left\.crs\)"):
        twinedge.overlay(ROW, ROW.to_crs("EPSG:4326"))
    with pytest.raises(ValueError, match="how: 'clip' is none of union, intersection"):
        twinedge.overlay(ROW, ROW, "clip")
    crossing = twinedge.Map([shapely.box(0, 0, 2, 2), shapely.box(1, 1, 3, 3)])
    for ask in [crossing.neighbours, lambda: crossing.at([(0, 0)]), lambda: crossing.contour(0), lambda: crossing.overlay(crossing)]:
        with pytest.raises(ValueError, match='snap="auto" cuts them'):
            ask()
    cut = twinedge.Map([shapely.box(0, 0, 2, 2), shapely.box(1, 1, 3, 3)], snap="auto")
    assert cut.at([(1.5, 1.5)])[0].features == (0, 1) and cut.neighbours()[0].overlap == 1
    with pytest.raises(ValueError, match="feature 1 has a coordinate that is NaN"):
        twinedge.Map([shapely.box(0, 0, 1, 1), shapely.Point(float("inf"), 0)])
    with pytest.raises(FileNotFoundError):
        twinedge.Map("no-such.geojson")


def test_pictures_are_svg_and_mark_what_is_wrong():
    picture = ET.fromstring(twinedge.Map(ROW)._repr_svg_())
    assert picture.tag.endswith("svg")
    page = twinedge.Map(ROW)._repr_html_()
    assert page.startswith("<figure><svg") and "4 features" in page
    crossing = twinedge.draw([shapely.box(0, 0, 2, 2), shapely.box(1, 1, 3, 3)])
    assert "cross" in crossing and "cross" not in twinedge.draw(ROW)
    detail = twinedge.Map(PARCELS).draw(detail=True, window=(0, 0, 200, 200))
    assert len(detail) > 1000
    with pytest.raises(ValueError, match="legible up to 1000"):
        twinedge.Map(WORLD).draw(detail=True)
    with pytest.raises(ValueError, match="size: 1 is not between"):
        twinedge.draw(ROW, size=1)


OVERLAPPING = geopandas.GeoDataFrame(
    {"owner": ["north", "south", "path", "none"], "n": [1, 2, 3, 4]},
    geometry=[
        shapely.Polygon([(0, 1, 5), (2, 1, 5), (2, 2, 5), (0, 2, 5)]),
        shapely.box(0, 0, 2, 1.1),
        shapely.LineString([(5, 5), (6, 6)]),
        None,
    ],
    index=[4, 3, 2, 1],
    crs="EPSG:2056",
)


def test_a_layer_is_cleaned_and_the_rest_is_the_same_object():
    mended, report = twinedge.clean(OVERLAPPING)
    assert report["clean"] and [change["kind"] for change in report["changes"]] == ["overlap"]
    assert mended.crs == OVERLAPPING.crs and mended.index.equals(OVERLAPPING.index) and mended["owner"].equals(OVERLAPPING["owner"])
    assert twinedge.expect(mended.iloc[:2]) and not twinedge.expect(OVERLAPPING.iloc[:2], raises=False)
    assert mended.geometry.iloc[2] is OVERLAPPING.geometry.iloc[2] and mended.geometry.iloc[3] is None
    # Heights are kept.
    assert mended.geometry.iloc[0].has_z and shapely.get_coordinates(mended.geometry.iloc[0], include_z=True)[0, 2] == 5
    # The receiving feature is a choice.
    areas = {overlap: twinedge.clean(OVERLAPPING, overlap=overlap).layer.area.iloc[:2].tolist() for overlap in ("first", "last")}
    assert areas["first"] == pytest.approx([2, 2]) and areas["last"] == pytest.approx([1.8, 2.2])
    with pytest.raises(ValueError, match="overlap: .best. is none of inner, larger"):
        twinedge.clean(OVERLAPPING, overlap="best")


CRACKED = geopandas.GeoDataFrame(
    {"use": ["field", "road", "wood"], "n": [1, 2, 3]},
    geometry=[
        shapely.Polygon([(0, 0), (30, 0), (30, 20), (0, 20)], [[(10, 1), (10.02, 1), (10.02, 19), (10, 19)], [(20, 5), (24, 5), (24, 9), (20, 9)]]),
        shapely.box(30, 0, 40, 20),
        shapely.box(60, 0, 70, 20),
    ],
    crs=2056,
)


@pytest.mark.parametrize(("gaps_to", "expected"), [(None, 0), (("use", "field"), 0), (("use", "road"), 1), ([2, 1], 1), (("use", "gap"), 3), ([], 3)])
def test_gaps_go_where_they_are_to_go_and_the_width_is_chosen(gaps_to, expected):
    mended, report = twinedge.clean(CRACKED, gap_width="auto", gaps_to=gaps_to)
    assert report["gap_width"] == 0.02 and report["chosen_width"]["gaps"] == 1
    assert [change["to"]["number"] for change in report["changes"]] == [expected]
    before = CRACKED.area.tolist() + [0.0]
    grown = [i for i, area in enumerate(mended.area) if abs(area - before[i] - 0.36) < 1e-9]
    assert grown == [expected] and mended.crs == CRACKED.crs
    assert mended["n"].iloc[:3].tolist() == [1, 2, 3] and len(mended) == max(3, expected + 1)
    if gaps_to == ("use", "gap"):
        assert mended["use"].iloc[3] == "gap" and mended.index[3] == 3 and mended["n"].isna().iloc[3]


def test_new_features_come_behind_all_kinds_of_layers_and_others_are_refused():
    series = twinedge.clean(CRACKED.geometry, gap_width="auto", gaps_to=[]).layer
    assert isinstance(series, geopandas.GeoSeries) and len(series) == 4 and series.crs == CRACKED.crs
    listed = twinedge.clean([*CRACKED.geometry], gap_width="auto", gaps_to=[]).layer
    assert len(listed) == 4 and listed[3].equals(series.iloc[3])
    named = twinedge.clean(CRACKED.set_index("use"), gap_width="auto", gaps_to=[]).layer
    assert named.index[3] == "gaps"
    for layer, gaps_to in [(CRACKED, ("sort", 1)), (CRACKED.geometry, ("use", "road")), (CRACKED, [3]), (CRACKED, [-1])]:
        with pytest.raises(ValueError, match="gaps_to"):
            twinedge.clean(layer, gaps_to=gaps_to)


def test_what_is_cleaned_keeps_its_kind(tmp_path):
    series = twinedge.clean(OVERLAPPING.geometry).layer
    assert isinstance(series, geopandas.GeoSeries) and series.index.equals(OVERLAPPING.index) and series.crs == OVERLAPPING.crs
    listed = twinedge.clean([*OVERLAPPING.geometry]).layer
    assert isinstance(listed, list) and [*map(shapely.to_wkt, listed[:3])] == [*map(shapely.to_wkt, series[:3])]
    OVERLAPPING.to_file(tmp_path / "layer.gpkg")
    cleaned = twinedge.clean(tmp_path / "layer.gpkg")
    assert cleaned.is_clean and cleaned.layer["n"].tolist() == [1, 2, 3, 4]
    gap = [shapely.box(0, 0, 1, 1), shapely.box(1.25, 0, 2, 1), shapely.box(0, 1, 2, 2), shapely.box(0, -1, 2, 0)]
    assert not twinedge.clean(gap).is_clean and twinedge.clean(gap, gap_width=0.5).is_clean
    for layer, error, text in [
        ([shapely.Point(0, 0)], ValueError, "no polygon"),
        (["POINT(0 0)"], TypeError, "cannot audit list: expected a frame"),
        (7, TypeError, "expected a frame"),
        ([shapely.Polygon([(0, 0), (1, float("inf")), (1, 0)])], ValueError, "not finite"),
    ]:
        with pytest.raises(error, match=text):
            twinedge.clean(layer)


class Cells:
    """A block of cells of meshio, and a mesh of these."""

    def __init__(self, kind, data, dim=2):
        self.type, self.data, self.dim = kind, np.asarray(data), dim


class Meshio:
    def __init__(self, points, cells):
        self.points, self.cells, self.cells_dict = np.asarray(points, float), cells, {}


class PolyData:
    """As pyvista has it."""

    def __init__(self, points, faces):
        self.n_points, self.points = len(points), points
        self.irregular_faces, self.faces = tuple(map(np.array, faces)), np.empty(0)


TETRAHEDRON = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]


def test_meshes_of_other_libraries_are_validated():
    import networkx
    import trimesh
    from compas.datastructures import Mesh

    points = np.eye(4, 3)
    six_nodes = [[*face, 4, 5, 6] for face in TETRAHEDRON]
    lines = Cells("line", [[0, 1]], dim=1)
    for mesh in [
        trimesh.Trimesh(points, TETRAHEDRON, process=False),
        PolyData(points, TETRAHEDRON),
        Meshio(points, [lines, Cells("triangle", TETRAHEDRON[:2]), Cells("triangle", TETRAHEDRON[2:])]),
        Meshio(np.zeros((7, 3)), [Cells("triangle6", six_nodes)]),
    ]:
        report = twinedge.validate(mesh, closed=True, genus=0, sides=3)
        assert report.valid and report.counts["faces"] == 4, mesh
        assert twinedge.audit(mesh, closed=True).valid
    assert twinedge.validate(Mesh.from_polyhedron(6), closed=True).valid
    assert twinedge.validate(networkx.check_planarity(networkx.complete_graph(4))[1]).valid
    assert twinedge.validate(PolyData(points, TETRAHEDRON[1:]), closed=True).broken_rules == ["M4"]
    for mesh, error in [(7, "cannot validate int"), (None, "cannot validate None"), ("x.obj", "cannot validate str")]:
        with pytest.raises(TypeError, match=error):
            twinedge.validate(mesh)
    with pytest.raises(TypeError, match="next: this is for links in arrays"):
        twinedge.validate(PolyData(points, TETRAHEDRON), next=[0])
