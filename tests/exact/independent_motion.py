"""Positions of a body with strokes of known times, from closed forms; shares no code with the package."""

from __future__ import annotations

import numpy as np

STEP = 1e-3


def draw_motion(seed, alternate, noise=0.0):
    """Return time, position, speed, the commands and the true travels of random strokes after a long one.

    Each small stroke is 5 to 15 % of the long one. With `alternate`, each stroke reverses the previous one. Strokes
    end with an overshoot, with rebounds at a stop, or by creep. `noise` is the standard deviation relative to the long
    stroke.
    """
    generator = np.random.default_rng(seed)
    whole = generator.uniform(0.05, 0.5)
    sizes = whole * np.concatenate(([1.0], generator.choice([0.05, 0.1, 0.15], 4)))
    signs = np.ones(5) if generator.random() < 0.5 else -np.ones(5)
    signs[1:] *= (-1.0) ** np.arange(1, 5) if alternate else generator.choice([-1.0, 1.0], 4)
    time = np.arange(0.0, 12.0, STEP)
    position, commands, command = np.zeros(time.size), [], generator.uniform(0.2, 0.5)
    for size, sign in zip(sizes, signs, strict=True):
        duration = generator.uniform(0.15, 0.6) * max(np.sqrt(size / whole), 0.3)
        start = command + generator.uniform(0.01, 0.1)
        s = np.clip((time - start) / duration, 0.0, 1.0)
        path = s**3 * (10.0 - 15.0 * s + 6.0 * s**2)  # least jerk
        after = np.clip(time - start - duration, 0.0, None)
        match generator.integers(3):
            case 0:  # an overshoot of a second-order loop; it starts at the arrival with zero speed
                pulse, decay = 2.0 * np.pi / duration, generator.uniform(3.0, 6.0) / duration
                peak = generator.uniform(0.02, 0.12)
                path = path + peak * np.exp(-decay * after) * np.sin(pulse * after) ** 2 * (after > 0.0)
            case 1:  # three rebounds of decreasing height: parabolas
                height, length, begin = generator.uniform(0.02, 0.12), 0.3 * duration, 0.0
                for _ in range(3):
                    u = np.clip((after - begin) / length, 0.0, 1.0)
                    path = path - 4.0 * height * u * (1.0 - u)
                    begin, height, length = begin + length, 0.25 * height, 0.5 * length
            case _:  # creep over the last hundredth
                path = path * 0.99 + 0.01 * (1.0 - np.exp(-after / duration)) * (after > 0.0)
        position += sign * size * path
        commands.append(command)
        command = start + duration + generator.uniform(1.2, 1.6)
    speed = np.abs(np.gradient(position, time))
    return time, position + noise * whole * generator.standard_normal(time.size), speed, commands, signs * sizes
