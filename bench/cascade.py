"""Cascade multi-resolution, Algorithm 6 of Bemporad & Paggi (2015), as the solver cmr is told to read it."""
import re
from dataclasses import dataclass

import roughcontact as rc

FILTERS = ('subsample', 'mean', 'max')  # what a coarse point takes from its four heights


def options(kind='subsample', radius=2.0, levels=0, *, area='side', backend='fft', inner='polonsky-keer', certified):
    """radius: h of the area of influence, which counts sides (Algorithm 6) or diagonals (the text) of coarse cells. levels: grids, the given
    one included; 0: down to 16 points a side. certified 0: as published, without a look at the points that were left out."""
    return {'solver': 'cmr', 'backend': backend, 'cmr.inner': inner, 'cmr.area': area, 'cmr.radius': radius, 'cmr.levels': levels,
            'cmr.filter': kind, 'cmr.certified': certified}


@dataclass(frozen=True)
class Note:
    """What a certified cascade says of itself: points of the last trial set, candidates, rounds, points that were added."""
    kept: int = 0
    all: int = 0
    rounds: int = 0
    added: int = 0

    @property
    def share(self):
        return self.kept / self.all if self.all else 1

    @property
    def share_at_first(self):
        """n_p / n of the paper: before anything was added."""
        return (self.kept - self.added) / self.all if self.all else 1


def note(text):
    found = re.search(r'trial set (\d+) of (\d+) after (\d+) rounds(?:, (\d+) points added)?', text)
    return Note(*(int(number or 0) for number in found.groups())) if found else Note()


def verdict(scene, halvings):
    """How well the library says that a cascade can see the surface."""
    advice = rc.surface.cmr_advice(-scene.gap, halvings, scene.approach, pitch=scene.pitch)
    return {'trustworthy': int(advice.trustworthy), 'unresolved': advice.unresolved}
