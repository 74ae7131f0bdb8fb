"""Text files whose header names units in a line, at the columns, in both or nowhere, beside a unit from the caller: what every door
reads, or that it refuses."""

ROWS, COLUMNS, STEP = 4, 5, 2  # STEP: of the coordinates


def heights():
    return [[((3 * i + 5 * j) % 7) / 2 for i in range(COLUMNS)] for j in range(ROWS)]


def _points(separator, mark):
    rows = ((STEP * i, STEP * j, z) for j, row in enumerate(heights()) for i, z in enumerate(row))
    return "".join(separator.join(("%g" % value).replace(".", mark) for value in row) + "\n" for row in rows)


def _matrix(separator, mark):
    return "".join(separator.join(("%g" % z).replace(".", mark) for z in row) + "\n" for row in heights())


METRES = {"m": 1, "mm": 1e-3, "um": 1e-6, "nm": 1e-9, "\u00b5m": 1e-6, "\u03bcm": 1e-6, "\u00c5ngstr\u00f6m": 1e-10}


def cases():
    """(file's name, contents, the caller's unit, metres per unit of x, y and heights; None: refused)"""
    kinds = (("a.xyz", True, " ", "."), ("a.csv", True, ";", ","), ("a.txt", True, "\t", "."), ("b.csv", False, ";", ","), ("b.asc", False, "\t", "."))
    for name, points, separator, mark in kinds:
        numbers = (_points if points else _matrix)(separator, mark)
        columns = lambda form, x, z: separator.join(form % pair for pair in ((("X", x), ("Y", x), ("Z", z)) if points else [("Z%d" % k, z) for k in range(COLUMNS)])) + "\n"
        yield name, numbers, None, (1, 1)
        yield name, numbers, "um", (1e-6, 1e-6)
        for line in ("# Unit: um\n", "Units = um\n", "# lengths in um\n"):
            for given, found in ((None, (1e-6, 1e-6)), ("um", (1e-6, 1e-6)), ("mm", None)):
                yield name, line + numbers, given, found
        forms = ("%s [%s]", "%s (%s)", "%s / %s", "%s/%s", '"%s [%s]"', "# %s [%s]") if separator != " " else ("%s [%s]", "%s/%s")
        for form in forms:
            head = "# " + columns(form[2:], "mm", "um") if form[0] == "#" else columns(form, "mm", "um")
            for given, found in ((None, (1e-3, 1e-6)), ("nm", None)):
                yield name, head + numbers, given, found
        for unit in METRES:
            yield name, "Instrument 7\n\n" + columns("%s [%s]", unit, unit) + numbers, unit, (METRES[unit], METRES[unit])
        for line in ("# Unit: mm\n", "# z-unit: nm\n", "# Z [mm]\n"):
            yield name, line + columns("%s [%s]", "um", "um") + numbers, None, None
        yield name, "# z-unit: um\n" + columns("%s [%s]", "um", "um") + numbers, None, (1e-6, 1e-6)
        for unknown in ("furlong", "V", "deg"):
            yield name, columns("%s [%s]", "um", unknown) + numbers, None, None
            yield name, "# z-unit: %s\n" % unknown + numbers, None, None
            yield name, "# Unit: %s\n" % unknown + numbers, None, None
        yield name, "# taken in um at night\n" + numbers, None, None  # of what?
        yield name, "# taken in um at night\n" + numbers, "nm", (1e-9, 1e-9)
        if points:
            yield name, columns("%s [%s]", "deg", "um") + numbers, None, None
            yield name, separator.join(("X [um]", "Y [um]", "Z")) + "\n" + numbers, "nm", (1e-6, 1e-9)
            yield name, separator.join("XYZ") + "\n" + separator.join(("mm", "mm", "um")) + "\n" + numbers, None, (1e-3, 1e-6)
