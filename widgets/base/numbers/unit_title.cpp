// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/numbers/unit_title.h"

#include <QCoreApplication>

namespace teleta::base {

namespace {

struct UnitTitleText {
    Q_DECLARE_TR_FUNCTIONS(UnitTitle)
};

} // namespace

QString titleWithUnit(const QString& title, const QString& unit) {
    return unit.isEmpty() ? title : UnitTitleText::tr("%1 (%2)", "a title and its unit").arg(title, unit);
}

QString titleOverUnit(const QString& title, const QString& unit) {
    return unit.isEmpty() ? title : UnitTitleText::tr("%1\n(%2)", "a title above its unit").arg(title, unit);
}

} // namespace teleta::base
