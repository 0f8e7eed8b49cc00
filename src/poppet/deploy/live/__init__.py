"""A page in which the model itself runs, as WebAssembly."""
