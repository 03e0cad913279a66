// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/peer/mouse3d/evdev_view.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fcntl.h>
#include <filesystem>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>

namespace teleta::peer {

namespace {

int require(int result, const char* what) {
    if (result < 0)
        throw std::system_error(errno, std::generic_category(), what);
    return result;
}

} // namespace

std::optional<std::string> findEvdev(const std::string& name) {
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator("/dev/input", none)) {
        const std::string path = entry.path();
        if (!entry.path().filename().string().starts_with("event"))
            continue;
        const int device = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
        if (device < 0)
            continue;
        std::array<char, 256> text{};
        const bool named = ::ioctl(device, EVIOCGNAME(text.size() - 1), text.data()) >= 0;
        ::close(device);
        if (named && name == text.data())
            return path;
    }
    return std::nullopt;
}

EvdevView::EvdevView(const std::string& path)
    : m_device(require(::open(path.c_str(), O_RDONLY | O_CLOEXEC), path.c_str())) {
}

EvdevView::~EvdevView() {
    ::close(m_device);
}

int EvdevView::axis(int code) const {
    input_absinfo info{};
    require(::ioctl(m_device, EVIOCGABS(static_cast<unsigned>(code)), &info), "EVIOCGABS");
    return info.value;
}

bool EvdevView::button(int code) const {
    std::array<std::uint8_t, KEY_MAX / 8 + 1> keys{};
    require(::ioctl(m_device, EVIOCGKEY(keys.size()), keys.data()), "EVIOCGKEY");
    return (keys[static_cast<std::size_t>(code / 8)] >> (code % 8) & 1) != 0;
}

} // namespace teleta::peer
