"""roughcontact through its C library: solver and backend auto, everything else as by default."""
import time

import numpy as np

from library import Contact, Library


def version(request):
    return Library(request['build']).version()


def options(request):
    return {'threads': request['threads'], 'tol': request['tol'], **request.get('options', {})}


def warm_up(request):
    gap = np.random.default_rng(1).random((64, 64))
    with Contact(Library(request['build']), 64, request['boundary'], **options(request)) as contact:
        contact.solve('load', 0.1, gap, np.zeros_like(gap))


class Code:
    def __init__(self, request, gap):
        self.request, self.gap, self.library = request, gap, Library(request['build'])
        self.contact = Contact(self.library, request['n'], request['boundary'], **options(request))
        self.pressure = np.zeros_like(gap)

    def solve(self):
        begun = time.perf_counter()
        self.result = self.contact.solve(self.request['control'], self.request['target'], self.gap, self.pressure)
        self.seconds = time.perf_counter() - begun
        return self.pressure

    def setup_inside(self):
        return max(0.0, self.seconds - self.result.seconds)

    def details(self):
        result = self.result
        return {'status': self.library.status_name(result.status), 'iterations': result.iterations,
                'products': result.applications, 'solver': result.solver.decode(), 'backend': result.backend.decode()}
