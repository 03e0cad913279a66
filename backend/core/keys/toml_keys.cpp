// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/toml_keys.h"

#include <algorithm>
#include <iterator>

namespace teleta::core {

namespace {

template <typename Value>
std::optional<Value> fallback(const Value& value, Need need) {
    return need == Need::required ? std::nullopt : std::optional(value);
}

} // namespace

TomlKeys::TomlKeys(TomlTable table, Nested nested)
    : m_table(std::move(table))
    , m_nested(nested) {
}

void TomlKeys::finish() {
    m_table.finish();
    for (const auto& finish : std::exchange(m_atEnd, {}))
        finish();
}

void TomlKeys::number(std::string_view key, double& value, const NumberRange& range, std::string_view,
                      Need need) {
    value = m_table.number(key, range, fallback(value, need));
}

void TomlKeys::numbers(std::string_view key, std::span<const std::string_view> names,
                       std::span<double> values, const NumberRange& range, std::string_view, Need need) {
    if (need == Need::optional && !m_table.has(key))
        return;
    TomlTable table = m_table.table(key);
    for (std::size_t i = 0; i < names.size(); ++i)
        values[i] = table.number(names[i], range);
    table.finish();
}

void TomlKeys::list(std::string_view key, std::vector<double>& values, const NumberRange& range,
                    const WholeRange& count, std::string_view, Need need) {
    if (need == Need::required || m_table.has(key))
        values = m_table.numberList(key, range, count);
}

void TomlKeys::rows(std::string_view key, std::vector<std::vector<double>>& values, const NumberRange& range,
                    std::size_t count, std::size_t perRow, std::string_view, Need need) {
    if (need == Need::required || m_table.has(key))
        values = m_table.numberRows(key, range, count, perRow);
}

void TomlKeys::texts(std::string_view key, std::vector<std::string>& values, std::string_view, Need need) {
    if (need == Need::required || m_table.has(key))
        values = m_table.textList(key);
}

void TomlKeys::flag(std::string_view key, bool& value, std::string_view) {
    value = m_table.boolean(key, value);
}

void TomlKeys::text(std::string_view key, std::string& value, std::string_view, Need need) {
    value = m_table.text(key, fallback(value, need));
}

void TomlKeys::choose(std::string_view key, std::size_t value, const KeyNames& names, std::string_view,
                      Need need, const DescribeAt& describe) {
    if (need == Need::optional && !m_table.has(key))
        return describe(*this, value);
    std::vector<std::string_view> allowed;
    std::ranges::transform(names, std::back_inserter(allowed), &KeyName::name);
    describe(*this, m_table.choice(key, allowed));
}

void TomlKeys::table(std::string_view key, std::string_view, Need need, const Describe& describe) {
    if (need == Need::optional && !m_table.has(key))
        return;
    readNow([table = m_table.table(key), describe] {
        TomlKeys keys(table);
        describe(keys);
        keys.finish();
    });
}

void TomlKeys::tableList(std::string_view key, std::size_t minimum, std::string_view, std::size_t,
                         const std::function<void(std::size_t)>& resize, const DescribeAt& describe) {
    const std::vector<TomlTable> tables = m_table.tables(key, minimum);
    resize(tables.size());
    readNow([tables, describe] {
        for (std::size_t i = 0; i < tables.size(); ++i) {
            TomlKeys keys(tables[i]);
            describe(keys, i);
            keys.finish();
        }
    });
}

void TomlKeys::oneOf(std::string_view first, std::string_view second, const std::string& message,
                     const std::string& expected) {
    if (m_table.has(first) == m_table.has(second))
        refuse(first, message, expected);
}

void TomlKeys::refuse(std::string_view key, const std::string& message, const std::string& expected) {
    m_atEnd.push_back(
        [this, key = std::string(key), message, expected] { m_table.fail(key, message, expected); });
}

void TomlKeys::wholeNumber(std::string_view key, long long& value, const WholeRange& range, std::string_view,
                           Need need) {
    value = m_table.integer(key, range.low, range.high, fallback(value, need));
}

bool TomlKeys::isThere(std::string_view key, bool) {
    return m_table.has(key);
}

void TomlKeys::readNow(const std::function<void()>& read) {
    if (m_nested == Nested::atOnce)
        read();
    else
        m_atEnd.push_back(read);
}

} // namespace teleta::core
