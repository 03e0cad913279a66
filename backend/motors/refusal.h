// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QString>

namespace teleta::motors {

/// The error for a measurement that is not good enough: what is missing, and what would help.
[[nodiscard]] inline core::Unexpected refused(const QString& message, const QString& expected = {}) {
    return core::Unexpected(
        core::Error{core::ErrorKind::refused, message.toStdString(), expected.toStdString(), {}});
}

} // namespace teleta::motors
