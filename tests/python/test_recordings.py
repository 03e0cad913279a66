# SPDX-License-Identifier: GPL-3.0-or-later
"""Recordings as arrays."""

from __future__ import annotations

import contextlib
import json
import shutil
import sqlite3
import threading
import warnings
import zlib

import numpy as np
import pytest
from conftest import read_csv, run_program

import teleta


@pytest.fixture(scope="module")
def arm(tmp_path_factory):
    folder = tmp_path_factory.mktemp("arm")
    run_program("simulate", "teleta-touch", "--duration", 4, "--out", folder)
    return folder


def test_an_array_is_what_the_frames_were(indenter, frames):
    with teleta.open(indenter / "recording.teleta") as recording:
        (name,) = [name for name, stream in recording.streams.items() if stream.kind == "array"]
        stream = recording.streams[name]
        assert (stream.type, stream.shape) == ("float32", (6, 14))
        assert stream.rate_hz == 200.0
        data = recording.read(name)
        np.testing.assert_array_equal(data.values, frames.values)
        np.testing.assert_allclose(data.source_time_s, frames.time_s, atol=1e-12)
        assert data.time_ns.dtype == np.int64 and data.values.dtype == np.float32
        assert data.damaged == 0
    by_content = teleta.read_frames(indenter / "recording.teleta")
    np.testing.assert_array_equal(by_content.values, frames.values)


def test_joints_have_names_and_units(arm):
    with teleta.open(arm / "recording.teleta") as recording:
        assert recording.scene and recording.complete
        (name,) = [name for name, stream in recording.streams.items() if stream.kind == "joints"]
        data = recording.read(name)
        assert data.values.dtype == np.float64 and len(data.columns) == data.values.shape[1]
        units = dict(zip(data.columns, recording.streams[name].column_units))
        assert units[data.columns[0]] == "rad"


def test_a_range_is_half_open_and_steps_count_within_it(indenter):
    with teleta.open(indenter / "recording.teleta") as recording:
        name = next(iter(recording.streams))
        whole = recording.read(name)
        start_s, stop_s = whole.time_s[40], whole.time_s[90]
        part = recording.read(name, start_s, stop_s)
        np.testing.assert_array_equal(part.time_ns, whole.time_ns[40:90])
        np.testing.assert_array_equal(part.values, whole.values[40:90])
        third = recording.read(name, start_s, stop_s, step=3)
        np.testing.assert_array_equal(third.time_ns, whole.time_ns[40:90:3])
        assert len(recording.read(name, 1e6).time_s) == 0
        assert recording.read(name, 1e6).values.shape == (0, 6, 14)
        with pytest.raises(ValueError, match="step: expected 1 or more"):
            recording.read(name, step=0)


def test_blocks_are_the_whole_in_pieces(indenter):
    with teleta.open(indenter / "recording.teleta") as recording:
        name = next(iter(recording.streams))
        whole = recording.read(name)
        blocks = list(recording.blocks(name, frames=100))
        assert len(blocks) > 2 and all(len(block.time_s) >= 100 for block in blocks[:-1])
        np.testing.assert_array_equal(np.concatenate([block.values for block in blocks]), whole.values)


