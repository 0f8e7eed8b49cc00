"""Drive the machine of two_cylinders_machine.toml through A+ B+ B- A- as a PLC does, then with a stuck valve.

Start the machine first: poppet serve examples/serve/two_cylinders_machine.toml --modbus 127.0.0.1:5020
Run with: python examples/serve/two_cylinders_client.py [PORT]
"""

from __future__ import annotations

import struct
import sys
import time
from collections.abc import Callable

from pymodbus.client import ModbusTcpClient

VALVE_A, VALVE_B = 0, 1  # coils
B_STUCK_CLOSED = 17  # coil
A_BACK, A_OUT, B_BACK, B_OUT, PRESSED = range(5)  # discrete inputs
TIME = 0  # input registers, float64
SCAN, TIMEOUT = 0.01, 2.0  # [s]
STEPS = {
    "A+": ((True, False), (A_OUT,)),
    "B+": ((True, True), (B_OUT, PRESSED)),
    "B-": ((True, False), (B_BACK,)),
    "A-": ((False, False), (A_BACK,)),
}
"""Name of each step to the commands of both valves, and to the switches that end it."""


def machine_time(client: ModbusTcpClient) -> float:
    """Return the time of the machine [s]."""
    registers = client.read_input_registers(TIME, count=4).registers
    (seconds,) = struct.unpack(">d", struct.pack(">4H", *registers))
    return float(seconds)


def run_cycle(client: ModbusTcpClient, wait: Callable[[float], object] = time.sleep) -> dict[str, float]:
    """Run one cycle, and return the duration of each step [s]."""
    durations = {}
    for name, (commands, switches) in STEPS.items():
        client.write_coils(VALVE_A, list(commands))
        begin = machine_time(client)
        while True:
            wait(SCAN)
            duration = machine_time(client) - begin
            bits = client.read_discrete_inputs(A_BACK, count=5).bits
            if all(bits[k] for k in switches):
                break
            if duration > TIMEOUT:
                raise TimeoutError(f"step {name} has not ended after {duration:.2f} s")
        durations[name] = duration
    return durations


def main() -> None:
    """Run a cycle, then one with a stuck valve, then one without."""
    port = int(sys.argv[1]) if len(sys.argv) > 1 else 5020
    with ModbusTcpClient("127.0.0.1", port=port) as client:
        print("cycle:", ", ".join(f"{name} {duration:.2f} s" for name, duration in run_cycle(client).items()))
        client.write_coil(B_STUCK_CLOSED, True)
        try:
            run_cycle(client)
        except TimeoutError as error:
            print("valve B is stuck:", error)
        client.write_coil(B_STUCK_CLOSED, False)
        client.write_coils(VALVE_A, [False, False])
        time.sleep(1.0)
        print("repaired:", ", ".join(f"{name} {duration:.2f} s" for name, duration in run_cycle(client).items()))


if __name__ == "__main__":
    main()
