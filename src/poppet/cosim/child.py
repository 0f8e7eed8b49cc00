"""Program of the child process that loads one FMU and executes its functions.

A request is one line of JSON on the standard input, and the reply one line on the former standard output. The FMU
itself can write to the standard output: it is redirected to the standard error first. The parent checks all arguments.
"""

from __future__ import annotations

import json
import os
import shutil
import sys
import threading
import time
from collections.abc import Iterable
from typing import Any

FOLDER_PREFIX = "poppet-fmu-"
"""Beginning of the names of folders with unpacked FMUs."""
_DISCARD, _TERMINATED, _LAST_TIME = 2, 3, 2
"""Status `discard`, and the kinds of status of FMI 2.0 for the end of a simulation and the last successful time."""


class LoadedFmu:
    """FMU in this process, with the groups of its inputs and outputs by type."""

    def __init__(self, setup: dict[str, Any]) -> None:
        self.version, self.can_roll_back = setup["version"], setup["can_roll_back"]
        self.slope = setup["can_interpolate"] and not setup["is_sampled"]
        self.is_sampled, self.is_continuous, self.state = setup["is_sampled"], setup["is_continuous"], None
        self.inputs, self.outputs = setup["inputs"], setup["outputs"]
        arguments = {
            "guid": setup["token"], "unzipDirectory": setup["folder"], "modelIdentifier": setup["identifier"],
            "instanceName": setup["name"], "libraryPath": setup["library"], "requireFunctions": False,
        }  # fmt: skip
        self.fmu: Any
        if self.version == 2:
            from fmpy.fmi2 import FMU2Slave

            self.fmu = FMU2Slave(**arguments)
            self.fmu.instantiate(loggingOn=False)
            self.write(setup["start"])
            self.fmu.setupExperiment(startTime=0.0, tolerance=setup["tolerance"])
            self.fmu.enterInitializationMode()
        else:
            from fmpy.fmi3 import FMU3Slave

            self.fmu = FMU3Slave(**arguments)
            # Events are handled inside the FMU: a step always ends at the next communication point.
            self.fmu.instantiate(eventModeUsed=False, earlyReturnAllowed=False)
            self.write(setup["start"])
            self.fmu.enterInitializationMode(startTime=0.0, tolerance=setup["tolerance"])

    def write(self, groups: Iterable[tuple[str, list[int], list[Any]]]) -> None:
        """Set variables of several types; arrays contribute all their elements."""
        for type_, references, values in groups:
            if not references:
                continue
            if type_ == "Boolean":
                values = [v > 0.5 for v in values]
            elif type_ == "String":
                values = [str(v) for v in values]
            elif not type_.startswith("Float"):
                values = [round(v) for v in values]
            getattr(self.fmu, f"set{self._function(type_)}")(references, values)

    def _function(self, type_: str) -> str:
        """Return the name of a type in the functions of the FMI version."""
        return {"Float64": "Real", "Int32": "Integer"}.get(type_, type_) if self.version == 2 else type_

    def write_inputs(self, values: list[float]) -> None:
        """Set the inputs to values in the order of the declaration."""
        groups, k = [], 0
        for type_, references, size in self.inputs:
            groups.append((type_, references, values[k : k + size]))
            k += size
        self.write(groups)

    def read_outputs(self) -> list[float]:
        """Return the outputs in the order of the declaration."""
        result: list[float] = []
        for type_, references, size in self.outputs:
            read = getattr(self.fmu, f"get{self._function(type_)}")
            values = read(references) if self.version == 2 else read(references, nValues=size)
            result += [float(value) for value in values]
        return result

    def initialise(self, request: dict[str, Any]) -> dict[str, Any]:
        """Set the inputs at the start, return the outputs, and leave the initialisation mode if requested."""
        self.write_inputs(request["u"])
        if request["is_last"]:
            self.fmu.exitInitializationMode()
        return {"y": self.read_outputs()}

    def step(self, request: dict[str, Any]) -> dict[str, Any]:
        """Take one communication step; a repeated step starts from the saved state."""
        if request["is_repeated"]:
            self.restore()
        elif request["is_saved"]:
            self.save()
        time, duration, (first, middle, last) = request["t"], request["h"], request["u"]
        if not self.slope:
            self.write_inputs(first if self.is_sampled else self.mix(first, last, 0.5))
            end = self.advance(time, duration)
            if end is None and not self.is_sampled:
                # Outputs with direct feedthrough depend on the inputs at the end of the step.
                self.write_inputs(last)
            return {"y": self.read_outputs(), "end": end}
        # Two straight lines, whose integral is that of the parabola through the three points.
        straight = self.mix(first, last, 0.5)
        corner = self.mix(straight, middle, 4.0 / 3.0)
        half = 0.5 * duration
        self.ramp(first, corner, half)
        end = self.advance(time, half)
        self.write_inputs(middle)
        at_middle = self.read_outputs()
        if end is None:
            self.ramp(corner, last, half)
            end = self.advance(time + half, duration - half)
        return {"middle": at_middle, "y": self.read_outputs(), "end": end}

    def mix(self, first: list[float], last: list[float], weight: float) -> list[float]:
        """Interpolate continuous inputs linearly; discrete inputs keep their first value."""
        pairs = zip(first, last, self.is_continuous, strict=True)
        return [a + weight * (b - a) if is_continuous else a for a, b, is_continuous in pairs]

    def ramp(self, first: list[float], last: list[float], duration: float) -> None:
        """Set inputs that change linearly during the next step."""
        self.write_inputs(first)
        k = 0
        for type_, references, size in self.inputs:
            places, k = range(k, k + size), k + size
            if type_.startswith("Float"):
                slopes = [(last[i] - first[i]) / duration if self.is_continuous[i] else 0.0 for i in places]
                self.fmu.setRealInputDerivatives(references, [1] * size, slopes)

    def advance(self, time: float, duration: float) -> float | None:
        """Execute the step; if the FMU ends the simulation, return the time that it has reached."""
        if self.version == 3:
            _, has_ended, is_early, reached = self.fmu.doStep(time, duration, not self.can_roll_back)
            if has_ended or is_early:
                return float(reached)
            return None
        from fmpy.fmi1 import FMICallException

        try:
            self.fmu.doStep(time, duration, 0 if self.can_roll_back else 1)
        except FMICallException as problem:
            if problem.status != _DISCARD:
                raise
            try:
                has_ended = self.fmu.getBooleanStatus(_TERMINATED)
                reached = self.fmu.getRealStatus(_LAST_TIME)
            except FMICallException:
                raise problem from None
            if not has_ended:
                raise
            return float(reached)
        return None

    def save(self) -> None:
        """Save the state of the FMU in place of the last saved state."""
        get, free = ("getFMUstate", "freeFMUstate") if self.version == 2 else ("getFMUState", "freeFMUState")
        if self.state is not None:
            getattr(self.fmu, free)(self.state)
        self.state = getattr(self.fmu, get)()

    def restore(self) -> None:
        """Return to the saved state."""
        getattr(self.fmu, "setFMUstate" if self.version == 2 else "setFMUState")(self.state)

    def close(self) -> dict[str, Any]:
        """Terminate and free the FMU."""
        self.fmu.terminate()
        self.fmu.freeInstance()
        return {}