@pytest.fixture(scope="module")
def pictures(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pictures")
    run_program("simulate", "vtacarm-bump", "--duration", 1.5, "--out", folder)
    return folder / "recording.teleta"


def test_pictures_are_bytes(pictures):
    with teleta.open(pictures) as recording:
        name = "camera"
        data = recording.read(name, step=5)
    assert data.values.dtype == np.uint8 and data.values.ndim == 3
    assert data.values[0].std() > 5.0


def test_pictures_in_colour_have_three_values_a_pixel(pictures, tmp_path):
    path = tmp_path / "colour.teleta"
    shutil.copy(pictures, path)
    pixels = np.arange(2 * 4 * 3, dtype=np.uint8).reshape(2, 4, 3)
    with contextlib.closing(sqlite3.connect(path)) as database, database:
        database.execute("UPDATE stream SET shape = '0x0x3' WHERE name = 'camera'")
        database.execute(
            "UPDATE block SET width = 12, height = 2, data = ?"
            " WHERE stream = (SELECT key FROM stream WHERE name = 'camera')",
            (zlib.compress(pixels.tobytes()),),
        )
    with teleta.open(path) as recording:
        assert recording.streams["camera"].shape == (0, 0, 3)
        values = recording.read("camera").values
    assert len(values) > 10
    np.testing.assert_array_equal(values[3], pixels)


def test_wall_clock_times_follow_the_anchors(indenter):
    with teleta.open(indenter / "recording.teleta") as recording:
        start = recording.start_utc
        assert isinstance(start, np.datetime64)
        assert abs(np.datetime64("now") - start) < np.timedelta64(1, "D")
        anchors = recording.anchors
        assert anchors["utc"].dtype == "datetime64[ns]"
        later = recording.utc(anchors["time_ns"][0] + np.array([0, 1_500_000_000]))
        assert later[1] - later[0] == np.timedelta64(1_500_000_000, "ns")
        assert later[0] == anchors["utc"][0]
        with pytest.raises(TypeError):
            recording.utc(0.5)


def test_events_are_those_of_the_export(arm, tmp_path):
    with teleta.open(arm / "recording.teleta") as recording:
        recording.to_csv(tmp_path)
        events = recording.events
    printed = read_csv(tmp_path / "events.csv")
    assert list(events)[:5] == list(printed)[:5]
    assert events["event"].tolist() == printed["event"]
    np.testing.assert_array_equal(events["time_s"], np.array(printed["time_s"], dtype=float))
    stamps = [np.datetime64(text.removesuffix("Z")) for text in printed["utc"]]
    np.testing.assert_array_equal(events["utc"], np.array(stamps).astype("datetime64[ns]"))


def test_a_damaged_block_is_left_out_with_a_warning(indenter, tmp_path):
    path = tmp_path / "damaged.teleta"
    shutil.copy(indenter / "recording.teleta", path)
    database = sqlite3.connect(path)
    database.execute("UPDATE block SET data = x'00' WHERE key = (SELECT min(key) + 1 FROM block)")
    database.commit()
    database.close()
    with teleta.open(path) as recording:
        name = next(iter(recording.streams))
        with pytest.warns(teleta.DamagedDataWarning, match="1 damaged block was left out"):
            data = recording.read(name)
    with teleta.open(indenter / "recording.teleta") as recording:
        assert data.damaged == 1 and len(data.time_s) < len(recording.read(name).time_s)


def test_a_closed_recording_says_so(indenter):
    recording = teleta.open(indenter / "recording.teleta")
    recording.close()
    with pytest.raises(ValueError, match="closed"):
        recording.read(next(iter(recording.streams)))


def test_a_recording_belongs_to_its_thread(indenter):
    with teleta.open(indenter / "recording.teleta") as recording:
        name = next(iter(recording.streams))
        caught = []

        def read() -> None:
            try:
                recording.read(name)
            except RuntimeError as error:
                caught.append(str(error))

        thread = threading.Thread(target=read)
        thread.start()
        thread.join()
        assert caught and "thread" in caught[0]


def test_what_is_no_recording_is_refused(tmp_path):
    path = tmp_path / "other.teleta"
    path.write_text("nothing")
    with pytest.raises(teleta.BadInputError):
        teleta.open(path)
    sqlite3.connect(path.with_suffix(".db")).execute("CREATE TABLE a (b)").connection.commit()
    with pytest.raises(teleta.BadInputError):
        teleta.open(path.with_suffix(".db"))


def test_mcap_is_that_of_the_program(arm, tmp_path):
    run_program("export", arm / "recording.teleta", "--mcap", tmp_path / "wanted.mcap")
    run_program("export", arm / "recording.teleta", "--mcap", tmp_path / "part.mcap", "--stream", "joints",
                "--compression", "lz4", "--chunk-mb", 0.5)
    with teleta.open(arm / "recording.teleta") as recording:
        whole = recording.to_mcap(tmp_path / "whole.mcap")
        part = recording.to_mcap(tmp_path / "lz4.mcap", streams=["joints"], compression="lz4", chunk_mb=0.5)
        joints = recording.read("joints")
    assert (tmp_path / "whole.mcap").read_bytes() == (tmp_path / "wanted.mcap").read_bytes()
    assert (tmp_path / "lz4.mcap").read_bytes() == (tmp_path / "part.mcap").read_bytes()
    assert whole.path == str(tmp_path / "whole.mcap")
    assert whole.bytes == (tmp_path / "whole.mcap").stat().st_size
    assert (whole.damaged_blocks, whole.left_out, whole.y_turned) == (0, (), ())
    messages = dict(zip(part.topics["topic"], part.topics["messages"]))
    assert messages["/joints/joint_states"] == len(joints.time_s)
    assert dict(zip(whole.topics["topic"], whole.topics["type"]))["/events"] == "foxglove_msgs/msg/Log"


def test_an_imported_mcap_has_every_value_and_time(arm, tmp_path):
    with teleta.open(arm / "recording.teleta") as recording:
        recording.to_mcap(tmp_path / "out.mcap")
        run_program("import", tmp_path / "out.mcap", "--out", tmp_path / "back.teleta")
        with teleta.open(tmp_path / "back.teleta") as back:
            assert list(back.streams) == list(recording.streams)
            for name in recording.streams:
                before, after = recording.read(name), back.read(name)
                np.testing.assert_array_equal(after.values, before.values, err_msg=name)
                utc = [np.asarray(each.utc(data.time_ns)).astype(np.int64)
                       for each, data in ((recording, before), (back, after))]
                assert np.abs(utc[1] - utc[0]).max(initial=0) <= 1


def test_mcap_of_what_is_not_there_is_refused(arm, tmp_path):
    path = tmp_path / "there.mcap"
    path.write_text("old")
    with teleta.open(arm / "recording.teleta") as recording:
        with pytest.raises(teleta.RefusedError, match="already exists"):
            recording.to_mcap(path)
        with pytest.raises(KeyError, match="joints"):
            recording.to_mcap(tmp_path / "no.mcap", streams=["joint"])
        with pytest.raises(ValueError, match="compression: expected 'zstd', 'lz4' or 'none', got 'xz'"):
            recording.to_mcap(tmp_path / "no.mcap", compression="xz")
        with pytest.raises(ValueError, match="chunk_mb: expected 0.01 to 64, got 100"):
            recording.to_mcap(tmp_path / "no.mcap", chunk_mb=100.0)
        with pytest.raises(ValueError, match="streams: expected one or more names"):
            recording.to_mcap(tmp_path / "no.mcap", streams=[])
        with pytest.raises(TypeError, match="streams"):
            recording.to_mcap(tmp_path / "no.mcap", streams="joints")
        assert path.read_text() == "old"
        recording.to_mcap(path, overwrite=True)
    assert path.read_bytes().startswith(b"\x89MCAP0\r\n")
    assert not (tmp_path / "no.mcap").exists()


def test_long_mcap_tells_its_progress_and_ends_when_it_is_to(pictures, tmp_path):
    told = []

    def ends_at_the_second(done: float, whole: float) -> None:
        told.append((done, whole))
        if len(told) == 2:
            raise LookupError("enough")

    with teleta.open(pictures) as recording:
        frames = sum(len(recording.read(name).time_s) for name in recording.streams)
        with pytest.raises(LookupError, match="enough"):
            recording.to_mcap(tmp_path / "no.mcap", progress=ends_at_the_second)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            written = recording.to_mcap(tmp_path / "pictures.mcap", streams=["camera"])
    assert len(told) == 2 and 0 < told[0][0] < told[1][0] < frames
    assert {whole for _, whole in told} == {frames}
    assert [path.name for path in tmp_path.iterdir()] == ["pictures.mcap"]
    assert "/camera/image/compressed" in written.topics["topic"]


def test_files_carry_the_version_and_the_commit(indenter, tmp_path):
    wanted = json.loads((indenter / "summary.json").read_text())["app_version"]
    assert wanted.startswith(teleta.__version__)
    assert teleta.simulate("tactile-indenter", duration_s=0.2, out=tmp_path / "run")["app_version"] == wanted
    with teleta.open(tmp_path / "run" / "recording.teleta") as recording:
        recording.to_csv(tmp_path / "csv")
        recording.to_mcap(tmp_path / "run.mcap", compression="none")
    described = json.loads((tmp_path / "csv" / "recording.json").read_text())
    assert (described["app_version"], described["exported_by"]) == (wanted, wanted)
    assert f"teleta {wanted}".encode() in (tmp_path / "run.mcap").read_bytes()
