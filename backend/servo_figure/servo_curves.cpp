// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo_figure/servo_curves.h"

#include "backend/core/data/csv_number.h"
#include "backend/core/data/csv_reader.h"
#include "backend/core/failure.h"
#include "backend/servo/arm/rigid_motion.h"

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

/// A curve, the value of a step that it shows and the column of servo.csv that has it.
struct Curve {
    std::vector<double> ServoCurves::*values;
    double servo::ServoStep::*value;
    std::string_view column;
    bool isLater = false; ///< missing in files of older versions
};

constexpr std::array kCurves{
    Curve{&ServoCurves::time_s, &servo::ServoStep::time_s, "time_s"},
    Curve{&ServoCurves::force_N, &servo::ServoStep::force_N, "force_true_n"},
    Curve{&ServoCurves::desired_N, &servo::ServoStep::desired_N, "force_desired_n"},
    Curve{&ServoCurves::copY_m, &servo::ServoStep::copY_m, "cop_y_m"},
    Curve{&ServoCurves::copYDesired_m, &servo::ServoStep::copYDesired_m, "cop_y_desired_m"},
    Curve{&ServoCurves::cocX_m, &servo::ServoStep::cocX_m, "coc_x_m"},
    Curve{&ServoCurves::dzmpY_m, &servo::ServoStep::dzmpY_m, "dzmp_y_m"},
    Curve{&ServoCurves::dzmpYTrue_m, &servo::ServoStep::dzmpYTrue_m, "dzmp_y_true_m"},
    Curve{&ServoCurves::alphaZ_rad, &servo::ServoStep::alphaZ_rad, "alpha_z_rad"},
    Curve{&ServoCurves::alphaZDesired_rad, &servo::ServoStep::alphaZDesired_rad, "alpha_z_desired_rad"},
    Curve{&ServoCurves::cocXDesired_m, &servo::ServoStep::cocXDesired_m, "coc_x_desired_m", true},
    Curve{&ServoCurves::dzmpYDesired_m, &servo::ServoStep::dzmpYDesired_m, "dzmp_y_desired_m", true}};

/// The curves that follow from the pose of the array.
constexpr std::array kPoseCurves{&ServoCurves::x_m,       &ServoCurves::y_m,
                                 &ServoCurves::z_m,       &ServoCurves::way_m,
                                 &ServoCurves::turnZ_rad, &ServoCurves::turnZCommanded_rad};

/// Name of a column in files of version 0.1.0, which the version after the next one will no longer read.
struct OlderName {
    std::string_view older;
    std::string_view present;
};
constexpr std::array kOlderNames{OlderName{"force_true_N", "force_true_n"},
                                 OlderName{"force_desired_N", "force_desired_n"}};

constexpr std::array<std::string_view, 3> kPlace{"x_m", "y_m", "z_m"};
/// In the order of the coefficients of an Eigen::Quaternion, as quaternionXyzw() writes them.
constexpr std::array<std::string_view, 4> kTurn{"qx", "qy", "qz", "qw"};
constexpr std::array<std::string_view, 4> kTurnCommanded{"qx_commanded", "qy_commanded", "qz_commanded",
                                                         "qw_commanded"};

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
    for (const Curve& curve : kCurves)
        (this->*curve.values).push_back(step.*curve.value);
    const Eigen::Vector3d way = m_start_m ? Eigen::Vector3d(step.p_Base_Sensor - *m_start_m)
                                          : Eigen::Vector3d::Constant(servo::ServoStep::kNone);
    x_m.push_back(way.x());
    y_m.push_back(way.y());
    z_m.push_back(way.z());
    way_m.push_back(way.norm());
    turnZ_rad.push_back(turnSinceStart_rad(step.q_Base_Sensor));
    turnZCommanded_rad.push_back(turnSinceStart_rad(step.q_Base_Reference));
}

