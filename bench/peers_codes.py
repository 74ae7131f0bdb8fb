"""What is compared: the codes, their tolerances, and the problems. One run of a code is in a process of its own, so that its peak memory is this
code's. Each takes E* = 1 on the unit square; `request` has gap (a file), n, boundary, control, target, tol, threads, options, limit and out (a file)."""
import hashlib
import os
import resource
import time
from dataclasses import dataclass, field
from importlib.metadata import version as installed

import numpy as np

import native
from case import cpu_seconds, in_child, status_line
from contact import status_of, unit_square
from surfaces import asperity_band, influence, paraboloid_gap

LEVELS = (1e-4, 1e-6, 1e-8)  # of the certificate
SWEEP = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14)


@dataclass(frozen=True)
class Code:
    title: str
    family: str     # a key of RUNNERS
    package: str    # on the package index; '' for what this project builds
    look: str       # in pictures: a colour a code, a dash and a marker a variant
    boundaries: tuple = ('free',)
    controls: tuple = ('load',)
    tols: tuple = SWEEP  # its own tolerances, from loose to tight: the first whose answer is certified at the tightest level ends it
    options: dict = field(default_factory=dict)
    small: bool = False  # dense matrices only


def of_aspher(words, look, backend, precision='double', boundaries=('free',), **more):
    """In single precision its floor is 2e-6."""
    single = {'allow_tolerance_relaxation': True} if precision == 'float' else {}
    return Code(f'ASPHER, {words}', 'aspher', 'aspher', look, boundaries, ('load',), (1e-3, 1e-4, 1e-5, 2e-6) if single else SWEEP,
                {'backend': backend, 'precision': precision, **single, **more})


BOTH, EITHER = ('free', 'periodic'), ('load', 'approach')
CODES = {
    'ours': Code('roughcontact', 'ours', '', 'lc rgb "#000000" dt 1 pt 7', BOTH, EITHER, (1e-4, 1e-6, 1e-8)),
    'ours-float': Code('roughcontact, single', 'ours', '', 'lc rgb "#000000" dt 2 pt 6', tols=(1e-4,), options={'fft.precision': 'single'}),
    'baseline': Code('textbook Polonsky-Keer, padded FFTW', 'baseline', '', 'lc rgb "#777777" dt 1 pt 5', controls=EITHER, tols=(1e-8,)),
    'aspher-fft': of_aspher('fft, double', 'lc rgb "#D55E00" dt 1 pt 9', 'fft'),
    'aspher-h2': of_aspher('h2, double', 'lc rgb "#D55E00" dt (8,4) pt 11', 'h2', active_set=True),
    'aspher-fft-float': of_aspher('fft, float', 'lc rgb "#E69F00" dt 1 pt 8', 'fft', 'float'),
    'aspher-h2-float': of_aspher('h2, float', 'lc rgb "#E69F00" dt (8,4) pt 10', 'h2', 'float', active_set=True),
    'aspher-periodic': of_aspher('periodic, double', 'lc rgb "#D55E00" dt (2,3) pt 9', 'periodic', boundaries=('periodic',)),
    'tamaas': Code('Tamaas', 'tamaas', 'tamaas', 'lc rgb "#0072B2" dt 1 pt 13', ('periodic',)),
    'tamaas-free': Code('Tamaas, non-periodic operator', 'tamaas', 'tamaas', 'lc rgb "#0072B2" dt (8,4) pt 12'),
    'contactmechanics': Code('ContactMechanics', 'contactmechanics', 'ContactMechanics', 'lc rgb "#009E73" dt 1 pt 15', BOTH),
    'nnls': Code('scipy nnls, dense', 'nnls', 'scipy', 'lc rgb "#CC79A7" dt 1 pt 4', controls=EITHER[1:], tols=(0.0,), small=True),
    'osqp': Code('OSQP, dense', 'osqp', 'osqp', 'lc rgb "#56B4E9" dt 1 pt 6', controls=EITHER[1:], tols=(1e-4, 1e-6, 1e-8, 1e-10), small=True)}
