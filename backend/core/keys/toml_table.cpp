// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/toml_table.h"

#include "backend/core/data/input_file.h"
#include "backend/core/failure.h"
#include "backend/core/keys/key_lists.h"
#include "backend/core/keys/key_names.h"
#include "backend/core/keys/toml_depth.h"
#include "backend/core/unit_names.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <toml++/toml.h>

#include <algorithm>

namespace teleta::core {

namespace {

struct TomlReader {
    Q_DECLARE_TR_FUNCTIONS(TomlReader)
};

QString asQString(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

template <typename Names>
QString oneOf(const Names& names) {
    QStringList list;
    for (const auto& name : names)
        list << asQString(name);
    return TomlReader::tr("one of: %1").arg(list.join(QStringLiteral(", ")));
}

} // namespace

struct TomlDocument::Data {
    std::string file;
    toml::table root;
    std::optional<Error> error;

    SourcePlace placeOf(const toml::source_region& region) const {
        return {file, static_cast<long long>(region.begin.line), static_cast<long long>(region.begin.column)};
    }

    void report(SourcePlace where, const QString& message, const QString& expected) {
        if (!error)
            error =
                Error{ErrorKind::badInput, message.toStdString(), expected.toStdString(), std::move(where)};
    }
};

struct TomlTable::Data {
    std::shared_ptr<TomlDocument::Data> document;
    const toml::table* table = nullptr; ///< null: missing, already reported
    SourcePlace place;
    std::vector<std::string> asked;
    std::vector<std::string> missing;

    /// The node under a key, also under one whose unit is in lower case ("rate_hz" for "rate_Hz").
    const toml::node* at(std::string_view key) const {
        if (table == nullptr)
            return nullptr;
        const toml::node* node = table->get(key);
        return node != nullptr ? node : table->get(lowerCaseUnit(key));
    }

    /// Whether somebody asked for a key of the file. One beside its twin with another letter case is not
    /// known.
    bool knows(std::string_view key) const {
        return std::ranges::any_of(asked, [&](const std::string& name) {
            return name == key || (lowerCaseUnit(name) == key && table->get(name) == nullptr);
        });
    }

    /// The node under a key; null when there is none, which is an error if it is required.
    const toml::node* find(std::string_view key, bool required) {
        if (std::ranges::find(asked, key) == asked.end())
            asked.emplace_back(key);
        const toml::node* node = at(key);
        if (required && node == nullptr && table != nullptr)
            missing.emplace_back(key);
        return node;
    }

    void wrongType(std::string_view key, const toml::node& node, const QString& expected) {
        document->report(document->placeOf(node.source()),
                         TomlReader::tr("wrong type for \"%1\"").arg(asQString(key)), expected);
    }

    void outOfRange(std::string_view key, const toml::node& node, const QString& value,
                    const QString& expected) {
        document->report(document->placeOf(node.source()),
                         TomlReader::tr("\"%1\" is out of range: %2").arg(asQString(key), value), expected);
    }

    std::string text(std::string_view key, const toml::node& node) {
        const auto value = node.value_exact<std::string>();
        if (!value)
            wrongType(key, node, TomlReader::tr("a text in quotes"));
        else if (value->empty())
            document->report(document->placeOf(node.source()),
                             TomlReader::tr("\"%1\" is empty").arg(asQString(key)),
                             TomlReader::tr("a text in quotes"));
        return value.value_or(std::string());
    }

    double number(std::string_view key, const toml::node& node, const NumberRange& range) {
        if (!node.is_number()) {
            wrongType(key, node, QString::fromStdString(range.text()));
            return 0.0;
        }
        const double value = node.value<double>().value_or(0.0);
        if (!range.accepts(value))
            outOfRange(key, node, QString::number(value, 'g', 12), QString::fromStdString(range.text()));
        return value;
    }

