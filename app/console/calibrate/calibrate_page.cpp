// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/calibrate_page.h"

#include "app/console/base/page_stack.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/calibrate/gains_view.h"
#include "widgets/calibrate/motors_view.h"
#include "widgets/calibrate/step_list.h"

#include <QHBoxLayout>
#include <QMessageBox>
#include <QVBoxLayout>

#include <utility>

namespace teleta::console {

namespace {

/// Rows of the list.
enum CalibratePart { motorsPart, cameraPart, gainsPart, loadsPart, partCount };

} // namespace

CalibratePage::CalibratePage(BraceletService& station, SourceManager& sources, QWidget* parent)
    : QWidget(parent)
    , m_messages(new chrome::MessageBar(this))
    , m_parts(new calibrate::StepList(partCount, this))
    , m_contents(new PageStack(this))
    , m_motors(new MotorCalibrator(station, this))
    , m_camera(new CameraCalibrator)
    , m_gains(new GainCalibrator(sources, this))
    , m_loads(new LoadCalibrator(this)) {
    m_parts->setFixedWidth(base::em(this, 12));
    m_parts->setFrameShape(QFrame::NoFrame);
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    row->addWidget(m_parts);
    row->addWidget(m_contents, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    layout->addLayout(row, 1);
    connect(m_parts, &QListWidget::currentRowChanged, m_contents, &PageStack::setCurrentIndex);
    const auto tell = [this](const QString& what, const QString& details) {
        m_messages->post({chrome::Message::Severity::error, what, details, QString()});
    };
    connect(m_motors, &MotorCalibrator::trouble, this, tell);
    connect(m_gains, &GainCalibrator::trouble, this, tell);
    connect(m_loads, &LoadCalibrator::trouble, this, tell);
    connect(m_gains, &GainCalibrator::demoRequested, this,
            [this] { emit demoRequested(QStringLiteral(":/scenes/tactile-even-load.toml")); });
    connect(m_camera, &CameraCalibrator::message, this, [this](const QString& text, bool isError) {
        using Severity = chrome::Message::Severity;
        m_messages->post({isError ? Severity::error : Severity::information, text, QString(), QString()});
    });
    addPart(&m_motors->view());
    addPart(m_camera);
    addPart(&m_gains->view());
    addPart(&m_loads->view());
    m_parts->setCurrentRow(0);
    base::keepTranslated(this, &CalibratePage::retranslate);
}

void CalibratePage::addPart(QWidget* content) {
    m_contents->addPage(content);
}

void CalibratePage::openPairs(const QString& path) {
    m_parts->setCurrentRow(cameraPart);
    m_camera->open(path);
}

void CalibratePage::tick() {
    m_motors->tick();
    m_gains->tick();
    m_parts->setReading(motorsPart, m_motors->step());
    m_parts->setReading(cameraPart, m_camera->step());
    m_parts->setReading(gainsPart, m_gains->view().step());
    m_parts->setReading(loadsPart, m_loads->view().step());
}

bool CalibratePage::isSaved(int part) const {
    switch (part) {
    case motorsPart:
        return m_motors->view().isSaved();
    case cameraPart:
        return m_camera->isSaved();
    case gainsPart:
        return m_gains->isSaved();
    default:
        return m_loads->isSaved();
    }
}

bool CalibratePage::canSave(int part) const {
    switch (part) {
    case motorsPart:
        return m_motors->canSave();
    case cameraPart:
        return m_camera->canSave();
    case gainsPart:
        return m_gains->canSave();
    default:
        return m_loads->canSave();
    }
}

void CalibratePage::save(int part, std::function<void()> done) {
    switch (part) {
    case motorsPart:
        m_motors->save({}, std::move(done));
        break;
    case cameraPart:
        m_camera->askToSave(std::move(done));
        break;
    case gainsPart:
        m_gains->askToSave(std::move(done));
        break;
    default:
        m_loads->askToSave(std::move(done));
    }
}

bool CalibratePage::hasUnsaved() const {
    for (int part = 0; part < partCount; ++part)
        if (!isSaved(part))
            return true;
    return false;
}

void CalibratePage::whenSettled(std::function<void()> goOn) {
    m_goOn = std::move(goOn);
    if (m_question)
        m_question->raise();
    else
        settle(motorsPart);
}

/// Continues with the next part.
void CalibratePage::settle(int part) {
    while (part < partCount && isSaved(part))
        ++part;
    if (part == partCount) {
        if (const auto goOn = std::exchange(m_goOn, nullptr))
            goOn();
        return;
    }
    m_parts->setCurrentRow(part);
    const bool canSave = this->canSave(part);
    const QString motors = part == motorsPart ? m_motors->unsavedText() : QString();
    auto* ask = new QMessageBox(
        QMessageBox::Question, tr("Unsaved calibration"),
        motors.isEmpty()
            ? tr("%1: the calibration is not saved.", "a part of the page").arg(m_parts->item(part)->text())
            : motors,
        QMessageBox::Discard | QMessageBox::Cancel, this);
    if (canSave)
        ask->addButton(QMessageBox::Save);
    ask->setObjectName(QStringLiteral("unsavedCalibration%1").arg(part));
    ask->setInformativeText(tr("Discarded values must be measured again."));
    ask->setAttribute(Qt::WA_DeleteOnClose);
    ask->setDefaultButton(canSave ? QMessageBox::Save : QMessageBox::Cancel);
    connect(ask, &QMessageBox::finished, this, [this, part](int answer) {
        m_question = nullptr;
        if (answer == QMessageBox::Save)
            save(part, [this, part] { settle(part); });
        else if (answer == QMessageBox::Discard)
            settle(part + 1);
    });
    m_question = ask;
    ask->open();
}

void CalibratePage::whenGainsSettled(pipeline::ChannelKey key, const QString& name,
                                     std::function<void()> goOn) {
    if (m_gains->isSaved(key)) {
        goOn();
        return;
    }
    auto* ask = new QMessageBox(QMessageBox::Question, tr("Unsaved calibration"),
                                tr("The taxel gains of %1 are not saved.", "a source").arg(name),
                                QMessageBox::Discard | QMessageBox::Cancel, window());
    const bool canSave = m_gains->isShown(key) && m_gains->canSave();
    if (canSave)
        ask->addButton(QMessageBox::Save);
    ask->setObjectName(QStringLiteral("unsavedGains"));
    ask->setInformativeText(tr("They are lost when the source is closed. Save them on the page Calibrate."));
    ask->setAttribute(Qt::WA_DeleteOnClose);
    ask->setDefaultButton(canSave ? QMessageBox::Save : QMessageBox::Cancel);
    connect(ask, &QMessageBox::finished, this, [this, goOn = std::move(goOn)](int answer) {
        if (answer == QMessageBox::Discard)
            goOn();
        else if (answer == QMessageBox::Save)
            m_gains->askToSave(goOn);
    });
    ask->open();
}

void CalibratePage::retranslate() {
    m_parts->setAccessibleName(tr("What can be calibrated"));
    m_parts->setName(motorsPart, tr("Bracelet motors"));
    m_parts->setName(cameraPart, tr("Cylinder camera"));
    m_parts->setName(gainsPart, tr("Taxel gains"));
    m_parts->setName(loadsPart, tr("Loads in newtons"));
}

} // namespace teleta::console
