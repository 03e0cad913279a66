// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/study_page.h"

#include "app/console/study/forms/deletion_dialog.h"
#include "app/console/study/forms/new_study_dialog.h"
#include "app/console/study/forms/server_fields.h"
#include "app/console/study/forms/server_study_dialog.h"
#include "app/console/study/study_writing.h"
#include "backend/study/protocol/protocol.h"
#include "widgets/base/background.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/study/participant/participant_window.h"
#include "widgets/study/planning/plan_panel.h"
#include "widgets/study/results/confusion_view.h"
#include "widgets/study/results/page/results_view.h"
#include "widgets/study/session_panel.h"
#include "widgets/study/study_names.h"
#include "widgets/study/study_panel.h"
#include "widgets/study/study_start.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QTabWidget>
#include <QVBoxLayout>

#include <array>
#include <utility>
#include <vector>

namespace teleta::console {

namespace {

constexpr char kResults[] = "results";
constexpr char kPlan[] = "plan";
constexpr char kParticipant[] = "participant";
constexpr std::array kSpeeds{1.0, 10.0, 50.0};
constexpr std::size_t kDefaultSpeed = 1;

QString studiesFolder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
        .filePath(QStringLiteral("TeleTA"));
}

QString newFolder(const QString& kind) {
    return QDir(studiesFolder())
        .filePath(kind + QDateTime::currentDateTime().toString(QStringLiteral("-yyyyMMdd'T'HHmmss")));
}

} // namespace

StudyPage::StudyPage(BraceletService& station, core::StopSwitch& stop, StudyController::SteadyClock clock,
                     StudyController::WallClock utcNow, QWidget* parent)
    : QWidget(parent)
    , m_controller(station, stop, std::move(clock), std::move(utcNow))
    , m_messages(new chrome::MessageBar(this))
    , m_stack(new QStackedWidget(this))
    , m_empty(new study::StudyStart(this))
    , m_tabs(new QTabWidget(this))
    , m_study(new study::StudyPanel(this))
    , m_session(new study::SessionPanel(this))
    , m_matrix(new study::ConfusionView(this))
    , m_counts(new QComboBox(this))
    , m_speed(new QComboBox(this))
    , m_speedRow(new QWidget(this))
    , m_speedLabel(new QLabel(this))
    // No parent: a modal dialog of the experimenter would block it.
    , m_participant(std::make_unique<study::ParticipantWindow>([this] { return m_controller.now_ns(); }))
    , m_placement(*m_participant, *this, *m_session)
    , m_results(new study::ResultsView(this))
    , m_plan(new study::PlanPanel(this))
    , m_planning(*m_plan)
    , m_bracelet(station, *m_results, *m_messages, nullptr)
    , m_leaving(new StudyLeaving(m_controller, *this)) {
    m_participant->setAttribute(Qt::WA_QuitOnClose, false); // it does not keep the program open
    build();
    connectViews();
    base::keepTranslated(this, &StudyPage::retranslate);
}

StudyPage::~StudyPage() {
    // Both send last signals in their destructors, when their receivers are gone.
    m_controller.disconnect(this);
    m_noise.disconnect(this);
}