LARGEST_MATRIX = 1500  # points: a dense matrix of the small problems


@dataclass(frozen=True)
class Case:
    surface: str    # a key of MAKERS
    n: int
    boundary: str
    control: str
    percent: float  # contact area wanted

    @property
    def key(self):
        return f'{self.surface}-{self.n}-{self.boundary}-{self.control}-{self.percent:g}'

    @property
    def title(self):
        names = {'rough': 'rough-H0.8', 'wavy': 'power law', 'sphere': 'Hertz'}
        return f'{names[self.surface]}, {self.n}², {self.percent:g} %, {self.boundary}, {self.control} control'

    def codes(self):
        """Codes that can solve it. Dense ones solve the smallest; ASPHER's grids are 64 times a power of two."""
        small = self.n * self.n <= LARGEST_MATRIX
        fits = self.n >= 64 and self.n & (self.n - 1) == 0
        return [name for name, code in CODES.items()
                if self.boundary in code.boundaries and self.control in code.controls and (small or not code.small) and
                (fits or code.family != 'aspher')]


SMALL_SIZES = (16, 24, 32, 38)
SHARES = (0.1, 1, 10, 50)  # of the points in contact, in percent


def cases(sizes, percents, quick, edges):
    """From cheap to expensive, so that what a budget cuts off is what costs most."""
    found = []
    for n in sorted(sizes or [*(SMALL_SIZES[2:3] if quick else SMALL_SIZES), *((256, 512) if quick else (512, 1024, 2048))]):
        if n * n <= LARGEST_MATRIX:
            found.append(Case('wavy', n, 'free', 'approach', 30))
            continue
        shares = percents or ((1, 10) if quick else SHARES)
        found += [Case('rough', n, 'free', 'load', percent) for percent in shares]
        found += [] if percents else [Case('rough', n, 'free', 'approach', 10)]
        found += [Case('wavy', n, 'periodic', 'load', percent) for percent in (percents or (10,) if quick else shares)]
    return [case for case in found if edges in ('', case.boundary)]


HURST, SEED, WAVES, SHORTEST, RMS = 0.8, 42, 12, 0.33, 0.02


def rough(n):
    """The workload rough-H0.8 of ASPHER: 12 waves a side up to a third of a wave per cell, at every n. Free boundaries."""
    try:
        import rfgen
    except ImportError:
        return asperity_band(n, SEED), 'own'
    heights = rfgen.selfaffine_field(dim=2, N=n, Hurst=HURST, k_low=WAVES / n, k_high=SHORTEST, plateau=False, noise=True,
                                     rng=np.random.default_rng(SEED), verbose=False)
    return -RMS / np.std(heights) * heights, 'rfgen'


