// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QString>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace teleta::core {

/// A JSON text, read with limits, that knows the line and column of each value.
/// Thread: one.
class JsonDocument {
public:
    static constexpr std::size_t kMostBytes = 64U << 20U;
    static constexpr int kDeepest = 64;

    /// file: for errors. Error: badInput with line and column: not JSON, not UTF-8, nested deeper than
    /// kDeepest, a number out of range, a key that is there twice; without them: longer than kMostBytes.
    [[nodiscard]] static Expected<JsonDocument> parse(std::string text, const std::string& file);

    [[nodiscard]] const nlohmann::ordered_json& root() const { return *m_root; }

    /// An error about a value of this document: with its path (tracks/2/0), line and column.
    [[nodiscard]] Error errorAt(const nlohmann::ordered_json& value, const QString& message,
                                const QString& expected) const;

private:
    JsonDocument() = default;

    std::string m_file;
    std::string m_text;
    std::unique_ptr<nlohmann::ordered_json> m_root; ///< keeps its address when the document is moved
};

/// A value as the text of a file: indented by 2, invalid UTF-8 replaced, a line feed at the end. Thread: any
/// (pure).
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& value);

/// Reads the values of a document one by one. The first error is kept in error(); from then on all results
/// are harmless defaults, so that a reader needs to check error() only once, at its end.
class JsonReader {
public:
    explicit JsonReader(const JsonDocument& document)
        : m_document(document) {}

    using Value = const nlohmann::ordered_json&;

    [[nodiscard]] Value root() const { return m_document.root(); }
    /// A member that must be there.
    [[nodiscard]] Value member(Value object, const char* key);
    /// nullptr when the object has no such member.
    [[nodiscard]] const nlohmann::ordered_json* find(Value object, const char* key);
    /// The value when it is an array of so many elements, otherwise an empty array.
    [[nodiscard]] Value array(Value value, std::size_t atLeast, std::size_t atMost);

    [[nodiscard]] double number(Value value, double lower, double upper);
    [[nodiscard]] double number(Value object, const char* key, double lower, double upper, double missing);
    [[nodiscard]] long long integer(Value value, long long lower, long long upper);
    [[nodiscard]] bool boolean(Value object, const char* key, bool missing);
    [[nodiscard]] std::string text(Value value);
    [[nodiscard]] std::string text(Value object, const char* key, const std::string& missing);

    /// Keeps the first error.
    void fail(Value value, const QString& message, const QString& expected);
    [[nodiscard]] const std::optional<Error>& error() const { return m_error; }

private:
    const JsonDocument& m_document;
    std::optional<Error> m_error;
};

} // namespace teleta::core
