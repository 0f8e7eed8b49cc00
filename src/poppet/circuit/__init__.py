"""Parts joined into a network that runs."""
