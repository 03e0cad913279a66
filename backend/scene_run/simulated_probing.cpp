// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/simulated_probing.h"

#include "backend/vision/contacts/contact_ladder.h"
#include "backend/vision/nominal_camera.h"

#include <utility>

namespace teleta::scene_run {

core::Expected<std::unique_ptr<SimulatedProbing>> SimulatedProbing::make(const scene::Scene& scene,
                                                                         std::uint64_t seed) {
    auto tube = simulation::SimulatedTube::make(scene, seed);
    if (!tube)
        return core::Unexpected(tube.error());
    if (!(*tube)->probing())
        return core::Unexpected(
            core::Error{core::ErrorKind::badInput, "nobody probes the tube in this scene", {}, {}});
    std::unique_ptr<SimulatedProbing> probing(new SimulatedProbing);
    probing->m_tube = std::move(*tube);
    probing->m_tube->untouched(probing->m_reference);
    const vision::CalibrationSettings settings = probing->settings();
    auto finder = vision::makeContactFinder(
        vision::contactLadder().front(),
        vision::nominalCamera(settings.width_px, settings.height_px, settings.surface));
    if (!finder)
        return core::Unexpected(finder.error());
    if (auto taken = (*finder)->setReference(probing->m_reference); !taken)
        return core::Unexpected(taken.error());
    probing->m_finder = std::move(*finder);
    return probing;
}

vision::CalibrationSettings SimulatedProbing::settings() const {
    const vision::CylinderCamera& truth = m_tube->camera();
    const vision::CameraParameters& image = truth.camera().parameters();
    return {image.width_px, image.height_px, truth.surface()};
}

std::optional<SimulatedProbing::Taken> SimulatedProbing::next() {
    m_tube->next({}, m_frame);
    // Each frame by itself: with a camera that is only about right some dots at the far end are taken for
    // others, and would wander off from frame to frame.
    m_finder->forget();
    const auto contacts = m_finder->find(m_frame);
    if (!contacts) {
        m_collector.skip();
        ++m_unusable;
        return std::nullopt;
    }
    const auto pixel = m_collector.next(*contacts, m_tube->time_s());
    if (!pixel)
        return std::nullopt;
    const std::size_t hole = plan().holeAt(m_tube->time_s());
    return Taken{{*pixel, plan().holes()[hole].p_Sensor_Noted_m}, hole};
}

} // namespace teleta::scene_run