void StudyPage::build() {
    using study::StudyStart;
    connect(m_empty, &StudyStart::lastRequested, this, &StudyPage::open);
    connect(m_empty, &StudyStart::rehearsalRequested, this, [this] { watchRehearsal(); });
    connect(m_empty, &StudyStart::publishedRequested, this,
            [this] { withPaper([this](const study::Protocol& paper) { readProtocol(paper); }); });
    connect(m_empty, &StudyStart::newRequested, this, [this] { askForNewStudy(study::Mode::run); });
    connect(m_empty, &StudyStart::openRequested, this, &StudyPage::askForStudy);
    connect(m_empty, &StudyStart::openServerRequested, this, &StudyPage::askForServer);

    m_matrix->setObjectName(QStringLiteral("liveMatrix"));
    m_counts->setObjectName(QStringLiteral("counts"));
    m_speed->setObjectName(QStringLiteral("speed"));
    m_counts->addItems({QString(), QString()});
    for (const double speed : kSpeeds)
        m_speed->addItem(QString(), speed);
    m_speed->setCurrentIndex(static_cast<int>(kDefaultSpeed));
    m_controller.setSpeed(kSpeeds[kDefaultSpeed]);
    auto* speed = new QHBoxLayout(m_speedRow);
    speed->setContentsMargins(0, 0, 0, 0);
    speed->addWidget(m_speedLabel);
    speed->addWidget(m_speed, 1);
    auto* right = new QWidget(this);
    auto* column = new QVBoxLayout(right);
    const int margin = base::grid(this, 2);
    column->setContentsMargins(margin, margin, margin, margin);
    column->addWidget(m_counts);
    column->addWidget(m_matrix, 1);
    column->addWidget(m_speedRow);

    auto* splitter = new QSplitter(this);
    splitter->setChildrenCollapsible(false);
    for (QWidget* part : {static_cast<QWidget*>(m_study), static_cast<QWidget*>(m_session), right})
        splitter->addWidget(part);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 5);
    splitter->setStretchFactor(2, 4);
    m_tabs->setDocumentMode(true);
    m_tabs->addTab(splitter, QString());
    m_tabs->addTab(m_results, QString());
    m_tabs->addTab(m_plan, QString());
    m_stack->addWidget(m_empty);
    m_stack->addWidget(m_tabs);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    layout->addWidget(m_stack, 1);
}

