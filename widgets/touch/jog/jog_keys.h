// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <Qt>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace teleta::touch {

/// The keys that move one joint, or the tip along one axis.
struct KeyPair {
    int down, up;
};
inline constexpr std::array<KeyPair, 7> kJointKeys{{{Qt::Key_A, Qt::Key_Q},
                                                    {Qt::Key_S, Qt::Key_W},
                                                    {Qt::Key_D, Qt::Key_E},
                                                    {Qt::Key_F, Qt::Key_R},
                                                    {Qt::Key_G, Qt::Key_T},
                                                    {Qt::Key_H, Qt::Key_Y},
                                                    {Qt::Key_J, Qt::Key_U}}};
inline constexpr std::array<KeyPair, 3> kTipKeys{
    {{Qt::Key_A, Qt::Key_D}, {Qt::Key_S, Qt::Key_W}, {Qt::Key_Q, Qt::Key_E}}};

/// The keys of a joint or, with tip, of an axis. Empty: it has buttons only.
[[nodiscard]] inline std::optional<KeyPair> keysOf(bool tip, std::size_t axis) {
    if (tip)
        return kTipKeys[axis];
    return axis < kJointKeys.size() ? std::optional(kJointKeys[axis]) : std::nullopt;
}

/// The keys of so many joints in one direction, as text: "Q W E R".
inline QString lettersOf(std::size_t joints, int KeyPair::*key) {
    QStringList letters;
    for (std::size_t joint = 0; joint < std::min(joints, kJointKeys.size()); ++joint)
        letters += QChar(kJointKeys[joint].*key);
    return letters.join(QLatin1Char(' '));
}

} // namespace teleta::touch
