"""Functions of other packages, with their names, arguments and arrays, on the search of abut.

`abut.compat.ase`, `abut.compat.matscipy`, `abut.compat.vesin` and `abut.compat.scipy` need not have
those packages installed, but for symbols of elements in cutoffs. The cutoff is included, exactly.
"""
