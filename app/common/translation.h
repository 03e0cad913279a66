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

/// The one whose texts are installed; English without any. Thread: the application's.
[[nodiscard]] QLocale installedLocale(const QCoreApplication& application);

/// The locale of which texts are shown where this one is asked for: itself, or English. Thread: any.
[[nodiscard]] QLocale availableLocale(const QLocale& locale);

} // namespace teleta::app
