// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>

namespace teleta::core {

/// One number a joint, from the base to the tip, for an arm of any size: up to kCapacity joints, without the
/// heap. Numbers past the count read 0, so vectors are equal when counts and numbers are.
class JointVector {
public:
    static constexpr std::size_t kCapacity = 16;
    using value_type = double;
    using iterator = double*;
    using const_iterator = const double*;

    constexpr JointVector() = default; ///< no joints
    template <std::convertible_to<double>... Values>
    requires(sizeof...(Values) > 1 && sizeof...(Values) <= kCapacity) constexpr JointVector(Values... values)
        : m_values{static_cast<double>(values)...}
        , m_size(sizeof...(Values)) {}

    /// count zeros; count: at most kCapacity.
    [[nodiscard]] static constexpr JointVector zeros(std::size_t count) {
        assert(count <= kCapacity);
        JointVector vector;
        vector.m_size = std::min(count, kCapacity);
        return vector;
    }
    /// Empty when there are more than kCapacity.
    [[nodiscard]] static constexpr std::optional<JointVector> of(std::span<const double> values) {
        if (values.size() > kCapacity)
            return std::nullopt;
        JointVector vector = zeros(values.size());
        std::ranges::copy(values, vector.begin());
        return vector;
    }

    [[nodiscard]] constexpr std::size_t size() const { return m_size; }
    [[nodiscard]] constexpr bool empty() const { return m_size == 0; }
    /// joint < kCapacity; 0 past the count.
    [[nodiscard]] constexpr const double& operator[](std::size_t joint) const { return m_values[joint]; }
    /// joint < size().
    [[nodiscard]] constexpr double& operator[](std::size_t joint) {
        assert(joint < m_size);
        return m_values[joint];
    }
    [[nodiscard]] constexpr double* data() { return m_values.data(); }
    [[nodiscard]] constexpr const double* data() const { return m_values.data(); }
    [[nodiscard]] constexpr double* begin() { return data(); }
    [[nodiscard]] constexpr double* end() { return data() + m_size; }
    [[nodiscard]] constexpr const double* begin() const { return data(); }
    [[nodiscard]] constexpr const double* end() const { return data() + m_size; }

    [[nodiscard]] constexpr bool operator==(const JointVector&) const = default;

private:
    std::array<double, kCapacity> m_values{};
    std::size_t m_size = 0;
};

} // namespace teleta::core
