// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/core/frame_settings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace teleta::python {

namespace {

std::string text(py::handle value) {
    return std::string(py::repr(value));
}

double numberOf(const py::dict& arguments, const char* name) {
    const py::object value = arguments[name];
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        throw py::type_error(std::string(name) + ": expected a number, got " + text(value));
    }
    return number;
}

bool flagOf(const py::dict& arguments, const char* name) {
    return py::cast<bool>(py::bool_(py::object(arguments[name])));
}

/// One of two words.
template <typename Enumeration>
Enumeration choiceOf(const py::dict& arguments, const char* name, std::pair<const char*, Enumeration> first,
                     std::pair<const char*, Enumeration> second) {
    const py::object value = arguments[name];
    if (value.equal(py::str(first.first)))
        return first.second;
    if (value.equal(py::str(second.first)))
        return second.second;
    throw wrongValue(name, std::string("'") + first.first + "' or '" + second.first + "'", text(value));
}

std::string shapeOf(const core::ArrayLayout& layout) {
    return "(" + std::to_string(layout.rows) + ", " + std::to_string(layout.columns) + ")";
}

/// A number for each taxel, or nothing for None.
std::vector<float> ofEachTaxel(py::handle value, const char* name, const core::ArrayLayout& layout) {
    if (value.is_none())
        return {};
    const auto array = realArray<float>(value, name);
    needShape(array, name, {layout.rows, layout.columns}, shapeOf(layout).c_str());
    const std::span<const float> values = valuesOf(array);
    return {values.begin(), values.end()};
}

/// A mask of the array's shape, or the numbers of some taxels, counted row by row from 0.
std::vector<std::uint8_t> deadTaxels(py::handle value, const core::ArrayLayout& layout) {
    if (value.is_none())
        return {};
    const py::array any = py::array::ensure(value);
    if (!any)
        PyErr_Clear();
    std::vector<std::uint8_t> dead(layout.taxels(), 0);
    if (any && any.ndim() == 2) {
        needShape(any, "dead", {layout.rows, layout.columns}, shapeOf(layout).c_str());
        const auto mask = realArray<float>(any, "dead");
        std::ranges::transform(valuesOf(mask), dead.begin(),
                               [](float marked) { return static_cast<std::uint8_t>(marked != 0.0F); });
        return dead;
    }
    if (any && any.dtype().kind() == 'b')
        throw wrongValue("dead", "a mask " + shapeOf(layout) + " or numbers of taxels", shapeText(any));
    for (const double taxel : numbers(value, "dead")) {
        if (taxel < 0.0 || taxel >= static_cast<double>(dead.size()) || taxel != std::floor(taxel))
            throw wrongValue("dead",
                             "a mask " + shapeOf(layout) + " or numbers of taxels from 0 to " +
                                 std::to_string(dead.size() - 1),
                             text(py::float_(taxel)));
        dead[static_cast<std::size_t>(taxel)] = 1;
    }
    return dead;
}

} // namespace

contact::ConditioningSettings conditioningOf(const py::dict& arguments, const core::ArrayLayout& layout) {
    contact::ConditioningSettings settings;
    settings.tare = ofEachTaxel(arguments["tare"], "tare", layout);
    settings.gain = numberOf(arguments, "gain");
    if (!std::isfinite(settings.gain) || settings.gain == 0.0)
        throw wrongValue("gain", "a finite number other than 0", text(py::float_(settings.gain)));
    settings.inverted = flagOf(arguments, "inverted");
    py::object gains = arguments["taxel_gains"];
    // What teleta.gains() returns is taken as well.
    if (!gains.is_none() && py::hasattr(gains, "gain_se"))
        gains = gains.attr("gain");
    settings.taxelGain = ofEachTaxel(gains, "taxel_gains", layout);
    settings.dead = deadTaxels(arguments["dead"], layout);
    return settings;
}

contact::FeatureSettings featureSettingsOf(const py::dict& arguments) {
    return {.threshold_N = positive(numberOf(arguments, "threshold_n"), "threshold_n"),
            .automaticThreshold = flagOf(arguments, "automatic_threshold"),
            .orientation = choiceOf<contact::OrientationMode>(
                arguments, "orientation", {"binarised", contact::OrientationMode::binarised},
                {"weighted", contact::OrientationMode::weighted}),
            .range = choiceOf<contact::MomentRange>(arguments, "moment_range",
                                                    {"image", contact::MomentRange::image},
                                                    {"active", contact::MomentRange::active})};
}

contact::SegmentationSettings segmentationSettingsOf(const py::dict& arguments) {
    const double height = numberOf(arguments, "noise_height");
    if (!(height >= 0.0 && height <= 1.0))
        throw wrongValue("noise_height", "0 to 1", text(py::float_(height)));
    const double taxels = numberOf(arguments, "minimum_taxels");
    constexpr double kMost = double(core::ArrayLayout::kMaximumSide) * core::ArrayLayout::kMaximumSide;
    if (!(taxels >= 1.0 && taxels <= kMost) || taxels != std::floor(taxels))
        throw wrongValue("minimum_taxels", "a whole number of 1 or more", text(py::float_(taxels)));
    return {.threshold_N = positive(numberOf(arguments, "threshold_n"), "threshold_n"),
            .noiseHeight = height,
            .minimumTaxels = static_cast<int>(taxels)};
}

SummitArguments summitArgumentsOf(const py::dict& arguments) {
    SummitArguments summit{.wanted = flagOf(arguments, "summit"), .noise_N = {}};
    if (!py::object(arguments["noise_n"]).is_none())
        summit.noise_N = positive(numberOf(arguments, "noise_n"), "noise_n");
    return summit;
}

contact::TrackingSettings trackingSettingsOf(const py::dict& arguments, const core::ArrayLayout& layout) {
    contact::TrackingSettings settings = contact::trackingFor(layout);
    if (!py::object(arguments["gate_m"]).is_none())
        settings.gate_m = notNegative(numberOf(arguments, "gate_m"), "gate_m");
    settings.memory_s = notNegative(numberOf(arguments, "memory_s"), "memory_s");
    return settings;
}

} // namespace teleta::python
