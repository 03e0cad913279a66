// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/keys/toml_string.h"
#include "backend/core/number_text.h"
#include "backend/study/protocol/protocol.h"

#include <utility>

namespace teleta::study {

namespace {

std::string number(double value) {
    std::string text(core::NumberText(value).view());
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
    Lines& text(const char* key, const std::string& value) {
        return this->value(key, core::quotedToml(value));
    }
    Lines& count(const char* key, std::size_t value) { return this->value(key, std::to_string(value)); }
    Lines& truth(const char* key, bool value) { return this->value(key, value ? "true" : "false"); }
    /// An inline table of two strings, as a line of an array.
    Lines& pair(const char* key, const std::string& value, const char* otherKey,
                const std::string& otherValue) {
        m_text.append("    { ").append(key).append(" = ").append(core::quotedToml(value)).append(", ");
        m_text.append(otherKey).append(" = ").append(core::quotedToml(otherValue)).append(" },\n");
        return *this;
    }
    /// An inline table, as a line of an array.
    Lines& pattern(const StudyPattern& pattern) {
        if (pattern.files.empty())
            return pair("letter", pattern.letter, "name", pattern.name);
        m_text.append("    { letter = ").append(core::quotedToml(pattern.letter));
        m_text.append(", name = ").append(core::quotedToml(pattern.name)).append(", stimulus = {");
        const char* separator = " ";
        for (const auto& [condition, file] : pattern.files) {
            m_text.append(separator).append(condition).append(" = ").append(core::quotedToml(file));
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

/// [{ name = "..." }, ..]
std::string authorList(const std::vector<std::string>& authors) {
    std::string list;
    for (const std::string& author : authors)
        list.append(list.empty() ? "[{ name = " : ", { name = ")
            .append(core::quotedToml(author))
            .append(" }");
    return list + ']';
}

void addPhase(Lines& lines, const char* head, const PhaseSettings& phase) {
    lines.head(head)
        .count("repetitions", phase.repetitions)
        .truth("feedback", phase.feedback)
        .truth("diagram", phase.diagram);
}

/// An inline table on one line, as TOML 1.0 wants it.
class InlineTable {
public:
    InlineTable& value(const char* key, const std::string& value) {
        m_text.append(m_text.empty() ? "{ " : ", ").append(key).append(" = ").append(value);
        return *this;
    }
    InlineTable& text(const char* key, const std::string& value) {
        return this->value(key, core::quotedToml(value));
    }
    InlineTable& number(const char* key, double value) { return this->value(key, study::number(value)); }
    InlineTable& count(const char* key, std::size_t value) { return this->value(key, std::to_string(value)); }
    InlineTable& numbers(const char* key, const std::vector<double>& values) {
        std::string list;
        for (const double value : values)
            list.append(list.empty() ? "[" : ", ").append(study::number(value));
        return this->value(key, list.empty() ? "[]" : list + ']');
    }
    /// Tactors count from 1 in files.
    InlineTable& tactors(const char* key, const std::vector<std::size_t>& tactors) {
        std::string list;
        for (const std::size_t tactor : tactors)
            list.append(list.empty() ? "[" : ", ").append(std::to_string(tactor + 1));
        return tactors.empty() ? *this : this->value(key, list + ']');
    }
    [[nodiscard]] std::string close() const { return m_text + " }"; }

private:
    std::string m_text;
};

std::string procedureText(const LevelTask& levels, Design design) {
    InlineTable table;
    table.text("kind", nameOf(levels.procedure));
    if (const auto* staircase = std::get_if<StaircaseSettings>(&levels.procedure))
        table.number("first", staircase->first)
            .count("down", staircase->down)
            .number("step_up", staircase->stepUp)
            .number("step_down", staircase->stepDown)
            .count("fast_reversals", staircase->fastReversals)
            .number("fast_factor", staircase->fastFactor)
            .count("reversals", staircase->reversals)
            .count("skip_reversals", staircase->skipReversals)
            .count("most_trials", staircase->mostTrials);
    if (const auto* bayes = std::get_if<BayesSettings>(&levels.procedure)) {
        table.text("function", toString(bayes->function))
            .numbers("slope", bayes->slope)
            .numbers("lapse", bayes->lapse);
        if (design == Design::yesNo)
            table.numbers("guess", bayes->guess);
        table.count("grid", bayes->grid);
        if (bayes->priorMean)
            table.number("prior_mean", *bayes->priorMean);
        if (bayes->priorSd)
            table.number("prior_sd", *bayes->priorSd);
        table.count("most_trials", bayes->mostTrials).count("least_trials", bayes->leastTrials);
        if (bayes->sdAtMost)
            table.number("sd_at_most", *bayes->sdAtMost);
    }
    return table.close();
}

void addLevels(Lines& lines, Design design, const LevelTask& levels) {
    lines.text("design", toString(design));
    if (!levels.question.empty())
        lines.text("question", levels.question);
    if (design == Design::interval)
        lines.count("intervals", levels.intervals);
    if (design == Design::yesNo)
        lines.value("catch_share", number(levels.catchShare));
    else
        lines.value("gap_s", number(levels.gap_s));
    lines.raw("track = [\n");
    for (const LevelTrack& track : levels.tracks)
        lines.raw(("    " +
                   InlineTable()
                       .text("id", track.id)
                       .tactors("tactors", track.tactors)
                       .tactors("reference_tactors", track.reference)
                       .close() +
                   ",\n")
                      .c_str());
    lines.raw("]\n").value(
        "stimulus", InlineTable().text("file", levels.file).text("vary", toString(levels.vary)).close());
    InlineTable level;
    level.text("scale", toString(levels.range.scale))
        .number("lowest", levels.range.lowest)
        .number("highest", levels.range.highest)
        .number("reference", levels.reference);
    if (!levels.values.empty())
        level.numbers("values", levels.values);
    if (levels.practiceLevel)
        level.number("practice", *levels.practiceLevel);
    lines.value("level", level.close()).value("procedure", procedureText(levels, design));
}

void addTask(Lines& lines, const StudyTask& task) {
    lines.head("[[task]]").text("id", task.id).text("name", task.name);
    std::string conditions;
    for (const std::string& condition : task.conditions) {
        InlineTable entry;
        entry.text("id", condition);
        if (const auto reference = task.references.find(condition); reference != task.references.end())
            entry.number("reference", reference->second);
        conditions.append(conditions.empty() ? "[" : ", ").append(entry.close());
    }
    conditions.append(conditions.empty() ? "[]" : "]");
    lines.value("condition", conditions);
    if (task.design != Design::identification)
        return addLevels(lines, task.design, task.levels);
    lines.raw("pattern = [\n");
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
    if (item.kind == ItemKind::likert)
        lines.count("points", item.points);
    if (item.kind == ItemKind::likert || item.kind == ItemKind::scale) {
        if (!item.low.empty())
            lines.text("low", item.low);
        if (!item.high.empty())
            lines.text("high", item.high);
    }
    if (item.kind == ItemKind::choice || item.kind == ItemKind::pair) {
        lines.raw("choice = [\n");
        for (const ItemChoice& choice : item.choices)
            lines.pair("id", choice.id, "text", choice.text);
        lines.raw("]\n");
    }
}

void addQuestionnaire(Lines& lines, const Questionnaire& questionnaire) {
    lines.head("[[questionnaire]]").text("id", questionnaire.id);
    if (questionnaire.use != StandardQuestionnaire::none) {
        const bool required = questionnaire.items.empty() || questionnaire.items.front().required;
        lines.text("when", toString(questionnaire.when))
            .text("use", toString(questionnaire.use))
            .truth("required", required);
        return;
    }
    lines.text("title", questionnaire.title).text("when", toString(questionnaire.when));
    for (const QuestionnaireItem& item : questionnaire.items)
        addItem(lines, item);
}

void addTrigger(Lines& lines, const core::TriggerSettings& trigger) {
    switch (trigger.kind) {
    case core::TriggerSettings::Kind::none:
        break;
    case core::TriggerSettings::Kind::serial:
        lines.head("[trigger]")
            .text("kind", "serial")
            .text("device", trigger.device)
            .value("pulse_ms", number(trigger.pulse_ms));
        break;
    case core::TriggerSettings::Kind::osc:
        lines.head("[trigger]").text("kind", "osc").text("host", trigger.host).count("port", trigger.port);
        break;
    }
}

} // namespace

std::string protocolText(const Protocol& protocol) {
    Lines lines;
    lines.text("name", protocol.name).text("description", protocol.description);
    if (!protocol.authors.empty())
        lines.value("author", authorList(protocol.authors));
    lines.value("stimulus_s", number(protocol.stimulus_s))
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
    for (const Questionnaire& questionnaire : protocol.questionnaires)
        addQuestionnaire(lines, questionnaire);
    addTrigger(lines, protocol.trigger);
    if (protocol.recordSessions)
        lines.head("[recording]").truth("sessions", true);
    for (const ExclusionRule& rule : protocol.exclusions)
        lines.head("[[exclude]]")
            .text("id", rule.id)
            .text("of", toString(rule.of()))
            .text("rule", toString(rule.kind))
            .value("value", number(rule.value));
    return lines.take();
}

} // namespace teleta::study
