"""abut: which discrete elements touch?

>>> import abut
>>> abut.contacts([[0, 0, 0], [1, 0, 0]], 0.5).pairs
array([[0, 1]], dtype=uint32)
"""

from . import _interpreter  # noqa: F401, I001  (comes before all else)
from ._abut import build_description, simd_levels
from ._abut import version as _version
from ._algorithms import AlgorithmInfo, algorithms
from ._contacts import Contacts
from ._detect import contacts, count_contact_pairs, find_contact_pairs
from ._detector import Detector, SkinStatistics
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
from ._files import Snapshot, read, write
from ._fit_boxes import fit_boxes
from ._geometry import PairGeometry
from ._history import ContactHistory
from ._measure import PairMeasurer, measure
from ._mesh import Motion, TriangleMesh
from ._neighbors import NeighborList, build_neighbor_list, neighbors
from ._options import Options
from ._rules import ExclusionList, GroupTable, PairRule
from ._simplices import SimplexContacts, Simplices, find_simplex_contacts, touching
from ._spatial_order import spatial_order
from ._statistics import Statistics
from ._wall_contacts import BoxContacts, FeatureKind, MeshContacts
from ._wall_history import BoxContactHistory, MeshContactHistory
from ._walls import find_box_contacts, find_mesh_contacts

__version__ = _version()

__all__ = [
    "AlgorithmInfo",
    "BoxContactHistory",
    "BoxContacts",
    "Cancelled",
    "CheckError",
    "ContactHistory",
    "Contacts",
    "Detector",
    "Domain",
    "Elements",
    "Error",
    "ExclusionList",
    "FeatureKind",
    "GroupTable",
    "InputError",
    "InputTypeError",
    "LimitError",
    "MeshContactHistory",
    "MeshContacts",
    "Motion",
    "NeighborList",
    "Options",
    "OutputError",
    "PairGeometry",
    "PairMeasurer",
    "PairRule",
    "SimplexContacts",
    "Simplices",
    "SkinStatistics",
    "Snapshot",
    "Statistics",
    "TriangleMesh",
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
    "find_box_contacts",
    "find_contact_pairs",
    "find_mesh_contacts",
    "find_simplex_contacts",
    "fit_boxes",
    "measure",
    "neighbors",
    "points",
    "read",
    "rectangles",
    "simd_levels",
    "spatial_order",
    "spheres",
    "touching",
    "write",
]
