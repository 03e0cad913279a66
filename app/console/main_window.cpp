// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/main_window.h"

#include "app/console/base/page_stack.h"
#include "app/console/bracelet/bracelet_menu.h"
#include "app/console/bracelet/hand_station.h"
#include "app/console/calibrate/calibrate_page.h"
#include "app/console/cost/cost_page.h"
#include "app/console/desktop/layouts_menu.h"
#include "app/console/file_opener.h"
#include "app/console/foxglove/live_view_service.h"
#include "app/console/help/about.h"
#include "app/console/help/help_menu.h"
#include "app/console/language_menu.h"
#include "app/console/operate/arm_views.h"
#include "app/console/operate/operate_page.h"
#include "app/console/operate/recording/recording_files.h"
#include "app/console/operate/recording_controls.h"
#include "app/console/patterns/pattern_collection.h"
#include "app/console/patterns/patterns_page.h"
#include "app/console/plot/plot_page.h"
#include "app/console/settings_notice.h"
#include "app/console/sources/camera_dialog.h"
#include "app/console/sources/demo_scenes.h"
#include "app/console/start/recent_names.h"
#include "app/console/study/study_page.h"
#include "backend/core/steady_time.h"
#include "backend/cost/ladders/ladders.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/chrome/device_strip.h"
#include "widgets/chrome/message_log.h"
#include "widgets/chrome/page_rail.h"
#include "widgets/chrome/recording_indicator.h"
#include "widgets/chrome/stop_banner.h"
#include "widgets/chrome/stop_button.h"
#include "widgets/chrome/stop_reach.h"
#include "widgets/pattern/pattern_editor.h"
#include "widgets/view3d/scene3d_view.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDebug>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace teleta::console {

namespace {

constexpr char kOperate[] = "operate";
constexpr char kStudy[] = "study";

/// Room for the frame and the title that a desktop draws around the window.
constexpr QSize kFrame_px(16, 48);

/// What the pictures of an arm need beside each other, in any language.
constexpr QSize kSmall_em(68, 46);
/// In a lower window the controls of the arm would scroll.
constexpr int kLow_em = 54;

} // namespace

