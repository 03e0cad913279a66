// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/tube_camera.h"

#include "backend/simulation/camera/simulated_tube.h"

#include <cmath>
#include <utility>

namespace teleta::simulation {

namespace {

/// Standard deviation of a pixel that an exact camera is told to have, so that its points have one.
constexpr double kPixelNoise_px = 0.5;

class TubeCameraGenerator : public core::CameraGenerator {
public:
    TubeCameraGenerator(const scene::Scene& scene, std::unique_ptr<SimulatedTube> tube,
                        std::shared_ptr<CarrierLink> link, std::shared_ptr<core::SceneControl> control)
        : m_tube(std::move(tube))
        , m_carrier(std::move(link), scene.rate_Hz)
        , m_control(std::move(control))
        , m_end_s(scene.duration_s + kCarrierPause_s)
        , m_description{.name = scene.name, .nominalRate_Hz = scene.rate_Hz, .simulated = true} {}

    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }

    bool next(core::GreyImage& image, bool held) override {
        cv::Mat1b frame;
        const bool asked = m_control && m_control->takeRestart(held);
        held = held || (m_control && m_control->isHeld());
        const bool anew = asked || (!held && m_tube->time_s() >= m_end_s);
        if (anew) {
            m_tube->restart();
            m_carrier.restart();
        }
        if (!m_started)
            m_tube->untouched(frame);
        else
            m_tube->next(m_carrier.next(held), frame);
        m_started = true;
        m_carrier.tell(m_tube->arm().pose(), held);
        image = core::greyImageOf(std::move(frame));
        ++m_frames;
        return anew;
    }

    [[nodiscard]] double time_s() const override {
        return static_cast<double>(m_frames) / m_description.nominalRate_Hz;
    }

private:
    std::unique_ptr<SimulatedTube> m_tube;
    CommandedCarrier m_carrier;
    std::shared_ptr<core::SceneControl> m_control; ///< null: nobody's
    double m_end_s;
    core::CameraDescription m_description;
    bool m_started = false;
    std::uint64_t m_frames = 0;
};

} // namespace

core::Expected<TubeCameraSource> makeTubeCamera(const scene::Scene& scene, std::uint64_t seed,
                                                std::shared_ptr<CarrierLink> link,
                                                std::shared_ptr<core::SceneControl> control) {
    TELETA_TRY(auto tube, SimulatedTube::make(scene, seed));
    const vision::CylinderCamera& exact = tube->camera();
    const vision::CylinderCamera camera(exact.camera(), exact.surface(), exact.covariance(), kPixelNoise_px);
    return TubeCameraSource{
        std::make_unique<TubeCameraGenerator>(scene, std::move(tube), std::move(link), std::move(control)),
        camera};
}

} // namespace teleta::simulation
