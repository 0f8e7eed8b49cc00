"""Foundation of all packages: errors, units, sources of parameters, files. It imports no other package of poppet."""
