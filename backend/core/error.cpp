// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/error.h"

#include "backend/core/passwords.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::core {

std::string describe(const Error& error) {
    std::string text;
    if (!error.where.file.empty()) {
        text += error.where.file;
        if (error.where.line > 0) {
            text += ':' + std::to_string(error.where.line);
            if (error.where.column > 0)
                text += ':' + std::to_string(error.where.column);
        }
        text += ": ";
    }
    text += error.message;
    if (!error.expected.empty())
        text += QCoreApplication::translate("Error", " (expected %1)")
                    .arg(QString::fromStdString(error.expected))
                    .toStdString();
    return withoutPasswords(std::move(text));
}

} // namespace teleta::core
