// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/keys.h"

#include <QCoreApplication>
#include <QString>

#include <cmath>

namespace teleta::core {

namespace {

struct RangeText {
    Q_DECLARE_TR_FUNCTIONS(TomlReader)
};

} // namespace

bool NumberRange::accepts(double value) const {
    if (!std::isfinite(value))
        return allowNonFinite;
    return value <= high && (lowOpen ? value > low : value >= low);
}

std::string NumberRange::text() const {
    const QString lowText = QString::number(low, 'g', 12);
    const QString highText = QString::number(high, 'g', 12);
    QString text = allowNonFinite ? RangeText::tr("a number or nan") : RangeText::tr("a finite number");
    if (std::isfinite(low) && std::isfinite(high))
        text = (lowOpen ? RangeText::tr("a number above %1, at most %2")
                        : RangeText::tr("a number from %1 to %2"))
                   .arg(lowText, highText);
    else if (std::isfinite(low))
        text = (lowOpen ? RangeText::tr("a number above %1") : RangeText::tr("a number of at least %1"))
                   .arg(lowText);
    else if (std::isfinite(high))
        text = RangeText::tr("a number of at most %1").arg(highText);
    return text.toStdString();
}

std::string WholeRange::text() const {
    return RangeText::tr("a whole number from %1 to %2").arg(low).arg(high).toStdString();
}

} // namespace teleta::core
