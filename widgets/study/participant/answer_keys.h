// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstddef>
#include <optional>

class QKeyEvent;

namespace teleta::study {

/// A physical key, whatever the keyboard layout and Num Lock.
struct PhysicalKey {
    enum class Kind {
        digit, ///< 1 to 9, above the letters
        pad,   ///< 1 to 9 on the keypad
        space,
        letter, ///< Y, N, S or D, where they are on a US keyboard
    };
    Kind kind = Kind::digit;
    std::size_t number = 0; ///< 1 .. 9; 0 for the space bar and letters
    char letter = 0;        ///< 'Y'; 0 for others

    /// Code in W3C UI Events: "Digit3", "Numpad3", "Space", "KeyY".
    [[nodiscard]] QString code() const;
    /// "keyboard" or "keypad".
    [[nodiscard]] QString device() const;
};

/// From the scan code under X11 and Wayland (evdev + 8), otherwise from Qt's key. Empty for other keys.
/// Thread: GUI.
[[nodiscard]] std::optional<PhysicalKey> physicalKey(const QKeyEvent& event);

} // namespace teleta::study
