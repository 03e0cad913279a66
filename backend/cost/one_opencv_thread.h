// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::cost {

/// While it is there, OpenCV computes on the thread that calls it, in the whole program: a measured time is
/// then that of one core. Afterwards it has as many threads as before. Thread: one at a time.
class OneOpenCvThread {
public:
    OneOpenCvThread();
    ~OneOpenCvThread();
    OneOpenCvThread(const OneOpenCvThread&) = delete;
    OneOpenCvThread& operator=(const OneOpenCvThread&) = delete;

private:
    int m_before;
};

} // namespace teleta::cost
