"""Virtual devices: a circuit that runs in real time and speaks the protocols of a plant."""
