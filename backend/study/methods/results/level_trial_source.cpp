// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/results/level_trial_source.h"

#include "backend/core/data/csv_number.h"
#include "backend/core/data/csv_reader.h"
#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace teleta::study {

namespace {

struct LevelSourceText {
    Q_DECLARE_TR_FUNCTIONS(LevelSourceText)
};

constexpr std::array<std::string_view, 5> kLevelColumns{"participant_id", "task", "condition", "phase",
                                                        "level"};
constexpr long long kLevelRowsBetweenQuestions = 8192;
constexpr double kMostAlternatives = 100.0;
constexpr double kMostLevel = 1e9;

bool isNothing(std::string_view text) {
    return text.empty() || text == "NA" || text == "n/a" || text == "NONE";
}

QString quoted(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(std::min<std::size_t>(text.size(), 40)));
}

core::Unexpected twoModes(const core::SourcePlace& place, Mode one, Mode other) {
    return core::failed(core::ErrorKind::refused,
                        LevelSourceText::tr("these are data of different modes: %1 and %2")
                            .arg(toString(one), toString(other)),
                        LevelSourceText::tr("one mode, or the choice of one"), place);
}

/// The words of answers, by index.
std::vector<std::string> wordsOf(Design design, std::size_t intervals) {
    if (design == Design::yesNo)
        return {"yes", "no"};
    if (design == Design::sameDifferent)
        return {"same", "different"};
    std::vector<std::string> numbers;
    for (std::size_t i = 1; i <= (design == Design::compare ? 2 : intervals); ++i)
        numbers.push_back(std::to_string(i));
    return numbers;
}

std::optional<Design> designOf(std::string_view word) {
    for (const Design design :
         {Design::identification, Design::yesNo, Design::interval, Design::sameDifferent, Design::compare}) {
        if (word == toString(design))
            return design;
    }
    return std::nullopt;
}

/// Reads rows with levels.
class LevelRows {
public:
    explicit LevelRows(const core::CsvReader& csv)
        : m_csv(csv) {}

    /// Finds the columns. False: there is no column of levels.
    [[nodiscard]] core::Expected<bool> find();
    [[nodiscard]] core::Expected<void> take(const std::vector<std::string_view>& fields, ModeFilter& modes,
                                            LevelTrials& trials);

private:
    using Column = std::optional<std::size_t>;

    [[nodiscard]] Column columnOf(std::string_view name) const {
        const auto& header = m_csv.header();
        const auto found = std::ranges::find(header, name);
        return found == header.end() ? std::nullopt
                                     : Column(static_cast<std::size_t>(found - header.begin()));
    }
    [[nodiscard]] core::Unexpected wrong(std::size_t column, std::string_view text,
                                         const QString& expected) const {
        return core::failed(core::ErrorKind::badInput,
                            LevelSourceText::tr("%1 cannot be \"%2\"")
                                .arg(QString::fromStdString(m_csv.header()[column]), quoted(text)),
                            expected, m_csv.place(column));
    }
    [[nodiscard]] core::Expected<bool> isCounted(const std::vector<std::string_view>& fields,
                                                 ModeFilter& modes) const;
    /// A number; `otherwise` where the column or its value is missing.
    [[nodiscard]] core::Expected<double> number(Column column, const std::vector<std::string_view>& fields,
                                                double otherwise, double least, double most) const;
    [[nodiscard]] core::Expected<std::optional<LevelTrial>>
    trialOf(const std::vector<std::string_view>& fields, const LevelTaskFacts& facts, double level,
            double reference) const;
    [[nodiscard]] core::Expected<std::optional<std::size_t>> answer(std::size_t column, std::string_view text,
                                                                    const LevelTaskFacts& facts) const;
    [[nodiscard]] core::Expected<void> learn(const std::vector<std::string_view>& fields,
                                             LevelTaskFacts& facts) const;
    [[nodiscard]] std::string_view textOf(Column column, const std::vector<std::string_view>& fields) const {
        return column && !isNothing(fields[*column]) ? fields[*column] : std::string_view();
    }

    const core::CsvReader& m_csv;
    std::vector<std::size_t> m_needed;
    Column m_correct, m_stimulus, m_response, m_track, m_design, m_unit, m_reference, m_procedure,
        m_alternatives, m_repetition, m_mode, m_outcome, m_excluded;
};

