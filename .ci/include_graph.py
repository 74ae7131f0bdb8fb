#!/usr/bin/env python3
"""Checks every #include against the layers: each folder may include only what stands beside it here. The layers have no cycle, nor have
the headers of src or the modules of the Python package among themselves."""
import ast
import graphlib
import pathlib
import re
import sys

CONTACT = {f'roughcontact/{name}.h' for name in ('roughcontact', 'history', 'derivatives', 'direct', 'product', 'analysis', 'law', 'ranks', 'registry')}
PUBLIC = CONTACT | {f'roughcontact/{name}' for name in ('mpi.h', 'plugin.h', 'surface.h', 'formats.h', 'flow.h', 'request.h', 'budget.h', 'plugin.hpp')}
STEP = {f'contact{part}' for part in ('', '/surface', '/memory', '/coarse', '/sparse', '/proof', '/step')}
LAYERS = {  # folder under src: folders it may include, each without the folders below it that stand here themselves
    'platform': {'platform'},
    'core': {'core', 'platform'},
    'core/vectors': {'core/vectors'},
    'kernel': {'kernel'},
    'registry': {'registry', 'core', 'kernel', 'platform'},
    'operator': {'operator', 'registry', 'core'},
    'grid': {'grid'},
    'trees': {'trees', 'core/vectors', 'core'},
    'analysis': {'analysis', 'core'},
    'solvers': {'solvers', 'operator', 'grid', 'core'},
    'solvers/haar_cg/iteration': {'solvers/haar_cg/iteration', 'core'},
    'solvers/haar_cg/threads': {'solvers', 'solvers/haar_cg/threads', 'solvers/haar_cg/iteration', 'trees', 'core/vectors', 'core'},
    'solvers/haar_cg/near': {'solvers', 'solvers/haar_cg/near', 'solvers/haar_cg/threads', 'core/vectors', 'core'},
    'solvers/haar_cg/plain': {'solvers/haar_cg/iteration', 'trees', 'solvers/haar_cg/plain'},
    'solvers/haar_cg': {'solvers', 'grid', 'trees', 'core', *(f'solvers/haar_cg{part}' for part in ('', '/iteration', '/threads', '/near'))},
    'contact/surface': {'contact/surface', 'operator', 'grid', 'core'},
    'contact': {'contact', 'contact/surface', 'operator', 'registry', 'kernel', 'grid', 'core', 'platform'},
    'contact/memory': {'contact/memory', 'contact', 'contact/surface', 'core'},
    'contact/slopes': {'contact/slopes', 'contact/memory', 'contact', 'contact/surface', 'trees', 'operator', 'core'},
    'contact/proof': {'contact/proof', 'contact/slopes', 'contact', 'contact/surface', 'kernel', 'core'},
    'contact/coarse': {'contact/coarse', 'contact', 'contact/surface', 'grid', 'core'},
    'contact/sparse': {'contact/sparse', 'contact/proof', 'contact', 'contact/surface', 'core'},
    'contact/step': {'contact/step', 'contact/coarse', 'contact/sparse', 'contact/proof', 'contact/memory', 'contact', 'contact/surface', 'operator', 'core'},
    'contact/grids': {*STEP, 'contact/grids', 'grid', 'core'},
    'contact/grids/goal': {*STEP, 'contact/grids/goal', 'contact/grids', 'core'},
    'contact/calls': {*STEP, 'contact/calls', 'contact/grids/goal', 'contact/grids', 'contact/slopes', 'registry', 'core'},
    'abi': {'abi', 'analysis', 'contact', 'contact/calls', 'contact/surface', 'solvers', 'operator', 'registry', 'kernel', 'core'},
    'law': {'law', 'core'},  # above abi: it uses contacts as any program does, through the public headers
}
OUTSIDE = {  # other folders: public headers they may include; besides, their own files and those of dependencies
    'backends': {'roughcontact/plugin.h', 'roughcontact/plugin.hpp'},  # and backends/common, which includes no backend
    'bindings': CONTACT | {'roughcontact/formats.h', 'roughcontact/flow.h', 'roughcontact/request.h', 'roughcontact/budget.h'},
    'tools': CONTACT | {'roughcontact/surface.h', 'roughcontact/flow.h', 'roughcontact/mpi.h', 'roughcontact/request.h', 'roughcontact/budget.h'},
    'mpi': {'roughcontact/mpi.h', 'roughcontact/ranks.h'},
    'surface': {'roughcontact/roughcontact.h', 'roughcontact/surface.h'},
    'formats': {'roughcontact/roughcontact.h', 'roughcontact/formats.h'},
    'request': CONTACT | {'roughcontact/formats.h', 'roughcontact/request.h', 'roughcontact/budget.h'},
    'flow': CONTACT | {'roughcontact/flow.h'},
    'fuzz': CONTACT | {'roughcontact/surface.h', 'roughcontact/formats.h'},
    'examples': PUBLIC,
    'integrations': PUBLIC,
}
# The parts of haar-cg that need no other part of the library: plugins that run its iteration on a machine of their own compile them.
HAAR = {'solvers/problem.h', 'solvers/haar_cg/iteration/iteration.h', 'solvers/haar_cg/starts.h', 'trees/tree_inputs.h', 'trees/tree_shape.h',
        'trees/algebra.inc'}
