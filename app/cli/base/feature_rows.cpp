// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/feature_rows.h"

namespace teleta::cli {

void writeFeatures(RowOutput& rows, double time_s, const contact::TactileFeatures& features) {
    rows.number(time_s);
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
}

} // namespace teleta::cli
