"""A third-party package of the tests that was written for another version of the plugin interface."""

POPPET_API = 0
PART = object()
