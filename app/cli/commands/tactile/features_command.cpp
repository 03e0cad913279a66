// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/feature_rows.h"
#include "app/cli/base/frame_options.h"
#include "app/cli/commands/tactile/tactile_commands.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::cli {

namespace {

struct FeaturesCommand : FrameOptions {
    [[nodiscard]] core::Expected<void> run() {
        TELETA_TRY(OpenFrames frames, openFrames(*this));
        const core::TaxelLayout taxels = frames.reader.taxels();
        const bool vectors = taxels.isVector();
        const auto columns = withSummit(featureRowColumns(frames.loadUnit, vectors), summit);
        if (!frames.isGridOfLoads())
            return analyseFrames(*this, std::move(frames), columns,
                                 [&](double time_s, const contact::TaxelFrame& frame, RowOutput& rows) {
                                     writeFeatures(rows, time_s, frame.features, vectors);
                                     rows.endRow();
                                 });
        const core::ArrayLayout layout = taxels.grid();
        contact::FeatureExtractor extractor(layout, featureSettings());
        return processFrames(
            *this, std::move(frames), columns, [&](const ConditionedFrame& frame, RowOutput& rows) {
                const contact::TactileFeatures features = extractor.compute(frame.load_N, frame.dead);
                writeFeatures(rows, frame.time_s, features, false);
                if (summit)
                    writeSummit(rows, contact::summitOf(frame.load_N, layout, features.threshold_N,
                                                        frame.dead, noise_N));
                rows.endRow();
            });
    }
};

} // namespace

Command featuresCommand() {
    return makeCommand<FeaturesCommand>(
        "features",
        QCoreApplication::translate("FeaturesCommand",
                                    "Force, centres, moments and orientation of each tactile frame"),
        "teleta simulate tactile-indenter --out run\n"
        "  teleta features run/frames.csv --threshold 0.3 --out features.csv");
}

} // namespace teleta::cli
