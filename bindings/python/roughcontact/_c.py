"""Types of C as annotations; structs and prototypes for ctypes from classes that are annotated with them."""

import ast
import ctypes
import dataclasses
import functools
import sys
from ctypes import POINTER
from struct import Struct
from typing import Annotated, Any, ClassVar, Dict, Iterator, List, Tuple, Type, TypeVar, get_args

double = Annotated[float, ctypes.c_double]
int32_t = Annotated[int, ctypes.c_int32]
int64_t = Annotated[int, ctypes.c_int64]
uint32_t = Annotated[int, ctypes.c_uint32]
uint64_t = Annotated[int, ctypes.c_uint64]
size_t = Annotated[int, ctypes.c_size_t]
rc_status = int32_t
char = Annotated[bytes, ctypes.c_char]
text = Annotated[Any, ctypes.c_char_p]
texts = Annotated[Any, POINTER(ctypes.c_char_p)]
handle = Annotated[Any, ctypes.c_void_p]
handles = Annotated[Any, POINTER(ctypes.c_void_p)]
doubles = Annotated[Any, POINTER(ctypes.c_double)]
singles = Annotated[Any, POINTER(ctypes.c_float)]
integers = Annotated[Any, POINTER(ctypes.c_int64)]
statuses = Annotated[Any, POINTER(ctypes.c_int32)]
bytes_ = Annotated[Any, POINTER(ctypes.c_uint8)]


def ctype(annotation: Any) -> Any:
    """What ctypes has for it; a struct is passed by its address."""
    if annotation in (None, type(None)):
        return None
    return annotation.__metadata__[0] if hasattr(annotation, "__metadata__") else POINTER(annotation)


def callback(result: Any, *arguments: Any) -> Any:
    """The type of a function that C calls."""
    return ctypes.CFUNCTYPE(ctype(result), *map(ctype, arguments))


class Sized(ctypes.Structure):
    """A struct whose first member is its size. A new one has the values that its class gives to members, and zeros.

    members: "type member=value member; type*extent member; ...", the names of types and values as the class's module has them.
    """

    members: ClassVar[str] = ""
    initial: ClassVar[Dict[str, Any]]
    kept: Any = None  # what its pointers refer to

    def __init__(self) -> None:
        super().__init__()
        self.struct_size = ctypes.sizeof(self)
        for name, value in self.initial.items():
            setattr(self, name, value)


S = TypeVar("S", bound=Sized)
_CODES = {ctypes.c_double: "d", ctypes.c_int32: "i", ctypes.c_int64: "q", ctypes.c_uint32: "I", ctypes.c_uint64: "Q"}


def struct(cls: Type[S]) -> Type[S]:
    """Makes the members of a class."""
    known, cls.initial = vars(sys.modules[cls.__module__]), {}
    fields: List[Tuple[str, Any]] = []
    for kind, *members in map(str.split, cls.members.split(";")):
        base, _, extent = kind.partition("*")
        element = known[base] if isinstance(known[base], type) else ctype(known[base])
        for member in members:
            name, _, value = member.partition("=")
            fields.append((name, element * int(extent) if extent else element))
            if value:
                cls.initial[name] = known[value] if value in known else ast.literal_eval(value)
    cls._fields_ = fields
    return cls


def prototypes(functions: type) -> Iterator[Tuple[str, Any, List[Any]]]:
    """(name, result, arguments) of the functions that a class is annotated with."""
    for name, annotation in functions.__annotations__.items():
        arguments, result = get_args(annotation)
        yield name, ctype(result), [ctype(each) for each in arguments]


def members_for(cls: type, members: Sized) -> Dict[str, Any]:
    """The members whose names the fields of a dataclass have, with texts decoded."""
    names, numbers, others = _shared_names(cls, type(members))
    found = dict(zip(names, numbers.unpack_from(members)))
    for name in others:
        value = getattr(members, name)
        found[name] = value.decode(errors="replace") if isinstance(value, bytes) else value
    return found


@functools.lru_cache(maxsize=None)
def _shared_names(cls: type, struct: Type[Sized]) -> Tuple[Tuple[str, ...], Struct, Tuple[str, ...]]:
    """(numbers, how they lie in the struct, the others)"""
    shared = {each.name for each in dataclasses.fields(cls)}
    names, form, end, others = [], "=", 0, []
    for name, kind, *_ in struct._fields_:
        if name in shared and kind in _CODES:
            at = getattr(struct, name).offset
            form, end = f"{form}{at - end}x{_CODES[kind]}", at + ctypes.sizeof(kind)
            names.append(name)
        elif name in shared:
            others.append(name)
    return tuple(names), Struct(form), tuple(others)
