#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes inputs that open as many levels as there is room for, out of small inputs that a reader takes.

    deep_inputs.py --out FOLDER INPUT...

Mutations by chance seldom build them: a reader that calls itself for every level may end the program only after some
ten thousand. What opens a level is put before the first line that is no comment, the middle one and the last one.
"""
import argparse
import hashlib
import pathlib

LEVELS = (b"a.", b"[", b"[[", b'{"a":', b"{a=", b"<a>")
MOST_BYTES = 200_000
MOST_INPUTS = 6  # the smallest ones


def deep(content, level):
    lines = content.splitlines(keepends=True) or [b""]
    first = next((i for i, line in enumerate(lines) if line.strip() and line.lstrip()[:1] not in b"#;"), 0)
    for place in sorted({first, len(lines) // 2, len(lines) - 1}):
        times = max(0, MOST_BYTES - len(content)) // len(level)
        yield b"".join(lines[:place]) + times * level + b"".join(lines[place:])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, required=True, metavar="FOLDER")
    parser.add_argument("inputs", nargs="*", type=pathlib.Path, metavar="INPUT")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    contents = sorted({path.read_bytes() for path in options.inputs}, key=lambda content: (len(content), content))
    for content in contents[:MOST_INPUTS]:
        for level in LEVELS:
            for made in deep(content, level):
                (options.out / hashlib.sha256(made).hexdigest()[:16]).write_bytes(made)


if __name__ == "__main__":
    main()
