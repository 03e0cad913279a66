// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/servo/servo_log.h"

#include <Eigen/Geometry>

#include <array>
#include <limits>
#include <string_view>

namespace teleta::scene_run {

namespace {

constexpr std::array<std::string_view, 49> kColumns{"time_s",
                                                    "phase",
                                                    "contact",
                                                    "type",
                                                    "force_N",
                                                    "force_desired_N",
                                                    "force_true_N",
                                                    "rim_true_N",
                                                    "peak_N",
                                                    "cop_x_m",
                                                    "cop_y_m",
                                                    "coc_x_m",
                                                    "coc_y_m",
                                                    "dzmp_x_m",
                                                    "dzmp_y_m",
                                                    "alpha_z_rad",
                                                    "cop_x_desired_m",
                                                    "cop_y_desired_m",
                                                    "alpha_z_desired_rad",
                                                    "cop_x_true_m",
                                                    "cop_y_true_m",
                                                    "dzmp_y_true_m",
                                                    "alpha_z_true_rad",
                                                    "x_m",
                                                    "y_m",
                                                    "z_m",
                                                    "qw",
                                                    "qx",
                                                    "qy",
                                                    "qz",
                                                    "x_commanded_m",
                                                    "y_commanded_m",
                                                    "z_commanded_m",
                                                    "vx_m_per_s",
                                                    "vy_m_per_s",
                                                    "vz_m_per_s",
                                                    "wx_rad_per_s",
                                                    "wy_rad_per_s",
                                                    "wz_rad_per_s",
                                                    "tray_rad",
                                                    "energy_J",
                                                    "limits",
                                                    "coc_x_desired_m",
                                                    "dzmp_y_desired_m",
                                                    "mass_x_true_m",
                                                    "qw_commanded",
                                                    "qx_commanded",
                                                    "qy_commanded",
                                                    "qz_commanded"};

} // namespace

core::Expected<ServoLog> ServoLog::open(const std::string& outFolder) {
    ServoLog log;
    if (outFolder.empty())
        return log;
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(outFolder + "/servo.csv", kColumns));
    log.m_csv = std::move(csv);
    return log;
}

void ServoLog::add(const simulation::ServoLoop& loop, const std::string& phase, double desiredForce_N) {
    if (!m_csv)
        return;
    const contact::TactileFeatures& felt = loop.features();
    const servo::ServoOutput& output = loop.output();
    const simulation::ServoTruth& truth = loop.world().truth();
    const simulation::ServoFrameTruth& frame = loop.world().frameTruth();
    const simulation::ImpedanceArm& arm = loop.world().arm();
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const bool loaded = frame.loads.force_N > 0.0;

    m_csv->number(truth.time_s);
    m_csv->text(phase);
    m_csv->text(servo::toString(output.contact));
    m_csv->text(contact::toString(felt.type));
    for (const double value : {felt.force_N, desiredForce_N, truth.force_N, frame.loads.rim_N, felt.peak_N})
        m_csv->number(value);
    for (const std::optional<double>& value :
         {felt.copX_m, felt.copY_m, felt.cocX_m, felt.cocY_m, felt.dzmpX_m, felt.dzmpY_m, felt.alphaZ_rad})
        m_csv->number(value);
    for (const int component : {servo::kX, servo::kY, servo::kWz})
        m_csv->number(output.desired[component]);
    m_csv->number(loaded ? frame.loads.copX_m : kNone);
    m_csv->number(loaded ? frame.loads.copY_m : kNone);
    m_csv->number(loaded ? frame.loads.copX_m - frame.loads.cocX_m : kNone);
    m_csv->number(loaded ? frame.alphaZ_rad : std::optional<double>());
    for (const double value : arm.X_Base_Sensor().translation())
        m_csv->number(value);
    const Eigen::Quaterniond turn(arm.X_Base_Sensor().linear());
    for (const double value : {turn.w(), turn.x(), turn.y(), turn.z()})
        m_csv->number(value);
    for (const double value : arm.X_Base_Reference().translation())
        m_csv->number(value);
    for (const double value : output.twist_Sensor)
        m_csv->number(value);
    m_csv->number(truth.hinge_rad);
    m_csv->number(arm.energy_J());
    m_csv->text(output.limits.names());
    m_csv->number(output.desiredCocX_m());
    m_csv->number(output.desiredDzmpY_m());
    m_csv->number(arm.object().turns ? truth.massPlace_m : kNone);
    const Eigen::Quaterniond commanded(arm.X_Base_Reference().linear());
    for (const double value : {commanded.w(), commanded.x(), commanded.y(), commanded.z()})
        m_csv->number(value);
    m_csv->endRow();
}

} // namespace teleta::scene_run
