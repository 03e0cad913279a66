// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/feature_rows.h"

namespace teleta::cli {

void writeFeatures(RowOutput& rows, double time_s, const contact::TactileFeatures& features) {
    rows.number(time_s);
    rows.text(contact::toString(features.type));
    rows.number(features.force_N);
    for (const std::optional<double>& value :
         {features.copX_m, features.copY_m, features.cocX_m, features.cocY_m, features.dzmpX_m,
          features.dzmpY_m, features.alphaZ_rad, features.lambda1_m2, features.lambda2_m2})
        rows.number(value);
    rows.integer(features.active);
}

std::vector<std::string_view> withSummit(std::span<const std::string_view> columns, bool summit) {
    std::vector<std::string_view> all(columns.begin(), columns.end());
    if (summit)
        all.insert(all.end(), kSummitColumns.begin(), kSummitColumns.end());
    return all;
}

void writeSummit(RowOutput& rows, const std::optional<contact::Summit>& summit) {
    rows.number(summit ? std::optional(summit->x_m) : std::nullopt);
    rows.number(summit ? std::optional(summit->y_m) : std::nullopt);
    rows.number(summit ? summit->xSe_m : std::nullopt);
    rows.number(summit ? summit->ySe_m : std::nullopt);
}

} // namespace teleta::cli
