"""Reports of bench tests on valves, and of the dynamic limits of a valve."""
