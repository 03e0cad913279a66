// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/camera/live_probing.h"
#include "backend/vision/calibration/calibration_pair.h"
#include "backend/vision/camera/hole_grid.h"

#include <QWidget>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;

namespace teleta::camera {
class CameraView;
}

namespace teleta::console {

/// Guides a person through the holes of a shell while the camera watches: the next hole, the state of the
/// touch, skip, back, new reference, stop. Visible while a probing runs. Holes that have a pair are skipped;
/// when a pair is undone its hole is next again, the first one of several. A touch counts for the hole that
/// was next when it began. Thread: GUI.
class LiveProbingPanel : public QWidget {
    Q_OBJECT

public:
    explicit LiveProbingPanel(QWidget* parent = nullptr);

    /// Ends a running probing first.
    void start(LiveProbing::Opener opener, const vision::CylinderSurface& surface,
               const vision::HoleGrid& grid);
    void cancel() { m_probing.cancel(); }
    /// Passes on the present pairs.
    void setPairs(std::span<const vision::CalibrationPair> pairs);
    void skip();
    void back();

    [[nodiscard]] bool isRunning() const { return m_probing.isRunning(); }
    /// Empty if all holes are probed or no probing runs.
    [[nodiscard]] std::optional<Eigen::Vector3d> nextPoint_m() const;
    /// Number of the next hole, from 0; the number of holes when all are probed.
    [[nodiscard]] std::size_t hole() const { return m_hole; }
    [[nodiscard]] QString holeText() const;
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] LiveProbing& probing() { return m_probing; }
    void retranslate();

signals:
    /// As the signals of LiveProbing.
    void begun(const teleta::vision::CalibrationSettings& settings);
    void failed(const QString& why);
    void runningChanged(bool running);
    void taken(const teleta::vision::CalibrationPair& pair);
    /// The next hole has changed.
    void holeChanged();
    /// The last hole has its pair, or the video has ended.
    void ended(const QString& what);

private:
    void take(const Eigen::Vector2d& pixel);
    /// Goes to a hole at the user's request: the present touch does not count for it.
    void leaveFor(std::size_t hole);
    void goTo(std::size_t hole);
    /// The next hole without a pair, starting here and wrapping around.
    [[nodiscard]] std::size_t unprobedFrom(std::size_t hole) const;
    void refresh();

    LiveProbing m_probing;
    vision::HoleGrid m_grid;
    std::vector<Eigen::Vector3d> m_holes_m;
    std::vector<bool> m_probed;
    std::size_t m_hole = 0;
    bool m_taking = false; ///< the pair of the hole is being stored
    ProbingView m_view;
    QString m_trouble;

    camera::CameraView* m_picture;
    QLabel* m_next;
    QLabel* m_state;
    QProgressBar* m_progress;
    QPushButton *m_back, *m_skip, *m_reference, *m_stop;
};

} // namespace teleta::console