def wavy(n):
    """Tamaas' generator: 4 waves a side, power law of exponent 0.8 up to 8 cells a wave. Periodic."""
    try:
        import tamaas
    except ImportError:
        return asperity_band(n, SEED), 'own'
    generator = tamaas.SurfaceGeneratorFilter2D([n, n])
    generator.spectrum = tamaas.Isopowerlaw2D()
    generator.spectrum.q0, generator.spectrum.q1, generator.spectrum.q2 = 4, 4, max(n // 8, 8)
    generator.spectrum.hurst, generator.random_seed = HURST, SEED
    heights = np.array(generator.buildSurface())
    return -RMS / np.std(heights) * heights, 'tamaas'


MAKERS = {'rough': rough, 'wavy': wavy, 'sphere': lambda n: (paraboloid_gap(n), 'exact')}  # radius 1, its top between the four middle cells


def write_surface(kind, n, folder):
    """The file of a gap, how it was made and what it holds."""
    gap, maker = MAKERS[kind](n)
    gap = np.ascontiguousarray(gap - gap.min(), dtype=np.float64)
    file = os.path.join(folder, f'{kind}-{n}-{maker}.npy')
    np.save(file + '.part.npy', gap)
    os.replace(file + '.part.npy', file)
    with open(file, 'rb') as source:
        digest = hashlib.blake2b(source.read(), digest_size=8).hexdigest()
    return {'file': file, 'maker': maker, 'digest': digest}


TWICE = 5  # seconds: faster solves are done again in the same process
PLANNING = 120  # seconds that FFTW_MEASURE may take for the padded transform, once a grid
START = 20  # seconds for imports and warm-up, beside the limit


class Runner:
    """Made before the clock of the solve starts. inside: set-up that the code does within its solving call [s]."""
    inside = 0.0

    def __init__(self, request, gap):
        self.request, self.gap, self.n = request, gap, request['n']


class Ours(Runner):
    """roughcontact: solver and backend auto, everything else as by default."""

    def __init__(self, request, gap):
        import roughcontact
        super().__init__(request, gap)
        self.version = '.'.join(map(str, roughcontact.version()))
        options = {'threads': request['threads'], 'tol': request['tol'], **request['options']}
        self.contact = roughcontact.Contact(unit_square(self.n, request['boundary']), options=options)

    def solve(self):
        begun = time.perf_counter()
        result = self.contact.solve(undeformed_gap=self.gap, borrow=True, check=False, **{self.request['control']: self.request['target']})
        self.inside = max(0.0, time.perf_counter() - begun - result.seconds)
        self.details = {'status': status_of(result), 'iterations': result.iterations, 'products': result.products, 'solver': result.solver,
                        'backend': result.backend}
        return result.pressure


class Aspher(Runner):
    """ASPHER: its nested solver, one call that builds the operators too. Load control, E* = 1, domain 1: pressures are ours."""

    def solve(self):
        import aspher
        settings = dict(self.request['options'])
        if settings['backend'] == 'h2':  # the parameters that its author's harness uses
            settings.update(dict(q=6, leaf_side=8) if self.n <= 4096 else dict(q=4, leaf_side=16))
        result = aspher.solve_nested(grid_size=self.n, gap=self.gap.ravel(), p_nominal=self.request['target'], domain_size=1.0, E_star=1.0,
                                     tol=self.request['tol'], light_result=True, **settings)
        self.version, self.inside = installed('aspher'), result.timings['build']
        self.details = {'status': str(result.status), 'iterations': result.iterations, 'products': result.matvec_count}
        return result.pressure


class Tamaas(Runner):
    """Tamaas: Polonsky-Keer-Rey. Heights are -gap, the target is the mean pressure, E = 1 with nu = 0 is E* = 1."""

    def __init__(self, request, gap):
        import tamaas
        super().__init__(request, np.negative(gap, out=gap))
        self.version = tamaas.__version__
        tamaas.set_log_level(tamaas.LogLevel.error)
        tamaas.initialize(request['threads'])
        self.model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [1.0, 1.0], [self.n, self.n])
        self.model.E, self.model.nu = 1.0, 0.0  # before the operator is registered, else it has another modulus
        self.solver = tamaas.PolonskyKeerRey(self.model, self.gap, request['tol'])
        self.solver.max_iter, self.solver.dump_freq = 100000, 1 << 30
        if request['boundary'] == 'free':
            tamaas.ModelFactory.registerNonPeriodic(self.model, 'free')
            self.solver.setIntegralOperator('free')
            self.model.operators['free'](self.model.traction, self.model.displacement)
        else:
            self.model.solveNeumann()  # makes the plans

    def solve(self):
        error = self.solver.solve(self.request['target'])
        self.details = {'status': 'converged' if error <= self.request['tol'] else f'error {error:.1e}'}
        return self.model.traction


