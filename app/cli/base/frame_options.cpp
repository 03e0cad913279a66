// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/frame_options.h"

#include "app/cli/base/interruption.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/base/validators.h"
#include "backend/core/data/frame_file.h"
#include "backend/equilibration/taxel_gain_file.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>

#include <array>
#include <filesystem>
#include <utility>

namespace teleta::cli {

namespace {

struct FrameOptionText {
    Q_DECLARE_TR_FUNCTIONS(FrameOptionText)
};

/// What the options say of the array and its taxels.
core::Expected<contact::ConditioningSettings> conditioning(const FrameOptions& options) {
    core::Expected<contact::ConditioningSettings> settings = options.array.conditioning();
    if (!settings)
        return settings;
    settings->gain = options.gain;
    if (!options.gainsPath.empty()) {
        TELETA_TRY(const auto gains, equilibration::readTaxelGains(options.gainsPath, options.layout()));
        settings->taxelGain = gains.values();
    }
    return settings;
}

} // namespace

void ArrayOptions::declare(CLI::App& app) {
    constexpr int kSide = core::ArrayLayout::kMaximumSide;
    app.add_option("--rows", rows, FrameOptionText::tr("Rows of the array").toStdString())
        ->check(between(1, kSide))
        ->capture_default_str();
    app.add_option("--columns", columns, FrameOptionText::tr("Columns of the array").toStdString())
        ->check(between(1, kSide))
        ->capture_default_str();
    app.add_option("--pitch-mm", pitch_mm,
                   FrameOptionText::tr("Distance of neighbouring taxels in mm").toStdString())
        ->check(positive())
        ->capture_default_str();
    app.add_option(
           "--tare", tarePath,
           FrameOptionText::tr("Frames of the unloaded array; their mean is subtracted").toStdString())
        ->type_name("FILE");
    app.add_flag("--invert", inverted, FrameOptionText::tr("The raw values fall under load").toStdString());
    app.add_option("--dead", dead,
                   FrameOptionText::tr("Numbers of taxels to leave out, such as 0,17").toStdString())
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("LIST");
}

core::Expected<contact::ConditioningSettings> ArrayOptions::conditioning() const {
    contact::ConditioningSettings settings;
    settings.inverted = inverted;
    const std::size_t taxels = layout().taxels();
    if (!dead.empty())
        settings.dead.assign(taxels, 0);
    for (const int taxel : dead) {
        if (taxel < 0 || static_cast<std::size_t>(taxel) >= taxels)
            throw CLI::ValidationError("--dead",
                                       FrameOptionText::tr("%1 is given, a taxel from 0 to %2 is expected")
                                           .arg(taxel)
                                           .arg(taxels - 1)
                                           .toStdString());
        settings.dead[static_cast<std::size_t>(taxel)] = 1;
    }
    if (!tarePath.empty()) {
        TELETA_TRY(std::vector<float> tare, core::readTare(tarePath, layout()));
        settings.tare = std::move(tare);
    }
    return settings;
}

void refuseToReplace(const std::string& output, std::span<const std::string> inputs, const char* option) {
    for (const std::string& input : inputs) {
        std::error_code missing;
        if (!output.empty() && std::filesystem::equivalent(input, output, missing))
            throw CLI::ValidationError(
                option, FrameOptionText::tr("the output would replace the input").toStdString());
    }
}

void FrameOptions::declare(CLI::App& app) {
    app.add_option("FRAMES.csv", path,
                   FrameOptionText::tr("Recorded frames: time_s,t0,t1,... with one row a frame, row-major")
                       .toStdString())
        ->type_name("")
        ->required();
    array.declare(app);
    app.add_option("--threshold", threshold_N,
                   FrameOptionText::tr("Load in N from which a taxel is in contact").toStdString())
        ->check(positive())
        ->capture_default_str();
    app.add_option("--gain", gain, FrameOptionText::tr("N per raw unit").toStdString())
        ->check(nonZero())
        ->capture_default_str();
    app.add_option("--gains", gainsPath,
                   FrameOptionText::tr("Gains of the taxels, as \"teleta gains\" writes them").toStdString())
        ->type_name("GAINS.csv");
    app.add_flag(
        "--weighted", weighted,
        FrameOptionText::tr("Weight the taxels with their load to find the principal axis").toStdString());
    app.add_flag(
        "--auto-threshold", automaticThreshold,
        FrameOptionText::tr("Find the threshold in each frame; --threshold is the least").toStdString());
    app.add_flag(
        "--active-only", activeOnly,
        FrameOptionText::tr("Force and centre of pressure over taxels in contact, not over the whole array")
            .toStdString());
    app.add_option(
           "--noise-height", noiseHeight,
           FrameOptionText::tr(
               "Summits that rise less than this share of the frame's peak are no contacts of their own")
               .toStdString())
        ->check(between(0.0, 1.0))
        ->capture_default_str();
    app.add_option("--min-taxels", minimumTaxels,
                   FrameOptionText::tr("Contacts of fewer taxels are dropped").toStdString())
        ->check(between(1, core::ArrayLayout::kMaximumSide * core::ArrayLayout::kMaximumSide))
        ->capture_default_str();
    declareJson(app, output.json);
    declareOut(app, output.outPath);
}

contact::FeatureSettings FrameOptions::featureSettings() const {
    contact::FeatureSettings settings;
    settings.threshold_N = threshold_N;
    settings.automaticThreshold = automaticThreshold;
    settings.orientation =
        weighted ? contact::OrientationMode::weighted : contact::OrientationMode::binarised;
    settings.range = activeOnly ? contact::MomentRange::active : contact::MomentRange::image;
    return settings;
}

contact::SegmentationSettings FrameOptions::segmentationSettings() const {
    contact::SegmentationSettings settings;
    settings.threshold_N = threshold_N;
    settings.noiseHeight = noiseHeight;
    settings.minimumTaxels = minimumTaxels;
    return settings;
}

core::Expected<void> processFrames(const FrameOptions& options, std::span<const std::string_view> columns,
                                   const std::function<void(const ConditionedFrame&, RowOutput&)>& write) {
    const std::array inputs{options.path, options.array.tarePath, options.gainsPath};
    refuseToReplace(options.output.outPath, inputs);
    TELETA_TRY(contact::ConditioningSettings settings, conditioning(options));
    TELETA_TRY(core::FrameFile file, core::FrameFile::open(options.path, options.layout()));
    TELETA_TRY(RowOutput rows, RowOutput::open(columns, options.output));

    const std::size_t taxels = options.layout().taxels();
    const contact::FrameConditioner conditioner(taxels, std::move(settings));
    std::vector<float> raw(taxels);
    std::vector<float> load_N(taxels);
    std::vector<std::uint8_t> dead(taxels);
    double time_s = 0.0;
    const auto total = static_cast<double>(file.bytesTotal());
    ProgressBar progress(ProgressBar::Unit::bytes, rows.onTerminal());
    bool stopped = false;
    while (!(stopped = interrupted()) && !rows.failed()) {
        const core::Expected<bool> any = file.next(time_s, raw);
        if (!any) {
            stopped = any.error().kind == core::ErrorKind::cancelled;
            if (stopped)
                break;
            rows.flush();
            return core::Unexpected(any.error());
        }
        if (!*any)
            break;
        conditioner.apply(raw, load_N, dead);
        write({time_s, load_N, dead}, rows);
        rows.flushIfDue();
        progress.update(static_cast<double>(file.offset()), total);
    }
    const core::Expected<void> finished = rows.finish();
    if (finished && stopped)
        return core::Unexpected(interruption());
    return finished;
}

} // namespace teleta::cli
