// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/array_output.h"
#include "app/python/base/frame_input.h"
#include "app/python/core/core_bindings.h"
#include "app/python/core/frame_settings.h"
#include "backend/core/data/csv_reader.h"
#include "backend/equilibration/taxel_gain_file.h"
#include "backend/equilibration/taxel_gains.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::python {

namespace {

using equilibration::TaxelGain;
using equilibration::TaxelGains;

/// What teleta.Gains holds, by name.
py::dict toDict(const TaxelGains& gains) {
    std::vector<double> gain;
    std::vector<double> error;
    WordColumn<6> states;
    for (const TaxelGain& taxel : gains.taxels) {
        gain.push_back(taxel.gain);
        error.push_back(taxel.error);
        states.add(equilibration::toString(taxel.state));
    }
    const std::vector<py::ssize_t> shape{gains.layout.rows, gains.layout.columns};
    py::dict all;
    all["gain"] = arrayOf(std::move(gain), shape);
    all["gain_se"] = arrayOf(std::move(error), shape);
    all["state"] = std::move(states).array().reshape(shape);
    all["presses"] = gains.presses;
    all["frames"] = gains.frames;
    all["level"] = gains.level;
    all["scatter"] = gains.scatter;
    all["repeatability"] = gains.repeatability;
    all["tilt_x"] = gains.tilt_x;
    all["tilt_y"] = gains.tilt_y;
    all["tilted"] = gains.isTilted;
    return all;
}

py::dict findGains(const py::list& presses, double pitch_m, const py::dict& arguments) {
    std::vector<FrameInput> inputs;
    for (const py::handle press : presses) {
        inputs.push_back(FrameInput::read(press, pitch_m, "presses"));
        const core::ArrayLayout& first = inputs.front().layout;
        if (inputs.back().layout != first)
            throw wrongValue("presses",
                             "frames of one array, (frames, " + std::to_string(first.rows) + ", " +
                                 std::to_string(first.columns) + ")",
                             shapeText(inputs.back().array));
    }
    if (inputs.empty())
        throw py::value_error("presses: expected at least one press, got none");
    const core::ArrayLayout layout = inputs.front().layout;
    const contact::ConditioningSettings settings = conditioningOf(arguments, layout);
    std::vector<equilibration::GainPress> pressed;
    for (const FrameInput& input : inputs)
        pressed.push_back({valuesOf(input.array), settings});
    core::Expected<TaxelGains> gains;
    {
        const py::gil_scoped_release released;
        gains = equilibration::findTaxelGains(layout, pressed);
    }
    return toDict(valueOf(std::move(gains)));
}

/// Rows and columns of the array that a file of gains is of: the highest numbers in it.
core::Expected<core::ArrayLayout> layoutIn(const std::string& path) {
    TELETA_TRY(core::CsvReader csv, core::CsvReader::open(path));
    constexpr std::array<std::string_view, 2> kNames{"row", "column"};
    TELETA_TRY(const std::vector<std::size_t> places, csv.columns(kNames));
    core::ArrayLayout layout;
    layout.rows = 1;
    layout.columns = 1;
    std::vector<std::string_view> fields;
    for (;;) {
        TELETA_TRY(const bool any, csv.nextText(fields));
        if (!any)
            return layout;
        const auto count = [&](std::size_t place) {
            const std::string text(fields[places[place]]);
            const long number = std::strtol(text.c_str(), nullptr, 10);
            // Anything else is refused with its place when the gains are read.
            return static_cast<int>(std::clamp<long>(number, 0, core::ArrayLayout::kMaximumSide - 1)) + 1;
        };
        layout.rows = std::max(layout.rows, count(0));
        layout.columns = std::max(layout.columns, count(1));
    }
}

py::dict loadGains(const py::object& file) {
    const std::string path = pathOf(file);
    core::Expected<TaxelGains> gains;
    {
        const py::gil_scoped_release released;
        gains = layoutIn(path).and_then(
            [&](const core::ArrayLayout& layout) { return equilibration::readTaxelGains(path, layout); });
    }
    return toDict(valueOf(std::move(gains)));
}

void saveGains(const py::object& gain, const py::object& error, const py::object& states,
               const py::object& file) {
    const std::string path = pathOf(file);
    const auto gains = realArray<double>(gain, "gain");
    needShape(gains, "gain", {-1, -1}, "(rows, columns)");
    TaxelGains all;
    all.layout = layoutOf(gains.shape(0), gains.shape(1), all.layout.pitchX_m);
    const auto errors = realArray<double>(error, "gain_se");
    needShape(errors, "gain_se", {gains.shape(0), gains.shape(1)}, "the shape of gain");
    const auto words = py::cast<std::vector<std::string>>(states.attr("ravel")().attr("tolist")());
    for (std::size_t i = 0; i < all.layout.taxels(); ++i) {
        const auto state = i < words.size() ? equilibration::taxelState(words[i]) : std::nullopt;
        if (!state || words.size() != all.layout.taxels())
            throw py::value_error(
                "state: expected 'good', 'dead', 'weak', 'strong' or 'stuck' for each taxel");
        all.taxels.push_back({*state, gains.data()[i], errors.data()[i]});
    }
    core::Expected<void> written;
    {
        const py::gil_scoped_release released;
        written = equilibration::writeTaxelGains(all, path);
    }
    valueOf(written);
}

} // namespace

void bindGains(py::module_& module) {
    module.def("gains", &findGains);
    module.def("load_gains", &loadGains);
    module.def("save_gains", &saveGains);
}

} // namespace teleta::python
