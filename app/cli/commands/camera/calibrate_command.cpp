// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/frame_options.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/camera/camera_commands.h"
#include "app/cli/commands/camera/plane_calibration.h"
#include "backend/vision/calibration/camera_calibration.h"
#include "backend/vision/calibration/camera_file.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <vector>

namespace teleta::cli {

namespace {

using vision::Calibration;

struct CalibrateText {
    Q_DECLARE_TR_FUNCTIONS(CalibrateCommand)
};

nlohmann::ordered_json toJson(const Calibration& calibration, const vision::CameraFile& file,
                              double holeFactor) {
    const auto timesHoleFactor = [&](double vision::SurfaceFactor::*value) -> nlohmann::ordered_json {
        if (!calibration.surfaceFactor)
            return nullptr;
        return holeFactor * (*calibration.surfaceFactor).*value;
    };
    return {{"method", vision::toString(calibration.method)},
            {"pairs", calibration.residuals.size()},
            {"kept", calibration.kept},
            {"rms_px", calibration.rms_px},
            {"mean_px", calibration.mean_px},
            {"mean_mm", 1e3 * calibration.mean_error_m},
            {"valid_radius_px", calibration.camera.camera().validRadius_px()},
            {"uncertainty_mm", 1e3 * calibration.uncertainty_m},
            {"structured", calibration.isStructured()},
            {"reliable", calibration.isReliable()},
            {"warnings", file.summary.warnings},
            {"fitting_hole_factor", timesHoleFactor(&vision::SurfaceFactor::value)},
            {"fitting_hole_factor_se", timesHoleFactor(&vision::SurfaceFactor::standardError)},
            {"camera", vision::cameraJson(file)}};
}

core::Expected<void> printTable(const Calibration& calibration, double holeFactor) {
    const vision::CameraModel& camera = calibration.camera.camera();
    const vision::CameraParameters& parameters = camera.parameters();
    const Eigen::Vector3d& centre_m = camera.centre_m();
    Fields fields{
        {CalibrateText::tr("Pairs"), QString::number(calibration.residuals.size())},
        {CalibrateText::tr("Kept"), QString::number(calibration.kept)},
        {CalibrateText::tr("3D to 2D"),
         CalibrateText::tr("%1 px on average, %2 px rms")
             .arg(forPeople(calibration.mean_px), forPeople(calibration.rms_px))},
        {CalibrateText::tr("2D to 3D"),
         CalibrateText::tr("%1 mm on average").arg(forPeople(1e3 * calibration.mean_error_m))},
        {CalibrateText::tr("Uncertainty"),
         CalibrateText::tr("%1 mm of a point on the surface, by the camera alone")
             .arg(forPeople(1e3 * calibration.uncertainty_m, 3))},
        {CalibrateText::tr("Valid radius"),
         CalibrateText::tr("%1 px").arg(forPeople(camera.validRadius_px()))},
        {CalibrateText::tr("Focal lengths"),
         CalibrateText::tr("%1, %2 px").arg(forPeople(parameters.fx_px), forPeople(parameters.fy_px))},
        {CalibrateText::tr("Principal point"),
         CalibrateText::tr("%1, %2 px").arg(forPeople(parameters.cx_px), forPeople(parameters.cy_px))},
        {CalibrateText::tr("Camera centre"),
         CalibrateText::tr("%1, %2, %3 m")
             .arg(forPeople(centre_m.x()), forPeople(centre_m.y()), forPeople(centre_m.z()))},
        {CalibrateText::tr("Mirrored"),
         parameters.mirrored ? CalibrateText::tr("yes") : CalibrateText::tr("no")},
        {CalibrateText::tr("Residuals"),
         calibration.isStructured()
             ? CalibrateText::tr("neighbours are alike: the camera does not explain everything in the pairs")
             : CalibrateText::tr("without a pattern")}};
    if (!calibration.isReliable())
        fields.emplace_back(CalibrateText::tr("Reliable"), CalibrateText::tr("no"));
    for (const vision::CalibrationWarning warning : calibration.warnings) {
        // The row of the residuals tells the pattern.
        if (warning != vision::CalibrationWarning::structured)
            fields.emplace_back(CalibrateText::tr("Warning"),
                                vision::describe(warning, calibration, holeFactor));
    }
    return printFields(fields);
}

class CalibrateCommand {
public:
    void declare(CLI::App& app) {
        m_app = &app;
        addOption(
            app, "pairs", m_pairsPath,
            CalibrateText::tr("CSV with the columns u_px,v_px,x_m,y_m,z_m, at least 6 rows; with --plane a "
                              "picture of a chessboard, or a picture or video of the gel at rest"),
            "PAIRS.csv");
        m_plane.declare(app);
        addOption(app, "--width", m_settings.width_px, CalibrateText::tr("Width of the image, px"),
                  between(1, vision::kLargestSide_px));
        addOption(app, "--height", m_settings.height_px, CalibrateText::tr("Height of the image, px"),
                  between(1, vision::kLargestSide_px));
        addOption(app, "--radius-mm", m_radius_mm, CalibrateText::tr("Radius of the elastomer, mm"),
                  positive());
        addOption(app, "--length-mm", m_length_mm,
                  CalibrateText::tr("Length of the elastomer, from z = 0 of the sensor frame, mm"),
                  positive());
        addOption(app, "--hole-factor", m_holeFactor,
                  CalibrateText::tr("The points are holes of a shell: their x and y times this factor are on "
                                    "the elastomer (the paper's shell: 0.97)"),
                  positive());
        addChoice(app, "--method", m_method,
                  CalibrateText::tr("robust: camera and lens, wrong pairs are left out; paper: linear, "
                                    "without a lens, drops pairs that are off by more than 2 mm"),
                  {"robust", "paper"})
            ->capture_default_str();
        addOption(app, "-o,--out", m_outPath,
                  CalibrateText::tr(
                      "Write the camera, or with --plane the lines for the sensor file, to this file"),
                  "CAMERA.json");
        addOption(app, "--residuals", m_residualsPath,
                  CalibrateText::tr("Write each pair and its residual as CSV"), "OUT.csv");
        declareJson(app, m_json);
    }

