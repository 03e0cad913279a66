# SPDX-License-Identifier: GPL-3.0-or-later
"""Threads, Ctrl-C and progress."""

from __future__ import annotations

import os
import signal
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from conftest import balls

import teleta


def interrupt_after(seconds: float) -> threading.Timer:
    timer = threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    return timer


def test_two_threads_get_the_same_result():
    loads = balls(3000, 16, 16)
    wanted = teleta.contacts(loads, rate_hz=200.0)
    with ThreadPoolExecutor(2) as pool:
        for table in pool.map(lambda _: teleta.contacts(loads, rate_hz=200.0), range(4)):
            for name, column in wanted.items():
                np.testing.assert_array_equal(table[name], column)


def test_other_threads_run_meanwhile():
    loads = np.tile(balls(50, 64, 64), (20, 1, 1))
    done = threading.Event()
    counts = [0]

    def count() -> None:
        while not done.is_set():
            counts[0] += 1
            time.sleep(0)

    counter = threading.Thread(target=count)
    counter.start()
    before = counts[0]
    teleta.contacts(loads, rate_hz=200.0)
    after = counts[0]
    done.set()
    counter.join()
    assert after > before


def test_a_processor_belongs_to_one_thread_at_a_time():
    # Large frames, during which the lock is released.
    frames = balls(2, 256, 256)
    processor = teleta.Processor(256, 256)
    failures = []

    def work() -> None:
        for _ in range(30):
            try:
                processor.process(frames[0], 0.0)
            except RuntimeError as error:
                failures.append(str(error))

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert failures and all("another thread" in text for text in failures)
    # It still works.
    processor.reset()
    now, _ = processor.process(frames[1], 0.0)
    assert now.force_n == pytest.approx(frames[1].astype(float).sum(), rel=1e-12)


@pytest.mark.parametrize("work", ["features", "contacts", "simulate"])
def test_interruption_ends_long_work_at_once(work, tmp_path):
    if work == "features":
        frames = np.zeros((400_000, 32, 32), dtype=np.float32)
        call = lambda: teleta.features(frames)  # noqa: E731
    elif work == "contacts":
        noisy = np.tile(balls(20, 32, 32), (4000, 1, 1))
        call = lambda: teleta.contacts(noisy, rate_hz=1.0)  # noqa: E731
    else:
        teleta.scenes()  # OpenCV is loaded before
        call = lambda: teleta.simulate("tactile-mat", duration_s=100_000.0, out=tmp_path / "run")  # noqa: E731
    timer = interrupt_after(0.15)
    with pytest.raises(KeyboardInterrupt):
        call()
        pytest.fail("it was not interrupted")
    timer.join()
    assert list(tmp_path.iterdir()) == []


def test_progress_is_told_with_what_is_done_and_all():
    told = []
    teleta.simulate(
        "teleta-touch", duration_s=20.0, progress=lambda done, whole: told.append((done, whole, time.monotonic()))
    )
    assert told
    assert all(0.0 <= done <= whole for done, whole, _ in told)
    assert [done for done, _, _ in told] == sorted(done for done, _, _ in told)
    between = np.diff([when for _, _, when in told])
    assert (between > 0.09).all()


def test_an_exception_of_progress_ends_the_work(tmp_path):
    def fail(done: float, whole: float) -> None:
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        teleta.simulate("tactile-mat", duration_s=100_000.0, out=tmp_path / "run", progress=fail)
    assert list(tmp_path.iterdir()) == []