void StudyPage::connectViews() {
    StudyRunner& runner = m_controller.runner();
    using study::ParticipantWindow;
    connect(m_participant.get(), &ParticipantWindow::nextRequested, &runner, &StudyRunner::next);
    connect(m_participant.get(), &ParticipantWindow::replayRequested, &runner, &StudyRunner::replay);
    connect(m_participant.get(), &ParticipantWindow::pressed, &runner, &StudyRunner::press);
    connect(m_participant.get(), &ParticipantWindow::released, &runner,
            [&runner](const QString& device, const QString& key) {
                runner.release(device.toStdString(), key.toStdString());
            });
    connect(m_participant.get(), &ParticipantWindow::questionnaireAnswered, &m_controller.questionnaires(),
            &QuestionnaireSequence::submit);
    connect(m_participant.get(), &ParticipantWindow::left, &runner, &StudyRunner::pause);

    connect(&m_placement, &ParticipantPlacement::screenLost, this, [this] {
        m_controller.runner().pause();
        m_messages->post({chrome::Message::Severity::warning,
                          tr("The participant's screen was disconnected."),
                          tr("The participant's window is now next to the console, and the session pauses. "
                             "Reconnect the screen and show the window again."),
                          QString()});
    });

    connect(&m_placement, &ParticipantPlacement::consoleCovered, this, [this] {
        m_messages->post({chrome::Message::Severity::warning,
                          tr("The participant's window covers part of the console."),
                          tr("There is no second screen, and no room next to the console. Connect a second "
                             "screen, or make the console smaller, and show the window again."),
                          QString()});
    });

    using study::SessionPanel;
    connect(m_session, &SessionPanel::nextRequested, this, &StudyPage::doNextStep);
    connect(m_session, &SessionPanel::pauseRequested, &runner, &StudyRunner::pause);
    connect(m_session, &SessionPanel::abortRequested, &m_controller, &StudyController::abort);
    connect(m_session, &SessionPanel::skipRequested, &m_controller.questionnaires(),
            &QuestionnaireSequence::skip);
    connect(m_session, &SessionPanel::noteWritten, &m_controller, &StudyController::keepNote);
    connect(&m_controller, &StudyController::noteNotKept, m_session, &SessionPanel::restoreNote);
    connect(m_session, &SessionPanel::noiseConfirmed, &m_controller, &StudyController::setNoiseConfirmed);
    connect(m_session, &SessionPanel::noisePlayRequested, &m_noise, &NoisePlayer::setPlaying);
    connect(&m_noise, &NoisePlayer::changed, this, [this] {
        if (m_noise.isPlaying())
            m_noiseProblem.clear();
        refresh();
    });
    connect(&m_noise, &NoisePlayer::failed, this, [this](const core::Error& error) {
        m_noiseProblem = QString::fromStdString(error.message);
        tellThatNoiseFailed(error);
    });
    connect(m_session, &SessionPanel::participantWindowRequested, &m_placement, &ParticipantPlacement::show);

    using study::StudyPanel;
    connect(m_study, &StudyPanel::newRequested, this, [this] { askForNewStudy(study::Mode::run); });
    connect(m_study, &StudyPanel::openRequested, this, &StudyPage::askForStudy);
    connect(m_study, &StudyPanel::openServerRequested, this, &StudyPage::askForServer);
    connect(m_study, &StudyPanel::protocolRequested, this,
            [this] { readProtocol(m_controller.overview()->head.protocol); });
    connect(m_study, &StudyPanel::enrolRequested, &m_controller, &StudyController::enrol);
    connect(&m_controller, &StudyController::enrolled, m_study, &StudyPanel::clearName);
    connect(m_study, &StudyPanel::deleteRequested, this, &StudyPage::askForDeletion);
    connect(&m_controller, &StudyController::deleted, this,
            [this](const QString& id, const QStringList& stale) {
                m_messages->post(
                    {chrome::Message::Severity::information, tr("%1 was deleted.", "a participant").arg(id),
                     stale.isEmpty() ? QString()
                                     : tr("Results that were written before still count the participant: "
                                          "write them again."),
                     stale.join(QLatin1Char('\n'))});
            });
    connect(m_study, &StudyPanel::sessionChosen, &m_controller, &StudyController::choose);

    const auto figureFailed = [this](const QString& message) {
        m_messages->post(
            {chrome::Message::Severity::error, tr("The figure could not be saved."), {}, message});
    };
    connect(m_counts, &QComboBox::currentIndexChanged, this,
            [this](int index) { m_matrix->setPercent(index == 1); });
    connect(m_matrix, &study::ConfusionView::percentChanged, this,
            [this](bool percent) { m_counts->setCurrentIndex(percent ? 1 : 0); });
    connect(m_matrix, &study::ConfusionView::exportFailed, this, figureFailed);
    connect(m_speed, &QComboBox::currentIndexChanged, this,
            [this] { m_controller.setSpeed(m_speed->currentData().toDouble()); });

    connect(m_results, &study::ResultsView::exportRequested, &m_controller, &StudyController::write);
    connect(m_results, &study::ResultsView::figureFailed, this, figureFailed);
    connect(m_plan, &study::PlanPanel::figureFailed, this, figureFailed);
    connect(m_tabs, &QTabWidget::currentChanged, this, &StudyPage::analyse);
    connect(m_tabs, &QTabWidget::currentChanged, this, &StudyPage::showPlan);
    connect(&m_controller, &StudyController::resultsOutdated, this, [this] {
        m_outdated = true;
        analyse();
    });
    connect(&m_controller, &StudyController::rehearsed, this,
            [this] { bringForward(QLatin1String(kResults)); });
    connect(&m_controller, &StudyController::changed, this, &StudyPage::refresh);
    connect(&m_controller, &StudyController::failed, this,
            [this](const QString& what, const core::Error& error) {
                m_rehearseWhenOpened = false;
                report(what, error);
            });
    connect(&m_controller, &StudyController::written, this, [this](const QString& folder) {
        m_messages->post({chrome::Message::Severity::information, tr("Written: %1").arg(folder), {}, {}});
    });
    connect(&m_controller, &StudyController::opened, this, [this] {
        tellWhatWasOpened();
        m_session->takeKeyboard();
        if (std::exchange(m_rehearseWhenOpened, false))
            m_controller.startRehearsal();
    });
}

