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

/// Leads a person through the holes of a shell while the camera watches: which hole is next, how the touch is
/// going, skip, back, a new reference, stop; shown while a probing runs. A hole that has a pair is passed
/// over; one whose pair was taken back is next again, the first one of several. A touch counts for the hole
/// that was next when it began. Thread: GUI.
class LiveProbingPanel : public QWidget {
    Q_OBJECT

public:
    explicit LiveProbingPanel(QWidget* parent = nullptr);

    /// Ends one that runs.
    void start(LiveProbing::Opener opener, const vision::CylinderSurface& surface,
               const vision::HoleGrid& grid);
    void cancel() { m_probing.cancel(); }
    /// The pairs as they are now.
    void setPairs(std::span<const vision::CalibrationPair> pairs);
    void skip();
    void back();

    [[nodiscard]] bool isRunning() const { return m_probing.isRunning(); }
    /// Empty when all are probed, or none is running.
    [[nodiscard]] std::optional<Eigen::Vector3d> nextPoint_m() const;
    /// Number of the next hole, from 0; the number of holes when all are probed.
    [[nodiscard]] std::size_t hole() const { return m_hole; }
    [[nodiscard]] QString holeText() const;
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] LiveProbing& probing() { return m_probing; }
    [[nodiscard]] QPushButton* skipButton() const { return m_skip; }
    [[nodiscard]] QPushButton* backButton() const { return m_back; }
    [[nodiscard]] QPushButton* stopButton() const { return m_stop; }
    void retranslate();

signals:
    /// As those of LiveProbing.
    void begun(const teleta::vision::CalibrationSettings& settings);
    void failed(const QString& why);
    void runningChanged(bool running);
    void taken(const teleta::vision::CalibrationPair& pair);
    /// Another hole is next.
    void holeChanged();
    /// The last hole has its pair, or the video is over.
    void ended(const QString& what);

protected:
    void changeEvent(QEvent* event) override;

private:
    void take(const Eigen::Vector2d& pixel);
    /// As a person asks for it: a touch that goes on is none of this hole.
    void leaveFor(std::size_t hole);
    void goTo(std::size_t hole);
    /// The next one that has no pair, from here on and then from the first.
    [[nodiscard]] std::size_t unprobedFrom(std::size_t hole) const;
    void refresh();

    LiveProbing m_probing;
    vision::HoleGrid m_grid;
    std::vector<Eigen::Vector3d> m_holes_m;
    std::vector<bool> m_probed;
    std::size_t m_hole = 0;
    bool m_taking = false; ///< the touch of the hole is being filed
    ProbingView m_view;
    QString m_trouble;

    camera::CameraView* m_picture;
    QLabel* m_next;
    QLabel* m_state;
    QProgressBar* m_progress;
    QPushButton *m_back, *m_skip, *m_reference, *m_stop;
};

} // namespace teleta::console
