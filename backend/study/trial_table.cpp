// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/trial_table.h"

#include "backend/core/number_text.h"

#include <algorithm>

namespace teleta::study {

namespace {

TrialCell text(std::string value) {
    if (value.empty())
        return {};
    return {TrialCell::Kind::text, std::move(value)};
}

template <typename Number>
TrialCell number(Number value) {
    return {TrialCell::Kind::number, std::string(core::NumberText(value).view())};
}

template <typename Number>
TrialCell number(const std::optional<Number>& value) {
    return value ? number(*value) : TrialCell{};
}

std::string maskingNoise(const Protocol& protocol) {
    if (protocol.noiseColour == "none")
        return "none";
    return protocol.noiseColour + '_' + std::string(core::NumberText(protocol.noise_dBA).view()) + "dBA";
}

std::string field(const TrialCell& cell, const TableFormat& format) {
    if (cell.kind == TrialCell::Kind::missing)
        return format.missing;
    std::string value = cell.text;
    if (cell.kind == TrialCell::Kind::number) {
        std::replace(value.begin(), value.end(), '.', format.decimal);
        return value;
    }
    const auto isSpecial = [&](char c) {
        return c == format.separator || c == '"' || c == '\n' || c == '\r';
    };
    if (!format.quotes) {
        std::replace_if(
            value.begin(), value.end(),
            [&](char c) { return c == format.separator || c == '\n' || c == '\r'; }, ' ');
        return value;
    }
    // A text that looks like a missing value, or begins or ends with a blank, is read back as it is only in
    // quotes.
    const bool mustQuote = std::any_of(value.begin(), value.end(), isSpecial) || value.front() == ' ' ||
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
        rows.push_back({
            number(1),
            text(participant.id),
            text(session.id),
            text(toString(head.mode)),
            text(task.id),
            text(task.conditions[plan.condition]),
            number(plan.conditionPosition + 1),
            number(plan.sequenceRow + 1),
            text(toString(result.planned.phase)),
            number(practice ? 1 : 2),
            number(result.planned.trial),
            number(result.trialInBlock),
            number(result.planned.repetition),
            number(result.planned.attempt),
            text(task.patterns.at(result.planned.stimulus).letter),
            result.response ? text(task.patterns.at(*result.response).letter) : TrialCell{},
            text(toString(result.outcome)),
            result.isComplete() ? number(result.outcome == Outcome::correct ? 1 : 0) : TrialCell{},
            number(result.responseTime_s),
            number(result.responseTimeOffset_s),
            number(protocol.responseLimit_s),
            number(task.patterns.size()),
            text(result.responseDevice),
            text(result.responseKey),
            number(result.replays),
            number(result.earlyPresses),
            number(result.onset_s),
            number(result.duration_s),
            number(result.deviceLatency_ms),
            number(result.deviceFaults),
            number(feedback ? 1 : 0),
            text(maskingNoise(protocol)),
            text(stored.time.toString(Qt::ISODateWithMs).toStdString()),
            text(std::to_string(plan.seed)),
            text(toString(protocol.order)),
            text(head.stimulusSetSha256),
            text(head.appVersion),
        });
    }
    return rows;
}

std::string tableText(const std::vector<TrialRow>& rows, const TableFormat& format) {
    std::string table = format.byteOrderMark ? "\xEF\xBB\xBF" : "";
    for (std::size_t i = 0; i < kTrialColumns.size(); ++i) {
        table += i > 0 ? std::string(1, format.separator) : std::string();
        table += kTrialColumns[i];
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
