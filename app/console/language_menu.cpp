// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/language_menu.h"

#include "app/common/translation.h"
#include "app/console/base/console_settings.h"

#include <QActionGroup>
#include <QApplication>
#include <QMenu>

namespace teleta::console {

namespace {

struct MenuText {
    Q_DECLARE_TR_FUNCTIONS(LanguageMenu)
};

/// As those who speak it look for it, whatever language is in use.
QString ownName(const QLocale& locale) {
    switch (locale.language()) {
    case QLocale::French:
        return QStringLiteral("Fran\u00e7ais");
    case QLocale::Japanese:
        return QStringLiteral("\u65e5\u672c\u8a9e");
    case QLocale::Chinese:
        return QStringLiteral("\u7b80\u4f53\u4e2d\u6587");
    default:
        return QStringLiteral("English");
    }
}

/// "en", "fr", "ja", "zh_CN".
QString code(const QLocale& locale) {
    return locale.language() == QLocale::Chinese ? locale.name() : QLocale::languageToCode(locale.language());
}

} // namespace

void useLanguage(QApplication& application, const QString& language) {
    const QLocale desktop = QLocale::system();
    const QLocale chosen(language);
    const QLocale numbers = language.isEmpty() || chosen.language() == desktop.language() ? desktop : chosen;
    QLocale::setDefault(numbers);
    for (QWidget* window : QApplication::topLevelWidgets())
        window->setLocale(numbers);
    // Views ask for their texts, and so for numbers, when they are told of the translator.
    app::installTranslator(application, language.isEmpty() ? desktop : chosen);
}

std::vector<std::pair<QString, QString>> languageChoices() {
    std::vector<std::pair<QString, QString>> choices;
    for (const QLocale& locale : app::availableLocales())
        choices.emplace_back(ownName(locale), code(locale));
    return choices;
}

void addLanguageMenu(QMenu& view, ConsoleSettings& settings) {
    QMenu* menu = view.addMenu(MenuText::tr("Lan&guage"));
    menu->setObjectName(QStringLiteral("languages"));
    auto* group = new QActionGroup(menu);
    QApplication& application = *qApp;
    const auto add = [&](const QString& text, const QString& language, bool isChosen) {
        QAction* action = menu->addAction(text, menu, [&application, &settings, language] {
            settings.setLanguage(language);
            useLanguage(application, language);
        });
        action->setCheckable(true);
        action->setChecked(isChosen);
        group->addAction(action);
    };
    const QLocale installed = app::installedLocale(application);
    const bool asDesktop = settings.language().isEmpty() &&
                           installed.language() == app::availableLocale(QLocale::system()).language();
    add(MenuText::tr("As the &desktop"), QString(), asDesktop);
    menu->addSeparator();
    for (const QLocale& locale : app::availableLocales())
        add(ownName(locale), code(locale), !asDesktop && locale.language() == installed.language());
}

} // namespace teleta::console
