// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/interruption.h"
#include "app/cli/program.h"
#include "app/common/arguments.h"
#include "app/common/translation.h"
#include "app/common/version.h"

#include <QCoreApplication>
#include <QLocale>

#include <clocale>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace {

/// Qt warns on every start in the C locale, where cron jobs and containers live; C.UTF-8 is the same but for
/// file names, which are UTF-8 then.
void preferUtf8() {
    const char* name = std::setlocale(LC_CTYPE, "");
    if (name == nullptr || std::string_view(name) == "C" || std::string_view(name) == "POSIX") {
        const char* all = std::getenv("LC_ALL");
        setenv(all != nullptr && *all != '\0' ? "LC_ALL" : "LC_CTYPE", "C.UTF-8", 1);
    }
}

} // namespace

int main(int argc, char** argv) {
    preferUtf8();
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("teleta"));
    QCoreApplication::setApplicationVersion(teleta::app::version().text());
    // Qt has set the locale of the environment; numbers in options and files do not depend on it.
    std::setlocale(LC_NUMERIC, "C");
    teleta::app::installTranslator(application, QLocale::system());
    teleta::cli::catchInterruptions();
    const std::vector<std::string> copies(argv, argv + argc);
    teleta::app::hidePasswords(argc, argv);
    std::vector<const char*> arguments;
    for (const std::string& copy : copies)
        arguments.push_back(copy.c_str());
    return teleta::cli::runProgram(argc, arguments.data());
}
