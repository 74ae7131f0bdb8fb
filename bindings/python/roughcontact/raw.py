"""The C interface: constants and structs under their names in the headers, and the loaded libraries.

    from roughcontact import raw
    library = raw.contact_library()
    step = raw.rc_step()
    step.target = 1e-6

A new struct has its size and the values of the header's RC_..._INIT macro. Structs are passed by reference where ctypes expects
a pointer to one. Shapes, units and who keeps what: see the headers.
"""

from typing import List

from ._constants import *  # noqa: F401,F403
from ._library import contact_library, flow_library, formats_library, library_file  # noqa: F401
from ._library import request_library, surface_library  # noqa: F401
from ._structs import *  # noqa: F401,F403

__all__ = ["contact_library", "surface_library", "formats_library", "flow_library", "request_library", "library_file"]
__all__ += [name for name in dir() if name.startswith(("rc_", "RC_"))]


def __dir__() -> List[str]:
    return __all__
