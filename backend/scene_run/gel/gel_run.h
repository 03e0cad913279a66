// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene/scene.h"
#include "backend/scene_run/base/run_options.h"
#include "backend/scene_run/base/scene_summary.h"

namespace teleta::scene_run {

/// Runs a scene with a flat gel: pictures -> markers -> contacts. Nothing may touch the gel in the first
/// pictures, from which the rest is taken. Files in outFolder, beside summary.json:
///   markers.csv    as `teleta markers` writes them
///   contacts.csv   frame,time_s,contact_id,x_m,y_m,area_m2,normal_proxy_m2,shear_proxy_x_m,shear_proxy_y_m,
///                  torsion_rad,slip_index
///   truth.csv      time_s,object,touches,x_m,y_m,radius_m,drag_x_m,drag_y_m,turn_rad,slip_share
///   recording.teleta   pictures, rest and contacts, to be replayed
/// Measures:
///   marker_error_px: of the found markers, root of the mean square along one axis; markers_lost, over all
///   pictures;
///   contact_error_mean_m and contact_error_p95_m, distance from the centre of each true contact that is
///   deeper than 0.2 mm to that of the nearest one that was found, and contacts_missed without any;
///   shear_direction_error_rad, mean, while a ball has been dragged by more than 0.1 mm;
///   torsion_rad and true_turn_rad, when a ball has truly turned furthest: a proxy, smaller than the turn,
///   since the skin about the ball turns less;
///   slip_index_error, mean of |slip index - share of the contact's area that slips|;
///   incipient_slip_s and slip_s, when they were told, and true_incipient_slip_s and true_slip_s, when that
///   share first was at least 0.3 and 0.8; null: never.
/// Those of contacts, shear and slip count balls one by one, with the contact that is nearest.
[[nodiscard]] core::Expected<SceneSummary> runGelScene(const scene::Scene& scene, const RunOptions& options);

} // namespace teleta::scene_run
