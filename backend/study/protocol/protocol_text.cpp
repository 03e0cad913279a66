// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/protocol.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <utility>

namespace teleta::study {

namespace {

/// A TOML basic string.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (code < 0x20 || code == 0x7F) {
            std::array<char, 8> escape{};
            std::snprintf(escape.data(), escape.size(), "\\u%04X", static_cast<unsigned>(code));
            out += escape.data();
        } else {
            out += c;
        }
    }
    out += '"';
    return out;
}

std::string number(double value) {
    std::array<char, 32> digits{};
    const auto [end, code] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    std::string text(digits.data(), end);
    // A TOML float needs a decimal point or an exponent.
    if (text.find_first_of(".en") == std::string::npos)
        text.append(".0");
    return text;
}

/// Appends to the text.
class Lines {
public:
    Lines& head(const char* name) {
        m_text.append("\n").append(name).append("\n");
        return *this;
    }
    Lines& value(const char* key, const std::string& value) {
        m_text.append(key).append(" = ").append(value).append("\n");
        return *this;
    }
    Lines& text(const char* key, const std::string& value) { return this->value(key, quoted(value)); }
    Lines& count(const char* key, std::size_t value) { return this->value(key, std::to_string(value)); }
    Lines& truth(const char* key, bool value) { return this->value(key, value ? "true" : "false"); }
    /// An inline table of two strings, as a line of an array.
    Lines& pair(const char* key, const std::string& value, const char* otherKey,
                const std::string& otherValue) {
        m_text.append("    { ").append(key).append(" = ").append(quoted(value)).append(", ");
        m_text.append(otherKey).append(" = ").append(quoted(otherValue)).append(" },\n");
        return *this;
    }
    /// An inline table, as a line of an array.
    Lines& pattern(const StudyPattern& pattern) {
        if (pattern.files.empty())
            return pair("letter", pattern.letter, "name", pattern.name);
        m_text.append("    { letter = ").append(quoted(pattern.letter));
        m_text.append(", name = ").append(quoted(pattern.name)).append(", stimulus = {");
        const char* separator = " ";
        for (const auto& [condition, file] : pattern.files) {
            m_text.append(separator).append(condition).append(" = ").append(quoted(file));
            separator = ", ";
        }
        m_text.append(" } },\n");
        return *this;
    }
    Lines& raw(const char* text) {
        m_text.append(text);
        return *this;
    }
    [[nodiscard]] std::string take() { return std::move(m_text); }

private:
    std::string m_text;
};

void addPhase(Lines& lines, const char* head, const PhaseSettings& phase) {
    lines.head(head)
        .count("repetitions", phase.repetitions)
        .truth("feedback", phase.feedback)
        .truth("diagram", phase.diagram);
}

void addTask(Lines& lines, const StudyTask& task) {
    lines.head("[[task]]").text("id", task.id).text("name", task.name);
    std::string conditions;
    for (const std::string& condition : task.conditions) {
        conditions.append(conditions.empty() ? "[{ id = " : ", { id = ");
        conditions.append(quoted(condition)).append(" }");
    }
    conditions.append(conditions.empty() ? "[]" : "]");
    lines.value("condition", conditions).raw("pattern = [\n");
    for (const StudyPattern& pattern : task.patterns)
        lines.pattern(pattern);
    lines.raw("]\n");
}

void addItem(Lines& lines, const QuestionnaireItem& item) {
    lines.head("[[questionnaire.item]]")
        .text("id", item.id)
        .text("kind", toString(item.kind))
        .text("question", item.question)
        .truth("required", item.required);
    if (item.kind == ItemKind::likert) {
        lines.count("points", item.points);
        if (!item.low.empty())
            lines.text("low", item.low);
        if (!item.high.empty())
            lines.text("high", item.high);
    }
    if (item.kind == ItemKind::choice) {
        lines.raw("choice = [\n");
        for (const ItemChoice& choice : item.choices)
            lines.pair("id", choice.id, "text", choice.text);
        lines.raw("]\n");
    }
}

} // namespace

std::string protocolText(const Protocol& protocol) {
    Lines lines;
    lines.text("name", protocol.name)
        .text("description", protocol.description)
        .value("stimulus_s", number(protocol.stimulus_s))
        .value("response_limit_s", number(protocol.responseLimit_s))
        .text("response_window", protocol.window == ResponseWindow::fromOnset ? "from_onset" : "from_end")
        .count("replays", protocol.replays)
        .text("order", toString(protocol.order));
    addPhase(lines, "[practice]", protocol.practice);
    addPhase(lines, "[test]", protocol.test);
    if (protocol.rest.everyTrials > 0)
        lines.head("[pause]")
            .count("every_trials", protocol.rest.everyTrials)
            .value("at_least_s", number(protocol.rest.atLeast_s));
    lines.head("[masking_noise]").text("colour", protocol.noiseColour);
    if (protocol.noiseColour != "none")
        lines.value("level_dBA", number(protocol.noise_dBA));
    for (const StudyTask& task : protocol.tasks)
        addTask(lines, task);
    for (const Questionnaire& questionnaire : protocol.questionnaires) {
        lines.head("[[questionnaire]]")
            .text("id", questionnaire.id)
            .text("title", questionnaire.title)
            .text("when", toString(questionnaire.when));
        for (const QuestionnaireItem& item : questionnaire.items)
            addItem(lines, item);
    }
    return lines.take();
}

} // namespace teleta::study
