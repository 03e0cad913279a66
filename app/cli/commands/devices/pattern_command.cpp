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

nlohmann::ordered_json toJson(const std::vector<pattern::Loss>& losses) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const pattern::Loss& loss : losses)
        all.push_back({{"kind", pattern::toString(loss.kind)},
                       {"count", loss.count},
                       {"first_s", orNull(loss.first_s)},
                       {"file", loss.where},
                       {"message", describe(loss)}});
    return all;
}

/// Says on standard error what was lost in a file.
void warnOf(const std::string& file, const std::vector<pattern::Loss>& losses) {
    for (const pattern::Loss& loss : losses)
        warn(QString::fromStdString(file + ": " + describe(loss)));
}

/// What the samples of a WAV file are.
QString wavText(const pattern::SampleOptions& samples) {
    if (samples.carrier_Hz)
        return PatternText::tr("The samples are vibrations of %1 Hz with the intensities of the pattern.")
            .arg(*samples.carrier_Hz);
    return PatternText::tr("The samples are the bare intensities, which move no voice coil: --carrier writes "
                           "vibrations.");
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
        addOption(converts, "--carrier", m_carrier_Hz,
                  PatternText::tr("WAV: vibrations of this frequency, for voice coils, instead of the bare "
                                  "intensities; 250 without a number"),
                  "HZ")
            ->expected(0, 1)
            ->default_str("250")
            ->check(between(pattern::kLowestRate_Hz, 0.5 * pattern::kHighestRate_Hz));
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
        addOption(app, "--tactors", m_tactors,
                  PatternText::tr("A file with one signal: the tactors that play it, for example 1,4; all "
                                  "without this"),
                  "LIST");
        addChoice(app, "--arm", m_arm,
                  PatternText::tr("A .tact file with both arms: the one to read; left without this"),
                  {"left", "right"});
    }

    [[nodiscard]] std::vector<std::size_t> chosenTactors() const {
        std::vector<std::size_t> tactors;
        if (m_tactors.empty())
            return tactors;
        for (const QString& number : QString::fromStdString(m_tactors).split(QLatin1Char(','))) {
            const int tactor = number.toInt();
            if (tactor < 1 || tactor > static_cast<int>(core::kTactors))
                refuse("--tactors", PatternText::tr("expected numbers from 1 to 6 between commas"));
            tactors.push_back(static_cast<std::size_t>(tactor - 1));
        }
        return tactors;
    }

    /// The pattern that m_pattern names; what its file held beyond it is said on standard error.
    [[nodiscard]] core::Expected<pattern::PatternImport> read() const {
        pattern::ImportOptions options;
        options.arm = pattern::armFrom(m_arm);
        options.tactors = chosenTactors();
        TELETA_TRY(pattern::PatternImport import, pattern::findImport(m_pattern, options));
        if (!options.tactors.empty() && !import.oneSignal)
            refuse("--tactors", PatternText::tr("it belongs to a file with one signal"));
        warnOf(m_pattern, import.losses);
        return import;
    }

    [[nodiscard]] core::Expected<Pattern> readPattern() const {
        return read().map([](pattern::PatternImport import) { return std::move(import.pattern); });
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
        TELETA_TRY(const Pattern pattern, readPattern());
        if (!m_json)
            return printPattern(pattern);
        TELETA_TRY(const std::string text, pattern::patternToJson(pattern));
        core::OutputFile output = core::OutputFile::standardOutput();
        output.write(text);
        return output.finish();
    }

    /// The pattern that m_pattern names, overdriven if --overdrive is given.
    [[nodiscard]] core::Expected<Pattern> chosenPattern(const pattern::MotorProfiles& profiles) const {
        core::Expected<Pattern> pattern = readPattern();
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
        TELETA_TRY(const Pattern pattern, readPattern());
        PlayOptions options = m_play;
        options.json = m_json;
        return playPattern(pattern, options);
    }

    [[nodiscard]] core::Expected<void> convert() const {
        TELETA_TRY(const pattern::PatternImport import, read());
        const Pattern& pattern = import.pattern;
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
        if (format != pattern::PatternFormat::wav && m_carrier_Hz)
            refuse("--carrier", PatternText::tr("it is for .wav files"));
        TELETA_TRY(const std::vector<pattern::Loss> losses, pattern::exportLosses(pattern, *format));
        pattern::SampleOptions samples;
        samples.carrier_Hz = m_carrier_Hz;
        samples.rate_Hz = m_convertRate_Hz;
        if (m_predicted)
            samples.motors = pattern::assumedMotors();
        TELETA_CHECK(pattern::savePattern(pattern, path, samples));
        warnOf(m_outPath, losses);
        if (format == pattern::PatternFormat::wav)
            warn(QString::fromStdString(m_outPath) + QStringLiteral(": ") + wavText(samples));
        if (!m_json && !toStandardOutput)
            return {};
        if (toStandardOutput) {
            QFile written(QString::fromStdString(path));
            if (!written.open(QIODevice::ReadOnly))
                return core::failed(core::ErrorKind::ioFailed, written.errorString(), {}, {path});
            return printText(written.readAll().toStdString());
        }
        return printDocument({{"id", pattern.id},
                              {"out", m_outPath},
                              {"lost_at_reading", toJson(import.losses)},
                              {"lost_at_writing", toJson(losses)}});
    }

    [[nodiscard]] core::Expected<void> check() const {
        TELETA_TRY(const Pattern pattern, readPattern());
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
    std::string m_tactors;
    std::string m_arm;
    std::optional<double> m_convertRate_Hz;
    std::optional<double> m_carrier_Hz;
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
