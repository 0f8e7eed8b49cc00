"""Which tests would tell most: predicted intervals of tests that nobody has run yet."""
