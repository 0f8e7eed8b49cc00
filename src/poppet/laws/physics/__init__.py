"""Laws of gas, heat transfer and contact, each one function for floats, arrays and symbols."""
