// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/feature_rows.h"

#include "backend/contact/contact_columns.h"
#include "backend/recording/stream_columns.h"

#include <string_view>

namespace teleta::cli {

core::Expected<RowOutput> openRows(const std::vector<std::string>& columns, const RowOptions& options) {
    return RowOutput::open(std::vector<std::string_view>(columns.begin(), columns.end()), options);
}

std::vector<std::string> featureRowColumns(const std::string& loadUnit, bool vectors) {
    std::vector<std::string> names{"time_s"};
    for (const recording::Column& column : recording::featureColumns(loadUnit, vectors))
        names.push_back(column.name);
    return names;
}

void writeFeatures(RowOutput& rows, double time_s, const contact::TactileFeatures& features, bool vectors) {
    rows.number(time_s);
    rows.text(contact::toString(features.type));
    rows.number(features.force_N);
    for (const std::optional<double>& value :
         {features.copX_m, features.copY_m, features.cocX_m, features.cocY_m, features.dzmpX_m,
          features.dzmpY_m, features.alphaZ_rad, features.lambda1_m2, features.lambda2_m2})
        rows.number(value);
    rows.integer(features.active);
    if (!vectors)
        return;
    const std::optional<contact::ShearLoad>& shear = features.shear;
    rows.number(shear ? std::optional(shear->x_N) : std::nullopt);
    rows.number(shear ? std::optional(shear->y_N) : std::nullopt);
    rows.number(shear ? std::optional(shear->momentZ_Nm) : std::nullopt);
    rows.number(shear ? std::optional(shear->friction) : std::nullopt);
}

std::vector<std::string> contactRowColumns(const std::string& loadUnit, bool vectors) {
    std::vector<std::string> names = contact::contactColumns(loadUnit, vectors);
    names.insert(names.begin(), "time_s");
    return names;
}

void writeContact(RowOutput& rows, double time_s, const contact::Contact& contact, bool vectors) {
    rows.number(time_s);
    rows.integer(contact.id);
    for (const double value : contact::contactNumbers(contact, vectors))
        rows.number(value);
}

std::vector<std::string> withSummit(std::vector<std::string> columns, bool summit) {
    if (summit)
        columns.insert(columns.end(), {"summit_x_m", "summit_y_m", "summit_x_se_m", "summit_y_se_m"});
    return columns;
}

void writeSummit(RowOutput& rows, const std::optional<contact::Summit>& summit) {
    rows.number(summit ? std::optional(summit->x_m) : std::nullopt);
    rows.number(summit ? std::optional(summit->y_m) : std::nullopt);
    rows.number(summit ? summit->xSe_m : std::nullopt);
    rows.number(summit ? summit->ySe_m : std::nullopt);
}

} // namespace teleta::cli
