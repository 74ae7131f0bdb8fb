"""How a call ended.

Written by scripts/bindings.py.
"""

import enum


class Status(enum.IntEnum):
    """0 certified, 100 and above usable but not certified, < 0 failed."""

    OK = 0
    WITHIN_GOAL = 100
    STOP_MAX_ITER = 101
    STOP_TIME = 102
    STOP_CANCELLED = 103
    STOP_STALLED = 104
    UNCERTIFIED = 105
    OUTSIDE = 106
    ERR_ARGUMENT = -1
    ERR_SHAPE = -2
    ERR_OPTION = -3
    ERR_NO_BACKEND = -4
    ERR_NO_SOLVER = -5
    ERR_INCOMPATIBLE = -6
    ERR_PLUGIN = -7
    ERR_MEMORY = -8
    ERR_INFEASIBLE = -9
    ERR_NUMERIC = -10
    ERR_EXTERNAL = -11
    ERR_BUSY = -12
    ERR_INTERNAL = -99
