// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/analysis/trials/trial_source.h"

#include "backend/core/data/csv_reader.h"
#include "backend/core/failure.h"
#include "backend/study/analysis/trials/stored_exclusions.h"

#include <QByteArrayView>
#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

namespace teleta::study {

namespace {

struct SourceText {
    Q_DECLARE_TR_FUNCTIONS(SourceText)
};

constexpr std::array<std::string_view, 6> kNeeded{"participant_id", "task",     "condition",
                                                  "phase",          "stimulus", "response"};
constexpr long long kRowsBetweenQuestions = 8192;

bool isMissing(std::string_view text) {
    return text.empty() || text == "NA" || text == "n/a" || text == "NONE";
}

QString shown(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(std::min<std::size_t>(text.size(), 40)));
}

core::Unexpected mixedModes(const core::SourcePlace& place, Mode one, Mode other) {
    return core::failed(
        core::ErrorKind::refused,
        SourceText::tr("these are data of different modes: %1 and %2").arg(toString(one), toString(other)),
        SourceText::tr("one mode, or the choice of one"), place);
}

core::Unexpected twoPeople(const core::SourcePlace& place, std::string_view participant,
                           const std::string& before) {
    return core::failed(
        core::ErrorKind::refused,
        SourceText::tr("%1 also has trials in %2: these may be two people, or the same trials twice")
            .arg(shown(participant), QString::fromStdString(before)),
        SourceText::tr("each participant in one study only, under a unique name"), place);
}

core::Unexpected tooManyPatterns(const core::SourcePlace& place) {
    return core::failed(core::ErrorKind::badInput, SourceText::tr("there are too many different patterns"),
                        SourceText::tr("%1 at most").arg(TrialTally::kMostNames), place);
}

/// Reads the rows of a file.
class RowReader {
public:
    RowReader(const core::CsvReader& csv, const std::vector<std::size_t>& needed)
        : m_csv(csv)
        , m_file(csv.place(0).file)
        , m_needed(needed)
        , m_mode(optionalColumn("mode"))
        , m_outcome(optionalColumn("outcome"))
        , m_time(optionalColumn("response_time_s"))
        , m_session(optionalColumn("session_id"))
        , m_trial(optionalColumn("trial"))
        , m_attempt(optionalColumn("attempt"))
        , m_alternatives(optionalColumn("n_alternatives"))
        , m_faults(optionalColumn("device_faults"))
        , m_design(optionalColumn("design"))
        , m_excluded(optionalColumn("excluded")) {}

    /// Names in another encoding would be other names.
    [[nodiscard]] core::Expected<void> checkEncoding(const std::vector<std::string_view>& fields) const;
    /// False: the row is not counted.
    [[nodiscard]] core::Expected<bool> read(const std::vector<std::string_view>& fields, ModeFilter& modes,
                                            TalliedTrial& trial) const;
    /// Error: the row must not be combined with those before it.
    [[nodiscard]] core::Expected<void> take(const std::vector<std::string_view>& fields,
                                            const TalliedTrial& trial, TrialOrigins& origins) const;
    /// The trial with what the rules of exclusions have to know of it.
    [[nodiscard]] core::Expected<ExclusionBook::Trial> excludable(const std::vector<std::string_view>& fields,
                                                                  const TalliedTrial& trial) const;
    /// Number of patterns of the task according to the row; 0: unknown.
    [[nodiscard]] core::Expected<std::size_t> alternatives(const std::vector<std::string_view>& fields) const;

private:
    [[nodiscard]] std::optional<std::size_t> optionalColumn(std::string_view name) const {
        const auto& header = m_csv.header();
        const auto found = std::ranges::find(header, name);
        return found == header.end() ? std::nullopt
                                     : std::optional(static_cast<std::size_t>(found - header.begin()));
    }

    [[nodiscard]] core::Unexpected wrong(std::size_t column, std::string_view text,
                                         const QString& expected) const {
        return core::failed(core::ErrorKind::badInput,
                            SourceText::tr("%1 cannot be \"%2\"")
                                .arg(QString::fromStdString(m_csv.header()[column]), shown(text)),
                            expected, m_csv.place(column));
    }