    long long integer(std::string_view key, const toml::node& node, long long low, long long high) {
        const QString expected = QString::fromStdString(WholeRange{low, high}.text());
        const auto value = node.value_exact<std::int64_t>();
        if (!value) {
            wrongType(key, node, expected);
            return low;
        }
        if (*value < low || *value > high) {
            outOfRange(key, node, QString::number(*value), expected);
            return low;
        }
        return *value;
    }

    void reportUnknown(std::string_view key, const SourcePlace& where) {
        const auto twin =
            std::ranges::find_if(asked, [&](const std::string& name) { return lowerCaseUnit(name) == key; });
        if (twin != asked.end()) {
            document->report(
                where,
                TomlReader::tr("\"%1\" and \"%2\" are the same key").arg(asQString(key), asQString(*twin)),
                TomlReader::tr("one of them"));
            return;
        }
        const KeyMatch match = matchKey(key, asked);
        const QString meant = asQString(match.name);
        switch (match.kind) {
        case KeyMatch::Kind::unitMissing:
            document->report(where, TomlReader::tr("\"%1\" has no unit in its name").arg(asQString(key)),
                             meant);
            return;
        case KeyMatch::Kind::otherUnit:
            document->report(where, TomlReader::tr("\"%1\" has another unit in its name").arg(asQString(key)),
                             meant);
            return;
        case KeyMatch::Kind::similar:
            document->report(
                where,
                TomlReader::tr("unknown key \"%1\"; perhaps \"%2\" is meant").arg(asQString(key), meant),
                oneOf(asked));
            return;
        case KeyMatch::Kind::none:
            document->report(where, TomlReader::tr("unknown key \"%1\"").arg(asQString(key)), oneOf(asked));
            return;
        }
    }
};

Expected<TomlDocument> TomlDocument::open(const std::string& path) {
    TELETA_TRY(const std::string text, readFile(path, kMostTomlBytes));
    return parse(text, path);
}

Expected<TomlDocument> TomlDocument::parse(std::string_view text, const std::string& file) {
    auto data = std::make_shared<Data>();
    data->file = file;
    if (text.size() > kMostTomlBytes)
        return failed(ErrorKind::badInput, TomlReader::tr("the file is too large"),
                      TomlReader::tr("at most %1 MiB").arg(kMostTomlBytes >> 20U), {file});
    if (const std::optional<TextPlace> place = tomlDeeperThan(text, kDeepestToml))
        return failed(ErrorKind::badInput, TomlReader::tr("the keys are nested too deeply"),
                      TomlReader::tr("at most %1 levels").arg(kDeepestToml),
                      {file, place->line, place->column});
    try {
        data->root = toml::parse(text);
    } catch (const toml::parse_error& error) {
        return failed(ErrorKind::badInput,
                      TomlReader::tr("not valid TOML: %1").arg(asQString(error.description())), {},
                      data->placeOf(error.source()));
    }
    return TomlDocument(std::move(data));
}

TomlTable TomlDocument::root() const {
    auto data = std::make_shared<TomlTable::Data>();
    data->document = m_data;
    data->table = &m_data->root;
    data->place = {m_data->file};
    return TomlTable(std::move(data));
}

const std::optional<Error>& TomlDocument::firstError() const {
    return m_data->error;
}

bool TomlTable::has(std::string_view key) {
    return m_data->find(key, false) != nullptr;
}

std::string TomlTable::text(std::string_view key, const std::optional<std::string>& fallback) {
    const toml::node* node = m_data->find(key, !fallback);
    return node != nullptr ? m_data->text(key, *node) : fallback.value_or(std::string());
}

double TomlTable::number(std::string_view key, const NumberRange& range, std::optional<double> fallback) {
    const toml::node* node = m_data->find(key, !fallback);
    return node != nullptr ? m_data->number(key, *node, range) : fallback.value_or(0.0);
}

long long TomlTable::integer(std::string_view key, long long low, long long high,
                             std::optional<long long> fallback) {
    const toml::node* node = m_data->find(key, !fallback);
    return node != nullptr ? m_data->integer(key, *node, low, high) : fallback.value_or(low);
}

std::vector<double> TomlTable::numberList(std::string_view key, const NumberRange& range,
                                          const WholeRange& count) {
    const toml::node* node = m_data->find(key, true);
    if (node == nullptr)
        return {};
    // Where a list may have one number or several, one may stand without brackets.
    if (node->is_number() && count.low == 1 && count.high > 1)
        return {m_data->number(key, *node, range)};
    const toml::array* array = node->as_array();
    if (array == nullptr || !count.accepts(static_cast<long long>(array->size()))) {
        m_data->wrongType(key, *node, QString::fromStdString(listText(range, count)));
        return {};
    }
    std::vector<double> values;
    for (const toml::node& entry : *array)
        values.push_back(m_data->number(key, entry, range));
    return values;
}

std::vector<std::vector<double>> TomlTable::numberRows(std::string_view key, const NumberRange& range,
                                                       std::size_t rows, std::size_t perRow) {
    const toml::node* node = m_data->find(key, true);
    if (node == nullptr)
        return {};
    const auto isRow = [perRow](const toml::node& row) {
        return row.is_array() && row.as_array()->size() == perRow;
    };
    const toml::array* array = node->as_array();
    if (array == nullptr || array->empty() || (rows > 0 && array->size() != rows) ||
        !std::ranges::all_of(*array, isRow)) {
        m_data->wrongType(key, *node,
                          rows > 0
                              ? TomlReader::tr("a list of %1 lists, each of %2 numbers").arg(rows).arg(perRow)
                              : TomlReader::tr("a list of lists, each of %1 numbers").arg(perRow));
        return {};
    }
    std::vector<std::vector<double>> values;
    for (const toml::node& row : *array) {
        values.emplace_back();
        for (const toml::node& entry : *row.as_array())
            values.back().push_back(m_data->number(key, entry, range));
    }
    return values;
}

std::vector<std::string> TomlTable::textList(std::string_view key) {
    const toml::node* node = m_data->find(key, false);
    if (node == nullptr)
        return {};
    const toml::array* array = node->as_array();
    if (array == nullptr) {
        m_data->wrongType(key, *node, TomlReader::tr("a list of texts in quotes"));
        return {};
    }
    std::vector<std::string> texts;
    for (const toml::node& entry : *array)
        texts.push_back(m_data->text(key, entry));
    return texts;
}

std::vector<TomlValue> TomlTable::valueList(std::string_view key) {
    const toml::node* node = m_data->find(key, true);
    if (node == nullptr)
        return {};
    const toml::array* array = node->as_array();
    if (array == nullptr || array->empty()) {
        m_data->wrongType(key, *node, TomlReader::tr("a list of one or more values"));
        return {};
    }
    std::vector<TomlValue> values;
    for (const toml::node& entry : *array) {
        if (const auto flag = entry.value_exact<bool>())
            values.emplace_back(*flag);
        else if (const auto whole = entry.value_exact<std::int64_t>())
            values.emplace_back(static_cast<long long>(*whole));
        else if (const auto number = entry.value_exact<double>())
            values.emplace_back(*number);
        else if (const auto text = entry.value_exact<std::string>())
            values.emplace_back(*text);
        else
            m_data->wrongType(key, entry, TomlReader::tr("a number, a text in quotes, or true or false"));
    }
    return values;
}

bool TomlTable::isTable(std::string_view key) const {
    const toml::node* node = m_data->at(key);
    return node != nullptr && node->is_table();
}

bool TomlTable::boolean(std::string_view key, bool fallback) {
    const toml::node* node = m_data->find(key, false);
    if (node == nullptr)
        return fallback;
    const auto value = node->value_exact<bool>();
    if (!value)
        m_data->wrongType(key, *node, TomlReader::tr("true or false"));
    return value.value_or(fallback);
}

std::size_t TomlTable::choice(std::string_view key, const std::vector<std::string_view>& names) {
    const toml::node* node = m_data->find(key, true);
    if (node == nullptr)
        return 0;
    const auto value = node->value_exact<std::string>();
    if (!value) {
        m_data->wrongType(key, *node, oneOf(names));
        return 0;
    }
    const auto found = std::ranges::find(names, *value);
    if (found != names.end())
        return static_cast<std::size_t>(found - names.begin());
    const std::string_view similar = nearestName(*value, names);
    m_data->document->report(
        m_data->document->placeOf(node->source()),
        similar.empty()
            ? TomlReader::tr("unknown value \"%1\" of \"%2\"").arg(asQString(*value), asQString(key))
            : TomlReader::tr("unknown value \"%1\" of \"%2\"; perhaps \"%3\" is meant")
                  .arg(asQString(*value), asQString(key), asQString(similar)),
        oneOf(names));
    return 0;
}

TomlTable TomlTable::table(std::string_view key) {
    auto data = std::make_shared<Data>();
    data->document = m_data->document;
    if (const toml::node* node = m_data->find(key, true)) {
        data->place = m_data->document->placeOf(node->source());
        data->table = node->as_table();
        if (data->table == nullptr)
            m_data->wrongType(key, *node, TomlReader::tr("a table: [%1]").arg(asQString(key)));
    }
    return TomlTable(std::move(data));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key, std::size_t minimum) {
    const toml::node* node = m_data->find(key, minimum > 0);
    if (node == nullptr)
        return {};
    const toml::array* array = node->as_array();
    const bool wellTyped = array != nullptr && std::ranges::all_of(*array, [](const toml::node& entry) {
                               return entry.is_table();
                           });
    if (!wellTyped) {
        m_data->wrongType(key, *node, TomlReader::tr("tables: [[%1]] or %1 = [{...}]").arg(asQString(key)));
        return {};
    }
    if (array->size() < minimum) {
        m_data->document->report(m_data->document->placeOf(node->source()),
                                 TomlReader::tr("\"%1\" has too few entries").arg(asQString(key)),
                                 TomlReader::tr("at least %1").arg(minimum));
        return {};
    }
    std::vector<TomlTable> result;
    for (const toml::node& entry : *array) {
        auto data = std::make_shared<Data>();
        data->document = m_data->document;
        data->place = m_data->document->placeOf(entry.source());
        data->table = entry.as_table();
        result.push_back(TomlTable(std::move(data)));
    }
    return result;
}

std::vector<std::string> TomlTable::keys() const {
    std::vector<const toml::key*> found;
    if (m_data->table != nullptr) {
        for (auto&& [key, node] : *m_data->table)
            found.push_back(&key);
    }
    std::ranges::sort(found, {}, [](const toml::key* key) {
        return std::pair(key->source().begin.line, key->source().begin.column);
    });
    std::vector<std::string> names;
    for (const toml::key* key : found)
        names.emplace_back(key->str());
    return names;
}

SourcePlace TomlTable::place() const {
    return m_data->place;
}

SourcePlace TomlTable::place(std::string_view key) const {
    const toml::node* node = m_data->at(key);
    return node != nullptr ? m_data->document->placeOf(node->source()) : m_data->place;
}

void TomlTable::fail(std::string_view key, std::string message, std::string expected) {
    // That a table is missing says it all.
    if (!m_data->document->error && m_data->table != nullptr)
        m_data->document->error =
            Error{ErrorKind::badInput, std::move(message), std::move(expected), place(key)};
}

void TomlTable::finish() {
    if (m_data->table == nullptr)
        return;
    const toml::key* unknown = nullptr;
    for (auto&& [key, node] : *m_data->table) {
        if (!m_data->knows(key.str()) && (unknown == nullptr || key.source().begin < unknown->source().begin))
            unknown = &key;
    }
    // A misspelt key leaves the right one missing: the misspelling is what helps.
    if (unknown != nullptr)
        m_data->reportUnknown(unknown->str(), m_data->document->placeOf(unknown->source()));
    else if (!m_data->missing.empty())
        m_data->document->report(
            m_data->place, TomlReader::tr("\"%1\" is missing").arg(asQString(m_data->missing.front())), {});
}

} // namespace teleta::core
