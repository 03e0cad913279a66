// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/store/study_store.h"
#include "widgets/study/planning/plan_panel.h"

#include <QTimer>

#include <atomic>
#include <memory>

namespace teleta::console {

/// Plans studies on a pool thread for the view Plan of the Study page. Thread: GUI.
class StudyPlanning : public QObject {
    Q_OBJECT

public:
    explicit StudyPlanning(study::PlanPanel& panel);
    /// Cancels what runs.
    ~StudyPlanning() override;

    /// The study that is open.
    void setStudy(const study::StoreLocation& location, const study::Protocol& protocol);
    [[nodiscard]] bool isRunning() const { return m_run != nullptr; }

    void plan();
    void cancel();
    void readTruth(const QString& path);

private:
    /// What the pool thread and this one share.
    struct Run {
        std::atomic<double> done{0.0};
        std::atomic<bool> cancelled{false};
    };

    void takePilot();
    void showTruth(const core::Expected<study::StudyTruth>& truth, const QString& source);

    study::PlanPanel& m_panel;
    study::StoreLocation m_location{std::string()};
    study::Protocol m_protocol;
    std::shared_ptr<Run> m_run; ///< null: nothing runs
    QTimer m_ticks;
};

} // namespace teleta::console
