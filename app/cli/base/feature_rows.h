// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command_io.h"
#include "backend/contact/contact_segmenter.h"
#include "backend/contact/summit.h"
#include "backend/contact/tactile_features.h"

#include <optional>
#include <string>
#include <vector>

namespace teleta::cli {

/// RowOutput::open() with names that are made at run time.
[[nodiscard]] core::Expected<RowOutput> openRows(const std::vector<std::string>& columns,
                                                 const RowOptions& options);

/// Columns of tactile features, a row a frame: time_s and those of recording::featureColumns().
[[nodiscard]] std::vector<std::string> featureRowColumns(const std::string& loadUnit, bool vectors);

/// The caller ends the row.
void writeFeatures(RowOutput& rows, double time_s, const contact::TactileFeatures& features, bool vectors);

/// Columns of contacts, a row a contact: time_s and those of contact::contactColumns().
[[nodiscard]] std::vector<std::string> contactRowColumns(const std::string& loadUnit, bool vectors);

/// The caller ends the row.
void writeContact(RowOutput& rows, double time_s, const contact::Contact& contact, bool vectors);

/// The columns, and those of the summit where it is asked for: summit_x_m,summit_y_m,summit_x_se_m,
/// summit_y_se_m.
[[nodiscard]] std::vector<std::string> withSummit(std::vector<std::string> columns, bool summit);

/// The caller ends the row.
void writeSummit(RowOutput& rows, const std::optional<contact::Summit>& summit);

} // namespace teleta::cli
