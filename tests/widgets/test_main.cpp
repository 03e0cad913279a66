// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"

#include <QApplication>
#include <QLocale>
#include <QStandardPaths>
#include <QTest>

int main(int argc, char** argv) {
    QLocale::setDefault(QLocale::c());
    QStandardPaths::setTestModeEnabled(true);
    QApplication app(argc, argv);
    teleta::base::applyTheme(teleta::base::ThemeChoice::light);
    int failures = 0;
    for (const auto& make : teleta::test::registry())
        failures += QTest::qExec(make().get(), argc, argv);
    return failures;
}
