// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/store/trial_table.h"

#include "backend/core/number_text.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <utility>

namespace teleta::study {

namespace {

TrialCell textCell(std::string value) {
    if (value.empty())
        return {};
    return {TrialCell::Kind::text, std::move(value)};
}

template <typename Number>
TrialCell numberCell(Number value) {
    return {TrialCell::Kind::number, std::string(core::NumberText(value).view())};
}

template <typename Number>
TrialCell numberCell(const std::optional<Number>& value) {
    return value ? numberCell(*value) : TrialCell{};
}

/// Of trial tables. Those of schema 1 end with app_version, those of 2 with recording_s.
constexpr int kTrialSchema = 3;

/// What rows of every table begin with. session: null for a participant as a whole.
TrialRow firstCells(const StudyHead& head, const Participant& participant, const SessionRecord* session,
                    const PlannedSession& plan, int schema = 1) {
    TrialRow row{numberCell(schema), textCell(participant.id), {}, textCell(toString(head.mode)), {}, {}};
    if (session != nullptr) {
        const StudyTask& task = head.protocol.tasks[plan.task];
        row[2] = textCell(session->id);
        row[4] = textCell(task.id);
        row[5] = textCell(task.conditions[plan.condition]);
    }
    return row;
}

TrialCell timeCell(const QDateTime& time) {
    return textCell(time.toString(Qt::ISODateWithMs).toStdString());
}

/// Null if the protocol does not have them.
std::pair<const Questionnaire*, const QuestionnaireItem*> itemOf(const Protocol& protocol,
                                                                 const StoredAnswer& answer) {
    for (const Questionnaire& questionnaire : protocol.questionnaires) {
        if (questionnaire.id != answer.questionnaire)
            continue;
        const auto item = std::ranges::find(questionnaire.items, answer.item, &QuestionnaireItem::id);
        return {&questionnaire, item == questionnaire.items.end() ? nullptr : &*item};
    }
    return {nullptr, nullptr};
}

std::string maskingNoise(const Protocol& protocol) {
    if (protocol.noiseColour == "none")
        return "none";
    return protocol.noiseColour + '_' + std::string(core::NumberText(protocol.noise_dBA).view()) + "dBA";
}

/// Whether a spreadsheet would misread the text: as a formula, or as a number, of which it keeps 15 digits. A
/// number with a sign, such as a participant's answer, is left alone.
bool needsGuard(std::string_view text) {
    constexpr std::ptrdiff_t kDigits = 15;
    double value = 0.0;
    const char* begin = text.data() + (text.front() == '+' ? 1 : 0);
    const char* end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(begin, end, value);
    // A number too large to be parsed here has too many digits there.
    const bool isNumber = stop == end && code != std::errc::invalid_argument;
    const auto digits = std::count_if(begin, end, [](char c) { return c >= '0' && c <= '9'; });
    if (isNumber && digits > 0)
        return digits > kDigits;
    return std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
}

std::string field(const TrialCell& cell, const TableFormat& format) {
    if (cell.kind == TrialCell::Kind::missing)
        return format.missing;
    std::string value = cell.text;
    if (cell.kind == TrialCell::Kind::number) {
        std::ranges::replace(value, '.', format.decimal);
        return value;
    }
    // A terminal obeys them; line ends and tabs are text.
    std::ranges::replace_if(
        value, [](char c) { return (c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r') || c == 0x7F; },
        ' ');
    if (format.guarded && needsGuard(value))
        value.insert(value.begin(), '\'');
    const auto isSpecial = [&](char c) {
        return c == format.separator || c == '"' || c == '\n' || c == '\r';
    };
    if (!format.quotes) {
        std::replace_if(
            value.begin(), value.end(),
            [&](char c) { return c == format.separator || c == '\n' || c == '\r'; }, ' ');
        return value;
    }
    // Leading and trailing blanks survive only in quotes.
    const bool mustQuote = std::ranges::any_of(value, isSpecial) || value.front() == ' ' ||
                           value.back() == ' ' || value.front() == '\t' || value.back() == '\t';
    if (!mustQuote)
        return value;
    std::string quoted = "\"";
    for (const char c : value) {
        if (c == '"')
            quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

} // namespace

std::vector<TrialRow> trialRows(const StudyHead& head, const Participant& participant,
                                const SessionRecord& session, const PlannedSession& plan,
                                const std::vector<StoredTrial>& trials) {
    const Protocol& protocol = head.protocol;
    const StudyTask& task = protocol.tasks[plan.task];
    std::vector<TrialRow> rows;
    for (const StoredTrial& stored : trials) {
        const TrialResult& result = stored.result;
        const bool practice = result.planned.phase == Phase::practice;
        const bool feedback = (practice ? protocol.practice : protocol.test).feedback;
        TrialRow row = firstCells(head, participant, &session, plan, kTrialSchema);
        const bool hasLevels = task.design != Design::identification;
        const std::string& condition = task.conditions[plan.condition];
        // Of two that are the same neither has more.
        const bool isScored =
            task.design != Design::compare || result.planned.level != task.referenceOf(condition);
        const std::initializer_list<TrialCell> others{
            numberCell(plan.conditionPosition + 1),
            numberCell(plan.sequenceRow + 1),
            textCell(toString(result.planned.phase)),
            numberCell(practice ? 1 : 2),
            numberCell(result.planned.trial),
            numberCell(result.trialInBlock),
            numberCell(result.planned.repetition),
            numberCell(result.planned.attempt),
            textCell(task.patterns.at(result.planned.stimulus).letter),
            result.response ? textCell(task.patterns.at(*result.response).letter) : TrialCell{},
            textCell(toString(result.outcome)),
            result.isComplete() && isScored ? numberCell(result.outcome == Outcome::correct ? 1 : 0)
                                            : TrialCell{},
            numberCell(result.responseTime_s),
            numberCell(result.responseTimeOffset_s),
            numberCell(protocol.responseLimit_s),
            numberCell(task.patterns.size()),
            textCell(result.responseDevice),
            textCell(result.responseKey),
            numberCell(result.replays),
            numberCell(result.earlyPresses),
            numberCell(result.onset_s),
            numberCell(result.duration_s),
            numberCell(result.deviceLatency_ms),
            numberCell(result.deviceFaults),
            numberCell(feedback ? 1 : 0),
            textCell(maskingNoise(protocol)),
            timeCell(stored.time),
            textCell(std::to_string(plan.seed)),
            textCell(toString(protocol.order)),
            textCell(head.stimulusSetSha256),
            textCell(head.appVersion),
            textCell(toString(task.design)),
            textCell(result.planned.track),
            numberCell(result.planned.level),
            hasLevels ? textCell(unitOf(task.levels.vary)) : TrialCell{},
            hasLevels ? numberCell(task.referenceOf(condition)) : TrialCell{},
            hasLevels ? textCell(nameOf(task.levels.procedure)) : TrialCell{},
            TrialCell{},
            numberCell(result.trigger_ms),
            textCell(result.recording),
            numberCell(result.recording_s),
            numberCell(result.latencySpread_ms)};
        row.insert(row.end(), others);
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<TrialRow> answerRows(const StudyHead& head, const Participant& participant,
                                 const std::vector<SessionRecord>& sessions,
                                 const std::vector<StoredAnswer>& answers) {
    const Protocol& protocol = head.protocol;
    const std::vector<PlannedSession> plans = planSessions(protocol, head.seed, participant.enrolment);
    std::vector<TrialRow> rows;
    for (const StoredAnswer& answer : answers) {
        const auto session = std::ranges::find(sessions, answer.session, &SessionRecord::key);
        const bool known = session != sessions.end();
        TrialRow row = firstCells(head, participant, known ? &*session : nullptr,
                                  known ? plans.at(session->planIndex) : PlannedSession());
        row.push_back(textCell(answer.questionnaire));
        const auto [questionnaire, item] = itemOf(protocol, answer);
        row.push_back(questionnaire != nullptr ? textCell(toString(questionnaire->when)) : TrialCell{});
        row.push_back(textCell(answer.item));
        row.push_back(item != nullptr ? textCell(toString(item->kind)) : TrialCell{});
        row.push_back(item != nullptr ? textCell(item->question) : TrialCell{});
        row.push_back(textCell(answer.value.value_or(std::string())));
        row.push_back(item != nullptr ? textCell(shownAnswer(*item, answer.value)) : TrialCell{});
        row.push_back(timeCell(answer.time));
        row.push_back(textCell(head.appVersion));
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<TrialRow> noteRows(const StudyHead& head, const Participant& participant,
                               const SessionRecord& session, const PlannedSession& plan,
                               const std::vector<StoredNote>& notes) {
    std::vector<TrialRow> rows;
    for (const StoredNote& note : notes) {
        TrialRow row = firstCells(head, participant, &session, plan);
        row.insert(row.end(), {textCell(note.text), timeCell(note.time), textCell(head.appVersion)});
        rows.push_back(std::move(row));
    }
    return rows;
}

std::string tableText(const std::vector<TrialRow>& rows, const TableFormat& format,
                      std::span<const std::string_view> columns) {
    std::string table = format.byteOrderMark ? "\xEF\xBB\xBF" : "";
    for (std::size_t i = 0; i < columns.size(); ++i) {
        table += i > 0 ? std::string(1, format.separator) : std::string();
        table += columns[i];
    }
    table += '\n';
    for (const TrialRow& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i > 0)
                table += format.separator;
            table += field(row[i], format);
        }
        table += '\n';
    }
    return table;
}

} // namespace teleta::study
