"""Command line of poppet: one module per group of commands.

`poppet.cli.commands` declares all commands.
"""
