#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the files that teleta writes stay the same, byte by byte.

    written_files.py OLD NEW              runs two programs on whole scenes and names the first file that differs
    written_files.py --check PROGRAM      runs one program on short scenes and compares with written_files.sha256
    written_files.py --update PROGRAM     the same, and writes written_files.sha256 anew
    --keep FOLDER                         leaves what was written, as it was compared, in FOLDER/old and FOLDER/new

Every command that writes a file runs with fixed seeds on the scenes, studies and test data of the source tree. Standard
output is compared where it is CSV or JSON. Left out, because it differs from run to run:
    summary.json            wall_s and the times of effects and parts (time_s)
    ablation                the columns own_time_s, run_s and run_with_all_s
    recordings, studies     SQLite pages: each table is dumped row by row, without the version of the program, comments
                            and descriptions of the scene or protocol; frames of a recording without their cut into blocks
    the program's version   with the commit behind it; the sum of a recording in recording.json
    times of the clock      in recordings; in studies they count from its beginning; dates of PDF and HJIF
Not run, because their files are times: tradeoff, pattern play. Not run, because they need a device or server: devices,
study --store. Libraries are kept from choosing faster code on newer processors, so that sums hold on every x86-64.
"""
import argparse
import concurrent.futures
import datetime
import difflib
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import zlib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
SUMS = HERE / "written_files.sha256"
PATTERN_ENDINGS = ("json", "hjif", "haptic.zip", "haptic", "ahap.zip", "ahap", "tact", "csv", "wav")

# glibc and OpenCV choose code by the processor; FMA rounds differently.
ENVIRONMENT = {
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX_Usable,-AVX2_Usable,-FMA_Usable,-FMA4_Usable,-AVX512F_Usable,"
    "-AVX,-AVX2,-FMA,-FMA4,-AVX512F",
    "OPENCV_CPU_DISABLE": "SSE4.1,SSE4.2,POPCNT,FP16,AVX,AVX2,FMA3,AVX512F,AVX512-SKX",
    "LC_ALL": "C.UTF-8",
    "TZ": "UTC",
    "SOURCE_DATE_EPOCH": "0",
}


class Runner:
    """Runs one program in its folder; what it prints is kept where it is data."""

    def __init__(self, program, folder, whole):
        self.program, self.folder, self.whole = str(pathlib.Path(program).resolve()), folder, whole

    def run(self, *arguments, out=None, refused=None):
        """out: the file for standard output; refused: the exit code with which the program may refuse this."""
        environment = {**os.environ, **ENVIRONMENT, "HOME": str(self.folder), "XDG_CONFIG_HOME": str(self.folder)}
        done = subprocess.run([self.program, *map(str, arguments)], cwd=self.folder, env=environment, check=False,
                              capture_output=True)
        if done.returncode not in (0, refused):
            sys.exit(f"{' '.join(map(str, arguments))}: exit code {done.returncode}\n{done.stderr.decode()}")
        if out:
            (self.folder / out).write_bytes(done.stdout)


def seconds(scene):
    """Simulated time of a scene in the short run: until something touches, and less where images are drawn."""
    if scene.startswith("vtacarm"):
        return 60 if scene == "vtacarm-calibration" else 0.2
    return 40 if scene.startswith("teleta-contour") else 6 if scene.startswith("servo") else 3


def scene_jobs(runner):
    for path in sorted((ROOT / "resources" / "scenes").glob("*.toml")):
        limit = [] if runner.whole else ["--duration", seconds(path.stem)]
        if path.stem == "study-rehearsal":
            limit = [] if runner.whole else ["--duration", 60]

        def job(path=path, limit=limit):
            folder = f"scenes/{path.stem}"
            figures = ["--figures", "svg,pdf,png"] if path.stem.startswith("servo") else []
            # A short run of a servo may end before its task begins.
            runner.run("simulate", path, "--seed", 1, *limit, "--out", folder, *figures, refused=1)
            recording = f"{folder}/recording.teleta"
            if (runner.folder / recording).exists():
                runner.run("export", recording, "--csv", f"{folder}/export")
                try_replay(runner, recording, folder)
            follow_up(runner, path.stem, folder)

        yield job


def try_replay(runner, recording, folder):
    """Features of an array or contacts of a camera; recordings of a servo alone have neither."""
    streams = sqlite3.connect(f"file:{runner.folder / recording}?mode=ro", uri=True).execute(
        "SELECT kind FROM stream").fetchall()
    if {"array", "camera"} & {kind for (kind,) in streams}:
        runner.run("replay", recording, "--out", f"{folder}/replay.csv")


def follow_up(runner, scene, folder):
    """What the commands compute of the files of a scene."""
    run = runner.run
    if scene == "tactile-even-load":
        run("gains", f"{folder}/frames.csv", "--out", f"{folder}/gains.csv")
        run("gains", f"{folder}/frames.csv", "--json", out=f"{folder}/gains.json")
    if scene in ("tactile-indenter", "tactile-two-contacts"):
        for command in ("features", "contacts"):
            run(command, f"{folder}/frames.csv", "--threshold", 0.3, "--out", f"{folder}/{command}.csv")
            run(command, f"{folder}/frames.csv", "--auto-threshold", "--active-only", "--weighted", "--json",
                out=f"{folder}/{command}.json")
    if scene.startswith("teleta-contour"):
        for spline in ("approximating", "interpolating"):
            run("contour", f"{folder}/contour.csv", "--spline", spline,
                "--curve", f"{folder}/curve-{spline}.csv", "--json", out=f"{folder}/contour-{spline}.json")
    if scene == "vtacarm-calibration":
        for method in ("robust", "paper"):
            run("calibrate", f"{folder}/pairs.csv", "--method", method, "--out", f"{folder}/{method}.json",
                "--residuals", f"{folder}/residuals-{method}.csv", "--json", out=f"{folder}/calibrate-{method}.json")
        run("locate", f"{folder}/robust.json", f"{folder}/pairs.csv", "--out", f"{folder}/points.csv")


def stiffness_job(runner):
    folder = runner.folder / "stiffness"
    folder.mkdir()
    runner.run("simulate", ROOT / "resources/scenes/teleta-touch.toml", "--duration", 8, "--seed", 1, "--out",
               "stiffness/run")
    rows = [line.split(",") for line in (folder / "run/joints.csv").read_text().splitlines()[1:]]
    (folder / "touch.csv").write_text("time_s,joint_angle_rad,joint_torque_nm\n" +
                                      "".join(f"{row[0]},{row[4]},{row[8]}\n" for row in rows))
    for method in ("two-point", "regression"):
        runner.run("stiffness", "stiffness/touch.csv", "--contact-distance", 0.1695, "--method", method, "--json",
                   out=f"stiffness/{method}.json")


def ablation_job(runner):
    limit = [] if runner.whole else ["--duration", 2]
    runner.run("simulate", ROOT / "resources/scenes/tactile-indenter.toml", "--ablate", "--seeds", 2, *limit, "--out",
               "ablation.csv")


def mat_job(runner):
    popu = ROOT / "tests/data/popu"
    mat = ["--rows", 64, "--columns", 27, "--pitch-mm", 20, "--gain", 0.01, "--tare", popu / "tactilus_empty1.csv"]
    for command in ("features", "contacts"):
        runner.run(command, popu / "tactilus_sequence_excerpt.csv", *mat, "--out", f"mat-{command}.csv")


def pattern_jobs(runner):
    listed = runner.folder / "patterns.json"
    runner.run("pattern", "list", "--json", out="patterns.json")
    built_in = [pattern["id"] for pattern in json.loads(listed.read_text())]
    if not runner.whole:
        built_in = [name for name in built_in if name in ("shape.A.static", "shape.B.dynamic", "stiffness.E.dynamic")]
    files = sorted((ROOT / "tests/data/patterns").iterdir())

    def job(pattern):
        name = pathlib.Path(pattern).name
        folder = f"patterns/{name}"
        (runner.folder / folder).mkdir(parents=True)
        for ending in PATTERN_ENDINGS:
            # Some formats hold one tactor only.
            runner.run("pattern", "convert", pattern, f"{folder}/out.{ending}", refused=1)
        runner.run("pattern", "convert", pattern, f"{folder}/predicted.wav", "--predicted", "--rate", 4000)
        runner.run("pattern", "render", pattern, "--csv", f"{folder}/render.csv")
        runner.run("pattern", "render", pattern, "--predicted", "--overdrive", "--json", out=f"{folder}/driven.json")
        runner.run("pattern", "show", pattern, "--json", out=f"{folder}/show.json")

    for pattern in [*built_in, *files]:
        yield lambda pattern=pattern: job(pattern)


def study_job(runner):
    participants = 12 if runner.whole else 2
    runner.run("study", "rehearse", ROOT / "resources/studies/teleta.toml", "--participants", participants, "--seed", 5,
               "--lapses", 0.05, "--out", "study")
    for form in ("psychds", "bids", "excel"):
        runner.run("study", "export", "study", "--format", form)
    runner.run("study", "analyze", "study", "--out", "analysis", "--figures", "svg,pdf,png", "--json",
               out="analysis.json")
    runner.run("study", "noise", "--seed", 2, "--out", "noise.wav")


def read_grey_png(path):
    """Width and rows of a PNG of 8-bit grey levels without interlace."""
    content, position, packed = path.read_bytes(), 8, b""
    width = int.from_bytes(content[16:20], "big")
    while position < len(content):
        length = int.from_bytes(content[position:position + 4], "big")
        if content[position + 4:position + 8] == b"IDAT":
            packed += content[position + 8:position + 8 + length]
        position += length + 12
    raw, rows, above = zlib.decompress(packed), [], bytearray(width)
    for start in range(0, len(raw), width + 1):
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + width])
        for i in range(width):
            left, up, corner = (row[i - 1], above[i], above[i - 1]) if i else (0, above[i], 0)
            nearest = min((left, up, corner), key=lambda value: abs(left + up - corner - value))
            row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[kind]) % 256
        rows.append(row)
        above = row
    return width, rows


def track_job(runner):
    """Two pictures of the camera scene: at rest, and with the dots of one place pushed apart as by a press."""
    scene = ROOT / "resources/scenes/vtacarm-multicontact.toml"
    runner.run("simulate", scene, "--duration", 0.1, "--seed", 1, "--out", "track/scene")
    runner.run("simulate", ROOT / "resources/scenes/vtacarm-calibration.toml", "--duration", 60, "--seed", 1, "--out",
               "track/tube")
    runner.run("calibrate", "track/tube/pairs.csv", "--out", "track/camera.json")
    folder = runner.folder / "track"
    width, rows = read_grey_png(folder / "scene/reference.png")
    u, v, reach, push = 400, 400, 60, 14
    pressed = [bytearray(row) for row in rows]
    for y in range(v - reach, v + reach):
        for x in range(u - reach, u + reach):
            distance = math.hypot(x - u, y - v)
            if 0 < distance < reach:
                share = push / reach * (1 - distance / reach)
                pressed[y][x] = rows[round(y - share * (y - v))][round(x - share * (x - u))]
    for number, picture in enumerate((rows, rows, pressed, pressed)):
        (folder / f"frame_{number}.pgm").write_bytes(b"P5 %d %d 255\n" % (width, len(picture)) + b"".join(picture))
    for preset in ("dots", "paper", "medium-2"):
        runner.run("track", folder / "frame_%d.pgm", "--camera", "track/camera.json", "--preset", preset, "--out",
                   f"track/{preset}.csv")


def write_all(program, folder, whole):
    runner = Runner(program, folder, whole)
    jobs = [*scene_jobs(runner), *pattern_jobs(runner)]
    jobs += [lambda job=job: job(runner) for job in (stiffness_job, ablation_job, mat_job, study_job,
                                                  track_job)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for done in [pool.submit(job) for job in jobs]:
            done.result()


# --- what differs from run to run is taken out

LEFT_OUT_COLUMNS = {"app_version", "created_utc", "utc"}
CLOCK = re.compile(rb"20\d\d-\d\d-\d\dT\d\d:\d\d:\d\d(?:\.\d+)?(?=Z)|20\d{6}T\d{6}(?!\d)")


def instant(text):
    whole, _, fraction = re.sub("[-:]", "", text).partition(".")
    moment = datetime.datetime.strptime(whole, "%Y%m%dT%H%M%S").replace(tzinfo=datetime.timezone.utc)
    return moment.timestamp() + float("0." + (fraction or "0"))


def since(origin_s, content):
    """Every time of the wall clock as seconds since the origin; without an origin they are left out. Names of sessions are
    whole seconds, rounded down."""
    def shift(match):
        text = match[0].decode()
        return b"+%.3f" % (instant(text) - (origin_s if "." in text else math.floor(origin_s)))
    return CLOCK.sub(lambda match: b"TIME" if origin_s is None else shift(match), content)


def bare(text):
    """A scene or protocol without what is for people only."""
    return "\n".join(line for line in text.splitlines() if line and not line.startswith(("#", "description =")))


def shown(name, value):
    if isinstance(value, bytes):
        return f"{name}={len(value)}:{hashlib.sha256(value).hexdigest()}"
    return f"{name}={bare(value) if name in ('scene_text', 'protocol') else value!r}"


def blocks(database):
    """What a recording holds of each stream: how it was cut into blocks depends on how quickly it was written."""
    for (stream,) in database.execute("SELECT key FROM stream ORDER BY key").fetchall():
        rows = database.execute(
            "SELECT width, height, first_ns * discontinuity, time_ns, source_time_s, data FROM block WHERE stream = ? "
            "ORDER BY first_ns, key", (stream,)).fetchall()
        sizes = sorted({row[:3] for row in rows})
        joined = [b"".join(row[column] for row in rows) for column in (3, 4, 5)]
        yield f"block: stream={stream} {sizes} " + " ".join(
            shown(name, value) for name, value in zip(("time_ns", "source_time_s", "data"), joined))


def dump(path):
    database = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
    lines = [sql for (sql,) in database.execute("SELECT sql FROM sqlite_master WHERE sql IS NOT NULL ORDER BY sql")]
    tables = [name for (name,) in database.execute("SELECT name FROM sqlite_master WHERE type='table' ORDER BY name")]
    for table in tables:
        if table == "block":
            lines += blocks(database)
            continue
        cursor = database.execute(f'SELECT * FROM "{table}" ORDER BY 1, 2')
        names = [column[0] for column in cursor.description]
        for row in cursor:
            cells = [shown(name, value) for name, value in zip(names, row) if name not in LEFT_OUT_COLUMNS]
            lines.append(f"{table}: " + " ".join(cells))
    return "\n".join(lines).encode()


def study_origin_s(folder):
    """When the rehearsed study began; its clock goes on from there."""
    for path in folder.glob("study/*.sqlite"):
        database = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
        (created,) = database.execute("SELECT created_utc FROM study").fetchone()
        return instant(created.rstrip("Z"))
    return None


def without_times(document):
    if isinstance(document, dict):
        left_out = ("wall_s", "time_s", "app_version", "exported_by", "sha256")
        return {key: without_times(value) for key, value in document.items() if key not in left_out}
    if isinstance(document, list):
        return [without_times(value) for value in document]
    return document


def normalised(path, content):
    name = path.name
    if path.suffix in (".teleta", ".sqlite"):
        return dump(path)
    if name in ("summary.json", "recording.json"):
        return json.dumps(without_times(json.loads(content)), indent=1).encode()
    if name == "ablation.csv":
        return b"\n".join(b",".join(line.split(b",")[:-3]) for line in content.splitlines())
    if path.suffix == ".hjif":
        return re.sub(rb'"date": "[0-9-]+"', b'"date": "DATE"', content)
    if path.suffix == ".pdf":
        return re.sub(rb"/(CreationDate|ModDate) \([^)]*\)", b"", content)
    return content


def version_in_files(program):
    """The program's version, with the commit where there is one, as it stands in files."""
    told = subprocess.run([program, "--version", "--json"], check=True, capture_output=True)
    version = json.loads(told.stdout)["version"].encode()
    return re.compile(rb"(?<![\d.])" + re.escape(version) + rb"(?:\+[0-9a-f]{12}(?:\.modified)?)?(?!\.?\d)")