MainWindow::MainWindow(const ConsoleOptions& options, ConsoleSettings& settings, core::StopSwitch& stop)
    : m_settings(settings)
    , m_stop(stop)
    , m_bracelet(stop)
    , m_sources(stop)
    , m_recorder(m_sources, m_bracelet, stop)
    , m_collection(new PatternCollection(
          options.dataFolder.isEmpty() ? QString() : options.dataFolder + QStringLiteral("/patterns"), this))
    , m_recordings(new RecordingFiles(m_sources, settings, this))
    , m_rail(new chrome::PageRail(this))
    , m_pages(new PageStack(this))
    , m_operate(new OperatePage(m_sources, m_bracelet, stop, this))
    , m_patterns(new PatternsPage(
          m_bracelet, *m_collection,
          options.dataFolder.isEmpty() ? QString() : options.dataFolder + QStringLiteral("/recovery"), this))
    , m_study(new StudyPage(m_bracelet, stop, core::steadyNow_ns, QDateTime::currentDateTimeUtc, this))
    , m_calibrate(new CalibratePage(m_bracelet, m_sources, this))
    , m_cost(new CostPage(cost::allLadders,
                          options.dataFolder.isEmpty()
                              ? QString()
                              : options.dataFolder + QStringLiteral("/cost/tradeoff.csv"),
                          {}, this))
    , m_plot(new PlotPage(m_sources, settings, this))
    , m_recentNames(new RecentFileNames(this))
    , m_layouts(new LayoutsMenu(m_operate->docks(), settings, this))
    , m_braceletMenu(new BraceletMenu(m_bracelet, settings, this))
    , m_recording(new RecordingControls(m_recorder, m_sources, *m_operate, settings, this))
    , m_live(std::make_unique<LiveViewService>(m_sources, m_bracelet))
    , m_help(new HelpMenu(*this, [this] { return m_rail->currentPage(); }))
    , m_opener(new FileOpener(m_sources, *m_recordings, *m_study, m_stop, options.seed, this))
    , m_hand(std::make_unique<HandStation>())
    , m_devices(new chrome::DeviceStrip(this))
    , m_stopButton(new chrome::StopButton(this))
    , m_stopReach(std::make_unique<chrome::StopReach>(*m_stopButton))
    , m_stopBanner(new chrome::StopBanner(this))
    , m_stopCause(chrome::StopCause::program)
    , m_questions(*this, *m_patterns, *m_calibrate, *m_study) {
    m_study->controller().setRecording(&m_sessionRecorder);
    setAcceptDrops(true);
    for (const Page& page : pages()) {
        m_rail->addPage(page.name, page.icon, page.title, page.about);
        m_pages->addPage(page.content);
    }

    auto* status = new QWidget(this);
    auto* statusRow = new QHBoxLayout(status);
    statusRow->setContentsMargins(base::grid(this), base::grid(this, 0.5), base::grid(this, 0.5),
                                  base::grid(this, 0.5));
    statusRow->addWidget(m_devices, 1);
    statusRow->addWidget(m_recording->indicator());
    statusRow->addWidget(m_stopButton);

    auto* right = new QVBoxLayout;
    right->setSpacing(0);
    right->addWidget(m_pages, 1);
    right->addWidget(m_stopBanner);
    right->addWidget(status);
    auto* central = new QWidget(this);
    auto* row = new QHBoxLayout(central);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(m_rail);
    row->addLayout(right, 1);
    setCentralWidget(central);

    connect(m_rail, &chrome::PageRail::pageRequested, this, &MainWindow::showPage);
    connect(m_devices, &chrome::DeviceStrip::deviceActivated, this, [this](int index) {
        if (index < static_cast<int>(m_sources.items().size()))
            m_sources.activate(m_sources.items()[static_cast<std::size_t>(index)].key);
    });
    connect(m_stopButton, &chrome::StopButton::stopRequested, this,
            [this] { engageStop(chrome::StopCause::button); });
    connect(m_stopButton, &chrome::StopButton::releaseRequested, this, [this] {
        m_stop.release();
        showStop();
    });
    // Once the mouse or the key is up: the next Space is for the page, and stops nothing.
    connect(m_stopButton, &QAbstractButton::released, this, [this] {
        if (!m_stop.engaged())
            focusPage();
    });
    connect(&m_sources, &SourceManager::failed, this, &MainWindow::onFailed);
    connect(m_recordings, &RecordingFiles::failed, this, &MainWindow::onFailed);
    connect(m_live.get(), &LiveViewService::listening, this, [this](const QString& address) {
        m_operate->messages().post(
            {chrome::Message::Severity::information, tr("Foxglove can be connected to %1.").arg(address),
             tr("Open connection > Foxglove WebSocket shows all sources there."), QString()});
    });
    connect(m_live.get(), &LiveViewService::failed, this, [this](const QString& why) {
        m_operate->messages().post({chrome::Message::Severity::error, tr("The live view has ended."),
                                    tr("Choose another port with --foxglove."), why});
    });
    connect(m_recording.get(), &RecordingControls::playRequested, m_opener, &FileOpener::openRecording);
    connect(m_recordings, &RecordingFiles::opened, this, &MainWindow::addRecent);
    connect(&m_recorder, &RecordingService::finished, this, &MainWindow::addRecent);
    connect(m_recordings, &RecordingFiles::imported, this, &MainWindow::onImported);
    connect(m_opener, &FileOpener::failed, this, &MainWindow::onFailed);
    for (const auto opened :
         {&FileOpener::listOpened, &FileOpener::sceneOpened, &FileOpener::armOpened, &FileOpener::siteOpened})
        connect(m_opener, opened, this, &MainWindow::addRecent);
    connect(m_opener, &FileOpener::siteAwaited, this, [this](const QString& name) {
        m_operate->messages().post({chrome::Message::Severity::information,
                                    tr("Looking for the site of %1\u2026").arg(name),
                                    {},
                                    {}});
    });
    connectStartPage();
    connect(m_layouts, &LayoutsMenu::notRestored, this, [this](const QString& name) {
        m_operate->messages().post(
            {chrome::Message::Severity::warning,
             tr("The layout %1 cannot be restored; the default one is shown.").arg(name),
             tr("It was saved by another version of the program."), QString()});
    });
    // For the log: the checks before a session say it where it matters.
    connect(&m_screen, &ScreenKeeper::failed, this, [](const QString& why) {
        qInfo().noquote() << tr("The desktop may turn the screen off while something runs: %1").arg(why);
    });
    connect(m_opener, &FileOpener::studyShown, this, [this] { showPage(QLatin1String(kStudy)); });
    connect(&m_questions, &ClosingQuestions::pageRequested, this, &MainWindow::showPage);
    // The release of a key that is down then goes elsewhere.
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state != Qt::ApplicationActive)
            m_escapeDown = false;
    });
    connect(m_operate.get(), &OperatePage::demoRequested, this, &MainWindow::openDemo);
    connect(m_operate.get(), &OperatePage::closeRequested, this, &MainWindow::closeSource);
    connect(m_operate.get(), &OperatePage::firstStepsRequested, m_help, &HelpMenu::openFirstSteps);
    connect(m_operate.get(), &OperatePage::openRecordingRequested, this, [this] {
        askForFile(tr("Open recording"),
                   tr("Recordings (*.teleta *.csv *.mcap *.npz *.npy *.h5 *.hdf5 *.mat *.asf)"),
                   &FileOpener::openRecording, m_recordings->folder(m_recording->folder()));
    });
    connect(m_operate.get(), &OperatePage::openListRequested, this, [this] {
        askForFile(tr("Open source list"), tr("Source lists (*.toml)"), &FileOpener::openList);
    });
    connect(m_cost.get(), &CostPage::demoCameraRequested, this,
            [this] { m_opener->openScene(QStringLiteral(":/scenes/vtacarm-multicontact.toml")); });
    connect(m_plot.get(), &PlotPage::demoRequested, this, &MainWindow::openDemo);
    auto& chooser = m_operate->chooser();
    connect(m_calibrate.get(), &CalibratePage::demoRequested, m_opener, &FileOpener::openScene);
    connect(m_operate.get(), &OperatePage::sceneRequested, m_opener, &FileOpener::openScene);
    connect(&chooser, &chrome::SourceChooser::demoRequested, m_opener, &FileOpener::openScene);
    connect(&chooser, &chrome::SourceChooser::openRecordingRequested, m_operate.get(),
            &OperatePage::openRecordingRequested);
    connect(&chooser, &chrome::SourceChooser::openListRequested, m_operate.get(),
            &OperatePage::openListRequested);
    connect(&chooser, &chrome::SourceChooser::openSceneRequested, this,
            [this] { askForFile(tr("Open scene"), tr("Scenes (*.toml)"), &FileOpener::openScene); });
    connect(&chooser, &chrome::SourceChooser::openCameraRequested, this, &MainWindow::openCamera);
    connect(&chooser, &chrome::SourceChooser::openArmRequested, this, &MainWindow::openArm);
    connect(&chooser, &chrome::SourceChooser::recentRequested, m_opener, &FileOpener::openFile);
    connect(&m_bracelet, &BraceletService::chosen, this, &MainWindow::buildMenus);
    connect(&m_operate->armViews().feedbackPanel(), &FeedbackPanel::changed, this, &MainWindow::saveFeedback);
    connect(&m_sources, &SourceManager::activeChanged, this, &MainWindow::buildMenus);
    auto& reconstruction = m_operate->reconstruction();
    reconstruction.setHiddenLayers(m_settings.hiddenLayers());
    connect(&reconstruction, &view3d::Scene3dView::layersChanged, this,
            [this] { m_settings.setHiddenLayers(m_operate->reconstruction().hiddenLayers()); });
    connect(m_collection, &PatternCollection::changed, this, &MainWindow::takeOwnPatterns);
    connect(m_patterns.get(), &PatternsPage::used, this, [this](const QString& path) {
        m_settings.addRecentPattern(path);
        showRecent();
    });
    connect(&m_study->controller(), &StudyController::opened, this, [this] {
        const auto& location = m_study->controller().overview()->location;
        if (location.server.empty())
            m_settings.addRecentStudy(QString::fromStdString(location.folder));
        showRecent();
    });
    connect(m_patterns.get(), &PatternsPage::recoveryOffered, this, [this](const QString& text) {
        m_operate->messages().post({chrome::Message::Severity::information, text,
                                    tr("The page Patterns opens the edits."), QString()});
    });
    connect(m_study.get(), &StudyPage::openFailed, this, [this] { m_anyFailure = true; });
    if (const auto notice = settingsNotice(m_settings))
        m_operate->messages().post(*notice);
    restoreFeedback();
    m_braceletMenu->restore(options.bracelet);
    showRecent();
    base::keepTranslated(this, &MainWindow::retranslate);
    qApp->installEventFilter(this);

    resize(base::em(this, 96), base::em(this, 60));
    if (!m_settings.geometry().isEmpty())
        restoreGeometry(m_settings.geometry());
    if (options.size.isValid())
        resize(options.size);
    // Nobody presses STOP in a picture, which may be larger than the screen.
    if (options.screenshot.isEmpty())
        keepOnScreen();
    if (!m_settings.layout(QLatin1String(kOperate)).isEmpty())
        m_operate->docks().restoreLayouts(m_settings.layout(QLatin1String(kOperate)));

    offerLastSession();
    const QString page = options.page.isEmpty() ? m_settings.page() : options.page;
    if (pageNames().contains(page))
        showPage(page);
    if (StudyPage::viewNames().contains(options.dock))
        m_study->bringForward(options.dock);
    else if (!options.dock.isEmpty())
        m_operate->docks().bringForward(options.dock);

    connect(&m_clock, &GuiClock::tick, this, &MainWindow::onTick);
    m_clock.start();
}

