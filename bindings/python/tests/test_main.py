"""`python -m twinedge`."""

import os
import subprocess
import sys
import sysconfig

import pytest


def run(folder, *arguments):
    command = [sys.executable, "-P", "-m", "twinedge", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False, env=os.environ | {"PATH": str(folder)})


@pytest.mark.skipif(os.name != "posix", reason="the program is a shell script here")
@pytest.mark.skipif(os.path.exists(os.path.join(sysconfig.get_path("scripts"), "twinedge")), reason="the program is installed beside Python")
def test_the_program_is_run_with_its_arguments_and_its_status(tmp_path):
    missing = run(tmp_path)
    assert missing.returncode == 2 and "the program is not installed" in missing.stderr
    program = tmp_path / "twinedge"
    program.write_text("#!/bin/sh\necho \"$#: $1 $2\"\nexit 7\n")
    program.chmod(0o755)
    done = run(tmp_path, "audit", "a layer.shp")
    assert (done.returncode, done.stdout) == (7, "2: audit a layer.shp\n")
