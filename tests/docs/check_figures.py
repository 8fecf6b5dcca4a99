"""The committed figures are those that their script draws."""

import argparse
import filecmp
import pathlib
import subprocess
import sys
import tempfile


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--root", required=True)
    root = pathlib.Path(parser.parse_args().root)
    images, script = root / "docs" / "images", root / "scripts" / "figures" / "draw_figures.py"
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, "-B", script, folder], check=True)
        drawn = sorted(path.name for path in pathlib.Path(folder).iterdir())
        _, differ, missing = filecmp.cmpfiles(folder, images, drawn, shallow=False)
    for name in differ + missing:
        print(f"docs/images/{name}: draw it again with scripts/figures/draw_figures.py")
    print(f"{len(drawn)} figures, {len(differ + missing)} problems")
    return 1 if differ or missing or not drawn else 0


if __name__ == "__main__":
    sys.exit(main())
