"""Laws of gas, heat transfer, contact and muscles for floats, arrays and symbols."""
