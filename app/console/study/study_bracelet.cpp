// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/study_bracelet.h"

#include "backend/motors/motor_file.h"
#include "widgets/base/background.h"
#include "widgets/base/compose.h"

#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace teleta::console {

StudyBracelet::StudyBracelet(BraceletService& station, study::ResultsView& results,
                             chrome::MessageBar& messages, QObject* parent)
    : QObject(parent)
    , m_station(station)
    , m_results(results)
    , m_messages(messages) {
    connect(&station, &BraceletService::sessionChanged, this, &StudyBracelet::showMotors);
    connect(&station, &BraceletService::calibrationChanged, this, &StudyBracelet::showMotors);
    connect(&results, &study::ResultsView::useRequested, this, &StudyBracelet::use);
    showMotors();
}

void StudyBracelet::showMotors() {
    const auto& open = m_station.session();
    if (!open) {
        m_results.setMotors({});
        return;
    }
    const core::BraceletDescription& description = open->source().description();
    m_results.setMotors(study::BraceletMotors{QString::fromStdString(description.name),
                                              m_station.calibration().profiles(), description.simulated});
}

void StudyBracelet::use(const pattern::MotorProfiles& balanced, const QString& from) {
    const motors::MotorCalibration& now = m_station.calibration();
    QStringList lines;
    for (std::size_t i = 0; i < balanced.size(); ++i)
        lines << tr("Tactor %1: %2 \u2192 %3", "a number; full drives")
                     .arg(i + 1)
                     .arg(QLocale().toString(now.motors[i].profile.fullDrive, 'f', 3),
                          QLocale().toString(balanced[i].fullDrive, 'f', 3));
    auto* box = base::named<QMessageBox>(
        "useForBracelet", QMessageBox::Question, tr("Balance the bracelet"),
        tr("Use these full drives for the bracelet %1?").arg(QString::fromStdString(now.bracelet)),
        QMessageBox::Cancel, &m_results);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(
        tr("As felt by: %1", "a participant, or all").arg(from) + QStringLiteral("\n\n") +
        lines.join(QLatin1Char('\n')) + QStringLiteral("\n\n") +
        tr("Patterns, feedback and later studies will use them. The page Calibrate can change them again."));
    QPushButton* yes = box->addButton(tr("&Use them"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(box, &QMessageBox::finished, this, [this, box, yes, balanced, bracelet = now.bracelet] {
        if (box->clickedButton() == yes)
            keep(balanced, bracelet);
    });
    box->open();
}

void StudyBracelet::keep(const pattern::MotorProfiles& balanced, const std::string& bracelet) {
    motors::MotorCalibration calibration = m_station.calibration();
    if (calibration.bracelet != bracelet) {
        m_messages.post({chrome::Message::Severity::warning,
                         tr("Another bracelet was connected meanwhile."),
                         tr("Nothing was changed. Connect the one with which the study was run."),
                         {}});
        return;
    }
    for (std::size_t i = 0; i < balanced.size(); ++i) {
        motors::CalibratedMotor& motor = calibration.motors[i];
        motor.profile = balanced[i];
        if (motor.startFrom == motors::CalibratedMotor::Origin::assumed)
            motor.startFrom = motors::CalibratedMotor::Origin::answers;
    }
    m_station.setCalibration(calibration);
    const std::string path = motors::profilePath(bracelet);
    base::runInBackground(
        this, [calibration, path] { return motors::writeMotors(calibration, path); },
        [this, path](const core::Expected<void>& written) {
            if (written)
                m_messages.post({chrome::Message::Severity::information,
                                 tr("The tactors are balanced."),
                                 tr("Saved: %1").arg(QString::fromStdString(path)),
                                 {}});
            else
                m_messages.post({chrome::Message::Severity::error, tr("The full drives could not be saved."),
                                 tr("They are used until the program ends. Save them on the page Calibrate."),
                                 QString::fromStdString(core::describe(written.error()))});
        });
}

} // namespace teleta::console
