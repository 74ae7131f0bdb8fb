"""Where an elastic answer stops making sense.

Written by scripts/bindings.py.
"""

HARDNESSES = ((150e9, "diamond"), (10e9, "any steel"))  # [Pa], the hardest first
SMALL_STRAIN = 0.2  # largest pressure over E*
