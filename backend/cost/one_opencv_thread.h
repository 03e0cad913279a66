// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::cost {

/// While one is there, OpenCV computes on the thread that calls it, in the whole program: a measured time is
/// then that of one core. After the last one it has as many threads as before. Thread: any.
class OneOpenCvThread {
public:
    OneOpenCvThread();
    ~OneOpenCvThread();
    OneOpenCvThread(const OneOpenCvThread&) = delete;
    OneOpenCvThread& operator=(const OneOpenCvThread&) = delete;
};

} // namespace teleta::cost
