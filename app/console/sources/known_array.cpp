// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/known_array.h"

#include "devices/taxels/layout_file.h"

#include <span>
#include <utility>

namespace teleta::console {

core::Expected<frames::FrameRequest> withKnownArray(frames::FrameRequest request) {
    if (request.knownPath.empty())
        return request;
    TELETA_TRY(taxels::LayoutFile file, taxels::readLayout(request.knownPath));
    taxels::TaxelGrid& grid = file.grid;
    if (!request.threshold && grid.loadUnit() == grid.unit())
        request.threshold = file.threshold;
    request.known = {.layout = grid.layout(), .numbers = grid.values(), .place{}, .unit = grid.unit()};
    request.known->place = [grid = std::move(grid)](std::span<const float> numbers, std::span<float> frame) {
        grid.place(numbers, frame);
    };
    return request;
}

} // namespace teleta::console
