// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/arguments.h"
#include "app/common/translation.h"
#include "app/common/version.h"
#include "app/console/base/console_settings.h"
#include "app/console/console_options.h"
#include "app/console/help/about.h"
#include "app/console/help/log_window.h"
#include "app/console/language_menu.h"
#include "app/console/main_window.h"
#include "app/console/sudden_end.h"
#include "app/console/unattended.h"
#include "backend/core/threads/stop_switch.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/vtk/gl_setup.h"

#include <QApplication>
#include <QLocale>
#include <QStandardPaths>
#include <QTimer>

#include <algorithm>
#include <array>
#include <cstdio>
#include <future>
#include <optional>
#include <string_view>

namespace {

using namespace teleta;

/// By then the window has been shown.
constexpr int kDriverAfter_ms = 300;

int print(const console::ParsedOptions& parsed) {
    std::fprintf(parsed.exitCode == 0 ? stdout : stderr, "%s\n", qPrintable(parsed.text));
    return parsed.exitCode;
}

/// What --help and --version print needs no screen, and there may be none.
std::optional<int> answerWithoutScreen(int argc, char* argv[]) {
    constexpr std::array<std::string_view, 5> kQuestions{"-h", "--help", "--help-all", "-v", "--version"};
    const bool asked = std::any_of(argv + 1, argv + argc, [&](const char* argument) {
        return std::find(kQuestions.begin(), kQuestions.end(), argument) != kQuestions.end();
    });
    if (!asked)
        return std::nullopt;
    QCoreApplication application(argc, argv);
    app::installTranslator(application, QLocale::system());
    const console::ParsedOptions parsed = console::parseOptions(QCoreApplication::arguments());
    return parsed.options ? std::nullopt : std::optional(print(parsed));
}

} // namespace

int main(int argc, char* argv[]) {
    QCoreApplication::setOrganizationName(QStringLiteral("TeleTA"));
    QCoreApplication::setApplicationName(QStringLiteral("teleta-console"));
    QCoreApplication::setApplicationVersion(app::version().text());
    if (const std::optional<int> exitCode = answerWithoutScreen(argc, argv))
        return *exitCode;

    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    QGuiApplication::setDesktopFileName(QStringLiteral("org.teleta.Console"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/teleta-console.svg")));
    app::installTranslator(application, QLocale::system());
    console::beginLog();

    const console::ParsedOptions parsed = console::parseOptions(QCoreApplication::arguments());
    app::hidePasswords(argc, argv);
    if (!parsed.options)
        return print(parsed);
    console::ConsoleOptions options = *parsed.options;
    const bool fresh = options.freshLayout || !options.screenshot.isEmpty() || options.measure_s;
    if (options.dataFolder.isEmpty() && !fresh)
        options.dataFolder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);

    console::ConsoleSettings settings(fresh);
    const QString language = options.language.isEmpty() ? settings.language() : options.language;
    console::useLanguage(application, language);
    base::applyTheme(console::themeFromName(options.theme.isEmpty() ? settings.theme() : options.theme));

    core::StopSwitch stop;
    console::MainWindow window(options, settings, stop);
    const console::SuddenEnd end(stop, {[&window] { window.leave(); }, [&window] { window.secure(); }});
    console::Unattended unattended(options, window);
    window.show();
    window.openRequested(options);
    // It takes long to load: not before the window is shown, nor when the first source is.
    std::future<bool> driver;
    QTimer::singleShot(kDriverAfter_ms, &window,
                       [&driver] { driver = std::async(std::launch::async, &view3d::loadOpenGlDriver); });
    unattended.start();
    const int code = QApplication::exec();
    // It uses the application, which a console that is closed at once would take away from it.
    if (driver.valid())
        driver.wait();
    return code;
}
