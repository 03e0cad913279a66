// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::base {

/// Dynamic property of widgets that only draw, such as charts and the 3-D view: where each corner of a page
/// has a control, a notice may lie over a part of them.
inline constexpr const char* kPictureProperty = "teletaPicture";

} // namespace teleta::base
