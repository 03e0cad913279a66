// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/known_array.h"

#include "devices/taxels/known_array.h"
#include "devices/taxels/layout_file.h"

#include <utility>

namespace teleta::console {

core::Expected<frames::FrameRequest> withKnownArray(frames::FrameRequest request) {
    if (request.knownPath.empty())
        return request;
    TELETA_TRY(taxels::LayoutFile file, taxels::readLayout(request.knownPath));
    if (!request.threshold && file.grid.loadUnit() == file.grid.unit())
        request.threshold = file.threshold;
    request.known = taxels::knownArray(std::move(file.grid));
    return request;
}

} // namespace teleta::console
