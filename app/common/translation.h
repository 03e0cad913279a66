// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QLocale>

class QCoreApplication;

namespace teleta::app {

/// The languages that the programs speak, English first.
[[nodiscard]] QList<QLocale> availableLocales();

/// Gives the application the texts of a language, its own and those of Qt, in place of those installed
/// before. Qt then sends QEvent::LanguageChange to every widget. A locale whose language is not available
/// gets English. Returns the locale whose texts are installed. Thread: the application's.
QLocale installTranslator(QCoreApplication& application, const QLocale& locale);

} // namespace teleta::app