MainWindow::~MainWindow() {
    qApp->removeEventFilter(this);
}

void MainWindow::onTick() {
    m_sources.poll();
    m_operate->armViews().setHand(m_hand->motion(), m_hand->text());
    m_recording->tick();
    m_live->tick();
    m_operate->tick();
    m_patterns->tick();
    m_study->tick();
    m_calibrate->tick();
    m_cost->tick(m_operate->cameraViews().camera());
    m_plot->tick();
    beginRecording();
    std::vector<chrome::DeviceReading> readings = m_operate->readings();
    if (auto hand = m_hand->reading())
        readings.push_back(std::move(*hand));
    m_devices->setReadings(readings);
    showStop();
    keepScreen();
}

void MainWindow::openRequested(const ConsoleOptions& options) {
    if (!options.screenshot.isEmpty() || options.measure_s)
        m_questions.waive();
    if (options.scenes.isEmpty())
        m_opener->openStudy(options.study, options.rehearse);
    else
        m_opener->openScenes(options.scenes, options.study, options.rehearse);
    for (const QString& path : options.files)
        m_opener->openFile(path);
    for (const RecordingArguments& recording : options.recordings)
        m_opener->openAs(recording);
    if (options.camera)
        m_sources.open(*options.camera);
    for (const QString& arm : options.arms)
        m_opener->openArm(arm);
    for (const QString& site : options.sites)
        m_opener->openSite(site);
    if (!options.sourceList.isEmpty())
        m_opener->openList(options.sourceList);
    if (!options.pattern.isEmpty()) {
        if (options.page.isEmpty())
            showPage(QStringLiteral("patterns"));
        m_patterns->open(options.pattern);
    }
    if (m_settings.atStart() == AtStart::open && !options.opensAnything())
        openLastSession();
    m_record = options.record;
    m_live->setOptions(options.liveView);
    if (options.startsLiveView)
        m_live->start();
    if (!options.cameraPairs.isEmpty())
        m_calibrate->openPairs(options.cameraPairs);
    if (!options.plotted.isEmpty())
        m_plot->plotNamed(options.plotted);
}

