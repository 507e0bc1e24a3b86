"""remesh_many(): collections of meshes, on any executor."""
from __future__ import annotations

import concurrent.futures
import hashlib
import os
import pathlib
import tempfile
import threading
import time
from collections import deque
from typing import Any, Callable, Deque, Dict, Iterable, List, NamedTuple, Optional, Union

import numpy as np

from . import _arrays
from ._files import read, write
from ._manifest import Manifest
from ._remesh import remesh
from ._results import Mesh, Remesh
from ._core import has_mesh_name, version

Path = Union[str, "os.PathLike[str]"]
Row = Dict[str, Any]

# What remesh() takes that belongs to no mesh alone.
_OPTIONS = {"count", "edge_length", "tolerance", "field", "features", "adapt", "equal_error", "growth", "fit"}
_UNDER_WAY = 256  # tasks that an executor has at a time: enough for its workers, little to keep


class ManyProgress(NamedTuple):
    """Where remesh_many() stands: after each mesh."""

    done: int
    total: int
    row: Row  #: of this mesh


class _Task(NamedTuple):
    input: str
    output: str
    options: Dict[str, Any]
    threads: int
    known: Optional[Row]  #: its row of an earlier run


def remesh_many(inputs: Union[Path, Iterable[Path]], output_folder: Path, *, executor: Any = None,
                format: str = "ply", threads: int = 1, progress: Optional[Callable[[ManyProgress], Any]] = None,
                **options: Any) -> List[Row]:
    """Remeshes many files, each into ``output_folder/NAME.ply``, and keeps a manifest there.

    Parameters
    ----------
    inputs : a folder, whose files with the extension of a mesh are taken; or paths
    executor : who works: any concurrent.futures executor, such as dask.distributed's Client.get_executor() or
        mpi4py.futures.MPIPoolExecutor(); its workers see the same files. A function that makes one is called
        again where one broke, as a process pool does when a process dies. None: threads of this process
    format : of the remeshes: the extension
    threads : of each mesh
    progress : is called with a ManyProgress after each mesh
    options : count, edge_length, tolerance, field ("curvature"), features, adapt, equal_error, growth, fit: as remesh() has them

    Returns
    -------
    list of dict : a row per input, in their order: input, output, vertices, triangles, fingerprint, seconds,
        sha256 and so on; ``warnings`` are those of the remesh, ``error`` is None, or the sentence that says why there is no remesh

    The rows are also in ``manifest.jsonl``, one per line, as soon as they are known. A further call does what is
    missing: it leaves out what is done, with the same options and the same version, and whose file is unchanged.
    One bad mesh stops nothing, and a worker that dies costs its mesh only. Large files are started first.
    """
    paths = _paths(inputs)
    _check(options, format, threads)
    folder = pathlib.Path(output_folder)
    folder.mkdir(parents=True, exist_ok=True)
    tasks = _tasks(paths, folder, format, options, threads)
    with Manifest(folder / "manifest.jsonl") as manifest:
        tasks = [task._replace(known=manifest.row(task.input)) for task in tasks]
        waiting = [task for task in tasks if not _is_done(task)]
        waiting.sort(key=lambda task: -_size(task.input))
        done = len(tasks) - len(waiting)

        def note(task: _Task, row: Row) -> None:
            nonlocal done
            done += 1
            manifest.add(row)
            if progress:
                progress(ManyProgress(done, len(tasks), row))

        if waiting:
            _Runner(executor, note).run(waiting)
        return [manifest.row(task.input) for task in tasks]


def _paths(inputs: Union[Path, Iterable[Path]]) -> List[pathlib.Path]:
    if isinstance(inputs, (str, os.PathLike)):
        folder = pathlib.Path(inputs)
        if not folder.is_dir():
            return [folder]
        found = sorted(path for path in folder.iterdir() if path.is_file() and has_mesh_name(str(path)))
        if not found:
            raise ValueError(f"{folder}: no meshes in this folder")
        return found
    return [pathlib.Path(path) for path in inputs]


def _check(options: Dict[str, Any], format: str, threads: int) -> None:
    """Before any work: what would fail for every mesh."""
    unknown = sorted(set(options) - _OPTIONS)
    if unknown:
        raise ValueError(f"{unknown[0]}: no option of many meshes: give some of {', '.join(sorted(_OPTIONS))}")
    tetrahedron = Mesh(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]]),
                       np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]))
    sizes = {"tolerance": 10, "edge_length": 1, "count": 4}  # what that mesh can have
    for name in sizes.keys() & options.keys():
        if name == "count":
            _arrays.whole(name, options[name], 4, 2**31 - 1)
        else:
            _arrays.positive(name, options[name])
    remesh(tetrahedron, **{**options, **{name: size for name, size in sizes.items() if name in options}}, threads=threads)
    with tempfile.TemporaryDirectory() as folder:
        write(os.path.join(folder, f"tetrahedron.{format}"), tetrahedron)


def _tasks(paths: List[pathlib.Path], folder: pathlib.Path, format: str, options: Dict[str, Any],
           threads: int) -> List[_Task]:
    tasks = []
    input_of: Dict[str, str] = {}
    all_inputs = {os.path.realpath(path) for path in paths}
    for path in paths:
        output = str(folder / f"{path.name.split('.')[0] if path.suffix in ('.gz', '.zst') else path.stem}.{format}")
        if output in input_of:
            raise ValueError(f"{path}: its remesh would be {output}, as that of {input_of[output]}: rename one of them")
        if os.path.realpath(output) in all_inputs:
            raise ValueError(f"{output}: is an input: give another folder")
        input_of[output] = str(path)
        tasks.append(_Task(str(path), output, options, threads, None))
    return tasks


