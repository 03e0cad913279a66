// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/gel/scene_gel.h"

namespace teleta::scene_run {

vision::MarkerGelFile gelFile(const scene::Scene& scene) {
    constexpr double kMmPerM = 1000.0;
    const scene::GelSensor& sensor = scene.gel().sensor;
    vision::MarkerGelFile file;
    file.name = scene.name;
    file.polarity = sensor.bright ? vision::MarkerPolarity::bright : vision::MarkerPolarity::dark;
    file.grid = vision::MarkerGrid::rectangular;
    file.rows = sensor.rows;
    file.columns = sensor.columns;
    file.plane.mmPerPx = kMmPerM * sensor.pixel_m;
    return file;
}

} // namespace teleta::scene_run
