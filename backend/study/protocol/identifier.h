// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/keys/keys.h"

#include <set>
#include <string>
#include <string_view>

namespace teleta::study {

/// Describes the key of a name that may stand in file names and in identifiers of every export: letters,
/// digits, - and _, not among `used`, to which it is added. Anything else is refused.
void describeIdentifier(core::Keys& keys, std::string_view key, std::string& value,
                        std::set<std::string>& used, std::string_view about);

} // namespace teleta::study