def _size(path: str) -> int:
    try:
        return os.path.getsize(path)
    except OSError:
        return 0


def _stamp(path: str) -> Dict[str, int]:
    stat = os.stat(path)
    return {"bytes": stat.st_size, "mtime_ns": stat.st_mtime_ns}


def _fits(task: _Task) -> bool:
    """Whether the row of an earlier run is of such a run."""
    row = task.known
    return (row is not None and row["error"] is None and row["options"] == task.options and row["version"] == version
            and row["output"] == task.output and os.path.exists(task.output))


def _is_done(task: _Task) -> bool:
    """Without reading the file: by its size and time."""
    try:
        return _fits(task) and _stamp(task.input).items() <= task.known.items()  # type: ignore[union-attr]
    except OSError:
        return False


def _sentence(error: BaseException) -> str:
    return " ".join(str(error).split()) or type(error).__name__


def _new_row(task: _Task) -> Row:
    return {"input": task.input, "output": task.output, "options": task.options, "version": version, "sha256": None,
            "bytes": None, "mtime_ns": None, "fingerprint": None, "vertices": None, "triangles": None, "seconds": None,
            "warnings": None, "error": None}


def _work(task: _Task, stop: Optional[threading.Event] = None) -> Optional[Row]:
    """What a worker does: a row, whatever comes. None where it was stopped."""
    row = _new_row(task)
    start = time.perf_counter()
    try:
        row.update(_stamp(task.input))
        row["sha256"] = hashlib.sha256(pathlib.Path(task.input).read_bytes()).hexdigest()
        if _fits(task) and task.known["sha256"] == row["sha256"]:  # type: ignore[index]
            return {**task.known, **_stamp(task.input)}  # type: ignore[dict-item]
        made: Remesh = remesh(read(task.input), **task.options, threads=task.threads,
                              progress=stop and (lambda _: not stop.is_set()))
        if made.report["interrupted"]:
            return None
        write(task.output, made.vertices, made.faces)
        row.update(fingerprint=made.fingerprint, vertices=len(made.vertices), triangles=len(made.faces),
                   warnings=made.warnings)
    except MemoryError:
        row["error"] = f"{task.input}: out of memory"
    except (ValueError, OSError) as error:
        text = _sentence(error)
        row["error"] = text if task.input in text else f"{task.input}: {text}"
    row["seconds"] = round(time.perf_counter() - start, 6)
    return row


def _threads_of_this_process() -> concurrent.futures.Executor:
    return concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0)))


class _Runner:
    """Keeps an executor busy, and goes on where one breaks."""

    def __init__(self, executor: Any, note: Callable[[_Task, Row], None]) -> None:
        self._stop = threading.Event() if executor is None else None
        self._make = _threads_of_this_process if executor is None else executor if callable(executor) else None
        self._executor = self._make() if self._make else executor
        self._note = note
        self._running: Dict[Any, _Task] = {}
        self._suspects: Deque[_Task] = deque()  # under way when a worker died: from now on one at a time

    def run(self, tasks: Iterable[_Task]) -> None:
        waiting = deque(tasks)
        try:
            while waiting or self._suspects or self._running:
                self._submit(waiting)
                done, _ = concurrent.futures.wait(self._running, return_when=concurrent.futures.FIRST_COMPLETED)
                was_alone = len(self._running) == 1
                broken = [task for task in map(self._finish, done) if task]
                if broken:
                    self._begin_again(broken + self._take_running(), was_alone)
        except BaseException:
            if self._stop:
                self._stop.set()
            for future in self._running:
                future.cancel()
            raise
        finally:
            if self._make:
                self._executor.shutdown()

    def _submit(self, waiting: Deque[_Task]) -> None:
        if self._suspects:
            if not self._running:
                self._start(self._suspects.popleft())
            return
        while waiting and not self._suspects and len(self._running) < _UNDER_WAY:
            self._start(waiting.popleft())

    def _start(self, task: _Task) -> None:
        try:
            self._running[self._executor.submit(_work, task, *([self._stop] if self._stop else []))] = task
        except concurrent.futures.BrokenExecutor:  # noticed only now
            self._begin_again(self._take_running() + [task], False)

    def _take_running(self) -> List[_Task]:
        tasks = list(self._running.values())
        self._running.clear()
        return tasks

    def _finish(self, future: Any) -> Optional[_Task]:
        """Notes the row; gives the task back where the executor broke."""
        task = self._running.pop(future)
        try:
            row = future.result()
        except concurrent.futures.BrokenExecutor:
            return task
        except Exception as error:  # of the executor: such as Dask's KilledWorker
            row = {**_new_row(task), "error": f"{task.input}: the worker failed: {_sentence(error)}"}
        if row is not None:
            self._note(task, row)
        return None

    def _begin_again(self, tasks: List[_Task], was_alone: bool) -> None:
        if was_alone or not self._make:
            for task in tasks:
                what = "its worker died" if was_alone else "the executor broke: run it again with a new one"
                self._note(task, {**_new_row(task), "error": f"{task.input}: {what}"})
            tasks = []
        if not self._make:
            raise concurrent.futures.BrokenExecutor(
                "a worker died and took the executor along: call again, with a function that makes one") from None
        self._executor.shutdown(wait=False)
        self._executor = self._make()
        self._suspects.extend(tasks)
