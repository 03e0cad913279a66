// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/key_reference.h"

#include "backend/core/unit_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace teleta::core {

namespace {

std::string numberText(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

std::string code(std::string_view text) {
    return '`' + std::string(text) + '`';
}

std::string rangeText(const NumberRange& range, const ReferenceWords& words) {
    const std::string low = range.lowIs != nullptr ? range.lowIs : numberText(range.low);
    const bool hasLow = std::isfinite(range.low);
    const bool hasHigh = std::isfinite(range.high);
    if (hasLow && hasHigh && !range.lowOpen)
        return low + " … " + numberText(range.high);
    std::string text = hasLow ? (range.lowOpen ? "> " : "≥ ") + low : std::string();
    if (hasHigh)
        text += (text.empty() ? "≤ " : ", ≤ ") + numberText(range.high);
    if (text.empty())
        text = words.number;
    return range.allowNonFinite ? text + ", " + code("nan") : text;
}

std::string wholeText(const WholeRange& range, const ReferenceWords& words) {
    const std::string low = std::to_string(range.low);
    if (range.highIs == nullptr && range.high == WholeRange().high)
        return words.whole + ", ≥ " + low;
    return words.whole + ", " + low + " … " +
           (range.highIs != nullptr ? range.highIs : std::to_string(range.high));
}

} // namespace

KeyReference::KeyReference(ReferenceWords words)
    : m_tables(std::make_shared<std::vector<ReferenceTable>>(1))
    , m_words(std::move(words)) {
}

KeyReference::KeyReference(const KeyReference& parent, const std::string& path, bool list)
    : m_tables(parent.m_tables)
    , m_words(parent.m_words)
    , m_path(path) {
    const std::string head = list ? "[[" + path + "]]" : '[' + path + ']';
    // A table that several choices have is shown once.
    const auto known = std::ranges::find(*m_tables, head, &ReferenceTable::path);
    m_table = static_cast<std::size_t>(known - m_tables->begin());
    if (known == m_tables->end())
        m_tables->push_back({.path = head, .rows = {}});
}

std::string KeyReference::markdown(int level) const {
    std::string text;
    for (const ReferenceTable& table : *m_tables) {
        if (table.rows.empty())
            continue;
        if (!table.path.empty())
            text += std::string(static_cast<std::size_t>(level), '#') + ' ' + code(table.path) + "\n\n";
        text += "| " + m_words.key + " | " + m_words.unit + " | " + m_words.accepts + " | " +
                m_words.fallback + " | " + m_words.meaning + " |\n|---|---|---|---|---|\n";
        for (const ReferenceTable::Row& row : table.rows)
            text += "| " + code(row.key) + " | " + row.unit + " | " + row.accepts + " | " + row.fallback +
                    " | " + (row.when.empty() ? std::string() : row.when + ": ") + row.meaning + " |\n";
        text += '\n';
    }
    return text;
}

void KeyReference::add(std::string_view key, std::string accepts, Need need, std::string fallback,
                       std::string_view about) {
    ReferenceTable::Row row{.key = std::string(key),
                            .unit = std::string(unitOf(key)),
                            .accepts = std::move(accepts),
                            .fallback = need == Need::required          ? m_words.required
                                        : std::exchange(m_unset, false) ? std::string("—")
                                                                        : std::move(fallback),
                            .meaning = std::string(about),
                            .when = m_when};
    auto& rows = (*m_tables)[m_table].rows;
    const auto same = std::ranges::find_if(rows, [&](const ReferenceTable::Row& known) {
        return known.key == row.key && known.accepts == row.accepts && known.meaning == row.meaning;
    });
    if (same == rows.end())
        rows.push_back(std::move(row));
    else if (!same->when.empty() && same->when != m_when)
        same->when += ", " + m_when;
}

void KeyReference::number(std::string_view key, double& value, const NumberRange& range,
                          std::string_view about, Need need) {
    add(key, rangeText(range, m_words), need, numberText(value), about);
}

void KeyReference::numbers(std::string_view key, std::span<const std::string_view> names,
                           std::span<double> values, const NumberRange& range, std::string_view about,
                           Need need) {
    std::string accepts;
    std::string fallback;
    for (std::size_t i = 0; i < names.size(); ++i) {
        accepts += (i > 0 ? ", " : "{ ") + std::string(names[i]);
        fallback += (i > 0 ? ", " : "") + numberText(values[i]);
    }
    add(key, code(accepts + " }") + ", " + rangeText(range, m_words), need, fallback, about);
}

void KeyReference::list(std::string_view key, std::vector<double>& values, const NumberRange& range,
                        const WholeRange& count, std::string_view about, Need need) {
    std::string fallback;
    for (const double value : values)
        fallback += (fallback.empty() ? "" : ", ") + numberText(value);
    const std::string length = count.low == count.high
                                   ? std::to_string(count.low)
                                   : std::to_string(count.low) + " … " + std::to_string(count.high);
    add(key, m_words.list + " (" + length + "), " + rangeText(range, m_words), need,
        fallback.empty() ? "—" : code('[' + fallback + ']'), about);
}

void KeyReference::rows(std::string_view key, std::vector<std::vector<double>>&, const NumberRange& range,
                        std::size_t, std::size_t perRow, std::string_view about, Need need) {
    std::string row;
    for (std::size_t i = 0; i < perRow; ++i)
        row += (i > 0 ? ", " : "") + m_words.number;
    add(key, m_words.list + ", [" + row + "], " + rangeText(range, m_words), need, "—", about);
}

void KeyReference::texts(std::string_view key, std::vector<std::string>& values, std::string_view about,
                         Need need) {
    std::string fallback;
    for (const std::string& value : values)
        fallback += (fallback.empty() ? "\"" : ", \"") + value + '"';
    add(key, m_words.list + ", " + m_words.text, need, fallback.empty() ? "—" : code('[' + fallback + ']'),
        about);
}

void KeyReference::flag(std::string_view key, bool& value, std::string_view about) {
    add(key, "`true`, `false`", Need::optional, code(value ? "true" : "false"), about);
}

void KeyReference::text(std::string_view key, std::string& value, std::string_view about, Need need) {
    add(key, m_words.text, need, value.empty() ? std::string("—") : code(value), about);
}

void KeyReference::wholeNumber(std::string_view key, long long& value, const WholeRange& range,
                               std::string_view about, Need need) {
    add(key, wholeText(range, m_words), need, std::to_string(value), about);
}

void KeyReference::choose(std::string_view key, std::size_t value, const KeyNames& names,
                          std::string_view about, Need need, const DescribeAt& describe) {
    std::string accepts;
    for (const KeyName& name : names)
        accepts += (accepts.empty() ? "" : ", ") + code(name.name);
    add(key, accepts, need, value < names.size() ? code(names[value].name) : std::string(), about);
    const std::string before = std::exchange(m_when, {});
    std::string always;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!names[i].about.empty())
            add(std::string(key) + " = \"" + std::string(names[i].name) + '"', {}, Need::optional, {},
                names[i].about);
        m_when = code(names[i].name);
        always += (always.empty() ? "" : ", ") + m_when;
        describe(*this, i);
        m_when.clear();
    }
    // What all of them have needs no condition.
    for (ReferenceTable::Row& row : (*m_tables)[m_table].rows)
        if (row.when == always)
            row.when = before;
    m_when = before;
}

void KeyReference::addTable(std::string_view key, const std::string& accepts, Need need,
                            std::string_view about, bool list, const Describe& describe) {
    // What a page says in a heading of its own needs no row.
    if (!about.empty())
        add(key, accepts, need, "—", about);
    KeyReference nested(*this, m_path.empty() ? std::string(key) : m_path + '.' + std::string(key), list);
    describe(nested);
}

void KeyReference::table(std::string_view key, std::string_view about, Need need, const Describe& describe) {
    addTable(key, m_words.table, need, about, false, describe);
}

void KeyReference::tableList(std::string_view key, std::size_t minimum, std::string_view about, std::size_t,
                             const std::function<void(std::size_t)>& resize, const DescribeAt& describe) {
    resize(1);
    addTable(key, m_words.tables + (minimum > 1 ? ", ≥ " + std::to_string(minimum) : std::string()),
             minimum > 0 ? Need::required : Need::optional, about, true,
             [&describe](Keys& keys) { describe(keys, 0); });
}

} // namespace teleta::core
