// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/duration_text.h"

#include <QCoreApplication>

#include <cmath>

namespace teleta::app {

namespace {

struct DurationText {
    Q_DECLARE_TR_FUNCTIONS(DurationText)
};

} // namespace

QString durationText(double duration_s) {
    if (!std::isfinite(duration_s))
        return QStringLiteral("\u2014");
    const auto whole = static_cast<qint64>(std::ceil(duration_s));
    if (whole < 60)
        return DurationText::tr("%1 s").arg(whole);
    if (whole < 3600)
        return DurationText::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
    return DurationText::tr("%1 h %2 min").arg(whole / 3600).arg(whole % 3600 / 60);
}

} // namespace teleta::app
