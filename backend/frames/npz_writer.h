// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace teleta::frames {

/// One array of numbers for an npz file, in C order.
struct NpzArray {
    /// shape: its product is the number of values; empty for a single one.
    NpzArray(std::string name, std::vector<std::uint64_t> shape, std::span<const float> values);
    NpzArray(std::string name, std::vector<std::uint64_t> shape, std::span<const double> values);
    NpzArray(std::string name, std::vector<std::uint64_t> shape, std::span<const std::int64_t> values);

    std::string name;
    std::string head; ///< of the npy file
    std::span<const std::byte> values;
};

/// Writes an npz file as numpy.savez does: a zip archive of stored npy files. It gets its name when it is
/// complete, and replaces a file of this name. Error: ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writeNpz(const std::string& path, std::span<const NpzArray> arrays);

} // namespace teleta::frames
