// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>

#include <cstdint>
#include <functional>
#include <stop_token>
#include <utility>

namespace teleta::console {

/// A thread on which one probing runs at a time. A newer one ends the one before, and of that nothing more is
/// heard. The last member of its owner: the destructor waits for what uses the others. Thread: GUI, but
/// tell().
class ProbingThread : public QObject {
    Q_OBJECT

public:
    /// Which probing it is, and when it has to end.
    struct Run {
        std::uint64_t number = 0;
        std::stop_token stop;
    };

    explicit ProbingThread(QObject* parent = nullptr);
    ~ProbingThread() override;

    void start(std::function<void(const Run&)> work);
    void cancel();
    [[nodiscard]] bool isRunning() const { return m_running; }

    /// Has the GUI's thread do something, as long as this probing is the present one. Thread: the probing's.
    template <typename What>
    void tell(const Run& run, What what) {
        QMetaObject::invokeMethod(
            this,
            [this, run, what = std::move(what)] {
                if (isPresent(run))
                    what();
            },
            Qt::QueuedConnection);
    }
    /// Whether that probing is the newest one. Thread: GUI.
    [[nodiscard]] bool isPresent(const Run& run) const { return run.number == m_number; }
    /// The present probing is over. Thread: GUI, out of tell().
    void ended() { setRunning(false); }

signals:
    void runningChanged(bool running);

private:
    void setRunning(bool running);

    std::stop_source m_stop;
    std::uint64_t m_number = 0; ///< of the newest probing
    bool m_running = false;
    QThreadPool m_pool; ///< one thread
};

} // namespace teleta::console
