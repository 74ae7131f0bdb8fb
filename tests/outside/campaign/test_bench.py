"""`roughcontact-bench campaign` of the build that is the argument: the campaign has the numbers of rc_batch_solve. Times decide nothing."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

from packages import needed

needed("numpy", "tomllib", "pyarrow", "distributed")

with tempfile.TemporaryDirectory() as folder:
    out, program = pathlib.Path(folder) / "out.json", pathlib.Path(sys.argv[1]) / "bin/roughcontact-bench"
    command = [program, "campaign", "--quick", "--threads", "2", "--json", out]
    subprocess.run(command, check=True, env={**os.environ, "PYTHON": sys.executable})
    rows = json.loads(out.read_text(encoding="utf-8"))["campaigns"]
assert [(row["solves"], row["same"]) for row in rows] == [(8, "yes")] * 2, rows
assert all(row["campaign"] > row["batch"] > 0 for row in rows), rows
