// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/camera/simulated_probing.h"

#include <utility>

namespace teleta::scene_run {

core::Expected<std::unique_ptr<SimulatedProbing>> SimulatedProbing::make(const scene::Scene& scene,
                                                                         std::uint64_t seed) {
    TELETA_TRY(auto tube, simulation::SimulatedTube::make(scene, seed));
    if (!tube->probing())
        return core::Unexpected(
            core::Error{core::ErrorKind::badInput, "nobody probes the tube in this scene", {}, {}});
    std::unique_ptr<SimulatedProbing> probing(new SimulatedProbing);
    probing->m_tube = std::move(tube);
    probing->m_tube->untouched(probing->m_reference);
    TELETA_TRY(probing->m_watcher, vision::ProbeWatcher::make(probing->settings()));
    TELETA_CHECK(probing->m_watcher->setReference(probing->m_reference));
    return probing;
}

vision::CalibrationSettings SimulatedProbing::settings() const {
    const vision::CylinderCamera& truth = m_tube->camera();
    const vision::CameraParameters& image = truth.camera().parameters();
    return {image.width_px, image.height_px, truth.surface()};
}

std::optional<SimulatedProbing::Taken> SimulatedProbing::next() {
    m_tube->next({}, m_frame);
    const auto pixel = m_watcher->next(m_frame, m_tube->time_s());
    if (!pixel)
        return std::nullopt;
    const std::size_t hole = plan().holeAt(m_tube->time_s());
    return Taken{{*pixel, plan().holes()[hole].p_Sensor_Noted_m}, hole};
}

} // namespace teleta::scene_run
