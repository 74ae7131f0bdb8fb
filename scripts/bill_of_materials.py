#!/usr/bin/env python3
"""bill_of_materials.py VERSION FOLDER: prints, as CycloneDX in JSON, the packages in FOLDER with their licences and check sums, and the
libraries that each contains or links, as Debian has them on the machine that built them."""
import datetime
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import zipfile

GCC = 'GPL-3.0-or-later WITH GCC-exception-3.1'
# SPDX, by the beginning of the names of Debian's packages.
LICENCES = {'libamd': 'BSD-3-Clause', 'libblas': 'BSD-3-Clause', 'libbz2-': 'bzip2-1.0.6', 'libc6': 'LGPL-2.1-or-later', 'libcamd': 'BSD-3-Clause',
            'libccolamd': 'BSD-3-Clause', 'libcholmod': 'LGPL-2.1-or-later AND GPL-2.0-or-later', 'libcli11-dev': 'BSD-3-Clause',
            'libcolamd': 'BSD-3-Clause', 'libeigen3-dev': 'MPL-2.0', 'libfftw3-': 'GPL-2.0-or-later', 'libgcc-s1': GCC, 'libgfortran': GCC,
            'libgomp': GCC, 'libgsl': 'GPL-3.0-or-later', 'libhdf5-': 'BSD-3-Clause', 'liblapack': 'BSD-3-Clause', 'libmetis': 'Apache-2.0',
            'libmpich': 'mpich2', 'libnetcdf': 'NetCDF', 'libopenblas': 'BSD-3-Clause', 'libopenmpi': 'BSD-3-Clause', 'libpng': 'libpng-2.0', 'libpugixml': 'MIT',
            'libquadmath': 'LGPL-2.1-or-later', 'libssl': 'Apache-2.0', 'libstdc++': GCC, 'libsuitesparseconfig': 'BSD-3-Clause', 'libtiff': 'libtiff',
            'libzip': 'BSD-3-Clause', 'nlohmann-json3-dev': 'MIT', 'python3-numpy': 'BSD-3-Clause', 'python3': 'PSF-2.0', 'zlib1g': 'Zlib'}
OURS = {r'-backend-|-flow': 'GPL-2.0-or-later', r'-surface|-tools': 'GPL-3.0-or-later',
        r'-dev_|^$': 'BSD-3-Clause AND GPL-2.0-or-later AND GPL-3.0-or-later', r'_gpl-.*\.whl$': 'GPL-3.0-or-later',
        r'\.whl$': 'BSD-3-Clause AND MIT AND MPL-2.0', '-site': 'BSD-3-Clause',
        r'\.tar\.gz$': 'BSD-3-Clause AND GPL-2.0-only AND GPL-2.0-or-later AND GPL-3.0-or-later', '': 'BSD-3-Clause'}
HEADERS = {r'-tools_|\.whl$': ['libcli11-dev', 'nlohmann-json3-dev', 'libeigen3-dev'], r'^lib': ['libeigen3-dev']}  # compiled in


def said(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def version_of(package):
    """The version of the installed package; '' if no package of this name is installed."""
    ran = subprocess.run(['dpkg-query', '-W', '-f', '${Version}', package], capture_output=True, text=True, check=False)
    return ran.stdout if ran.returncode == 0 else ''


def first(table, name, otherwise):
    return next((value for pattern, value in table.items() if re.search(pattern, name)), otherwise)


def libraries(file):
    """Debian's packages that a package of ours contains or links."""
    names = list(first(HEADERS, file.name, []))
    if file.suffix == '.deb':
        names += re.findall(r'(?:^|, )([a-z0-9.+-]+)', said('dpkg-deb', '-f', file, 'Depends'))
    elif file.suffix == '.whl':
        names += [pathlib.PurePath(name).name for name in zipfile.ZipFile(file).namelist() if '.dist-info/licenses/' in name]
    return sorted({name for name in names if 'roughcontact' not in name and version_of(name)})


def licence(package):
    return next((text for start, text in LICENCES.items() if package.startswith(start)), None) or sys.exit(
        f'bill_of_materials.py: the licence of {package} is not in the table')


def component(name, version, text, **more):
    return {'type': 'library', 'bom-ref': name, 'name': name, 'version': version, 'licenses': [{'expression': text}], **more}


def main():
    version, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    needs = {file: libraries(file) for file in sorted(folder.iterdir()) if re.search(r'\.deb$|\.whl$|\.tar\.gz$', file.name)}
    others = sorted({name for names in needs.values() for name in names})
    time = datetime.datetime.fromtimestamp(int(os.environ['SOURCE_DATE_EPOCH']), datetime.timezone.utc)
    print(json.dumps({
        'bomFormat': 'CycloneDX', 'specVersion': '1.5', 'version': 1,
        'metadata': {'timestamp': time.strftime('%Y-%m-%dT%H:%M:%SZ'), 'component': component('roughcontact', version, first(OURS, '', ''))},
        'components': [component(file.name, version, first(OURS, file.name, ''), hashes=[{'alg': 'SHA-256', 'content': hashlib.sha256(file.read_bytes()).hexdigest()}])
                       for file in needs] + [component(name, version_of(name), licence(name), purl=f'pkg:deb/debian/{name}@{version_of(name)}') for name in others],
        'dependencies': [{'ref': file.name, 'dependsOn': names} for file, names in needs.items()]}, indent=1))


if __name__ == '__main__':
    main()
