// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/peer/vivid_driver.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <linux/videodev2.h>
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

} // namespace teleta::test
