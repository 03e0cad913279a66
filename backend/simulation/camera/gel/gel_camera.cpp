// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/gel/gel_camera.h"

#include "backend/simulation/camera/gel/gel_stage.h"

#include <optional>
#include <utility>

namespace teleta::simulation {

namespace {

class GelCameraGenerator : public core::CameraGenerator {
public:
    GelCameraGenerator(const scene::Scene& scene, std::unique_ptr<GelStage> stage,
                       std::shared_ptr<core::SceneControl> control, std::shared_ptr<CarrierLink> link)
        : m_stage(std::move(stage))
        , m_control(std::move(control))
        , m_end_s(scene.duration_s + (link ? kCarrierPause_s : 0.0))
        , m_description{.name = scene.name, .nominalRate_Hz = scene.rate_Hz, .simulated = true} {
        if (link)
            m_carrier.emplace(std::move(link), scene.rate_Hz);
    }

    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }

    bool next(core::GreyImage& image, bool held) override {
        const bool asked = m_control && m_control->takeRestart(held);
        held = held || (m_control && m_control->isHeld());
        const bool anew = asked || (!held && m_stage->time_s() >= m_end_s);
        cv::Mat1b picture;
        if (anew) {
            m_stage->restart();
            if (m_carrier)
                m_carrier->restart();
        }
        // While it is held, an arm brakes under balls that move on; without one all stands still.
        if (anew || (held && !m_carrier))
            m_stage->again(picture);
        else
            m_stage->next(m_carrier ? m_carrier->next(held) : TubeVelocity(), picture);
        if (m_carrier)
            m_carrier->tell(m_stage->arm().pose(), held);
        image = core::greyImageOf(std::move(picture));
        ++m_frames;
        return anew;
    }

    [[nodiscard]] double time_s() const override {
        return static_cast<double>(m_frames) / m_description.nominalRate_Hz;
    }

private:
    std::unique_ptr<GelStage> m_stage;
    std::shared_ptr<core::SceneControl> m_control; ///< null: nobody's
    std::optional<CommandedCarrier> m_carrier;     ///< empty: nobody commands the arm
    double m_end_s;
    core::CameraDescription m_description;
    std::uint64_t m_frames = 0;
};

} // namespace

core::Expected<std::unique_ptr<core::CameraGenerator>>
makeGelCamera(const scene::Scene& scene, std::uint64_t seed, std::shared_ptr<core::SceneControl> control,
              std::shared_ptr<CarrierLink> link) {
    TELETA_TRY(auto stage, GelStage::make(scene, seed));
    return std::make_unique<GelCameraGenerator>(scene, std::move(stage), std::move(control), std::move(link));
}

} // namespace teleta::simulation
