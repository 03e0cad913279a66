// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/tactile/locate_command.h"

#include "app/cli/base/column_reader.h"
#include "backend/vision/calibration/camera_file.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

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

} // namespace

QString LocateCommand::summary() const {
    return LocateText::tr("Points on the tactile cylinder that belong to pixels of its camera");
}

const char* LocateCommand::example() const {
    return "teleta simulate vtacarm-calibration --duration 60 --out run\n"
           "  teleta locate run/camera.json run/pairs.csv --out points.csv";
}

void LocateCommand::declare(CLI::App& app) {
    const auto help = [](const char* text) { return LocateText::tr(text).toStdString(); };
    app.add_option("camera", m_cameraPath,
                   help(QT_TRANSLATE_NOOP("LocateCommand", "Camera file that teleta calibrate has written")))
        ->type_name("CAMERA.json")
        ->required();
    app.add_option("pixels", m_pixelsPath,
                   help(QT_TRANSLATE_NOOP("LocateCommand", "CSV with the columns u_px,v_px")))
        ->type_name("PIXELS.csv")
        ->required();
    declareOut(app, m_output.outPath);
    declareJson(app, m_output.json);
}

core::Expected<void> LocateCommand::run() {
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

} // namespace teleta::cli
