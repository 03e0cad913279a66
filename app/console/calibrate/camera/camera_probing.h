// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/camera/probing_thread.h"
#include "backend/vision/calibration/camera_calibration.h"

#include <QObject>
#include <QString>

#include <cstdint>

namespace teleta::console {

/// Collects pairs by probing the simulated tube of the scene vtacarm-calibration, as fast as its thread can.
/// Thread: GUI; nothing blocks but the destructor, which waits for the frame or the tables being computed.
class CameraProbing : public QObject {
    Q_OBJECT

public:
    explicit CameraProbing(QObject* parent = nullptr);

    /// Ends the running probing, if any.
    void start(std::uint64_t seed);
    void cancel() { m_thread.cancel(); }
    [[nodiscard]] bool isRunning() const { return m_thread.isRunning(); }

signals:
    /// Settings for the pairs that follow.
    void begun(const teleta::vision::CalibrationSettings& settings);
    void taken(const teleta::vision::CalibrationPair& pair);
    /// Progress, 0 .. 1.
    void progressed(double share);
    /// The probing has failed.
    void failed(const QString& trouble);
    void runningChanged(bool running);

private:
    void probe(const ProbingThread::Run& run, std::uint64_t seed);

    ProbingThread m_thread;
};

} // namespace teleta::console
