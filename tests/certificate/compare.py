"""Holds `check.sql` beside `twinedge check`: certificates that are right, and each with one number changed.

    compare.py TWINEDGE ENGINE CHANGES FOLDER [PSQL ARGUMENTS...]
"""

import csv
import os
import random
import struct
import subprocess
import sys
import time

NIL = 0xFFFFFFFF

# From so many changes on, a map of the world is judged, too.
WORLD = 500

# Table and column, and the file that has the same; None if no file can say what a change of it says, as the key of a row.
FILES = {
    "half_edges": ["-", "half_edge_origin", "half_edge_twin", "half_edge_next", "half_edge_prev", "half_edge_boundary", "half_edge_rank", "half_edge_dart"],
    "vertices": ["-", "vertex_leaving", "vertex_isolated", "vertex_dart"],
    "boundaries": ["-", "boundary_face", "boundary_start", "boundary_vertex", "boundary_place"],
    "faces": ["-", "face_outer", "face_dart"],
    "entries": ["-", "-", "face_inner"],
    "sides": ["-", "-", "dart_twin", "dart_point", "dart_half_edge", "dart_ahead", "dart_face", "dart_rank"],
    "points": ["-", "point_x", "point_y"],
}
# The same, of a surface.
SURFACE_FILES = {
    "half_edges": [*FILES["half_edges"][:-1], "half_edge_turn", "half_edge_step", "half_edge_component"],
    "vertices": ["-", "vertex_leaving", "vertex_border"],
    "boundaries": ["-", "boundary_face", "boundary_start"],
    "faces": ["-", "face_outer"],
}
# Columns that are numbers and no links: NULL is not nil there.
NUMBERS = {"half_edge_rank", "half_edge_turn", "half_edge_step", "half_edge_component", "dart_ahead", "dart_face", "dart_rank", "point_x", "point_y", "half_edge_dart", "vertex_dart", "face_dart", "dart_twin", "dart_point"}


def in_duckdb(folder):
    import duckdb

    connection = duckdb.connect()
    statements = open(os.path.join(folder, "check.sql")).read()
    before = os.getcwd()
    os.chdir(folder)
    try:
        return connection.execute(statements).fetchall()
    finally:
        os.chdir(before)
        connection.close()


def in_psql(command):
    def run(folder):
        arguments = [*command, "-q", "-A", "-t", "-f", "check.sql"]
        printed = subprocess.run(arguments, cwd=folder, capture_output=True, text=True, check=True).stdout
        # The genus, the components and the holes of a surface are a row of three.
        rows = [line.split("|") for line in printed.splitlines() if line.count("|") == 1]
        return [(test, int(violations)) for test, violations in rows]

    return run


def in_spark():
    from pyspark.sql import SparkSession

    builder = SparkSession.builder.master("local[2]").config("spark.sql.shuffle.partitions", "2")
    for switch in ["spark.ui.enabled", "spark.ui.showConsoleProgress"]:
        builder = builder.config(switch, "false")
    spark = builder.getOrCreate()
    spark.sparkContext.setLogLevel("ERROR")

    def run(folder):
        # Views belong to a session, and paths to the folder in which Spark was started.
        session = spark.newSession()
        text = open(os.path.join(folder, "check.sql")).read().replace("(path '", f"(path '{os.path.abspath(folder)}/")
        lines = [line for line in text.splitlines() if not line.startswith("--")]
        statements = [one.strip().rstrip(";") for one in "\n".join(lines).split(";\n")]
        results = [session.sql(statement) for statement in statements if statement]
        return [(row.test, row.violations) for row in results[-1].collect()]

    return run


def certified(twinedge, engine, folder, arguments):
    subprocess.run([twinedge, "certify", *arguments, "--sql", engine, "-o", folder], check=True, stdout=subprocess.DEVNULL)


def check(twinedge, folder):
    return subprocess.run([twinedge, "check", folder], capture_output=True).returncode


def proved(folder):
    """The exit status of the checker that is proved in Coq; 3 if it is not built."""
    return subprocess.run(["proofs/coq/certified", folder], capture_output=True).returncode


