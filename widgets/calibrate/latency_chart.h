// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

class QCustomPlot;

namespace teleta::calibrate {

/// The latency of each click of a measurement, in the order in which they were played, and their median.
/// Thread: GUI.
class LatencyChart : public QWidget {
    Q_OBJECT

public:
    explicit LatencyChart(QWidget* parent = nullptr);

    /// of: how many clicks there will be.
    void setClicks(const std::vector<double>& clicks_s, int of);
    [[nodiscard]] const std::vector<double>& clicks_s() const { return m_clicks_s; }

private:
    void restyle();
    void draw();

    QCustomPlot* m_plot;
    std::vector<double> m_clicks_s;
    int m_of = 0;
};

} // namespace teleta::calibrate
