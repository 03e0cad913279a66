// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/key_lists.h"

#include <QCoreApplication>
#include <QString>

namespace teleta::core {

namespace {

struct KeyListText {
    Q_DECLARE_TR_FUNCTIONS(KeyListText)
};

} // namespace

void describeList(Keys& keys, std::string_view key, std::vector<double>& values, const NumberRange& range,
                  const WholeRange& count, std::string_view about, Need need) {
    dynamic_cast<KeyLists&>(keys).list(key, values, range, count, about, need);
}

void describeRows(Keys& keys, std::string_view key, std::vector<std::vector<double>>& values,
                  const NumberRange& range, std::size_t count, std::size_t perRow, std::string_view about,
                  Need need) {
    dynamic_cast<KeyLists&>(keys).rows(key, values, range, count, perRow, about, need);
}

void describeTexts(Keys& keys, std::string_view key, std::vector<std::string>& values, std::string_view about,
                   Need need) {
    dynamic_cast<KeyLists&>(keys).texts(key, values, about, need);
}

std::string listText(const NumberRange& range, const WholeRange& count) {
    const QString each = QString::fromStdString(range.text());
    return (count.low == count.high
                ? KeyListText::tr("a list of %1, each %2").arg(count.low).arg(each)
                : KeyListText::tr("a list of %1 to %2, each %3").arg(count.low).arg(count.high).arg(each))
        .toStdString();
}

} // namespace teleta::core
