// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QString>

namespace teleta::motors {

/// What a measurement of motors does not show, in words, and what would show it.
[[nodiscard]] inline core::Unexpected refused(const QString& message, const QString& expected = {}) {
    return core::Unexpected(
        core::Error{core::ErrorKind::refused, message.toStdString(), expected.toStdString(), {}});
}

} // namespace teleta::motors
