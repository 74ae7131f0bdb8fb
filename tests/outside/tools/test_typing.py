"""Typing: completion in the shells, and the threads that nobody typed. (Suggestions: refusals.txt)"""
import os
import shutil
import subprocess
import unittest
from pathlib import Path

import harness
from harness import CommandTest, rough

SCRIPTS = Path(__file__).resolve().parents[3] / "tools" / "completions"


class Completion(CommandTest):
    def candidates(self, *words):
        done = self.run_command("complete", *words)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.split()

    def test_candidates(self):
        self.assertEqual(self.candidates("so"), ["solve", "solvers"])
        self.assertEqual(self.candidates("generate", "sp"), ["spectral", "sphere"])
        self.assertEqual(self.candidates("solve", "file", "--b"), ["--boundary", "--backend", "--budget"])
        self.assertEqual(self.candidates("solve", "--boundary", ""), ["free", "periodic", "periodic-x", "periodic-y"])
        self.assertEqual(self.candidates("solve", "--boundary=p"), ["--boundary=periodic", "--boundary=periodic-x", "--boundary=periodic-y"])
        self.assertEqual(self.candidates("solve", "--boundary", "=", "p"), ["--boundary=periodic", "--boundary=periodic-x", "--boundary=periodic-y"])
        self.assertEqual(self.candidates("solve", "--set", "greedy.i"), ["greedy.inner="])
        self.assertEqual(self.candidates("solve", "--set", "solver", "=", "haar"), ["solver=haar-cg"])
        self.assertEqual(self.candidates("solve", "--remove", "--resume", "--q"), ["--quiet"])
        self.assertEqual(self.candidates("solve", "--write", ""), ["vti", "netcdf", "hdf5"])
        self.assertEqual(self.candidates("law", "--export", "c"), ["csv=", "calculix="])
        self.assertEqual(self.candidates("law", "-o", "a", "--bulk", ""), ["auto", "none", "mean"])
        self.assertEqual(self.candidates("law", "-o", "--q"), [])  # a file
        self.assertIn("dense", self.candidates("solve", "--backend", ""))
        self.assertEqual(self.candidates("solve", "f"), [])  # a file
        self.assertEqual(self.candidates("generate", "sphere", "--pa"), ["--paraboloid"])

    def test_every_option_of_the_help(self):
        shown = self.run_command("solve", "--help").stdout
        for option in self.candidates("solve", "--"):
            self.assertIn(option, shown)

    def asked(self, shell, script):
        if not shutil.which(shell):
            raise unittest.SkipTest(shell + " is not installed")
        folder = os.pathsep.join([str(Path(harness.COMMAND).parent), os.environ["PATH"]])
        done = subprocess.run([shell, *script], cwd=self.folder, env=dict(os.environ, PATH=folder), capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.split()

    def in_bash(self, *words):
        listed = " ".join("'%s'" % word for word in words)
        return self.asked("bash", ["-c", """source '%s'; COMP_WORDS=(roughcontact %s); COMP_CWORD=%d; compopt() { :; }; _roughcontact
                                            printf '%%s\\n' "${COMPREPLY[@]}" """ % (SCRIPTS / "roughcontact.bash", listed, len(words))])

    def test_bash(self):
        self.asked("bash", ["-n", str(SCRIPTS / "roughcontact.bash")])
        self.assertEqual(self.in_bash("an"), ["analyze"])
        self.assertEqual(self.in_bash("solve", "--bou"), ["--boundary"])
        self.assertEqual(self.in_bash("solve", "--boundary", ""), ["free", "periodic", "periodic-x", "periodic-y"])
        self.assertEqual(self.in_bash("solve", "--boundary", "=", "fr"), ["free"])
        self.assertEqual(self.in_bash("solve", "--boundary", "="), ["free", "periodic", "periodic-x", "periodic-y"])
        self.assertEqual(self.in_bash("solve", "--set", "solver", "=", "haar"), ["haar-cg"])
        self.assertEqual(self.in_bash("solve", "file"), [])

    def test_zsh(self):
        self.asked("zsh", ["-n", str(SCRIPTS / "_roughcontact")])

    def test_fish(self):
        script = SCRIPTS / "roughcontact.fish"
        self.asked("fish", ["--no-execute", str(script)])
        self.assertEqual(self.asked("fish", ["-N", "-c", "source '%s'; complete -C 'roughcontact solve --boundary '" % script]), ["free", "periodic", "periodic-x", "periodic-y"])


class Threads(CommandTest):
    def threads_of(self, *arguments, **settings):
        """Threads that the running command has."""
        surface = self.npy(rough(512, 512))
        with self.start("solve", surface, "--pitch", "1e-6", "--modulus", "1e9", "--approach", "1e-7:4e-7:40", "--tol", "1e-12", *arguments, **settings) as process:
            for _ in range(3):
                process.stdout.readline()  # two lines of head, and the first step
            count = len(os.listdir("/proc/%d/task" % process.pid))
            process.kill()
        return count

    def test_cores(self):
        cores = os.sched_getaffinity(0)
        self.assertEqual((self.threads_of(), self.threads_of("--threads", "3")), (len(cores), 3))
        self.assertEqual(self.threads_of(env=dict(os.environ, OMP_NUM_THREADS="1, 4")), 1)
        self.assertEqual(self.threads_of(preexec_fn=lambda: os.sched_setaffinity(0, list(cores)[:1])), 1)


if __name__ == "__main__":
    harness.main()
