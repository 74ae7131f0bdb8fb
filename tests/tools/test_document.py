"""The commands that docs/command-line.md shows, run as they stand."""
import re
from pathlib import Path

import harness
from harness import CommandTest, gsf, rough, without_gnuplot

DOCUMENT = Path(__file__).resolve().parents[2] / "docs" / "command-line.md"


class Document(CommandTest):
    def test_commands(self):
        blocks = re.findall(r"^```\n(.*?)^```", DOCUMENT.read_text(encoding="utf-8"), re.M | re.S)
        lines = [line for block in blocks for line in block.splitlines() if line.startswith("roughcontact ") and not re.search(r"\[options\]|\|", line)]
        self.assertGreater(len(lines), 4)
        self.file("surface.gsf", gsf(rough().astype("f4"), 1e-6, 1e-6, "XYUnits = m\nZUnits = m\n"))
        for line in lines:
            with self.subTest(line):
                done = self.run_command(*line.split("  ")[0].split()[1:], env=without_gnuplot(), timeout=300)
                self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    harness.main()
