// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/array_output.h"
#include "app/python/base/frame_input.h"
#include "app/python/base/long_work.h"
#include "app/python/core/contact_columns.h"
#include "app/python/core/core_bindings.h"
#include "app/python/core/frame_settings.h"
#include "backend/frames/frame_reader.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace teleta::python {

namespace {

/// So many taxels are computed between two looks at the clock: a few milliseconds.
constexpr std::size_t kTaxelsBetweenLooks = 1 << 18;

std::size_t framesBetweenLooks(const core::ArrayLayout& layout) {
    return std::max<std::size_t>(1, kTaxelsBetweenLooks / layout.taxels());
}

/// The column of a table that tells its rows apart when there are no times.
py::array frameNumbers(std::size_t count) {
    std::vector<std::int64_t> frames(count);
    std::iota(frames.begin(), frames.end(), std::int64_t{0});
    return arrayOf(std::move(frames));
}

py::dict features(const py::object& frames, double pitch_m, const py::dict& arguments,
                  const py::object& time_s) {
    const FrameInput input = FrameInput::read(frames, pitch_m);
    std::vector<double> times_s = frameTimes(time_s, input.count);
    const std::size_t taxels = input.layout.taxels();
    const contact::ConditioningSettings conditioning = conditioningOf(arguments, input.layout);
    contact::FeatureBatch batch(input.layout, conditioning, featureSettingsOf(arguments));
    const SummitArguments summit = summitArgumentsOf(arguments);
    FeatureColumns columns(input.count);
    SummitColumns summits;
    LongWork work;
    {
        const py::gil_scoped_release released;
        const std::size_t pause = framesBetweenLooks(input.layout);
        std::vector<contact::ContactType> types(std::min(pause, input.count));
        std::vector<double> thresholds_N(types.size());
        const contact::FrameConditioner conditioner(taxels, conditioning);
        std::vector<float> load_N(taxels);
        std::vector<std::uint8_t> dead(taxels);
        for (std::size_t first = 0; first < input.count && work.goOn(); first += pause) {
            const std::size_t count = std::min(pause, input.count - first);
            batch.compute({input.frame(first).data(), count * taxels},
                          columns.arrays(first, types, thresholds_N));
            columns.addTypes(std::span(types).first(count));
            for (std::size_t i = 0; summit.wanted && i < count; ++i) {
                conditioner.apply(input.frame(first + i), load_N, dead);
                summits.add(contact::summitOf(load_N, input.layout, thresholds_N[i], dead, summit.noise_N));
            }
        }
    }
    work.rethrow();
    py::dict table;
    if (time_s.is_none())
        table["frame"] = frameNumbers(input.count);
    else
        table["time_s"] = arrayOf(std::move(times_s));
    std::move(columns).moveTo(table);
    if (summit.wanted)
        std::move(summits).moveTo(table);
    return table;
}

/// The times of the frames: told, or from a rate; empty when neither is.
std::vector<double> timesOf(const py::object& time_s, const py::object& rate_hz, std::size_t frames) {
    if (rate_hz.is_none())
        return frameTimes(time_s, frames);
    if (!time_s.is_none())
        throw py::value_error("rate_hz: expected either time_s or rate_hz, got both");
    const double rate_Hz = positive(py::cast<double>(rate_hz), "rate_hz");
    std::vector<double> times_s(frames);
    for (std::size_t i = 0; i < frames; ++i)
        times_s[i] = static_cast<double>(i) / rate_Hz;
    return times_s;
}

py::object contacts(const py::object& frames, double pitch_m, const py::dict& arguments,
                    const py::object& time_s, const py::object& rate_hz, bool returnLabels) {
    const FrameInput input = FrameInput::read(frames, pitch_m);
    const std::vector<double> times_s = timesOf(time_s, rate_hz, input.count);
    const bool timed = !time_s.is_none() || !rate_hz.is_none();
    const std::size_t taxels = input.layout.taxels();
    const contact::FrameConditioner conditioner(taxels, conditioningOf(arguments, input.layout));
    const contact::FeatureSettings featureSettings = featureSettingsOf(arguments);
    contact::SegmentationSettings settings = segmentationSettingsOf(arguments);
    contact::FeatureExtractor extractor(input.layout, featureSettings);
    contact::ContactSegmenter segmenter(input.layout, settings);
    contact::ContactTracker tracker(trackingSettingsOf(arguments, input.layout));
    const SummitArguments summit = summitArgumentsOf(arguments);
    ContactColumns columns;
    SummitColumns summits;
    std::vector<std::int64_t> numbers;
    std::vector<double> seen_s;
    std::unique_ptr<std::int32_t[]> labels;
    if (returnLabels)
        labels = std::make_unique_for_overwrite<std::int32_t[]>(input.count * taxels);
    LongWork work;
    {
        const py::gil_scoped_release released;
        std::vector<float> load_N(taxels);
        std::vector<std::uint8_t> dead(taxels);
        const std::size_t pause = framesBetweenLooks(input.layout);
        for (std::size_t i = 0; i < input.count; ++i) {
            if (i % pause == 0 && !work.goOn())
                break;
            conditioner.apply(input.frame(i), load_N, dead);
            if (featureSettings.automaticThreshold) {
                settings.threshold_N = extractor.compute(load_N, dead).threshold_N;
                segmenter.setSettings(settings);
            }
            const std::span<contact::Contact> found = segmenter.segment(load_N, dead);
            if (timed)
                tracker.assign(found, times_s[i]);
            columns.add(found);
            if (summit.wanted)
                for (const contact::Contact& each : found)
                    summits.add(
                        contact::summitOf(load_N, input.layout, segmenter, each, dead, summit.noise_N));
            numbers.insert(numbers.end(), found.size(), static_cast<std::int64_t>(i));
            seen_s.insert(seen_s.end(), found.size(),
                          timed ? times_s[i] : std::numeric_limits<double>::quiet_NaN());
            if (labels != nullptr)
                std::ranges::copy(segmenter.labels(), labels.get() + i * taxels);
        }
    }
    work.rethrow();
    py::dict table;
    table["frame"] = arrayOf(std::move(numbers));
    table["time_s"] = arrayOf(std::move(seen_s));
    std::move(columns).moveTo(table);
    if (summit.wanted)
        std::move(summits).moveTo(table);
    if (labels == nullptr)
        return table;
    const std::vector<py::ssize_t> shape(input.array.shape(), input.array.shape() + input.array.ndim());
    return py::make_tuple(table, arrayOf(std::move(labels), shape));
}

/// A number that was given, or none.
template <typename Number>
std::optional<Number> numberIn(const py::dict& arguments, const char* name) {
    const py::object value = arguments[name];
    return value.is_none() ? std::optional<Number>() : py::cast<Number>(value);
}

std::string textIn(const py::dict& arguments, const char* name) {
    const py::object value = arguments[name];
    return value.is_none() ? std::string() : py::cast<std::string>(value);
}

frames::FrameAxis axisIn(const py::dict& arguments) {
    const std::string axis = textIn(arguments, "frame_axis");
    if (axis == "first")
        return frames::FrameAxis::first;
    if (axis == "last")
        return frames::FrameAxis::last;
    if (!axis.empty())
        throw py::value_error("frame_axis: expected 'first', 'last' or None, got '" + axis + "'");
    return frames::FrameAxis::automatic;
}

py::tuple readFrames(const py::object& file, const py::dict& arguments) {
    frames::FrameRequest request{.path = pathOf(file)};
    request.guessesShape = true;
    const auto rows = numberIn<long long>(arguments, "rows");
    const auto columns = numberIn<long long>(arguments, "columns");
    if (rows.has_value() != columns.has_value())
        throw py::value_error("rows: expected both rows and columns, or neither");
    if (rows) {
        const core::ArrayLayout layout = layoutOf(*rows, *columns, core::ArrayLayout{}.pitchX_m);
        request.rows = layout.rows;
        request.columns = layout.columns;
    }
    request.rate_Hz = numberIn<double>(arguments, "rate_hz");
    if (request.rate_Hz)
        request.rate_Hz = positive(*request.rate_Hz, "rate_hz");
    request.array = textIn(arguments, "array");
    request.axis = axisIn(arguments);
    request.timeColumn = textIn(arguments, "time_column");
    request.timeUnit = textIn(arguments, "time_unit");
    if (const std::string text = textIn(arguments, "taxel_columns"); !text.empty()) {
        const auto ranges = frames::columnRangesOf(text);
        if (!ranges)
            throw py::value_error("taxel_columns: expected columns such as '2..85', got '" + text + "'");
        request.taxelColumns = *ranges;
    }
    LongWork work;
    frames::FrameSeries series = work.valueOf([&] {
        const py::gil_scoped_release released;
        return frames::readFrames(request, [&work] { return work.goOn(); });
    }());
    if (series.layout.pitchX_m != series.layout.pitchY_m)
        throw py::value_error(
            "the file's columns are " + std::to_string(1e3 * series.layout.pitchX_m) +
            " mm apart and its rows " + std::to_string(1e3 * series.layout.pitchY_m) +
            " mm; features() and contacts() take one pitch, so use the program: teleta features");
    const auto count = static_cast<py::ssize_t>(series.frames());
    return py::make_tuple(
        arrayOf(std::move(series.time_s)),
        arrayOf(std::move(series.values), {count, series.layout.rows, series.layout.columns}), series.unit);
}

} // namespace

void bindFrames(py::module_& module) {
    module.def("features", &features);
    module.def("contacts", &contacts);
    module.def("read_frames", &readFrames);
}

} // namespace teleta::python
