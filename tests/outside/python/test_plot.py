"""Pictures are drawn."""

import numpy as np
import pytest

import roughcontact as rc

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("agg")


def test_every_picture(rough, tmp_path):
    from matplotlib import pyplot

    result = rc.solve(rough, modulus=1e9, approach=8e-8)
    history = rc.history(rough, modulus=1e9, approach=[4e-8, 8e-8])
    figure, axes = pyplot.subplots(2, 3)
    drawn = [
        rc.plot.heights(rough, ax=axes[0, 0]),
        rc.plot.pressure(result, ax=axes[0, 1], si=False),
        rc.plot.patches(result, ax=axes[0, 2]),
        rc.plot.history(history, ax=axes[1, 0]),
        rc.plot.histogram(result.histogram(20), ax=axes[1, 1]),
        rc.plot.spectrum(rc.surface.psd(rough), rc.surface.power_law(rough), ax=axes[1, 2]),
    ]
    assert drawn == list(axes.ravel())
    figure.savefig(tmp_path / "all.png")
    assert (tmp_path / "all.png").stat().st_size > 10000
    figure.canvas.draw()
    assert "µm" in drawn[0].get_xticklabels()[1].get_text() and "m" not in drawn[1].get_xticklabels()[1].get_text()
    assert np.array_equal(drawn[3].lines[0].get_xdata(), history.approach)
    for ax in drawn[:3]:
        assert (ax.get_xlabel(), ax.get_ylabel()) == ("x", "y") and ax.yaxis_inverted() and ax.images[0].origin == "upper"
    assert (
        "µN" in drawn[2].get_title()
        and "certified\n0.46% of the points in contact" in drawn[1].get_title()
        and "patches" in drawn[2].get_title()
    )
    assert drawn[1].get_facecolor()[:3] == matplotlib.colors.to_rgb(rc.plot.DARK) and "2 of 2 steps" in drawn[3].get_title()
    assert len(rc.plot.heights(rough.heights, pitch=1.0).images) == 1  # on axes of its own
    pyplot.close("all")


def test_a_law_is_drawn_between_its_bounds(rough):
    from matplotlib import pyplot

    law = rc.law(rough, modulus=1e9, boundary="periodic", pressure=(1e5, 1e7), tolerance=0.01)
    figure, axes = pyplot.subplots(1, 3)
    for y, ax in zip(("pressure", "area_fraction", "conductance"), axes):
        assert law.plot(y=y, ax=ax, points=50) is ax
        figure.canvas.draw()
        assert ax.get_xlabel() == ("overclosure" if y == "pressure" else "pressure") and len(ax.collections) == 1
        assert (ax.get_xscale(), ax.get_yscale()) == ("log", "log") and ax.get_ylim()[1] < 1e12
    x, p = axes[0].lines[0].get_data()
    assert np.allclose(law(x), p) and np.array_equal(axes[0].lines[1].get_ydata(), law.nodes["p"][1:])
    assert "Pa" in axes[1].get_xticklabels()[1].get_text() and "nodes, p within" in axes[0].get_title()
    with pytest.raises(rc.ArgumentError, match="y is 'slope'"):
        law.plot(y="slope")
    pyplot.close("all")


@pytest.mark.parametrize("shape", [(48, 64), (16, 128)])
def test_rows_go_down_and_specks_are_seen(shape):
    """As in the command's pictures (tests/outside/tools/test_pictures.py): the first row on top, the contact brighter than its ground."""
    from matplotlib import pyplot

    surface = rc.surface.spectral(shape, pitch=1e-6, rms_height=1e-7, seed=3)
    result = rc.solve(surface, modulus=1e9, load=2e-5)
    touching = result.pressure > 0
    assert 0 < touching.mean() < 0.05 and not np.array_equal(touching, touching[::-1])
    figure, ax = pyplot.subplots(figsize=(9, 7))
    for draw in (rc.plot.pressure, rc.plot.patches):
        ax.clear()
        draw(result, ax=ax)
        ax.set_axis_on()
        figure.canvas.draw()
        pixels = np.asarray(figure.canvas.buffer_rgba())[..., :3].astype(float)
        box = ax.get_window_extent()
        left, top = box.x0, pixels.shape[0] - box.y1
        rows = (top + (np.arange(shape[0]) + 0.5) / shape[0] * box.height).astype(int)
        columns = (left + (np.arange(shape[1]) + 0.5) / shape[1] * box.width).astype(int)
        cells = pixels[np.ix_(rows, columns)]
        far = np.abs(cells - np.array(matplotlib.colors.to_rgb(rc.plot.DARK)) * 255).sum(2)
        assert np.array_equal(far > 60, touching)
    pyplot.close(figure)
