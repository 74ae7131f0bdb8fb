"""The C interface as it is: structs laid out as the golden numbers say, with the values that the library begins with."""

import ctypes
import dataclasses
import pathlib
import sys

import pytest

import roughcontact as rc
from roughcontact import raw

GOLDEN = pathlib.Path(__file__).resolve().parents[3] / "tests" / "contract" / "abi"
STRUCTS = {
    name: each
    for name, each in vars(raw).items()
    if isinstance(each, type) and issubclass(each, raw.Sized) and each is not raw.Sized
}


@pytest.mark.skipif(not (GOLDEN / "golden.txt").exists(), reason="the golden numbers are not beside the tests")
def test_structs_and_constants_are_those_of_c():
    sys.path.insert(0, str(GOLDEN))
    constants, sizes, offsets, _ = __import__("golden").numbers()
    seen = 0
    for name, size in sizes.items():
        if name in STRUCTS:
            assert ctypes.sizeof(STRUCTS[name]) == size, name
            members = offsets[name].items()
            assert [(member, getattr(STRUCTS[name], member).offset) for member, _ in members] == [
                (member, offset) for member, offset in members
            ]
            assert [member for member, _ in members] == [member for member, _ in STRUCTS[name]._fields_]
            seen += 1
    assert seen == len(STRUCTS)
    assert {getattr(raw, name) - value for name, value in constants.items() if hasattr(raw, name)} == {0}


def test_a_new_struct_has_the_values_of_the_macros():
    assert raw.rc_step().warm_start == 1 and raw.rc_step().control == 0
    assert raw.rc_result().status == raw.RC_ERR_ARGUMENT and raw.rc_batch().first == -1 and raw.rc_patches().neighbours == 4
    assert all(each().struct_size == ctypes.sizeof(each) for each in STRUCTS.values())


def test_results_have_all_members_of_the_structs():
    for classes, struct in (((rc.Result, rc.Accuracy), raw.rc_result), ((rc.surface.Statistics,), raw.rc_surface_statistics)):
        members = {name for name, _ in struct._fields_} - {"struct_size", "reserved", "p"}
        assert members <= {each.name for fields in map(dataclasses.fields, classes) for each in fields}
