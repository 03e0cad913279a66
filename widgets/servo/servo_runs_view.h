// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/figure_view.h"
#include "widgets/servo/servo_runs.h"

#include <QByteArray>
#include <QElapsedTimer>
#include <QPixmap>

#include <string>

class QToolButton;

namespace teleta::servo {

/// Servo runs in one chart, the current one, earlier ones and recorded ones, drawn as by `teleta simulate
/// --figures`. The chart can be saved and copied from its context menu and its button; Ctrl+C copies the
/// picture. Thread: GUI; recordings are read in the background.
class ServoRunsView : public base::FigureView {
    Q_OBJECT
public:
    /// Least time between two drawings of the chart.
    static constexpr qint64 kBetweenDrawings_ms = 500;

    explicit ServoRunsView(QWidget* parent = nullptr);

    /// See ServoRuns.
    void setSource(std::string name, const void* source);
    void append(const ServoStep& step);
    /// Reads a run written by `teleta simulate --out` and adds it. path: its folder or its servo.csv.
    void addRecorded(const QString& path);

    /// Redraws if necessary; called by a timer.
    void refresh();

    [[nodiscard]] const ServoRuns& runs() const { return m_runs; }
    [[nodiscard]] base::Figure figure() override;
    /// The chart as it is drawn, as SVG; empty before the first run.
    [[nodiscard]] const QByteArray& chart() const { return m_svg; }

signals:
    /// A recording could not be read, or a figure could not be written.
    void failed(const QString& message);

protected:
    void addOwnActions(QMenu& menu, const QPoint& position) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void askForRecording();
    void forgetOthers();
    void draw();
    [[nodiscard]] QRect chartRect() const;

    ServoRuns m_runs;
    QToolButton* m_add;
    QToolButton* m_forget;
    QToolButton* m_menu;
    QByteArray m_svg;
    QPixmap m_chart;
    QElapsedTimer m_drawn;
    bool m_dirty = true;
};

} // namespace teleta::servo
