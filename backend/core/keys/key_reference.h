// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/keys/key_lists.h"
#include "backend/core/keys/keys.h"

#include <memory>

namespace teleta::core {

/// The words of a reference's tables, in its reader's language.
struct ReferenceWords {
    std::string key = "Key";
    std::string unit = "Unit";
    std::string accepts = "Accepts";
    std::string fallback = "Without it";
    std::string meaning = "Meaning";
    std::string required = "required";
    std::string number = "a number";
    std::string whole = "whole";
    std::string text = "text";
    std::string table = "a table";
    std::string tables = "tables";
    std::string list = "list";
};

/// A table of a file as a page shows it.
struct ReferenceTable {
    struct Row {
        std::string key;
        std::string unit; ///< from the key's name
        std::string accepts;
        std::string fallback;
        std::string meaning;
        std::string when; ///< choices with which alone the key is there; empty: always
    };
    std::string path; ///< "[sensor]", "[[indenter.keyframes]]"; empty: the top of the file
    std::vector<Row> rows;
};

/// Collects the keys of values and, as defaults, what these values hold: each table with its rows, followed
/// by the tables in it.
class KeyReference : public Keys, public KeyLists {
public:
    explicit KeyReference(ReferenceWords words = {});

    [[nodiscard]] const std::vector<ReferenceTable>& tables() const { return *m_tables; }
    /// The tables as Markdown, each under a heading of that level.
    [[nodiscard]] std::string markdown(int level) const;

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
    void oneOf(std::string_view, std::string_view, const std::string&, const std::string&) override {}
    void refuse(std::string_view, const std::string&, const std::string&) override {}

protected:
    void wholeNumber(std::string_view key, long long& value, const WholeRange& range, std::string_view about,
                     Need need) override;
    void tableList(std::string_view key, std::size_t minimum, std::string_view about, std::size_t count,
                   const std::function<void(std::size_t)>& resize, const DescribeAt& describe) override;
    bool isThere(std::string_view, bool) override { return m_unset = true; }

private:
    KeyReference(const KeyReference& parent, const std::string& path, bool list);
    void add(std::string_view key, std::string accepts, Need need, std::string fallback,
             std::string_view about);

    void addTable(std::string_view key, const std::string& accepts, Need need, std::string_view about,
                  bool list, const Describe& describe);

    std::shared_ptr<std::vector<ReferenceTable>> m_tables;
    ReferenceWords m_words;
    std::string m_path; ///< "indenter.keyframes"
    std::size_t m_table = 0;
    std::string m_when;
    bool m_unset = false; ///< the next key has no stand-in
};

} // namespace teleta::core
