// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>

#include <cstdint>
#include <functional>
#include <stop_token>
#include <utility>

namespace teleta::console {

/// A thread for one probing at a time. Starting a probing ends the previous one, whose pending calls are
/// dropped. Declare it as the last member of its owner: the destructor waits for the thread, which uses the
/// others. Thread: GUI, except tell().
class ProbingThread : public QObject {
    Q_OBJECT

public:
    /// Identifies a probing and says when it must end.
    struct Run {
        std::uint64_t number = 0;
        std::stop_token stop;
    };

    explicit ProbingThread(QObject* parent = nullptr);
    ~ProbingThread() override;

    void start(std::function<void(const Run&)> work);
    void cancel();
    [[nodiscard]] bool isRunning() const { return m_running; }

    /// Calls a function on the GUI thread if this probing is still the newest one. Thread: the probing's.
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
    /// Whether this probing is the newest one. Thread: GUI.
    [[nodiscard]] bool isPresent(const Run& run) const { return run.number == m_number; }
    /// Call when the present probing has ended. Thread: GUI, from tell().
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
