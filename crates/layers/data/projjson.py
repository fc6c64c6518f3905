"""Writes projjson.tsv.gz: the number of each reference system of the EPSG that is not deprecated, geographic, geocentric, projected or
compound, and its definition in PROJJSON without scope, area and remarks. It needs pyproj; the last file is of pyproj 3.7.2 (PROJ 9.5.1, EPSG 11.022).
"""

import gzip
import json
import pathlib

from pyproj import CRS
from pyproj.database import query_crs_info
from pyproj.enums import PJType

KINDS = [
    PJType.COMPOUND_CRS,
    PJType.GEOCENTRIC_CRS,
    PJType.GEOGRAPHIC_2D_CRS,
    PJType.GEOGRAPHIC_3D_CRS,
    PJType.PROJECTED_CRS,
]
LEFT_OUT = ["$schema", "area", "bbox", "remarks", "scope", "usages"]

rows = {}
for info in query_crs_info("EPSG", KINDS):
    definition = CRS.from_epsg(info.code).to_json_dict()
    for key in LEFT_OUT:
        definition.pop(key, None)
    rows[int(info.code)] = json.dumps(definition, separators=(",", ":"), ensure_ascii=False)
text = "".join(f"{code}\t{definition}\n" for code, definition in sorted(rows.items()))
pathlib.Path(__file__).with_name("projjson.tsv.gz").write_bytes(gzip.compress(text.encode(), 9, mtime=0))
