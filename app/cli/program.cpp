// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/program.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/standard_streams.h"
#include "app/common/arguments.h"
#include "app/common/translation.h"
#include "app/common/version.h"
#include "backend/core/failure.h"
#include "backend/core/passwords.h"

#include <QCoreApplication>
#include <QLocale>

#include <CLI/CLI.hpp>

#include <clocale>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::cli {

namespace {

struct ProgramText {
    Q_DECLARE_TR_FUNCTIONS(ProgramText)
};

void translateHelp(CLI::App& app) {
    const auto label = [&app](const char* key, const char* text) {
        app.get_formatter()->label(key, QCoreApplication::translate("ProgramText", text).toStdString());
    };
    label("Usage", QT_TRANSLATE_NOOP("ProgramText", "Usage"));
    label("OPTIONS", QT_TRANSLATE_NOOP("ProgramText", "OPTIONS"));
    label("Options", QT_TRANSLATE_NOOP("ProgramText", "Options"));
    label("Positionals", QT_TRANSLATE_NOOP("ProgramText", "Arguments"));
    label("SUBCOMMAND", QT_TRANSLATE_NOOP("ProgramText", "COMMAND"));
    label("Subcommands", QT_TRANSLATE_NOOP("ProgramText", "Commands"));
    label("REQUIRED", QT_TRANSLATE_NOOP("ProgramText", "(required)"));
    app.set_help_flag("-h,--help", ProgramText::tr("Print this help").toStdString());
}

/// Of an app whose command nobody knows; empty when that is not what is wrong.
QString unknownCommand(const CLI::App& app) {
    QStringList names;
    for (const CLI::App* known : app.get_subcommands([](const CLI::App*) { return true; }))
        names << QString::fromStdString(known->get_name());
    const std::vector<std::string> words = app.remaining();
    if (names.isEmpty() || !app.get_subcommands().empty() || words.empty() || words.front().starts_with('-'))
        return {};
    return ProgramText::tr("there is no command '%1'; expected one of %2")
        .arg(QString::fromStdString(words.front()), names.join(QStringLiteral(", ")));
}

std::string usageError(const CLI::App* app, const CLI::Error& error) {
    QString command = QStringLiteral("teleta");
    while (!app->get_subcommands().empty()) {
        app = app->get_subcommands().front();
        command += QLatin1Char(' ') + QString::fromStdString(app->get_name());
    }
    const QString unknown = unknownCommand(*app);
    return ProgramText::tr("teleta: %1\nRun %2 --help for more.\n")
        .arg(unknown.isEmpty() ? QString::fromStdString(core::withoutPasswords(error.what())) : unknown,
             command)
        .toStdString();
}

ExitCode printAbout(bool citation, bool json) {
    const QString text = citation ? app::citation()
                         : json   ? app::versionJson(QStringLiteral("teleta"))
                                  : QStringLiteral("teleta %1\n").arg(app::version().number);
    const core::Expected<void> done = printText(text.toStdString());
    if (!done) {
        printError(done.error());
        return kWorkFailed;
    }
    return kDone;
}

/// The outcome of a command, also when the memory of the computer is not enough.
core::Expected<void> runWithin(const Command& command) {
    try {
        return command.run();
    } catch (const std::bad_alloc&) {
        return core::failed(core::ErrorKind::ioFailed, ProgramText::tr("there is not enough memory"));
    }
}

/// Qt warns on every start in the C locale, where cron jobs and containers live; C.UTF-8 is the same but for
/// file names, which are UTF-8 then.
void preferUtf8() {
    const char* name = std::setlocale(LC_CTYPE, "");
    if (name == nullptr || std::string_view(name) == "C" || std::string_view(name) == "POSIX") {
        const char* all = std::getenv("LC_ALL");
        setenv(all != nullptr && *all != '\0' ? "LC_ALL" : "LC_CTYPE", "C.UTF-8", 1);
    }
}

int runCommands(int argc, const char* const* argv, const std::vector<Command>& commands) {
    CLI::App app(
        ProgramText::tr("Computes contacts, stiffness and shape from what a tactile robot arm has felt.")
            .toStdString(),
        "teleta");
    translateHelp(app);
    bool asksVersion = false;
    bool asksCitation = false;
    bool asJson = false;
    CLI::Option* version =
        app.add_flag("--version", asksVersion, ProgramText::tr("Print the version").toStdString());
    app.add_flag("--json", asJson,
                 ProgramText::tr("With --version: print version and commit as JSON").toStdString())
        ->needs(version);
    app.add_flag("--citation", asksCitation,
                 ProgramText::tr("Print how to cite the program, as BibTeX").toStdString());
    app.failure_message(usageError);
    app.require_subcommand(0, 1);

    for (const Command& command : commands) {
        CLI::App* subcommand = app.add_subcommand(command.name, command.summary.toStdString());
        command.declare(*subcommand);
        subcommand->footer("\n" + ProgramText::tr("Example:").toStdString() + "\n  " + command.example);
    }

    try {
        app.parse(argc, argv);
        if (asksVersion || asksCitation)
            return printAbout(asksCitation, asJson);
        if (app.get_subcommands().empty())
            throw CLI::RequiredError::Subcommand(1);
        refuseTwoOutputs(*app.get_subcommands().front());
        for (const Command& command : commands) {
            if (!app.got_subcommand(command.name))
                continue;
            const core::Expected<void> done = runWithin(command);
            if (done)
                return kDone;
            if (done.error().kind == core::ErrorKind::cancelled && readerIsGone())
                endUnread();
            printError(done.error());
            return exitCode(done.error());
        }
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? kDone : kWrongUsage;
    }
    return kWrongUsage;
}

} // namespace

int runProgram(int argc, char** argv, std::vector<Command> (*commands)()) {
    preferUtf8();
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("teleta"));
    QCoreApplication::setApplicationVersion(app::version().text());
    // Qt has set the locale of the environment; numbers in options and files do not depend on it.
    std::setlocale(LC_NUMERIC, "C");
    app::installTranslator(application, QLocale::system());
    catchInterruptions();
    const std::vector<std::string> copies(argv, argv + argc);
    app::hidePasswords(argc, argv);
    std::vector<const char*> arguments;
    for (const std::string& copy : copies)
        arguments.push_back(copy.c_str());
    return runCommands(argc, arguments.data(), commands());
}

} // namespace teleta::cli