BESIDE = {'core', 'abi/own_guard.h', 'abi/sized_struct.h'}
# Folders and headers of src that others, and the law, may include; the flow also includes the session of backends/cholmod.
BORROWED = {'surface': BESIDE | {'grid'}, 'formats': BESIDE | {'platform'}, 'request': BESIDE | {'platform/files.h'}, 'flow': BESIDE | {'abi/steps.h', 'platform', 'cholmod'}, 'tools': {'core/text.h', 'platform'}, 'law': {'abi/arrays.h', 'abi/guard.h', 'abi/sized_struct.h'}, 'backends': {'platform', 'core/certificate_terms.h', 'core/start_terms.h'} | HAAR}
WITHIN = {('cuda_host', 'cuda/tables.h')}  # one plugin, built twice
EXCEPTIONS = {('src/registry/builtin.cpp.in', 'backends/known.def'),  # a list of names
              ('src/law/table.c', 'table.h')}  # compiled by programs without this tree


def layer(path):
    """The longest folder of LAYERS that holds a path below src; '' where none does."""
    return max((folder for folder in LAYERS if path.startswith(folder + '/')), key=len, default='')


def allowed(root, file, include, quoted):
    top, folder, *_ = file.parts
    inside = '/'.join(file.parts[1:])
    if include in PUBLIC:
        return include in OUTSIDE.get(top, PUBLIC) and (top != 'src' or include != 'roughcontact/law.h' or layer(inside) == 'law')
    if top == 'src':
        if include in BORROWED.get(layer(inside), set()):
            return True
        return layer(include) in LAYERS[layer(inside)] if layer(include) else not quoted
    beside = root / file.parent / include
    if beside.exists() and beside.resolve().is_relative_to((root / top / folder).resolve()):
        return True  # a file of its own
    if quoted and (top == 'backends' and (root / top / folder / include).exists() or top == 'tools' and (root / top / include).exists()):
        return True
    if BORROWED.get(top, set()) & {include, include.split('/')[0]}:
        return True
    if top == 'backends' and quoted and include.startswith('common/'):
        return (root / 'backends' / include).exists()
    if (folder, include) in WITHIN:
        return True
    if top == 'backends':  # a dependency, never another folder of this tree
        return not quoted and not include.startswith(('rc', '..')) and not (root / 'src' / include).exists()
    return not include.startswith('..') and not (root / 'src' / include).exists()


def imports_of(file):
    """Names of the modules beside it that a Python module imports, anywhere in it."""
    package = file.parent.name
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.ImportFrom):
            origin = '.'.join([package] * node.level + [node.module] * bool(node.module))
            paths = [f'{origin}.{name.name}' for name in node.names]
        else:
            paths = [name.name for name in node.names] if isinstance(node, ast.Import) else []
        yield from (path.split('.')[1] for path in paths if path.startswith(f'{package}.'))


def headers(src):
    """The headers that each header below src includes."""
    graph = {}
    for header in src.rglob('*.h'):
        quoted = re.findall(r'^\s*#\s*include\s*"([^"]+)"', header.read_text(), re.M)
        graph[str(header.relative_to(src))] = {each for each in quoted if each.endswith('.h') and (src / each).exists()}
    return graph


def cycle(name, graph):
    """Files that need each other in a circle, or nothing."""
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as error:
        return [f'{name}: in a circle: {" <- ".join(error.args[1])}']
    return [] if len(graph) > 1 else [f'{name}: none']


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else '.').resolve()
    package = root / 'bindings' / 'python' / 'roughcontact'
    modules = {file.stem: set(imports_of(file)) for file in package.glob('*.py')}
    layers = {folder: below - {folder} for folder, below in LAYERS.items()}
    edges, forbidden = 0, [*cycle('layers', layers), *cycle('headers of src', headers(root / 'src')), *cycle('the Python package', modules)]
    for top in ['src', *OUTSIDE]:
        for path in sorted((root / top).rglob('*')):
            if not re.search(r'\.(c|cpp|h|hpp|def|in)$', path.name):
                continue
            file = path.relative_to(root)
            for number, line in enumerate(path.read_text().splitlines(), 1):
                match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
                if not match:
                    continue
                edges += 1
                if not allowed(root, file, match[2], match[1] == '"') and (str(file), match[2]) not in EXCEPTIONS:
                    forbidden.append(f'{file}:{number}: must not include {match[2]}')
    print('\n'.join(forbidden) or f'{edges} includes follow the layers; no layer, no header and no Python module reaches itself')
    return 1 if forbidden or not edges else 0


sys.exit(main())