def end_with_parent(parent: int, folder: str = "") -> None:
    """End this process if its parent was killed, also during a call that does not return, and delete its folder."""
    while os.getppid() == parent:
        time.sleep(1.0)
    delete_folder(folder)
    os._exit(1)


def delete_folder(folder: str) -> None:
    """Delete the folder of an unpacked FMU, which a killed parent leaves; other folders are not deleted."""
    if os.path.basename(folder).startswith(FOLDER_PREFIX):
        shutil.rmtree(folder, ignore_errors=True)


def main() -> None:
    """Answer requests until the standard input ends."""
    folder = os.getcwd()  # now, because the FMU can change it
    if os.name == "posix":
        threading.Thread(target=end_with_parent, args=(os.getppid(), folder), daemon=True).start()
    requests = os.fdopen(os.dup(0), "rb")
    replies = os.fdopen(os.dup(1), "wb")
    with open(os.devnull, "rb") as nothing:
        os.dup2(nothing.fileno(), 0)
    os.dup2(2, 1)
    sys.stdout = sys.stderr

    def reply(content: dict[str, Any]) -> None:
        replies.write(json.dumps(content).encode() + b"\n")
        replies.flush()

    fmu: Any = None
    try:
        for line in requests:
            request = json.loads(line)
            try:
                if request["do"] == "load":
                    fmu = LoadedFmu(request)
                    reply({})
                else:
                    reply(getattr(fmu, request["do"])(request) if request["do"] != "close" else fmu.close())
            except Exception as failure:  # of the FMU or of FMPy; the parent reports it
                reply({"error": " ".join(str(failure).split())[:500]})
    finally:
        delete_folder(folder)


if __name__ == "__main__":
    main()
