// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::base {

/// Title of an axis, a column or a field with the unit of its numbers: "speed (Hz)". Without a unit: the
/// title alone. Everything that is titled is titled so. Thread: any.
[[nodiscard]] QString titleWithUnit(const QString& title, const QString& unit);

/// The same on two lines, for a narrow column.
[[nodiscard]] QString titleOverUnit(const QString& title, const QString& unit);

} // namespace teleta::base
