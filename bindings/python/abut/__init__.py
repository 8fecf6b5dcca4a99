"""abut: which discrete elements touch?

>>> import abut
>>> abut.contacts([[0, 0, 0], [1, 0, 0]], 0.5).pairs
array([[0, 1]], dtype=uint32)
"""

from ._abut import build_description, simd_levels
from ._abut import version as _version
from ._algorithms import AlgorithmInfo, algorithms
from ._contacts import Contacts
from ._detect import contacts, count_contact_pairs, find_contact_pairs
from ._domain import Domain
from ._elements import Elements, boxes, discs, points, rectangles, spheres
from ._errors import (
    Cancelled,
    CheckError,
    Error,
    InputError,
    InputTypeError,
    LimitError,
    OutputError,
    UnavailableError,
    UnexpectedError,
    UsageError,
)
from ._neighbors import NeighborList, build_neighbor_list, neighbors
from ._options import Options
from ._rules import ExclusionList, GroupTable, PairRule
from ._statistics import Statistics

__version__ = _version()

__all__ = [
    "AlgorithmInfo",
    "Cancelled",
    "CheckError",
    "Contacts",
    "Domain",
    "Elements",
    "Error",
    "ExclusionList",
    "GroupTable",
    "InputError",
    "InputTypeError",
    "LimitError",
    "NeighborList",
    "Options",
    "OutputError",
    "PairRule",
    "Statistics",
    "UnavailableError",
    "UnexpectedError",
    "UsageError",
    "algorithms",
    "boxes",
    "build_description",
    "build_neighbor_list",
    "contacts",
    "count_contact_pairs",
    "discs",
    "find_contact_pairs",
    "neighbors",
    "points",
    "rectangles",
    "simd_levels",
    "spheres",
]
