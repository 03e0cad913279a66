// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/finders/contact_ladder.h"

#include "backend/vision/finders/dot_contact_finder.h"
#include "backend/vision/finders/flow_contact_finder.h"
#include "backend/vision/finders/vision_text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace teleta::vision {

namespace {

constexpr double kPaperScale = 1.0 / 3.2;

constexpr std::array kLadder{
    ContactRung{.name = "dots"},
    ContactRung{.name = "paper", .method = FlowMethod::disMedium, .scale = kPaperScale, .paper = true},
    ContactRung{.name = "ultrafast-3.2", .method = FlowMethod::disUltrafast, .scale = kPaperScale},
    ContactRung{.name = "fast-3.2", .method = FlowMethod::disFast, .scale = kPaperScale},
    ContactRung{.name = "medium-3.2", .method = FlowMethod::disMedium, .scale = kPaperScale},
    ContactRung{.name = "ultrafast-2", .method = FlowMethod::disUltrafast, .scale = 0.5},
    ContactRung{.name = "fast-2", .method = FlowMethod::disFast, .scale = 0.5},
    ContactRung{.name = "medium-2", .method = FlowMethod::disMedium, .scale = 0.5},
    ContactRung{.name = "ultrafast-1", .method = FlowMethod::disUltrafast},
    ContactRung{.name = "fast-1", .method = FlowMethod::disFast},
    ContactRung{.name = "medium-1", .method = FlowMethod::disMedium},
    ContactRung{.name = "fast-2-changed", .method = FlowMethod::disFast, .scale = 0.5, .changedOnly = true},
    ContactRung{.name = "fast-2-warm", .method = FlowMethod::disFast, .scale = 0.5, .warmStart = true},
};

} // namespace

std::span<const ContactRung> contactLadder() {
    return kLadder;
}

const ContactRung* contactRung(std::string_view name) {
    const auto found = std::ranges::find(kLadder, name, &ContactRung::name);
    return found == kLadder.end() ? nullptr : &*found;
}

core::Expected<std::unique_ptr<ContactFinder>> makeContactFinder(const ContactRung& rung,
                                                                 const CylinderCamera& camera,
                                                                 const ContactSettings& settings,
                                                                 std::stop_token stop) {
    if (rung.method != FlowMethod::dots)
        return withoutExceptions(
            [&] { return FlowContactFinder::make(rung, camera, settings, std::move(stop)); });
    constexpr int kSmallest_px = 64;
    if (std::min(camera.camera().parameters().width_px, camera.camera().parameters().height_px) <
        kSmallest_px)
        return refused(VisionText::tr("The image is too small to show printed dots: %1 x %2 pixels.")
                           .arg(camera.camera().parameters().width_px)
                           .arg(camera.camera().parameters().height_px),
                       VisionText::tr("at least %1 pixels on each side").arg(kSmallest_px));
    return std::make_unique<DotContactFinder>(camera, settings, std::move(stop));
}

} // namespace teleta::vision