    [[nodiscard]] core::Expected<bool> hasCountedMode(std::string_view text, ModeFilter& modes) const;
    [[nodiscard]] core::Expected<std::size_t> number(std::size_t column, std::string_view text) const;

    const core::CsvReader& m_csv;
    const std::string m_file;
    const std::vector<std::size_t>& m_needed;
    std::optional<std::size_t> m_mode;
    std::optional<std::size_t> m_outcome;
    std::optional<std::size_t> m_time;
    std::optional<std::size_t> m_session;
    std::optional<std::size_t> m_trial;
    std::optional<std::size_t> m_attempt;
    std::optional<std::size_t> m_alternatives;
    std::optional<std::size_t> m_faults;
    std::optional<std::size_t> m_design;
    std::optional<std::size_t> m_excluded;
};

core::Expected<void> RowReader::checkEncoding(const std::vector<std::string_view>& fields) const {
    for (const std::size_t column : m_needed) {
        const std::string_view text = fields[column];
        const bool plain =
            std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
        if (!plain && !QByteArrayView(text.data(), static_cast<qsizetype>(text.size())).isValidUtf8())
            return core::failed(core::ErrorKind::badInput, SourceText::tr("this text is not UTF-8"),
                                SourceText::tr("a file that was saved as UTF-8"), m_csv.place(column));
    }
    return {};
}

core::Expected<bool> RowReader::hasCountedMode(std::string_view text, ModeFilter& modes) const {
    // Comparing with the last mode first saves a string per row.
    if (modes.seen && text == toString(*modes.seen))
        return !modes.wanted || modes.wanted == modes.seen;
    const std::optional<Mode> mode = modeOf(std::string(text));
    if (!mode)
        return wrong(*m_mode, text, SourceText::tr("run, pilot or simulated"));
    if (modes.wanted)
        return *mode == *modes.wanted;
    if (modes.seen)
        return mixedModes(m_csv.place(*m_mode), *modes.seen, *mode);
    modes.seen = mode;
    return true;
}

core::Expected<bool> RowReader::read(const std::vector<std::string_view>& fields, ModeFilter& modes,
                                     TalliedTrial& trial) const {
    const auto field = [&](std::size_t i) { return fields[m_needed[i]]; };
    for (std::size_t i = 0; i < 5; ++i) {
        if (isMissing(field(i)))
            return wrong(m_needed[i], field(i), SourceText::tr("a value"));
    }
    const bool isTest = field(3) == "test";
    if (!isTest && field(3) != "practice")
        return wrong(m_needed[3], field(3), SourceText::tr("practice or test"));
    bool counts = true;
    bool answered = !isMissing(field(5));
    if (m_mode) {
        const core::Expected<bool> counted = hasCountedMode(fields[*m_mode], modes);
        if (!counted)
            return counted;
        counts = *counted;
    }
    if (m_outcome) {
        const std::string_view text = fields[*m_outcome];
        const std::optional<Outcome> outcome = outcomeOf(std::string(text));
        if (!outcome)
            return wrong(*m_outcome, text,
                         SourceText::tr("correct, incorrect, timeout, aborted or device_error"));
        const bool completed = *outcome != Outcome::aborted && *outcome != Outcome::deviceError;
        counts = counts && completed;
        const bool isAnswer = *outcome == Outcome::correct || *outcome == Outcome::incorrect;
        if (completed &&
            (isAnswer != answered || (isAnswer && (*outcome == Outcome::correct) != (field(4) == field(5)))))
            return wrong(*m_outcome, text, SourceText::tr("the value implied by stimulus and response"));
    }
    trial.responseTime_s.reset();
    if (m_time && !isMissing(fields[*m_time])) {
        const std::string_view text = fields[*m_time];
        double time_s = 0.0;
        const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), time_s);
        if (code != std::errc{} || stop != text.data() + text.size() || !std::isfinite(time_s))
            return wrong(*m_time, text, SourceText::tr("a number of seconds or NA"));
        trial.responseTime_s = time_s;
    }
    trial.participant = field(0);
    trial.task = field(1);
    trial.condition = field(2);
    trial.phase = isTest ? Phase::test : Phase::practice;
    trial.stimulus = field(4);
    trial.response = answered ? field(5) : std::string_view();
    return counts;
}

