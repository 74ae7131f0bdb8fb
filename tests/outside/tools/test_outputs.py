"""Every output option of the command on everything that a name can be of: what is written is whole, anything else is refused with a
message, and nothing else is changed."""
import contextlib
import fcntl
import json
import os
import re
import resource
import signal
import socket
import stat
import subprocess

import harness
from harness import CommandTest, rough

INPUTS = {"--against", "--law", "--steps"}  # options whose value is a file that is read
MAKE = ["--pitch", "1um", "--modulus", "1GPa", "--boundary", "periodic", "--pressure", "1kPa..1MPa", "--tolerance", "10%", "--quiet"]
LAW = ["law", "a.law", "--quiet"]
SHAPES = {"sphere": ["--radius", "1"], "waves": ["--period", "8"], "pyramids": ["--period", "8"]}
PNG = b"\x89PNG\r\n\x1a\n"
NOBODY = 65534

# Each output option: command lines that write FILE, and what the file begins with.
ROWS = {
    ("analyze", "--json"): [(["analyze", "z.npy", "--pitch", "1um", "--json", "FILE"], b"{")],
    ("analyze", "--picture"): [(["analyze", "z.npy", "--pitch", "1um", "--picture", "FILE"], PNG)],
    ("law", "--output"): [(["law", "z.npy", *MAKE, "-o", "FILE"], b"roughcontact-law 1\n")],
    ("law", "--export"): [([*LAW, "--export", "csv=FILE"], b""), ([*LAW, "--export", "calculix=FILE", "--deck-units", "um,N"], b"*"),
                          ([*LAW, "--export", "abaqus=FILE"], b""),
                          ([*LAW, "--export", "moose=FILE"], b""), ([*LAW, "--export", "table=FILE"], b"")],
    ("law", "--json"): [([*LAW, "--json", "FILE"], b"{")],
    ("law", "--picture"): [([*LAW, "--picture", "FILE"], PNG)],
    ("solve", "--out"): [],  # a folder, see below
    **{("generate %s" % kind, "--output"): [(["generate", kind, "--levels" if kind == "rmd" else "--size", "5" if kind == "rmd" else "32", *SHAPES.get(kind, []),
                                              "--output", "FILE" + ending], begin) for ending, begin in ((".gsf", b"Gwyddion"), (".npy", b"\x93NUMPY"))]
       for kind in ("rmd", "spectral", "sphere", "waves", "pyramids", "noise")},
}
FORMS = [form for (command, _), forms in ROWS.items() for form in forms[: None if command == "generate noise" else 0 if command.startswith("generate") else 1]]


def nobody(limit=None):
    """For preexec_fn: a user who owns nothing, whose files have at most this many bytes."""
    if limit is not None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
    elif os.getuid() == 0:
        os.setgroups([])
        os.setgid(NOBODY)
        os.setuid(NOBODY)


def ending_of(form):
    """What the names of its files must end with."""
    return next(word.split("FILE")[1] for word in form if "FILE" in word)