    [[nodiscard]] core::Expected<void> run() {
        if (m_pairsPath.empty() && !(m_plane.isWanted() && m_plane.hasRuler()))
            refuse("pairs", CalibrateText::tr("a file is needed"));
        refuseToReplace(m_outPath, std::array{m_pairsPath, m_plane.sensorPath()});
        if (m_plane.isWanted()) {
            refuseOfCylinder();
            return m_plane.run(m_pairsPath, m_outPath, m_json);
        }
        refuseToReplace(m_residualsPath, std::array{m_pairsPath}, "--residuals");
        if (!m_outPath.empty() && m_outPath == m_residualsPath)
            refuse("--residuals", CalibrateText::tr("the camera is written to this file"));
        TELETA_TRY(std::vector<vision::CalibrationPair> pairs, vision::readPairs(m_pairsPath, interrupted));
        for (vision::CalibrationPair& pair : pairs)
            pair.p_Sensor_m.head<2>() *= m_holeFactor;
        m_settings.surface.radius_m = 1e-3 * m_radius_mm;
        m_settings.surface.highest_z_m = 1e-3 * m_length_mm;
        const auto calibration = vision::calibrate(pairs, m_settings, *vision::calibrationMethod(m_method));
        if (!calibration) {
            core::Error error = vision::describe(calibration.error(), pairs.size());
            error.where.file = m_pairsPath;
            return core::Unexpected(error);
        }
        if (interrupted())
            return core::Unexpected(interruption());
        const vision::CameraFile file{calibration->camera, vision::summaryOf(*calibration)};
        if (!m_residualsPath.empty())
            TELETA_CHECK(vision::writeResiduals(pairs, *calibration, m_residualsPath));
        if (!m_outPath.empty()) {
            TELETA_CHECK(vision::writeCamera(file, m_outPath));
            if (calibration->method == vision::CalibrationMethod::paper) {
                warn(CalibrateText::tr(
                         "The camera that was written has no lens: it is off by %1 mm on average "
                         "over the pairs that it kept (%2 of %3).")
                         .arg(forPeople(1e3 * calibration->mean_error_m))
                         .arg(calibration->kept)
                         .arg(pairs.size()));
            }
        }
        return m_json ? printDocument(toJson(*calibration, file, m_holeFactor))
                      : printTable(*calibration, m_holeFactor);
    }

private:
    void refuseOfCylinder() const {
        for (const char* option : {"--width", "--height", "--radius-mm", "--length-mm", "--hole-factor",
                                   "--method", "--residuals"})
            if (m_app->get_option(option)->count() > 0)
                refuse(option, CalibrateText::tr("this is for a tactile cylinder, not for --plane"));
    }

    CLI::App* m_app = nullptr;
    std::string m_pairsPath;
    PlaneCalibration m_plane;
    vision::CalibrationSettings m_settings;
    double m_radius_mm = 1e3 * vision::CylinderSurface{}.radius_m;
    double m_length_mm = 1e3 * vision::CylinderSurface{}.highest_z_m;
    double m_holeFactor = 1.0;
    std::string m_method = "robust";
    std::string m_outPath;
    std::string m_residualsPath;
    bool m_json = false;
};

} // namespace

Command calibrateCommand() {
    return makeCommand<CalibrateCommand>(
        "calibrate", CalibrateText::tr("Camera and lens of a tactile cylinder, or the plane of a flat gel"),
        "teleta simulate vtacarm-calibration --duration 60 --out run\n"
        "  teleta calibrate run/pairs.csv --out camera.json --residuals residuals.csv");
}

} // namespace teleta::cli