core::Expected<bool> LevelRows::find() {
    if (!columnOf("level"))
        return false;
    TELETA_TRY(m_needed, m_csv.columns(kLevelColumns));
    m_correct = columnOf("correct");
    m_stimulus = columnOf("stimulus");
    m_response = columnOf("response");
    m_track = columnOf("track");
    m_design = columnOf("design");
    m_unit = columnOf("level_unit");
    m_reference = columnOf("reference");
    m_procedure = columnOf("procedure");
    m_alternatives = columnOf("n_alternatives");
    m_repetition = columnOf("repetition");
    m_mode = columnOf("mode");
    m_outcome = columnOf("outcome");
    m_excluded = columnOf("excluded");
    if (!m_correct && !(m_stimulus && m_response))
        return core::failed(
            core::ErrorKind::badInput, LevelSourceText::tr("nothing says which answers are correct"),
            LevelSourceText::tr("a column correct, or stimulus and response"), {m_csv.path(), 1});
    return true;
}

core::Expected<bool> LevelRows::isCounted(const std::vector<std::string_view>& fields,
                                          ModeFilter& modes) const {
    const std::string_view phase = fields[m_needed[3]];
    if (phase != "test" && phase != "practice")
        return wrong(m_needed[3], phase, LevelSourceText::tr("practice or test"));
    bool counts = phase == "test";
    if (m_mode) {
        const std::optional<Mode> mode = modeOf(fields[*m_mode]);
        if (!mode)
            return wrong(*m_mode, fields[*m_mode], LevelSourceText::tr("run, pilot or simulated"));
        if (modes.wanted)
            counts = counts && *mode == *modes.wanted;
        else if (modes.seen && *modes.seen != *mode)
            return twoModes(m_csv.place(*m_mode), *modes.seen, *mode);
        else
            modes.seen = mode;
    }
    if (m_outcome) {
        const std::optional<Outcome> outcome = outcomeOf(fields[*m_outcome]);
        if (!outcome)
            return wrong(*m_outcome, fields[*m_outcome],
                         LevelSourceText::tr("correct, incorrect, timeout, aborted or device_error"));
        counts = counts && *outcome != Outcome::aborted && *outcome != Outcome::deviceError;
    }
    return counts && textOf(m_excluded, fields).empty();
}

core::Expected<double> LevelRows::number(Column column, const std::vector<std::string_view>& fields,
                                         double otherwise, double least, double most) const {
    if (textOf(column, fields).empty())
        return otherwise;
    const std::string_view text = fields[*column];
    const std::optional<double> value = core::numberOrNA(text);
    if (!value || *value < least || *value > most)
        return wrong(*column, text,
                     LevelSourceText::tr("a number from %1 to %2, or NA").arg(least).arg(most));
    return *value;
}

core::Expected<void> LevelRows::learn(const std::vector<std::string_view>& fields,
                                      LevelTaskFacts& facts) const {
    if (const std::string_view word = textOf(m_design, fields); !word.empty()) {
        const std::optional<Design> design = designOf(word);
        if (!design || *design == Design::identification || (facts.design && *facts.design != *design))
            return wrong(*m_design, word,
                         LevelSourceText::tr("yes_no, interval, same_different or compare, one for a task"));
        facts.design = design;
    }
    TELETA_TRY(const double alternatives, number(m_alternatives, fields, 0.0, 0.0, kMostAlternatives));
    facts.intervals = std::max(facts.intervals, static_cast<std::size_t>(alternatives));
    if (facts.unit.empty())
        facts.unit = textOf(m_unit, fields);
    if (facts.procedure.empty())
        facts.procedure = textOf(m_procedure, fields);
    return {};
}

core::Expected<std::optional<std::size_t>> LevelRows::answer(std::size_t column, std::string_view text,
                                                             const LevelTaskFacts& facts) const {
    if (isNothing(text))
        return std::nullopt;
    const std::size_t intervals = std::max<std::size_t>(facts.intervals, 2);
    const std::vector<std::string> answers = wordsOf(*facts.design, intervals);
    const auto found = std::ranges::find(answers, text);
    if (found != answers.end())
        return static_cast<std::size_t>(found - answers.begin());
    QString expected;
    for (const std::string& one : answers)
        expected += (expected.isEmpty() ? QString() : QStringLiteral(", ")) + QString::fromStdString(one);
    return wrong(column, text, expected);
}

