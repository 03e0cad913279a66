// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure_export.h"
#include "widgets/servo/servo_runs.h"

#include <QElapsedTimer>
#include <QPixmap>
#include <QWidget>

#include <string>

class QMenu;
class QToolButton;

namespace teleta::servo {

/// Servo runs in one chart, the current one, earlier ones and recorded ones, drawn as by `teleta simulate
/// --figures`. The chart can be saved and copied from its context menu and its button; Ctrl+C copies the
/// picture. Thread: GUI; recordings are read in the background.
class ServoRunsView : public QWidget {
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
    [[nodiscard]] base::Figure figure() const;
    void populateMenu(QMenu& menu);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void exported(const QString& path);
    void failed(const QString& message);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void askForRecording();
    void forgetOthers();
    void draw();
    [[nodiscard]] QRect chartRect() const;

    ServoRuns m_runs;
    base::FigureExport* m_export;
    QToolButton* m_add;
    QToolButton* m_forget;
    QToolButton* m_menu;
    QPixmap m_chart;
    QElapsedTimer m_drawn;
    bool m_dirty = true;
};

} // namespace teleta::servo
