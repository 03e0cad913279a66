// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/exclusion_rule.h"

#include "backend/core/failure.h"
#include "backend/core/words.h"
#include "backend/study/protocol/identifier.h"

#include <QCoreApplication>
#include <QStringList>

#include <array>
#include <charconv>
#include <set>

namespace teleta::study {

namespace {

struct ExclusionText {
    Q_DECLARE_TR_FUNCTIONS(ExclusionRule)
};

constexpr core::Words<ExclusionOf, 3> kExclusionOf{{"trial", "session", "participant"}};
constexpr std::size_t kExclusionKinds = 10;
constexpr core::Words<ExclusionKind, kExclusionKinds> kKindWords{
    {"response_time_below_s", "response_time_above_s", "response_time_mad", "device_faults",
     "frames_missed_above", "timeouts_share_above", "catch_yes_share_above", "same_answer_share_above",
     "practice_accuracy_below", "accuracy_not_above_chance"}};
constexpr std::array<const char*, kExclusionKinds> kAbout{
    "trial: answered earlier than value",
    "trial: answered later than value",
    "trial: the logarithm of the time is further than value times 1.4826 MAD from the median of participant "
    "and condition",
    "trial: the device had more faults than value",
    "trial: more frames were missed than value",
    "session: the share of test trials without an answer is above value",
    "session: the share of yes in catch trials is above value",
    "session: the share of the most frequent answer is above value",
    "participant: the share of right answers in practice is below value",
    "participant: p of so many right test answers by guessing is above value"};
constexpr double kMostSeconds = 3600.0;
constexpr double kMostFactor = 100.0;
constexpr double kMostCount = 1e6;

core::NumberRange rangeOf(ExclusionKind kind) {
    switch (kind) {
    case ExclusionKind::responseTimeBelow_s:
    case ExclusionKind::responseTimeAbove_s:
        return core::NumberRange::positiveUpTo(kMostSeconds);
    case ExclusionKind::responseTimeMad:
        return core::NumberRange::positiveUpTo(kMostFactor);
    case ExclusionKind::deviceFaults:
    case ExclusionKind::framesMissedAbove:
        return core::NumberRange::between(0.0, kMostCount);
    case ExclusionKind::timeoutsShareAbove:
    case ExclusionKind::catchYesShareAbove:
    case ExclusionKind::sameAnswerShareAbove:
    case ExclusionKind::practiceAccuracyBelow:
    case ExclusionKind::accuracyNotAboveChance:
        break;
    }
    return core::NumberRange::between(0.0, 1.0);
}

} // namespace

ExclusionOf ExclusionRule::of() const {
    if (kind <= ExclusionKind::framesMissedAbove)
        return ExclusionOf::trial;
    return kind <= ExclusionKind::sameAnswerShareAbove ? ExclusionOf::session : ExclusionOf::participant;
}

const char* toString(ExclusionOf of) {
    return kExclusionOf.of(of);
}

const char* toString(ExclusionKind kind) {
    return kKindWords.of(kind);
}

void describeExclusions(core::Keys& keys, std::vector<ExclusionRule>& rules) {
    std::set<std::string> ids;
    keys.tables(
        "exclude", rules, 0, "What does not count; the rules apply in this order, each to what is left",
        [&ids](core::Keys& table, std::vector<ExclusionRule>& all, std::size_t i) {
            ExclusionRule& rule = all[i];
            describeIdentifier(table, "id", rule.id, ids, "The rule's name in results");
            auto of = rule.of();
            table.choice("of", of, {"trial", "session", "participant"}, "What is left out");
            core::KeyNames names;
            for (std::size_t k = 0; k < kExclusionKinds; ++k)
                names.emplace_back(kKindWords.words[k], kAbout[k]);
            table.choose("rule", static_cast<std::size_t>(rule.kind), names, "When it is left out",
                         core::Need::required, [&](core::Keys& same, std::size_t chosen) {
                             rule.kind = static_cast<ExclusionKind>(chosen);
                             same.number("value", rule.value, rangeOf(rule.kind), "The number of the rule");
                         });
            if (of != rule.of())
                table.refuse(
                    "of",
                    ExclusionText::tr("the rule %1 is about something else")
                        .arg(QLatin1String(toString(rule.kind)))
                        .toStdString(),
                    ExclusionText::tr("\"%1\"").arg(QLatin1String(toString(rule.of()))).toStdString());
        });
}

core::Expected<ExclusionRule> parseExclusion(std::string_view text) {
    const std::size_t sign = text.find('=');
    const std::string_view name = text.substr(0, sign);
    const std::optional<ExclusionKind> kind = kKindWords.find(name);
    const QString given = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    if (!kind) {
        QStringList names;
        for (const char* word : kKindWords.words)
            names << QLatin1String(word);
        return core::failed(
            core::ErrorKind::badInput, ExclusionText::tr("\"%1\" is no exclusion rule").arg(given),
            ExclusionText::tr("RULE=VALUE with one of %1").arg(names.join(QStringLiteral(", "))));
    }
    ExclusionRule rule{std::string(name), *kind, 0.0, true};
    const std::string_view number =
        sign == std::string_view::npos ? std::string_view() : text.substr(sign + 1);
    const char* end = number.data() + number.size();
    const auto [stop, code] = std::from_chars(number.data(), end, rule.value);
    const core::NumberRange range = rangeOf(*kind);
    if (number.empty() || code != std::errc{} || stop != end || !range.accepts(rule.value))
        return core::failed(core::ErrorKind::badInput,
                            ExclusionText::tr("\"%1\" has no usable value").arg(given),
                            ExclusionText::tr("%1=VALUE with %2")
                                .arg(QLatin1String(toString(*kind)), QString::fromStdString(range.text())));
    return rule;
}

} // namespace teleta::study
