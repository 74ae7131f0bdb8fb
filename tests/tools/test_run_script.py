"""./run.sh with a surface: what it asks the command to do. Building and the command are stood in for."""
import os
import shutil
import subprocess
from pathlib import Path

import harness
from harness import CommandTest

SCRIPT = Path(__file__).resolve().parents[2] / "run.sh"


class RunScript(CommandTest):
    def setUp(self):
        super().setUp()
        shutil.copy(SCRIPT, self.folder)
        for name, text in (("scripts/bootstrap.sh", ""), ("path/cmake", ""), ("build/bin/roughcontact", 'printf "%s\\n" "$@"\n')):
            path = self.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("#!/bin/sh\n" + text)
            path.chmod(0o755)

    def asked(self, *arguments):
        environment = dict(os.environ, PATH=str(self.folder / "path") + os.pathsep + os.environ["PATH"])
        done = subprocess.run(["./run.sh", *arguments], cwd=self.folder, env=environment, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        return " ".join(done.stdout.splitlines())

    def test_a_surface_is_levelled_unless_told_otherwise(self):
        self.assertIn("solve s.x3p --remove plane --modulus", self.asked("s.x3p"))
        self.assertIn("solve s.x3p --E 210GPa --remove plane", self.asked("s.x3p", "--E", "210GPa"))
        for told in (["--remove", "none"], ["--remove=quadric"]):
            self.assertNotIn("--remove plane", self.asked("s.x3p", "--E", "210GPa", *told))
        self.assertNotIn("--remove", self.asked())


if __name__ == "__main__":
    harness.main()
