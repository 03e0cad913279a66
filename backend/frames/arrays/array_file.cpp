// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/arrays/array_file.h"

namespace teleta::frames {

std::optional<std::uint64_t> valuesOf(std::span<const std::uint64_t> shape) {
    std::uint64_t count = 1;
    bool isEmpty = false;
    for (const std::uint64_t side : shape) {
        isEmpty = isEmpty || side == 0;
        if (side != 0 && count > kMostValues / side)
            return std::nullopt;
        count *= side == 0 ? 1 : side;
    }
    return isEmpty ? 0 : count;
}

std::string shapeText(std::span<const std::uint64_t> shape) {
    if (shape.empty())
        return "1";
    std::string text;
    for (const std::uint64_t side : shape)
        text += (text.empty() ? "" : " x ") + std::to_string(side);
    return text;
}

} // namespace teleta::frames
