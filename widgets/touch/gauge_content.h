// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/material.h"
#include "backend/stiffness/refusal.h"
#include "backend/stiffness/stiffness_estimator.h"
#include "widgets/base/controls/badge.h"

#include <QString>

#include <optional>

namespace teleta::touch {

/// What the stiffness gauge shows.
struct GaugeContent {
    std::optional<stiffness::TouchStiffness> touch;
    std::optional<stiffness::Refusal> refusal; ///< why there is no stiffness; with touch empty
    base::Provenance provenance = base::Provenance::live;
    QString emptyText;
    std::optional<double> age_s; ///< of the touch; empty: it is not known
};

/// The texts of the gauge, translated when they are asked for.
class GaugeTexts {
    Q_DECLARE_TR_FUNCTIONS(GaugeTexts)

public:
    /// From this age on, what was touched may no longer be what is there.
    static constexpr double kStale_s = 30.0;

    /// The estimate with its unit, or that there is none.
    [[nodiscard]] static QString headline(const GaugeContent& content);
    /// Material with its level, and how sure that is.
    [[nodiscard]] static QString material(const stiffness::TouchStiffness& touch);
    /// Interval, method and samples of an estimate; the reason of a refusal; else empty.
    [[nodiscard]] static QString details(const GaugeContent& content);
    /// What is suspicious about the estimate; empty when nothing is.
    [[nodiscard]] static QString warning(const GaugeContent& content);
    /// A class of the scale with its borders.
    [[nodiscard]] static QString band(const stiffness::MaterialBand& band);
    [[nodiscard]] static bool isStale(const GaugeContent& content);
    /// How long ago the touch was, in whole seconds, minutes or hours; empty without one.
    [[nodiscard]] static QString age(const GaugeContent& content);
    /// All of it in words, for those who do not see the scale.
    [[nodiscard]] static QString spoken(const GaugeContent& content);
};

/// Header and one row with the values of `teleta stiffness`, C locale, NA where undefined; empty without a
/// touch.
[[nodiscard]] QString gaugeCsv(const GaugeContent& content);

} // namespace teleta::touch
