// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/identifier.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>

namespace teleta::study {

namespace {

struct IdentifierText {
    Q_DECLARE_TR_FUNCTIONS(IdentifierText)
};

bool isIdentifier(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    });
}

} // namespace

std::string readIdentifier(core::TomlTable& table, std::string_view key, std::set<std::string>& used) {
    std::string text = table.text(key);
    if (!isIdentifier(text))
        table.fail(key,
                   IdentifierText::tr("\"%1\" cannot be part of a file name").arg(text.c_str()).toStdString(),
                   IdentifierText::tr("letters, digits, - and _").toStdString());
    else if (!text.empty() && !used.insert(text).second)
        table.fail(key, IdentifierText::tr("\"%1\" occurs twice").arg(text.c_str()).toStdString(),
                   IdentifierText::tr("each one once").toStdString());
    return text;
}

} // namespace teleta::study
