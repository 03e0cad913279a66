// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace teleta::core {

/// A text with *** in place of the passwords of addresses: scheme://user:PASSWORD@host and
/// ?password=PASSWORD. The texts of describe() are like that. Thread: any (pure).
[[nodiscard]] std::string withoutPasswords(std::string text);

} // namespace teleta::core
