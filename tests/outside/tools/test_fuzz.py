"""Damaged surface files: `roughcontact` must answer each with an exit code of its own, never with a crash."""
import io
import random

import harness
from harness import CommandTest, gsf, np, rough

RUNS = 2000
NUMBERS = [b"0", b"-1", b"1", b"2", b"65536", b"2147483648", b"4294967297", b"9223372036854775807", b"99999999999999999999999", b"1e308", b"nan", b""]


def mutate(data, random):
    """A few edits near the beginning, where the headers are."""
    data = bytearray(data)
    for _ in range(random.randint(1, 4)):
        at = min(int(random.expovariate(1 / 60)), len(data))
        kind = random.randrange(5)
        if kind == 0:
            data[at : at + 1] = bytes([random.randrange(256)])
        elif kind == 1:
            del data[at : at + random.randint(1, 12)]
        elif kind == 2:
            data[at:at] = bytes(random.choices(b"0123456789-+.eE(){}',:=#;\n\0 ", k=random.randint(1, 8)))
        elif kind == 3:
            del data[random.randrange(len(data) + 1) :]
        else:
            digits = [i for i, c in enumerate(data[:200]) if chr(c).isdigit()]
            if digits:
                at = random.choice(digits)
                data[at : at + 1] = random.choice(NUMBERS)
    return bytes(data)


class Fuzz(CommandTest):
    def test_mutated_files(self):
        z = rough(6, 8)
        array = io.BytesIO()
        np.save(array, z)
        text = "# Width: 8.0 um\n# Height: 6.0 um\n# Value units: m\n" + "\n".join("\t".join("%.6g" % v for v in row) for row in z)
        seeds = [("a.gsf", gsf(z, 1e-6, 1e-6, "XYUnits = m\nZUnits = m\n")), ("a.npy", array.getvalue()), ("a.txt", text.encode())]
        chance = random.Random(20)
        codes = {0: 0, 1: 0, 2: 0}
        for run in range(RUNS):
            name, data = seeds[run % len(seeds)]
            mutated = mutate(data, chance)
            done = self.run_command("solve", self.file(name, mutated), "--pitch", "1e-6", "--modulus", "1e9", "--approach", "1e-8", "--quiet", timeout=30)
            self.assertIn(done.returncode, codes, (run, mutated, done.stderr))
            codes[done.returncode] += 1
            if done.returncode == 1:
                self.assertEqual(done.stderr.count("\n"), 1, (run, mutated, done.stderr))
        print("exit codes:", codes)


if __name__ == "__main__":
    harness.main()
