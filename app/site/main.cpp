// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/arguments.h"
#include "app/common/translation.h"
#include "app/common/version.h"
#include "app/site/site_program.h"

#include <QCoreApplication>
#include <QLocale>

#include <clocale>
#include <string>
#include <vector>

int main(int argc, char** argv) {
    // First of all: threads take over what signals the first one blocks.
    const teleta::site_program::SiteSignals sent;
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("teleta-site"));
    QCoreApplication::setApplicationVersion(teleta::app::version().text());
    std::setlocale(LC_NUMERIC, "C");
    teleta::app::installTranslator(application, QLocale::system());
    const std::vector<std::string> copies(argv, argv + argc);
    teleta::app::hidePasswords(argc, argv);
    std::vector<const char*> arguments;
    for (const std::string& copy : copies)
        arguments.push_back(copy.c_str());
    return teleta::site_program::runProgram(argc, arguments.data(), sent);
}
