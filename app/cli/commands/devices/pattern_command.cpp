// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/standard_streams.h"
#include "app/cli/commands/devices/devices_commands.h"
#include "app/cli/commands/devices/pattern_play.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "backend/motors/motor_file.h"
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/files/pattern_format.h"
#include "backend/pattern/files/pattern_json.h"
#include "backend/pattern/laws/law_checker.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/pattern/motors/motor_model.h"
#include "backend/pattern/motors/overdriven.h"
#include "backend/pattern/motors/sampled_output.h"

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

using pattern::Pattern;

struct PatternText {
    Q_DECLARE_TR_FUNCTIONS(PatternCommand)
};

QString taskText(pattern::Task task) {
    switch (task) {
    case pattern::Task::shape:
        return PatternText::tr("shape");
    case pattern::Task::stiffness:
        return PatternText::tr("stiffness");
    case pattern::Task::other:
        return PatternText::tr("other");
    }
    return {};
}

QString conditionText(pattern::Condition condition) {
    switch (condition) {
    case pattern::Condition::none:
        return PatternText::tr("-");
    case pattern::Condition::constant:
        return PatternText::tr("static");
    case pattern::Condition::dynamic:
        return PatternText::tr("dynamic");
    }
    return {};
}

core::Expected<void> printPattern(const Pattern& pattern) {
    QStringList tags;
    for (const std::string& tag : pattern.tags)
        tags << QString::fromStdString(tag);
    Fields fields{{PatternText::tr("Id"), QString::fromStdString(pattern.id)},
                  {PatternText::tr("Name"), QString::fromStdString(pattern.name)},
                  {PatternText::tr("Task"), taskText(pattern.task)},
                  {PatternText::tr("Condition"), conditionText(pattern.condition)},
                  {PatternText::tr("Duration"), PatternText::tr("%1 s").arg(forPeople(pattern.duration_s))},
                  {PatternText::tr("Tags"), tags.join(QStringLiteral(", "))},
                  {PatternText::tr("Objects"), QString::number(pattern.objects.size())}};
    constexpr std::size_t kMostShown = 6;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        const pattern::Track& track = pattern.tracks[i];
        QStringList points;
        for (std::size_t k = 0; k < std::min(track.size(), kMostShown); ++k)
            points
                << PatternText::tr("%1 s: %2").arg(forPeople(track[k].time_s), forPeople(track[k].intensity));
        if (track.size() > kMostShown)
            points << PatternText::tr("... (%1 breakpoints)").arg(track.size());
        fields.emplace_back(PatternText::tr("Tactor %1").arg(i + 1),
                            track.empty() ? PatternText::tr("-") : points.join(QStringLiteral(", ")));
    }
    if (!pattern.notes.empty())
        fields.emplace_back(PatternText::tr("Notes"), QString::fromStdString(pattern.notes));
    return printFields(fields);
}

nlohmann::ordered_json toJson(const Pattern& pattern, const pattern::Finding& finding) {
    nlohmann::ordered_json tactors = nlohmann::ordered_json::array();
    for (const int tactor : finding.tactors)
        tactors.push_back(tactor + 1);
    return {{"law", pattern::toString(finding.law)},
            {"object", finding.object ? nlohmann::ordered_json(*finding.object + 1) : nullptr},
            {"tactors", std::move(tactors)},
            {"begin_s", finding.span.begin_s},
            {"end_s", finding.span.end_s},
            {"value", finding.value},
            {"limit", finding.limit},
            {"message", describe(finding)},
            {"suggestion", describeFix(finding)},
            {"fixable", pattern::fixed(pattern, finding).has_value()}};
}

