// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/column_reader.h"
#include "app/cli/base/command_io.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/tactile/tactile_commands.h"
#include "backend/vision/calibration/camera_file.h"

#include <QCoreApplication>

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace teleta::cli {

namespace {

struct LocateText {
    Q_DECLARE_TR_FUNCTIONS(LocateCommand)
};

void writePoint(const vision::CylinderCamera& camera, const Eigen::Vector2d& pixel, RowOutput& rows) {
    const auto point_m = camera.locate_m(pixel);
    for (Eigen::Index i = 0; i < 3; ++i)
        rows.number(point_m ? std::optional<double>((*point_m)[i]) : std::nullopt);
    std::optional<double> deviation_m;
    if (point_m) {
        if (const auto known_m = camera.standardDeviation_m(*point_m))
            deviation_m = *known_m;
    }
    rows.number(deviation_m);
    rows.endRow();
}

class LocateCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "camera", m_cameraPath,
                  LocateText::tr("Camera file that teleta calibrate has written"), "CAMERA.json")
            ->required();
        addOption(app, "pixels", m_pixelsPath, LocateText::tr("CSV with the columns u_px,v_px"), "PIXELS.csv")
            ->required();
        declareOut(app, m_output.outPath);
        declareJson(app, m_output.json);
    }

    [[nodiscard]] core::Expected<void> run() const {
        TELETA_TRY(const vision::CameraFile file, vision::readCamera(m_cameraPath));
        constexpr std::array<std::string_view, 2> kNames{"u_px", "v_px"};
        TELETA_TRY(ColumnReader reader, ColumnReader::open(m_pixelsPath, kNames));
        constexpr std::array<std::string_view, 4> kColumns{"x_m", "y_m", "z_m", "sd_m"};
        TELETA_TRY(RowOutput rows, RowOutput::open(kColumns, m_output));

        const core::Expected<void> read =
            reader.forEachRow(rows.onTerminal(), [&](std::span<const double> pixel) {
                writePoint(file.camera, {pixel[0], pixel[1]}, rows);
                rows.flushIfDue();
                return !rows.failed();
            });
        // What was located before the work was cut short is kept.
        const core::Expected<void> finished = rows.finish();
        return read ? finished : read;
    }

private:
    std::string m_cameraPath;
    std::string m_pixelsPath;
    RowOptions m_output;
};

} // namespace

Command locateCommand() {
    return makeCommand<LocateCommand>(
        "locate", LocateText::tr("Points on the tactile cylinder that belong to pixels of its camera"),
        "teleta simulate vtacarm-calibration --duration 60 --out run\n"
        "  teleta locate run/camera.json run/pairs.csv --out points.csv");
}

} // namespace teleta::cli