def normalise(folder, program):
    """Leaves each file as it is compared, under a name without times."""
    version = version_in_files(program)
    origin_s = study_origin_s(folder)
    for path in sorted(folder.rglob("*"), reverse=True):
        of_study = path.relative_to(folder).parts[0] in ("study", "analysis", "analysis.json")
        if path.is_file():
            content = path.read_bytes()
            changed = normalised(path, content).replace(str(folder).encode(), b"FOLDER")
            if path.suffix not in (".png", ".wav", ".zip"):
                changed = version.sub(b"VERSION", changed)
                changed = since(origin_s if of_study else None, changed)
            if changed != content:
                path.write_bytes(changed)
        name = since(origin_s, path.name.encode()).decode() if of_study else path.name
        if name != path.name:
            path.rename(path.with_name(name))


def sums_of(folder):
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*")) if path.is_file()
    }


def first_difference(old, new):
    if old is None or new is None:
        return "is written by one of them only"
    lines = [content.decode(errors="replace").splitlines() for content in (old, new)]
    if all(len(line) < 2000 for part in lines for line in part):
        for line in difflib.unified_diff(*lines, n=0, lineterm=""):
            if line[:1] in "+-" and line[:3] not in ("+++", "---"):
                return line
    at = next((i for i, (a, b) in enumerate(zip(old, new)) if a != b), min(len(old), len(new)))
    return f"byte {at}: {old[at:at + 40]!r} became {new[at:at + 40]!r}"


