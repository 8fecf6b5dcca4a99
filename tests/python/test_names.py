"""Python has what the public headers have, under the same names; tables list the exceptions."""

import dataclasses
import re

import pytest
from conftest import SOURCES

import abut

HEADERS = SOURCES / "include" / "abut"

# Names of the headers that Python has under another name or in another form.
ELSEWHERE = {
    "ElementView": "Elements",
    "PairList": "Contacts",
    "ContactList": "MeshContacts",
    "BoxContact": "BoxContacts.records",
    "BoxContactList": "BoxContacts",
    "BoxFeature": "BoxContacts.side",
    "MeshContact": "MeshContacts.records",
    "MeshContactList": "MeshContacts",
    "MeshFeature": "MeshContacts.number",
    "LostBoxContact": "BoxContactHistory.lost",
    "LostContact": "ContactHistory.lost",
    "LostMeshContact": "MeshContactHistory.lost",
    "FittedBoxes": "fit_boxes",
    "fit_boxes_2d": "fit_boxes",
    "fit_boxes_3d": "fit_boxes",
    "gap": "Contacts.gap",
    "ContactPair": "Contacts.pairs",
    "ElementIndex": "Contacts.pairs",
    "ImageShift": "Contacts.shift",
    "PairArray": "Contacts.pairs",
    "ShiftArray": "Contacts.shift",
    "PairTraits": "PairRule",
    "Skin": "Detector.skin",
    "ErrorCode": "Error.code",
    "SimplexView": "Simplices",
    "simplices_2d": "Simplices",
    "simplices_3d": "Simplices",
}
# Types that are words, numbers or arguments in Python, and the option that takes them.
ARGUMENTS = {
    "Algorithm": "algorithm",
    "Order": "order",
    "Shifts": "shifts",
    "Simd": "simd",
    "ProgressHook": "progress",
    "Progress": "progress",
    "Quantity": "quantities",
    "Quantities": "quantities",
    "ProgressAction": "progress",
    "PairCount": "max_pairs",
    "unlimited_pairs": "max_pairs",
    "automatic_memory_bound": "max_bytes",
}
# What Python needs no name for.
NOT_NEEDED = {
    "Axes": "text such as 'xy'",
    "unbounded": "None as a length",
    "NeighborListKind": "kind=",
    "PairGeometrySpans": "measure returns its arrays",
    "ContactSpans": "measure takes records of contacts and shifts",
    "PairSpans": "measure takes the tables pairs and shifts",
    "Vector": "a row of an array is one",
    "NumberArray": "an array is one",
    "VectorArray": "an array is one",
    "Precision": "Elements.precision is text",
    "Shape": "Elements.shape is text",
    "Real": "the type of an array says it",
    "Column": "an array is one",
    "ColumnLike": "an array is one",
    "ColumnScalar": "the type of an array says it",
    "column": "an array is one",
    "Connectivity": "an array is one",
    "SharedVertices": "shared_vertices= takes the word",
    "WorkerNumber": "no visitors",
    "PairBatchVisitor": "no visitors: a call of Python for each batch would hold all workers up",
    "ShiftedBatchVisitor": "no visitors",
    "for_each_batch": "no visitors",
    "for_each_shifted_batch": "no visitors",
    "for_each_contact_pair": "no visitors",
    "for_each_shifted_pair": "no visitors",
    "info": "algorithms() has all",
    "algorithm_named": "algorithm= takes the name",
    "name_of": "names are text",
    "available": "simd_levels() lists what is available",
    "simd_named": "simd= takes the name",
    "simd_variable": "ABUT_SIMD works in Python, too",
    "version": "__version__",
    "CandidateList": "loops over candidates are for compiled code: Detector with a skin",
    # Of namespace trace
    **dict.fromkeys(
        [
            *("Array", "CellSystem", "IndexedBy", "Meaning", "Partition", "SearchStep", "Sink"),
            *("first_partition", "integerise", "run"),
        ],
        "the arrays of the book's algorithms are shown by the tool: abut explain",
    ),
}
# The classes of Python for those of C++, and members that they have in another form or not at all.
CLASSES = {
    "AlgorithmInfo": "AlgorithmInfo",
    "BoxContactHistory": "BoxContactHistory",
    "ContactHistory": "ContactHistory",
    "ContactList": "MeshContacts",
    "Detector": "Detector",
    "Domain": "Domain",
    "ElementView": "Elements",
    "ExclusionList": "ExclusionList",
    "GroupTable": "GroupTable",
    "MeshContactHistory": "MeshContactHistory",
    "NeighborList": "NeighborList",
    "PairGeometry": "PairGeometry",
    "PairList": "Contacts",
    "PairMeasurer": "PairMeasurer",
    "PairRule": "PairRule",
    "SimplexView": "Simplices",
    "TriangleMesh": "TriangleMesh",
}
MEMBERS_ELSEWHERE = {
    "begin": "a list is not walked through: its arrays are",
    "boxes": "fit_boxes(mesh.vertices, mesh.triangles)",
    "center": "positions",
    "common_radius": "radii",
    "contacts": "records",
    "distances": "distance",
    "empty": "len",
    "end": "a list is not walked through: its arrays are",
    "first_elements": "what it was made for",
    "for_each_batch": "no visitors",
    "for_each_shifted_batch": "no visitors",
    "gaps": "gap",
    "has_common_radius": "radii",
    "is_empty": "a rule is left out",
    "normals": "normal",
    "offsets": "what an ExclusionList was made of",
    "options": "each call may give others",
    "partners": "what an ExclusionList was made of",
    "partners_of": "contains",
    "points": "point",
    "row": "list[i], and offsets for other arrays",
    "second_elements": "what it was made for",
    "set_options": "each call may give others",
    "set_skin": "skin",
    "shifts": "shift",
    "shifts_of": "offsets",
    "size": "len",
    "spans": "its arrays",
    "take_neighbors": "what is kept is kept",
    "take_pairs": "what is kept is kept",
    "triangle_count": "np.bincount of edges_of_triangles or triangles",
    "vector": "vectors",
    "vectors": "vector",
    "words": "for devices, which abut.Detector has not",
}


