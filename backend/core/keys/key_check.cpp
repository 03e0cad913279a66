// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/key_check.h"

#include <QCoreApplication>
#include <QString>

namespace teleta::core {

namespace {

struct CheckText {
    Q_DECLARE_TR_FUNCTIONS(TomlReader)
};

} // namespace

std::string KeyCheck::pathOf(std::string_view key) const {
    return m_path.empty() ? std::string(key) : m_path + '.' + std::string(key);
}

void KeyCheck::refuse(std::string_view key, const std::string& message, const std::string& expected) {
    if (!m_error)
        m_error = Error{ErrorKind::badInput, message, expected, {pathOf(key)}};
}

void KeyCheck::outOfRange(std::string_view key, double value, const std::string& expected) {
    refuse(key,
           CheckText::tr("\"%1\" is out of range: %2")
               .arg(QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size())),
                    QString::number(value, 'g', 12))
               .toStdString(),
           expected);
}

void KeyCheck::number(std::string_view key, double& value, const NumberRange& range, std::string_view, Need) {
    if (!range.accepts(value))
        outOfRange(key, value, range.text());
}

void KeyCheck::numbers(std::string_view key, std::span<const std::string_view>, std::span<double> values,
                       const NumberRange& range, std::string_view, Need) {
    for (double& value : values)
        number(key, value, range, {}, Need::required);
}

void KeyCheck::list(std::string_view key, std::vector<double>& values, const NumberRange& range,
                    const WholeRange& count, std::string_view, Need need) {
    if (need == Need::optional && values.empty())
        return;
    if (!count.accepts(static_cast<long long>(values.size())))
        outOfRange(key, static_cast<double>(values.size()), listText(range, count));
    for (double& value : values)
        number(key, value, range, {}, Need::required);
}

void KeyCheck::rows(std::string_view key, std::vector<std::vector<double>>& values, const NumberRange& range,
                    std::size_t, std::size_t, std::string_view, Need) {
    for (std::vector<double>& row : values)
        for (double& value : row)
            number(key, value, range, {}, Need::required);
}

void KeyCheck::wholeNumber(std::string_view key, long long& value, const WholeRange& range, std::string_view,
                           Need) {
    if (!range.accepts(value))
        outOfRange(key, static_cast<double>(value), range.text());
}

void KeyCheck::choose(std::string_view, std::size_t value, const KeyNames&, std::string_view, Need,
                      const DescribeAt& describe) {
    describe(*this, value);
}

void KeyCheck::inTable(const std::string& path, const Describe& describe) {
    KeyCheck nested(path);
    describe(nested);
    if (!m_error)
        m_error = nested.m_error;
}

void KeyCheck::table(std::string_view key, std::string_view, Need, const Describe& describe) {
    inTable(pathOf(key), describe);
}

void KeyCheck::tableList(std::string_view key, std::size_t minimum, std::string_view, std::size_t count,
                         const std::function<void(std::size_t)>&, const DescribeAt& describe) {
    if (count < minimum && !m_path.empty())
        refuse(key,
               CheckText::tr("\"%1\" has too few entries")
                   .arg(QString::fromStdString(pathOf(key)))
                   .toStdString(),
               CheckText::tr("at least %1").arg(minimum).toStdString());
    for (std::size_t i = 0; i < count; ++i)
        inTable(pathOf(key) + '[' + std::to_string(i) + ']', [&](Keys& keys) { describe(keys, i); });
}

} // namespace teleta::core