/// Where a finding is: an object by its number and name, or tactors.
QString placeText(const Pattern& pattern, const pattern::Finding& finding) {
    if (finding.object) {
        const QString name = QString::fromStdString(pattern.objects[*finding.object].name);
        return name.isEmpty() ? PatternText::tr("Object %1").arg(*finding.object + 1)
                              : PatternText::tr("Object %1 (%2)").arg(*finding.object + 1).arg(name);
    }
    QStringList numbers;
    for (const int tactor : finding.tactors)
        numbers << QString::number(tactor + 1);
    return PatternText::tr("Tactor %1").arg(numbers.join(QStringLiteral(", ")));
}

class PatternCommand : public CommandGroup {
public:
    void declare(CLI::App& app) {
        declareJson(
            addPart(app, "list", PatternText::tr("List the built-in patterns"), [this] { return list(); }),
            m_json);

        CLI::App& shows = addPart(app, "show", PatternText::tr("Show what a pattern consists of"),
                                  [this] { return show(); });
        takePattern(shows);
        declareJson(shows, m_json);

        CLI::App& renders =
            addPart(app, "render", PatternText::tr("Sample a pattern: rows time_s,t1..t6 over its duration"),
                    [this] { return render(); });
        takePattern(renders);
        addOption(renders, "--rate", m_rate_Hz, PatternText::tr("Samples a second"),
                  between(pattern::kLowestRate_Hz, pattern::kHighestRate_Hz), "HZ");
        addOption(renders, "-o,--csv,--out", m_outPath,
                  PatternText::tr("Write the CSV to this file, which appears when it is complete"), "OUT");
        addFlag(renders, "--predicted", m_predicted,
                PatternText::tr("What the motors will do; without --motors with an assumed motor: lag, start "
                                "and speed are not measured"));
        takeOverdrive(renders);
        takeMotors(renders);
        declareJson(renders, m_json);

        CLI::App& converts = addPart(
            app, "convert", PatternText::tr("Write a pattern in another format, chosen by the ending"),
            [this] { return convert(); });
        takePattern(converts);
        addOption(converts, "out", m_outPath,
                  PatternText::tr("File to write") + QStringLiteral(": ") +
                      QString::fromStdString(pattern::allEndings()),
                  "OUT")
            ->required();
        addOption(converts, "--format", m_format,
                  PatternText::tr("Ending that chooses the format when OUT is -, for example json"),
                  "ENDING");
        addOption(converts, "--rate", m_convertRate_Hz,
                  PatternText::tr("Samples a second of CSV (default 200) and WAV (default 8000)"), "HZ")
            ->check(between(pattern::kLowestRate_Hz, pattern::kHighestRate_Hz));
        addFlag(converts, "--predicted", m_predicted,
                PatternText::tr("CSV and WAV: what the motors will do, with an assumed motor: lag, start and "
                                "speed are not measured"));
        declareJson(converts, m_json);

        CLI::App& checks =
            addPart(app, "check", PatternText::tr("Say where a pattern breaks a law of what can be felt"),
                    [this] { return check(); });
        takePattern(checks);
        takeMotors(checks);
        declareJson(checks, m_json);

        CLI::App& plays =
            addPart(app, "play", PatternText::tr("Play a pattern on a bracelet"), [this] { return play(); });
        takePattern(plays);
        addOption(plays, "--device", m_play.device,
                  PatternText::tr("usb, simulated, or a file that describes a bracelet"), "WHICH")
            ->capture_default_str();
        takeOverdrive(plays);
        takeMotors(plays);
        addOption(plays, "--measure", m_play.measure_s,
                  PatternText::tr("Repeat it for this long, then send live setpoints for as long again, and "
                                  "print how punctual the frames were"),
                  "S")
            ->check(between(0.1, 86'400.0));
        declareJson(plays, m_json);
    }

private:
    void takePattern(CLI::App& app) {
        addOption(app, "pattern", m_pattern, PatternText::tr("Pattern file or id of a built-in pattern"), "P")
            ->required();
    }

    void takeMotors(CLI::App& app) {
        addOption(app, "--motors", m_play.motorsPath,
                  PatternText::tr("Profile of the bracelet's motors, as the page Calibrate saves it"),
                  "FILE");
    }

    void takeOverdrive(CLI::App& app) {
        addFlag(app, "--overdrive", m_play.overdrive,
                PatternText::tr(
                    "Speed the motors up with full intensity first, for as long as their profile allows"));
    }

    [[nodiscard]] core::Expected<void> list() const {
        if (m_json) {
            nlohmann::ordered_json all = nlohmann::ordered_json::array();
            for (const Pattern& pattern : pattern::builtInPatterns())
                all.push_back({{"id", pattern.id},
                               {"name", pattern.name},
                               {"task", pattern::toString(pattern.task)},
                               {"condition", pattern::toString(pattern.condition)},
                               {"duration_s", pattern.duration_s}});
            return printDocument(all);
        }
        core::OutputFile output = core::OutputFile::standardOutput();
        const auto row = [&output](const QString& id, const QString& task, const QString& condition,
                                   const QString& duration, const QString& name) {
            output.write((id.leftJustified(21) + task.leftJustified(11) + condition.leftJustified(10) +
                          duration.rightJustified(6) + QStringLiteral("  ") + name + QLatin1Char('\n'))
                             .toStdString());
        };
        row(PatternText::tr("Id"), PatternText::tr("Task"), PatternText::tr("Condition"),
            PatternText::tr("s"), PatternText::tr("Name"));
        for (const Pattern& pattern : pattern::builtInPatterns())
            row(QString::fromStdString(pattern.id), taskText(pattern.task), conditionText(pattern.condition),
                forPeople(pattern.duration_s), QString::fromStdString(pattern.name));
        return output.finish();
    }

    [[nodiscard]] core::Expected<void> show() const {
        TELETA_TRY(const Pattern pattern, pattern::findPattern(m_pattern));
        if (!m_json)
            return printPattern(pattern);
        TELETA_TRY(const std::string text, pattern::patternToJson(pattern));
        core::OutputFile output = core::OutputFile::standardOutput();
        output.write(text);
        return output.finish();
    }

    /// The pattern that m_pattern names, overdriven if --overdrive is given.
    [[nodiscard]] core::Expected<Pattern> chosenPattern(const pattern::MotorProfiles& profiles) const {
        core::Expected<Pattern> pattern = pattern::findPattern(m_pattern);
        return pattern && m_play.overdrive ? pattern::overdriven(*pattern, profiles) : pattern;
    }

    [[nodiscard]] core::Expected<void> render() const {
        TELETA_TRY(const pattern::MotorProfiles profiles, motors());
        TELETA_TRY(const Pattern pattern, chosenPattern(profiles));
        constexpr std::array<std::string_view, 7> kColumns{"time_s", "t1", "t2", "t3", "t4", "t5", "t6"};
        TELETA_TRY(RowOutput rows, RowOutput::open(kColumns, {m_json, m_outPath}));
        const auto addRow = [&](double t_s, const core::Intensities& intensities) {
            rows.number(t_s);
            for (const double intensity : intensities)
                rows.number(intensity);
            rows.endRow();
            return !rows.failed() && !interrupted();
        };
        if (m_predicted)
            pattern::forEachPredictedSample(
                pattern, profiles, m_rate_Hz,
                [&](double t_s, const core::Intensities& intensities, const core::Intensities&) {
                    return addRow(t_s, intensities);
                });
        else
            pattern::forEachSample(pattern, m_rate_Hz, addRow);
        return unlessCut(rows.finish());
    }

    /// Of --motors; assumed ones without it.
    [[nodiscard]] core::Expected<pattern::MotorProfiles> motors() const {
        if (m_play.motorsPath.empty())
            return pattern::assumedMotors();
        return teleta::motors::readMotors(m_play.motorsPath).map(&teleta::motors::MotorCalibration::profiles);
    }

    [[nodiscard]] core::Expected<void> play() const {
        TELETA_TRY(const Pattern pattern, pattern::findPattern(m_pattern));
        PlayOptions options = m_play;
        options.json = m_json;
        return playPattern(pattern, options);
    }

    [[nodiscard]] core::Expected<void> convert() const {
        TELETA_TRY(const Pattern pattern, pattern::findPattern(m_pattern));
        const bool toStandardOutput = m_outPath == kStandardOutput;
        if (toStandardOutput == m_format.empty())
            refuse("--format", PatternText::tr("it belongs to OUT as -, where it is needed"));
        // Its ending chooses the format; some formats are written to a file only.
        const QTemporaryDir folder;
        const std::string path = toStandardOutput
                                     ? folder.filePath(QStringLiteral("pattern.")).toStdString() + m_format
                                     : m_outPath;
        const std::optional<pattern::PatternFormat> format = pattern::formatOf(path);
        if (!format)
            refuse("OUT", PatternText::tr("the ending of %1 is not that of a format; expected one of %2")
                              .arg(QString::fromStdString(toStandardOutput ? m_format : m_outPath),
                                   QString::fromStdString(pattern::allEndings())));
        const bool sampled = format == pattern::PatternFormat::csv || format == pattern::PatternFormat::wav;
        if (!sampled && (m_convertRate_Hz || m_predicted))
            refuse("OUT",
                   PatternText::tr("%1 holds no samples: --rate and --predicted are for .csv and .wav files")
                       .arg(QString::fromStdString(m_outPath)));
        pattern::SampleOptions samples;
        samples.rate_Hz = m_convertRate_Hz;
        if (m_predicted)
            samples.motors = pattern::assumedMotors();
        if (auto saved = pattern::savePattern(pattern, path, samples);
            !saved || !(m_json || toStandardOutput))
            return saved;
        if (toStandardOutput) {
            QFile written(QString::fromStdString(path));
            if (!written.open(QIODevice::ReadOnly))
                return core::failed(core::ErrorKind::ioFailed, written.errorString(), {}, {path});
            return printText(written.readAll().toStdString());
        }
        return printDocument({{"id", pattern.id}, {"out", m_outPath}});
    }

    [[nodiscard]] core::Expected<void> check() const {
        TELETA_TRY(const Pattern pattern, pattern::findPattern(m_pattern));
        TELETA_TRY(const pattern::MotorProfiles profiles, motors());
        const std::vector<pattern::Finding> findings = pattern::checkLaws(pattern, profiles);
        if (m_json) {
            nlohmann::ordered_json all = nlohmann::ordered_json::array();
            for (const pattern::Finding& finding : findings)
                all.push_back(toJson(pattern, finding));
            return printDocument({{"id", pattern.id}, {"findings", std::move(all)}});
        }
        core::OutputFile output = core::OutputFile::standardOutput();
        if (findings.empty())
            output.write((PatternText::tr("%1 keeps all laws.").arg(QString::fromStdString(pattern.id)) +
                          QLatin1Char('\n'))
                             .toStdString());
        for (const pattern::Finding& finding : findings)
            output.write((PatternText::tr("%1, %2 s to %3 s: %4 %5")
                              .arg(placeText(pattern, finding), forPeople(finding.span.begin_s),
                                   forPeople(finding.span.end_s), QString::fromStdString(describe(finding)),
                                   QString::fromStdString(describeFix(finding))) +
                          QLatin1Char('\n'))
                             .toStdString());
        return output.finish();
    }

    std::string m_pattern;
    std::string m_format;
    std::string m_outPath;
    PlayOptions m_play;
    double m_rate_Hz = 200.0;
    std::optional<double> m_convertRate_Hz;
    bool m_predicted = false;
    bool m_json = false;
};

} // namespace

Command patternCommand() {
    return makeCommand<PatternCommand>(
        "pattern",
        PatternText::tr("List, show, sample, convert, check and play the patterns of the bracelet"),
        "teleta pattern render shape.A.dynamic --rate 200 --csv circle.csv");
}

} // namespace teleta::cli
