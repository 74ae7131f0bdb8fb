"""The package says what the headers say: functions, constants, callbacks, and structs as a C compiler lays them out."""

import ctypes
import os
import pathlib
import re
import shutil

import pytest
from header import Header, c_layout

from roughcontact import raw
from roughcontact._prototypes import CONTACT_FUNCTIONS, SURFACE_FUNCTIONS, prototypes

INCLUDE = pathlib.Path(__file__).resolve().parents[3] / "include" / "roughcontact"
FILES = ("roughcontact.h", "surface.h")
CALLBACKS = {
    "rc_path_fn": "int32_t (int64_t step, const rc_result *result, void *user)",
    "rc_batch_fn": "int32_t (int64_t contact, int64_t step, const rc_result *result, void *user)",
    "rc_progress_fn": "int32_t (const rc_progress *, void *user)",
    "rc_log_fn": "void (int32_t level, const char *message, void *user)",
}
APPLY = "int32_t (*apply)(const double *x, double *y, int64_t n, void *user)"

if not INCLUDE.is_dir():
    pytest.skip("the headers are not beside the tests", allow_module_level=True)


def texts():
    return [(INCLUDE / name).read_text() for name in FILES]


def structs_of_package():
    return {each.__name__: each for each in raw.STRUCTS + raw.SURFACE_STRUCTS}


def ctype_of(declaration):
    """What ctypes should call a member."""
    if "(*apply)" in declaration:
        assert declaration == APPLY
        return raw.rc_apply_fn
    base, stars, _, size = re.fullmatch(r"(?:const )?(\w+) (\**)(\w+)(?:\[(\w+)\])?", declaration).groups()
    plain = {
        "double": ctypes.c_double,
        "int32_t": ctypes.c_int32,
        "int64_t": ctypes.c_int64,
        "uint32_t": ctypes.c_uint32,
        "uint64_t": ctypes.c_uint64,
        "uint8_t": ctypes.c_uint8,
        "size_t": ctypes.c_size_t,
        "rc_status": ctypes.c_int32,
        "char": ctypes.c_char,
        **{name: getattr(raw, name) for name in CALLBACKS},
    }
    if stars:
        return {"void": ctypes.c_void_p, "char": ctypes.c_char_p}.get(base) or ctypes.POINTER(plain[base])
    return plain[base] * (getattr(raw, size) if size.startswith("RC_") else int(size)) if size else plain[base]


def differences(headers, compiled=None):
    """Everything in which the headers and the package differ."""
    found = []
    constants, functions, callbacks, structs = {}, {}, {}, {}
    for header in headers:
        constants.update(header.constants)
        functions.update(header.functions)
        callbacks.update(header.callbacks)
        structs.update(header.structs)

    ours = {name: value for name, value in vars(raw).items() if name.startswith("RC_")}
    found += [f"constant {name}" for name in constants.keys() | ours.keys() if constants.get(name) != ours.get(name)]

    declared = {d.split("(")[0].split()[-1].lstrip("*"): d for d in (CONTACT_FUNCTIONS + SURFACE_FUNCTIONS).split("\n") if d}
    found += [f"function {name}" for name in functions.keys() | declared.keys() if functions.get(name) != declared.get(name)]
    found += [f"callback {name}" for name in callbacks.keys() | CALLBACKS.keys() if callbacks.get(name) != CALLBACKS.get(name)]

    mine = structs_of_package()
    found += [f"struct {name}" for name in structs.keys() ^ mine.keys()]
    for name in structs.keys() & mine.keys():
        try:
            expected = [(member, ctype_of(declaration)) for member, declaration in structs[name]]
        except (KeyError, AssertionError):
            expected = None
        if expected != list(mine[name]._fields_):
            found.append(f"struct {name}")
        elif compiled:
            layout = {"": (0, ctypes.sizeof(mine[name]))}
            layout.update(
                (member, (getattr(mine[name], member).offset, getattr(mine[name], member).size)) for member, _ in expected
            )
            found += [f"layout {name}.{member}" for member, where in layout.items() if compiled[name, member] != where]
    return sorted(found)


def test_package_and_headers_agree():
    headers = [Header(text) for text in texts()]
    assert sum(len(header.functions) for header in headers) > 60
    assert sum(len(header.constants) for header in headers) > 60
    assert differences(headers) == []


def test_structs_are_laid_out_as_the_c_compiler_does(tmp_path):
    compiler = shutil.which(os.environ.get("CC", "cc"))
    if compiler is None:
        pytest.skip("no C compiler (CC, cc)")
    headers = [Header(text) for text in texts()]
    structs = {name: members for header in headers for name, members in header.structs.items()}
    compiled = c_layout(tmp_path, compiler, [INCLUDE / name for name in FILES], structs)
    assert len(compiled) > 200
    assert differences(headers, compiled) == []


