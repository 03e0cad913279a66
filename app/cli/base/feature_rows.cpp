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
    rows.endRow();
}

} // namespace teleta::cli
