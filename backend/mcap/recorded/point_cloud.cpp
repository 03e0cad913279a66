// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/recorded/point_cloud.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace teleta::mcap {

namespace {

constexpr std::uint8_t kFloat32 = 7; ///< sensor_msgs/PointField.FLOAT32

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

} // namespace teleta::mcap
