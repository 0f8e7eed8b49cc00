"""A law of hypothesis in two sizes: few examples every day, many with the slow tests."""

from __future__ import annotations

import pytest
from hypothesis import given, settings


def law(*strategies, few, many):
    """Decorate a test with its strategies; both sizes begin with the same examples."""

    def in_both_sizes(test):
        runs = {
            size: settings(max_examples=size, deadline=None, derandomize=True)(given(*strategies)(test))
            for size in (few, many)
        }

        # Not `functools.wraps`: pytest would look through it and take the law's arguments for fixtures.
        @pytest.mark.parametrize("examples", [few, pytest.param(many, marks=pytest.mark.slow)])
        def run(examples):
            runs[examples]()

        run.__name__, run.__doc__ = test.__name__, test.__doc__
        return run

    return in_both_sizes
