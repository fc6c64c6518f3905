"""``python -m twinedge`` runs the program ``twinedge``, with its arguments and its exit status."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import sysconfig


def _program() -> str | None:
    """The program beside Python, as in a virtual environment, or else the one on the path."""
    here = os.pathsep.join([sysconfig.get_path("scripts"), os.path.dirname(sys.executable)])
    return shutil.which("twinedge", path=here) or shutil.which("twinedge")


def main() -> int:
    program = _program()
    if program is None:
        print("twinedge: the program is not installed: `cargo install --path crates/cli` does it", file=sys.stderr)
        return 2
    arguments = [program, *sys.argv[1:]]
    if os.name == "posix":
        sys.stdout.flush()
        os.execv(program, arguments)
    return subprocess.run(arguments, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
