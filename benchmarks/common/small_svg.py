"""Makes the SVG that matplotlib writes small; the picture stays the same.

Left out are metadata, names of groups, groups without a style, digits beyond a tenth of a point (a
hundredth in the shapes of marks), and turns by 0 degrees. Things of one style are drawn together, so
that the style stands once."""

import os
import re
import xml.etree.ElementTree as ElementTree

SVG = "{http://www.w3.org/2000/svg}"
LINE = 300  # characters; one element is never broken
LARGEST = 100_000  # bytes
FONT = "DejaVu Sans, Verdana, sans-serif"


def rounded(text, digits):
    def short(match):
        number = f"{float(match[0]):.{digits}f}"
        return re.sub(r"^-0$", "0", number.rstrip("0").rstrip(".") if "." in number else number)

    return re.sub(r"-?\d+\.\d+", short, text)


def path_data(text, digits):
    text = rounded(" ".join(text.split()), digits)
    return re.sub(r" ?([MLCQzZ]) ?", r"\1", text)


def tidy_attributes(element, inside_defs):
    for key in ("x", "y", "transform", "width", "height", "viewBox"):
        if key in element.attrib:
            element.set(key, rounded(element.get(key), 1))
    if "d" in element.attrib:
        element.set("d", path_data(element.get("d"), 2 if inside_defs else 1))
    if element.get("transform", "").startswith(("rotate(-0 ", "rotate(0 ")):
        del element.attrib["transform"]
    if "style" in element.attrib:
        style = element.get("style").replace("'DejaVu Sans'", FONT)
        element.set("style", re.sub(r"([:;]) +", r"\1", style))


def is_plain_group(element):
    return element.tag == SVG + "g" and not element.attrib


def flattened(children):
    """Groups without attributes give way to what is in them."""
    for child in children:
        if is_plain_group(child):
            yield from flattened(list(child))
        else:
            yield child


def look(element):
    """All that two things must have in common to be drawn as one, or None for a filled area."""
    if element.tag == SVG + "path" and "fill:none" in element.get("style", ""):
        return ("path", element.get("style"), element.get("clip-path"))
    if element.tag in (SVG + "use", SVG + "text") and "style" in element.attrib:
        return (element.tag, element.get("style"))
    return None


def drawn_together(children):
    """Lines of one look become one path; marks and words of one look come into a group. Nothing
    moves past a filled area, which may cover what is drawn before it."""
    result, places = [], {}
    for child in children:
        key = look(child)
        if key is None:
            places.clear()
            result.append(child)
        elif key not in places:
            places[key] = len(result)
            result.append(child)
        elif key[0] == "path":
            first = result[places[key]]
            first.set("d", first.get("d") + child.get("d"))
        else:
            result[places[key]] = joined(result[places[key]], child)
    return result


def joined(first, other):
    """Both in a group that has their style."""
    if first.tag != SVG + "g":
        group = ElementTree.Element(SVG + "g", {"style": first.attrib.pop("style")})
        group.append(first)
        first = group
    del other.attrib["style"]
    first.append(other)
    return first


def tidy(element, inside_defs=False):
    inside_defs = inside_defs or element.tag == SVG + "defs"
    if element.tag == SVG + "g":
        element.attrib.pop("id", None)
    tidy_attributes(element, inside_defs)
    for child in list(element):
        tidy(child, inside_defs)
    children = [c for c in element if c.tag != SVG + "metadata"]
    if not inside_defs:
        children = drawn_together(flattened(children))
    element[:] = children


def definitions_first(root):
    """Shapes of marks and clips into one place, so that equal things can stand together."""
    shared = ElementTree.Element(SVG + "defs")
    parents = {child: parent for parent in root.iter() for child in parent}
    for defs in list(root.iter(SVG + "defs")):
        parents[defs].remove(defs)
        shared.extend(list(defs))
    root.insert(0, shared)


def short_names(text):
    """Names of marks and clips are m1, m2, …"""
    names = dict.fromkeys(re.findall(r'\bid="([^"]+)"', text))
    for number, name in enumerate(names, 1):
        text = text.replace(f'id="{name}"', f'id="m{number}"')
        text = text.replace(f'"#{name}"', f'"#m{number}"').replace(f"(#{name})", f"(#m{number})")
    return text


def small(svg):
    """The text of the small SVG."""
    ElementTree.register_namespace("", SVG[1:-1])
    ElementTree.register_namespace("xlink", "http://www.w3.org/1999/xlink")
    root = ElementTree.fromstring(svg)
    for element in root.iter():
        if element.tag != SVG + "text" and not (element.text or "").strip():
            element.text = None
        element.tail = None
    definitions_first(root)
    tidy(root)
    text = short_names(ElementTree.tostring(root, encoding="unicode").replace(" />", "/>"))
    lines = [""]
    for piece in re.findall(r"<text[^>]*>[^<]*</text>|<[^>]*>[^<]*", text):
        if lines[-1] and len(lines[-1]) + len(piece) > LINE:
            lines.append("")
        lines[-1] += piece
    return "\n".join(lines) + "\n"


def check_picture(path):
    """Ends with a message unless the file is a small picture in which something is drawn."""
    drawn = sum(element.tag in (SVG + "path", SVG + "use", SVG + "text")
                for element in ElementTree.parse(path).iter())
    if drawn < 20:
        raise SystemExit(f"{path} is all but empty: {drawn} things are drawn in it")
    if os.path.getsize(path) > LARGEST:
        raise SystemExit(f"{path} has {os.path.getsize(path):,} bytes, more than {LARGEST:,}")
