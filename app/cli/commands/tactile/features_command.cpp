// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/tactile/features_command.h"

#include "app/cli/base/feature_rows.h"

#include <QCoreApplication>

namespace teleta::cli {

QString FeaturesCommand::summary() const {
    return QCoreApplication::translate("FeaturesCommand",
                                       "Force, centres, moments and orientation of each tactile frame");
}

const char* FeaturesCommand::example() const {
    return "teleta simulate tactile-indenter --out run\n"
           "  teleta features run/frames.csv --threshold 0.3 --out features.csv";
}

core::Expected<void> FeaturesCommand::run() {
    contact::FeatureExtractor extractor(m_options.layout(), m_options.featureSettings());
    return processFrames(m_options, kFeatureColumns,
                         [&extractor](const ConditionedFrame& frame, RowOutput& rows) {
                             writeFeatures(rows, frame.time_s, extractor.compute(frame.load_N, frame.dead));
                         });
}

} // namespace teleta::cli
