"""roughcontact.mpi: answers as those of roughcontact, errors on every rank. Rank 0 prints what must not depend on the number of ranks."""
import numpy as np
from mpi4py import MPI

import roughcontact as rc
import roughcontact.mpi

WORLD = MPI.COMM_WORLD
NY, NX = 96, 64


def heights():
    y, x = np.mgrid[:NY, :NX]
    return 1e-7 * sum(np.cos(2 * np.pi * (k * x / NX + (7 - k) * y / NY) + k * k) / k for k in range(1, 7))


def gathered(mine):
    return np.concatenate(WORLD.allgather(mine))


def raised(kind, words, call, **arguments):
    """That every rank raises this."""
    try:
        call(**arguments)
    except kind as error:
        assert words in str(error), error
        return
    raise AssertionError(f'{words}: nothing was raised')


def main():
    system = rc.HalfSpace((NY, NX), pitch=1e-6, modulus=1e9, boundary="free")
    rows = rc.mpi.rows(system)
    assert sum(WORLD.allgather(rows.stop - rows.start)) == NY
    gap = rc.mpi.gap_from_heights(heights()[rows])
    assert gathered(gap).min() == 0
    with rc.mpi.Contact(system) as contact:
        found = contact.solve(undeformed_gap=gap, load=1e-4, want_gap=True)
        again = contact.solve(approach=found.approach)
        judged = contact.certify(found.pressure, load=1e-4)
        counts = contact.counts()
        raised(rc.ArgumentError, 'one of approach, load', contact.solve, undeformed_gap=gap)
        raised(rc.ShapeError, 'shape', contact.solve, undeformed_gap=np.zeros((NY + 1, NX)), load=1.0)
        last = WORLD.size - 1  # alone is wrong, and all get its error
        alone = gap[:-1] if WORLD.rank == last else gap
        raised(rc.ShapeError, f'rank {last}: undeformed_gap', contact.solve, undeformed_gap=alone, load=1.0)
        raised(rc.ShapeError, f'rank {last}: pressure', contact.certify, pressure=alone, load=1e-4)
        raised(rc.ArgumentError, 'rank 0: nothing presses', contact.solve, **({'load': 1.0} if WORLD.rank > 0 else {}))
        raised(rc.InfeasibleError, 'negative', contact.solve, undeformed_gap=gap, load=-1.0)
    raised(rc.ArgumentError, 'closed', contact.solve, load=1.0)
    raised(rc.OptionError, f'rank {last}: ', rc.mpi.Contact, system=system, options={'tol' if WORLD.rank < last else 'tal': 1e-7})
    raised(TypeError, 'unexpected keyword', rc.mpi.Contact, system=system, tolerance=1)

    pressure, deformed = gathered(found.pressure), gathered(found.gap)
    alone = rc.solve(heights(), pitch=1e-6, modulus=1e9, boundary="free", load=1e-4, want_gap=True, threads=1)
    assert found.status == again.status == judged.status == rc.Status.OK
    assert abs(pressure - alone.pressure).max() < 1e-5 * alone.pressure.max()
    assert abs(deformed - alone.gap).max() < 1e-5 * deformed.max()
    assert abs(found.approach / alone.approach - 1) < 1e-6 and abs(again.load / 1e-4 - 1) < 1e-6
    assert counts.products >= 0 and counts.transpositions >= 0
    if WORLD.rank == 0:
        print(found.contacts, found.approach.hex(), float(pressure.max()).hex(), float(deformed.max()).hex(), judged.contacts)


main()
