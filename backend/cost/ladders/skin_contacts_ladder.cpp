// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/contact_segmenter.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/contact/summit.h"
#include "backend/core/random_stream.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"
#include "backend/simulation/array/foundation_contact.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>

namespace teleta::cost {

namespace {

using Centre = Eigen::Vector2d;

constexpr core::ArrayLayout kPatch{.rows = 10, .columns = 25, .pitchX_m = 0.01};
constexpr std::size_t kPatches = 40;
constexpr std::size_t kFrames = 32;
/// Every fourth patch is touched, by two balls or the side of a cylinder, by turns.
constexpr std::size_t kTouchedEach = 4;
constexpr std::size_t kTwiceEach = 8;
constexpr double kSkinStiffness_NPerM = 1200.0;
constexpr double kNoise_N = 0.05;

/// The skin of a body in one frame.
struct SkinFrame {
    std::vector<float> raw;                    ///< patch by patch
    std::vector<std::vector<Centre>> bodies_m; ///< middles of what presses, of each patch
};

/// Two balls are near enough that their contacts run into each other, and far enough for a valley between.
std::vector<Centre> drawBodies(core::RandomStream& random, std::size_t count) {
    constexpr double kNearest_m = 0.028;
    constexpr double kFarthest_m = 0.04;
    const double margin_m = 3.0 * kPatch.pitchX_m;
    const Centre first((random.uniform() - 0.5) * (kPatch.pitchX_m * kPatch.columns - 2.0 * margin_m),
                       (random.uniform() - 0.5) * (kPatch.pitchX_m * kPatch.rows - 2.0 * margin_m));
    std::vector<Centre> bodies_m{first};
    if (count > 1) {
        // Towards the middle of the patch's length, where there is room.
        const double apart_m = std::lerp(kNearest_m, kFarthest_m, random.uniform());
        bodies_m.emplace_back(first.x() + (first.x() < 0.0 ? apart_m : -apart_m), first.y());
    }
    return bodies_m;
}

std::vector<SkinFrame> drawFrames() {
    core::RandomStream random(1, "skin contacts ladder");
    simulation::FoundationContact foundation(kPatch, kSkinStiffness_NPerM);
    std::vector<double> load_N(kPatch.taxels());
    std::vector<SkinFrame> frames(kFrames);
    for (SkinFrame& frame : frames) {
        for (std::size_t patch = 0; patch < kPatches; ++patch) {
            std::vector<Centre> bodies_m;
            if (patch % kTouchedEach == 0)
                bodies_m = drawBodies(random, patch % kTwiceEach == 0 ? 2 : 1);
            std::vector<simulation::RigidIndenter> indenters;
            for (const Centre& body_m : bodies_m) {
                indenters.emplace_back(bodies_m.size() > 1
                                           ? scene::IndenterShape(scene::Sphere{0.05})
                                           : scene::IndenterShape(scene::Cylinder{0.03, 0.05}));
                indenters.back().moveTo({body_m.x(), body_m.y(), 0.0015 + 0.001 * random.uniform(),
                                         std::numbers::pi * random.uniform()});
            }
            std::vector<simulation::IndenterLoad> loads(indenters.size());
            foundation.press(indenters, load_N, loads);
            for (const double load : load_N)
                frame.raw.push_back(static_cast<float>(load + kNoise_N * random.normal()));
            frame.bodies_m.push_back(std::move(bodies_m));
        }
    }
    return frames;
}

/// Without any other the distance from the patch's middle.
double nearest_m(const Centre& place_m, const std::vector<Centre>& others_m) {
    double nearest = others_m.empty() ? place_m.norm() : std::numeric_limits<double>::infinity();
    for (const Centre& other_m : others_m)
        nearest = std::min(nearest, (other_m - place_m).norm());
    return nearest;
}

Rung skinRung(std::string name, std::string parameter,
              const std::shared_ptr<const std::vector<SkinFrame>>& frames,
              const contact::SegmentationSettings& settings, bool summits) {
    const auto segmenters = std::make_shared<std::vector<contact::ContactSegmenter>>(
        kPatches, contact::ContactSegmenter(kPatch, settings));
    const auto run = [=](Trial& trial) {
        const SkinFrame& frame = (*frames)[trial.index() % frames->size()];
        const contact::FrameConditioner conditioner(kPatch.taxels(), {});
        std::vector<float> load_N(kPatch.taxels());
        std::vector<std::uint8_t> dead(kPatch.taxels());
        std::vector<std::vector<Centre>> found_m(kPatches);
        trial.timed(1, [&] {
            for (std::size_t patch = 0; patch < kPatches; ++patch) {
                conditioner.apply(std::span(frame.raw).subspan(patch * kPatch.taxels(), kPatch.taxels()),
                                  load_N, dead);
                contact::ContactSegmenter& segmenter = (*segmenters)[patch];
                for (const contact::Contact& contact : segmenter.segment(load_N, dead)) {
                    const auto summit =
                        summits ? contact::summitOf(load_N, kPatch, segmenter, contact, dead) : std::nullopt;
                    found_m[patch].push_back(summit ? Centre(summit->x_m, summit->y_m)
                                                    : Centre(contact.x_m, contact.y_m));
                }
            }
        });
        for (std::size_t patch = 0; patch < kPatches; ++patch) {
            for (const Centre& body_m : frame.bodies_m[patch])
                trial.error(nearest_m(body_m, found_m[patch]));
            for (const Centre& contact_m : found_m[patch])
                trial.error(nearest_m(contact_m, frame.bodies_m[patch]));
        }
    };
    return {std::move(name), std::move(parameter), run};
}

} // namespace

Ladder skinContactsLadder() {
    Ladder ladder;
    ladder.name = "skin-contacts";
    ladder.topic = Topic::tactileArray;
    ladder.title = LadderText::tr("Contacts on the skin of a whole body").toStdString();
    ladder.truth =
        LadderText::tr(
            "distance of each body from the nearest contact of its patch, and of each contact from the "
            "nearest body; from the patch's middle where there is none")
            .toStdString();
    ladder.errorUnit = "m";
    ladder.trials = 64;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        const auto frames = std::make_shared<const std::vector<SkinFrame>>(drawFrames());
        const contact::SegmentationSettings usual;
        contact::SegmentationSettings connected = usual;
        connected.noiseHeight = 1.0;
        contact::SegmentationSettings all = usual;
        all.noiseHeight = 0.0;
        contact::SegmentationSettings large = usual;
        large.minimumTaxels = 3;
        const auto rung = [&](const char* name, const char* parameter,
                              const contact::SegmentationSettings& settings,
                              bool summits) { return skinRung(name, parameter, frames, settings, summits); };
        return std::vector<Rung>{
            rung("connected", "taxels that touch are one contact", connected, false),
            rung("every-summit", "a contact at every summit", all, false),
            rung("watershed", "summits that rise by 30 %", usual, false),
            rung("watershed-3-taxels", "the same, of 3 taxels and more", large, false),
            rung("watershed-3-summit", "the same, at the summit of a paraboloid", large, true),
            limitRung("each taxel of the skin read once", 4, [=](std::size_t index) {
                const std::vector<float>& raw = (*frames)[index % frames->size()].raw;
                return static_cast<double>(std::accumulate(raw.begin(), raw.end(), 0.0F));
            })};
    };
    return ladder;
}

} // namespace teleta::cost
