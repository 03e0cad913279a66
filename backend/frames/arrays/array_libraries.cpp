// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/arrays/array_libraries.h"

#include "backend/core/part.h"

namespace teleta::frames {

core::Expected<const ArrayLibraries*> arrayLibraries() {
    static const auto loaded = core::part<ArrayLibraries>("teleta_array_libraries");
    return loaded;
}

} // namespace teleta::frames
