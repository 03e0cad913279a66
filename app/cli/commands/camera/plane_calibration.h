// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/gel/marker_gel_file.h"
#include "backend/vision/gel/plane_fit.h"

#include <CLI/CLI.hpp>
#include <opencv2/core.hpp>

#include <string>
#include <vector>

namespace teleta::cli {

/// The part of "teleta calibrate" that finds how pixels become places on a flat gel: from the picture of a
/// chessboard, from a ruler, or from the distance of the gel's markers. Writes lines for the sensor file.
class PlaneCalibration {
public:
    void declare(CLI::App& app);
    [[nodiscard]] bool isWanted() const { return m_wanted; }
    /// Whether a picture is needed.
    [[nodiscard]] bool hasRuler() const { return !m_rulers.empty(); }
    /// Empty without one.
    [[nodiscard]] const std::string& sensorPath() const { return m_sensorPath; }

    /// picturePath: a picture, for markers also a video; of a ruler empty or a picture of its size. outPath:
    /// for the lines; empty: they are printed. Error: as the readers; badInput: the picture does not show
    /// what is looked for.
    [[nodiscard]] core::Expected<void> run(const std::string& picturePath, const std::string& outPath,
                                           bool json) const;

private:
    [[nodiscard]] core::Expected<vision::PlaneFit> fit(const std::string& picturePath) const;
    [[nodiscard]] core::Expected<vision::PlaneFit> fitBoard(const vision::MarkerGelFile& file,
                                                            const std::string& picturePath) const;
    [[nodiscard]] core::Expected<vision::PlaneFit> fitMarkers(const vision::MarkerGelFile& file,
                                                              const std::string& picturePath) const;
    [[nodiscard]] core::Expected<vision::PlaneFit> fitRulers(const vision::MarkerGelFile& file,
                                                             const std::string& picturePath) const;
    [[nodiscard]] std::vector<vision::RulerReading> readings() const;
    [[nodiscard]] core::Expected<void> straighten(const vision::MarkerGelFile& file, const cv::Size& size,
                                                  std::vector<vision::PlanePair>& pairs) const;

    bool m_wanted = false;
    std::string m_sensorPath;
    std::string m_board;
    double m_square_mm = 0.0;
    double m_pitch_mm = 0.0;
    std::vector<std::string> m_rulers;
};

} // namespace teleta::cli
