#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What make_sbom.py says about a program, against the linker's headers and dpkg: sbom.py MAKE_SBOM PROGRAM"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

make_sbom, program = sys.argv[1:]
if not shutil.which("dpkg-query"):
    sys.exit(77)
with tempfile.TemporaryDirectory() as folder:
    texts = []
    for name in ("one.json", "two.json"):
        path = pathlib.Path(folder, name)
        subprocess.run([sys.executable, make_sbom, "--version", "1.2.3", "--out", path, program], check=True)
        texts.append(path.read_text())
assert texts[0] == texts[1], "the same packages give other bytes"
document = json.loads(texts[0])
assert (document["bomFormat"], document["specVersion"]) == ("CycloneDX", "1.5")
assert re.fullmatch(r"urn:uuid:[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}", document["serialNumber"])
assert document["metadata"]["component"]["version"] == "1.2.3"
components = document["components"]
references = [component["bom-ref"] for component in components]
assert len(set(references)) == len(references) and references == document["dependencies"][0]["dependsOn"]
assert all(re.fullmatch(r"pkg:deb/debian/[a-z0-9.%B+-]+@[A-Za-z0-9.%~-]+\?arch=[a-z0-9]+&distro=[a-z]+-[0-9.]+", one)
           for one in references), references
versions = {component["name"]: component["version"] for component in components}
for name, version in versions.items():
    asked = subprocess.run(["dpkg-query", "-W", "-f=${Version}\\n", name], capture_output=True, text=True, check=True)
    assert version in asked.stdout.splitlines(), name
# What the program itself names, without the loader's search.
needed = re.findall(r"\(NEEDED\).*\[(lib[^\]]+)\]", subprocess.run(
    ["readelf", "-d", program], capture_output=True, text=True, check=True, env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"}).stdout)
assert len(needed) > 10, needed
for package, library in (("libc6", "libc.so.6"), ("libstdc++6", "libstdc++.so.6"), ("libqt6core6", "libQt6Core.so.6")):
    assert library in needed and package in versions, package
assert "libeigen3-dev" in versions, "a library of headers only"

refused = subprocess.run([sys.executable, make_sbom, "--version", "1", "--out", "/dev/null", "/etc/passwd"], capture_output=True)
assert refused.returncode != 0, "a file that is no program"