void StudyPage::askForDeletion(int participant) {
    const auto& overview = m_controller.overview();
    if (!overview || participant < 0 ||
        static_cast<std::size_t>(participant) >= overview->participants.size())
        return;
    const QString id =
        QString::fromStdString(overview->participants[static_cast<std::size_t>(participant)].participant.id);
    auto* dialog = new DeletionDialog(id, this);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog, id] { m_controller.deleteParticipant(id, dialog->reason()); });
    dialog->open();
}

void StudyPage::open(const QString& path) {
    if (path.startsWith(QLatin1String("postgres://")) || path.startsWith(QLatin1String("postgresql://"))) {
        ServerFields address;
        address.setAddress(path);
        m_controller.open(
            {QDir(studiesFolder()).filePath(address.folderName()).toStdString(), path.toStdString()});
        return;
    }
    using Protocol = core::Expected<study::Protocol>;
    base::runInBackground(
        this,
        [path] {
            return QFileInfo(path).isDir() ? std::optional<Protocol>()
                                           : std::optional(study::readProtocol(path.toStdString()));
        },
        [this, path](const std::optional<Protocol>& protocol) {
            if (!protocol)
                m_controller.open(path.toStdString());
            else if (*protocol && path.startsWith(QLatin1Char(':'))) // comes with the program
                readProtocol(**protocol);
            else if (*protocol)
                showProtocol(**protocol);
            else
                report(tr("%1 could not be opened.", "a file").arg(QFileInfo(path).fileName()),
                       protocol->error());
        });
}

void StudyPage::watchRehearsal(const QString& folder) {
    m_rehearseWhenOpened = true;
    const QString place = folder.isEmpty() ? newFolder(QStringLiteral("rehearsal")) : folder;
    base::runInBackground(
        this, [] { return study::paperProtocol(); },
        [this, place](const core::Expected<study::Protocol>& protocol) {
            if (!protocol) {
                report(tr("The paper's protocol could not be read."), protocol.error());
                return;
            }
            NewStudyDialog form(*protocol, place);
            form.setMode(study::Mode::simulated);
            m_controller.openOrCreate(form.location(), form.head());
        });
}

void StudyPage::watchScene(const study::StudyScene& scene, std::uint64_t seed, const QString& folder) {
    m_rehearseWhenOpened = true;
    m_controller.openScene(folder.isEmpty() ? newFolder(QStringLiteral("rehearsal")) : folder, scene, seed);
}

/// protocol: selected at first; otherwise the paper's.
void StudyPage::askForNewStudy(study::Mode mode, std::optional<study::Protocol> protocol) {
    base::runInBackground(
        this, [] { return study::builtInProtocols(); },
        [this, mode, own = std::move(protocol)](const core::Expected<std::vector<study::Protocol>>& all) {
            if (!all) {
                report(tr("The protocols that come with the program could not be read."), all.error());
                return;
            }
            const QString builtIn = tr("comes with the program", "a protocol");
            const study::Protocol first = own.value_or(all->front());
            auto* dialog = new NewStudyDialog(first, newFolder(QStringLiteral("study")), this,
                                              own ? QString() : builtIn);
            for (const study::Protocol& other : *all) {
                if (study::protocolText(other) != study::protocolText(first))
                    dialog->offer(other, builtIn);
            }
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            dialog->setMode(mode);
            connect(dialog, &QDialog::accepted, this,
                    [this, dialog] { m_controller.create(dialog->location(), dialog->head()); });
            dialog->open();
        });
}

void StudyPage::askForStudy() {
    base::askForFolder(this, {.title = tr("Open a study"), .folder = studiesFolder()},
                       [this](const QString& path) { open(path); });
}

