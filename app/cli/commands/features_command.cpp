// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/features_command.h"

#include <QCoreApplication>

#include <array>

namespace teleta::cli {

QString FeaturesCommand::summary() const {
    return QCoreApplication::translate("FeaturesCommand",
                                       "Force, centres, moments and orientation of each tactile frame");
}

const char* FeaturesCommand::example() const {
    return "teleta features press.csv --tare empty.csv --rows 6 --columns 14 --out features.csv";
}

core::Expected<void> FeaturesCommand::run() {
    constexpr std::array<std::string_view, 13> kColumns{
        "time_s",   "contact_type", "force_n",     "cop_x_m",    "cop_y_m",    "coc_x_m", "coc_y_m",
        "dzmp_x_m", "dzmp_y_m",     "alpha_z_rad", "lambda1_m2", "lambda2_m2", "active"};
    contact::FeatureExtractor extractor(m_options.layout(), m_options.featureSettings());
    return processFrames(m_options, kColumns, [&extractor](const ConditionedFrame& frame, RowOutput& rows) {
        const contact::TactileFeatures features = extractor.compute(frame.load_N, frame.dead);
        rows.number(frame.time_s);
        rows.text(contact::toString(features.type));
        rows.number(features.force_N);
        rows.number(features.copX_m);
        rows.number(features.copY_m);
        rows.number(features.cocX_m);
        rows.number(features.cocY_m);
        rows.number(features.dzmpX_m);
        rows.number(features.dzmpY_m);
        rows.number(features.alphaZ_rad);
        rows.number(features.lambda1_m2);
        rows.number(features.lambda2_m2);
        rows.integer(features.active);
        rows.endRow();
    });
}

} // namespace teleta::cli
