// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo_figure/servo_curves.h"

#include "backend/core/data/csv_number.h"
#include "backend/core/data/csv_reader.h"
#include "backend/core/failure.h"
#include "backend/servo/rigid_motion.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QString>

#include <algorithm>
#include <array>
#include <cmath>

namespace teleta::servo_figure {

namespace {

struct CurvesText {
    Q_DECLARE_TR_FUNCTIONS(ServoCurves)
};

constexpr std::array kVectors{&ServoCurves::time_s,        &ServoCurves::force_N,
                              &ServoCurves::desired_N,     &ServoCurves::copY_m,
                              &ServoCurves::copYDesired_m, &ServoCurves::cocX_m,
                              &ServoCurves::dzmpY_m,       &ServoCurves::dzmpYTrue_m,
                              &ServoCurves::alphaZ_rad,    &ServoCurves::alphaZDesired_rad,
                              &ServoCurves::x_m,           &ServoCurves::y_m,
                              &ServoCurves::z_m,           &ServoCurves::way_m,
                              &ServoCurves::cocXDesired_m, &ServoCurves::dzmpYDesired_m,
                              &ServoCurves::turnZ_rad,     &ServoCurves::turnZCommanded_rad};

constexpr std::array<std::string_view, 15> kNames{"time_s",
                                                  "force_true_N",
                                                  "force_desired_N",
                                                  "cop_y_m",
                                                  "cop_y_desired_m",
                                                  "coc_x_m",
                                                  "dzmp_y_m",
                                                  "dzmp_y_true_m",
                                                  "alpha_z_rad",
                                                  "alpha_z_desired_rad",
                                                  "x_m",
                                                  "y_m",
                                                  "z_m",
                                                  "phase",
                                                  "contact"};
constexpr std::size_t kNumbers = 13;

/// Columns that are missing in files of older versions.
constexpr std::array<std::string_view, 11> kLaterNumbers{
    "coc_x_desired_m", "dzmp_y_desired_m", "mass_x_true_m", "qw",          "qx", "qy", "qz",
    "qw_commanded",    "qx_commanded",     "qy_commanded",  "qz_commanded"};
constexpr std::string_view kLimitsName = "limits";

/// Largest plausible place, force or time of a run, in SI units.
constexpr double kLargest = 1e12;

/// Neither NaN nor of another length than 1.
bool isRotation(const Eigen::Quaterniond& q) {
    constexpr double kTolerance = 1e-3;
    const double size = q.norm();
    return std::isfinite(size) && std::abs(size - 1.0) < kTolerance;
}

core::Unexpected badField(const core::CsvReader& csv, std::size_t column, const QString& message,
                          const QString& expected) {
    return core::failed(core::ErrorKind::badInput, message, expected, csv.place(column));
}

} // namespace

void ServoCurves::lengthen(std::vector<Span>& spans, double now_s, const servo::ActiveLimits& acting,
                           bool goesOn) {
    if (!spans.empty() && goesOn)
        spans.back().end_s = now_s;
    else if (spans.size() < kMostSpans)
        spans.push_back({now_s, now_s, acting});
    else
        spans.back().end_s = now_s;
}

void ServoCurves::note(const servo::ServoStep& step) {
    if (step.touching)
        lengthen(contacts, step.time_s, {}, m_touching);
    m_touching = step.touching;
    if (step.limits.any())
        lengthen(limits, step.time_s, step.limits, m_limited && limits.back().limits == step.limits);
    m_limited = step.limits.any();
    if (!massMoves_s && std::isfinite(m_mass_m) && std::isfinite(step.massX_m) && step.massX_m != m_mass_m)
        massMoves_s = m_noted_s;
    m_mass_m = step.massX_m;
    m_noted_s = step.time_s;
}

/// The z component of the rotation vector from the start to this orientation.
double ServoCurves::turnSinceStart_rad(const Eigen::Quaterniond& q_Base_Sensor) const {
    if (!m_start_m || !isRotation(m_q_Base_Start) || !isRotation(q_Base_Sensor))
        return servo::ServoStep::kNone;
    const Eigen::Quaterniond turn = m_q_Base_Start.normalized().conjugate() * q_Base_Sensor.normalized();
    return servo::logSO3(turn.toRotationMatrix()).z();
}

void ServoCurves::add(const servo::ServoStep& step, std::string_view phase) {
    note(step);
    if (phases.empty() || phases.back().second != phase)
        phases.emplace_back(step.time_s, std::string(phase));
    if (!m_start_m && step.touching) {
        m_start_m = step.p_Base_Sensor;
        m_q_Base_Start = step.q_Base_Sensor;
    }
    const Eigen::Vector3d way = m_start_m ? Eigen::Vector3d(step.p_Base_Sensor - *m_start_m)
                                          : Eigen::Vector3d::Constant(servo::ServoStep::kNone);
    const std::array<double, kVectors.size()> values{step.time_s,
                                                     step.force_N,
                                                     step.desired_N,
                                                     step.copY_m,
                                                     step.copYDesired_m,
                                                     step.cocX_m,
                                                     step.dzmpY_m,
                                                     step.dzmpYTrue_m,
                                                     step.alphaZ_rad,
                                                     step.alphaZDesired_rad,
                                                     way.x(),
                                                     way.y(),
                                                     way.z(),
                                                     way.norm(),
                                                     step.cocXDesired_m,
                                                     step.dzmpYDesired_m,
                                                     turnSinceStart_rad(step.q_Base_Sensor),
                                                     turnSinceStart_rad(step.q_Base_Reference)};
    for (std::size_t i = 0; i < kVectors.size(); ++i)
        (this->*kVectors[i]).push_back(values[i]);
}

void ServoCurves::thin() {
    for (const auto vector : kVectors) {
        std::vector<double>& values = this->*vector;
        const std::size_t left = (values.size() + 1) / 2;
        for (std::size_t i = 0; i < left; ++i)
            values[i] = values[2 * i];
        values.resize(left);
    }
}

core::Expected<ServoCurves> readServoCurves(const std::string& path) {
    const QFileInfo info(QString::fromStdString(path));
    const QString file =
        info.isDir() ? QDir(info.filePath()).filePath(QStringLiteral("servo.csv")) : info.filePath();
    TELETA_TRY(core::CsvReader csv, core::CsvReader::open(file.toStdString()));
    TELETA_TRY(const std::vector<std::size_t> columns, csv.columns(kNames));

    const auto later = [&](std::string_view name) {
        const auto& header = csv.header();
        return static_cast<std::size_t>(std::ranges::find(header, name) - header.begin());
    };
    std::array<std::size_t, kLaterNumbers.size()> laterColumns{};
    std::ranges::transform(kLaterNumbers, laterColumns.begin(), later);
    const std::size_t limitsColumn = later(kLimitsName);

    ServoCurves curves;
    curves.name = QFileInfo(QFileInfo(file).absolutePath()).fileName().toStdString();
    std::vector<std::string_view> fields;
    double before_s = -kLargest;
    while (true) {
        TELETA_TRY(const bool more, csv.nextText(fields));
        if (!more)
            return curves;
        std::array<double, kNumbers> row{};
        for (std::size_t i = 0; i < kNumbers; ++i) {
            const std::optional<double> value = core::numberOrNA(fields[columns[i]]);
            if (!value || (std::isfinite(*value) && std::abs(*value) > kLargest))
                return badField(csv, columns[i], CurvesText::tr("this is not a plausible number"),
                                CurvesText::tr("a number from -1e12 to 1e12, or NA"));
            row[i] = *value;
        }
        if (!std::isfinite(row[0]) || row[0] < before_s)
            return badField(csv, columns[0], CurvesText::tr("the time decreases or is missing"),
                            CurvesText::tr("times in order"));
        before_s = row[0];
        servo::ServoStep step;
        const std::array laterValues{
            &step.cocXDesired_m,        &step.dzmpYDesired_m,       &step.massX_m,
            &step.q_Base_Sensor.w(),    &step.q_Base_Sensor.x(),    &step.q_Base_Sensor.y(),
            &step.q_Base_Sensor.z(),    &step.q_Base_Reference.w(), &step.q_Base_Reference.x(),
            &step.q_Base_Reference.y(), &step.q_Base_Reference.z()};
        for (std::size_t i = 0; i < laterColumns.size(); ++i) {
            if (laterColumns[i] >= fields.size())
                continue;
            const std::optional<double> value = core::numberOrNA(fields[laterColumns[i]]);
            if (!value || (std::isfinite(*value) && std::abs(*value) > kLargest))
                return badField(csv, laterColumns[i], CurvesText::tr("this is not a plausible number"),
                                CurvesText::tr("a number from -1e12 to 1e12, or NA"));
            *laterValues[i] = *value;
        }
        if (limitsColumn < fields.size()) {
            const std::optional<servo::ActiveLimits> limits =
                servo::ActiveLimits::fromNames(fields[limitsColumn]);
            if (!limits)
                return badField(csv, limitsColumn, CurvesText::tr("this is not a limit of a servo"),
                                CurvesText::tr("names such as force+tool_speed, or nothing"));
            step.limits = *limits;
        }
        step.time_s = row[0];
        step.touching = fields[columns[14]] == "touching";
        step.force_N = row[1];
        step.desired_N = row[2];
        step.copY_m = row[3];
        step.copYDesired_m = row[4];
        step.cocX_m = row[5];
        step.dzmpY_m = row[6];
        step.dzmpYTrue_m = row[7];
        step.alphaZ_rad = row[8];
        step.alphaZDesired_rad = row[9];
        step.p_Base_Sensor = {row[10], row[11], row[12]};
        curves.add(step, fields[columns[13]]);
    }
}

} // namespace teleta::servo_figure
