"""stand_ins.py FOLDER: writes surfaces with the character of measured ones: a film with a roll-off, an anisotropic lay on oblong
pixels, machined grooves, and a self-affine patch whose steepest points are missing. The same heights in every run."""

import sys
from pathlib import Path

import numpy as np


def gsf(z, hx, hy, fields=""):
    """The bytes of a Gwyddion Simple Field."""
    ny, nx = z.shape
    header = "Gwyddion Simple Field 1.0\nXRes = %d\nYRes = %d\nXReal = %.17g\nYReal = %.17g\n%s" % (nx, ny, nx * hx, ny * hy, fields)
    head = header.encode("utf-8")
    return head + b"\0" * (4 - len(head) % 4) + z.astype("<f4").tobytes()


def rms_slope(z, hx, hy):
    return np.sqrt(np.nanmean((np.diff(z, axis=1) / hx)[1:] ** 2 + (np.diff(z, axis=0) / hy)[:, 1:] ** 2))


def spectral(shape, hx, hy, slope, density, seed):
    """Heights whose Fourier amplitudes are density(qx, qy), with random phases, scaled to an rms slope."""
    ny, nx = shape
    qx, qy = 2 * np.pi * np.fft.rfftfreq(nx, hx)[None, :], 2 * np.pi * np.fft.fftfreq(ny, hy)[:, None]
    noise = np.fft.rfft2(np.random.default_rng(seed).normal(size=shape))
    noise[0, 0] = 0
    z = np.fft.irfft2(noise * density(qx, qy), s=shape)
    return z * slope / rms_slope(z, hx, hy)


def power_law(q, hurst, rolloff):
    """Constant below the roll-off, then falling as a self-affine surface's amplitudes do."""
    return np.maximum(q, rolloff) ** -(1 + hurst)


def film():
    z = spectral((256, 256), 4e-8, 4e-8, 0.22, lambda qx, qy: power_law(np.hypot(qx, qy), 0.8, 2 * np.pi / 0.6e-6), 11)
    return z, 4e-8, 4e-8


def lay():
    z = spectral((160, 256), 5e-7, 2e-6, 0.005, lambda qx, qy: power_law(np.hypot(qx, 8 * qy), 0.7, 1e5), 12)
    return z, 5e-7, 2e-6


def grooves():
    n, pitch, period = 224, 4e-6, 149e-6
    x = np.arange(n) * pitch
    across = np.cos(np.pi / 6) * x[None, :] + np.sin(np.pi / 6) * x[:, None]
    cut = -np.abs(np.sin(np.pi * across / period)) ** 8
    z = spectral((n, n), pitch, pitch, 0.15, lambda qx, qy: power_law(np.hypot(qx, qy), 0.8, 1e5), 13)
    return 2e-5 * cut + z, pitch, pitch


def missing():
    z = spectral((192, 200), 1e-7, 1e-7, 0.18, lambda qx, qy: power_law(np.hypot(qx, qy), 0.6, 1e6), 14)
    steep = np.hypot(*np.gradient(z, 1e-7))
    z[steep > np.quantile(steep, 0.98)] = np.nan
    return z, 1e-7, 1e-7


def main(folder):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for make in (film, lay, grooves, missing):
        (folder / (make.__name__ + ".gsf")).write_bytes(gsf(*make()))


if __name__ == "__main__":
    main(sys.argv[1])
