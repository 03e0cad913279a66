// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/keys/key_lists.h"
#include "backend/core/keys/keys.h"

namespace teleta::core {

/// Checks values against what their keys accept. A program's own value may leave out what only a file has to
/// give: texts, and the tables at the top level.
class KeyCheck : public Keys, public KeyLists {
public:
    explicit KeyCheck(std::string path = {})
        : m_path(std::move(path)) {}

    [[nodiscard]] const std::optional<Error>& firstError() const { return m_error; }

    using Keys::number;
    void number(std::string_view key, double& value, const NumberRange& range, std::string_view about,
                Need need) override;
    void numbers(std::string_view key, std::span<const std::string_view> names, std::span<double> values,
                 const NumberRange& range, std::string_view about, Need need) override;
    void list(std::string_view key, std::vector<double>& values, const NumberRange& range,
              const WholeRange& count, std::string_view about, Need need) override;
    void rows(std::string_view key, std::vector<std::vector<double>>& values, const NumberRange& range,
              std::size_t count, std::size_t perRow, std::string_view about, Need need) override;
    void texts(std::string_view, std::vector<std::string>&, std::string_view, Need) override {}
    void flag(std::string_view, bool&, std::string_view) override {}
    void text(std::string_view, std::string&, std::string_view, Need) override {}
    void choose(std::string_view key, std::size_t value, const KeyNames& names, std::string_view about,
                Need need, const DescribeAt& describe) override;
    using Keys::table;
    void table(std::string_view key, std::string_view about, Need need, const Describe& describe) override;
    void oneOf(std::string_view, std::string_view, const std::string&, const std::string&) override {}
    void refuse(std::string_view key, const std::string& message, const std::string& expected) override;

protected:
    void wholeNumber(std::string_view key, long long& value, const WholeRange& range, std::string_view about,
                     Need need) override;
    void tableList(std::string_view key, std::size_t minimum, std::string_view about, std::size_t count,
                   const std::function<void(std::size_t)>& resize, const DescribeAt& describe) override;
    bool isThere(std::string_view, bool known) override { return known; }

private:
    [[nodiscard]] std::string pathOf(std::string_view key) const;
    void outOfRange(std::string_view key, double value, const std::string& expected);
    void inTable(const std::string& path, const Describe& describe);

    std::string m_path;
    std::optional<Error> m_error;
};

/// Error: badInput for the first value that its key does not accept; without a place, the key's path in the
/// message. Thread: any (pure).
template <typename T>
[[nodiscard]] Expected<void> checkKeys(T value) {
    KeyCheck check;
    value.describeKeys(check);
    if (check.firstError())
        return Unexpected(*check.firstError());
    return {};
}

} // namespace teleta::core
