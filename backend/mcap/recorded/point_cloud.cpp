// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/point_cloud.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace teleta::mcap {

namespace {

constexpr std::uint8_t kFloat32 = 7; ///< sensor_msgs/PointField.FLOAT32
constexpr std::uint8_t kFloat64 = 8; ///< sensor_msgs/PointField.FLOAT64
constexpr std::size_t kMostPoints = std::size_t{1} << 20U;
constexpr double kFarthest_m = 10.0; ///< as core::TaxelPlace has it

/// A number of each point.
struct PointField {
    std::size_t offset = 0;
    bool isDouble = false;

    [[nodiscard]] std::size_t bytes() const { return isDouble ? sizeof(double) : sizeof(float); }
};

template <typename Number>
double numberAt(const char* bytes, bool swaps) {
    std::array<char, sizeof(Number)> copy{};
    std::copy_n(bytes, sizeof(Number), copy.begin());
    if (swaps)
        std::ranges::reverse(copy);
    return static_cast<double>(std::bit_cast<Number>(copy));
}

} // namespace

void writePoints(CdrWriter& cdr, const core::TaxelLayout& layout, std::span<const float> values) {
    std::vector<const char*> fields{"x", "y", "z", "value"};
    if (layout.isVector())
        fields = {"x", "y", "z", "force_x", "force_y", "force_z"};
    const auto components = static_cast<std::size_t>(layout.components());
    std::vector<float> points;
    std::uint32_t width = 0;
    bool isDense = true;
    for (std::size_t taxel = 0; taxel < layout.taxels(); ++taxel) {
        if (layout.isAbsent(taxel))
            continue;
        const double z_m = layout.isGrid() ? 0.0 : (*layout.places())[taxel].z_m;
        points.insert(points.end(), {static_cast<float>(layout.x_m(taxel)),
                                     static_cast<float>(layout.y_m(taxel)), static_cast<float>(z_m)});
        for (const float value : values.subspan(taxel * components, components)) {
            points.push_back(value);
            isDense = isDense && std::isfinite(value);
        }
        ++width;
    }
    const auto step = static_cast<std::uint32_t>(fields.size() * sizeof(float));
    cdr.number(std::uint32_t{1}); // height
    cdr.number(width);
    cdr.number(static_cast<std::uint32_t>(fields.size()));
    for (std::size_t i = 0; i < fields.size(); ++i) {
        cdr.text(fields[i]);
        cdr.number(static_cast<std::uint32_t>(i * sizeof(float)));
        cdr.number(kFloat32);
        cdr.number(std::uint32_t{1});
    }
    cdr.number(std::uint8_t{0}); // is_bigendian
    cdr.number(step);
    cdr.number(step * width);
    cdr.byteSequence({reinterpret_cast<const char*>(points.data()), points.size() * sizeof(float)});
    cdr.number(static_cast<std::uint8_t>(isDense ? 1 : 0));
}

namespace {

/// What a cloud has of x, y, z, force_x, force_y, force_z, value.
using TaxelFields = std::array<std::optional<PointField>, 7>;

TaxelFields readFields(CdrReader& cdr) {
    static constexpr std::array<std::string_view, 7> kNames{"x",       "y",       "z",    "force_x",
                                                            "force_y", "force_z", "value"};
    constexpr std::size_t kFieldBytes = 9;
    TaxelFields fields;
    const std::size_t told = cdr.count(kFieldBytes);
    for (std::size_t i = 0; i < told && !cdr.failed(); ++i) {
        const auto name = std::ranges::find(kNames, cdr.text());
        const std::size_t offset = cdr.number<std::uint32_t>();
        const auto type = cdr.number<std::uint8_t>();
        const auto count = cdr.number<std::uint32_t>();
        if (name != kNames.end() && count == 1 && (type == kFloat32 || type == kFloat64))
            fields[static_cast<std::size_t>(name - kNames.begin())] = {offset, type == kFloat64};
    }
    return fields;
}

bool areVectors(const TaxelFields& fields) {
    return fields[3] && fields[4] && fields[5];
}

bool areOfTaxels(const TaxelFields& fields) {
    return fields[0] && fields[1] && fields[2] && (areVectors(fields) || fields[6]);
}

} // namespace

std::optional<bool> hasTaxelFields(CdrReader& cdr) {
    (void)cdr.number<std::uint32_t>(); // height
    (void)cdr.number<std::uint32_t>(); // width
    const TaxelFields fields = readFields(cdr);
    return cdr.failed() ? std::nullopt : std::optional(areOfTaxels(fields));
}

bool readPoints(CdrReader& cdr, TaxelPoints& points) {
    points = {};
    const std::size_t height = cdr.number<std::uint32_t>();
    const std::size_t width = cdr.number<std::uint32_t>();
    const TaxelFields fields = readFields(cdr);
    const bool swaps = cdr.number<std::uint8_t>() != 0;
    const std::size_t step = cdr.number<std::uint32_t>();
    const std::size_t rowStep = cdr.number<std::uint32_t>();
    const std::string_view data = cdr.byteSequence();
    const bool isVector = areVectors(fields);
    if (cdr.failed() || !areOfTaxels(fields) || height == 0 || width == 0 || height > kMostPoints ||
        width > kMostPoints || height * width > kMostPoints ||
        width > rowStep / std::max<std::size_t>(step, 1) ||
        height > data.size() / std::max<std::size_t>(rowStep, 1))
        return false;
    std::vector<PointField> used{*fields[0], *fields[1], *fields[2]};
    if (isVector)
        used.insert(used.end(), {*fields[3], *fields[4], *fields[5]});
    else
        used.push_back(*fields[6]);
    if (std::ranges::any_of(used,
                            [&](const PointField& field) { return field.offset + field.bytes() > step; }))
        return false;
    points.components = isVector ? 3 : 1;
    for (std::size_t point = 0; point < height * width; ++point) {
        const char* bytes = data.data() + (point / width) * rowStep + (point % width) * step;
        std::array<double, 6> numbers{};
        for (std::size_t i = 0; i < used.size(); ++i)
            numbers[i] = used[i].isDouble ? numberAt<double>(bytes + used[i].offset, swaps)
                                          : numberAt<float>(bytes + used[i].offset, swaps);
        for (std::size_t i = 0; i < 3; ++i)
            if (!(std::abs(numbers[i]) <= kFarthest_m))
                return false;
        points.places.push_back({numbers[0], numbers[1], numbers[2]});
        for (std::size_t i = 3; i < used.size(); ++i)
            points.values.push_back(static_cast<float>(numbers[i]));
    }
    return true;
}

std::vector<float> valuesOn(const core::TaxelLayout& layout, const TaxelPoints& points) {
    std::size_t present = 0;
    for (std::size_t taxel = 0; taxel < layout.taxels(); ++taxel)
        present += layout.isAbsent(taxel) ? 0 : 1;
    if (points.components != layout.components() || points.places.size() != present)
        return {};
    const auto components = static_cast<std::size_t>(layout.components());
    std::vector<float> values(layout.values(), std::numeric_limits<float>::quiet_NaN());
    auto next = points.values.begin();
    for (std::size_t taxel = 0; taxel < layout.taxels(); ++taxel) {
        if (layout.isAbsent(taxel))
            continue;
        std::copy_n(next, components, values.begin() + static_cast<std::ptrdiff_t>(taxel * components));
        next += static_cast<std::ptrdiff_t>(components);
    }
    return values;
}

} // namespace teleta::mcap
