// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/contacts/contact_identities.h"

#include <array>
#include <optional>
#include <string_view>

namespace teleta::vision {

/// Columns of tracked contacts in CSV files.
inline constexpr std::array<std::string_view, 13> kContactColumns{
    "frame", "time_s", "contact_id", "u_px", "v_px",    "x_m",  "y_m",
    "z_m",   "dx_m",   "dy_m",       "dz_m", "area_px", "event"};

/// Writes one contact of a frame. Rows: a type with the members of core::CsvWriter. bumped: identity of the
/// contact that bumps in this frame, or 0. Column event: "begin", "bump" (also in the frame in which it
/// begins), "end" (with the place where it was last seen), otherwise NA.
template <typename Rows>
void writeContact(Rows& rows, long long frame, double time_s, const FollowedContact& followed, int bumped) {
    const CameraContact& contact = followed.contact;
    rows.integer(frame);
    rows.number(time_s);
    rows.integer(contact.id);
    rows.number(contact.centre_px.x());
    rows.number(contact.centre_px.y());
    for (const double coordinate : contact.p_Sensor_Centre_m)
        rows.number(coordinate);
    for (const double coordinate : followed.displacement_m())
        rows.number(coordinate);
    rows.number(contact.area_px);
    if (bumped == contact.id)
        rows.text("bump");
    else if (followed.event == ContactEvent::begins)
        rows.text("begin");
    else if (followed.event == ContactEvent::ends)
        rows.text("end");
    else
        rows.number(std::optional<double>());
    rows.endRow();
}

} // namespace teleta::vision
