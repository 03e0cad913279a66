// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_reader.h"
#include "backend/core/data/csv_writer.h"
#include "backend/core/failure.h"
#include "backend/vision/calibration/calibration_checks.h"
#include "backend/vision/calibration/camera_file.h"

#include <QCoreApplication>

#include <array>
#include <string_view>

namespace teleta::vision {

namespace {

struct PairText {
    Q_DECLARE_TR_FUNCTIONS(PairText)
};

constexpr std::array<std::string_view, 5> kPairColumns{"u_px", "v_px", "x_m", "y_m", "z_m"};

void writePair(core::CsvWriter& csv, const CalibrationPair& pair) {
    for (const double value : pair.pixel)
        csv.number(value);
    for (const double value : pair.p_Sensor_m)
        csv.number(value);
}

} // namespace

core::Expected<std::vector<CalibrationPair>> readPairs(const std::string& path, bool (*cancelled)()) {
    TELETA_TRY(core::CsvReader reader, core::CsvReader::open(path));
    TELETA_TRY(const std::vector<std::size_t> columns, reader.columns(kPairColumns));
    // Fitting more would take minutes.
    constexpr std::size_t kMostPairs = 100'000;
    std::vector<CalibrationPair> pairs;
    std::vector<double> row;
    for (;;) {
        TELETA_TRY(const bool more, reader.next(row));
        if (!more)
            return pairs;
        if (cancelled != nullptr && cancelled())
            return core::failed(core::ErrorKind::cancelled, PairText::tr("interrupted"));
        const auto value = [&](std::size_t i) { return row[columns[i]]; };
        pairs.push_back({{value(0), value(1)}, {value(2), value(3), value(4)}});
        if (pairs.size() > kMostPairs)
            return core::failed(core::ErrorKind::badInput, PairText::tr("the file has too many pairs"),
                                PairText::tr("at most %1").arg(kMostPairs), reader.place(0));
    }
}

core::Expected<void> writePairs(const std::vector<CalibrationPair>& pairs, const std::string& path) {
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, kPairColumns));
    for (const CalibrationPair& pair : pairs) {
        writePair(csv, pair);
        csv.endRow();
    }
    return csv.finish();
}

core::Expected<void> writeResiduals(const std::vector<CalibrationPair>& pairs, const Calibration& calibration,
                                    const std::string& path) {
    constexpr std::array<std::string_view, 12> kColumns{
        "u_px",  "v_px",  "x_m",         "y_m",         "z_m",         "kept",
        "du_px", "dv_px", "x_located_m", "y_located_m", "z_located_m", "error_m"};
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(path, kColumns));
    const auto numbers = [&](const auto& optional, Eigen::Index count) {
        for (Eigen::Index i = 0; i < count; ++i)
            csv.number(optional ? std::optional<double>((*optional)[i]) : std::nullopt);
    };
    for (std::size_t i = 0; i < pairs.size() && !csv.failed(); ++i) {
        writePair(csv, pairs[i]);
        const PairResidual& residual = calibration.residuals[i];
        csv.integer(residual.kept ? 1 : 0);
        numbers(residual.error_px, 2);
        numbers(residual.located_m, 3);
        csv.number(residual.error_m);
        csv.endRow();
    }
    return csv.finish();
}

QString describe(CalibrationWarning warning, const Calibration& calibration, double holeFactor) {
    const auto number = [](double value, int digits = 4) { return QString::number(value, 'g', digits); };
    const CameraParameters& camera = calibration.camera.camera().parameters();
    switch (warning) {
    case CalibrationWarning::offSurface: {
        if (!calibration.surfaceFactor)
            return PairText::tr("most points are on the axis of the cylinder, not on its surface");
        const auto [factor, error] = *calibration.surfaceFactor;
        const double radius_mm = 1e3 * calibration.camera.surface().radius_m;
        return PairText::tr(
                   "the points are %1 mm from the axis, the surface is at %2 mm: a hole factor of %3 "
                   "(standard error %4) brings them onto it, unless the radius is wrong")
            .arg(number(radius_mm / factor), number(radius_mm), number(holeFactor * factor),
                 number(holeFactor * error, 2));
    }
    case CalibrationWarning::beyondEnds:
        return PairText::tr("many points are beyond the ends of the cylinder: check its length, and where "
                            "z = 0 is");
    case CalibrationWarning::swappedPixels: {
        const OffMiddle off = offMiddle(camera);
        return PairText::tr("u and v seem to be swapped: the principal point is %1 px off the middle of the "
                            "image, and with u and v swapped %2 px")
            .arg(number(off.fitted_px, 3), number(off.swapped_px, 3));
    }
    case CalibrationWarning::outsideImage:
        return PairText::tr("many pixels are outside the image of %1 x %2 px: check its size")
            .arg(camera.width_px)
            .arg(camera.height_px);
    case CalibrationWarning::structured:
        return PairText::tr("neighbouring residuals are alike: the camera does not explain everything in the "
                            "pairs (a shell that has moved, a wrong radius)");
    }
    return {};
}

core::Error describe(CalibrationRefusal refusal, std::size_t pairs) {
    const auto refused = [](const QString& message, const QString& expected) {
        return core::failed(core::ErrorKind::refused, message, expected).value();
    };
    const QString spread = PairText::tr("points at several heights and all around the cylinder");
    switch (refusal) {
    case CalibrationRefusal::notFinite:
        return core::failed(core::ErrorKind::badInput,
                            PairText::tr("a coordinate is not a number, or too large"),
                            PairText::tr("finite pixels and metres"))
            .value();
    case CalibrationRefusal::badSettings:
        return refused(
            PairText::tr("the size of the image or of the cylinder is invalid"),
            PairText::tr("a positive radius, width and height of 1 to %1 pixels").arg(kLargestSide_px));
    case CalibrationRefusal::tooFewPairs:
        return refused(PairText::tr("there are too few pairs: %1").arg(pairs),
                       PairText::tr("at least 6, better 50 or more"));
    case CalibrationRefusal::repeatedPoints:
        return refused(PairText::tr("the pairs contain fewer than six different points"),
                       PairText::tr("at least 6 different points, each with its own pixel"));
    case CalibrationRefusal::onOneLine:
        return refused(
            PairText::tr("all points are on one line of the cylinder: the camera could turn about that line "
                         "without changing the image"),
            spread);
    case CalibrationRefusal::onOneRing:
        return refused(
            PairText::tr("all points are on one ring of the cylinder: the camera's distance and its focal "
                         "length cannot be distinguished"),
            spread);
    case CalibrationRefusal::inOnePlane:
        return refused(
            PairText::tr("all points are in one plane: the camera's distance and its focal length cannot be "
                         "distinguished"),
            spread);
    case CalibrationRefusal::noAgreement:
        return refused(
            PairText::tr("no camera agrees with enough of the pairs"),
            PairText::tr("at least half of the pairs and at least %1 in agreement: check that pixels and "
                         "points match, the image size and the cylinder radius")
                .arg(kFewestAgreeing));
    case CalibrationRefusal::notDetermined:
        return refused(
            PairText::tr("the pairs leave the camera undetermined: points on the surface would be uncertain "
                         "by more than %1 mm")
                .arg(1e3 * kLargestUncertainty_m),
            PairText::tr("more pairs, spread over the whole surface"));
    case CalibrationRefusal::folds:
        return refused(PairText::tr("the lens model folds in the region of the pairs"),
                       PairText::tr("more pairs near the lens, where the distortion is strongest"));
    }
    return {};
}

} // namespace teleta::vision
