// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera_calibration.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <cstdint>
#include <stop_token>

namespace teleta::console {

/// Collects pairs by probing the simulated tube of the scene vtacarm-calibration, as fast as a thread of its
/// own can. Thread: GUI; no call waits but the destructor, for the frame or the tables
/// that are computed just now.
class CameraProbing : public QObject {
    Q_OBJECT

public:
    explicit CameraProbing(QObject* parent = nullptr);
    ~CameraProbing() override;

    /// Ends one that runs.
    void start(std::uint64_t seed);
    void cancel();
    [[nodiscard]] bool isRunning() const { return m_running; }

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
    void setRunning(bool running);
    void run(std::uint64_t number, std::uint64_t seed, const std::stop_token& stop);
    /// Has the GUI's thread do something, as long as this probing is the present one.
    template <typename What>
    void tell(std::uint64_t number, What what);

    std::stop_source m_stop;
    std::uint64_t m_number = 0; ///< of the newest probing
    bool m_running = false;
    QThreadPool m_pool; ///< one thread
};

} // namespace teleta::console