def test_prototypes_translate():
    found = {name: (result, arguments) for name, result, arguments in prototypes(CONTACT_FUNCTIONS + SURFACE_FUNCTIONS)}
    assert found["rc_contact_create"] == (
        ctypes.c_int32,
        [ctypes.POINTER(raw.rc_system), ctypes.c_void_p, ctypes.POINTER(ctypes.c_void_p)],
    )
    assert found["rc_last_error"] == (ctypes.c_char_p, [])
    assert found["rc_contact_cancel"] == (None, [ctypes.c_void_p])
    assert found["rc_options_get_text"][1][2] == ctypes.POINTER(ctypes.c_char_p)
    assert found["rc_contact_on_progress"][1][1] is raw.rc_progress_fn


CHANGES = {
    "function added": (
        0,
        "RC_API void rc_contact_destroy(",
        "RC_API void rc_new(rc_context *context);\nRC_API void rc_contact_destroy(",
    ),
    "function renamed": (0, "rc_contact_reset(", "rc_contact_clear("),
    "argument added": (0, "rc_contact_reset(rc_contact *contact)", "rc_contact_reset(rc_contact *contact, int32_t deep)"),
    "argument widened": (0, "int32_t control, const rc_options", "int64_t control, const rc_options"),
    "argument made an output": (0, "const double *heights", "double *heights"),
    "arguments swapped": (0, "double hx, double hy, int64_t nx", "double hy, double hx, int64_t nx"),
    "return type changed": (0, "RC_API int64_t rc_backend_count", "RC_API rc_status rc_backend_count"),
    "constant renumbered": (0, "RC_STOP_STALLED = 4", "RC_STOP_STALLED = 7"),
    "constant added": (0, "RC_LOG_WARNING = 2", "RC_LOG_WARNING = 2, RC_LOG_DEBUG = 3"),
    "key respelled": (0, '"max_iter"', '"maxiter"'),
    "ABI number": (0, "#define RC_ABI 0", "#define RC_ABI 1"),
    "callback widened": (0, "(*rc_path_fn)(int64_t step", "(*rc_path_fn)(int32_t step"),
    "product's sign": (0, "(*apply)(const double *x, double *y, int64_t n", "(*apply)(const double *x, double *y, int32_t n"),
    "members swapped": (0, "double hx, hy;", "double hy, hx;"),
    "member removed": (0, "double energy;", ""),
    "member retyped": (0, "int32_t control;     /*", "double control;     /*"),
    "text shortened": (0, "char note[160]", "char note[128]"),
    "member appended": (0, "} rc_result;", "int64_t more;\n} rc_result;"),
    "member inserted": (0, "  int64_t completed; ", "  double progress;\n  int64_t completed; "),
    "surface: function changed": (1, "int32_t stage, int32_t crop", "int32_t stage, int64_t crop"),
    "surface: constant": (1, "RC_SURFACE_MAX = 3", "RC_SURFACE_MAX = 4"),
    "surface: array shortened": (1, "#define RC_SURFACE_PEAKS 4", "#define RC_SURFACE_PEAKS 3"),
    "surface: member": (1, "double radius;", "float radius;"),
}


@pytest.mark.parametrize("name", CHANGES)
def test_a_changed_header_is_noticed(name):
    which, old, new = CHANGES[name]
    changed = texts()
    assert old in changed[which], f'the header no longer has "{old}"'
    changed[which] = changed[which].replace(old, new, 1)
    assert differences([Header(text) for text in changed])


@pytest.mark.parametrize(
    "old, new", [("double load;         /*", "float load;  float more;       /*"), ("int32_t borrow;", "int64_t borrow;")]
)
def test_a_changed_layout_is_noticed(tmp_path, old, new):
    """By the compiler alone: the names are what they were."""
    compiler = shutil.which(os.environ.get("CC", "cc"))
    if compiler is None:
        pytest.skip("no C compiler (CC, cc)")
    now = [Header(text) for text in texts()]
    changed = texts()
    assert old in changed[0]
    (tmp_path / FILES[0]).write_text(changed[0].replace(old, new, 1))
    (tmp_path / FILES[1]).write_text(changed[1])
    structs = {name: members for header in now for name, members in header.structs.items()}
    compiled = c_layout(tmp_path, compiler, [tmp_path / name for name in FILES], structs)
    assert any(each.startswith("layout") for each in differences(now, compiled))


def test_every_function_is_in_the_libraries():
    for library, declarations in ((raw.contact_library(), CONTACT_FUNCTIONS), (raw.surface_library(), SURFACE_FUNCTIONS)):
        for name, _, _ in prototypes(declarations):
            assert getattr(library, name).argtypes is not None