class ContactMechanics(Runner):
    """ContactMechanics: its Polonsky-Keer solver. Works with forces per cell and heights -gap; `young` is E* for a half-space."""

    def __init__(self, request, gap):
        from ContactMechanics import FreeFFTElasticHalfSpace, PeriodicFFTElasticHalfSpace
        super().__init__(request, np.negative(gap, out=gap))
        self.version = installed('ContactMechanics')
        kind = FreeFFTElasticHalfSpace if request['boundary'] == 'free' else PeriodicFFTElasticHalfSpace
        self.substrate = kind((self.n, self.n), 1.0, (1.0, 1.0))
        self.substrate.evaluate_disp(np.zeros(self.substrate.nb_subdomain_grid_pts))

    def solve(self):
        from ContactMechanics.Optimization import constrained_conjugate_gradients
        load, tol = self.request['target'], self.request['tol']  # force: the domain's area is 1
        result = constrained_conjugate_gradients(self.substrate, self.gap, external_force=load, pentol=tol * float(np.std(self.gap)),
                                                 forcetol=tol * load / self.gap.size, thermotol=tol)
        self.details = {'status': result.message, 'iterations': result.nit, 'products': result.nfev}
        return result.jac * self.gap.size  # cells have the area 1/size


def love_matrix(n):
    """H of n x n cells of the unit square, contact modulus 1."""
    return influence('love', n) / n


class Nnls(Runner):
    """scipy.optimize.nnls (Lawson-Hanson): with H = L L', min |L'p - inv(L) u| over p >= 0 is the contact problem."""

    def __init__(self, request, gap):
        import scipy.linalg
        super().__init__(request, gap)
        self.version = scipy.__version__
        factor = scipy.linalg.cholesky(love_matrix(self.n), lower=True)
        self.right = scipy.linalg.solve_triangular(factor, request['target'] - gap.ravel(), lower=True)
        self.factor = np.ascontiguousarray(factor.T)

    def solve(self):
        import scipy.optimize
        self.details = {'status': 'solved'}
        return scipy.optimize.nnls(self.factor, self.right, maxiter=100 * self.right.size)[0]


class Osqp(Runner):
    """OSQP (ADMM for quadratic programs) with polishing: min 1/2 p'Hp - u'p over p >= 0, H as a full sparse matrix. Its tolerances are
    absolute too, so it gets cells of side 1 and penetrations of at most 1."""

    def __init__(self, request, gap):
        import osqp
        import scipy.sparse
        super().__init__(request, gap)
        right = request['target'] - gap.ravel()
        self.version, self.depth, self.problem = osqp.__version__, right.max(), osqp.OSQP()
        self.problem.setup(P=scipy.sparse.triu(love_matrix(self.n) * self.n, format='csc'), q=-right / self.depth,
                           A=scipy.sparse.identity(right.size, format='csc'), l=np.zeros(right.size), u=np.full(right.size, np.inf),
                           eps_abs=request['tol'], eps_rel=request['tol'], max_iter=100000, polishing=True, verbose=False)

    def solve(self):
        result = self.problem.solve(raise_error=False)
        self.details = {'status': result.info.status, 'iterations': result.info.iter}
        return np.maximum(result.x, 0) * (self.depth * self.n)


RUNNERS = {'ours': Ours, 'aspher': Aspher, 'tamaas': Tamaas, 'contactmechanics': ContactMechanics, 'nnls': Nnls, 'osqp': Osqp}


def forget_peak():
    """The peak counts from here; where that is not allowed, from the start of the process."""
    try:
        with open('/proc/self/clear_refs', 'w') as file:
            file.write('5')
    except OSError:
        pass


def peak():
    return status_line('/proc/self/status', 'VmHWM')


def timed(runner, request):
    """({set-up and solve}, pressures, the code) of one cold solve. A code may work in the gap it is given."""
    gap = np.load(request['gap'])
    begun = time.perf_counter()
    code = runner(request, gap)
    ready = time.perf_counter()
    pressure = code.solve()
    done = time.perf_counter()
    return {'setup_seconds': ready - begun + code.inside, 'solve_seconds': done - ready - code.inside}, pressure, code


