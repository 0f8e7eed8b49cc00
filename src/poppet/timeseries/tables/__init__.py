"""Tables of numbers in files of many formats, as they are: names, units, columns, and no interpretation."""
