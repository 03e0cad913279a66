// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/dds_error.h"

#include "backend/core/failure.h"

#include <dds/dds.h>

namespace teleta::dds {

core::Unexpected ddsFailure(const QString& message, std::int32_t code) {
    return core::failed(core::ErrorKind::unavailable,
                        QStringLiteral("%1: %2").arg(message, QLatin1String(dds_strretcode(code))));
}

} // namespace teleta::dds
