// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/translation.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QTranslator>

#include <memory>

namespace teleta::app {
namespace {

constexpr QLatin1String kOwner("teleta translation");

} // namespace

QList<QLocale> availableLocales() {
    return {QLocale(QLocale::English), QLocale(QLocale::French), QLocale(QLocale::Japanese),
            QLocale(QLocale::Chinese, QLocale::China)};
}

QLocale installTranslator(QCoreApplication& application, const QLocale& locale) {
    auto own = std::make_unique<QTranslator>();
    const QString folder = QStringLiteral(":/i18n");
    [[maybe_unused]] const bool loaded =
        own->load(locale, QStringLiteral("teleta"), QStringLiteral("_"), folder) ||
        own->load(QStringLiteral("teleta_en"), folder);
    Q_ASSERT(loaded);
    const QLocale installed(own->language());
    auto qt = std::make_unique<QTranslator>();
    const bool hasQtTexts = qt->load(installed, QStringLiteral("qtbase"), QStringLiteral("_"),
                                     QLibraryInfo::path(QLibraryInfo::TranslationsPath));

    qDeleteAll(application.findChildren<QTranslator*>(kOwner, Qt::FindDirectChildrenOnly));
    // The one installed last is asked first.
    if (hasQtTexts) {
        qt->setObjectName(kOwner);
        qt->setParent(&application);
        QCoreApplication::installTranslator(qt.release());
    }
    own->setObjectName(kOwner);
    own->setParent(&application);
    QCoreApplication::installTranslator(own.release());
    return installed;
}

QLocale installedLocale(const QCoreApplication& application) {
    // The program's own texts were installed after those of Qt.
    const QList<QTranslator*> translators =
        application.findChildren<QTranslator*>(kOwner, Qt::FindDirectChildrenOnly);
    return translators.isEmpty() ? QLocale(QLocale::English) : QLocale(translators.back()->language());
}

QLocale availableLocale(const QLocale& locale) {
    QTranslator texts;
    return texts.load(locale, QStringLiteral("teleta"), QStringLiteral("_"), QStringLiteral(":/i18n"))
               ? QLocale(texts.language())
               : QLocale(QLocale::English);
}

} // namespace teleta::app
