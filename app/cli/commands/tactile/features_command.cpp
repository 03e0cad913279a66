// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/feature_rows.h"
#include "app/cli/base/frame_options.h"
#include "app/cli/commands/tactile/tactile_commands.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::cli {

namespace {

struct FeaturesCommand : FrameOptions {
    [[nodiscard]] core::Expected<void> run() const {
        TELETA_TRY(frames::FrameReader frames, openFrames(*this));
        contact::FeatureExtractor extractor(frames.layout(), featureSettings());
        return processFrames(
            *this, std::move(frames), kFeatureColumns, [&](const ConditionedFrame& frame, RowOutput& rows) {
                writeFeatures(rows, frame.time_s, extractor.compute(frame.load_N, frame.dead));
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
