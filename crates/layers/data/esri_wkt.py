"""Writes esri-wkt.tsv.gz: the number of each reference system of the EPSG that is not deprecated, geographic with two dimensions or
projected, and its definition as Esri writes it into .prj. It needs pyproj; the last file is of pyproj 3.7.2 (PROJ 9.5.1, EPSG 11.022).
"""

import gzip
import pathlib

from pyproj import CRS
from pyproj.database import query_crs_info
from pyproj.enums import PJType
from pyproj.exceptions import CRSError

rows = {}
for info in query_crs_info("EPSG", [PJType.GEOGRAPHIC_2D_CRS, PJType.PROJECTED_CRS]):
    try:
        wkt = not info.deprecated and CRS.from_epsg(info.code).to_wkt("WKT1_ESRI")
    except CRSError:
        continue
    if wkt:
        rows[int(info.code)] = wkt
text = "".join(f"{code}\t{wkt}\n" for code, wkt in sorted(rows.items()))
pathlib.Path(__file__).with_name("esri-wkt.tsv.gz").write_bytes(gzip.compress(text.encode(), 9, mtime=0))
