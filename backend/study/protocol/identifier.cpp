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
    return std::ranges::all_of(text, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    });
}

} // namespace

void describeIdentifier(core::Keys& keys, std::string_view key, std::string& value,
                        std::set<std::string>& used, std::string_view about) {
    keys.text(key, value, about);
    if (!isIdentifier(value))
        keys.refuse(
            key, IdentifierText::tr("\"%1\" cannot be part of a file name").arg(value.c_str()).toStdString(),
            IdentifierText::tr("letters, digits, - and _").toStdString());
    else if (!value.empty() && !used.insert(value).second)
        keys.refuse(key, IdentifierText::tr("\"%1\" occurs twice").arg(value.c_str()).toStdString(),
                    IdentifierText::tr("each one once").toStdString());
}

} // namespace teleta::study
