"""Small pictures for notebooks, made without other packages."""

import base64
import struct
import zlib
from typing import Optional

import numpy as np
from numpy.typing import NDArray

from ._arrays import Doubles
from ._blocks import largest

# Ground and colours of pressures from low to high, all of which are seen on the ground.
GROUND = (24, 26, 32)
COLOURS = np.array([[96, 64, 160], [200, 70, 110], [245, 140, 60], [255, 240, 170]], float)


def png(rgb: NDArray[np.uint8]) -> bytes:
    """The file of an image [rows, columns, 3]."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows, columns, _ = rgb.shape
    lines = b"".join(b"\0" + row.tobytes() for row in np.ascontiguousarray(rgb))
    head = struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b"")


def pressure_image(pressure: Doubles, width: int = 160) -> str:
    """An img element: where there is contact, and how much it carries; x to the right, y down, as in the command."""
    points = np.nan_to_num(np.atleast_2d(pressure))
    p = largest(points, -(-max(points.shape) // width))
    level = np.clip(p / (p.max() or 1.0), 0, 1) * (len(COLOURS) - 1)
    low = np.minimum(level.astype(int), len(COLOURS) - 2)
    rgb = COLOURS[low] + (level - low)[..., None] * (COLOURS[low + 1] - COLOURS[low])
    rgb[p <= 0] = GROUND
    data = base64.b64encode(png(rgb.astype(np.uint8))).decode()
    return f'<img src="data:image/png;base64,{data}" style="image-rendering: pixelated; width: {width}px" alt="pressure">'


def curve(x: Doubles, y: Doubles, width: int = 160, height: int = 110) -> Optional[str]:
    """An svg element with y over x; None where there is nothing to be seen."""
    seen = np.isfinite(x) & np.isfinite(y)
    if seen.sum() < 2:
        return None
    points = []
    for values, length in ((x[seen], width), (y[seen], height)):
        span = float(np.ptp(values)) or 1.0
        points.append(5 + (values - values.min()) / span * (length - 10))
    line = " ".join(f"{a:.1f},{height - b:.1f}" for a, b in zip(*points))
    return f'<svg width="{width}" height="{height}"><polyline points="{line}" fill="none" stroke="currentColor"/></svg>'
