// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/cost/ladders/ladder_camera.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/vision/camera/nominal_camera.h"
#include "backend/vision/finders/contact_ladder.h"

#include <memory>
#include <numbers>

namespace teleta::cost {

namespace {

constexpr double kPressDepth_m = 0.0012;

struct TouchedFrame {
    simulation::SkinPress press;
    cv::Mat1b half; ///< the frame before, pressed half as deep; empty until a rung looks at it
    cv::Mat1b full;
    Eigen::Vector3d truth_m;
};

struct TubeFrames {
    std::unique_ptr<simulation::SimulatedTube> tube;
    cv::Mat1b reference;
    std::vector<TouchedFrame> touched;
};

/// The paper's camera with all that spoils its image.
scene::Scene tubeScene() {
    const vision::RationalDistortion lens =
        vision::nominalCamera(1640, 1232).camera().parameters().distortion;
    scene::Scene scene;
    scene.name = "contact flow";
    scene.duration_s = 1.0;
    scene.rate_Hz = 40.0;
    scene.world = scene::CameraWorld{};
    scene.effects.push_back(
        {"", scene::LensDistortionSpec{{lens.k1, lens.k2, lens.k3, lens.k4, lens.k5, lens.k6}, {}}});
    scene.effects.push_back({"", scene::MarkerPrintErrorSpec{.sd_m = 0.0001, .sizeShare = 0.05}});
    scene.effects.push_back({"", scene::UnevenLightSpec{.lamps = 8, .ripple = 0.3, .fallPerMetre = 3.0}});
    scene.effects.push_back({"", scene::VignettingSpec{.share = 0.3}});
    scene.effects.push_back({"", scene::SensorNoiseSpec{.read = 1.0, .shot = 2.5}});
    return scene;
}

/// One press in each of so many rings of the tube.
core::Expected<std::shared_ptr<TubeFrames>> renderFrames(std::size_t contacts) {
    core::Expected<std::unique_ptr<simulation::SimulatedTube>> tube =
        simulation::SimulatedTube::make(tubeScene(), 1);
    TELETA_CHECK(tube);
    auto frames = std::make_shared<TubeFrames>();
    frames->tube = std::move(*tube);
    frames->tube->untouched(frames->reference);
    core::RandomStream random(9, "contact flow ladder");
    for (std::size_t i = 0; i < contacts; ++i) {
        simulation::SkinPress press;
        press.centre = {2.0 * std::numbers::pi * random.uniform(),
                        0.005 + 0.09 * (static_cast<double>(i) + 0.5) / static_cast<double>(contacts)};
        press.ballRadius_m = 0.008 + 0.006 * random.uniform();
        TouchedFrame frame;
        press.depth_m = kPressDepth_m;
        frame.press = press;
        frames->tube->pressed({press}, frame.full);
        frame.truth_m = tubePoint_m(press.centre.angle_rad, press.centre.z_m);
        frames->touched.push_back(std::move(frame));
    }
    return frames;
}

std::string flowParameter(const vision::ContactRung& rung) {
    if (rung.method == vision::FlowMethod::dots)
        return "dots only";
    std::string text = rung.paper          ? "the paper's, 512 x 288"
                       : rung.scale == 1.0 ? "scale 1"
                       : rung.scale == 0.5 ? "scale 1/2"
                                           : "scale 1/3.2";
    if (rung.changedOnly)
        text += ", changed part";
    if (rung.warmStart)
        text += ", warm start";
    return text;
}

} // namespace

Ladder contactFlowLadder() {
    Ladder ladder;
    ladder.name = "contact-flow";
    ladder.topic = Topic::camera;
    ladder.title = LadderText::tr("Contacts in a camera frame").toStdString();
    ladder.truth =
        LadderText::tr("distance from the true contact on the tube; a contact that is missed counts with "
                       "its distance from the tube's middle")
            .toStdString();
    ladder.errorUnit = "m";
    ladder.trials = kFewestTrials;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        TELETA_TRY(const auto frames, renderFrames(kFewestTrials));
        std::vector<Rung> rungs;
        for (const vision::ContactRung& rung : vision::contactLadder()) {
            core::Expected<std::unique_ptr<vision::ContactFinder>> made =
                vision::makeContactFinder(rung, frames->tube->camera());
            TELETA_CHECK(made);
            const std::shared_ptr<vision::ContactFinder> finder = std::move(*made);
            TELETA_CHECK(finder->setReference(frames->reference));
            rungs.push_back(
                {std::string(rung.name), flowParameter(rung), [=, warm = rung.warmStart](Trial& trial) {
                     TouchedFrame& frame = frames->touched[trial.index() % frames->touched.size()];
                     finder->forget();
                     // Only a warm start knows the frame before.
                     if (warm) {
                         if (frame.half.empty()) {
                             simulation::SkinPress before = frame.press;
                             before.depth_m *= 0.5;
                             frames->tube->pressed({before}, frame.half);
                         }
                         static_cast<void>(finder->find(frame.half));
                     }
                     core::Expected<std::vector<vision::CameraContact>> found;
                     trial.timed(1, [&] { found = finder->find(frame.full); });
                     if (!found || found->empty()) {
                         trial.error((middleOfTube_m() - frame.truth_m).norm());
                         return;
                     }
                     // One ball presses: a second contact is an error of its own.
                     for (const vision::CameraContact& contact : *found)
                         trial.error((contact.p_Sensor_Centre_m - frame.truth_m).norm());
                 }});
        }
        rungs.push_back(limitRung("each pixel read once", 1, [=](std::size_t index) {
            return cv::sum(frames->touched[index % frames->touched.size()].full)[0];
        }));
        return rungs;
    };
    return ladder;
}

} // namespace teleta::cost
