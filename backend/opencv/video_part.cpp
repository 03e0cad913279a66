// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/opencv/exported_parts.h"

const teleta::opencv::Video teleta_opencv_video{[] { return std::make_unique<cv::VideoCapture>(); }};
