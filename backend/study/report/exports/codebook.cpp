// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/exports/codebook.h"

#include "backend/study/protocol/standard_questionnaire.h"
#include "backend/study/report/exports/export_parts.h"

#include <algorithm>
#include <array>

namespace teleta::study {

namespace {

using nlohmann::ordered_json;

/// "word: meaning; word: meaning" as {word: meaning}; a word without a meaning means itself.
ordered_json levelsOf(const std::string& levels) {
    ordered_json made = ordered_json::object();
    std::size_t begin = 0;
    while (begin < levels.size()) {
        const std::size_t end = std::min(levels.find("; ", begin), levels.size());
        const std::string level = levels.substr(begin, end - begin);
        const std::size_t colon = level.find(": ");
        made[level.substr(0, colon)] = colon == std::string::npos ? level : level.substr(colon + 2);
        begin = end + 2;
    }
    return made;
}

/// Levels of an item: its choices, or the ends of its scale.
std::string itemLevels(const QuestionnaireItem& item) {
    // A semicolon stands between levels.
    const auto word = [](std::string text) {
        std::ranges::replace(text, ';', ',');
        return text;
    };
    std::string levels;
    const auto add = [&](const std::string& value, const std::string& meaning) {
        levels += (levels.empty() ? "" : "; ") + value + (meaning.empty() ? "" : ": " + word(meaning));
    };
    if (item.kind == ItemKind::choice || item.kind == ItemKind::pair) {
        for (const ItemChoice& choice : item.choices)
            add(choice.id, choice.text);
    } else if (item.kind == ItemKind::likert) {
        add("1", item.low);
        add(std::to_string(item.points), item.high);
    } else if (item.kind == ItemKind::scale) {
        add("0", item.low);
        add("100", item.high);
    }
    return levels;
}

} // namespace

const std::vector<CodebookEntry>& codebook() {
    static const std::vector<CodebookEntry> kEntries = [] {
        std::vector<CodebookEntry> entries;
        for (const std::span<const CodebookFile> files :
             {codebookOfExports(), codebookOfResults(), codebookOfMethods()}) {
            for (const CodebookFile& file : files) {
                for (const CodebookRow& row : file.rows)
                    entries.push_back(
                        {file.file, row.column, row.description, row.unit, row.levels, row.missing});
            }
        }
        return entries;
    }();
    return kEntries;
}

std::vector<CodebookEntry> questionnaireEntries(const Questionnaire& questionnaire) {
    std::vector<CodebookEntry> entries;
    for (const QuestionnaireItem& item : questionnaire.items)
        entries.push_back({"phenotype", item.id, questionnaire.id + ": " + item.question, "",
                           itemLevels(item), "left out"});
    for (const QuestionnaireScore& score : questionnaireScores(questionnaire, {}))
        entries.push_back({"phenotype", score.name, questionnaire.id + ": " + scoreMeaning(score.name), "",
                           "", "an item that it needs was left out"});
    return entries;
}

std::string codebookPage() {
    const auto safe = [](std::string text) {
        for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
            text.insert(at, 1, '\\');
        return text;
    };
    std::string page;
    const std::string* file = nullptr;
    for (const CodebookEntry& entry : codebook()) {
        if (file == nullptr || *file != entry.file) {
            file = &entry.file;
            page += "\n## " + entry.file +
                    "\n\n| column | description | unit | levels | NA |\n|---|---|---|---|---|\n";
        }
        page += "| `" + entry.column + "` | " + safe(entry.description) + " | " + safe(entry.unit) + " | " +
                safe(entry.levels) + " | " + safe(entry.missing) + " |\n";
    }
    return page;
}

const CodebookEntry* findEntry(std::string_view file, std::string_view column) {
    const auto found = std::ranges::find_if(
        codebook(), [&](const CodebookEntry& entry) { return entry.file == file && entry.column == column; });
    return found == codebook().end() ? nullptr : &*found;
}

std::vector<CodebookEntry> codebookOf(const Protocol* protocol) {
    std::vector<CodebookEntry> entries = codebook();
    if (protocol == nullptr)
        return entries;
    for (const Questionnaire& questionnaire : protocol->questionnaires) {
        for (CodebookEntry& entry : questionnaireEntries(questionnaire))
            entries.push_back(std::move(entry));
    }
    return entries;
}

std::string codebookText(const std::vector<CodebookEntry>& entries) {
    static constexpr std::array<std::string_view, 6> kColumns{"file", "column", "description",
                                                              "unit", "levels", "missing"};
    std::vector<TrialRow> rows;
    for (const CodebookEntry& entry : entries)
        rows.push_back({wordCell(entry.file), wordCell(entry.column), wordCell(entry.description),
                        wordCell(entry.unit), wordCell(entry.levels), wordCell(entry.missing)});
    return tableText(rows, {}, kColumns);
}

ordered_json psychDsVariables(std::string_view file, std::span<const std::string_view> columns) {
    ordered_json variables = ordered_json::array();
    for (const std::string_view column : columns) {
        ordered_json variable{{"@type", "PropertyValue"}, {"name", column}};
        if (const CodebookEntry* entry = findEntry(file, column)) {
            variable["description"] = entry->description;
            if (!entry->unit.empty())
                variable["unitText"] = entry->unit;
            if (!entry->levels.empty())
                variable["levels"] = levelsOf(entry->levels);
        }
        variables.push_back(std::move(variable));
    }
    return variables;
}

ordered_json bidsColumn(const CodebookEntry& entry) {
    ordered_json column{{"Description", entry.description}};
    if (!entry.unit.empty())
        column["Units"] = entry.unit;
    if (!entry.levels.empty())
        column["Levels"] = levelsOf(entry.levels);
    return column;
}

ordered_json bidsColumns(std::string_view file, std::span<const std::string_view> columns) {
    ordered_json described = ordered_json::object();
    for (const std::string_view column : columns) {
        if (const CodebookEntry* entry = findEntry(file, column))
            described[std::string(column)] = bidsColumn(*entry);
    }
    return described;
}

} // namespace teleta::study
