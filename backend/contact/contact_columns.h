// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"

#include <string>
#include <string_view>
#include <vector>

namespace teleta::contact {

/// Columns of the contacts of an array: contact_id,x_m,y_m,force_n,peak_n,area_m2. Of frames of vectors,
/// shear_x_n,shear_y_n,moment_z_nm,friction_ratio follow; the moment is about the contact's centre. loadUnit:
/// of the loads, stands in place of n where they are no forces. Thread: any (pure).
[[nodiscard]] std::vector<std::string> contactColumns(std::string_view loadUnit, bool vectors);

/// The numbers of a contact for these columns behind contact_id. NaN: not told. Thread: any (pure).
[[nodiscard]] std::vector<double> contactNumbers(const Contact& contact, bool vectors);

} // namespace teleta::contact