/// The recording that was asked for at the start. Its head tells of what is open by then, so it waits for all
/// of that, and for nothing that has failed.
void MainWindow::beginRecording() {
    const BraceletService& bracelet = m_bracelet;
    const auto& items = m_sources.items();
    const bool isWaiting =
        m_opener->isReading() || (bracelet.choice() != BraceletChoice::none && !bracelet.session()) ||
        std::any_of(items.begin(), items.end(), [](const auto& item) { return !item.isOpen(); });
    if (!m_record.isEmpty() && !isWaiting)
        m_recorder.start(std::exchange(m_record, {}));
}

void MainWindow::openDemo() {
    m_opener->openScene(QStringLiteral(":/scenes/teleta-touch.toml"));
}

void MainWindow::openCamera() {
    auto* dialog = new CameraDialog(m_settings.camera(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        m_settings.setCamera(dialog->request());
        m_sources.open(dialog->sourceRequest());
    });
    dialog->open();
}

void MainWindow::closeSource(std::uint64_t key) {
    const SourceManager::Item* item = m_sources.find(key);
    if (item != nullptr)
        m_calibrate->whenGainsSettled(key, item->name, [this, key] { m_sources.close(key); });
}

void MainWindow::addRecent(const QString& path) {
    m_settings.addRecentFile(path);
    showRecent();
}