core::Expected<std::size_t> RowReader::number(std::size_t column, std::string_view text) const {
    std::size_t value = 0;
    const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || stop != text.data() + text.size() || value == 0)
        return wrong(column, text, SourceText::tr("a whole number of at least 1"));
    return value;
}

core::Expected<ExclusionBook::Trial> RowReader::excludable(const std::vector<std::string_view>& fields,
                                                           const TalliedTrial& trial) const {
    const auto textOf = [&](std::optional<std::size_t> column) {
        return column && !isMissing(fields[*column]) ? fields[*column] : std::string_view();
    };
    ExclusionBook::Trial known{trial, textOf(m_session), 0, 0, true, textOf(m_excluded)};
    // Without their names, sessions are told apart by what they were about.
    if (known.session.empty())
        known.session = trial.condition;
    known.isScored = textOf(m_design) != "compare";
    if (const std::string_view faults = textOf(m_faults); !faults.empty()) {
        const auto [stop, code] =
            std::from_chars(faults.data(), faults.data() + faults.size(), known.deviceFaults);
        if (code != std::errc{} || stop != faults.data() + faults.size())
            return wrong(*m_faults, faults, SourceText::tr("a whole number"));
    }
    return known;
}

core::Expected<std::size_t> RowReader::alternatives(const std::vector<std::string_view>& fields) const {
    if (!m_alternatives || isMissing(fields[*m_alternatives]))
        return 0U;
    const std::string_view text = fields[*m_alternatives];
    const core::Expected<std::size_t> value = number(*m_alternatives, text);
    if (value && *value > TrialTally::kMostNames)
        return wrong(*m_alternatives, text, SourceText::tr("%1 at most").arg(TrialTally::kMostNames));
    return value;
}

core::Expected<void> RowReader::take(const std::vector<std::string_view>& fields, const TalliedTrial& trial,
                                     TrialOrigins& origins) const {
    if (const auto before = origins.takeFromFile(trial.participant, m_file))
        return twoPeople(m_csv.place(m_needed[0]), trial.participant, *before);
    if (!m_session || !m_trial || !m_attempt || isMissing(fields[*m_session]) ||
        isMissing(fields[*m_trial]) || isMissing(fields[*m_attempt]))
        return {};
    TELETA_TRY(const std::size_t shownTrial, number(*m_trial, fields[*m_trial]));
    TELETA_TRY(const std::size_t attempt, number(*m_attempt, fields[*m_attempt]));
    if (!origins.addTrial({trial.participant, fields[*m_session], trial.phase, shownTrial, attempt}))
        return core::failed(core::ErrorKind::refused,
                            SourceText::tr("trial %1 of session %2 of %3 was already counted")
                                .arg(shownTrial)
                                .arg(shown(fields[*m_session]), shown(trial.participant)),
                            SourceText::tr("each trial once"), m_csv.place(*m_trial));
    return {};
}

/// Spreadsheets and BIDS separate columns by other characters.
core::Expected<void> checkSeparator(const core::CsvReader& csv) {
    if (csv.header().size() != 1)
        return {};
    const std::string& line = csv.header().front();
    const bool semicolons = line.find(';') != std::string::npos;
    if (!semicolons && line.find('\t') == std::string::npos)
        return {};
    return core::failed(core::ErrorKind::badInput,
                        semicolons ? SourceText::tr("the columns are separated by semicolons")
                                   : SourceText::tr("the columns are separated by tabs"),
                        SourceText::tr("commas, and a point in numbers: the trials that are in data/ of the "
                                       "study, or the file saved as CSV with commas"),
                        csv.place(0));
}

} // namespace

