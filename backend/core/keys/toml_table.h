// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/keys/keys.h"
#include "backend/core/keys/toml_value.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::core {

class TomlTable;

/// A parsed TOML file and the first thing that is wrong with it. Reads through its tables never fail on the
/// spot: a value that is missing or wrong yields a stand-in and the document keeps the error, so that a
/// reader is a plain list of fields which asks firstError() once at its end.
/// Thread: one.
class TomlDocument {
public:
    /// Error: notFound, ioFailed, or badInput with the place of the syntax error.
    [[nodiscard]] static Expected<TomlDocument> open(const std::string& path);
    [[nodiscard]] static Expected<TomlDocument> parse(std::string_view text, const std::string& file);

    [[nodiscard]] TomlTable root() const;
    [[nodiscard]] const std::optional<Error>& firstError() const;

private:
    friend class TomlTable;
    struct Data;
    explicit TomlDocument(std::shared_ptr<Data> data)
        : m_data(std::move(data)) {}

    std::shared_ptr<Data> m_data;
};

/// One table of a document, read key by key. It remembers which keys were asked for; finish() reports the
/// others. A key whose name lacks its unit, or has another one, is told apart from an unknown one, and a near
/// miss is named.
/// Thread: one.
class TomlTable {
public:
    /// True when the key is there; counts as asked for.
    [[nodiscard]] bool has(std::string_view key);

    // A key without a fallback must be there.

    /// Text that is not empty.
    [[nodiscard]] std::string text(std::string_view key, const std::optional<std::string>& fallback = {});
    /// A number, whole or not.
    [[nodiscard]] double number(std::string_view key, const NumberRange& range,
                                std::optional<double> fallback = {});
    /// A whole number, low .. high inclusive.
    [[nodiscard]] long long integer(std::string_view key, long long low, long long high,
                                    std::optional<long long> fallback = {});
    /// A list of numbers, key = [1, 2]; of wrong numbers the place is that of the first wrong one. Must be
    /// there.
    [[nodiscard]] std::vector<double> numberList(std::string_view key, const NumberRange& range,
                                                 const WholeRange& count);
    /// A list of such lists, each of perRow numbers: key = [[1, 2], [3, 4]]. rows 0: as many as
    /// there are, at least one. Must be there.
    [[nodiscard]] std::vector<std::vector<double>> numberRows(std::string_view key, const NumberRange& range,
                                                              std::size_t rows, std::size_t perRow);
    /// A list of texts that are not empty, key = ["a", "b"]; empty when the key is missing.
    [[nodiscard]] std::vector<std::string> textList(std::string_view key);
    /// A list of one or more single values, key = [1, 2.5, "a", true]. Must be there.
    [[nodiscard]] std::vector<TomlValue> valueList(std::string_view key);
    [[nodiscard]] bool boolean(std::string_view key, bool fallback);
    /// True when the key is there and is a table; does not count as asked for.
    [[nodiscard]] bool isTable(std::string_view key) const;

    /// Index of the text among the allowed names; 0 when it is wrong.
    [[nodiscard]] std::size_t choice(std::string_view key, const std::vector<std::string_view>& names);

    /// A table. One that is missing is an error and reads as stand-ins without further errors.
    [[nodiscard]] TomlTable table(std::string_view key);

    /// An array of tables, [[key]] or key = [{...}], with at least so many.
    [[nodiscard]] std::vector<TomlTable> tables(std::string_view key, std::size_t minimum);

    /// The keys of the table, in the order of the file: for a table whose keys are names that the user
    /// chooses. They do not count as asked for.
    [[nodiscard]] std::vector<std::string> keys() const;

    /// Place of the table, and of a key's value in it (the table's when the key is missing).
    [[nodiscard]] SourcePlace place() const;
    [[nodiscard]] SourcePlace place(std::string_view key) const;

    /// Reports what only the caller can see to be wrong with a value.
    void fail(std::string_view key, std::string message, std::string expected);

    /// Reports keys that nobody asked for, then those that are missing. Call it after the last key was asked
    /// for.
    void finish();

private:
    friend class TomlDocument;
    struct Data;
    explicit TomlTable(std::shared_ptr<Data> data)
        : m_data(std::move(data)) {}

    std::shared_ptr<Data> m_data;
};

} // namespace teleta::core
