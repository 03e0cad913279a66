// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/calibration/camera_calibration.h"

#include <QString>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace teleta::vision {

/// How a camera was calibrated, as stored in its file.
struct CalibrationSummary {
    std::string method; ///< empty: unknown
    std::size_t pairs = 0;
    std::size_t kept = 0;
    double rms_px = 0.0;
    double mean_px = 0.0;
    double mean_error_m = 0.0;
    std::vector<std::string> warnings{}; ///< names of CalibrationWarning
};
[[nodiscard]] CalibrationSummary summaryOf(const Calibration& calibration);

/// Content of a camera file.
struct CameraFile {
    CylinderCamera camera;
    CalibrationSummary summary;
    nlohmann::ordered_json others =
        nlohmann::ordered_json::object(); ///< unknown keys, written back unchanged
};

/// JSON document in the format "teleta-camera", version 1: image size, K, R, C, mirrored, distortion, valid
/// radius (written for information, not read: it follows from the distortion), cylinder, noise and covariance
/// of the parameters, how it was calibrated, then the unknown keys.
[[nodiscard]] nlohmann::ordered_json cameraJson(const CameraFile& file);

/// Reads a camera file. file: for errors. Error: badInput with line and column: not JSON, another format or
/// version, a missing key, a value out of range, parameters that are not a valid camera. Thread: any.
[[nodiscard]] core::Expected<CameraFile> parseCamera(std::string text, const std::string& file);
[[nodiscard]] core::Expected<CameraFile> readCamera(const std::string& path);
[[nodiscard]] core::Expected<void> writeCamera(const CameraFile& camera, const std::string& path);

/// Reads pairs from a CSV file with the columns u_px,v_px,x_m,y_m,z_m; other columns are ignored. cancelled:
/// polled between rows. Error: notFound, ioFailed, cancelled, badInput with line and column. Thread: any.
[[nodiscard]] core::Expected<std::vector<CalibrationPair>> readPairs(const std::string& path,
                                                                     bool (*cancelled)() = nullptr);
/// Writes pairs as readPairs() reads them.
[[nodiscard]] core::Expected<void> writePairs(const std::vector<CalibrationPair>& pairs,
                                              const std::string& path);
/// Writes one row per pair: u_px,v_px,x_m,y_m,z_m,kept (1 or 0), then the errors of the camera: du_px,dv_px
/// (projected minus pixel), x_located_m,y_located_m,z_located_m,error_m; NA where undefined.
[[nodiscard]] core::Expected<void> writeResiduals(const std::vector<CalibrationPair>& pairs,
                                                  const Calibration& calibration, const std::string& path);

/// Error for people: why no camera can be found from so many pairs, and what to do about it. Translated.
[[nodiscard]] core::Error describe(CalibrationRefusal refusal, std::size_t pairs);
/// Text for people: what was seen in the pairs, and what to do about it. holeFactor: by which x and y of the
/// points were multiplied before the calibration. Translated.
[[nodiscard]] QString describe(CalibrationWarning warning, const Calibration& calibration, double holeFactor);

} // namespace teleta::vision
