// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_record.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace teleta::pipeline {

/// Where the skin feels one touch: the mean over its frames, weighted with their force. Thread: one.
struct TouchedPlace {
    /// A contact farther away is another place.
    static constexpr double kSame_m = 0.015;

    double x_m = 0.0;
    double y_m = 0.0;
    double xSe_m = 0.0; ///< the means of those of the frames: such an error does not average out
    double ySe_m = 0.0;
    double weight_N = 0.0;
    contact::ContactType type = contact::ContactType::none; ///< of the newest frame

    /// Adds a frame's contact to a touch, or begins the place anew. centreSe_m: standard error of any centre
    /// on this skin.
    static void add(std::optional<TouchedPlace>& place, const SkinContact& contact, double centreSe_m) {
        // The least force of a skin may be 0: a contact without force still has a place.
        constexpr double kLeastWeight_N = 1e-9;
        const double weight_N = std::max(contact.force_N, kLeastWeight_N);
        if (!place || std::hypot(contact.x_m - place->x_m, contact.y_m - place->y_m) > kSame_m)
            place = TouchedPlace{.x_m = contact.x_m, .y_m = contact.y_m};
        place->type = contact.type;
        place->weight_N += weight_N;
        const double share = weight_N / place->weight_N;
        place->x_m += share * (contact.x_m - place->x_m);
        place->y_m += share * (contact.y_m - place->y_m);
        place->xSe_m += share * (std::hypot(contact.xSe_m, centreSe_m) - place->xSe_m);
        place->ySe_m += share * (std::hypot(contact.ySe_m, centreSe_m) - place->ySe_m);
    }
};

} // namespace teleta::pipeline
