"""Execution of missing shards (groups of runs) with threads, processes, Dask or another executor."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor, wait
from contextlib import contextmanager
from typing import Any

from poppet.core.errors import InputError, NameSuggestion, needed
from poppet.core.tables import Field
from poppet.engine.batch import usable_cores
from poppet.ensemble.dataset import Dataset
from poppet.ensemble.ensemble_plan import KINDS, EnsemblePlan
from poppet.ensemble.shards import run_shard

Progress = Callable[[int, int, str], Any]
"""Callback with the completed runs of a kind, all runs of that kind, and the kind."""
EXECUTORS = ("threads", "processes")
WORKERS = Field(type="integer", low=1, high=4096, meaning="number of workers")
_QUEUED_PER_WORKER = 2
"""Maximum number of submitted shards per worker."""
_DEFAULT_WIDTH = 32
"""Assumed number of workers if an executor does not report it."""


def run_missing(
    plan: EnsemblePlan, dataset: Dataset, executor: Any, workers: int | None, progress: Progress | None
) -> bool:
    """Run all missing runs of an ensemble on several workers, and store their results.

    The runs are divided into shards, groups of runs that one worker completes and stores together. The result is False
    if Ctrl-C stopped the execution.
    """
    todo: list[tuple[str, int]] = []
    sizes: dict[tuple[str, int], int] = {}
    total = {kind: plan.counts(kind)[0] for kind in KINDS}
    done = dict(total)
    for kind in KINDS:
        shard_size = plan.counts(kind)[1]
        for number in dataset.missing(plan, kind):
            todo.append((kind, number))
            sizes[kind, number] = min(shard_size, total[kind] - number * shard_size)
            done[kind] -= sizes[kind, number]
    if not todo:
        return True
    key, pickled = str(dataset.manifest["sha256"]) + str(plan.indices), pickle.dumps(plan)
    kernel = dataset.manifest["versions"]["kernel"]
    if workers is not None:
        WORKERS.read(workers, "workers")
    with _open_pool(executor, workers, len(todo)) as (pool, width):
        waiting: dict[Future[Any], tuple[str, int]] = {}
        tasks = iter(todo)
        try:
            while True:
                for task in tasks:
                    waiting[pool.submit(run_shard, key, pickled, *task, kernel)] = task
                    if len(waiting) >= _QUEUED_PER_WORKER * width:
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
            # Store the completed shards, and cancel all others.
            for future in waiting:
                if not future.cancel() and future.done() and future.exception() is None:
                    dataset.write(future.result())
            return False
        except BaseException:
            # Results cannot be stored, for example on a full disk.
            for future in waiting:
                future.cancel()
            raise


@contextmanager
def _open_pool(executor: Any, workers: int | None, shards: int) -> Iterator[tuple[Any, int]]:
    """Open a pool of workers, and yield it with the number of its workers.

    `executor` is a name, a Dask address, a Dask client, or an executor of the caller, which is not closed. `shards` is
    the number of tasks.
    """
    if executor in EXECUTORS:
        width = max(1, min(workers or usable_cores(), shards))
        if executor == "threads":
            pool: Executor = ThreadPoolExecutor(width)
        else:
            import multiprocessing

            # A fork of a process with threads can copy a locked lock.
            pool = ProcessPoolExecutor(width, multiprocessing.get_context("spawn"))
        try:
            yield pool, width
        finally:
            pool.shutdown(wait=True, cancel_futures=True)
        return
    if isinstance(executor, str):
        if "://" not in executor and ":" not in executor:
            raise InputError("ensemble.executor", value=executor, suggestion=NameSuggestion(executor, EXECUTORS))
        with needed("distributed", "Dask", "dask"):
            import distributed
        with distributed.Client(executor) as client:
            yield _dask_pool(client)
        return
    if hasattr(executor, "get_executor"):
        yield _dask_pool(executor)
    elif hasattr(executor, "submit"):
        yield executor, getattr(executor, "_max_workers", _DEFAULT_WIDTH)
    else:
        raise InputError("ensemble.executor", value=str(executor), suggestion=NameSuggestion(str(executor), EXECUTORS))


def _dask_pool(client: Any) -> tuple[Any, int]:
    # Dask merges pure tasks of one name; these tasks differ in their arguments.
    return client.get_executor(pure=False), max(1, sum(client.nthreads().values()))
