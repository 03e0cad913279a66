// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/calibration/camera_file.h"

#include "backend/core/data/input_file.h"
#include "backend/core/data/json_document.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace teleta::vision {

namespace {

using core::JsonDocument;
using core::JsonReader;
using nlohmann::ordered_json;

struct CameraText {
    Q_DECLARE_TR_FUNCTIONS(CameraText)
};

constexpr const char* kFormat = "teleta-camera";
constexpr long long kVersion = 1;
// Far beyond what a camera in a tube can be.
constexpr double kHuge = 1e9;
constexpr double kMost_px = 1e7;
constexpr double kMost_m = 1e3;
constexpr double kMostLens = 1e6;
constexpr double kMostCovariance = 1e15;
constexpr std::array<const char*, 8> kLensKeys{"k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2"};
constexpr std::array<std::string_view, 14> kKeys{
    "format",   "version",    "width_px",        "height_px", "K",        "R",          "C_m",
    "mirrored", "distortion", "valid_radius_px", "cylinder",  "noise_px", "covariance", "calibration"};

template <typename Matrix>
ordered_json rowsOf(const Matrix& matrix) {
    ordered_json rows = ordered_json::array();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        ordered_json row = ordered_json::array();
        for (Eigen::Index j = 0; j < matrix.cols(); ++j)
            row.push_back(matrix(i, j));
        rows.push_back(std::move(row));
    }
    return rows;
}

/// most: of the size of each number.
template <typename Matrix>
void readRows(JsonReader& reader, const ordered_json& value, Matrix& matrix, double most) {
    const auto rows = static_cast<std::size_t>(matrix.rows());
    const auto columns = static_cast<std::size_t>(matrix.cols());
    const ordered_json& all = reader.array(value, rows, rows);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const ordered_json& row = reader.array(all[i], columns, columns);
        for (std::size_t j = 0; j < row.size(); ++j)
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                reader.number(row[j], -most, most);
    }
}

std::array<double*, 8> values(RationalDistortion& k) {
    return {&k.k1, &k.k2, &k.k3, &k.k4, &k.k5, &k.k6, &k.p1, &k.p2};
}

void readCovariance(JsonReader& reader, const ordered_json& value, CameraCovariance& covariance) {
    readRows(reader, value, covariance, kMostCovariance);
    if (reader.error())
        return;
    // Rounding in the file, and in whoever wrote it, may leave traces.
    constexpr double kTrace = 1e-6;
    const Eigen::ArrayXd variances = covariance.diagonal().array();
    bool isOne = (variances >= 0.0).all();
    for (Eigen::Index i = 0; i < covariance.rows() && isOne; ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            const double most = std::sqrt(variances[i] * variances[j]);
            isOne = isOne && std::abs(covariance(i, j)) <= (1.0 + kTrace) * most &&
                    std::abs(covariance(i, j) - covariance(j, i)) <= kTrace * most;
        }
    }
    if (!isOne)
        reader.fail(value, CameraText::tr("this is not a covariance"),
                    CameraText::tr("a symmetric matrix without negative variances"));
}

void readFocus(JsonReader& reader, CameraParameters& camera) {
    Eigen::Matrix3d k = Eigen::Matrix3d::Identity();
    const ordered_json& value = reader.member(reader.root(), "K");
    readRows(reader, value, k, kMost_px);
    if (!reader.error() && (k(1, 0) != 0.0 || k(2, 0) != 0.0 || k(2, 1) != 0.0 || k(2, 2) != 1.0))
        reader.fail(value, CameraText::tr("this is not a camera matrix"),
                    "[[fx, s, cx], [0, fy, cy], [0, 0, 1]]");
    camera.fx_px = k(0, 0);
    camera.skew_px = k(0, 1);
    camera.cx_px = k(0, 2);
    camera.fy_px = k(1, 1);
    camera.cy_px = k(1, 2);
}

QString wordsFor(CameraModel::Refusal refusal) {
    switch (refusal) {
    case CameraModel::Refusal::notFinite:
    case CameraModel::Refusal::noImage:
        return CameraText::tr("a parameter is out of range");
    case CameraModel::Refusal::noFocus:
        return CameraText::tr("the focal lengths in K are not positive");
    case CameraModel::Refusal::notRotation:
        return CameraText::tr("R is not a rotation");
    case CameraModel::Refusal::folds:
        return CameraText::tr("the distortion folds on the axis");
    }
    return {};
}

} // namespace

CalibrationSummary summaryOf(const Calibration& calibration) {
    CalibrationSummary summary{
        toString(calibration.method), calibration.residuals.size(), calibration.kept,
        calibration.rms_px,           calibration.mean_px,          calibration.mean_error_m};
    for (const CalibrationWarning warning : calibration.warnings)
        summary.warnings.emplace_back(toString(warning));
    return summary;
}

