"""One JSON file a benchmark, a line a record: its provenance, and tables of records that are found by the values of some keys. It is written
whole after every record, so that an interrupted run goes on where it stopped."""
import hashlib
import os
import time

import roughcontact

import native
from case import Failure, plain
from json_tables import lines, read, rounded
from samples import chosen, fits


def processor():
    with open('/proc/cpuinfo') as info:
        return next((line.split(':', 1)[1].strip() for line in info if line.startswith('model name')), 'unknown')


def library_hash():
    """A hash of the library, its plugins and the kind of processor: the same bytes need not be measured there again."""
    library = os.path.realpath(roughcontact.library_file())
    files = [os.path.join(folder, name) for folder, _, names in os.walk(os.path.join(os.path.dirname(library), 'roughcontact')) for name in names]
    digest = hashlib.blake2b(processor().encode(), digest_size=8)
    for file in [*sorted(files), library]:
        with open(file, 'rb') as content:
            digest.update(content.read())
    return digest.hexdigest()


def provenance(threads):
    compiler, flags, fftw = native.build()
    with open(os.path.join(os.environ['RC_BENCH_BUILD'], 'commit'), encoding='utf-8') as text:
        commit = text.read().strip()
    return {'date': time.strftime('%Y-%m-%dT%H:%M:%SZ', time.gmtime()), 'version': '.'.join(map(str, roughcontact.version())),
            'commit': commit, 'library': library_hash(), 'compiler': compiler, 'flags': flags, 'fftw': fftw,
            'cpu': processor(), 'threads': threads, 'load_average_at_start': os.getloadavg()[0]}


class Store:
    """file: of the results, '': none."""

    def __init__(self, file, benchmark, threads):
        self.file, self.document = file, {}
        if file and os.path.exists(file):
            self.document = read(file)
            if self.document.get('benchmark') != benchmark:
                raise Failure(f'{file} is no result of this benchmark; give another name, or remove it')
        self.document.update(benchmark=benchmark, provenance=provenance(threads))
        self.library = self.document['provenance']['library']

    def rows(self, name, **values):
        return chosen(self.document.get(name, []), **values)

    def find(self, name, values):
        """The record with these values, or None."""
        return next(iter(self.rows(name, **values)), None)

    def measured(self, name, key):
        """The record of the key by this library, or None."""
        return self.find(name, {**key, 'library': self.library})

    def known(self, name, key):
        """Whether this library has measured the record, without an error."""
        return 'error' not in (self.measured(name, key) or {'error': ''})

    def put(self, name, key, values):
        """The record of the key and these values, in the place of the one with this key."""
        rows = self.document.setdefault(name, [])
        row = rounded(plain({**key, 'library': self.library, **values}))  # as it is read again
        at = next((i for i, old in enumerate(rows) if fits(old, key)), len(rows))
        rows[at:at + 1] = [row]
        self.save()
        return row

    def save(self, **values):
        """Writes the file, with these values."""
        self.document.update(values)
        if not self.file:
            return
        os.makedirs(os.path.dirname(os.path.abspath(self.file)), exist_ok=True)
        with open(self.file + '.part', 'w', encoding='utf-8') as out:
            out.write(lines(rounded(plain(self.document))))
        os.replace(self.file + '.part', self.file)
