#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what the programs are made of, as CycloneDX 1.5 (JSON): the Debian packages of every shared library
that they load, and of the libraries that are compiled in. The same packages give the same bytes.

    make_sbom.py --version VERSION --out FILE.cdx.json PROGRAM...
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import uuid
from urllib.parse import quote

# Libraries without a shared object of their own.
COMPILED_IN = ["libboost-dev", "libcli11-dev", "libeigen3-dev", "libexpected-dev", "libreaderwriterqueue-dev",
               "nlohmann-json3-dev"]
NAMESPACE = uuid.UUID("6d1f3a52-0d0c-5c55-9c1e-3f1d2f7f6b10")


def output_of(*command):
    environment = {"LC_ALL": "C", "PATH": "/usr/bin:/bin"}
    return subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout


def libraries_of(program):
    """Paths of the shared libraries that a program loads when it starts."""
    found = set()
    for line in output_of("ldd", program).splitlines():
        if "not found" in line:
            sys.exit(f"make_sbom: {program}: {line.strip()}")
        match = re.search(r"(/\S+) \(0x", line)
        if match:
            found.add(match.group(1))
    return found


def packages_of(libraries):
    """Names of the Debian packages that installed these files."""
    # Links and the merge of /usr give a file several names.
    names = {}
    for library in libraries:
        real = str(pathlib.Path(library).resolve())
        names[library] = {library, real, real.removeprefix("/usr"), "/usr" + library}
    asked = sorted(set().union(*names.values()))
    owners = {}
    for line in subprocess.run(["dpkg-query", "-S", *asked], capture_output=True, text=True).stdout.splitlines():
        owner, _, path = line.partition(": ")
        owners[path] = owner.split(",")[0].split(":")[0]
    packages = set()
    for library, known in names.items():
        found = {owners[name] for name in known if name in owners}
        if not found:
            sys.exit(f"make_sbom: no package has {library}")
        packages |= found
    return packages


def component_of(package, distribution):
    name, version, architecture, source, source_version, summary = output_of(
        "dpkg-query", "-W",
        "-f=${Package}\\t${Version}\\t${Architecture}\\t${source:Package}\\t${source:Version}\\t${binary:Summary}\\n",
        package).splitlines()[0].split("\t")
    purl = f"pkg:deb/debian/{quote(name)}@{quote(version, safe='')}?arch={architecture}&distro={distribution}"
    return {
        "type": "library",
        "bom-ref": purl,
        "name": name,
        "version": version,
        "description": summary,
        "purl": purl,
        "properties": [{"name": "debian:source", "value": source}, {"name": "debian:source-version", "value": source_version}],
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--version", required=True)
    parser.add_argument("--out", required=True)
    parser.add_argument("programs", nargs="+")
    arguments = parser.parse_args()
    release = dict(line.split("=", 1) for line in pathlib.Path("/etc/os-release").read_text().splitlines() if "=" in line)
    distribution = "-".join(release[key].strip('"') for key in ("ID", "VERSION_ID"))
    packages = packages_of(set().union(*(libraries_of(program) for program in arguments.programs)))
    loaded = sorted(packages)
    built_in = [name for name in COMPILED_IN
                if name not in packages and subprocess.run(["dpkg-query", "-W", name], capture_output=True).returncode == 0]
    components = [component_of(package, distribution) for package in sorted(loaded + built_in)]
    own = f"pkg:generic/teleta-console@{arguments.version}"
    document = {
        "$schema": "http://cyclonedx.org/schema/bom-1.5.schema.json",
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "serialNumber": "",
        "version": 1,
        "metadata": {
            "component": {
                "type": "application",
                "bom-ref": own,
                "name": "teleta-console",
                "version": arguments.version,
                "licenses": [{"license": {"id": "GPL-3.0-or-later"}}],
                "purl": own,
            }
        },
        "components": components,
        "dependencies": [{"ref": own, "dependsOn": [component["bom-ref"] for component in components]}],
    }
    document["serialNumber"] = "urn:uuid:" + str(uuid.uuid5(NAMESPACE, json.dumps(document, sort_keys=True)))
    pathlib.Path(arguments.out).write_text(json.dumps(document, indent=2) + "\n")
    print(f"{len(loaded)} packages are loaded, {len(built_in)} are compiled in")


if __name__ == "__main__":
    main()
