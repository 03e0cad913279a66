// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/array_input.h"
#include "app/python/base/array_output.h"
#include "app/python/base/long_work.h"
#include "app/python/base/table_rows.h"
#include "app/python/core/core_bindings.h"
#include "backend/motors/motor_file.h"
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/files/pattern_format.h"
#include "backend/pattern/laws/law_checker.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/pattern/motors/motor_model.h"
#include "backend/pattern/motors/predicted_times.h"
#include "backend/pattern/motors/sampled_output.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::python {

namespace {

using pattern::Pattern;

/// Of a file; assumed ones without it.
pattern::MotorProfiles motorsOf(const py::object& path) {
    if (path.is_none())
        return pattern::assumedMotors();
    const std::string file = pathOf(path);
    core::Expected<motors::MotorCalibration> calibration;
    {
        const py::gil_scoped_release released;
        calibration = motors::readMotors(file);
    }
    return valueOf(std::move(calibration)).profiles();
}

py::array toArray(std::vector<double>&& intensities) {
    const auto rows = static_cast<py::ssize_t>(intensities.size() / core::kTactors);
    return arrayOf(std::move(intensities), {rows, py::ssize_t(core::kTactors)});
}

void append(std::vector<double>& rows, const core::Intensities& intensities) {
    rows.insert(rows.end(), intensities.begin(), intensities.end());
}

py::array evaluate(const Pattern& pattern, const py::object& times) {
    const std::vector<double> times_s = numbers(times, "times_s");
    std::vector<double> rows;
    {
        const py::gil_scoped_release released;
        const pattern::CompiledPattern compiled(pattern);
        rows.reserve(times_s.size() * core::kTactors);
        for (const double time_s : times_s)
            append(rows, compiled.evaluate(time_s));
    }
    return toArray(std::move(rows));
}

/// The rate in Hz for which times are the samples that `teleta pattern render` takes: k / rate within the
/// pattern.
std::optional<double> rateOf(const std::vector<double>& times_s, double duration_s) {
    if (times_s.size() < 2 || times_s[0] != 0.0 || !(times_s[1] > 0.0))
        return std::nullopt;
    const double rate_Hz = 1.0 / times_s[1];
    if (rate_Hz < pattern::kLowestRate_Hz || rate_Hz > pattern::kHighestRate_Hz ||
        times_s.size() > pattern::samplesOf(duration_s, rate_Hz))
        return std::nullopt;
    for (std::size_t k = 0; k < times_s.size(); ++k) {
        if (times_s[k] != static_cast<double>(k) / rate_Hz)
            return std::nullopt;
    }
    return rate_Hz;
}

py::array predicted(const Pattern& pattern, const py::object& times, const py::object& motorsPath) {
    const std::vector<double> times_s = numbers(times, "times_s");
    for (std::size_t i = 0; i < times_s.size(); ++i) {
        if (!(times_s[i] >= 0.0 && times_s[i] <= Pattern::kLongest_s) ||
            (i > 0 && times_s[i] < times_s[i - 1]))
            throw wrongValue("times_s", "times from 0 to 86400 s that do not decrease",
                             std::string(py::repr(py::float_(times_s[i]))));
    }
    const pattern::MotorProfiles profiles = motorsOf(motorsPath);
    std::vector<double> rows;
    rows.reserve(times_s.size() * core::kTactors);
    LongWork work;
    {
        const py::gil_scoped_release released;
        if (const std::optional<double> rate_Hz = rateOf(times_s, pattern.duration_s))
            pattern::forEachPredictedSample(
                pattern, profiles, *rate_Hz,
                [&](double, const core::Intensities& intensities, const core::Intensities&) {
                    append(rows, intensities);
                    return rows.size() < times_s.size() * core::kTactors && work.goOn();
                });
        else
            pattern::forEachPredictedTime(pattern, profiles, times_s,
                                          [&](std::size_t, const core::Intensities& intensities) {
                                              append(rows, intensities);
                                              return work.goOn();
                                          });
    }
    work.rethrow();
    return toArray(std::move(rows));
}

void save(const Pattern& pattern, const py::object& path, const std::optional<double>& rate_Hz,
          bool predictedToo, const py::object& motorsPath) {
    const std::string file = pathOf(path);
    const std::optional<pattern::PatternFormat> format = pattern::formatOf(file);
    if (!format)
        throw wrongValue("path", "a name that ends in one of " + pattern::allEndings(), file);
    const bool sampled = format == pattern::PatternFormat::csv || format == pattern::PatternFormat::wav;
    if (!sampled && (rate_Hz || predictedToo))
        throw py::value_error("path: rate_hz and predicted are for .csv and .wav files, which hold samples");
    pattern::SampleOptions options;
    options.rate_Hz = rate_Hz;
    if (predictedToo)
        options.motors = motorsOf(motorsPath);
    core::Expected<void> saved;
    {
        const py::gil_scoped_release released;
        saved = pattern::savePattern(pattern, file, options);
    }
    valueOf(saved);
}

/// The keys of the findings of `teleta pattern check --json`.
py::list check(const Pattern& pattern, const py::object& motorsPath) {
    const pattern::MotorProfiles profiles = motorsOf(motorsPath);
    std::vector<pattern::Finding> findings;
    {
        const py::gil_scoped_release released;
        findings = pattern::checkLaws(pattern, profiles);
    }
    py::list all;
    for (const pattern::Finding& finding : findings) {
        py::list tactors;
        for (const int tactor : finding.tactors)
            tactors.append(tactor + 1);
        py::dict fields;
        fields["law"] = pattern::toString(finding.law);
        fields["object"] = finding.object ? py::object(py::int_(*finding.object + 1)) : py::none();
        fields["tactors"] = py::tuple(tactors);
        fields["begin_s"] = finding.span.begin_s;
        fields["end_s"] = finding.span.end_s;
        fields["value"] = finding.value;
        fields["limit"] = finding.limit;
        fields["message"] = describe(finding);
        fields["suggestion"] = describeFix(finding);
        fields["fixable"] = pattern::fixed(pattern, finding).has_value();
        all.append(fields);
    }
    return all;
}

Pattern find(const py::object& nameOrPath) {
    const std::string name = pathOf(nameOrPath);
    core::Expected<Pattern> found;
    {
        const py::gil_scoped_release released;
        found = pattern::findPattern(name);
    }
    return valueOf(std::move(found));
}

py::dict list() {
    constexpr std::array<std::string_view, 5> kColumns{"id", "name", "task", "condition", "duration_s"};
    TableRows rows(kColumns, "ssssf");
    for (const Pattern& pattern : pattern::builtInPatterns()) {
        rows.text(pattern.id);
        rows.text(pattern.name);
        rows.text(pattern::toString(pattern.task));
        rows.text(pattern::toString(pattern.condition));
        rows.number(pattern.duration_s);
        rows.endRow();
    }
    return std::move(rows).table();
}

Pattern fromSamples(const py::object& times, const py::object& intensities, const std::string& id,
                    const std::string& name) {
    const std::vector<double> times_s = numbers(times, "times_s");
    const auto samples = realArray<double>(intensities, "intensities");
    needShape(samples, "intensities", {py::ssize_t(times_s.size()), py::ssize_t(core::kTactors)},
              ("(" + std::to_string(times_s.size()) + ", 6)").c_str());
    if (times_s.size() < 2 || times_s.size() > Pattern::kMostBreakpoints)
        throw wrongValue("times_s", "2 to " + std::to_string(Pattern::kMostBreakpoints) + " times",
                         std::to_string(times_s.size()));
    Pattern made;
    made.id = id;
    made.name = name;
    made.duration_s = times_s.back();
    for (std::size_t k = 0; k < times_s.size(); ++k) {
        if (!(times_s[k] >= 0.0 && times_s[k] <= Pattern::kLongest_s) ||
            (k > 0 && times_s[k] < times_s[k - 1]))
            throw wrongValue("times_s", "times from 0 to 86400 s that do not decrease",
                             std::string(py::repr(py::float_(times_s[k]))));
        for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor) {
            const double intensity = samples.data()[k * core::kTactors + tactor];
            if (!(intensity >= 0.0 && intensity <= 1.0))
                throw wrongValue("intensities", "0 to 1", std::string(py::repr(py::float_(intensity))));
            made.tracks[tactor].push_back({times_s[k], intensity});
        }
    }
    // A tactor that is never on needs no corners.
    for (pattern::Track& track : made.tracks) {
        if (std::ranges::all_of(track, [](const pattern::Breakpoint& at) { return at.intensity == 0.0; }))
            track.clear();
    }
    return made;
}

} // namespace

void bindPatterns(py::module_& module) {
    py::class_<Pattern>(module, "Pattern", py::module_local())
        .def_readonly("id", &Pattern::id)
        .def_readonly("name", &Pattern::name)
        .def_readonly("notes", &Pattern::notes)
        .def_readonly("duration_s", &Pattern::duration_s)
        .def_property_readonly("task", [](const Pattern& self) { return pattern::toString(self.task); })
        .def_property_readonly("condition",
                               [](const Pattern& self) { return pattern::toString(self.condition); })
        .def_property_readonly("tags", [](const Pattern& self) { return py::tuple(py::cast(self.tags)); })
        .def("evaluate", &evaluate)
        .def("predicted", &predicted)
        .def("save", &save)
        .def("check", &check);
    module.def("pattern", &find);
    module.def("patterns", &list);
    module.def("pattern_from_samples", &fromSamples);
}

} // namespace teleta::python
