// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/keys/key_lists.h"
#include "backend/core/keys/keys.h"
#include "backend/core/keys/toml_table.h"

namespace teleta::core {

/// Reads the described keys from a table of a TOML document, which keeps the first error.
class TomlKeys : public Keys, public KeyLists {
public:
    /// When the tables in the table are read.
    enum class Nested {
        atOnce,
        /// In finish(), after the table itself was checked for unknown keys: a misspelt table is then the
        /// error to show, not what its absence brings about.
        afterwards,
    };
    explicit TomlKeys(TomlTable table, Nested nested = Nested::atOnce);

    /// Reports unknown and missing keys. Call it after the last key has been described.
    void finish();

    using Keys::number;
    void number(std::string_view key, double& value, const NumberRange& range, std::string_view about,
                Need need) override;
    void numbers(std::string_view key, std::span<const std::string_view> names, std::span<double> values,
                 const NumberRange& range, std::string_view about, Need need) override;
    void list(std::string_view key, std::vector<double>& values, const NumberRange& range,
              const WholeRange& count, std::string_view about, Need need) override;
    void rows(std::string_view key, std::vector<std::vector<double>>& values, const NumberRange& range,
              std::size_t count, std::size_t perRow, std::string_view about, Need need) override;
    void texts(std::string_view key, std::vector<std::string>& values, std::string_view about,
               Need need) override;
    void flag(std::string_view key, bool& value, std::string_view about) override;
    void text(std::string_view key, std::string& value, std::string_view about, Need need) override;
    void choose(std::string_view key, std::size_t value, const KeyNames& names, std::string_view about,
                Need need, const DescribeAt& describe) override;
    using Keys::table;
    void table(std::string_view key, std::string_view about, Need need, const Describe& describe) override;
    void oneOf(std::string_view first, std::string_view second, const std::string& message,
               const std::string& expected) override;
    void refuse(std::string_view key, const std::string& message, const std::string& expected) override;

protected:
    void wholeNumber(std::string_view key, long long& value, const WholeRange& range, std::string_view about,
                     Need need) override;
    void tableList(std::string_view key, std::size_t minimum, std::string_view about, std::size_t count,
                   const std::function<void(std::size_t)>& resize, const DescribeAt& describe) override;
    bool isThere(std::string_view key, bool known) override;

private:
    void readNow(const std::function<void()>& read);

    TomlTable m_table;
    Nested m_nested;
    /// What waits for finish(): tables that are read afterwards, and refusals, since a missing value makes
    /// others look wrong.
    std::vector<std::function<void()>> m_atEnd;
};

/// Reads a value from the root of a document by the keys that it describes.
/// Error: badInput, the first one in the file's order of reading.
template <typename T>
[[nodiscard]] Expected<T> readKeys(const TomlDocument& document) {
    T value;
    TomlKeys keys(document.root());
    value.describeKeys(keys);
    keys.finish();
    if (document.firstError())
        return Unexpected(*document.firstError());
    return value;
}

} // namespace teleta::core
