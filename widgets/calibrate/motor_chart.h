// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/motors/motor_file.h"
#include "backend/motors/motor_fit.h"
#include "backend/motors/motor_recording.h"
#include "widgets/base/controls/badge.h"
#include "widgets/base/figure/figure_export.h"
#include "widgets/base/figure/sized_view.h"

#include <QPalette>
#include <QPointF>

#include <cstddef>
#include <vector>

class QBoxLayout;
class QCPItemText;
class QCustomPlot;

namespace teleta::calibrate {

/// Two charts of one motor: speed over drive (measured levels with their 95 % intervals, the curve, the
/// interval of the start), and the recording behind it next to the model's prediction, with the residuals.
/// Wheel and drag zoom and move the recording; a double click shows all of it. Thread: GUI.
class MotorChart : public base::SizedView {
    Q_OBJECT
public:
    struct Evidence {
        motors::MotorRecording recording;
        motors::MotorFit fit;
    };

    explicit MotorChart(QWidget* parent = nullptr);

    /// evidence: null when the motor was not measured in this session.
    void setMotor(std::size_t number, const motors::CalibratedMotor& motor,
                  std::shared_ptr<const Evidence> evidence, base::Provenance provenance);
    /// The motor is being measured: a speed at a time of the measurement, in place of the recording.
    /// duration_s: of the whole measurement.
    void addLive(double time_s, double speed_Hz, double duration_s);
    /// The measurement is over, or another one begins.
    void endLive();
    /// Speeds of the measurement that runs.
    [[nodiscard]] std::size_t liveSpeeds() const { return m_live.size(); }
    [[nodiscard]] base::Figure curveFigure();
    [[nodiscard]] base::Figure recordingFigure();

signals:
    void exportFailed(const QString& message);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QString wrapped(const QCustomPlot& chart, const QString& text) const;
    void restyle(const QPalette& colours);
    void draw();
    void drawCurve();
    void drawRecording();
    void drawLive();
    void showAll();
    QCPItemText* addText(QCustomPlot* chart, const QColor& colour) const;
    [[nodiscard]] base::Figure figure(QCustomPlot* plot, const QString& name, std::function<QString()> csv);

    std::size_t m_number = 0;
    motors::CalibratedMotor m_motor;
    std::shared_ptr<const Evidence> m_evidence;
    std::vector<QPointF> m_live; ///< s, Hz
    double m_liveDuration_s = 0.0;
    base::Provenance m_provenance = base::Provenance::live;
    QPalette m_colours;
    QBoxLayout* m_layout;
    QCustomPlot* m_curve;
    QCustomPlot* m_recording;
};

} // namespace teleta::calibrate
