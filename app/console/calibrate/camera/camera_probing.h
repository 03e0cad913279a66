// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/camera/probing_thread.h"
#include "backend/vision/calibration/camera_calibration.h"

#include <QObject>
#include <QString>

#include <cstdint>

namespace teleta::console {

/// Collects pairs by probing the simulated tube of the scene vtacarm-calibration, as fast as a thread of its
/// own can. Thread: GUI; no call waits but the destructor, for the frame or the tables
/// that are computed just now.
class CameraProbing : public QObject {
    Q_OBJECT

public:
    explicit CameraProbing(QObject* parent = nullptr);

    /// Ends one that runs.
    void start(std::uint64_t seed);
    void cancel() { m_thread.cancel(); }
    [[nodiscard]] bool isRunning() const { return m_thread.isRunning(); }

signals:
    /// What the pairs that follow are to be calibrated with.
    void begun(const teleta::vision::CalibrationSettings& settings);
    void taken(const teleta::vision::CalibrationPair& pair);
    /// How far it is, 0 .. 1.
    void progressed(double share);
    /// It cannot be done.
    void failed(const QString& trouble);
    void runningChanged(bool running);

private:
    void probe(const ProbingThread::Run& run, std::uint64_t seed);

    ProbingThread m_thread;
};

} // namespace teleta::console
