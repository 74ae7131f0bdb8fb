"""free_of_gpl.py FREE... [-- GPL...]: what the Python package installs by default has nothing of GSL, FFTW and SuiteSparse: it links none
of their libraries nor ours that do, has none of their symbols, and none of the texts that they have where they are linked statically
and stripped. FREE, GPL: files, or folders whose programs and libraries are read. Each of GPL must be noticed, so that the test can
fail. Exits with 77 without readelf."""

import pathlib
import re
import shutil
import subprocess
import sys

NAMES = re.compile(
    r"lib(roughcontact-surface|roughcontact-flow|fftw|gsl|cholmod|amd|camd|colamd|ccolamd|metis|suitesparse|umfpack|spqr|klu|btf|cxsparse|ldl)"
)
SYMBOLS = re.compile(r"^_*(fftwf?l?q?_|gsl_|cholmod_|amd_|camd_|colamd_|ccolamd_|SuiteSparse)")
TEXTS = (b"fftw_codelet", b"fftwf_codelet", b"gsl: %s", b"cholmod_allocate_work")


def files_of(places):
    for place in map(pathlib.Path, places):
        inside = [file for file in sorted(place.rglob("*")) if file.is_file()] if place.is_dir() else [place]
        found = [file for file in inside if file.read_bytes()[:4] == b"\x7fELF"]
        assert found, f"{place} has no program and no library"
        yield from found


def said(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def found_in(file):
    """What of those libraries is in a file, in words."""
    needed = re.findall(r"\(NEEDED\).*\[(.*)\]", said("readelf", "-dW", file))
    symbols = {line.split()[7].partition("@")[0] for line in said("readelf", "-sW", file).splitlines() if len(line.split()) > 7}
    content = file.read_bytes()
    return (
        [name for name in [file.name, *needed] if NAMES.match(name)]
        + sorted(filter(SYMBOLS.match, symbols))[:3]
        + [text.decode() for text in TEXTS if text in content]
    )


def main():
    if not shutil.which("readelf"):
        print("skipped: no readelf (Debian: binutils)")
        return 77
    places = sys.argv[1:]
    split = places.index("--") if "--" in places else len(places)
    free, gpl = list(files_of(places[:split])), list(files_of(places[split + 1 :]))
    wrong = [f"{file} has {', '.join(found)}" for file in free for found in [found_in(file)] if found]
    wrong += [f"{file} links a library under the GPL, which is not noticed" for file in gpl if not found_in(file)]
    print(
        "\n".join(wrong)
        or f"{len(free)} files are free of the GPL: {', '.join(file.name for file in free)}; {len(gpl)} are not"
    )
    return 1 if wrong else 0


sys.exit(main())
