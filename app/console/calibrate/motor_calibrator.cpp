// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/motor_calibrator.h"

#include "backend/core/threads/pacing_clock.h"
#include "backend/motors/excitation.h"
#include "backend/motors/excitation_run.h"
#include "backend/motors/motor_file.h"
#include "widgets/base/background.h"
#include "widgets/base/file_dialog.h"
#include "widgets/calibrate/motors_view.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <chrono>
#include <utility>

namespace teleta::console {

namespace {

constexpr double kExcitationRate_Hz = 200.0;

} // namespace

MotorCalibrator::MotorCalibrator(BraceletService& station, QWidget* parent)
    : QObject(parent)
    , m_station(station)
    , m_view(new calibrate::MotorsView(parent)) {
    using calibrate::MotorsView;
    connect(&m_station, &BraceletService::sessionChanged, this, &MotorCalibrator::onSession);
    connect(&m_station, &BraceletService::calibrationFailed, this, [this](const core::Error& error) {
        report(tr("The motor profile cannot be used: the motors use assumed values."), error);
    });
    connect(m_view, &MotorsView::calibrationChanged, &m_station, &BraceletService::setCalibration);
    connect(m_view, &MotorsView::playRequested, this,
            [this](const playback::Program& program) { m_station.play(program, false); });
    connect(m_view, &MotorsView::stopRequested, &m_station, &BraceletService::stopPlaying);
    connect(m_view, &MotorsView::measureRequested, this, [this](const std::vector<std::size_t>& motors) {
        m_waiting.assign(motors.rbegin(), motors.rend());
        m_asked = motors.size();
        m_failed = false;
        measureNext();
    });
    connect(m_view, &MotorsView::cancelMeasureRequested, this, &MotorCalibrator::cancel);
    connect(m_view, &MotorsView::recordingRequested, this, [this](std::size_t motor) {
        base::askToOpen(m_view, {tr("Open the recording of a motor"), {tr("Recordings (*.csv)")}},
                        [this, motor](const QString& path) { openRecording(motor, path); });
    });
    connect(m_view, &MotorsView::excitationFileRequested, this, [this] {
        base::askToSave(m_view,
                        {.title = tr("Save the excitation"),
                         .filters = {tr("Tables (*.csv)")},
                         .suffix = QStringLiteral("csv")},
                        [this](const QString& path) { writeExcitation(path); });
    });
    connect(m_view, &MotorsView::saveRequested, this, [this] { save(); });
    connect(m_view, &MotorsView::copyRequested, this, [this] {
        base::askToSave(m_view,
                        {.title = tr("Save a copy of the profile"),
                         .filters = {tr("Profiles (*.toml)")},
                         .suffix = QStringLiteral("toml")},
                        [this](const QString& path) { save(path); });
    });
    connect(m_view, &MotorsView::loadRequested, this, [this] {
        base::askToOpen(m_view, {tr("Load a profile"), {tr("Profiles (*.toml)")}},
                        [this](const QString& path) { load(path); });
    });
    connect(m_view, &MotorsView::exportFailed, this, [this](const QString& message) {
        emit trouble(message, tr("Choose another folder or file name."));
    });
    onSession();
}

MotorCalibrator::~MotorCalibrator() {
    // The view has another parent and may have been deleted.
    if (m_run)
        m_run->stop.request_stop();
    for (const std::shared_ptr<Run>& run : m_runs)
        run->end.wait();
}

void MotorCalibrator::onSession() {
    cancel();
    m_failed = false;
    m_saved = m_station.calibration();
    m_view->setCalibration(m_saved);
    tick();
}

void MotorCalibrator::tick() {
    calibrate::BraceletFacts facts;
    if (const auto& session = m_station.session()) {
        const core::BraceletDescription& description = session->source().description();
        // Its name is in the language in which it was created.
        facts.name = description.simulated
                         ? QCoreApplication::translate("SimulatedBracelet", "Simulated bracelet")
                         : QString::fromStdString(description.name);
        facts.serial = QString::fromStdString(description.serial);
        facts.simulated = description.simulated;
        facts.ready = m_station.isFree();
        facts.reserved = m_station.isReserved();
        const auto speeds = session->source().motorSpeeds();
        facts.hasSensor = speeds.has_value();
        facts.strongest = m_station.strongest();
        if (speeds && m_view->isVisible())
            facts.speeds_Hz = speeds->speeds_Hz;
    }
    m_view->setFacts(facts);
    // A run still waiting for a thread would otherwise start later, unexpectedly. A playing one is ended by
    // STOP or the loss.
    if (m_run && (m_station.isReserved() || (!m_run->begun && !m_station.isReady())))
        refuseRun();
    if (m_measuring)
        m_view->setMeasuring(m_measuring, m_run ? m_run->progress.load() : 0.0, m_asked - m_waiting.size(),
                             m_asked);
}

void MotorCalibrator::measureNext() {
    auto session = m_station.session();
    if (m_waiting.empty() || !session || m_station.isReserved()) {
        m_waiting.clear();
        m_measuring.reset();
        m_run.reset();
        m_view->setMeasuring(std::nullopt);
        return;
    }
    m_measuring = m_waiting.back();
    m_waiting.pop_back();
    m_run = std::make_shared<Run>();
    std::erase_if(m_runs, [](const std::shared_ptr<Run>& run) {
        return run->end.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
    m_runs.push_back(m_run);
    m_view->setMeasuring(m_measuring, 0.0, m_asked - m_waiting.size(), m_asked);
    base::runInBackground(
        this,
        [session = std::move(session), run = m_run, motor = *m_measuring]() mutable {
            core::PacingClock clock;
            run->begun = true;
            auto recording = motors::recordExcitation(session->player(), session->source(), motor,
                                                      motors::stairsAndPulses(), run->stop.get_token(),
                                                      run->progress, clock);
            session.reset();
            run->ended.set_value();
            if (!recording)
                return Fitted{{}, core::Unexpected(recording.error())};
            auto fit = motors::fitMotor(*recording);
            return Fitted{std::move(*recording), std::move(fit)};
        },
        [this, run = m_run, motor = *m_measuring](Fitted fitted) {
            // It has been replaced by another bracelet or measurement.
            if (run != m_run)
                return;
            const bool failed = !fitted.second;
            if (!failed || fitted.second.error().kind != core::ErrorKind::cancelled)
                take(motor, fitted);
            if (failed)
                m_waiting.clear();
            measureNext();
        });
}

void MotorCalibrator::cancel() {
    m_waiting.clear();
    if (!m_run)
        return;
    m_run->stop.request_stop();
    m_run.reset();
    m_measuring.reset();
    m_view->setMeasuring(std::nullopt);
}

void MotorCalibrator::refuseRun() {
    const std::size_t motor = m_measuring.value_or(0);
    const core::Error why{core::ErrorKind::refused, m_station.note().toStdString(), {}, {}};
    cancel();
    take(motor, {{}, core::Unexpected(why)});
}

void MotorCalibrator::take(std::size_t motor, const Fitted& fitted) {
    m_failed = !fitted.second;
    m_view->takeFit(motor, fitted.first, fitted.second);
}

calibrate::StepReading MotorCalibrator::step() const {
    using calibrate::StepState;
    const auto& motors = m_view->calibration().motors;
    const int all = static_cast<int>(motors.size());
    const int measured = static_cast<int>(std::ranges::count_if(motors, &motors::CalibratedMotor::measured));
    if (m_measuring)
        return {.state = StepState::running,
                .number = static_cast<int>(m_asked - m_waiting.size()),
                .of = static_cast<int>(m_asked),
                .share = (static_cast<double>(m_asked - m_waiting.size()) - 1.0 +
                          (m_run ? m_run->progress.load() : 0.0)) /
                         static_cast<double>(m_asked)};
    // What could be lost counts before what went wrong, which the page says.
    if (!m_view->isSaved())
        return {.state = StepState::notSaved};
    if (m_failed)
        return {.state = StepState::failed};
    return {.state = measured == all ? StepState::done : StepState::toDo, .number = measured, .of = all};
}

void MotorCalibrator::openRecording(std::size_t motor, const QString& path) {
    base::runInBackground(
        this,
        [path] {
            auto recording = motors::readMotorRecording(path.toStdString());
            if (!recording)
                return Fitted{{}, core::Unexpected(recording.error())};
            auto fit = motors::fitMotor(*recording);
            return Fitted{std::move(*recording), std::move(fit)};
        },
        [this, motor, serial = m_view->calibration().bracelet](Fitted fitted) {
            // Another bracelet may have been connected meanwhile.
            if (serial == m_view->calibration().bracelet)
                take(motor, fitted);
        });
}

void MotorCalibrator::load(const QString& path) {
    base::runInBackground(
        this, [path] { return motors::readMotors(path.toStdString()); },
        [this, path](core::Expected<motors::MotorCalibration> read) {
            const QString file = QFileInfo(path).fileName();
            if (!read) {
                report(tr("%1 could not be opened.", "a file").arg(file), read.error());
                return;
            }
            const std::string& serial = m_station.calibration().bracelet;
            if (read->bracelet != serial) {
                emit trouble(
                    tr("%1 belongs to another bracelet.", "a file").arg(file),
                    tr("The file is for \u201c%1\u201d, this bracelet is \u201c%2\u201d. Measure this one, "
                       "or "
                       "connect the other.")
                        .arg(QString::fromStdString(read->bracelet), QString::fromStdString(serial)));
                return;
            }
            m_failed = false;
            m_view->takeProfile(*read);
        });
}

bool MotorCalibrator::canSave() const {
    return !m_view->calibration().bracelet.empty();
}

QString MotorCalibrator::unsavedText() const {
    const auto& motors = m_view->calibration().motors;
    QStringList numbers;
    bool areMeasured = true;
    for (std::size_t i = 0; i < motors.size(); ++i) {
        if (motors[i] == m_saved.motors[i])
            continue;
        numbers << QString::number(i + 1);
        areMeasured = areMeasured && motors[i].measured();
    }
    if (numbers.isEmpty())
        return {};
    const QString list = numbers.join(QStringLiteral(", "));
    if (areMeasured)
        return numbers.size() == 1 ? tr("Motor %1 was measured and is not saved.").arg(list)
                                   : tr("Motors %1 were measured and are not saved.", "1, 2").arg(list);
    return numbers.size() == 1 ? tr("Motor %1 was changed and is not saved.").arg(list)
                               : tr("Motors %1 were changed and are not saved.", "1, 2").arg(list);
}

void MotorCalibrator::save(const QString& copyPath, std::function<void()> done) {
    const motors::MotorCalibration calibration = m_view->calibration();
    const QString path =
        copyPath.isEmpty() ? QString::fromStdString(motors::profilePath(calibration.bracelet)) : copyPath;
    base::runInBackground(
        this, [calibration, path] { return motors::writeMotors(calibration, path.toStdString()); },
        [this, calibration, path, copy = !copyPath.isEmpty(),
         done = std::move(done)](core::Expected<void> written) {
            if (!written) {
                report(tr("%1 could not be saved.", "a file").arg(QFileInfo(path).fileName()),
                       written.error());
                return;
            }
            if (!copy && calibration.bracelet == m_saved.bracelet)
                m_saved = calibration;
            if (!copy && calibration == m_view->calibration())
                m_view->markSaved();
            if (done)
                done();
        });
}

void MotorCalibrator::writeExcitation(const QString& path) {
    base::runInBackground(
        this,
        [path] {
            return motors::writeExcitation(motors::stairsAndPulses(), kExcitationRate_Hz, path.toStdString());
        },
        [this, path](core::Expected<void> written) {
            if (!written)
                report(tr("%1 could not be saved.", "a file").arg(QFileInfo(path).fileName()),
                       written.error());
        });
}

void MotorCalibrator::report(const QString& what, const core::Error& error) {
    emit trouble(what, QString::fromStdString(core::describe(error)));
}

} // namespace teleta::console
