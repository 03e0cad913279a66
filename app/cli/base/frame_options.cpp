// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/frame_options.h"

#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/base/standard_streams.h"
#include "backend/core/data/frame_file.h"
#include "backend/equilibration/taxel_gain_file.h"

#include <QCoreApplication>

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
    TELETA_TRY(contact::ConditioningSettings settings, options.array.conditioning());
    settings.gain = options.gain;
    if (!options.gainsPath.empty()) {
        TELETA_TRY(const auto gains, equilibration::readTaxelGains(options.gainsPath, options.layout()));
        settings.taxelGain = gains.values();
    }
    return settings;
}

} // namespace

void ArrayOptions::declare(CLI::App& app) {
    const CLI::Validator side = between(1, core::ArrayLayout::kMaximumSide);
    addOption(app, "--rows", rows, FrameOptionText::tr("Rows of the array"), side);
    addOption(app, "--columns", columns, FrameOptionText::tr("Columns of the array"), side);
    addOption(app, "--pitch-mm", pitch_mm, FrameOptionText::tr("Distance of neighbouring taxels in mm"),
              positive());
    addOption(app, "--tare", tarePath,
              FrameOptionText::tr("Frames of the unloaded array; their mean is subtracted"), "FILE");
    addFlag(app, "--invert", inverted, FrameOptionText::tr("The raw values fall under load"));
    addOption(app, "--dead", dead, FrameOptionText::tr("Numbers of taxels to leave out, such as 0,17"),
              "LIST")
        ->delimiter(',')
        ->allow_extra_args(false);
}

core::Expected<contact::ConditioningSettings> ArrayOptions::conditioning() const {
    contact::ConditioningSettings settings;
    settings.inverted = inverted;
    const std::size_t taxels = layout().taxels();
    if (!dead.empty())
        settings.dead.assign(taxels, 0);
    for (const int taxel : dead) {
        if (taxel < 0 || static_cast<std::size_t>(taxel) >= taxels)
            refuse("--dead", FrameOptionText::tr("%1 is given, a taxel from 0 to %2 is expected")
                                 .arg(taxel)
                                 .arg(taxels - 1));
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
        if (!output.empty() && output != kStandardOutput &&
            std::filesystem::equivalent(input, output, missing))
            refuse(option, FrameOptionText::tr("the output would replace the input"));
    }
}

void FrameOptions::declare(CLI::App& app) {
    addOption(app, "FRAMES.csv", path,
              FrameOptionText::tr("Recorded frames: time_s,t0,t1,... with one row a frame, row-major"), "")
        ->required();
    array.declare(app);
    addOption(app, "-t,--threshold", threshold_N,
              FrameOptionText::tr("Load in N from which a taxel is in contact"), positive());
    addOption(app, "--gain", gain, FrameOptionText::tr("N per raw unit"), nonZero());
    addOption(app, "--gains", gainsPath,
              FrameOptionText::tr("Gains of the taxels, as \"teleta gains\" writes them"), "GAINS.csv");
    addFlag(app, "--weighted", weighted,
            FrameOptionText::tr("Weight the taxels with their load to find the principal axis"));
    addFlag(app, "--auto-threshold", automaticThreshold,
            FrameOptionText::tr("Find the threshold in each frame; --threshold is the least"));
    addFlag(
        app, "--active-only", activeOnly,
        FrameOptionText::tr("Force and centre of pressure over taxels in contact, not over the whole array"));
    addOption(app, "--noise-height", noiseHeight,
              FrameOptionText::tr(
                  "Summits that rise less than this share of the frame's peak are no contacts of their own"),
              between(0.0, 1.0));
    addOption(app, "--min-taxels", minimumTaxels, FrameOptionText::tr("Contacts of fewer taxels are dropped"),
              between(1, core::ArrayLayout::kMaximumSide * core::ArrayLayout::kMaximumSide));
    declareJson(app, output.json);
    declareOut(app, output.outPath);
}

contact::FeatureSettings FrameOptions::featureSettings() const {
    return {.threshold_N = threshold_N,
            .automaticThreshold = automaticThreshold,
            .orientation =
                weighted ? contact::OrientationMode::weighted : contact::OrientationMode::binarised,
            .range = activeOnly ? contact::MomentRange::active : contact::MomentRange::image};
}

contact::SegmentationSettings FrameOptions::segmentationSettings() const {
    return {.threshold_N = threshold_N, .noiseHeight = noiseHeight, .minimumTaxels = minimumTaxels};
}

core::Expected<void> processFrames(const FrameOptions& options, std::span<const std::string_view> columns,
                                   const std::function<void(const ConditionedFrame&, RowOutput&)>& write) {
    refuseToReplace(options.output.outPath,
                    std::array{options.path, options.array.tarePath, options.gainsPath});
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
    return unlessCut(rows.finish(), stopped);
}

} // namespace teleta::cli
