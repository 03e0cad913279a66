// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/taxels/taxel_frame.h"

#include <cstdint>
#include <span>

namespace teleta::contact {

/// Sets the shear of the contacts, of a frame of vectors. labels: of the frame. Thread: any (pure).
void setContactShear(TaxelFrame& frame, std::span<const std::int32_t> labels);

/// Sets the shear of the features: over the taxels that range says, empty without a contact. Thread: any
/// (pure).
void setFeatureShear(TaxelFrame& frame, MomentRange range);

} // namespace teleta::contact
