// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "backend/vision/calibration/camera_calibration.h"

#include <string>

namespace teleta::cli {

/// teleta calibrate: camera, lens and handedness from pairs of pixels and points on the cylinder.
class CalibrateCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "calibrate"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    std::string m_pairsPath;
    vision::CalibrationSettings m_settings;
    double m_radius_mm = 1e3 * vision::CylinderSurface{}.radius_m;
    double m_length_mm = 1e3 * vision::CylinderSurface{}.highest_z_m;
    double m_holeFactor = 1.0;
    std::string m_method = "robust";
    std::string m_outPath;
    std::string m_residualsPath;
    bool m_json = false;
};

} // namespace teleta::cli
