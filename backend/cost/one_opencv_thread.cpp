// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/one_opencv_thread.h"

#include <opencv2/core/utility.hpp>

namespace teleta::cost {

OneOpenCvThread::OneOpenCvThread()
    : m_before(cv::getNumThreads()) {
    cv::setNumThreads(1);
}

OneOpenCvThread::~OneOpenCvThread() {
    cv::setNumThreads(m_before);
}

} // namespace teleta::cost
