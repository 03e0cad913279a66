// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/devices/pattern_command.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/validators.h"
#include "app/cli/commands/devices/pattern_play.h"
#include "backend/core/data/output_file.h"
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

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
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
    std::vector<std::pair<QString, QString>> fields{
        {PatternText::tr("Id"), QString::fromStdString(pattern.id)},
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

} // namespace

QString PatternCommand::summary() const {
    return PatternText::tr("List, show, sample, convert, check and play the patterns of the bracelet");
}

const char* PatternCommand::example() const {
    return "teleta pattern render shape.A.dynamic --rate 200 --csv circle.csv";
}

void PatternCommand::declare(CLI::App& app) {
    const auto help = [](const char* text) { return PatternText::tr(text).toStdString(); };
    const auto part = [&](const char* name, const char* summary) {
        return app.add_subcommand(name, help(summary));
    };
    const auto takesPattern = [&](CLI::App* command) {
        command
            ->add_option(
                "pattern", m_pattern,
                help(QT_TRANSLATE_NOOP("PatternCommand", "Pattern file or id of a built-in pattern")))
            ->type_name("P")
            ->required();
    };
    const auto takesMotors = [&](CLI::App* command) {
        command
            ->add_option(
                "--motors", m_motorsPath,
                help(QT_TRANSLATE_NOOP("PatternCommand",
                                       "Profile of the bracelet's motors, as the page Calibrate saves it")))
            ->type_name("FILE");
    };
    const auto takesOverdrive = [&](CLI::App* command) {
        command->add_flag(
            "--overdrive", m_overdrive,
            help(QT_TRANSLATE_NOOP(
                "PatternCommand",
                "Speed the motors up with full intensity first, for as long as their profile allows")));
    };
    app.require_subcommand(1);

    m_list = part("list", QT_TRANSLATE_NOOP("PatternCommand", "List the built-in patterns"));
    declareJson(*m_list, m_json);

    m_show = part("show", QT_TRANSLATE_NOOP("PatternCommand", "Show what a pattern consists of"));
    takesPattern(m_show);
    declareJson(*m_show, m_json);

    m_render = part("render", QT_TRANSLATE_NOOP("PatternCommand",
                                                "Sample a pattern: rows time_s,t1..t6 over its duration"));
    takesPattern(m_render);
    m_render->add_option("--rate", m_rate_Hz, help(QT_TRANSLATE_NOOP("PatternCommand", "Samples a second")))
        ->type_name("HZ")
        ->capture_default_str()
        ->check(between(pattern::kLowestRate_Hz, pattern::kHighestRate_Hz));
    m_render
        ->add_option("--csv,--out", m_outPath,
                     help(QT_TRANSLATE_NOOP("PatternCommand",
                                            "Write the CSV to this file, which appears when it is complete")))
        ->type_name("OUT");
    m_render->add_flag(
        "--predicted", m_predicted,
        help(QT_TRANSLATE_NOOP("PatternCommand", "What the motors will do; without --motors with an assumed "
                                                 "motor: lag, start and speed are not measured")));
    takesOverdrive(m_render);
    takesMotors(m_render);
    declareJson(*m_render, m_json);

    m_convert = part("convert", QT_TRANSLATE_NOOP("PatternCommand",
                                                  "Write a pattern in another format, chosen by the ending"));
    takesPattern(m_convert);
    m_convert
        ->add_option("out", m_outPath,
                     help(QT_TRANSLATE_NOOP("PatternCommand", "File to write")) + ": " +
                         pattern::allEndings())
        ->type_name("OUT")
        ->required();
    m_convert
        ->add_option("--rate", m_convertRate_Hz,
                     help(QT_TRANSLATE_NOOP("PatternCommand",
                                            "Samples a second of CSV (default 200) and WAV (default 8000)")))
        ->type_name("HZ")
        ->check(between(pattern::kLowestRate_Hz, pattern::kHighestRate_Hz));
    m_convert->add_flag(
        "--predicted", m_predicted,
        help(QT_TRANSLATE_NOOP("PatternCommand", "CSV and WAV: what the motors will do, with an assumed "
                                                 "motor: lag, start and speed are not measured")));
    declareJson(*m_convert, m_json);

    m_check = part(
        "check", QT_TRANSLATE_NOOP("PatternCommand", "Say where a pattern breaks a law of what can be felt"));
    takesPattern(m_check);
    takesMotors(m_check);
    declareJson(*m_check, m_json);

    m_play = part("play", QT_TRANSLATE_NOOP("PatternCommand", "Play a pattern on a bracelet"));
    takesPattern(m_play);
    m_play
        ->add_option(
            "--device", m_device,
            help(QT_TRANSLATE_NOOP("PatternCommand", "usb, simulated, or a file that describes a bracelet")))
        ->type_name("WHICH")
        ->capture_default_str();
    takesOverdrive(m_play);
    takesMotors(m_play);
    m_play
        ->add_option("--measure", m_measure_s,
                     help(QT_TRANSLATE_NOOP("PatternCommand",
                                            "Repeat it for this long, then send live setpoints for as long "
                                            "again, and print how punctual the frames were")))
        ->type_name("S")
        ->check(between(0.1, 86'400.0));
    declareJson(*m_play, m_json);
}

core::Expected<void> PatternCommand::run() {
    if (m_list->parsed())
        return list();
    if (m_show->parsed())
        return show();
    if (m_render->parsed())
        return render();
    if (m_check->parsed())
        return check();
    if (m_play->parsed())
        return play();
    return convert();
}

core::Expected<void> PatternCommand::list() const {
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
    row(PatternText::tr("Id"), PatternText::tr("Task"), PatternText::tr("Condition"), PatternText::tr("s"),
        PatternText::tr("Name"));
    for (const Pattern& pattern : pattern::builtInPatterns())
        row(QString::fromStdString(pattern.id), taskText(pattern.task), conditionText(pattern.condition),
            forPeople(pattern.duration_s), QString::fromStdString(pattern.name));
    return output.finish();
}

core::Expected<void> PatternCommand::show() const {
    TELETA_TRY(const Pattern pattern, pattern::findPattern(m_pattern));
    if (!m_json)
        return printPattern(pattern);
    TELETA_TRY(const std::string text, pattern::patternToJson(pattern));
    core::OutputFile output = core::OutputFile::standardOutput();
    output.write(text);
    return output.finish();
}

core::Expected<Pattern> PatternCommand::helped(const pattern::MotorProfiles& profiles) const {
    core::Expected<Pattern> pattern = pattern::findPattern(m_pattern);
    return pattern && m_overdrive ? pattern::overdriven(*pattern, profiles) : pattern;
}

core::Expected<void> PatternCommand::render() const {
    TELETA_TRY(const pattern::MotorProfiles profiles, motors());
    TELETA_TRY(const Pattern pattern, helped(profiles));
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
        pattern::forEachPredictedSample(pattern, profiles, m_rate_Hz,
                                        [&](double t_s, const core::Intensities& intensities,
                                            const core::Intensities&) { return addRow(t_s, intensities); });
    else
        pattern::forEachSample(pattern, m_rate_Hz, addRow);
    const core::Expected<void> done = rows.finish();
    if (done && interrupted())
        return core::Unexpected(interruption());
    return done;
}

core::Expected<pattern::MotorProfiles> PatternCommand::motors() const {
    if (m_motorsPath.empty())
        return pattern::assumedMotors();
    return teleta::motors::readMotors(m_motorsPath).map(&teleta::motors::MotorCalibration::profiles);
}

core::Expected<void> PatternCommand::play() const {
    TELETA_TRY(const Pattern pattern, pattern::findPattern(m_pattern));
    return playPattern(pattern, {.device = m_device,
                                 .motorsPath = m_motorsPath,
                                 .overdrive = m_overdrive,
                                 .measure_s = m_measure_s,
                                 .json = m_json});
}

core::Expected<void> PatternCommand::convert() const {
    TELETA_TRY(const Pattern pattern, pattern::findPattern(m_pattern));
    const std::optional<pattern::PatternFormat> format = pattern::formatOf(m_outPath);
    if (!format)
        throw CLI::ValidationError(
            "OUT", PatternText::tr("the ending of %1 is not that of a format; expected one of %2")
                       .arg(QString::fromStdString(m_outPath), QString::fromStdString(pattern::allEndings()))
                       .toStdString());
    const bool sampled = format == pattern::PatternFormat::csv || format == pattern::PatternFormat::wav;
    if (!sampled && (m_convertRate_Hz || m_predicted))
        throw CLI::ValidationError(
            "OUT", PatternText::tr("%1 holds no samples: --rate and --predicted are for .csv and .wav files")
                       .arg(QString::fromStdString(m_outPath))
                       .toStdString());
    pattern::SampleOptions samples;
    samples.rate_Hz = m_convertRate_Hz;
    if (m_predicted)
        samples.motors = pattern::assumedMotors();
    if (auto saved = pattern::savePattern(pattern, m_outPath, samples); !saved || !m_json)
        return saved;
    return printDocument({{"id", pattern.id}, {"out", m_outPath}});
}

core::Expected<void> PatternCommand::check() const {
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

} // namespace teleta::cli
