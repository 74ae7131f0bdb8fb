"""The words of request/words.def.

Written by scripts/bindings.py.
"""

#: {word: (form of its value, meaning)}
HELP = {
    "format": ("NAME", "File format, if neither contents nor extension shows it"),
    "height_range": ("LENGTH", "Height between 0 and the largest value of a TIFF or PNG of whole numbers"),
    "pitch": ("H or HX,HY", "Cell size of a map that has none"),
    "unit": ("UNIT", "Unit of lengths without a unit, among the words and in files: m (default), mm, um, nm, A"),
    "missing": ("RULE", "Missing points: reject (default), fill (interpolate) or exclude (from contact)"),
    "crop": ("X0..X1,Y0..Y1", "Region that is kept, from the edge of the first cell, or a margin"),
    "despike": (
        "K",
        "Take out points that are farther from the median around them than K times the median of such distances; 10 is "
        "usual",
    ),
    "remove": ("FORM", "Level the map first: none (default), mean, plane or quadric"),
    "against": ("FILE", "Second rough body: heights on the same grid, seen from the first, and added"),
    "mirror": ("AXES", "Turn the other body over: reverse it along x, y or xy"),
    "shift": ("DX,DY", "Move the other body; points without a partner are cut off"),
    "resample": ("METHOD", "Bring the other body onto the grid of the surface: linear or cubic (default: refuse other grids)"),
    "shape": ("SHAPE", "Nominal shape, added last: sphere:R=1mm, cylinder:R=1mm,axis=x or wedge:angle=5deg,axis=x"),
    "modulus": ("E*", "Contact modulus"),
    "E": ("E", "Young's modulus"),
    "nu": ("NU", "Poisson's ratio"),
    "E2": ("E", "Young's modulus of the other body (default: rigid)"),
    "nu2": ("NU", "Poisson's ratio of the other body"),
    "hardness": ("H", "Largest pressure; above it the surface yields (default: elastic)"),
    "layer": (
        "LAYER",
        "Coating of the half-space: thickness, modulus and Poisson's ratio; unless it is bonded to the half-space, "
        "base=rigid, interface=frictionless; the other body is rigid",
    ),
    "approach": ("TARGETS", "Approach from first touch of the highest point"),
    "load": ("TARGETS", "Normal force"),
    "pressure": ("TARGETS", "Mean pressure over the whole surface; of a law the range LOWER..UPPER"),
    "area": ("TARGETS", "Contact area, such as 10%; the load is searched"),
    "boundary": (
        "NAME",
        "periodic: the map is a sample of a larger surface; free: the body ends at its edges; periodic-x, periodic-y: "
        "it repeats along this axis only (default: as the map says; free with a shape; else periodic)",
    ),
}
