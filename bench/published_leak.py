"""The flow through gaps of isotropic rough surfaces beside the effective medium that has the same distribution of gaps. E* and the side are 1."""
import numpy as np
import roughcontact as rc

PRESSURES = (0.02, 0.05, 0.1, 0.15, 0.2)  # over E* slope


def available():
    """Whether libroughcontact-flow was built."""
    try:
        return bool(rc.flow_factors(np.ones((2, 2)), pitch=1).xx > 0)
    except rc.LibraryNotFoundError:
        return False


def effective_medium(conductivity):
    """Bruggeman 1935, in two dimensions: the s that a disc of the medium with each conductivity k changes by 0 in the mean, so the mean of
    (k - s) / (k + s) is 0. It vanishes where half of the area does not conduct."""
    low, high = 0.0, conductivity.max()
    while high - low > 1e-9 * high:
        s = (low + high) / 2
        low, high = (s, high) if np.mean((conductivity - s) / (conductivity + s)) > 0 else (low, s)
    return (low + high) / 2


def conducted(pressed, pressure):
    """{area, ours, medium, width}: conductivities over the cube of the mean gap, and the width of ours' proven interval over it"""
    result = pressed.at(pressure, want_gap=True)
    gap = np.where(result.pressure > 0, 0, np.maximum(result.gap, 0))
    found, cube = rc.flow_factors(gap, pitch=1 / len(gap)), gap.mean()**3
    ours = (found.xx + found.yy) / 2
    width = (found.xx_upper - found.xx_lower + found.yy_upper - found.yy_lower) / 2
    return {'area': result.area_fraction, 'ours': ours / cube, 'medium': effective_medium(gap**3) / cube, 'width': width / ours}