def run_code(family, request):
    runner = RUNNERS[family]
    small = 128 if family == 'aspher' else 8 if family in ('nnls', 'osqp') else 64
    warm = request['gap'] + f'.warm-{small}.npy'
    np.save(warm, np.random.default_rng(1).random((small, small)))
    timed(runner, {**request, 'gap': warm, 'n': small, 'target': 0.1, 'tol': max(request['tol'], 1e-4)})
    forget_peak()
    start, cpu = peak(), cpu_seconds()
    seconds, pressure, code = timed(runner, request)
    highest, cpu = peak(), cpu_seconds() - cpu
    if sum(seconds.values()) < TWICE:  # plans and caches are warm for everyone
        del pressure, code
        seconds, pressure, code = timed(runner, request)
    np.save(request['out'], np.asarray(pressure, dtype=np.float64).reshape(request['n'], request['n']))
    return [{'version': code.version, **seconds, 'cpu_seconds': cpu, 'start_bytes': start, 'peak_bytes': highest, 'file': request['out'],
             **code.details, 'tol': request['tol']}]


def run_baseline(request, levels=LEVELS):
    """The textbook method gives the pressures at which each level of the residual was first met."""
    gap, reached = np.load(request['gap']), []
    forget_peak()
    # The caller's gap is there already; every code's memory counts it.
    start, cpu = peak() - gap.nbytes, cpu_seconds()

    def look(products, p, residual, seconds):
        # The certificate finds its own approach; half of the level leaves it room.
        while len(reached) < len(levels) and residual <= 0.5 * levels[len(reached)]:
            highest, file = peak(), f'{request["out"]}-{len(reached)}.npy'
            np.save(file, p)
            reached.append({'tol': levels[len(reached)], 'file': file, 'solve_seconds': seconds, 'iterations': products // 2, 'products': products,
                            'peak_bytes': highest})
        return len(reached) < len(levels) and seconds < request['limit']

    wisdom = os.path.join(os.path.dirname(request['out']), 'wisdom')
    setup, planning = native.polonsky_keer(gap, request['control'] == 'load', request['target'], request['threads'], PLANNING, wisdom, look)
    # Plans are warm for everyone: measuring them is not this method's set-up.
    shared = {'setup_seconds': setup - planning, 'planning_seconds': planning, 'start_bytes': start, 'cpu_seconds': cpu_seconds() - cpu}
    answers = [{**entry, **shared} for entry in reached]
    return answers if len(answers) == len(levels) else [*answers, {'error': f'over the limit of {request["limit"]:g} s'}]


def busy_seconds():
    """Processor time of everything on the machine; None where the system does not tell."""
    try:
        with open('/proc/stat') as stat:
            ticks = [int(word) for word in stat.readline().split()[1:]]
    except (OSError, ValueError):
        return None
    return (sum(ticks[:3]) + sum(ticks[5:8])) / os.sysconf('SC_CLK_TCK')


def solve(code, request, limit):
    """The answers of a run as a list, and the cores that others had busy meanwhile."""
    request = {**request, 'options': code.options, 'limit': limit}
    busy, own, begun = busy_seconds(), cpu_seconds(resource.RUSAGE_CHILDREN), time.monotonic()
    if code.family == 'baseline':
        found = in_child(lambda: run_baseline(request), limit + PLANNING + START, request['threads'])
    else:
        found = in_child(lambda: run_code(code.family, request), limit + START, request['threads'])
    wall = time.monotonic() - begun
    others = None if busy is None else max(0.0, (busy_seconds() - busy - (cpu_seconds(resource.RUSAGE_CHILDREN) - own)) / wall)
    if isinstance(found, dict):
        error = f'over the limit of {limit:g} s' if found['error'] == 'over the limit' else found['error']
        found = [{**found, 'error': error, 'tol': request['tol']}]
    return [{**answer, 'other_cores': others} for answer in found]
