"""Sampling of points in the unit cube, one point per run.

The point of a run depends only on the seed and on the index of the run.

Slices in any order have identical bits. Random numbers come from a counter (Philox), a Latin hypercube from keyed
permutations, and a Sobol sequence from its binary digits.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Whole = NDArray[np.uint64]

METHODS = ("random", "latin", "sobol", "grid", "file")
MAX_SOBOL = 21_201
"""Maximum dimension of a Sobol sequence in SciPy."""
_BITS = 30
"""Binary digits of a Sobol point. Half of the last digit is added, so that no point is on the surface of the cube."""
_BLOCK_BITS = 10
"""Binary digits of the index of a Sobol point within its block."""
_ROUNDS = 4
_PHILOX_VALUES = 4
"""Number of random values that the Philox generator returns for one value of its counter."""
_STREAMS = {"random": 0, "latin": 1, "permutation": 2}


def points(method: str, seed: int, total: int, dimension: int, first: int, last: int, levels: tuple[int, ...]) -> Array:
    """Return the sample points of the runs `first` to `last` (excluded), as probabilities.

    The result has the shape (last - first, dimension), with values between 0 and 1 (excluded). `method` is the sampling
    method, and `total` the number of all runs. `levels` is the number of grid values in each dimension.
    """
    if method == "latin":
        jitter = uniform(seed, "latin", dimension, first, last)
        keys = _random_integers(seed, "permutation", _ROUNDS, 0, dimension)
        runs = np.arange(first, last, dtype=np.uint64)
        strata = np.stack([permute(runs, total, key) for key in keys], axis=1)
        # Rounding can give 1 in the last stratum.
        return np.minimum((strata + jitter) / total, 1.0 - 2.0**-53)
    if method == "sobol":
        # In base two the sequence is linear: point n is the exclusive or of the points of the powers of two in n.
        # Each block of points is therefore the first block shifted by one point. The order is that of SciPy.
        block, powers = _sobol_basis(seed, dimension, max(_BLOCK_BITS, (total - 1).bit_length()))
        indices = np.arange(first, last)
        blocks = np.arange(first >> _BLOCK_BITS, ((last - 1) >> _BLOCK_BITS) + 1)
        moves = np.zeros((blocks.size, dimension), dtype=np.uint64)
        for k, power in enumerate(powers):
            moves ^= np.where((blocks >> k & 1)[:, np.newaxis] == 1, power, np.uint64(0))
        digits = block[indices & (len(block) - 1)] ^ moves[(indices >> _BLOCK_BITS) - blocks[0]]
        return np.asarray((digits.astype(np.float64) + 0.5) * 2.0**-_BITS)
    if method == "grid":
        cells = np.unravel_index(np.arange(first, last), levels)
        # Midpoints of cells with equal probability.
        return np.stack([(p + 0.5) / n for p, n in zip(cells, levels, strict=True)], axis=1)
    return uniform(seed, "random", dimension, first, last)


def uniform(seed: int, stream: str, dimension: int, first: int, last: int) -> Array:
    """Return independent uniform random numbers in the open interval (0, 1).

    The result has the shape (last - first, dimension) and belongs to the runs `first` to `last` (excluded). `stream` is
    a name: different streams of the same seed are independent.
    """
    raw = _random_integers(seed, stream, dimension, first, last)
    return ((raw >> np.uint64(12)).astype(np.float64) + 0.5) * 2.0**-52


def _random_integers(seed: int, stream: str, dimension: int, first: int, last: int) -> Whole:
    # Each run has its own values of the counter, so results do not depend on the slices.
    ticks = -(-dimension // _PHILOX_VALUES)
    # The key is the seed, the upper half of the counter the stream.
    source = np.random.Philox(key=seed, counter=_STREAMS[stream] << 192)
    source.advance(first * ticks)
    raw = source.random_raw((last - first) * ticks * _PHILOX_VALUES)
    return np.asarray(raw, dtype=np.uint64).reshape(last - first, ticks * _PHILOX_VALUES)[:, :dimension]


# --- Latin hypercube ---


def permute(indices: Whole, total: int, keys: Whole) -> Whole:
    """Return the new positions of the `indices` in a random permutation of 0 to total - 1.

    The `keys` determine the permutation.

    A Feistel network of four rounds permutes 0 to n - 1, where n is the next power of four. Results that are not below
    `total` are permuted again (Black and Rogaway, Ciphers with arbitrary finite domains, CT-RSA 2002, cycle-walking).
    The bits are mixed by the finaliser of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
    """
    half = np.uint64(max(1, -(-max(total - 1, 1).bit_length() // 2)))
    mask = np.uint64((1 << int(half)) - 1)
    permuted_indices = indices.copy()
    pending = np.arange(permuted_indices.size)
    while pending.size:
        left, right = permuted_indices[pending] >> half, permuted_indices[pending] & mask
        for key in keys:
            mixed = right ^ key
            mixed = (mixed ^ (mixed >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
            mixed = (mixed ^ (mixed >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
            left, right = right, left ^ ((mixed ^ (mixed >> np.uint64(31))) & mask)
        permuted_indices[pending] = (left << half) | right
        pending = pending[permuted_indices[pending] >= total]
    return permuted_indices


# --- Sobol sequence ---


@lru_cache(maxsize=8)
def _sobol_basis(seed: int, dimension: int, bits: int) -> tuple[Whole, list[Whole]]:
    """Return the first block of a scrambled Sobol sequence, and numbers that shift it to later blocks.

    Coordinates are integers of `_BITS` bits. There is one shift for each power of two from the size of the block up to
    the number of points, 2^`bits`. A later block is the exclusive or of the first block and the shifts that correspond
    to the binary digits of its index.
    """
    from scipy.stats import qmc

    engine = qmc.Sobol(dimension, scramble=True, bits=_BITS, seed=seed)
    block = (engine.random(1 << _BLOCK_BITS) * 2.0**_BITS).astype(np.uint64)
    powers, position = [], 1 << _BLOCK_BITS
    for k in range(_BLOCK_BITS, bits):
        engine.fast_forward((1 << k) - position)
        powers.append((engine.random(1)[0] * 2.0**_BITS).astype(np.uint64) ^ block[0])
        position = (1 << k) + 1
    return block, powers
