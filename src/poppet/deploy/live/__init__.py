"""Export as an HTML page that simulates the circuit in WebAssembly."""
