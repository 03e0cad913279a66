// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace teleta::peer {

/// Path of the input device that the kernel made of a HID device, by its name; none when there is none yet.
[[nodiscard]] std::optional<std::string> findEvdev(const std::string& name);

/// What the kernel itself reads from the reports of a HID device. Functions throw std::system_error when the
/// kernel refuses. Thread: one.
class EvdevView {
public:
    explicit EvdevView(const std::string& path);
    ~EvdevView();
    EvdevView(const EvdevView&) = delete;
    EvdevView& operator=(const EvdevView&) = delete;

    /// In counts; code: ABS_X ...
    [[nodiscard]] int axis(int code) const;
    /// code: BTN_0 ...
    [[nodiscard]] bool button(int code) const;

private:
    int m_device = -1;
};

} // namespace teleta::peer
