// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"
#include "backend/pattern/motors/motor_model.h"
#include "widgets/chrome/message_bar.h"
#include "widgets/study/results/page/results_view.h"

#include <QObject>
#include <QString>

namespace teleta::console {

/// What the results of a study and the connected bracelet have to do with each other: results show what its
/// motors do at a level, and the full drives that a study has found are used for it. Thread: GUI.
class StudyBracelet : public QObject {
    Q_OBJECT

public:
    /// All must outlive it.
    StudyBracelet(BraceletService& station, study::ResultsView& results, chrome::MessageBar& messages,
                  QObject* parent);

private:
    void showMotors();
    /// Asks first. from: whose results they are.
    void use(const pattern::MotorProfiles& balanced, const QString& from);
    void keep(const pattern::MotorProfiles& balanced, const std::string& bracelet);

    BraceletService& m_station;
    study::ResultsView& m_results;
    chrome::MessageBar& m_messages;
};

} // namespace teleta::console
