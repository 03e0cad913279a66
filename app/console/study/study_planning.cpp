// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/study_planning.h"

#include "app/console/study/study_writing.h"
#include "backend/core/failure.h"
#include "backend/study/planning/identification_plan.h"
#include "backend/study/planning/threshold_plan.h"
#include "widgets/base/background.h"
#include "widgets/base/file_dialog.h"

#include <QFileInfo>

#include <utility>

namespace teleta::console {

namespace {

constexpr int kProgress_ms = 100;

core::Expected<std::shared_ptr<const study::PossibleStudy>> possibleStudy(const study::Protocol& protocol,
                                                                          const study::PlanRequest& request) {
    const std::string test = request.test.toStdString();
    if (request.wish) {
        TELETA_TRY(study::ThresholdPlan plan,
                   study::ThresholdPlan::make(protocol, request.truth, test, *request.wish));
        return std::make_shared<const study::ThresholdPlan>(std::move(plan));
    }
    TELETA_TRY(study::IdentificationPlan plan,
               study::IdentificationPlan::make(protocol, request.truth, test));
    return std::make_shared<const study::IdentificationPlan>(std::move(plan));
}

} // namespace

StudyPlanning::StudyPlanning(study::PlanPanel& panel)
    : m_panel(panel) {
    connect(&m_panel, &study::PlanPanel::planRequested, this, &StudyPlanning::plan);
    connect(&m_panel, &study::PlanPanel::cancelRequested, this, &StudyPlanning::cancel);
    connect(&m_panel, &study::PlanPanel::pilotRequested, this, &StudyPlanning::takePilot);
    connect(&m_panel, &study::PlanPanel::truthFileRequested, this, [this] {
        base::askToOpen(&m_panel, {tr("What is assumed"), {tr("Truth (*.toml)")}},
                        [this](const QString& path) { readTruth(path); });
    });
    m_ticks.setInterval(kProgress_ms);
    connect(&m_ticks, &QTimer::timeout, this, [this] {
        if (m_run)
            m_panel.setRunning(m_run->done.load());
    });
}

StudyPlanning::~StudyPlanning() {
    cancel();
}

void StudyPlanning::setStudy(const study::StoreLocation& location, const study::Protocol& protocol) {
    m_location = location;
    m_protocol = protocol;
    m_panel.setProtocol(protocol);
}

void StudyPlanning::plan() {
    const std::optional<study::PlanRequest> request = m_panel.request();
    if (m_run)
        return;
    if (!request) {
        m_panel.setProblem(tr("There is no number of participants to try: \"from\" is above \"to\"."));
        return;
    }
    auto possible = possibleStudy(m_protocol, *request);
    if (!possible) {
        m_panel.setProblem(QString::fromStdString(core::describe(possible.error())));
        return;
    }
    m_run = std::make_shared<Run>();
    m_panel.setRunning(0.0);
    m_ticks.start();
    base::runInBackground(
        this,
        [run = m_run, settings = request->settings, study = std::move(*possible)] {
            return study::planPower(*study, settings, [&](double done) {
                run->done = done;
                return !run->cancelled.load();
            });
        },
        [this, request = *request](const study::PowerPlan& plan) {
            m_ticks.stop();
            m_run.reset();
            m_panel.setPlan(plan, request);
        });
}

void StudyPlanning::cancel() {
    if (m_run)
        m_run->cancelled = true;
}

void StudyPlanning::readTruth(const QString& path) {
    base::runInBackground(
        this, [path] { return study::readTruth(path.toStdString()); },
        [this, path](const core::Expected<study::StudyTruth>& truth) {
            showTruth(truth, QFileInfo(path).fileName());
        });
}

void StudyPlanning::takePilot() {
    base::runInBackground(
        this,
        [location = m_location]() -> core::Expected<study::StudyTruth> {
            TELETA_TRY(const StudyResults results, resultsOf(location));
            if (!results.levels)
                return study::truthOf(results.tasks, location.folder);
            return study::truthOf(results.tasks, results.levels->thresholds, location.folder);
        },
        [this](const core::Expected<study::StudyTruth>& truth) { showTruth(truth, tr("this study")); });
}

void StudyPlanning::showTruth(const core::Expected<study::StudyTruth>& truth, const QString& source) {
    if (truth)
        m_panel.setTruth(*truth, source);
    else
        m_panel.setProblem(QString::fromStdString(core::describe(truth.error())));
}

} // namespace teleta::console
