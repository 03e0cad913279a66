// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/contact_columns.h"

#include "backend/core/data/column_unit.h"

#include <limits>

namespace teleta::contact {

std::vector<std::string> contactColumns(std::string_view loadUnit, bool vectors) {
    const std::string unit = core::columnUnit(loadUnit);
    std::vector<std::string> columns{"contact_id", "x_m", "y_m", "force_" + unit, "peak_" + unit, "area_m2"};
    if (vectors)
        columns.insert(columns.end(), {"shear_x_" + unit, "shear_y_" + unit,
                                       "moment_z_" + core::momentColumnUnit(loadUnit), "friction_ratio"});
    return columns;
}

std::vector<double> contactNumbers(const Contact& contact, bool vectors) {
    constexpr double kNotTold = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> numbers{contact.x_m, contact.y_m, contact.force_N, contact.peak_N, contact.area_m2};
    if (!vectors)
        return numbers;
    const ShearLoad shear = contact.shear.value_or(ShearLoad{kNotTold, kNotTold, kNotTold, kNotTold});
    numbers.insert(numbers.end(), {shear.x_N, shear.y_N, shear.momentZ_Nm, shear.friction});
    return numbers;
}

} // namespace teleta::contact