void ServoCurves::thin() {
    const auto thinned = [this](std::vector<double> ServoCurves::*curve) {
        std::vector<double>& values = this->*curve;
        const std::size_t left = (values.size() + 1) / 2;
        for (std::size_t i = 0; i < left; ++i)
            values[i] = values[2 * i];
        values.resize(left);
    };
    std::ranges::for_each(kCurves, thinned, &Curve::values);
    std::ranges::for_each(kPoseCurves, thinned);
}

core::Expected<ServoCurves> readServoCurves(const std::string& path) {
    const QFileInfo info(QString::fromStdString(path));
    const QString file =
        info.isDir() ? QDir(info.filePath()).filePath(QStringLiteral("servo.csv")) : info.filePath();
    TELETA_TRY(core::CsvReader csv, core::CsvReader::open(file.toStdString()));
    const auto nameHere = [&csv](std::string_view present) {
        const auto older = std::ranges::find(kOlderNames, present, &OlderName::present);
        const bool isOlder = older != kOlderNames.end() &&
                             std::ranges::find(csv.header(), older->older) != csv.header().end() &&
                             std::ranges::find(csv.header(), present) == csv.header().end();
        return isOlder ? older->older : present;
    };
    std::vector<std::string_view> needed;
    for (const Curve& curve : kCurves)
        if (!curve.isLater)
            needed.push_back(nameHere(curve.column));
    needed.insert(needed.end(), {"x_m", "y_m", "z_m", "phase", "contact"});
    TELETA_CHECK(csv.columns(needed));

    ServoCurves curves;
    curves.name = QFileInfo(QFileInfo(file).absolutePath()).fileName().toStdString();
    servo::ServoStep step;
    std::vector<std::pair<std::size_t, double*>> numbers; // columns that there are, and where they go
    const std::vector<std::string>& header = csv.header();
    const auto columnOf = [&](std::string_view name) {
        return static_cast<std::size_t>(std::ranges::find(header, name) - header.begin());
    };
    const auto take = [&](std::string_view name, double& value) {
        if (columnOf(name) < header.size())
            numbers.emplace_back(columnOf(name), &value);
    };
    for (const Curve& curve : kCurves)
        take(nameHere(curve.column), step.*curve.value);
    for (std::size_t i = 0; i < kPlace.size(); ++i)
        take(kPlace[i], step.p_Base_Sensor.data()[i]);
    for (std::size_t i = 0; i < kTurn.size(); ++i) {
        take(kTurn[i], step.q_Base_Sensor.coeffs().data()[i]);
        take(kTurnCommanded[i], step.q_Base_Reference.coeffs().data()[i]);
    }
    take("mass_x_true_m", step.massX_m);
    const std::size_t phaseColumn = columnOf("phase");
    const std::size_t contactColumn = columnOf("contact");
    const std::size_t limitsColumn = columnOf("limits");

    std::vector<std::string_view> fields;
    double before_s = -kLargest;
    while (true) {
        TELETA_TRY(const bool more, csv.nextText(fields));
        if (!more)
            return curves;
        for (const auto& [column, value] : numbers) {
            const std::optional<double> number = core::numberOrNA(fields[column]);
            if (!number || (std::isfinite(*number) && std::abs(*number) > kLargest))
                return badField(csv, column, CurvesText::tr("this is not a plausible number"),
                                CurvesText::tr("a number from -1e12 to 1e12, or NA"));
            *value = *number;
        }
        if (!std::isfinite(step.time_s) || step.time_s < before_s)
            return badField(csv, columnOf("time_s"), CurvesText::tr("the time decreases or is missing"),
                            CurvesText::tr("times in order"));
        before_s = step.time_s;
        if (limitsColumn < fields.size()) {
            const auto limits = servo::ActiveLimits::fromNames(fields[limitsColumn]);
            if (!limits)
                return badField(csv, limitsColumn, CurvesText::tr("this is not a limit of a servo"),
                                CurvesText::tr("names such as force+tool_speed, or nothing"));
            step.limits = *limits;
        }
        step.touching = fields[contactColumn] == "touching";
        curves.add(step, fields[phaseColumn]);
    }
}

} // namespace teleta::servo_figure
