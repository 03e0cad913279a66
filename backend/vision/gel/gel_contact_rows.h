// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/gel/gel_contacts.h"

#include <array>
#include <span>
#include <string_view>

namespace teleta::vision {

/// Columns of contacts on a flat gel in CSV files.
inline constexpr std::array<std::string_view, 11> kGelContactColumns{
    "frame",           "time_s",          "contact_id",      "x_m",         "y_m",       "area_m2",
    "normal_proxy_m2", "shear_proxy_x_m", "shear_proxy_y_m", "torsion_rad", "slip_index"};

/// Writes one. Rows: a type with the members of core::CsvWriter. loads: what further columns have of it.
template <typename Rows>
void writeGelContact(Rows& rows, long long frame, double time_s, const GelContactState& contact,
                     std::span<const double> loads = {}) {
    rows.integer(frame);
    rows.number(time_s);
    rows.integer(contact.id);
    for (const double value :
         {contact.centre_m.x(), contact.centre_m.y(), contact.area_m2, contact.normalProxy_m2,
          contact.shearProxy_m.x(), contact.shearProxy_m.y(), contact.torsion_rad})
        rows.number(value);
    rows.number(contact.slipIndex);
    for (const double load : loads)
        rows.number(load);
    rows.endRow();
}

} // namespace teleta::vision
