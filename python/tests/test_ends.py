# SPDX-License-Identifier: GPL-3.0-or-later
"""How a process ends that computes: daemon threads, children of forks, subinterpreters. Nothing here depends on how
far a thread has come."""

import subprocess
import sys

import pytest

from support import HANGING

# Three daemon threads that call without end; the program ends once each has begun. Whatever they are doing then, the
# process ends well.
PROGRAM = """
import annulus, atexit, numpy as np, os, sys, threading, time
x = np.random.default_rng(0).random((3000, 3))
begun = threading.Semaphore(0)
shared = annulus.MovingDelaunay(x)
def work():
    own = annulus.MovingDelaunay(x[:500])
    begun.release()
    while True:
        CALL
for _ in range(3):
    threading.Thread(target=work, daemon=True).start()
for _ in range(3):
    begun.acquire()
"""

CALLS = {
    "construction": "annulus.MovingDelaunay(x)",
    "small construction": "annulus.MovingDelaunay(x[:50])",
    "move": "own.move(own.points[::-1].copy())",
    "move of float32": "own.move(own.points[::-1].astype(np.float32))",
    "move of one object": "shared.move(x[::-1].copy()); shared.move(x)",
    "move of some": "own.move(x[:5] + 0.01, indices=range(5)); own.move(x[:5].tolist(), indices=range(5))",
    "insert and remove": "own.remove(own.insert(x[700:720]))",
    "readings": "own.move(own.points + 0.1); own.simplices; own.tolerances; own.convex_hull; own.voronoi_volumes(); "
    "own.find_simplex(x)",
    "audit": "shared.audit()",
    "degeneracy": "annulus.degeneracy(x)",
    "lloyd": "annulus.lloyd(500, 10**6)",
    "lloyd with a callback": "annulus.lloyd(50, 10**6, callback=lambda *_: time.sleep(1e-4))",
    "a callback that never ends": "annulus.lloyd(50, 10**6, callback=lambda *_: threading.Event().wait())",
    "nodt": "annulus.nodt('sphere', 100, 10**6)",
    "threads of the library": "annulus.MovingDelaunay(x, threads=2).move(x[::-1].copy())",
    "raising": "\n        try: own.move(np.zeros((500, 3)))\n        except annulus.Error: pass",
    "a batch": "annulus.MovingDelaunayBatch(x.reshape(6, 500, 3), threads=2).move(x[::-1].reshape(6, 500, 3))",
    "raising in a batch": "\n        try: annulus.MovingDelaunayBatch(np.zeros((2, 50, 3)))\n        "
    "except annulus.Error: pass",
}


def ends_well(program, words=""):
    done = subprocess.run([sys.executable, "-B", "-c", program], capture_output=True, text=True, timeout=HANGING,
                          check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, words, ""), done


@pytest.mark.parametrize("call", CALLS)
def test_daemon_threads(call):
    ends_well(PROGRAM.replace("CALL", CALLS[call]))


def test_what_is_computed_at_the_end():
    """By what is called at exit, and by a destructor, in the thread that ends Python, while others compute."""
    ends_well(PROGRAM.replace("CALL", "shared.move(x[::-1].copy())") + """
class Last:
    def __del__(self, dt=annulus.MovingDelaunay(x[:20]), write=os.write):
        assert dt.audit() and len(dt.points) == 20
        write(1, b"last\\n")
atexit.register(lambda: (shared.move(x), print(bool(shared.audit())), sys.stdout.flush()))
sys.last = Last()
""", "True\nlast\n")


def test_a_child_of_a_fork_waits_for_no_thread_that_it_has_not():
    """Others compute when the process is forked; the child ends as any process does."""
    ends_well(PROGRAM.replace("CALL", "annulus.degeneracy(x)") + """
child = os.fork()
if child == 0:
    assert annulus.MovingDelaunay(x[:50]).audit()
    sys.exit(7)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
""", "7\n")


@pytest.mark.parametrize("before", ["", "import annulus"])
def test_a_subinterpreter_is_refused(before):
    """Also where the main interpreter has imported it before, whose objects it would be handed."""
    name = "_interpreters" if sys.version_info >= (3, 13) else "_xxsubinterpreters"
    pytest.importorskip(name)
    ends_well(f"""
{before}
import {name} as interpreters
there = interpreters.create()
interpreters.run_string(there, '''
try:
    import annulus
except ImportError as e:
    import os
    os.write(1, str(e).encode())
''')
import annulus
assert annulus.MovingDelaunay([[0, 0], [1, 0], [0, 1]]).audit()
""", "annulus works in the main interpreter only, and this is a subinterpreter")


def test_a_long_call_looks_for_signals():
    """While one call lasts a handler runs again and again; and what it raises ends the call."""
    for call in ("dt.audit()", "annulus.degeneracy(x)"):
        ends_well("""
import annulus, numpy as np, os, signal, threading
x = np.random.default_rng(0).random((30_000, 3))
dt = annulus.MovingDelaunay(x)
handled = threading.Semaphore(0)
runs = 0
def handler(number, frame):
    global runs
    runs += 1
    handled.release()
    dt.npoints  # the triangulation is at hand meanwhile
signal.signal(signal.SIGUSR1, handler)
def send():
    while not over:
        os.kill(os.getpid(), signal.SIGUSR1)
        handled.acquire()
over = False
sender = threading.Thread(target=send)
sender.start()
most = 0
while most <= 4:  # the sender may have no processor for as long as a call takes, or many calls
    before = runs
    CALL
    most = max(most, runs - before)
over = True
sender.join()
print(most > 4)
def raising(number, frame):
    handled.release()
    if frame.f_code.co_name in ("audit", "degeneracy"):
        raise KeyError("enough")
signal.signal(signal.SIGUSR1, raising)
over = False
sender = threading.Thread(target=send)
try:
    sender.start()
    while True: CALL
except KeyError as e:
    over = True
    print(e)
sender.join()
""".replace("CALL", call), "True\n'enough'\n")
