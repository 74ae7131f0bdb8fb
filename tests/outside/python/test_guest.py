"""A guest in the host's process: every call of any length, ended by each means that a Python program has, and the end of the
program during each of them.

Each runs in a Python of its own, because a fault would end it. Calls that see progress are ended in the middle, the others soon
after their start; what is left after 15 seconds is a fault.
"""

import os
import subprocess
import sys

import pytest

CALLS = """
import os, signal, sys, threading, time, warnings
import numpy as np
import roughcontact as rc

warnings.simplefilter("ignore")
n = 300
matrix = 1.0 / (1.0 + np.abs(np.arange(n)[:, None] - np.arange(n))) + np.eye(n)
gap = np.random.default_rng(1).random(n)
products, act, armed = [0], [lambda: None], [False]


def product(x):
    if armed[0]:
        products[0] += 1
        if products[0] == 3:
            act[0]()
        time.sleep(0.002)
    return matrix @ x


def waits(seconds=30):
    # a call that nothing ends takes this long
    return max(1, int(seconds / 0.002))


system = rc.Product(product, n, pitch=1)
contact = rc.Contact(system, options={"tol": 1e-12, "threads": 2})
contact.solve(undeformed_gap=gap, approach=0.7)
pressure = np.ones(n)
noise = np.random.default_rng(2).random((1025, 1025))
wide = np.tile(noise, (2, 2))
many = np.tile(gap, (waits(), 1))
size = 4000
hard = 1e-3 + np.diag(np.logspace(-6, 0, size)) if sys.argv[1] == "direct" else None


def long(function):
    # many calls of one length, of which the first is ended
    for _ in range(waits()):
        function()


calls = {
    "solve": lambda: long(lambda: rc.solve(undeformed_gap=gap, approach=0.7, system=system, tol=1e-12)),
    "history": lambda: rc.history(undeformed_gap=gap, approach=np.tile([0.5, 0.7], waits()), system=system),
    "batch": lambda: rc.batch(undeformed_gap=many, approach=0.7, system=system, options={"threads": 1}),
    "batch2": lambda: rc.batch(undeformed_gap=many, approach=0.7, system=system, options={"threads": 2}),
    "law": lambda: long(lambda: rc.law(undeformed_gap=gap, system=system, pressure=(1e-3, 1e-2), check_status=False)),
    "punch": lambda: long(lambda: rc.analysis.punch_stiffness(system)),
    "gradient": lambda: long(lambda: contact.gradient(pressure)),
    "tangent": lambda: long(lambda: contact.tangent(target=1.0)),
    "direct": lambda: rc.direct.gp(hard, np.linspace(1, 2, size), tol=1e-16, max_iter=10**9, check=False),
    "flow": lambda: long(lambda: rc.flow(noise[:700, :700], pitch=1, viscosity=1, pressure_drop=1, memory=1, width=1e-12)),
    "generate": lambda: rc.surface.spectral((2047, 2047)),
    "analyze": lambda: rc.surface.psd(wide, pitch=1.0),
    "roughness": lambda: long(lambda: rc.surface.analyze(noise, pitch=1.0)),
    "power_law": lambda: long(lambda: rc.surface.power_law(noise, pitch=1.0)),
    "cmr_advice": lambda: long(lambda: rc.surface.cmr_advice(noise, 4, pitch=1.0)),
}
name = sys.argv[1]
call = calls[name]
in_product = name in ("solve", "history", "batch", "batch2", "law", "punch", "gradient", "tangent")
at = [0.0]


def begin(action):
    # action, in the middle of the call
    def now():
        at[0] = time.monotonic()
        action()

    armed[0], products[0], at[0] = True, 0, 0.0
    if in_product:
        act[0] = now
    else:
        timer = threading.Timer(0.2, now)
        timer.daemon = True
        timer.start()


def ended(*kinds):
    try:
        call()
    except kinds as error:
        late = time.monotonic() - at[0]
        assert at[0] and late < 15, f"ended {late:.2f} s late"  # of 30 s and more
        return error
    raise AssertionError("it ran to its end")


class Mine(Exception):
    pass


def raising(*_):
    raise Mine
"""

ENDINGS = {
    "signals": """
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background ignores it
begin(lambda: os.kill(os.getpid(), signal.SIGINT))
assert isinstance(ended(KeyboardInterrupt), rc.Interrupted) or not in_product

signal.signal(signal.SIGINT, signal.SIG_IGN)  # as of a program that a shell runs in the background
signal.signal(signal.SIGALRM, raising)
begin(lambda: os.kill(os.getpid(), signal.SIGALRM))
ended(Mine)

# A handler that raises nothing runs during the call: this one sends the signal that ends it.
signal.signal(signal.SIGUSR1, lambda *_: os.kill(os.getpid(), signal.SIGALRM))
begin(lambda: os.kill(os.getpid(), signal.SIGUSR1))
ended(Mine)
print("sound", flush=True)
""",
    "its end": """
signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGUSR1})  # after contact has started its threads
begun = threading.Event()
begin(begun.set)
threading.Thread(target=call, daemon=True).start()
assert begun.wait(20)
os.kill(os.getpid(), signal.SIGUSR1)
assert signal.sigtimedwait({signal.SIGUSR1}, 15) is not None
print("sound", flush=True)
""",
    "one thread": """
threading.stack_size(1 << 46)  # the system refuses a thread of this size
try:
    threading.Thread(target=print).start()
    raise SystemExit("a thread was started")
except RuntimeError:
    pass


def stop():
    raise Mine


many = many[:4]
if in_product:
    begin(stop)
    ended(Mine)
else:
    rc.surface.spectral(64), rc.surface.psd(noise[:65], pitch=1.0)
print("sound", flush=True)
""",
}
USUAL = ("solve", "history", "batch", "law", "punch", "gradient", "tangent", "flow", "generate", "analyze")
OTHERS = [pytest.param(name, marks=pytest.mark.slow) for name in ("batch2", "direct", "roughness", "power_law", "cmr_advice")]


@pytest.mark.parametrize("means", ENDINGS)
@pytest.mark.parametrize("name", [*USUAL, *OTHERS])
def test_call_ends(name, means):
    alone = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}  # NumPy's own threads do not block signals
    command = [sys.executable, "-c", CALLS + ENDINGS[means], name]
    ran = subprocess.run(command, capture_output=True, text=True, timeout=60, env=alone)
    assert (ran.stdout, ran.returncode) == ("sound\n", 0), f"{ran.returncode}: {ran.stderr[-2000:]}"
