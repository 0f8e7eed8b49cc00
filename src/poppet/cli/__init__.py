"""The command line: one module per command, registered in `poppet.cli.main`."""
