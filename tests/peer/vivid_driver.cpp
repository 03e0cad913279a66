// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/peer/vivid_driver.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <linux/videodev2.h>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>

namespace teleta::test {

void toVividDriver(const std::string& what) {
    std::ofstream file("/sys/bus/platform/drivers/vivid/" + what);
    file << "vivid.0" << std::flush;
    ASSERT_TRUE(file.good()) << what;
}

int setVividFormat(unsigned width, unsigned height) {
    const int node = ::open(kVividNode, O_RDWR | O_CLOEXEC);
    if (node < 0)
        return errno;
    v4l2_format format{};
    format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    int error = ::ioctl(node, VIDIOC_G_FMT, &format) == 0 ? 0 : errno;
    format.fmt.pix.width = width;
    format.fmt.pix.height = height;
    if (error == 0 && ::ioctl(node, VIDIOC_S_FMT, &format) != 0)
        error = errno;
    ::close(node);
    return error;
}

int setVividLoss(int percent) {
    const int node = ::open(kVividNode, O_RDWR | O_CLOEXEC);
    if (node < 0)
        return errno;
    // The driver's own controls have no constants; their names do not change.
    v4l2_queryctrl asked{};
    asked.id = V4L2_CTRL_FLAG_NEXT_CTRL;
    while (::ioctl(node, VIDIOC_QUERYCTRL, &asked) == 0 &&
           std::string_view(reinterpret_cast<const char*>(asked.name)) != "Percentage of Dropped Buffers")
        asked.id |= V4L2_CTRL_FLAG_NEXT_CTRL;
    v4l2_ext_control control{};
    control.id = asked.id;
    control.value = percent;
    v4l2_ext_controls controls{};
    controls.which = V4L2_CTRL_WHICH_CUR_VAL;
    controls.count = 1;
    controls.controls = &control;
    const int error = ::ioctl(node, VIDIOC_S_EXT_CTRLS, &controls) == 0 ? 0 : errno;
    ::close(node);
    return error;
}

} // namespace teleta::test