void MainWindow::onImported(const QString& file, const QString& recording, const QString& missing) {
    m_operate->messages().post(
        {missing.isEmpty() ? chrome::Message::Severity::information : chrome::Message::Severity::warning,
         tr("%1 was made from %2.", "two files")
             .arg(QFileInfo(recording).fileName(), QFileInfo(file).fileName()),
         missing, recording});
}

void MainWindow::keepScreen() {
    const StudyController& study = m_study->controller();
    const bool choosesSession =
        m_rail->currentPage() == QLatin1String(kStudy) && study.chosenSession() != nullptr;
    const auto& items = m_sources.items();
    const bool armMayMove =
        !m_stop.engaged() && std::any_of(items.begin(), items.end(), [](const auto& item) {
            return item.playback() == nullptr && (item.arm() != nullptr || item.servo() != nullptr);
        });
    const bool wanted = m_settings.keepsScreenOn() &&
                        (m_recorder.isRecording() || study.isActive() || choosesSession || armMayMove);
    m_screen.setWanted(wanted, tr("A robot arm, a recording or a session is running"));
    const bool isKnown = m_screen.state() == ScreenKeeper::State::held ||
                         m_screen.state() == ScreenKeeper::State::unavailable || !m_settings.keepsScreenOn();
    m_study->controller().setScreenHeld(isKnown ? std::optional(m_screen.state() == ScreenKeeper::State::held)
                                                : std::nullopt);
}

void MainWindow::askForFile(const QString& title, const QString& filter,
                            void (FileOpener::*open)(const QString&), const QString& folder) {
    base::askToOpen(this, {.title = title, .filters = {filter}, .folder = folder},
                    [this, open](const QString& path) { (m_opener->*open)(path); });
}

void MainWindow::onFailed(const QString& name, const core::Error& error) {
    m_anyFailure = true;
    const QString details = QString::fromStdString(core::describe(error));
    std::fprintf(stderr, "teleta-console: %s\n", qPrintable(details));
    m_operate->messages().post({chrome::Message::Severity::error,
                                tr("%1 could not be opened.", "a file").arg(name), details, QString()});
}

void MainWindow::engageStop(chrome::StopCause cause) {
    const bool wasEngaged = m_stop.engaged();
    m_stop.engage();
    if (!wasEngaged)
        m_stopCause = cause;
    showStop();
}

void MainWindow::showStop() {
    using Severity = chrome::Message::Severity;
    const std::int64_t since_ns = m_stop.engagedSince_ns();
    m_stopButton->setEngaged(since_ns != 0);
    if (since_ns == m_stoppedSince_ns)
        return;
    const std::int64_t before_ns = std::exchange(m_stoppedSince_ns, since_ns);
    chrome::MessageLog& log = chrome::MessageLog::instance();
    const auto ago_ms = [](std::int64_t time_ns) { return (core::steadyNow_ns() - time_ns) / 1'000'000; };
    if (before_ns != 0)
        log.append(Severity::information,
                   tr("STOP was released after %1 s.")
                       .arg(QLocale().toString(static_cast<double>(ago_ms(before_ns)) * 1e-3, 'f', 1)));
    if (since_ns == 0) {
        m_stopCause = chrome::StopCause::program;
        m_stopBanner->release();
        m_operate->onStopReleased();
        return;
    }
    log.append(Severity::warning, tr("STOP. %1", "cause").arg(chrome::StopBanner::sentence(m_stopCause)));
    m_stopBanner->engage(m_stopCause, QDateTime::currentDateTime().addMSecs(-ago_ms(since_ns)));
}

void MainWindow::showPage(const QString& name) {
    m_rail->setCurrentPage(name);
    for (const Page& page : pages())
        if (page.name == name)
            m_pages->showPage(page.content);
    m_settings.setPage(name);
    focusPage();
}

