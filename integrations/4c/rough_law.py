"""The pressure of a rough interface for 4C, from the contact law in the file of this name that ends in .law.

4C imports the file that its input names, and calls both functions where gap + offset is negative.
"""

from pathlib import Path

import roughcontact

LAW = roughcontact.Law.load(Path(__file__).with_suffix(".law"))


def evaluate(gap, offset):
    """Minus the nominal pressure."""
    return 0.0 - float(LAW(-(gap + offset)))  # without contact 0, not -0


def evaluate_derivative(gap, offset):
    """Its derivative by the gap, which is the law's slope."""
    return float(LAW.slope(-(gap + offset)))
