"""Fit the recordings of this folder, compare each circuit with two linear models, draw validation windows.

The measured data are not part of the repository; the fit files state their source. Usage:

    python examples/regulators/compare.py [PICTURE.png]
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from poppet.identify import baselines, identify_fit, read_fit_file, score_table
from poppet.identify.baseline_models import fit_arx, fit_first_order, responses_of

FOLDER = Path(__file__).parent
REGULATOR, LUNG = {"arm.pressure": "controller.setpoint"}, {"airway.pressure": "inhale.stroke"}
FITS = {f"fit_itv0050_{k}.toml": REGULATOR for k in (1, 2, 4, 5)} | {f"fit_test_lung_{k}.toml": LUNG for k in (1, 5)}
SHOWN = {
    "fit_itv0050_2.toml": "again.arm.pressure",
    "fit_itv0050_5.toml": "late.arm.pressure",
    "fit_test_lung_1.toml": "held.airway.pressure",
}
"""Validation windows in the figure."""


def compare(name: str) -> tuple[str, dict[str, tuple[np.ndarray, ...]]]:
    """Return the table of scores of a fit file, and time and pressures of the drawn window."""
    plan, result = read_fit_file(FOLDER / name), identify_fit(FOLDER / name)
    channel, command = next(iter(FITS[name].items()))
    numbers = "\n".join(f"  {key}: {e.value:.4g} {e.unit}, {e.verdict}" for key, e in result.parameters.items())
    text = f"{plan.title}\n{score_table(baselines(plan, FITS[name], result))}\n{numbers}\n"
    if name not in SHOWN:
        return text, {}
    seen = [r for e in plan.experiments for r in responses_of(e.measurement, {channel: command})]
    held = [r for e in plan.validation for r in responses_of(e.measurement, {channel: command})]
    response = next(r for r in held if r.name == SHOWN[name])
    shown = {
        "measured": response.measured,
        "circuit": result.series[response.name]["model"],
        "first order + dead time": fit_first_order(seen).simulate(response),
        "ARX": fit_arx(seen).simulate(response),
    }
    return text, {label: (response.time, values) for label, values in shown.items()}


def draw(panels: dict[str, dict[str, tuple[np.ndarray, ...]]], path: str) -> None:
    """Draw one panel per window."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    looks = {
        "measured": ("0.1", 2.2, "-"),
        "circuit": ("C3", 1.6, "-"),
        "first order + dead time": ("C0", 1.0, "--"),
        "ARX": ("C2", 1.0, ":"),
    }
    figure, axes = plt.subplots(len(panels), 1, figsize=(9.0, 3.0 * len(panels)), layout="constrained")
    for axis, (title, series) in zip(axes, panels.items(), strict=True):
        for label, (time, values) in series.items():
            colour, width, line = looks[label]
            axis.plot(time, 1e-5 * values, line, color=colour, linewidth=width, label=label)
        axis.set_title(title, loc="left", fontsize=10)
        axis.set_ylabel("pressure in bar")
        axis.grid(alpha=0.3)
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=4)
    axes[-1].set_xlabel("time from the start of the window in s")
    figure.savefig(path, dpi=110)


def main() -> None:
    panels = {}
    for name in FITS:
        text, series = compare(name)
        print(text)
        if series:
            panels[f"{text.splitlines()[0]}, held out: {SHOWN[name]}"] = series
    if len(sys.argv) > 1:
        draw(panels, sys.argv[1])


if __name__ == "__main__":
    main()
