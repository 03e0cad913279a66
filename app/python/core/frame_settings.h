// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/python/base/array_input.h"
#include "backend/contact/contact_segmenter.h"
#include "backend/contact/contact_tracker.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/contact/tactile_features.h"
#include "backend/core/data/array_layout.h"

#include <optional>
#include <pybind11/pybind11.h>

namespace teleta::python {

/// What a dict of keyword arguments says of the taxels: tare, gain, inverted, taxel_gains, dead. ValueError
/// or TypeError names the parameter. Needs the interpreter's lock, as all below.
[[nodiscard]] contact::ConditioningSettings conditioningOf(const py::dict& arguments,
                                                           const core::ArrayLayout& layout);

/// threshold_n, automatic_threshold, orientation, moment_range.
[[nodiscard]] contact::FeatureSettings featureSettingsOf(const py::dict& arguments);

/// threshold_n, noise_height, minimum_taxels.
[[nodiscard]] contact::SegmentationSettings segmentationSettingsOf(const py::dict& arguments);

/// summit, noise_n.
struct SummitArguments {
    bool wanted = false;
    std::optional<double> noise_N;
};
[[nodiscard]] SummitArguments summitArgumentsOf(const py::dict& arguments);

/// gate_m, memory_s.
[[nodiscard]] contact::TrackingSettings trackingSettingsOf(const py::dict& arguments,
                                                           const core::ArrayLayout& layout);

} // namespace teleta::python
