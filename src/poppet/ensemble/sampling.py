"""Points of the unit cube, any slice of which follows from the seed and the numbers of its runs alone.

Whoever computes a slice, in whatever order and after whatever was lost, gets the same bits: random numbers come from a
counter (Philox), a Latin hypercube from permutations that are functions of a key, a Sobol sequence from its digits.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Whole = NDArray[np.uint64]

WAYS = ("random", "latin", "sobol", "grid", "file")
MOST_SOBOL = 21_201
"""Dimensions for which direction numbers are known."""
_BITS = 30
"""Digits of a Sobol point, to which half a digit is added: no point lies on the edge of the cube."""
_FEW = 10
"""Digits in the number of a Sobol point within its block."""
_ROUNDS = 4
_WORDS = 4
"""Numbers that Philox gives for each value of its counter."""
_STREAMS = {"random": 0, "latin": 1, "permutation": 2}


def points(way: str, seed: int, total: int, dimension: int, first: int, last: int, levels: tuple[int, ...]) -> Array:
    """Points of runs `first` up to `last` of `total`, (last - first, dimension), inside the open unit cube.

    `levels` is the number of steps of a grid in each dimension.
    """
    if way == "latin":
        return _latin(seed, total, dimension, first, last)
    if way == "sobol":
        return _sobol(seed, dimension, total, first, last)
    if way == "grid":
        places = np.unravel_index(np.arange(first, last), levels)
        # Middles of cells of equal probability: every point counts the same.
        return np.stack([(p + 0.5) / n for p, n in zip(places, levels, strict=True)], axis=1)
    return uniform(seed, "random", dimension, first, last)


def uniform(seed: int, stream: str, dimension: int, first: int, last: int) -> Array:
    """Independent uniform numbers of some runs, (last - first, dimension), in the open interval."""
    raw = _raw(seed, stream, dimension, first, last)
    return ((raw >> np.uint64(12)).astype(np.float64) + 0.5) * 2.0**-52


def _raw(seed: int, stream: str, dimension: int, first: int, last: int) -> Whole:
    # Every run owns as many values of the counter as its numbers need, so none depends on how runs are cut into slices.
    ticks = -(-dimension // _WORDS)
    # The key is the seed, the upper half of the counter the stream.
    source = np.random.Philox(key=seed, counter=_STREAMS[stream] << 192)
    source.advance(first * ticks)
    raw = source.random_raw((last - first) * ticks * _WORDS)
    return np.asarray(raw, dtype=np.uint64).reshape(last - first, ticks * _WORDS)[:, :dimension]


# --- Latin hypercube ---


def _latin(seed: int, total: int, dimension: int, first: int, last: int) -> Array:
    jitter = uniform(seed, "latin", dimension, first, last)
    keys = _raw(seed, "permutation", _ROUNDS, 0, dimension)
    runs = np.arange(first, last, dtype=np.uint64)
    strata = np.stack([permuted(runs, total, key) for key in keys], axis=1)
    # Of the last stratum rounding may make a one.
    return np.minimum((strata + jitter) / total, 1.0 - 2.0**-53)


def permuted(places: Whole, total: int, keys: Whole) -> Whole:
    """Where a permutation of 0 ... total - 1, which is a function of its keys, puts some places.

    A Feistel network of four rounds permutes the next power of four; what falls outside is permuted again (Black and
    Rogaway, Ciphers with arbitrary finite domains, CT-RSA 2002, cycle-walking).
    """
    half = np.uint64(max(1, -(-max(total - 1, 1).bit_length() // 2)))
    mask = np.uint64((1 << int(half)) - 1)
    found = places.copy()
    wanted = np.arange(found.size)
    while wanted.size:
        left, right = found[wanted] >> half, found[wanted] & mask
        for key in keys:
            left, right = right, left ^ (_mixed(right ^ key) & mask)
        found[wanted] = (left << half) | right
        wanted = wanted[found[wanted] >= total]
    return found


def _mixed(x: Whole) -> Whole:
    """The finaliser of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): every bit depends on all."""
    x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return x ^ (x >> np.uint64(31))


# --- Sobol sequence ---


def _sobol(seed: int, dimension: int, total: int, first: int, last: int) -> Array:
    """Points of a scrambled Sobol sequence in the order of SciPy's."""
    # In base two the sequence is linear: point n is the exclusive or of the points of the powers of two in n. So a
    # block of them is the first block, moved, and nothing has to be counted up from zero.
    block, powers = _sobol_basis(seed, dimension, max(_FEW, (total - 1).bit_length()))
    runs = np.arange(first, last)
    blocks = np.arange(first >> _FEW, ((last - 1) >> _FEW) + 1)
    moves = np.zeros((blocks.size, dimension), dtype=np.uint64)
    for k, power in enumerate(powers):
        moves ^= np.where((blocks >> k & 1)[:, np.newaxis] == 1, power, np.uint64(0))
    found = block[runs & (len(block) - 1)] ^ moves[(runs >> _FEW) - blocks[0]]
    return np.asarray((found.astype(np.float64) + 0.5) * 2.0**-_BITS)


@lru_cache(maxsize=8)
def _sobol_basis(seed: int, dimension: int, bits: int) -> tuple[Whole, list[Whole]]:
    """The first block of points as digits and, less the first of all, the points at the powers of two behind it."""
    from scipy.stats import qmc

    engine = qmc.Sobol(dimension, scramble=True, bits=_BITS, seed=seed)
    block = (engine.random(1 << _FEW) * 2.0**_BITS).astype(np.uint64)
    powers, at = [], 1 << _FEW
    for k in range(_FEW, bits):
        engine.fast_forward((1 << k) - at)
        powers.append((engine.random(1)[0] * 2.0**_BITS).astype(np.uint64) ^ block[0])
        at = (1 << k) + 1
    return block, powers
