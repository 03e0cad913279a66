// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace teleta::frames {

/// The most values that one array may have: 2^31.
inline constexpr std::uint64_t kMostValues = std::uint64_t{1} << 31U;

/// One array of a file, before its values are read.
struct ArrayHead {
    std::string name; ///< empty: the only one of a file that names none
    std::vector<std::uint64_t> shape{};
    bool isColumnMajor = false;      ///< the first index is the quickest one
    std::string type{};              ///< as the file calls it
    std::string problem{};           ///< why it cannot be read, translated; empty: it can
    bool axisIsOpen = false;         ///< no custom says which dimension counts the frames
    std::string unit{};              ///< of the values; empty: not told
    std::optional<double> rate_Hz{}; ///< as the file says, whatever it is worth
    std::optional<double> pitch_m{};
};

/// The product of a shape; empty: more than kMostValues. Thread: any (pure).
[[nodiscard]] std::optional<std::uint64_t> valuesOf(std::span<const std::uint64_t> shape);

/// "2000 x 6 x 14". Thread: any (pure).
[[nodiscard]] std::string shapeText(std::span<const std::uint64_t> shape);

/// A file of named arrays of numbers. Thread: one.
class ArrayFile {
public:
    virtual ~ArrayFile() = default;
    ArrayFile(const ArrayFile&) = delete;
    ArrayFile& operator=(const ArrayFile&) = delete;

    [[nodiscard]] const std::vector<ArrayHead>& arrays() const { return m_arrays; }
    [[nodiscard]] const std::string& path() const { return m_path; }

    /// Takes the next values in the order in which the file has them; returning false ends the reading.
    using Take = std::function<bool(std::span<const double>)>;
    /// Hands all values of an array that can be read to take(), piece by piece. Error: badInput with the
    /// place in the file, ioFailed; cancelled by take.
    [[nodiscard]] virtual core::Expected<void> read(std::size_t array, const Take& take) = 0;

protected:
    explicit ArrayFile(std::string path)
        : m_path(std::move(path)) {}

    std::string m_path;
    std::vector<ArrayHead> m_arrays;
};

} // namespace teleta::frames
