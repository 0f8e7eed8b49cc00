"""Running the shards that are missing, on threads, processes, Dask, or any executor."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor, wait
from contextlib import contextmanager
from typing import Any

from poppet.core.errors import InputError, NameSuggestion, OutOfRangeError, needed
from poppet.engine.batch import usable_cores
from poppet.ensemble.dataset import Dataset
from poppet.ensemble.designs import KINDS, design_of
from poppet.ensemble.ensemble_plan import EnsemblePlan
from poppet.ensemble.shards import work

Progress = Callable[[int, int, str], Any]
"""Called with the number of runs of a kind that are done, of all of that kind, and the kind; one after the other."""
EXECUTORS = ("threads", "processes")
MOST_WORKERS = 4096
_AHEAD = 2
"""Shards that wait for each worker."""
_UNKNOWN = 32
"""Workers that an executor is taken to have which does not say."""


def run_missing(
    plan: EnsemblePlan, dataset: Dataset, executor: Any, workers: int | None, progress: Progress | None
) -> bool:
    """Run the shards that are not there yet; False where Ctrl-C has ended it, and what was done by then is kept."""
    todo: list[tuple[str, int]] = []
    sizes: dict[tuple[str, int], int] = {}
    total = {kind: design_of(plan, kind).size for kind in KINDS}
    done = dict(total)
    for kind in KINDS:
        design = design_of(plan, kind)
        for number in dataset.missing(plan, kind):
            todo.append((kind, number))
            sizes[kind, number] = min(design.shard, design.size - number * design.shard)
            done[kind] -= sizes[kind, number]
    if not todo:
        return True
    key, pickled = str(dataset.manifest["sha256"]) + str(plan.indices), pickle.dumps(plan)
    kernel = dataset.manifest["versions"]["kernel"]
    if workers is not None and not 1 <= workers <= MOST_WORKERS:
        raise OutOfRangeError("ensemble.count", "workers", value=workers, low=1, high=MOST_WORKERS)
    with _opened(executor, workers, len(todo)) as (pool, width):
        waiting: dict[Future[Any], tuple[str, int]] = {}
        rest = iter(todo)
        try:
            while True:
                for task in rest:
                    waiting[pool.submit(work, key, pickled, *task, kernel)] = task
                    if len(waiting) >= _AHEAD * width:
                        break
                if not waiting:
                    return True
                ready, _ = wait(waiting, 0.2, FIRST_COMPLETED)
                for future in ready:
                    dataset.write(future.result())
                    task = waiting.pop(future)
                    done[task[0]] += sizes[task]
                if progress is not None:
                    kind = next((kind for kind in KINDS if done[kind] < total[kind]), todo[-1][0])
                    progress(done[kind], total[kind], kind)
        except KeyboardInterrupt:
            _keep(dataset, waiting)
            return False
        except BaseException:
            # A full disk, say: nobody waits for what cannot be kept.
            for future in waiting:
                future.cancel()
            raise


def _keep(dataset: Dataset, waiting: dict[Future[Any], tuple[str, int]]) -> None:
    """Keep what has been finished, and give up the rest."""
    for future in waiting:
        if not future.cancel() and future.done() and future.exception() is None:
            dataset.write(future.result())


@contextmanager
def _opened(executor: Any, workers: int | None, shards: int) -> Iterator[tuple[Any, int]]:
    """An executor by name or address, a Dask client, or one that is somebody's own and stays open; and its width."""
    if executor in EXECUTORS:
        width = max(1, min(workers or usable_cores(), shards))
        if executor == "threads":
            pool: Executor = ThreadPoolExecutor(width)
        else:
            import multiprocessing

            # A fork of a process with threads may copy a lock that is held.
            pool = ProcessPoolExecutor(width, multiprocessing.get_context("spawn"))
        try:
            yield pool, width
        finally:
            pool.shutdown(wait=True, cancel_futures=True)
        return
    if isinstance(executor, str):
        if "://" not in executor and ":" not in executor:
            raise InputError("ensemble.executor", value=executor, near=NameSuggestion(executor, EXECUTORS))
        with needed("distributed", "Dask", "dask"):
            import distributed
        with distributed.Client(executor) as client:
            yield _of_dask(client)
        return
    if hasattr(executor, "get_executor"):
        yield _of_dask(executor)
    elif hasattr(executor, "submit"):
        yield executor, getattr(executor, "_max_workers", _UNKNOWN)
    else:
        raise InputError("ensemble.executor", value=str(executor), near=NameSuggestion(str(executor), EXECUTORS))


def _of_dask(client: Any) -> tuple[Any, int]:
    # Pure tasks of one name would be one task; these differ in their arguments, and are never asked for again.
    return client.get_executor(pure=False), max(1, sum(client.nthreads().values()))
