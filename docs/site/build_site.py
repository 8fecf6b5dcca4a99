#!/usr/bin/env python3
"""Builds the site from the pages and the public headers; warnings are errors.

    docs/site/build_site.py FOLDER

FOLDER/html is the site: open FOLDER/html/index.html. Needs Doxygen, and Sphinx with MyST, Breathe
and Furo (scripts/install-dependencies site).
"""

import pathlib
import re
import shutil
import subprocess
import sys
from xml.etree import ElementTree

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]

# The pages of the reference, and the headers on each.
REFERENCE = {
    "Finding contact pairs": ["detect", "two_sets", "options", "progress", "statistics", "error"],
    "Elements": ["element_view", "points", "column", "fit_boxes", "simplex_contacts",
                 "spatial_order"],
    "Domains": ["domain", "image_shift"],
    "Results": ["pair", "pair_list", "neighbor_list"],
    "From a contact to a force": ["measure", "quantity", "pair_geometry"],
    "Who may pair": ["pair_rule", "group_table", "exclusion_list"],
    "Time steps": ["detector", "skin", "candidate_list", "contact_history"],
    "Walls": [
        "mesh_contacts",
        "triangle_mesh",
        "box_contacts",
        "feature_kind",
        "contact_list",
        "wall_history",
    ],
    "Algorithms and instruction sets": ["algorithm", "simd"],
    "Devices": ["device", "device_elements", "device_lists"],
    "A look inside": ["trace", "version"],
}
# Headers whose names lie in a name space within abut.
SPACES = {"trace": "trace", "device": "device", "device_elements": "device",
          "device_lists": "device"}
REFERENCE_HEAD = """The C++ interface
=================

Everything that ``#include <abut/abut.hpp>`` declares, from the comments of the headers. The name
space is ``abut``; names in ``abut::detail`` are not part of the interface. ``abut::trace`` needs
``#include <abut/trace.hpp>``, and ``abut::device`` ``<abut/device.hpp>``.

.. toctree::
   :maxdepth: 2

"""


def heading(text, line):
    return f"{text}\n{line * len(text)}\n\n"


def check_reference():
    """Each public header that declares something is on one page."""
    listed = sorted(name for names in REFERENCE.values() for name in names)
    there = sorted(path.stem for path in (ROOT / "include" / "abut").glob("*.hpp")
                   if path.stem not in ("abut", "export", "page_allocator"))
    if listed != there:
        raise SystemExit("docs/site/build_site.py: REFERENCE lacks or repeats "
                         f"{sorted(set(listed) ^ set(there))}")


def simplify(xml):
    """Takes out what Breathe stumbles over: the header of each class, which the page names, and the
    name space of each class, which the page sets."""
    for path in xml.glob("*.xml"):
        text = re.sub(r"\s*<includes .*?</includes>", "", path.read_text(encoding="utf-8"))
        if path.name.startswith(("class", "struct")):
            text = re.sub(rf"<compoundname>abut::(({'|'.join(set(SPACES.values()))})::)?", "<compoundname>", text)
        path.write_text(text, encoding="utf-8")


def header_of(entity):
    """The stem of the header that declares an entity."""
    return pathlib.Path(entity.find("location").get("file")).stem


def make_groups(xml):
    """Makes a group of what each header declares: Breathe shows a group, while it would repeat the
    name space with each file."""
    groups = {}
    for path in sorted(xml.glob("*_8hpp.xml")) + sorted(xml.glob("namespaceabut*.xml")):
        for member in ElementTree.parse(path).getroot().iter("memberdef"):
            groups.setdefault(header_of(member), []).append(member)
    for path in sorted(xml.glob("class*.xml")) + sorted(xml.glob("struct*.xml")):
        compound = ElementTree.parse(path).getroot().find("compounddef")
        name = compound.findtext("compoundname")
        if "::" in name:
            continue  # shown inside its class
        reference = ElementTree.Element("innerclass", refid=compound.get("id"), prot="public")
        reference.text = name
        reference.append(compound.find("location"))
        groups.setdefault(header_of(reference), []).append(reference)
    index = ElementTree.parse(xml / "index.xml")
    for header, entities in groups.items():
        write_group(xml, index.getroot(), header, entities)
    index.write(xml / "index.xml", encoding="unicode")