def text_of(header):
    """A header without its comments and without namespaces that Python leaves out: detail, and
    device, a library of its own for programs that keep their elements in the memory of a GPU."""
    text = (HEADERS / header).read_text()
    if "namespace abut::detail {" in text or "namespace abut::device {" in text:
        return ""
    text = re.sub(r"^namespace detail \{.*?^\}  // namespace detail", "", text, flags=re.S | re.M)
    return re.sub(r"//[^\n]*", "", text)


def public_names():
    """Names that the public headers declare in namespace abut and those below it."""
    names = set()
    for header in HEADERS.glob("*.hpp"):
        text = text_of(header.name)
        for pattern in (
            r"^(?:template <[^\n]*>\n)?(?:class|struct|enum class) (?:ABUT_API )?(\w+)",
            r"^using (\w+) =",
            r"^concept (\w+) =",
            r"^inline constexpr [\w:\s*]+?(\w+) =",
            r"^(?:requires[^\n]*\n)?(?:\[\[nodiscard\]\] )?(?:ABUT_API |constexpr )?"
            r"[\w:<>&]+(?: [\w:<>&]+)* (\w+)\(",
        ):
            names |= set(re.findall(pattern, text, re.MULTILINE))
    return names - {"requires"}


def has(path):
    value = abut
    for name in path.split("."):
        if not hasattr(value, name):
            return False
        value = getattr(value, name)
    return True


def test_every_name_of_the_headers_is_accounted_for():
    names = public_names()
    assert {"Domain", "find_contact_pairs", "Detector", "spheres", "unbounded"} <= names
    listed = set(ELSEWHERE) | set(ARGUMENTS) | set(NOT_NEEDED)
    known = set(abut.__all__) | listed
    assert names - known == set(), "give them a place in Python, or in a table above"
    assert listed - names == set(), "no longer there"


def test_the_tables_are_true():
    assert [path for path in ELSEWHERE.values() if not has(path)] == []
    assert set(ARGUMENTS.values()) <= set(abut.Options.__annotations__)
    assert all(hasattr(abut, name) for name in abut.__all__)


def fields(header, struct):
    """Names of the members of a struct."""
    body = re.search(rf"^struct {struct} \{{(.*?)^\}};", text_of(header), re.DOTALL | re.MULTILINE)
    return re.findall(r"^  [\w:<>]+ (\w+)(?: =[^;]*|\{\})?;", body[1], re.MULTILINE)


@pytest.mark.parametrize(
    ("header", "python"),
    [("statistics.hpp", abut.Statistics), ("skin.hpp", abut.SkinStatistics)],
)
def test_statistics_have_the_same_fields(header, python):
    found = fields(header, python.__name__)
    assert len(found) >= 8
    assert found == [field.name for field in dataclasses.fields(python)]


def test_options_have_the_same_names():
    found = set(fields("options.hpp", "Options"))
    assert {"margin", "threads"} <= found
    python = set(abut.Options.__annotations__)
    assert found - python == set()
    assert python - found == {"domain", "groups", "exclude"}


def public_members(header):
    """Classes of a header with the names of their public functions."""
    classes = r"^(?:class|struct) (?:ABUT_API )?(\w+)[^;{]*\{(.*?)^\};"
    functions = (
        r"^  (?:template <[^\n]*>\n  )?(?:\[\[nodiscard\]\] )?"
        r"[\w:<>&*, \n]+?[\w>&*]\s+(\w+)\("
    )
    for name, body in re.findall(classes, text_of(header), re.DOTALL | re.MULTILINE):
        public = re.split(r"^ (?:private|protected):", body, flags=re.MULTILINE)[0]
        public = re.sub(r"requires\([^)]*\)\s*|\{[^{}]*\}", "", public)
        yield name, set(re.findall(functions, public, re.MULTILINE)) - {name, "operator"}


def test_classes_have_the_same_members():
    members = {
        name: found
        for header in HEADERS.glob("*.hpp")
        for name, found in public_members(header.name)
    }
    assert {"find_contact_pairs", "set_ids"} <= members["Detector"]
    assert {"periodic", "lees_edwards"} <= members["Domain"]
    assert {"feature_shifts", "edges"} <= members["TriangleMesh"]
    missing = {
        (cpp, name)
        for cpp, python in CLASSES.items()
        for name in members[cpp]
        if not has(f"{python}.{name}") and name not in getattr(abut, python).__annotations__
    }
    assert {name for _, name in missing} == set(MEMBERS_ELSEWHERE), "give them a place, or a reason"
