// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/servo/servo_runs.h"

#include "backend/servo/servo_tuning.h"
#include "widgets/servo/servo_texts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace teleta::servo {

void ServoRuns::setSource(std::string name, const void* source) {
    m_name = std::move(name);
    m_source = source;
    // When a source is shown again, its newest run may continue.
    const auto last = std::find_if(m_origins.rbegin(), m_origins.rend(), [&](const Origin& origin) {
        return origin.source != nullptr && origin.source == source;
    });
    m_current =
        last == m_origins.rend() ? m_origins.size() : static_cast<std::size_t>(m_origins.rend() - last) - 1;
}

bool ServoRuns::goesOn(const ServoStep& step) const {
    if (m_current >= m_curves.size() || m_origins[m_current].source != m_source ||
        m_origins[m_current].run != step.run)
        return false;
    const std::vector<double>& time_s = m_curves[m_current].time_s;
    return time_s.empty() || step.time_s > time_s.back();
}

void ServoRuns::push(Origin origin, servo_figure::ServoCurves curves) {
    if (m_curves.size() == kMost) {
        m_curves.erase(m_curves.begin());
        m_origins.erase(m_origins.begin());
        m_current = m_current == 0 ? kMost : m_current - 1;
    }
    m_curves.push_back(std::move(curves));
    m_origins.push_back(std::move(origin));
}

void ServoRuns::add(const ServoStep& step) {
    if (m_source == nullptr)
        return;
    if (!goesOn(step)) {
        Origin origin;
        origin.source = m_source;
        origin.run = step.run;
        origin.name = m_name;
        for (const Origin& other : m_origins)
            if (other.name == m_name)
                origin.number = std::max(origin.number, other.number + 1);
        push(std::move(origin), {});
        m_current = m_curves.size() - 1;
    }
    Origin& origin = m_origins[m_current];
    servo_figure::ServoCurves& curves = m_curves[m_current];
    if (origin.passed++ % origin.stride != 0) {
        curves.note(step);
        return;
    }
    if (turnsByMoment(step.task))
        (step.moment ? origin.balanced : origin.unbalanced) = true;
    curves.name = ServoTexts::run(QString::fromStdString(origin.name), origin.number, origin.unbalanced,
                                  origin.balanced)
                      .toStdString();
    if (!curves.time_s.empty() && step.time_s - curves.time_s.back() > kGap_s) {
        ServoStep gap;
        gap.time_s = step.time_s;
        gap.p_Base_Sensor.setConstant(ServoStep::kNone);
        curves.add(gap, toString(step.task));
    }
    curves.add(step, toString(step.task));
    if (curves.time_s.size() >= kLongest) {
        curves.thin();
        origin.stride *= 2;
        origin.passed = 1;
    }
}

void ServoRuns::addRecorded(servo_figure::ServoCurves run) {
    Origin origin;
    origin.name = run.name;
    push(std::move(origin), std::move(run));
}

void ServoRuns::forgetOthers() {
    if (m_current < m_curves.size()) {
        std::swap(m_curves.front(), m_curves[m_current]);
        std::swap(m_origins.front(), m_origins[m_current]);
        m_curves.resize(1);
        m_origins.resize(1);
        m_current = 0;
        return;
    }
    m_curves.clear();
    m_origins.clear();
    m_current = 0;
}

QString ServoRuns::csv() const {
    constexpr std::array kColumns{
        &servo_figure::ServoCurves::time_s,        &servo_figure::ServoCurves::force_N,
        &servo_figure::ServoCurves::desired_N,     &servo_figure::ServoCurves::copY_m,
        &servo_figure::ServoCurves::copYDesired_m, &servo_figure::ServoCurves::cocX_m,
        &servo_figure::ServoCurves::dzmpY_m,       &servo_figure::ServoCurves::dzmpYTrue_m,
        &servo_figure::ServoCurves::alphaZ_rad,    &servo_figure::ServoCurves::alphaZDesired_rad,
        &servo_figure::ServoCurves::way_m,         &servo_figure::ServoCurves::cocXDesired_m,
        &servo_figure::ServoCurves::dzmpYDesired_m};
    QString text =
        QStringLiteral("run,time_s,force_true_n,force_desired_n,cop_y_m,cop_y_desired_m,coc_x_m,"
                       "dzmp_y_m,dzmp_y_true_m,alpha_z_rad,alpha_z_desired_rad,way_m,coc_x_desired_m,"
                       "dzmp_y_desired_m\n");
    for (const servo_figure::ServoCurves& run : m_curves) {
        const QString name =
            QLatin1Char('"') +
            QString::fromStdString(run.name).replace(QLatin1Char('"'), QLatin1String("\"\"")) +
            QLatin1Char('"');
        for (std::size_t i = 0; i < run.time_s.size(); ++i) {
            text += name;
            for (const auto column : kColumns) {
                const double value = (run.*column)[i];
                text += QLatin1Char(',');
                text += std::isfinite(value) ? QString::number(value, 'g', 9) : QStringLiteral("NA");
            }
            text += QLatin1Char('\n');
        }
    }
    return text;
}

} // namespace teleta::servo
