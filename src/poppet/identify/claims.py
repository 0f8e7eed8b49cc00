"""No claim rests on a number that the data do not determine: what each finding takes for known, and what it is else."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from poppet.core.codes import Note
from poppet.identify.result import Estimate


class Basis(NamedTuple):
    """The numbers that a finding takes for known."""

    facts: tuple[str, ...] = ()  # of the note, that hold their addresses; `address` is its own
    otherwise: str = ""  # code of what is said where one of them is open; nothing is said where it is empty


SAMPLES = Basis()
"""Of what is said of samples, residuals, tests and searches, or of how well a number is known."""

RESTS_ON: Mapping[str, Basis] = {
    "finding.choking.never": Basis(("number",), "finding.choking.perhaps_never"),
    "flow.none_choked": Basis(("address",), "flow.none_choked_perhaps"),
    "flow.unusual_conductance": Basis(("address",)),
    **dict.fromkeys(
        (
            *(f"finding.alike.{way}" for way in ("changed", "scaled")),
            *("finding.bootstrap", "finding.profile"),
            *("finding.choking.perhaps_never", "finding.choking.throughout"),
            *("finding.gauge", "finding.held_out", "finding.interrupted", "finding.local", "finding.sampled"),
            *(f"finding.models.{how}" for how in ("alike", "clearly", "somewhat")),
            *(f"finding.number.{case}" for case in ("bound", "not_determined", "not_moved", "weak")),
            *("finding.offset.small", "finding.offset.widens", "finding.optima.heat", "finding.optima.other"),
            *("finding.area", "finding.ratio", "finding.trials"),  # each with an interval, or the misfit, of its own
            *(f"finding.other_model.{how}" for how in ("alike", "clear", "doubt", "none", "somewhat")),
            *("finding.capped", "finding.other_models", "finding.room", "finding.wall"),
            *("finding.residuals.large", "finding.residuals.not_white"),
            *("finding.contour.one", "finding.contour.several", "finding.laws.one", "finding.laws.several"),
            *(f"finding.stopped.{what}" for what in ("bootstrap", "contour", "laws", "profile")),
            *(f"finding.tell_apart.{what}" for what in ("other", "ratio", "volume", "wall")),
            *("finding.unexplained.constant", "finding.unexplained.range"),
            *(f"finding.unusual.{what}" for what in ("conductance", "volume", "wall")),
            *("flow.absolute_as_gauge", "flow.ambient_assumed", "flow.below_atmosphere", "flow.gauge_as_absolute"),
            *("flow.at_bound", "flow.gauge_twin", "flow.no_cracking_pressure", "flow.ratio_open"),
            *("flow.choked_only", "flow.choked_says_nothing", "flow.none_choked_perhaps", "flow.perhaps_none_choked"),
            *(
                "flow.error_needed",
                "flow.near_one",
                "flow.near_one_uncertain",
                "flow.one_point",
                "flow.only_one_point",
                "flow.outlier",
            ),
            *(
                "flow.other_law",
                "flow.pattern",
                "flow.pattern_free",
                "flow.residuals_too_large",
                "flow.residuals_too_small",
            ),
            *("flow.scatter_estimated", "flow.scatter_only"),
            *("characteristic.b_of_one", "characteristic.negative_b", "characteristic.negative_c"),
            *("characteristic.blind", "characteristic.by_numbers", "characteristic.continued", "characteristic.gap"),
            *("characteristic.falls", "characteristic.may_never_fall", "characteristic.not_joint"),
            *("characteristic.misfit", "characteristic.not_repeated", "characteristic.room"),
            *("characteristic.twin", "characteristic.two_ways"),
            *("friction.supported", "friction.not_supported", "friction.not_told", "friction.other_minimum"),
            *("friction.narrow", "friction.bounded", "friction.bristles", "friction.no_reversals"),
            *(
                "friction.bristles_unresolved",
                "friction.damping_coarse",
                "friction.damping_open",
                "friction.force_late",
                "friction.one_pressure",
                "friction.no_pressure",
            ),
            *("friction.two_pressures", "friction.between", "friction.pressure_moves", "friction.one_side"),
            *("friction.sides_open", "friction.lopsided", "friction.even", "friction.break_away", "friction.places"),
            *("friction.misfit", "friction.velocity", "friction.short_strokes", "friction.smeared", "friction.at_zero"),
        ),
        SAMPLES,
    ),
}
"""By code; a test sees to it that every finding of an identification is here."""


def upheld(notes: Iterable[Note], estimates: Mapping[str, Estimate]) -> tuple[Note, ...]:
    """The notes whose numbers are determined, and what remains of the others."""
    said = []
    for note in notes:
        # Notes of recordings come from below, and rest on samples.
        basis = RESTS_ON.get(note.code, SAMPLES)
        named = [note.address if fact == "address" else note.facts[fact] for fact in basis.facts]
        if all(estimates[name].verdict == "determined" for name in named if name in estimates):
            said.append(note)
        elif basis.otherwise:
            said.append(Note(basis.otherwise, note.address, **note.facts))
    return tuple(said)