core::Expected<std::optional<LevelTrial>> LevelRows::trialOf(const std::vector<std::string_view>& fields,
                                                             const LevelTaskFacts& facts, double level,
                                                             double reference) const {
    if (m_stimulus && m_response && facts.design && !isNothing(fields[*m_stimulus])) {
        TELETA_TRY(const std::optional<std::size_t> right, answer(*m_stimulus, fields[*m_stimulus], facts));
        TELETA_TRY(const std::optional<std::size_t> given, answer(*m_response, fields[*m_response], facts));
        return levelTrialOf(*facts.design, level, reference, *right, given);
    }
    bool correct = false;
    if (m_correct) {
        const std::string_view text = fields[*m_correct];
        if (text != "0" && text != "1")
            return wrong(*m_correct, text, LevelSourceText::tr("0 or 1"));
        correct = text == "1";
    } else {
        correct = fields[*m_stimulus] == fields[*m_response];
    }
    return levelTrialOf(facts.design, level, reference, correct);
}

core::Expected<void> LevelRows::take(const std::vector<std::string_view>& fields, ModeFilter& modes,
                                     LevelTrials& trials) {
    const std::string_view levelText = fields[m_needed[4]];
    if (isNothing(levelText))
        return {};
    TELETA_TRY(const bool counts, isCounted(fields, modes));
    if (!counts)
        return {};
    for (std::size_t i = 0; i < 3; ++i) {
        if (isNothing(fields[m_needed[i]]))
            return wrong(m_needed[i], fields[m_needed[i]], LevelSourceText::tr("a value"));
    }
    TELETA_TRY(const double level, number(m_needed[4], fields, 0.0, -kMostLevel, kMostLevel));
    LevelTaskFacts& facts = trials.factsOf(fields[m_needed[1]]);
    TELETA_CHECK(learn(fields, facts));
    TELETA_TRY(const double reference, number(m_reference, fields, 0.0, -kMostLevel, kMostLevel));
    TELETA_TRY(std::optional<LevelTrial> trial, trialOf(fields, facts, level, reference));
    if (!trial)
        return {};
    TELETA_TRY(const double run, number(m_repetition, fields, 1.0, 1.0, 1e6));
    trial->run = facts.procedure == "constant" ? 1 : static_cast<std::size_t>(run);
    const std::string_view track = textOf(m_track, fields);
    LevelTrials::Track& kept =
        trials.trackOf({std::string(fields[m_needed[1]]), std::string(fields[m_needed[2]]),
                        track.empty() ? "all" : std::string(track), std::string(fields[m_needed[0]])});
    kept.reference = reference;
    kept.trials.push_back(*trial);
    return {};
}

} // namespace

core::Expected<void> addLevelTrials(const std::string& path, ModeFilter& modes, LevelTrials& trials,
                                    const std::function<bool(std::uint64_t)>& goOn,
                                    const std::function<bool(long long)>& isLeftOut) {
    TELETA_TRY(core::CsvReader csv, core::CsvReader::open(path));
    LevelRows rows(csv);
    TELETA_TRY(const bool hasLevels, rows.find());
    if (!hasLevels)
        return {};
    std::vector<std::string_view> fields;
    for (long long row = 0;; ++row) {
        TELETA_TRY(const bool more, csv.nextText(fields));
        if (!more)
            return {};
        if (row % kLevelRowsBetweenQuestions == 0 && !goOn(csv.bytesRead()))
            return core::failed(core::ErrorKind::cancelled, LevelSourceText::tr("interrupted"), {}, {path});
        if (!isLeftOut || !isLeftOut(row))
            TELETA_CHECK(rows.take(fields, modes, trials));
    }
}

core::Expected<bool> hasOnlyLevels(const std::string& path) {
    TELETA_TRY(const core::CsvReader csv, core::CsvReader::open(path));
    const auto has = [&](std::string_view name) {
        return std::ranges::find(csv.header(), name) != csv.header().end();
    };
    return has("level") && has("correct") && !(has("stimulus") && has("response"));
}

} // namespace teleta::study
