"""Functions of poppet for assistants, over the Model Context Protocol or as lines of JSON."""
