// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/array/array_message.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace teleta::ros_array {

namespace {

struct ArrayMessageText {
    Q_DECLARE_TR_FUNCTIONS(ArrayMessageText)
};

float loadOf(double number, const RosArrayFile& file) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    const double load = std::isfinite(number) ? file.scale * number : number;
    // Neither a float nor a load.
    return std::abs(load) <= kLargest ? static_cast<float>(load) : std::numeric_limits<float>::quiet_NaN();
}

core::Unexpected otherCount(std::size_t count, const RosArrayFile& file) {
    return core::failed(core::ErrorKind::badInput,
                        ArrayMessageText::tr("a message has %1 numbers, the file has %2 x %3 taxels")
                            .arg(count)
                            .arg(file.layout.rows)
                            .arg(file.layout.columns));
}

core::Unexpected otherSize(std::size_t rows, std::size_t columns, const RosArrayFile& file) {
    return core::failed(core::ErrorKind::badInput,
                        ArrayMessageText::tr("a message has %1 x %2 numbers, the file has %3 x %4 taxels")
                            .arg(rows)
                            .arg(columns)
                            .arg(file.layout.rows)
                            .arg(file.layout.columns));
}

bool isOf(const RosArrayFile& file, std::size_t rows, std::size_t columns) {
    return rows == static_cast<std::size_t>(file.layout.rows) &&
           columns == static_cast<std::size_t>(file.layout.columns);
}

/// A number of these bytes, in the machine's order.
template <typename Number>
Number numberAt(const std::uint8_t* bytes, bool isBig) {
    std::array<std::uint8_t, sizeof(Number)> ordered{};
    std::memcpy(ordered.data(), bytes, sizeof(Number));
    if (isBig != (std::endian::native == std::endian::big))
        std::ranges::reverse(ordered);
    return std::bit_cast<Number>(ordered);
}

template <typename Number>
core::Expected<bool> loadsOfPixels(const ros::Image& message, const RosArrayFile& file,
                                   std::span<float> loads) {
    const auto data = ros::view(message.data);
    const std::size_t rowBytes = std::size_t{message.width} * sizeof(Number);
    const std::size_t needed =
        message.height == 0 ? 0 : std::size_t{message.step} * (message.height - 1) + rowBytes;
    if (message.step < rowBytes || data.size() < needed)
        return core::failed(
            core::ErrorKind::badInput,
            ArrayMessageText::tr("a message has %1 bytes, its size says %2").arg(data.size()).arg(needed));
    std::size_t taxel = 0;
    for (std::size_t row = 0; row < message.height; ++row) {
        const std::uint8_t* pixel = data.data() + row * message.step;
        for (std::size_t column = 0; column < message.width; ++column, pixel += sizeof(Number))
            loads[taxel++] =
                loadOf(static_cast<double>(numberAt<Number>(pixel, message.is_bigendian != 0)), file);
    }
    return true;
}

} // namespace

core::Expected<bool> loadsOf(const ros::TactileState& message, const RosArrayFile& file,
                             std::span<float> loads) {
    const auto sensors = ros::view(message.sensors);
    for (const auto& sensor : sensors) {
        const std::string_view name = sensor.name == nullptr ? "" : sensor.name;
        if (file.sensor.empty() ? sensors.size() > 1 : name != file.sensor)
            continue;
        const auto values = ros::view(sensor.values);
        if (values.size() != loads.size())
            return otherCount(values.size(), file);
        for (std::size_t i = 0; i < loads.size(); ++i)
            loads[i] = loadOf(static_cast<double>(values[i]), file);
        return true;
    }
    if (file.sensor.empty() && sensors.size() > 1)
        return core::failed(core::ErrorKind::badInput,
                            ArrayMessageText::tr("a message has %1 sensors").arg(sensors.size()),
                            ArrayMessageText::tr("sensor = \"NAME\" in the file"));
    return false;
}

core::Expected<bool> loadsOf(const ros::Float64MultiArray& message, const RosArrayFile& file,
                             std::span<float> loads) {
    const auto dimensions = ros::view(message.layout.dim);
    const auto data = ros::view(message.data);
    const std::size_t offset = message.layout.data_offset;
    if (offset > data.size() || data.size() - offset != loads.size())
        return otherCount(offset > data.size() ? 0 : data.size() - offset, file);
    if (!dimensions.empty()) {
        if (dimensions.size() != 2)
            return core::failed(core::ErrorKind::badInput,
                                ArrayMessageText::tr("a message has %1 dimensions").arg(dimensions.size()),
                                ArrayMessageText::tr("rows and columns"));
        if (!isOf(file, dimensions[0].size, dimensions[1].size))
            return otherSize(dimensions[0].size, dimensions[1].size, file);
    }
    for (std::size_t i = 0; i < loads.size(); ++i)
        loads[i] = loadOf(data[offset + i], file);
    return true;
}

core::Expected<bool> loadsOf(const ros::Image& message, const RosArrayFile& file, std::span<float> loads) {
    if (!isOf(file, message.height, message.width))
        return otherSize(message.height, message.width, file);
    const std::string_view encoding = message.encoding == nullptr ? "" : message.encoding;
    if (encoding == "32FC1")
        return loadsOfPixels<float>(message, file, loads);
    if (encoding == "16UC1" || encoding == "mono16")
        return loadsOfPixels<std::uint16_t>(message, file, loads);
    if (encoding == "8UC1" || encoding == "mono8")
        return loadsOfPixels<std::uint8_t>(message, file, loads);
    return core::failed(core::ErrorKind::badInput,
                        ArrayMessageText::tr("a message has the encoding \"%1\"")
                            .arg(QString::fromUtf8(encoding.data(), static_cast<qsizetype>(encoding.size()))),
                        "32FC1, 16UC1, mono16, 8UC1, mono8");
}

} // namespace teleta::ros_array
