// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/toml_edit.h"

#include "backend/core/failure.h"
#include "backend/core/keys/toml_table.h"
#include "backend/core/number_text.h"

#include <QCoreApplication>
#include <QString>

#include <toml++/toml.h>

#include <charconv>
#include <optional>
#include <sstream>

namespace teleta::core {

namespace {

struct TomlEditText {
    Q_DECLARE_TR_FUNCTIONS(TomlEdit)
};

std::optional<std::size_t> wholeNumber(std::string_view text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

Unexpected noPlace(const std::string& path, const std::string& file, const QString& expected) {
    return failed(ErrorKind::badInput,
                  TomlEditText::tr("there is no place for the key \"%1\"").arg(QString::fromStdString(path)),
                  expected, {file});
}

/// The entry of a list of tables that a part of a path names; null: a number that is not there.
toml::table* entryOf(toml::array& list, const std::string& part) {
    if (const auto number = wholeNumber(part))
        return *number < list.size() ? list[*number].as_table() : nullptr;
    for (toml::node& entry : list)
        if (toml::table* table = entry.as_table();
            table != nullptr && table->at_path("name").value_exact<std::string>() == part)
            return table;
    list.push_back(toml::table{{"name", part}});
    return list.back().as_table();
}

Expected<void> setValue(toml::table& root, const std::string& path, const TomlValue& value,
                        const std::string& file) {
    toml::table* table = &root;
    std::size_t begin = 0;
    for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', begin)) {
        const std::string part = path.substr(begin, dot - begin);
        begin = dot + 1;
        toml::node* node = table->get(part);
        if (node == nullptr)
            node = &table->insert(part, toml::table{}).first->second;
        if (toml::array* list = node->as_array()) {
            const std::size_t next = path.find('.', begin);
            if (next == std::string::npos)
                return noPlace(path, file, TomlEditText::tr("the entry's number or name, and a key in it"));
            table = entryOf(*list, path.substr(begin, next - begin));
            begin = next + 1;
            if (table == nullptr)
                return noPlace(
                    path, file,
                    TomlEditText::tr("a number from 0 to %1").arg(static_cast<qint64>(list->size()) - 1));
        } else {
            table = node->as_table();
            if (table == nullptr)
                return noPlace(path, file, TomlEditText::tr("tables of the file, with dots between them"));
        }
    }
    const std::string key = path.substr(begin);
    if (key.empty())
        return noPlace(path, file, TomlEditText::tr("tables of the file, with dots between them"));
    std::visit(
        [&](const auto& plain) {
            if constexpr (std::is_same_v<std::decay_t<decltype(plain)>, long long>)
                table->insert_or_assign(key, static_cast<std::int64_t>(plain));
            else
                table->insert_or_assign(key, plain);
        },
        value);
    return {};
}

} // namespace

std::string plainText(const TomlValue& value) {
    if (const bool* flag = std::get_if<bool>(&value))
        return *flag ? "true" : "false";
    if (const long long* whole = std::get_if<long long>(&value))
        return std::to_string(*whole);
    if (const double* number = std::get_if<double>(&value))
        return std::string(NumberText(*number).view());
    return std::get<std::string>(value);
}

Expected<std::string> withTomlValues(std::string_view text, const std::string& file,
                                     std::span<const std::pair<std::string, TomlValue>> values) {
    TELETA_CHECK(TomlDocument::parse(text, file)); // says what is wrong with a text that cannot be parsed
    toml::table root = toml::parse(text);
    for (const auto& [path, value] : values)
        TELETA_CHECK(setValue(root, path, value, file));
    std::ostringstream edited;
    edited << toml::toml_formatter(root);
    return std::move(edited).str();
}

} // namespace teleta::core