/// STOP is at the lower right: a window that is larger than its screen, or beside it, would hide it.
void MainWindow::keepOnScreen() {
    if (isMaximized() || isFullScreen())
        return;
    const QRect room = screen()->availableGeometry();
    resize(size().boundedTo(room.size() - kFrame_px));
    if (!testAttribute(Qt::WA_Moved)) // the desktop finds a place
        return;
    // Without the frame, whose place is not known before the window is shown.
    const QSize whole = size() + 0.5 * kFrame_px;
    const QRect place(
        QPoint(std::clamp(geometry().x(), room.left(), room.left() + room.width() - whole.width()),
               std::clamp(geometry().y(), room.top(), room.top() + room.height() - whole.height())),
        size());
    if (place != geometry())
        setGeometry(place);
}

void MainWindow::focusPage() {
    for (const Page& page : pages())
        if (page.name == m_rail->currentPage())
            (page.first != nullptr ? page.first : page.content)->setFocus(Qt::OtherFocusReason);
}

void MainWindow::setTheme(const QString& theme) {
    m_settings.setTheme(theme);
    base::applyTheme(themeFromName(theme));
}

void MainWindow::saveState() {
    m_settings.setGeometry(saveGeometry());
    m_settings.setLayout(QLatin1String(kOperate), m_operate->docks().saveLayouts());
    for (const SourceManager::Item& item : m_sources.items())
        if (const auto* camera = std::get_if<app::CameraRequest>(&item.request))
            m_settings.setCamera(*camera);
    m_settings.setLastSession(session());
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    const bool small =
        width() < base::em(this, kSmall_em.width()) || height() < base::em(this, kSmall_em.height());
    m_rail->setIconsOnly(small);
    m_operate->setCompact(height() < base::em(this, kLow_em), small);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_questions.allow()) {
        event->ignore();
        return;
    }
    // Whatever moves is stopped before the window that can stop it is gone. A site goes on without it.
    for (const SourceManager::Item& item : m_sources.items())
        if (const auto* remote = std::get_if<app::SiteRequest>(&item.request))
            if (const auto site = remote->site.lock())
                site->leave();
    m_stop.engage();
    m_clock.stop();
    saveState();
    m_recording->stop();
    m_sources.closeAll();
    QMainWindow::closeEvent(event);
}

void MainWindow::leave() {
    m_questions.waive();
    close();
    QApplication::exit(m_anyFailure ? 3 : 0);
}

void MainWindow::secure() {
    m_bracelet.waitUntilOff();
    m_recorder.completeNow();
    m_study->controller().waitUntilKept();
}

/// In the order of the rail.
std::vector<MainWindow::Page> MainWindow::pages() const {
    return {{QStringLiteral("operate"), base::Icon::operate, tr("Operate"),
             tr("What the arm touches, live or played back"), m_operate.get()},
            {QStringLiteral("patterns"), base::Icon::patterns, tr("Patterns"),
             tr("What the bracelet can say: edit, check and play patterns"), m_patterns.get(),
             m_patterns->editor().timeline()},
            {QStringLiteral("study"), base::Icon::study, tr("Study"),
             tr("User studies: from the first practice trial to confusion matrices and ANOVA"),
             m_study.get()},
            {QStringLiteral("calibrate"), base::Icon::calibrate, tr("Calibrate"),
             tr("What has to be measured: the motors of the bracelet, the camera in the tube, the taxels"),
             m_calibrate.get()},
            {QStringLiteral("cost"), base::Icon::cost, tr("Cost"),
             tr("What accuracy costs in time on this machine, and the setting that the camera uses"),
             m_cost.get()},
            {QStringLiteral("plot"), base::Icon::plot, tr("Plot"),
             tr("Any signal over time: live ones and those of recordings, with cursors and spectra"),
             m_plot.get()}};
}

void MainWindow::retranslate() {
    setWindowTitle(tr("TeleTA Console"));
    for (const Page& page : pages())
        m_rail->setTitle(page.name, page.title, page.about);
    m_operate->setDemos(demoScenes(), startCards());
    buildMenus();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    for (const QUrl& url : event->mimeData()->urls()) {
        const QString suffix = QFileInfo(url.toLocalFile()).suffix().toLower();
        if (QStringList{"csv", "mcap", "teleta", "toml"}.contains(suffix)) {
            event->acceptProposedAction();
            return;
        }
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile())
            m_opener->openFile(url.toLocalFile());
    }
    event->acceptProposedAction();
}

} // namespace teleta::console
