"""Sphinx' settings for the site of the documents; scripts/site.sh runs it.

The pages are those of the source tree. The front page is docs/index.md, to which the contents are appended; pages of the reference
are made from the sources by reference.py.
"""

import os
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
tree = pathlib.Path(__file__).parents[2]

project = 'roughcontact'
version = release = re.search(r'^project\(.* VERSION ([0-9.]+)', (tree / 'CMakeLists.txt').read_text(), re.M)[1]
root_doc = 'docs/index'
extensions = ['breathe', 'myst_parser', 'sphinx.ext.autodoc']
exclude_patterns = ['tests/data/README.md', 'tests/contract/pairs/README.md']
html_theme = 'furo'
html_title = f'roughcontact {release}'
html_theme_options = {'sidebar_hide_name': False}
html_copy_source = False
smartquotes = False  # h' is the slope
html_show_copyright = False
myst_heading_anchors = 4
# Fragments of programs are no programs: the lexers say so, and are not asked.
suppress_warnings = ['misc.highlighting_failure']
breathe_projects = {'roughcontact': os.environ['RC_DOXYGEN_XML']}
breathe_default_project = 'roughcontact'
breathe_domain_by_extension = {'h': 'c'}
autodoc_member_order = 'groupwise'
autodoc_typehints = 'none'
autodoc_default_options = {'members': True, 'undoc-members': False, 'exclude-members': 'RCError'}

CONTENTS = """
```{toctree}
:caption: Start
:hidden:

../README
install
tutorial
gallery
../examples/README
```

```{toctree}
:caption: Maps
:hidden:

how-to/file-to-report
how-to/prepare-a-map
how-to/two-maps
how-to/rough-ball
how-to/free-or-periodic
how-to/modulus-and-units
how-to/uncertainty
how-to/conductance
how-to/slip
how-to/rubber
how-to/seals
how-to/flow-factors
how-to/campaigns
how-to/limits
how-to/tolerance
how-to/cite
surface-files
command-line
words
```

```{toctree}
:caption: Programs
:hidden:

python
how-to/coming-from
derivatives
surfaces
fortran
octave
device
how-to/many-machines
compatibility
```

```{toctree}
:caption: Finite elements
:hidden:

law
fem
how-to/calculix
../integrations/README
../integrations/4c/README
../integrations/mirco/README
../integrations/gapflow/README
../integrations/abaqus/README
../integrations/moose/README
../integrations/two-blocks/README
../integrations/precice/README
```

```{toctree}
:caption: Reference
:hidden:

reference
options
glossary
certificate
troubleshooting
../CHANGELOG
```

```{toctree}
:caption: Development
:hidden:
:glob:

../CONTRIBUTING
../CODE_OF_CONDUCT
../SECURITY
development/*
../packaging/README
../bindings/python/gpl/README
../bindings/python/gpl/LICENSE
../backends/*/README
../src/solvers/haar_cg/README
../src/solvers/haar_cg/constants
../fuzz/README
../integrations/calculix/README
../integrations/calculix/LICENSE
```
"""
REFERENCE = """
```{toctree}
../reference/c
../reference/fortran
../reference/python
```
"""


def complete(app, docname, source):
    """The contents belong to the site, not to the pages as a forge shows them."""
    source[0] += {root_doc: CONTENTS, 'docs/reference': REFERENCE}.get(docname, '')


def marked_up(line):
    plain = re.sub(r'([*|\\_])', r'\\\1', line)
    return re.sub(r'`([^`]+)`', lambda match: '``' + re.sub(r'\\([*|\\_])', r'\1', match[1]) + '``', plain)


def as_written(app, what, name, obj, options, lines):
    """Docstrings are plain text: a line stays one unless it was full, and what is between backquotes is code."""
    joined = []
    for line in lines:
        full = joined and len(joined[-1].split('\n')[-1]) > 95
        if full and line.strip():
            joined[-1] += '\n' + line
        else:
            joined.append(line)
    lines[:] = ['| ' + marked_up(' '.join(part.strip() for part in line.split('\n'))) if line.strip() else '' for line in joined] + ['']


def setup(app):
    app.connect('source-read', complete)
    app.connect('autodoc-process-docstring', as_written)
