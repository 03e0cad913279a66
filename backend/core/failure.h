// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QString>

#include <utility>

namespace teleta::core {

/// An error with translated texts, to be returned from a function that returns an Expected:
///   return failed(ErrorKind::badInput, Text::tr("the gain is negative"), {}, {path, line, column});
/// Thread: any (pure).
[[nodiscard]] inline Unexpected failed(ErrorKind kind, const QString& message, const QString& expected = {},
                                       SourcePlace where = {}) {
    return Unexpected(Error{kind, message.toStdString(), expected.toStdString(), std::move(where)});
}

/// The same for a well-formed request that cannot be answered.
[[nodiscard]] inline Unexpected refused(const QString& message, const QString& expected = {}) {
    return failed(ErrorKind::refused, message, expected);
}

} // namespace teleta::core