def compare(old, new, folder):
    for name, program in (("old", old), ("new", new)):
        (folder / name).mkdir(parents=True)
        write_all(program, folder / name, whole=True)
        normalise(folder / name, program)
    read = [{str(path.relative_to(folder / name)): path.read_bytes()
             for path in (folder / name).rglob("*") if path.is_file()} for name in ("old", "new")]
    names = sorted(read[0].keys() | read[1].keys())
    different = [name for name in names if read[0].get(name) != read[1].get(name)]
    for name in different:
        print(f"{name}: {first_difference(read[0].get(name), read[1].get(name))}")
    print(f"{len(names)} files, {len(different)} differ")
    return 1 if different else 0


def check(program, folder, update):
    (folder / "new").mkdir(parents=True)
    write_all(program, folder / "new", whole=False)
    normalise(folder / "new", program)
    sums = sums_of(folder / "new")
    if update:
        SUMS.write_text("".join(f"{value}  {name}\n" for name, value in sums.items()))
        print(f"{len(sums)} files")
        return 0
    known = dict(reversed(line.split("  ", 1)) for line in SUMS.read_text().splitlines())
    different = [name for name in sorted(known.keys() | sums.keys()) if known.get(name) != sums.get(name)]
    for name in different:
        print(f"{name}: " + ("differs" if name in known and name in sums else
                             "is new" if name in sums else "is not written any more"))
    print(f"{len(sums)} files, {len(different)} differ")
    if different:
        print("What files contain must not change unnoticed. When the change is meant: written_files.py --update PROGRAM")
    return 1 if different else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+", metavar="PROGRAM")
    mode = parser.add_mutually_exclusive_group()
    mode.add_argument("--check", action="store_true")
    mode.add_argument("--update", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER")
    options = parser.parse_args()
    single = options.check or options.update
    if len(options.programs) != (1 if single else 2):
        parser.error("--check and --update take one program, a comparison takes two")
    folder = options.keep or pathlib.Path(tempfile.mkdtemp(prefix="teleta-written-"))
    try:
        return check(options.programs[0], folder, options.update) if single else compare(*options.programs, folder)
    finally:
        if not options.keep:
            shutil.rmtree(folder)


if __name__ == "__main__":
    sys.exit(main())
