// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/site/control_arbiter.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <random>

namespace teleta::site_link {

/// A name that no other start of a program has. Thread: any.
[[nodiscard]] inline site::BootName newBootName() {
    std::random_device random;
    site::BootName name{};
    std::ranges::generate(name, [&random] { return static_cast<std::uint8_t>(random() & 0xFFU); });
    return name;
}

/// That of a message.
template <typename Bytes>
[[nodiscard]] site::BootName bootNameOf(const Bytes& bytes) {
    site::BootName name{};
    std::copy(std::begin(bytes), std::end(bytes), name.begin());
    return name;
}

} // namespace teleta::site_link