void StudyPage::askForServer() {
    auto* dialog = new ServerStudyDialog(studiesFolder(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { m_controller.open(dialog->location()); });
    dialog->open();
}

void StudyPage::doNextStep() {
    switch (StudyScenes::nextStep(m_controller)) {
    case NextStep::enrol:
        m_study->askForName();
        return;
    case NextStep::begin:
        m_controller.begin();
        m_placement.show();
        return;
    case NextStep::rehearse:
        m_controller.startRehearsal();
        return;
    case NextStep::stopRehearsal:
        m_controller.stopRehearsal();
        m_controller.runner().pause();
        refresh();
        return;
    case NextStep::goOn:
        m_controller.goOn();
        if (m_controller.overview()->head.mode == study::Mode::simulated)
            m_controller.startRehearsal();
        else
            m_participant->activateWindow();
        return;
    case NextStep::retry:
        if (m_controller.questionnaires().current() != nullptr)
            m_controller.questionnaires().retry();
        else
            m_controller.runner().retry();
        return;
    case NextStep::fillIn:
        m_placement.show();
        return;
    case NextStep::leaveSession:
        m_controller.leaveSession();
        return;
    case NextStep::showResults:
        bringForward(QLatin1String(kResults));
        return;
    case NextStep::none:
        return;
    }
}

void StudyPage::refresh() {
    // What is not shown takes no room.
    const auto policy = m_controller.overview() ? QSizePolicy::Expanding : QSizePolicy::Ignored;
    m_tabs->setSizePolicy(policy, policy);
    m_stack->setCurrentWidget(m_controller.overview() ? static_cast<QWidget*>(m_tabs) : m_empty);
    if (!m_controller.overview())
        return;
    // The participant's window first: the participant waits for a response to the key.
    showParticipant();
    m_study->setScene(StudyScenes::study(m_controller));
    showSession();
    m_matrix->setContent(StudyScenes::matrix(m_controller));
    m_speedRow->setVisible(m_controller.overview()->head.mode == study::Mode::simulated);
    m_speed->setEnabled(!m_controller.isActive());
    showPlan();
}

void StudyPage::showPlan() {
    if (m_controller.overview() && m_tabs->currentWidget() == m_plan)
        m_planning.setStudy(m_controller.overview()->location, m_controller.overview()->head.protocol);
}

void StudyPage::showParticipant() {
    // Choices change only with the session; their pictures are expensive.
    QString session;
    if (const study::PlannedSession* plan = m_controller.plan())
        session = QStringLiteral("%1 %2 %3")
                      .arg(QString::fromStdString(m_controller.overview()->store))
                      .arg(plan->task)
                      .arg(plan->condition);
    if (session != m_choicesOf) {
        m_choicesOf = session;
        m_participant->setChoices(StudyScenes::choices(m_controller));
    }
    const QuestionnaireSequence& questionnaires = m_controller.questionnaires();
    if (questionnaires.current() != nullptr && m_asked != questionnaires.shown()) {
        m_asked = questionnaires.shown();
        m_participant->setQuestionnaire(*questionnaires.current(), questionnaires.filledIn());
    }
    m_participant->setScene(StudyScenes::participant(m_controller));
    m_participant->paintNow();
}

void StudyPage::showSession() {
    study::SessionScene scene = StudyScenes::session(m_controller);
    // The level at the ear depends on headphones and volume, not on what is played.
    scene.noisePlaying = m_noise.isPlaying();
    scene.needsNoise = scene.needsNoise || scene.noisePlaying; // whatever plays can be stopped
    if (!m_noiseProblem.isEmpty())
        scene.noiseText = tr("\u2717 Not played: %1. Play it from another device.").arg(m_noiseProblem);
    m_session->setScene(scene);
}

void StudyPage::tick() {
    m_controller.tick();
    if (isVisible() && m_controller.overview())
        showSession();
    // A rest counts down, and STOP is released while the session still waits.
    if (const study::Hold hold = m_controller.runner().hold();
        hold == study::Hold::rest || hold == study::Hold::stopped)
        m_participant->setScene(StudyScenes::participant(m_controller));
}

QStringList StudyPage::viewNames() {
    return {QStringLiteral("session"), QLatin1String(kResults), QLatin1String(kPlan),
            QLatin1String(kParticipant)};
}

void StudyPage::bringForward(const QString& view) {
    m_tabs->setCurrentWidget(view == QLatin1String(kResults) ? static_cast<QWidget*>(m_results)
                             : view == QLatin1String(kPlan)  ? static_cast<QWidget*>(m_plan)
                                                             : m_tabs->widget(0));
    if (view == QLatin1String(kParticipant))
        m_placement.show();
}

QWidget* StudyPage::forwardWindow() const {
    return m_participant->isVisible() ? m_participant.get() : nullptr;
}

/// Updates the results if they are visible and outdated.
void StudyPage::analyse() {
    if (!m_controller.overview() || !m_outdated || m_analysing || m_tabs->currentWidget() != m_results)
        return;
    m_outdated = false;
    m_analysing = true;
    m_results->setState(tr("Computing \u2026"));
    const StudyOverview& overview = *m_controller.overview();
    study::ResultsScene scene;
    scene.mode = overview.head.mode;
    for (const study::StudyTask& task : overview.head.protocol.tasks) {
        const QString id = QString::fromStdString(task.id);
        scene.taskNames.insert(id, study::displayName(task));
        for (const std::string& condition : task.conditions)
            scene.conditionNames[id].insert(QString::fromStdString(condition),
                                            study::displayCondition(task, condition));
        for (const study::StudyPattern& pattern : task.patterns)
            scene.patternNames[id].insert(QString::fromStdString(pattern.letter),
                                          study::displayName(task, pattern));
    }
    base::runInBackground(
        this, [location = overview.location] { return resultsOf(location); },
        [this, scene](core::Expected<StudyResults> results) mutable {
            m_analysing = false;
            if (results) {
                scene.tasks = std::move(results->tasks);
                scene.levels = std::move(results->levels);
                scene.supplements = std::move(results->supplements);
                scene.exclusions = std::move(results->exclusions);
                m_results->setState(scene.tasks.empty() ? tr("There are no completed trials yet.")
                                                        : tr("Completed test trials only."));
                m_results->setScene(std::move(scene));
            } else {
                m_results->setState({});
                report(tr("The results could not be computed."), results.error());
            }
            analyse();
        });
}

void StudyPage::report(const QString& what, const core::Error& error) {
    m_messages->post(
        {chrome::Message::Severity::error, what, QString::fromStdString(core::describe(error)), QString()});
    emit openFailed(error);
}

void StudyPage::retranslate() {
    m_tabs->setTabText(0, tr("Session"));
    m_tabs->setTabText(1, tr("Results"));
    m_tabs->setTabText(2, tr("Plan"));
    m_counts->setItemText(0, tr("Counts"));
    m_counts->setItemText(1, tr("Percent of the row"));
    m_counts->setAccessibleName(tr("What the matrix shows"));
    m_speedLabel->setText(tr("Spee&d"));
    m_speedLabel->setBuddy(m_speed);
    const QSignalBlocker quiet(m_speed);
    m_speed->setItemText(0, tr("Real time, felt on the bracelet"));
    for (int i = 1; i < m_speed->count(); ++i)
        m_speed->setItemText(i, tr("%1 times real time, not played").arg(m_speed->itemData(i).toInt()));
    m_speed->setToolTip(tr("Speed of the simulated participants; can be changed between sessions"));
    setLast(std::exchange(m_last, {}));
    // For the names of answers and tasks.
    m_choicesOf.clear();
    m_outdated = true;
    refresh();
    analyse();
}

} // namespace teleta::console
