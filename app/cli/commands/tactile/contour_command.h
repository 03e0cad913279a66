// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command.h"
#include "backend/contour/cubic_spline.h"
#include "backend/contour/shape_recogniser.h"

#include <string>
#include <vector>

namespace teleta::cli {

/// teleta contour: shape and spline of a series of contact points.
class ContourCommand : public Command {
public:
    [[nodiscard]] const char* name() const override { return "contour"; }
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] const char* example() const override;
    void declare(CLI::App& app) override;
    [[nodiscard]] core::Expected<void> run() override;

private:
    [[nodiscard]] core::Expected<std::vector<contour::Point>> readPoints() const;
    [[nodiscard]] core::Expected<void> writeCurve(const contour::CubicSpline& spline) const;

    std::string m_pointsPath;
    std::string m_spline = "approximating";
    std::string m_curvePath;
    double m_resolution_m = contour::RecognitionSettings{}.resolution_m;
    int m_samples = 200;
    bool m_closed = false;
    bool m_json = false;
};

} // namespace teleta::cli
