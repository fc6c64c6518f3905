"""The example of Spark, in local mode. Needs pyspark, pyarrow and a Java runtime."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).parents[1] / "examples" / "spark_audit.py"


@pytest.mark.skipif(shutil.which("java") is None, reason="no Java runtime")
def test_one_partition_of_four_is_not_valid():
    pytest.importorskip("pyspark")
    pytest.importorskip("pyarrow")
    code = "import json, runpy, sys; print(json.dumps(runpy.run_path(sys.argv[1])['main']()))"
    environment = os.environ | {"SPARK_LOCAL_IP": "127.0.0.1"}
    done = subprocess.run(
        [sys.executable, "-P", "-c", code, str(EXAMPLE)], capture_output=True, text=True, env=environment, check=False, timeout=300
    )
    assert done.returncode == 0, done.stderr[-4000:]
    rows = json.loads(done.stdout.splitlines()[-1])
    assert [(row["features"], row["valid"]) for row in rows] == [(9, True), (9, True), (9, False), (9, True)]
    assert {f["kind"] for f in json.loads(rows[2]["report"])["findings"]} >= {"overlap"}