ordered_json cameraJson(const CameraFile& file) {
    const CameraModel& model = file.camera.camera();
    CameraParameters parameters = model.parameters();
    ordered_json lens;
    const auto lensValues = values(parameters.distortion);
    for (std::size_t i = 0; i < kLensKeys.size(); ++i)
        lens[kLensKeys[i]] = *lensValues[i];
    const CylinderSurface& surface = file.camera.surface();
    ordered_json document{{"format", kFormat},
                          {"version", kVersion},
                          {"width_px", parameters.width_px},
                          {"height_px", parameters.height_px},
                          {"K", rowsOf(parameters.cameraMatrix_px())},
                          {"R", rowsOf(parameters.R_Camera_Sensor)},
                          {"C_m", rowsOf(parameters.p_Sensor_Camera_m.transpose())[0]},
                          {"mirrored", parameters.mirrored},
                          {"distortion", std::move(lens)},
                          {"valid_radius_px", model.validRadius_px()},
                          {"cylinder",
                           {{"radius_m", surface.radius_m},
                            {"lowest_z_m", surface.lowest_z_m},
                            {"highest_z_m", surface.highest_z_m}}},
                          {"noise_px", file.camera.noise_px()},
                          {"covariance", rowsOf(file.camera.covariance())},
                          {"calibration",
                           {{"method", file.summary.method},
                            {"pairs", file.summary.pairs},
                            {"kept", file.summary.kept},
                            {"rms_px", file.summary.rms_px},
                            {"mean_px", file.summary.mean_px},
                            {"mean_mm", 1e3 * file.summary.mean_error_m},
                            {"warnings", file.summary.warnings}}}};
    for (const auto& [key, value] : file.others.items())
        document[key] = value;
    return document;
}

core::Expected<CameraFile> parseCamera(std::string text, const std::string& file) {
    TELETA_TRY(const JsonDocument document, JsonDocument::parse(std::move(text), file));
    JsonReader reader(document);
    const ordered_json& root = reader.root();
    if (const ordered_json* format = reader.find(root, "format");
        !reader.error() && (format == nullptr || *format != kFormat))
        reader.fail(format == nullptr ? root : *format, CameraText::tr("this is not a camera file"),
                    "\"format\": \"teleta-camera\"");
    if (const ordered_json& version = reader.member(root, "version");
        !reader.error() && reader.integer(version, 1, 1'000'000) > kVersion)
        reader.fail(version, CameraText::tr("the file was written by a newer version"),
                    QString::number(kVersion));

    CameraParameters camera;
    camera.width_px = static_cast<int>(reader.integer(reader.member(root, "width_px"), 1, kLargestSide_px));
    camera.height_px = static_cast<int>(reader.integer(reader.member(root, "height_px"), 1, kLargestSide_px));
    readFocus(reader, camera);
    readRows(reader, reader.member(root, "R"), camera.R_Camera_Sensor, 2.0);
    const ordered_json& centre = reader.array(reader.member(root, "C_m"), 3, 3);
    for (std::size_t i = 0; i < centre.size(); ++i)
        camera.p_Sensor_Camera_m[static_cast<Eigen::Index>(i)] = reader.number(centre[i], -kMost_m, kMost_m);
    camera.mirrored = reader.boolean(root, "mirrored", false);
    const ordered_json& lens = reader.member(root, "distortion");
    const auto lensValues = values(camera.distortion);
    for (std::size_t i = 0; i < kLensKeys.size(); ++i)
        *lensValues[i] = reader.number(lens, kLensKeys[i], -kMostLens, kMostLens, 0.0);

    CylinderSurface surface;
    if (const ordered_json* cylinder = reader.find(root, "cylinder")) {
        surface.radius_m = reader.number(*cylinder, "radius_m", 1e-9, kMost_m, surface.radius_m);
        surface.lowest_z_m = reader.number(*cylinder, "lowest_z_m", -kMost_m, kMost_m, surface.lowest_z_m);
        surface.highest_z_m = reader.number(*cylinder, "highest_z_m", -kMost_m, kMost_m, surface.highest_z_m);
        if (!surface.isUsable())
            reader.fail(*cylinder, CameraText::tr("the cylinder has no length"), "lowest_z_m < highest_z_m");
    }
    const double noise_px = reader.number(root, "noise_px", 0.0, kMost_px, 0.0);
    CameraCovariance covariance = CameraCovariance::Zero();
    if (const ordered_json* rows = reader.find(root, "covariance"))
        readCovariance(reader, *rows, covariance);
    CalibrationSummary summary;
    if (const ordered_json* told = reader.find(root, "calibration")) {
        summary.method = reader.text(*told, "method", {});
        summary.pairs = static_cast<std::size_t>(reader.number(*told, "pairs", 0, kHuge, 0));
        summary.kept = static_cast<std::size_t>(reader.number(*told, "kept", 0, kHuge, 0));
        summary.rms_px = reader.number(*told, "rms_px", 0.0, kHuge, 0.0);
        summary.mean_px = reader.number(*told, "mean_px", 0.0, kHuge, 0.0);
        summary.mean_error_m = 1e-3 * reader.number(*told, "mean_mm", 0.0, kHuge, 0.0);
        constexpr std::size_t kMostWarnings = 100;
        if (const ordered_json* warnings = reader.find(*told, "warnings")) {
            for (const ordered_json& warning : reader.array(*warnings, 0, kMostWarnings))
                summary.warnings.push_back(reader.text(warning));
        }
    }
    if (reader.error())
        return core::Unexpected(*reader.error());
    const auto model = CameraModel::create(camera);
    if (!model)
        return core::Unexpected(document.errorAt(root, wordsFor(model.error()), {}));
    CameraFile result{CylinderCamera(*model, surface, covariance, noise_px), summary};
    for (const auto& [key, value] : root.items()) {
        if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end())
            result.others[key] = value;
    }
    return result;
}

core::Expected<CameraFile> readCamera(const std::string& path) {
    TELETA_TRY(std::string text, core::readFile(path));
    return parseCamera(std::move(text), path);
}

core::Expected<void> writeCamera(const CameraFile& camera, const std::string& path) {
    return core::writeFile(path, cameraJson(camera).dump(2) + "\n");
}

} // namespace teleta::vision