def write_group(xml, index, header, entities):
    """One group, its entities in the order of the header."""
    entities.sort(key=lambda entity: int(entity.find("location").get("line")))
    name = f"group__{header}"
    compound = ElementTree.SubElement(index, "compound", refid=name, kind="group")
    ElementTree.SubElement(compound, "name").text = header
    top = ElementTree.Element("doxygen")
    group = ElementTree.SubElement(top, "compounddef", id=name, kind="group")
    ElementTree.SubElement(group, "compoundname").text = header
    ElementTree.SubElement(group, "title").text = header
    for entity in entities:
        if entity.tag == "innerclass":
            group.append(entity)
    for entity in entities:
        if entity.tag == "memberdef":
            section = ElementTree.SubElement(group, "sectiondef", kind="user-defined")
            section.append(entity)
    ElementTree.ElementTree(top).write(xml / f"{name}.xml", encoding="unicode")


def concepts(xml):
    """{header: directives}: the concepts, which Breathe does not know."""
    result = {}
    for path in sorted(xml.glob("concept*.xml")):
        concept = ElementTree.parse(path).getroot().find("compounddef")
        name = concept.findtext("compoundname").removeprefix("abut::")
        parameter = concept.find("templateparamlist/param")
        words = [parameter.findtext("type"), parameter.findtext("declname") or ""]
        about = " ".join("".join(concept.find("detaileddescription").itertext()).split())
        header = header_of(concept)
        result[header] = result.get(header, "") + \
            f".. cpp:concept:: template <{' '.join(words).strip()}> {name}\n\n   {about}\n\n"
    return result


def write_reference(folder, xml):
    """The pages of the C++ interface."""
    folder.mkdir()
    of_header = concepts(xml)
    index = REFERENCE_HEAD
    for title, headers in REFERENCE.items():
        name = title.lower().replace(" ", "_")
        text = heading(f"Interface: {title[0].lower()}{title[1:]}", "=")
        for header in headers:
            space = "::".join(["abut", *filter(None, [SPACES.get(header)])])
            text += heading(f"abut/{header}.hpp", "-") + f".. cpp:namespace:: {space}\n\n"
            text += of_header.get(header, "")
            text += f".. doxygengroup:: {header}\n   :content-only:\n   :members:\n\n"
        (folder / f"{name}.rst").write_text(text, encoding="utf-8")
        index += f"   {name}\n"
    (folder / "index.rst").write_text(index, encoding="utf-8")


def stage(folder):
    """The source folder of Sphinx: the pages where they lie, the index, the reference."""
    folder.mkdir()
    for entry in ROOT.iterdir():
        if not entry.name.startswith((".", "build", "out")):
            (folder / entry.name).symlink_to(entry)
    index = (ROOT / "docs" / "README.md").read_text(encoding="utf-8")
    index = index.replace("](", "](docs/").replace("](docs/../include/abut/abut.hpp)",
                                                   "](reference/index.md)")
    (folder / "index.md").write_text(index.replace("](docs/../", "]("), encoding="utf-8")
    write_reference(folder / "reference", folder.parent / "xml")


def run(command, **settings):
    if subprocess.run(command, check=False, **settings).returncode != 0:
        raise SystemExit(f"docs/site/build_site.py: {command[0]} found faults (above)")


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    folder = pathlib.Path(sys.argv[1]).resolve()
    check_reference()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    settings = (HERE / "Doxyfile").read_text(encoding="utf-8")
    run(["doxygen", "-"], cwd=ROOT, text=True, input=f"{settings}OUTPUT_DIRECTORY = {folder}\n")
    simplify(folder / "xml")
    make_groups(folder / "xml")
    stage(folder / "source")
    run(["sphinx-build", "-q", "-W", "--keep-going", "-c", HERE, "-d", folder / "doctrees",
         "-D", f"breathe_projects.abut={folder / 'xml'}", "-D", f"project_root={ROOT}",
         folder / "source", folder / "html"])
    print(f"{folder / 'html' / 'index.html'}")


if __name__ == "__main__":
    main()
