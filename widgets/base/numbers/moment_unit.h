// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cmath>

namespace teleta::base {

struct MomentUnit {
    double perNm = 1.0;
    QString name;
};

/// The unit in which moments up to this size are told: mNm below 1 Nm, and of NaN.
[[nodiscard]] inline MomentUnit momentUnit(double size_Nm) {
    return std::isgreaterequal(size_Nm, 1.0) ? MomentUnit{1.0, QStringLiteral("Nm")}
                                             : MomentUnit{1e3, QStringLiteral("mNm")};
}

} // namespace teleta::base
