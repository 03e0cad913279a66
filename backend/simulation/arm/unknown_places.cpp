// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/unknown_places.h"

#include "backend/core/random_stream.h"

#include <cstddef>
#include <utility>

namespace teleta::simulation {

std::vector<scene::ArmObject> drawPlaces(const scene::ArmWorld& world, std::uint64_t seed) {
    std::vector<scene::ArmObject> objects = world.objects;
    const scene::UnknownPlaces& unknown = world.unknown;
    core::RandomStream random(seed, "unknown_places");
    if (unknown.swap) {
        for (std::size_t i = objects.size(); i > 1; --i) {
            scene::ArmObject& a = objects[i - 1];
            scene::ArmObject& b = objects[random.below(i)];
            std::swap(a.x_m, b.x_m);
            std::swap(a.y_m, b.y_m);
        }
    }
    const auto within = [&random](double range) { return range * (2.0 * random.uniform() - 1.0); };
    if (unknown.spread_m > 0.0) {
        for (scene::ArmObject& object : objects) {
            object.x_m += within(unknown.spread_m);
            object.y_m += within(unknown.spread_m);
        }
    }
    if (unknown.turn_rad > 0.0) {
        for (scene::ArmObject& object : objects)
            object.angle_rad += within(unknown.turn_rad);
    }
    return objects;
}

} // namespace teleta::simulation
