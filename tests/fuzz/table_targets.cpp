// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/contact_segmenter.h"
#include "backend/contact/contact_tracker.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/contact/tactile_features.h"
#include "backend/contour/cubic_spline.h"
#include "backend/contour/shape_recogniser.h"
#include "backend/core/data/csv_reader.h"
#include "backend/core/data/frame_file.h"
#include "backend/equilibration/taxel_gain_file.h"
#include "backend/stiffness/stiffness_estimator.h"
#include "tests/fuzz/memory_file.h"
#include "tests/support/floating_point_traps.h"

#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace teleta::fuzz {

namespace {

struct RowStart {
    std::uint64_t offset = 0;
    long long line = 0;
    std::vector<std::string> fields;
};

/// Columns of numbers by name, row by row; empty when a reader refuses.
std::optional<std::vector<std::vector<double>>> readNumbers(const std::string& path,
                                                            std::span<const std::string_view> names) {
    core::Expected<core::CsvReader> csv = core::CsvReader::open(path);
    if (!csv) {
        requireExplained(csv.error(), path);
        return {};
    }
    const core::Expected<std::vector<std::size_t>> columns = csv->columns(names);
    if (!columns) {
        requireExplained(columns.error(), path);
        return {};
    }
    std::vector<std::vector<double>> rows;
    std::vector<double> row;
    for (;;) {
        const core::Expected<bool> more = csv->next(row);
        if (!more) {
            requireExplained(more.error(), path);
            return {};
        }
        if (!*more)
            return rows;
        std::vector<double>& kept = rows.emplace_back();
        for (const std::size_t column : *columns) {
            require(std::isfinite(row[column]), "numbers are finite");
            kept.push_back(row[column]);
        }
    }
}

bool isShare(double value) {
    return value >= 0.0 && value <= 1.0;
}

void requireSound(const contact::TactileFeatures& features) {
    const auto finite = [](const std::optional<double>& value) { return !value || std::isfinite(*value); };
    require(std::isfinite(features.force_N) && std::isfinite(features.peak_N), "forces are finite");
    for (const auto& value :
         {features.copX_m, features.copY_m, features.cocX_m, features.cocY_m, features.dzmpX_m,
          features.dzmpY_m, features.alphaZ_rad, features.lambda1_m2, features.lambda2_m2})
        require(finite(value), "features are finite or absent");
}

} // namespace

bool csv(Bytes bytes) {
    const MemoryFile file(bytes);
    core::Expected<core::CsvReader> reader = core::CsvReader::open(file.path());
    if (!reader) {
        requireExplained(reader.error(), file.path());
        return false;
    }
    std::vector<RowStart> rows;
    std::vector<std::string_view> fields;
    for (;;) {
        RowStart start{reader->bytesRead(), reader->nextLine(), {}};
        const core::Expected<bool> more = reader->nextText(fields);
        if (!more) {
            requireExplained(more.error(), file.path());
            return false;
        }
        if (!*more)
            break;
        require(fields.size() == reader->header().size(), "a row has a field a column");
        start.fields = std::vector<std::string>(fields.begin(), fields.end());
        rows.push_back(std::move(start));
    }
    require(reader->bytesRead() == bytes.size(), "all bytes were read");
    // The same rows again from the last to the first, and as numbers.
    std::vector<double> numbers;
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        require(reader->seek(row->offset, row->line).has_value(), "a start of a row can be gone to");
        const core::Expected<bool> found = reader->nextText(fields);
        require(found && *found &&
                    std::equal(fields.begin(), fields.end(), row->fields.begin(), row->fields.end()),
                "a row is the same when it is read again");
        require(reader->seek(row->offset, row->line).has_value(), "a start of a row can be gone to again");
        const core::Expected<bool> counted = reader->next(numbers, true);
        if (!counted)
            requireExplained(counted.error(), file.path());
        require(!counted || numbers.size() == row->fields.size(), "a row has a number a column");
    }
    return true;
}

