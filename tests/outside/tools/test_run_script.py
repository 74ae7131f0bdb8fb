"""./run.sh with a surface: what it asks the command to do. Building and the command are stood in for."""
import os
import shutil
import subprocess
from pathlib import Path

import harness
from harness import CommandTest

SCRIPT = Path(__file__).resolve().parents[3] / "run.sh"


class RunScript(CommandTest):
    def setUp(self):
        super().setUp()
        shutil.copy(SCRIPT, self.folder)
        for folder in "backends bindings cmake formats include mpi packaging pkgconfig src surface tools".split():
            (self.folder / folder).mkdir()
        for file in ("CMakeLists.txt", "CMakePresets.json"):
            (self.folder / file).touch()
        for name, text in (("scripts/bootstrap.sh", ""), ("path/cmake", 'echo "[ 50%] made by $*"; echo "$*" >>built\n'), ("path/python3", "exit 1\n"), ("build-run/bin/roughcontact", 'printf "%s\\n" "$@"\n')):
            path = self.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("#!/bin/sh\n" + text)
            path.chmod(0o755)

    def ran(self, *arguments, code=0):
        path = dict(os.environ, PATH=str(self.folder / "path") + os.pathsep + os.environ["PATH"])
        done = subprocess.run(["./run.sh", *arguments], cwd=self.folder, env=path, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def asked(self, *arguments):
        done = self.ran(*arguments)
        return " ".join(done.stdout.splitlines())

    def test_a_surface_is_levelled_unless_told_otherwise(self):
        self.assertIn("solve s.x3p --remove plane --modulus", self.asked("s.x3p"))
        self.assertIn("solve s.x3p --E 210GPa --nu 0.3 --remove plane", self.asked("s.x3p", "--E", "210GPa", "--nu", "0.3"))
        for stated in (["--remove", "none"], ["--remove=quadric"]):
            self.assertNotIn("--remove plane", self.asked("s.x3p", "--E", "210GPa", *stated))

    def test_without_a_surface_it_answers_a_question(self):
        (self.folder / "build-run/bin/roughcontact").write_text(
            '#!/bin/sh\nmkdir -p build-run/demo/out\necho "$@"\n'
            'printf "step,load [N],mean_pressure [Pa],area_fraction,max_pressure [Pa]\\n1,1,20000,.05,1e6\\n2,2,1e5,.25,1.3e6\\n" >build-run/demo/out/steps.csv\n')
        said = self.asked()
        self.assertNotIn("--remove", said)
        self.assertTrue(said.endswith("5 % under 20 kPa, 25 % under 100 kPa; the largest pressure is 1.3 MPa."), said)

    def test_it_builds_once_and_again_after_a_change(self):
        self.assertIn("compiling: 50 %", self.asked("s.x3p"))
        builds = (self.folder / "built").read_text()
        self.assertIn("--target roughcontact_command rcb_fft\n", builds)
        self.assertNotIn("compiling", self.asked("s.x3p"))
        self.assertEqual((self.folder / "built").read_text(), builds)
        self.asked("s.x3p", "--backend", "dense")
        self.assertIn("roughcontact_python", (self.folder / "built").read_text())
        (self.folder / "src/new.cpp").touch()
        self.assertIn("compiling", self.asked("s.x3p", "--backend", "dense"))

    def test_a_failed_build_says_why_and_presses_nothing(self):
        (self.folder / "path/cmake").write_text("#!/bin/sh\necho 'x.cpp:1: error: no'\nexit 1\n")
        done = self.ran("s.x3p", code=1)
        self.assertIn("x.cpp:1: error: no", done.stdout)
        self.assertNotIn("solve", done.stdout)

    def test_one_option_keeps_the_other_defaults(self):
        modulus, pressure = "--modulus 1e11", "--pressure 5e7,5e8,2e9"
        for arguments, kept, replaced in (
                (["s.npy", "--pitch", "39nm"], [modulus, pressure, "--unit um", "--remove plane"], "--pitch 1"), (["s.npy", "--pitch=39nm"], [modulus, "--unit um"], "--pitch 1"),
                (["s.npy", "--unit", "nm"], [modulus, pressure, "--pitch 1"], "--unit um"), (["s.xyz", "--load", "1mN"], [modulus, "--unit um"], "--pressure"),
                (["s.x3p", "--E", "3GPa", "--nu=.4"], [pressure], "--modulus"), (["s.x3p", "--area", "10%"], [modulus], "--pressure"),
                (["--load", "1mN"], ["--E 10MPa --nu 0.5"], "--pressure"), (["--boundary", "free"], ["--pressure 20kPa,50kPa,100kPa", "--boundary free"], "--load")):
            with self.subTest(arguments):
                said = self.asked(*arguments)
                for option in kept:
                    self.assertIn(option + " ", said + " ")
                self.assertNotIn(replaced + " ", said + " ")

    def test_help_builds_nothing(self):
        for arguments in (["--help"], ["-h"], ["s.x3p", "--help"]):
            self.assertIn("./run.sh [SURFACE] [OPTIONS", self.asked(*arguments))
        self.assertFalse((self.folder / "built").exists())

    def test_a_page_if_it_is_asked_for(self):
        self.assertIn("the same with --page", self.asked("s.x3p", "--modulus", "210GPa"))
        self.assertIn("pip install jinja2 numpy plotly", self.ran("s.x3p", "--page", code=1).stderr)
        python = self.folder / "path/python3"
        python.write_text('#!/bin/sh\n[ "$1" = -c ] || printf "%s\\n" "$@" >page\n')
        for out in (["--out", "folder"], ["--out=folder"]):
            said = self.asked("s.x3p", "--modulus", "210GPa", *out, "--resume", "--quiet", "--load", "1mN,2mN", "--page")
            self.assertIn("page: folder/report.html", said)
            self.assertIn("roughcontact_request", (self.folder / "built").read_text())
            self.assertEqual((self.folder / "page").read_text().split(),
                             "-m roughcontact report folder --out folder/report.html".split())
        (self.folder / "page").unlink()
        (self.folder / "build-run/bin/roughcontact").write_text("#!/bin/sh\nexit 1\n")
        self.ran("s.x3p", "--page", code=1)
        self.assertFalse((self.folder / "page").exists())


if __name__ == "__main__":
    harness.main()
