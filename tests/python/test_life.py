"""Threads, memory, progress, interrupts."""
import gc
import inspect
import os
import resource
import signal
import subprocess
import sys
import threading
import weakref
from concurrent.futures import ThreadPoolExecutor

import pytest

import geolloyd


def test_threads_may_call_at_once(torus, creature):
    def work(number):
        mesh = torus if number % 2 else creature
        return geolloyd.remesh(mesh, 100, threads=1 + number % 3).fingerprint, geolloyd.relax(mesh, 20).fingerprint

    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(work, range(12)))
    assert len(set(found[::2])) == 1 and len(set(found[1::2])) == 1 and len(set(found)) == 2


def test_python_goes_on_meanwhile(creature):
    ticks = []
    stop = threading.Event()

    def tick():
        while not stop.wait(0.001):
            ticks.append(1)

    ticker = threading.Thread(target=tick)
    ticker.start()
    before = len(ticks)
    geolloyd.remesh(creature, 1000, threads=1)
    during = len(ticks) - before
    stop.set()
    ticker.join()
    assert during > 5


def test_progress_is_told_and_may_end_the_work(creature):
    told = []
    whole = geolloyd.remesh(creature, 2000, progress=told.append, threads=1)
    assert told and isinstance(told[0], geolloyd.RemeshProgress) and told[-1].wanted_vertices == 2000
    assert not whole.report["interrupted"]
    stopped = geolloyd.remesh(creature, 2000, progress=lambda p: False)
    assert stopped.report["interrupted"] and stopped.fingerprint != whole.fingerprint
    steps = []
    ended = geolloyd.relax(creature, 50, progress=lambda p: steps.append(p) or False)
    assert ended.end == "interrupted" and isinstance(steps[0], geolloyd.TessellationProgress)


def test_an_error_of_the_callback_arrives(creature):
    class Mine(Exception):
        pass

    def fail(progress):
        raise Mine

    for work in (lambda: geolloyd.remesh(creature, 500, progress=fail), lambda: geolloyd.relax(creature, 50, progress=fail)):
        with pytest.raises(Mine):
            work()


INTERRUPTED = """
import geolloyd, os, signal, threading
mesh = geolloyd.generate("creature", 100_000)
threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    {call}
except KeyboardInterrupt:
    print("interrupted")
print(geolloyd.remesh(mesh, 20).report["is_manifold"])
"""


@pytest.mark.parametrize("call", ["geolloyd.remesh(mesh, 100_000, threads=1)",
                                  "geolloyd.relax(mesh, 4000, init='random', graph='mixed', threads=1)"])
def test_ctrl_c(call):
    done = subprocess.run([sys.executable, "-c", INTERRUPTED.format(call=call)], capture_output=True, text=True, timeout=120)
    assert done.stdout.split() == ["interrupted", "True"], done.stderr


def test_arrays_outlive_what_made_them(creature):
    tessellation = geolloyd.relax(creature, 20)
    region, expected = tessellation.region, tessellation.region.copy()
    dual = tessellation.dual()
    faces, expected_faces = dual.faces, dual.faces.copy()
    gone = weakref.ref(tessellation)
    del tessellation, dual
    gc.collect()
    geolloyd.relax(creature, 30)
    assert gone() is None and (region == expected).all() and (faces == expected_faces).all()
    region[0] = 7  # it is the user's


def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


@pytest.mark.skipif("libasan" in os.environ.get("LD_PRELOAD", ""), reason="the sanitizer keeps what is freed")
def test_a_thousand_calls_take_no_more_memory_than_a_hundred(torus):
    bad = torus.faces - 1

    def once():
        geolloyd.voronoi(torus, [1, 2, 3], threads=1).dual(threads=1)
        geolloyd.remesh(torus, 10, threads=1)
        geolloyd.quality(torus)
        with pytest.raises(ValueError):
            geolloyd.remesh(torus.vertices, bad, 10)

    for _ in range(25):
        once()
    before = peak()
    for _ in range(225):  # a thousand calls, as each time there are four
        once()
    assert peak() - before < 8 << 20


def test_help_reads_well():
    for name in geolloyd.__all__:
        thing = getattr(geolloyd, name)
        assert inspect.getdoc(thing), name
    assert "shape" in geolloyd.remesh.__doc__ and "(n, 3)" in geolloyd.relax.__doc__


def test_signals_are_heard_while_a_graph_is_built():
    """Python's handlers run while the work goes on; else all signals would be one at its end.

    A fast machine may end a call before a third one is heard, so there are several calls.
    """
    mesh = geolloyd.generate("creature", 400_000)
    heard = []
    most = 0
    before = signal.signal(signal.SIGALRM, lambda *_: heard.append(1))
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)
        for _ in range(20):
            heard.clear()
            geolloyd.distances(mesh, sources=[0])
            most = max(most, len(heard))
            if most > 2:
                break
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert most > 2
