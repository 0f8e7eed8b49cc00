"""Tables of numbers in files of many formats: names, units and columns, without interpretation."""
