// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/pattern_map.h"

#include <algorithm>

namespace teleta::pattern {

namespace {

const std::string kNothing;

} // namespace

PatternMap PatternMap::defaults() {
    return {{"stiffness.A.dynamic", "stiffness.B.dynamic", "stiffness.C.dynamic", "stiffness.D.dynamic",
             "stiffness.E.dynamic"},
            {"shape.A.dynamic", "shape.B.dynamic", "shape.C.dynamic", "shape.D.dynamic", "shape.E.dynamic",
             "shape.F.dynamic", ""},
            "stiffness.unknown"};
}

const std::string& PatternMap::ofStiffness(int level) const {
    return level >= 1 && level <= static_cast<int>(stiffness.size())
               ? stiffness[static_cast<std::size_t>(level - 1)]
               : kNothing;
}

const std::string& PatternMap::ofShape(std::string_view name) const {
    const auto found = std::ranges::find(kRecognisedShapes, name);
    return found == kRecognisedShapes.end()
               ? kNothing
               : shape[static_cast<std::size_t>(found - kRecognisedShapes.begin())];
}

} // namespace teleta::pattern
