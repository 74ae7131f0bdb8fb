"""What is compared: the codes, their tolerances, and the problems."""
from dataclasses import dataclass, field

LEVELS = (1e-4, 1e-6, 1e-8)  # of the certificate
SWEEP = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14)


@dataclass(frozen=True)
class Code:
    title: str
    family: str     # a key of peers_codes.RUNNERS
    package: str    # on the package index; '' for what this project builds
    boundaries: tuple
    controls: tuple = ('load',)
    tols: tuple = SWEEP  # its own tolerances, from loose to tight: the first whose answer is certified at the tightest level ends it
    options: dict = field(default_factory=dict)
    small: bool = False  # dense matrices only


def aspher(backend, precision, **more):
    return {'backend': backend, 'precision': precision, **more}


FLOAT = {'tols': (1e-3, 1e-4, 1e-5, 2e-6)}  # its floor in single precision is 2e-6
CODES = {
    'ours': Code('roughcontact', 'ours', '', ('free', 'periodic'), ('load', 'displacement'), (1e-4, 1e-6, 1e-8)),
    'ours-float': Code('roughcontact, single', 'ours', '', ('free',), ('load',), (1e-4,), options={'fft.precision': 'single'}),
    'baseline': Code('standard Polonsky-Keer, padded FFTW', 'baseline', '', ('free',), ('load', 'displacement'), (1e-8,)),
    'aspher-fft': Code('ASPHER, fft, double', 'aspher', 'aspher', ('free',), options=aspher('fft', 'double')),
    'aspher-h2': Code('ASPHER, h2, double', 'aspher', 'aspher', ('free',), options=aspher('h2', 'double', active_set=True)),
    'aspher-fft-float': Code('ASPHER, fft, float', 'aspher', 'aspher', ('free',), **FLOAT,
                             options=aspher('fft', 'float', allow_tolerance_relaxation=True)),
    'aspher-h2-float': Code('ASPHER, h2, float', 'aspher', 'aspher', ('free',), **FLOAT,
                            options=aspher('h2', 'float', allow_tolerance_relaxation=True, active_set=True)),
    'aspher-periodic': Code('ASPHER, periodic, double', 'aspher', 'aspher', ('periodic',), options=aspher('periodic', 'double')),
    'tamaas': Code('Tamaas', 'tamaas', 'tamaas', ('periodic',)),
    'tamaas-free': Code('Tamaas, non-periodic operator', 'tamaas', 'tamaas', ('free',)),
    'contactmechanics': Code('ContactMechanics', 'contactmechanics', 'ContactMechanics', ('free', 'periodic')),
    'nnls': Code('scipy nnls, dense', 'nnls', 'scipy', ('free',), ('displacement',), (0.0,), small=True),
    'osqp': Code('OSQP, dense', 'osqp', 'osqp', ('free',), ('displacement',), (1e-4, 1e-6, 1e-8, 1e-10), small=True),
}
LARGEST_MATRIX = 1500  # points: a dense matrix of the small problems


@dataclass(frozen=True)
class Case:
    surface: str    # a key of peers_surfaces.MAKERS
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
                (fits or code.family != 'aspher') and (self.n < 8192 or name == 'ours' or name.endswith('-float'))]


SMALL_SIZES = (16, 24, 32, 38)


def cases(sizes, percents, quick):
    """From cheap to expensive, so that what a budget cuts off is what costs most."""
    found = []
    for n in sorted(sizes or ((256, 512) if quick else (512, 1024, 2048, 4096, 8192))):
        if n * n <= LARGEST_MATRIX:
            found.append(Case('wavy', n, 'free', 'displacement', 30))
            continue
        free = (0.1, 1, 10, 30, 50) if n <= 1024 else (0.1, 10, 50) if n <= 2048 else (0.1, 10) if n <= 4096 else (0.1,)
        if quick:
            free = (1, 10)
        free = percents or free
        found += [Case('rough', n, 'free', 'load', percent) for percent in free]
        if n < 8192:
            found.append(Case('rough', n, 'free', 'displacement', 10))
            periodic = (10,) if quick or n > 1024 else (1, 10, 50)
            found += [Case('wavy', n, 'periodic', 'load', percent) for percent in percents or periodic]
    small = [] if sizes else [Case('wavy', n, 'free', 'displacement', 30) for n in (SMALL_SIZES[2:3] if quick else SMALL_SIZES)]
    return small + found