def parquet_to_csv(parquet, path):
    import duckdb

    duckdb.sql(f"COPY (FROM '{parquet}') TO '{path}' (HEADER)")


def csv_to_parquet(path, parquet, kind="BIGINT"):
    import duckdb

    duckdb.sql(f"COPY (FROM read_csv('{path}', all_varchar = true) SELECT CAST(COLUMNS(*) AS {kind})) TO '{parquet}'")


def deny(parquet, number):
    """Makes the statistics of a file say 0 where they say this number."""
    with open(parquet, "rb") as file:
        content = file.read()
    end = len(content) - 8
    begin = end - int.from_bytes(content[end : end + 4], "little")
    said = struct.pack("<q", number)
    assert said in content[begin:end], "the file has no statistics"
    with open(parquet, "wb") as file:
        file.write(content[:begin] + content[begin:end].replace(said, bytes(8)) + content[end:])


def write_torus(path):
    """Writes a torus without two of its triangles, which have no vertex in common."""
    at = lambda x, y: 1 + x % 4 + 4 * (y % 4)
    squares = [[at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)] for x in range(4) for y in range(4)]
    triangles = [triangle for a, b, c, d in squares for triangle in ((a, b, c), (a, c, d))]
    with open(path, "w") as file:
        file.writelines(f"v {i} {i * i} 0\n" for i in range(16))
        file.writelines("f {} {} {}\n".format(*triangle) for i, triangle in enumerate(triangles) if i not in (0, 21))


class Changes:
    """Changes of one number of a certificate, in its tables and in its columns."""

    def __init__(self, folder, files, seed):
        self.folder = folder
        self.files = files
        self.random = random.Random(seed)
        self.tables = {}
        for table in files:
            csv_file, parquet = (os.path.join(folder, table + extension) for extension in (".csv", ".parquet"))
            if os.path.exists(parquet):
                parquet_to_csv(parquet, csv_file)
            if os.path.exists(csv_file):
                with open(csv_file) as file:
                    self.tables[table] = list(csv.reader(file))

    def path(self, column):
        return os.path.join(self.folder, column + (".i64" if column.startswith("point_") else ".u32"))

    def write_table(self, table, rows):
        csv_file, parquet = (os.path.join(self.folder, table + extension) for extension in (".csv", ".parquet"))
        with open(csv_file, "w") as file:
            csv.writer(file, lineterminator="\n").writerows(rows)
        if os.path.exists(parquet):
            csv_to_parquet(csv_file, parquet)

    def out_of_range(self, run):
        """Moves a point out of range, which the statistics of its file deny, and returns the tests that fail."""
        rows, far = self.tables["points"], 2**60
        moved = [list(row) for row in rows]
        moved[-1][1] = str(far)
        self.write_table("points", moved)
        deny(os.path.join(self.folder, "points.parquet"), far)
        failing = {test for test, violations in run(self.folder) if violations}
        self.write_table("points", rows)
        return failing

    def refuses_fractions(self, run):
        """Returns true if a table with a number that is no integer, which would be right if it were rounded, is not certified."""
        rows = self.tables["half_edges"]
        changed = [list(row) for row in rows]
        changed[-1][1] += ".25"
        csv_file, parquet = (os.path.join(self.folder, "half_edges" + extension) for extension in (".csv", ".parquet"))
        self.write_table("half_edges", rows)
        with open(csv_file, "w") as file:
            csv.writer(file, lineterminator="\n").writerows(changed)
        if os.path.exists(parquet):
            csv_to_parquet(csv_file, parquet, "DOUBLE")
        try:
            refuses = "integers_ok" in {test for test, violations in run(self.folder) if violations}
        except subprocess.CalledProcessError:
            refuses = True
        self.write_table("half_edges", rows)
        return refuses

    def one(self, judge):
        """Makes a change, calls judge(what, expressible), and takes it back."""
        table = self.random.choice([table for table, rows in self.tables.items() if len(rows) > 1])
        rows = self.tables[table]
        at, column = self.random.randrange(1, len(rows)), self.random.randrange(len(rows[0]))
        before = rows[at][column]
        near = int(before) if before else 0
        value = self.random.choice([None, 0, near + 1, max(near - 1, 0), self.random.randrange(len(rows)), 10**9])
        if (value is None and before == "") or str(value) == before:
            return False
        file = self.files[table][column]
        expressible = file != "-" and not (value is None and file in NUMBERS)
        changed = [list(row) for row in rows]
        changed[at][column] = "" if value is None else str(value)
        self.write_table(table, changed)
        right = None
        if expressible:
            right = open(self.path(file), "rb").read()
            # Entries and sides are in the order of their rows; all else has its number.
            row = at - 1 if table in ("entries", "sides") else int(rows[at][0])
            form, width = ("<q", 8) if file.startswith("point_") else ("<I", 4)
            number = struct.pack(form, NIL if value is None else value)
            with open(self.path(file), "wb") as out:
                out.write(right[: width * row] + number + right[width * (row + 1) :])
        judge(f"{table}.{rows[0][column]}, row {at}: {before} to {value}", expressible)
        self.write_table(table, rows)
        if right is not None:
            with open(self.path(file), "wb") as out:
                out.write(right)
        return True


