// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/opencv/exported_parts.h"

const teleta::opencv::Flow teleta_opencv_flow{[](int preset) { return cv::DISOpticalFlow::create(preset); }};
