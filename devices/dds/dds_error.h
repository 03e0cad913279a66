// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QString>

#include <cstdint>

namespace teleta::dds {

/// The error of a call to the middleware that returned this negative number. Thread: any.
[[nodiscard]] core::Unexpected ddsFailure(const QString& message, std::int32_t code);

} // namespace teleta::dds