def main():
    twinedge, engine, count, scratch, *psql = sys.argv[1:]
    run = {"duckdb": lambda: in_duckdb, "postgres": lambda: in_psql(psql), "spark": in_spark}[engine]()
    judged = refused = differences = by_proof = 0
    torus = os.path.join(scratch, "torus.obj")
    write_torus(torus)
    certificates = {
        "drawing": (["docs/parcels.geojson", "--snap", "auto"], FILES),
        "plane": (["docs/parcels.geojson", "--topology-only"], FILES),
        "surface": ([torus], SURFACE_FILES),
    }
    for name, (arguments, files) in certificates.items():
        folder = os.path.join(scratch, f"{engine}-{name}")
        certified(twinedge, engine, folder, arguments)
        failing = [row for row in run(folder) if row[1]]
        assert not failing, f"a certificate that is right fails in {engine}: {failing}"
        changes = Changes(folder, files, 1)
        assert changes.refuses_fractions(run), f"{engine} rounds what is no integer"
        if engine != "postgres" and name == "drawing":
            assert "drawing_readable" in changes.out_of_range(run), f"{engine} believes statistics that are false"

        def judge(what, expressible):
            nonlocal judged, refused, differences, by_proof
            failing = [row for row in run(folder) if row[1]]
            # A key that is another, or a number that is NULL, is in no file, and never right.
            status = check(twinedge, folder) if expressible else 1
            accepted = status == 0
            if expressible and (other := proved(folder)) != 3:
                by_proof += 1
                if other != status:
                    differences += 1
                    print(f"proofs/coq/certified: {what}: exit status {other}, and {status} of twinedge check")
            judged += 1
            refused += bool(failing)
            if bool(failing) == accepted:
                differences += 1
                print(f"{engine}: {what}: twinedge check {'accepts' if accepted else 'refuses'}, check.sql finds {failing}")

        made = 0
        while made < int(count) // len(certificates):
            made += changes.one(judge)
    print(f"{engine}: {judged} changes, {refused} refused, {differences} differences")
    print(f"proofs/coq/certified: {f'{by_proof} of them' if by_proof else 'not run: it is not built'}")
    status = differences > 0 or refused == 0 or refused == judged
    if int(count) < WORLD:
        sys.exit(status)
    folder = os.path.join(scratch, f"{engine}-world")
    certified(twinedge, engine, folder, ["tests/data/world-50m.geojson", "--snap", "auto"])
    start, processor = time.time(), time.process_time()
    failing = [row for row in run(folder) if row[1]]
    assert not failing, failing
    print(f"{engine}: world-50m with its drawing, {time.time() - start:.1f} s, {time.process_time() - processor:.1f} s of this process")
    sys.exit(status)


main()
