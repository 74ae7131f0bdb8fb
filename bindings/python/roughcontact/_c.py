"""Types of C as annotations; structs and prototypes for ctypes from classes that are annotated with them."""

import ast
import ctypes
import dataclasses
import functools
import sys
from ctypes import POINTER
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
    names, texts = _shared_names(cls, type(members))
    found = {name: getattr(members, name) for name in names}
    for name in texts:
        if found[name] is not None:
            found[name] = found[name].decode(errors="replace")
    return found


@functools.lru_cache(maxsize=None)
def _shared_names(cls: type, struct: Type[Sized]) -> Tuple[Tuple[str, ...], Tuple[str, ...]]:
    """(all, texts)"""
    kinds = {field[0]: field[1] for field in struct._fields_}
    names = tuple(each.name for each in dataclasses.fields(cls) if hasattr(struct, each.name))
    return names, tuple(name for name in names if kinds[name] is ctypes.c_char_p or getattr(kinds[name], "_type_", None) is ctypes.c_char)
