// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/background.h"

namespace teleta::console {

using base::runInBackground;

} // namespace teleta::console