core::Expected<void> tallyCsv(const std::string& path, ModeFilter& modes, TrialTally& tally,
                              ExclusionBook& exclusions, const std::function<bool(std::uint64_t)>& goOn) {
    TELETA_TRY(core::CsvReader csv, core::CsvReader::open(path));
    TELETA_CHECK(checkSeparator(csv));
    TELETA_TRY(const std::vector<std::size_t> needed, csv.columns(kNeeded));
    const RowReader reader(csv, needed);
    std::vector<std::string_view> fields;
    TalliedTrial trial;
    for (long long row = 0;; ++row) {
        TELETA_TRY(const bool more, csv.nextText(fields));
        if (!more)
            return {};
        if (row % kRowsBetweenQuestions == 0 && !goOn(csv.bytesRead()))
            return core::failed(core::ErrorKind::cancelled, SourceText::tr("interrupted"), {}, {path});
        TELETA_CHECK(reader.checkEncoding(fields));
        TELETA_TRY(const bool counts, reader.read(fields, modes, trial));
        if (!counts)
            continue;
        TELETA_CHECK(reader.take(fields, trial, tally.origins()));
        TELETA_TRY(const std::size_t alternatives, reader.alternatives(fields));
        tally.expectCount(trial.task, alternatives);
        TELETA_TRY(ExclusionBook::Trial known, reader.excludable(fields, trial));
        known.file = path;
        known.row = row;
        const bool isHeld = !known.excluded.empty() || exclusions.hasRules({});
        if (isHeld ? !exclusions.hold(known, {}) : !tally.add(trial))
            return tooManyPatterns(csv.place(needed[4]));
    }
}

core::Expected<void> tallyCsv(const std::string& path, ModeFilter& modes, TrialTally& tally,
                              const std::function<bool(std::uint64_t)>& goOn) {
    ExclusionBook marks;
    TELETA_CHECK(tallyCsv(path, modes, tally, marks, goOn));
    return settle(marks, tally, path);
}

core::Expected<void> tallyStore(const StudyStore& store, ModeFilter& modes, TrialTally& tally,
                                ExclusionBook& exclusions) {
    const StudyHead& head = store.head();
    if (modes.wanted && *modes.wanted != head.mode)
        return {};
    if (!modes.wanted && modes.seen && *modes.seen != head.mode)
        return mixedModes({store.folder()}, *modes.seen, head.mode);
    modes.seen = head.mode;
    TELETA_TRY(const std::vector<Participant> participants, store.participants());
    for (const Participant& participant : participants) {
        bool isTaken = false;
        const std::vector<PlannedSession> plan =
            planSessions(head.protocol, head.seed, participant.enrolment);
        TELETA_TRY(const std::vector<SessionRecord> sessions, store.sessions(participant));
        for (const SessionRecord& session : sessions) {
            TELETA_TRY(const std::vector<StoredTrial> trials, store.trials(session));
            const PlannedSession& planned = plan.at(session.planIndex);
            const StudyTask& task = head.protocol.tasks[planned.task];
            const auto counts = [](const StoredTrial& stored) { return stored.result.isComplete(); };
            if (std::ranges::any_of(trials, counts)) {
                for (const StudyPattern& pattern : task.patterns)
                    tally.expectPattern(task.id, pattern.letter);
            }
            for (const StoredTrial& stored : trials) {
                const TrialResult& result = stored.result;
                if (!result.isComplete())
                    continue;
                if (!isTaken) {
                    if (const auto before = tally.origins().takeFromStore(participant.id, store.shownName()))
                        return twoPeople({store.shownName()}, participant.id, *before);
                    isTaken = true;
                }
                tally.addFrames(result.frameWrite_ms, result.framesMissed);
                const ExcludableTrial known = excludableTrial(task, planned, session, result);
                const TalliedTrial trial{participant.id, task.id,        known.condition,     known.phase,
                                         known.stimulus, known.response, known.responseTime_s};
                if (exclusions.hasRules(head.protocol.exclusions))
                    (void)exclusions.hold(
                        {trial, session.id, known.deviceFaults, known.framesMissed, known.chance > 0.0, {}},
                        head.protocol.exclusions);
                else
                    (void)tally.add(trial);
            }
        }
    }
    return {};
}

core::Expected<void> tallyStore(const StudyStore& store, ModeFilter& modes, TrialTally& tally) {
    ExclusionBook rules;
    TELETA_CHECK(tallyStore(store, modes, tally, rules));
    return settle(rules, tally, store.shownName());
}

core::Expected<void> settle(ExclusionBook& exclusions, TrialTally& tally, const std::string& source) {
    if (!exclusions.finish(tally))
        return tooManyPatterns({source});
    return {};
}

} // namespace teleta::study
