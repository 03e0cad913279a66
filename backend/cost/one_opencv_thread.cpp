// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/one_opencv_thread.h"

#include <opencv2/core/utility.hpp>

#include <mutex>

namespace teleta::cost {

namespace {

std::mutex mutex;
int users = 0;
int threadsBefore = 0;

} // namespace

OneOpenCvThread::OneOpenCvThread() {
    const std::scoped_lock lock(mutex);
    if (users++ == 0) {
        threadsBefore = cv::getNumThreads();
        cv::setNumThreads(1);
    }
}

OneOpenCvThread::~OneOpenCvThread() {
    const std::scoped_lock lock(mutex);
    if (--users == 0)
        cv::setNumThreads(threadsBefore);
}

} // namespace teleta::cost
