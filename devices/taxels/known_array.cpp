// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/known_array.h"

#include <span>
#include <utility>

namespace teleta::taxels {

frames::KnownArray knownArray(TaxelGrid grid) {
    frames::KnownArray known{
        .layout = grid.layout(), .numbers = grid.values(), .place{}, .unit = grid.unit()};
    known.place = [grid = std::move(grid)](std::span<const float> numbers, std::span<float> frame) {
        grid.place(numbers, frame);
    };
    return known;
}

} // namespace teleta::taxels