class Outputs(CommandTest):
    in_memory = True

    def setUp(self):
        super().setUp()
        self.npy(rough(32, 32, rms=5e-8), "z.npy")
        (self.folder / "bin").mkdir()
        self.environment = self.with_gnuplot("printf '\\211PNG\\r\\n\\032\\n picture IEND\\256B`\\202'\n", "bin")  # gnuplot takes long
        self.assertEqual(self.run_command("law", "z.npy", *MAKE, "-o", "a.law").returncode, 0)
        (self.folder / "there").mkdir()
        os.umask(0o022)

    def written(self, form, name, **settings):
        settings.setdefault("env", self.environment)
        return self.run_command(*(word.replace("FILE", name) for word in form), **settings)

    def each_form(self, forms=FORMS):
        """(command line, name of its file, its beginning), in a folder that is empty at the start."""
        there = self.folder / "there"
        for form, begin in forms:
            yield form, there / ("a" + ending_of(form)), begin
            there.chmod(0o755)
            for path in there.iterdir():
                path.rmdir() if path.is_dir() and not path.is_symlink() else path.unlink()

    def state(self):
        """All that is in the folders: kind, permissions, and contents or target."""
        def of(path):
            kind = path.lstat().st_mode
            return kind, os.readlink(path) if stat.S_ISLNK(kind) else path.read_bytes() if stat.S_ISREG(kind) else b""
        return {str(path): of(path) for path in self.folder.rglob("*")}

    def assert_writes(self, form, path, begin, target=None, **settings):
        """Only the target is new or another; returns it."""
        before = self.state()
        done = self.written(form, "there/a", **settings)
        self.assertEqual(done.returncode, 0, (form, done.stderr))
        after, target = self.state(), str(target or path)
        contents = after.pop(target)[1]
        before.pop(target, None)
        self.assertEqual(after, before)
        self.assertTrue(contents.startswith(begin) and len(contents) > 20, contents[:40])
        return contents

    def assert_refuses(self, form, says, first="", **settings):
        before = self.state()
        done = self.written(form, "there/a", **settings)
        self.assertEqual(done.returncode, 1, (form, done.stderr))
        self.assertRegex(done.stderr, r"roughcontact: %s.*there/a.*%s" % (first, says))
        self.assertEqual(self.state(), before)

    def test_every_output_option_has_a_row(self):
        manual = self.run_command("manual").stdout.replace("\\-", "-")
        found, command = set(), ""
        for line in manual.splitlines():
            heading = re.match(r'\.SS "(.*)"', line)
            command = heading[1] if heading else command
            option = re.match(r"\.B (?:-\w,)?(--[\w-]+) (\S*=?FILE|DIR|FOLDER|PATH)\b", line)
            if option and option[1] not in INPUTS:
                found.add((command, option[1]))
        self.assertEqual(found, set(ROWS))

    def test_new_and_old_files(self):
        for form, path, begin in self.each_form([form for forms in ROWS.values() for form in forms]):
            new = self.assert_writes(form, path, begin)
            self.assertEqual(stat.S_IMODE(path.stat().st_mode), 0o644)
            for mode in (0o600, 0o664):
                path.write_text("old")
                path.chmod(mode)
                self.assertEqual(self.assert_writes(form, path, begin), new)
                self.assertEqual(stat.S_IMODE(path.stat().st_mode), mode)

    def test_long_names(self):
        for form, path, begin in self.each_form():
            name = "there/" + "n" * 250
            done = self.written(form, name)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_links_stay(self):
        for form, path, begin in self.each_form():
            target = self.folder / "there/target"
            (self.folder / "there/second").symlink_to(target)
            for link in ("target", str(target), "second", "../there/second"):
                for old in (True, False):  # or the link leads nowhere
                    path.symlink_to(link)
                    if old:
                        target.write_text("old")
                    self.assert_writes(form, path, begin, target)
                    target.unlink()
                    path.unlink()

    def test_what_cannot_be_written_is_refused(self):
        """Streams that take nothing before any work is done: the message names the option."""
        def socket_at(path):
            with socket.socket(socket.AF_UNIX) as server:
                server.bind(str(path))

        def links_to(link):
            return lambda path: path.symlink_to(link or path.name)

        option = r"--\S+.*: cannot write "
        kinds = (
            (links_to("missing/target"), "", "its folder is missing"), (links_to(""), "", "symbolic links"), (links_to("/dev/full"), "", "No space left"),
            (links_to("/dev/fd/99"), option, "Bad file descriptor"), (links_to("/proc/self/fd/0"), option, "this stream is open for reading only"),
            (os.mkdir, "", "it is a folder"), (socket_at, "", "it is a socket"), (os.mkfifo, "", "nobody reads this pipe"),
            (lambda path: os.mknod(path, 0o666 | stat.S_IFBLK, os.makedev(240, 250)), "", "it is a block device"))
        for form, path, begin in self.each_form():
            for make, first, says in kinds:
                try:
                    make(path)
                except PermissionError:
                    continue
                with self.subTest(form=form, says=says), open(self.folder / "z.npy", "rb") as readable:
                    self.assert_refuses(form, says, first, stdin=readable, timeout=60)
                path.rmdir() if path.is_dir() else path.unlink()

    def test_devices_are_written_to(self):
        for form, path, begin in self.each_form():
            try:
                os.mknod(path, 0o666 | stat.S_IFCHR, os.makedev(1, 3))
                os.close(os.open(path, os.O_WRONLY))
            except OSError:
                self.skipTest("no device of one's own")
            before, done = self.state(), self.written(form, "there/a")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(self.state(), before)

    def test_pipes(self):
        for form, path, begin in self.each_form():
            plain = self.assert_writes(form, path, begin)
            path.unlink()
            os.mkfifo(path)
            before, reader = self.state(), os.open(path, os.O_RDONLY | os.O_NONBLOCK)
            fcntl.fcntl(reader, 1031, 1 << 20)  # F_SETPIPE_SZ: nobody reads until all is written
            done, received = self.written(form, "there/a"), os.read(reader, 1 << 20)
            os.close(reader)
            self.assertEqual((done.returncode, received), (0, plain), done.stderr)
            self.assertEqual(self.state(), before)

    def test_open_streams(self):
        for form, path, begin in self.each_form():
            plain = self.assert_writes(form, path, begin)
            path.unlink()
            for stream in ("/dev/stdout", "/proc/self/fd/1", "/dev/fd/1"):
                path.symlink_to(stream)
                done = subprocess.run([harness.COMMAND, *(word.replace("FILE", "there/a") for word in form)], cwd=self.folder, env=self.environment, capture_output=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn(plain, done.stdout)
                log = self.folder / "log"
                log.write_text("earlier\n")
                number = log.stat().st_ino
                with open(log, "ab") as out:
                    subprocess.run([harness.COMMAND, *(word.replace("FILE", "there/a") for word in form)], cwd=self.folder, env=self.environment, stdout=out, check=True)
                self.assertTrue(log.read_bytes().startswith(b"earlier\n") and plain in log.read_bytes())
                self.assertEqual(log.stat().st_ino, number)
                log.unlink()
                self.assertEqual(os.readlink(path), stream)
                path.unlink()

    def test_a_limit_of_file_sizes(self):
        for form, path, begin in self.each_form():
            for old in (False, True):
                if old:
                    path.write_text("old")
                if begin != PNG:  # which another program writes, see below
                    self.assert_refuses(form, "File too large", preexec_fn=lambda: nobody(256), restore_signals=False)

    def test_no_permission(self):
        self.folder.chmod(0o755)
        if not self.nobody_starts():
            self.skipTest("the command cannot be started by another user")
        for form, path, begin in self.each_form():
            path.parent.chmod(0o555)
            self.assert_refuses(form, "Permission denied", preexec_fn=nobody)
            path.write_text("old")
            path.chmod(0o666)
            self.assert_refuses(form, "Permission denied", preexec_fn=nobody)
            path.parent.chmod(0o777)
            path.chmod(0o444)
            self.assert_refuses(form, "Permission denied", preexec_fn=nobody)

    def nobody_starts(self):
        with contextlib.suppress(PermissionError):  # a folder above is another user's alone
            return self.run_command("--version", preexec_fn=nobody).returncode == 0

    def test_the_owner_stays_and_a_group_that_cannot(self):
        """The rights of a group do not go to the members of another one."""
        self.folder.chmod(0o755)
        if os.getuid() != 0 or not self.nobody_starts():
            self.skipTest("the command cannot be started by another user")
        for form, path, begin in self.each_form():
            path.parent.chmod(0o777)
            path.write_text("old")
            os.chown(path, NOBODY, NOBODY)
            self.assert_writes(form, path, begin)
            self.assertEqual((path.stat().st_uid, path.stat().st_gid), (NOBODY, NOBODY))
            for mode, kept in ((0o660, 0o600), (0o664, 0o644), (0o600, 0o600)):
                path.write_text("old")
                os.chown(path, NOBODY, 12345)
                path.chmod(mode)
                self.assertEqual(self.written(form, "there/a", preexec_fn=nobody).returncode, 0)
                written = path.stat()
                self.assertEqual((written.st_gid, oct(written.st_mode & 0o777)), (NOBODY, oct(kept)))

    def test_a_picture_that_is_cut_off(self):
        self.file("bin/gnuplot", "#!/bin/sh\nprintf '\\211PNG\\r\\n\\032\\n half a picture'\n")
        for form in (form for form, begin in FORMS if begin == PNG):
            before, done = self.state(), self.written(form, "there/a")
            self.assertEqual((done.returncode, "cut off" in done.stderr), (1, True), done.stderr)
            self.assertEqual(self.state(), before)

    def test_inputs_are_not_overwritten(self):
        (self.folder / "there/a").symlink_to(self.folder / "z.npy")
        for option in ("--json", "--picture"):
            self.assert_refuses(["analyze", "z.npy", "--pitch", "1um", option, "FILE"], "is read or written as another file")
        self.assert_fails("analyze", "z.npy", "--pitch", "1um", "--json", "x", "--picture", "./x", says="is read or written as another file")
        self.assert_fails("law", "z.npy", *MAKE, "--against", "y.npy", "-o", "y.npy", says="is read or written as another file")

    def test_the_folder_of_a_history(self):
        solve = ["solve", "z.npy", "--pitch", "1um", "--modulus", "1GPa", "--boundary", "free", "--load", "1uN", "--quiet", "--out", "FILE"]
        path = self.folder / "there/a"
        target = self.folder / "there/target"
        target.mkdir()
        path.symlink_to("target")
        self.assertEqual(self.written(solve, "there/a").returncode, 0)
        self.assertTrue(path.is_symlink() and (target / "summary.json").exists())
        (target / "elsewhere.json").write_bytes((target / "summary.json").read_bytes())
        (target / "summary.json").unlink()
        (target / "summary.json").symlink_to("elsewhere.json")
        self.assertEqual(self.written(solve, "there/a").returncode, 0)
        self.assertTrue((target / "summary.json").is_symlink())
        path.unlink()
        for make in (lambda: path.write_text("old"), lambda: os.mkfifo(path), lambda: path.symlink_to("nowhere"), lambda: path.symlink_to("/dev/null")):
            make()
            self.assert_refuses(solve, "", timeout=60)
            path.unlink()
        self.folder.chmod(0o755)
        (self.folder / "there").chmod(0o555)
        if self.nobody_starts():
            self.assert_refuses(solve, "Permission denied", preexec_fn=nobody)

    def test_names_that_are_not_text(self):
        odd = os.fsdecode(b"m\xfcll \xff'\"")
        os.rename(self.folder / "z.npy", self.folder / (odd + ".npy"))
        os.rename(self.folder / "a.law", self.folder / (odd + ".law"))
        for forms in ROWS.values():
            for form, begin in forms[:1]:
                words = [word.replace("z.npy", odd + ".npy").replace("a.law", odd + ".law") for word in form]
                name = "there/" + odd
                done = self.written(words, name)
                self.assertEqual(done.returncode, 0, done.stderr)
                contents = (self.folder / (name + ending_of(form))).read_bytes()
                self.assertTrue(contents.startswith(begin))
                if begin == b"{":
                    json.loads(contents)
        self.assertEqual(self.run_command("solve", odd + ".npy", "--pitch", "1um", "--modulus", "1GPa", "--boundary", "free", "--load", "1uN", "--out", "there/o" + odd,
                                          env=self.environment).returncode, 0)
        self.assertIn("npy", json.loads((self.folder / ("there/o" + odd) / "summary.json").read_text("utf-8"))["input"]["file"])
        for words in (["analyze", "no" + odd, "--json", "x"], ["analyze", odd + ".npy", "--pitch", "1um", "--json", "no/" + odd], ["law", "no" + odd + ".law"],
                      ["generate", "noise", "--output", odd]):
            done = self.run_command(*words)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)

    def test_what_is_no_file_of_a_law(self):
        (self.folder / "folder.law").mkdir()
        os.mkfifo(self.folder / "pipe.law")
        (self.folder / "zero.law").symlink_to("/dev/zero")
        with open(self.folder / "sparse.law", "wb") as file:
            file.truncate(1 << 40)
        with open(self.folder / "long.law", "wb") as file:
            file.write(b"roughcontact-law 1\n")
            file.truncate(1 << 40)
        (self.folder / "circle.law").symlink_to("circle.law")
        for name, says in (("folder.law", "it is a folder"), ("pipe.law", "it is a pipe"), ("zero.law", "it is a device"), ("sparse.law", "does not begin with"),
                           ("long.law", "more than the 4000000000"), ("circle.law", "Too many levels of symbolic links"), ("absent.law", "there is no such file")):
            self.assert_fails("law", name, says=[name, says], timeout=20)


if __name__ == "__main__":
    harness.main()