bool frameCsv(Bytes bytes) {
    const MemoryFile file(bytes);
    const core::Expected<std::size_t> taxels = core::FrameFile::countTaxels(file.path());
    if (!taxels) {
        requireExplained(taxels.error(), file.path());
        return false;
    }
    constexpr std::size_t kMost = 512;
    core::ArrayLayout layout{.rows = 1, .columns = static_cast<int>(std::min(*taxels, kMost))};
    if (layout.columns % 2 == 0)
        layout = {.rows = 2, .columns = layout.columns / 2};
    core::Expected<core::FrameFile> frames = core::FrameFile::open(file.path(), layout);
    if (!frames) {
        requireExplained(frames.error(), file.path());
        return false;
    }
    std::vector<float> raw(layout.taxels());
    std::vector<float> load_N(layout.taxels());
    std::vector<std::uint8_t> dead(layout.taxels());
    const core::Expected<std::vector<float>> tare = core::readTare(file.path(), layout);
    if (const auto press = core::readFrames(file.path(), layout)) {
        const test::FloatingPointTraps traps;
        const auto gains =
            equilibration::findTaxelGains(layout, std::array{equilibration::GainPress{*press, {}}});
        for (std::size_t i = 0; gains && i < gains->taxels.size(); ++i) {
            const equilibration::TaxelGain& taxel = gains->taxels[i];
            require(!taxel.isGood() || (std::isfinite(taxel.gain) && taxel.gain > 0.0 &&
                                        std::isfinite(taxel.error) && taxel.error >= 0.0),
                    "a good taxel has a gain");
        }
    }
    contact::ConditioningSettings conditioning;
    conditioning.tare = tare.value_or(std::vector<float>());
    const contact::FrameConditioner conditioner(layout.taxels(), std::move(conditioning));
    contact::ContactSegmenter segmenter(layout);
    contact::ContactTracker tracker(contact::trackingFor(layout));
    contact::FeatureSettings features;
    features.automaticThreshold = bytes.size() % 2 == 0;
    features.orientation = contact::OrientationMode::weighted;
    contact::FeatureExtractor extractor(layout, features);
    double time_s = 0.0;
    for (double before_s = -HUGE_VAL;; before_s = time_s) {
        const core::Expected<bool> more = frames->next(time_s, raw);
        if (!more) {
            requireExplained(more.error(), file.path());
            return false;
        }
        if (!*more)
            return true;
        require(std::isfinite(time_s) && time_s >= before_s, "times never decrease");
        const test::FloatingPointTraps traps;
        conditioner.apply(raw, load_N, dead);
        requireSound(extractor.compute(load_N, dead));
        const std::span<contact::Contact> contacts = segmenter.segment(load_N, dead);
        tracker.assign(contacts, time_s);
        for (const contact::Contact& contact : contacts)
            require(contact.id > 0 && contact.taxels > 0 && std::isfinite(contact.x_m) &&
                        std::isfinite(contact.y_m) && std::isfinite(contact.force_N),
                    "contacts have a place and a force");
    }
}

bool gainCsv(Bytes bytes) {
    const MemoryFile file(bytes);
    constexpr core::ArrayLayout kLayout{.rows = 2, .columns = 3};
    const core::Expected<equilibration::TaxelGains> gains =
        equilibration::readTaxelGains(file.path(), kLayout);
    if (!gains) {
        requireExplained(gains.error(), file.path());
        return false;
    }
    require(gains->taxels.size() == kLayout.taxels(), "each taxel has a row");
    for (const equilibration::TaxelGain& taxel : gains->taxels)
        require(taxel.isGood() ? std::isfinite(taxel.gain) && taxel.gain > 0.0 && taxel.error >= 0.0
                               : std::isnan(taxel.gain) && std::isnan(taxel.error),
                "a taxel that is used has a gain, and no other");
    return true;
}

bool contourCsv(Bytes bytes) {
    constexpr std::array<std::string_view, 2> kNames{"x_m", "y_m"};
    constexpr std::size_t kMostPoints = 48; // the recogniser takes milliseconds for more
    const MemoryFile file(bytes);
    const auto rows = readNumbers(file.path(), kNames);
    if (!rows)
        return false;
    std::vector<contour::Point> points;
    for (const std::vector<double>& row : *rows) {
        if (points.size() < kMostPoints)
            points.emplace_back(row[0], row[1]);
    }
    const test::FloatingPointTraps traps;
    for (const bool closed : {false, true}) {
        const auto spline = contour::CubicSpline::fit(points, contour::SplineKind::interpolating, closed);
        if (!spline)
            return false;
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const double at = t * static_cast<double>(spline->segments());
            require(spline->position_m(at).allFinite(), "a curve has points");
            require(std::isfinite(spline->curvature_perM(at)), "a curve has a curvature");
        }
        require(spline->length_m() >= 0.0, "a curve has a length");
    }
    const auto seen = contour::recogniseShape(points);
    require(seen.has_value(), "points that make a curve have a shape");
    const double sum = std::accumulate(seen->probability.begin(), seen->probability.end(), 0.0);
    require(isShare(seen->confidence), "a confidence is 0..1");
    require(points.empty() || std::abs(sum - 1.0) < 1e-9, "probabilities sum to 1");
    return true;
}

bool touchCsv(Bytes bytes) {
    constexpr std::array<std::string_view, 3> kNames{"time_s", "joint_angle_rad", "joint_torque_nm"};
    const MemoryFile file(bytes);
    const auto rows = readNumbers(file.path(), kNames);
    if (!rows)
        return false;
    std::vector<stiffness::JointSample> samples;
    for (const std::vector<double>& row : *rows)
        samples.push_back({row[0], row[1], row[2]});
    const test::FloatingPointTraps traps;
    for (const stiffness::Method method : {stiffness::Method::twoPoint, stiffness::Method::regression}) {
        stiffness::TouchSettings settings;
        settings.contactDistance_m = 0.2;
        settings.method = method;
        const auto touch = stiffness::estimateStiffness(samples, settings);
        if (!touch)
            return false;
        for (const std::optional<double>& value : {touch->object.value_NPerM, touch->object.lower95_NPerM,
                                                   touch->object.upper95_NPerM, touch->total.value_NPerM})
            require(!value || (std::isfinite(*value) && *value > 0.0), "a stiffness is positive and finite");
    }
    return true;
}

} // namespace teleta::fuzz
