#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs the file type of recordings into a folder of its own and asks GLib for the type of files.

    file_type.py MIME_XML      exit code 77: update-mime-database or gio is missing
"""
import os
import pathlib
import shutil
import sqlite3
import subprocess
import sys
import tempfile

RECORDING = "application/vnd.teleta.recording+sqlite3"


def database(path, application_id):
    connection = sqlite3.connect(path)
    connection.execute(f"PRAGMA application_id = {application_id}")
    connection.execute("CREATE TABLE t (x)")
    connection.commit()
    connection.close()


def main():
    if not shutil.which("update-mime-database") or not shutil.which("gio"):
        return 77
    with tempfile.TemporaryDirectory(prefix="teleta-mime-") as name:
        folder = pathlib.Path(name)
        packages = folder / "data/mime/packages"
        packages.mkdir(parents=True)
        shutil.copy(sys.argv[1], packages / "org.teleta.Console.xml")
        for known in ("/usr/share/mime/packages/freedesktop.org.xml",):
            shutil.copy(known, packages)
        told = subprocess.run(["update-mime-database", folder / "data/mime"], check=True, capture_output=True, text=True)
        database(folder / "named.teleta", 0x54544C41)
        database(folder / "by-content", 0x54544C41)
        database(folder / "other.sqlite3", 0)
        database(folder / "other-content", 0x12345678)
        environment = {**os.environ, "XDG_DATA_HOME": str(folder / "data"), "XDG_DATA_DIRS": str(folder / "none")}
        failures = []
        for file, is_recording in (("named.teleta", True), ("by-content", True), ("other.sqlite3", False),
                                   ("other-content", False)):
            answer = subprocess.run(["gio", "info", "-a", "standard::content-type", folder / file], env=environment,
                                    check=True, capture_output=True, text=True).stdout
            print(file, answer.strip().splitlines()[-1])
            if (RECORDING in answer) != is_recording:
                failures.append(file)
        print(told.stderr)
        return 1 if failures or "error" in told.stderr.lower() else 0


if __name__ == "__main__":
    sys.exit(main())
