// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "backend/contact/tactile_features.h"
#include "backend/core/data/taxel_layout.h"

#include <cstdint>
#include <vector>

namespace teleta::contact {

/// What was found in a frame of any layout.
struct TaxelFrame {
    core::TaxelLayout layout;
    std::vector<float> load_N;   ///< what presses, layout.taxels() entries
    std::vector<float> shearX_N; ///< along the surface, of a layout of vectors; otherwise empty
    std::vector<float> shearY_N;
    std::vector<std::uint8_t> dead;   ///< also where the layout has no taxel
    std::vector<std::int32_t> labels; ///< region of each taxel; 0 none
    std::vector<Contact> contacts;
    TactileFeatures features;
};

} // namespace teleta::contact
