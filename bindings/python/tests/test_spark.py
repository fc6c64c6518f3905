"""Tiles on Spark, in local mode. Needs pyspark and a Java runtime."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).parents[1] / "examples" / "spark_tiles.py"


@pytest.mark.skipif(shutil.which("java") is None, reason="no Java runtime")
def test_faults_across_partitions_are_found_once_each_as_on_one_machine():
    pytest.importorskip("pyspark", reason="pyspark is not installed")
    environment = os.environ | {"SPARK_LOCAL_IP": "127.0.0.1"}
    done = subprocess.run(
        [sys.executable, "-P", str(EXAMPLE)], capture_output=True, text=True, env=environment, check=False, timeout=500
    )
    assert done.returncode == 0, done.stderr[-4000:]
    assert done.stdout.splitlines()[-1] == "the same as on one machine: 47 findings, 7 overlaps and duplicates across borders of tiles"
