// SPDX-License-Identifier: GPL-3.0-or-later
// The menus of the window, what they set, and the keys of the whole program.
#include "app/console/bracelet/bracelet_menu.h"
#include "app/console/desktop/first_steps_keeper.h"
#include "app/console/desktop/last_session.h"
#include "app/console/desktop/layouts_menu.h"
#include "app/console/desktop/preferences_dialog.h"
#include "app/console/file_opener.h"
#include "app/console/foxglove/live_view_service.h"
#include "app/console/help/help_menu.h"
#include "app/console/language_menu.h"
#include "app/console/main_window.h"
#include "app/console/operate/arm_views.h"
#include "app/console/operate/operate_page.h"
#include "app/console/operate/recording/recording_files.h"
#include "app/console/operate/recording_controls.h"
#include "app/console/patterns/patterns_page.h"
#include "app/console/start/recent_names.h"
#include "app/console/start/start_page.h"
#include "app/console/study/study_page.h"
#include "widgets/base/mnemonics.h"
#include "widgets/chrome/start/first_steps.h"
#include "widgets/chrome/start/recent_list.h"
#include "widgets/chrome/stop_banner.h"
#include "widgets/pattern/pattern_editor.h"

#include <QActionGroup>
#include <QApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>

#include <optional>
#include <utility>
#include <vector>

namespace teleta::console {

namespace {

/// Two presses of Escape within this time are STOP.
constexpr int kDoubleEscape_ms = 600;

} // namespace

bool MainWindow::openMenuBy(QKeyEvent& key) {
    if (key.modifiers() != Qt::AltModifier || !isActiveWindow() ||
        QApplication::activePopupWidget() != nullptr)
        return false;
    for (QAction* menu : menuBar()->actions()) {
        if (QKeySequence::mnemonic(menu->text()) != QKeySequence(key.keyCombination()))
            continue;
        key.accept(); // of an override: no shortcut is run
        if (key.type() == QEvent::KeyPress)
            menuBar()->setActiveAction(menu);
        return true;
    }
    return false;
}

void MainWindow::buildMenus() {
    // The bar keeps menus that are no longer in it; one of them may have asked for this.
    for (QMenu* menu : menuBar()->findChildren<QMenu*>(Qt::FindDirectChildrenOnly))
        menu->deleteLater();
    menuBar()->clear();
    QMenu* file = menuBar()->addMenu(tr("&File"));
    QMenu* open = m_operate->chooser().openMenu();
    open->setTitle(tr("&Open"));
    file->addMenu(open);
    QAction* close = file->addAction(tr("&Close source"), QKeySequence::Close, this, [this] {
        if (const auto* item = m_sources.active())
            closeSource(item->key);
    });
    close->setToolTip(tr("Close the source that is shown"));
    addRecentMenu(*file);
    file->addSeparator();
    QAction* preferences = file->addAction(tr("&Preferences\u2026"), Qt::CTRL | Qt::Key_Comma, this,
                                           &MainWindow::editPreferences);
    preferences->setMenuRole(QAction::PreferencesRole);
    file->addSeparator();
    file->addAction(tr("&Quit"), QKeySequence::Quit, this, &QWidget::close);

    QMenu* view = menuBar()->addMenu(tr("&View"));
    view->addActions(m_operate->docks().actions());
    view->addSeparator();
    m_layouts->fill(*view);
    view->addAction(tr("&Reset layout"), this, [this] { m_operate->docks().resetLayout(); });
    view->addSeparator();
    auto* themes = new QActionGroup(view);
    const QString current = m_settings.theme();
    const auto addTheme = [&](const QString& text, const QString& theme) {
        QAction* action = view->addAction(text, this, [this, theme] { setTheme(theme); });
        action->setCheckable(true);
        action->setChecked(theme == current);
        themes->addAction(action);
    };
    addTheme(tr("&Light"), QStringLiteral("light"));
    addTheme(tr("&Dark"), QStringLiteral("dark"));
    addTheme(tr("As the de&sktop"), QStringLiteral("system"));
    addLanguageMenu(*view, m_settings);
    view->addSeparator();
    m_live->fill(*view);
    view->addAction(tr("&Full screen"), QKeySequence::FullScreen, this,
                    [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });

    m_recording->fill(*menuBar()->addMenu(tr("&Recording")));
    buildArmMenu();
    m_braceletMenu->fill(*menuBar()->addMenu(tr("&Bracelet")));

    m_help->fill(*menuBar()->addMenu(tr("&Help")));
}

void MainWindow::buildArmMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Arm"));
    const SourceManager::Item* item = m_sources.active();
    const bool hasArm = item != nullptr && item->arm() != nullptr;
    const bool hasProgram = m_operate->hasProgram();
    menu->addAction(tr("&Open arm\u2026"), this, &MainWindow::openArm)
        ->setToolTip(tr("An arm over ROS 2, described in a file"));
    menu->addAction(tr("&Connect to a site\u2026"), this, &MainWindow::openSite)
        ->setToolTip(tr("Arms and arrays at another place, where teleta-site runs"));
    menu->addSeparator();
    const auto add = [&](const QString& text, const QKeySequence& key, bool isPossible, auto call) {
        QAction* action = menu->addAction(text, key, m_operate.get(), call);
        action->setEnabled(isPossible);
        return action;
    };
    add(tr("&Run its program"), Qt::Key_F5, hasProgram, [this] { m_operate->setProgramRunning(true); });
    add(tr("&Hold"), Qt::SHIFT | Qt::Key_F5, hasProgram, [this] { m_operate->setProgramRunning(false); });
    add(tr("Re&start"), Qt::CTRL | Qt::Key_F5, hasProgram, [this] { m_operate->restartProgram(); });
    menu->addSeparator();
    addSiteActions(*menu);
    menu->addSeparator();
    add(tr("&Forget the explored contour"), Qt::CTRL | Qt::SHIFT | Qt::Key_N, hasArm, [this] {
        m_operate->armViews().forgetContour();
    })->setToolTip(tr("What is touched from now on is another object"));
}

/// What is possible changes while the menus stay.
void MainWindow::addSiteActions(QMenu& menu) {
    SiteViews* site = &m_operate->siteViews();
    QAction* request = menu.addAction(tr("Re&quest control of the site"), site, &SiteViews::request);
    QMenu* successors = menu.addMenu(tr("Hand o&ver to"));
    successors->setObjectName(QStringLiteral("handOver"));
    QAction* takeOver = menu.addAction(tr("&Take over control of the site"), site, &SiteViews::takeOver);
    takeOver->setToolTip(tr("For supervisors: the other console has 5 s to decline"));
    QAction* release = menu.addAction(tr("Rele&ase control of the site"), Qt::CTRL | Qt::ALT | Qt::Key_C,
                                      site, &SiteViews::release);
    const auto update = [=] {
        request->setEnabled(site->mayRequest());
        takeOver->setEnabled(site->mayTakeOver());
        release->setEnabled(site->controls());
        successors->clear();
        for (const auto& [console, person] : site->successors()) {
            const QString name = person.isEmpty() ? console : tr("%1 (%2)").arg(console, person);
            successors->addAction(base::withoutMnemonic(name), site,
                                  [site, console = console] { site->handOver(console); });
        }
        successors->setEnabled(!successors->isEmpty());
    };
    update();
    connect(site, &SiteViews::possibilitiesChanged, successors, update);
}

void MainWindow::openArm() {
    askForFile(tr("Open arm"), tr("Arms (*.toml)"), &FileOpener::openArm);
}

void MainWindow::openSite() {
    askForFile(tr("Connect to a site"), tr("Sites (*.toml)"), &FileOpener::openSite);
}

void MainWindow::addRecentMenu(QMenu& file) {
    QMenu* menu = file.addMenu(tr("Open &recent"));
    menu->setObjectName(QStringLiteral("recent"));
    menu->setToolTipsVisible(true);
    const auto add = [this, menu](const QString& title, base::Icon icon, const QStringList& paths,
                                  auto open) {
        if (!paths.isEmpty())
            menu->addSection(title);
        const QList<chrome::RecentName> names = chrome::recentNamesOf(paths, m_recentNames->names());
        for (qsizetype i = 0; i < names.size(); ++i) {
            const QString& path = paths[i];
            const QString name = base::withoutMnemonic(names[i].oneLine());
            menu->addAction(base::themeIcon(icon), name, menu, [path, open] { open(path); })
                ->setToolTip(path);
        }
    };
    QStringList recordings = m_settings.recentFiles();
    QStringList scenes;
    for (const QString& path : std::as_const(recordings))
        if (!app::isPlayable(path))
            scenes << path;
    recordings.removeIf([](const QString& path) { return !app::isPlayable(path); });
    const auto openFile = [this](const QString& path) { m_opener->openFile(path); };
    add(tr("Recordings"), base::Icon::recording, recordings, openFile);
    add(tr("Scenes, arms and source lists"), base::Icon::scene, scenes, openFile);
    add(tr("Patterns"), base::Icon::patterns, m_settings.recentPatterns(), [this](const QString& path) {
        showPage(QStringLiteral("patterns"));
        m_patterns->open(path);
    });
    add(tr("Studies"), base::Icon::study, m_settings.recentStudies(), [this](const QString& path) {
        showPage(QStringLiteral("study"));
        m_study->open(path);
    });
    menu->setEnabled(!menu->isEmpty());
    menu->addSeparator();
    menu->addAction(tr("&Clear the list"), this, [this] {
        m_settings.clearRecent();
        showRecent();
    });
    const auto last = last_session::entriesFrom(m_settings.lastSession());
    QAction* reopen = file.addAction(tr("Reopen the &last session"), this, &MainWindow::openLastSession);
    reopen->setEnabled(!last.empty());
    reopen->setToolTip(last_session::text(last, m_recentNames->names()));
}

void MainWindow::showRecent() {
    m_recentNames->ask(m_settings.recentFiles());
    m_operate->chooser().setRecentNames(m_recentNames->names());
    m_operate->startPage().recent().setNames(m_recentNames->names());
    m_operate->chooser().setRecent(m_settings.recentFiles());
    m_operate->startPage().setRecent(m_settings.recentFiles());
    m_patterns->editor().setRecent(m_settings.recentPatterns());
    m_study->setLast(m_settings.recentStudies().value(0));
    buildMenus();
}

void MainWindow::connectStartPage() {
    connect(m_recentNames, &RecentFileNames::changed, this, [this] {
        showRecent();
        offerLastSession();
    });
    StartPage& start = m_operate->startPage();
    connect(&start.recent(), &chrome::RecentList::fileRequested, m_opener, &FileOpener::openFile);
    connect(&start.recent(), &chrome::RecentList::sessionRequested, this, &MainWindow::openLastSession);
    connect(m_operate.get(), &OperatePage::cardRequested, this, &MainWindow::openCard);
    connect(&start.firstSteps(), &chrome::FirstSteps::stepRequested, this, [this](const QString& step) {
        if (step == QLatin1String("touch"))
            openDemo();
        else
            openCard(step == QLatin1String("study") ? QStringLiteral("study:rehearsal")
                                                    : QStringLiteral("pattern:shape.A.dynamic"));
    });
    // Whatever way a step was done.
    auto* keeper = new FirstStepsKeeper(start.firstSteps(), m_settings, this);
    connect(&m_sources, &SourceManager::activeChanged, keeper, [this, keeper] {
        if (m_sources.active() != nullptr)
            keeper->done(QStringLiteral("touch"));
    });
    connect(&m_patterns->editor(), &pattern::PatternEditor::playRequested, keeper,
            [keeper] { keeper->done(QStringLiteral("pattern")); });
    connect(&m_study->controller(), &StudyController::opened, keeper,
            [keeper] { keeper->done(QStringLiteral("study")); });
}

void MainWindow::openCard(const QString& place) {
    const auto behind = [&place](QLatin1String kind) {
        return place.startsWith(kind) ? std::optional(place.mid(kind.size())) : std::nullopt;
    };
    if (const auto id = behind(QLatin1String("pattern:"))) {
        showPage(QStringLiteral("patterns"));
        m_patterns->open(*id);
    } else if (const auto kind = behind(QLatin1String("study:"))) {
        showPage(QStringLiteral("study"));
        if (*kind == QLatin1String("rehearsal"))
            m_study->watchRehearsal();
        else
            m_study->open(QStringLiteral(":/studies/teleta.toml"));
    }
}

void MainWindow::offerLastSession() {
    const auto entries = last_session::entriesFrom(m_settings.lastSession());
    QStringList paths;
    for (const last_session::Entry& entry : entries)
        paths << entry.path;
    m_recentNames->ask(paths);
    m_operate->startPage().recent().setSession(m_settings.atStart() == AtStart::nothing
                                                   ? QString()
                                                   : last_session::text(entries, m_recentNames->names()));
}

void MainWindow::openLastSession() {
    using Kind = last_session::Entry::Kind;
    for (const last_session::Entry& entry : last_session::entriesFrom(m_settings.lastSession())) {
        switch (entry.kind) {
        case Kind::scene:
            m_opener->openScene(entry.path);
            break;
        case Kind::recording:
            m_opener->reopenRecording(entry.path);
            break;
        case Kind::list:
            m_opener->openList(entry.path);
            break;
        case Kind::camera:
            m_sources.open(m_settings.camera());
            break;
        case Kind::arm:
            m_opener->openArm(entry.path);
            break;
        case Kind::site:
            m_opener->openSite(entry.path);
            break;
        case Kind::study:
            m_study->open(entry.path);
            break;
        }
    }
}

/// What is open now.
QStringList MainWindow::session() {
    std::vector<last_session::OpenSource> open;
    for (const SourceManager::Item& item : m_sources.items())
        open.push_back({item.request, m_opener->listOf(item.key)});
    const auto& study = m_study->controller().overview();
    const bool isFolder = study && study->location.server.empty();
    return last_session::entriesOf(open,
                                   isFolder ? QString::fromStdString(study->location.folder) : QString());
}

void MainWindow::editPreferences() {
    const Preferences before{.language = m_settings.language(),
                             .theme = m_settings.theme(),
                             .recordingFolder = m_settings.recordingFolder(),
                             .atStart = m_settings.atStart(),
                             .keepsScreenOn = m_settings.keepsScreenOn(),
                             .exportsUtc = m_settings.exportsUtc()};
    auto* dialog = new PreferencesDialog(before, languageChoices(), RecordingFiles::usualFolder(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, before] {
        const Preferences chosen = dialog->preferences();
        m_settings.setRecordingFolder(chosen.recordingFolder);
        m_settings.setAtStart(chosen.atStart);
        m_settings.setExportsUtc(chosen.exportsUtc);
        m_settings.setKeepsScreenOn(chosen.keepsScreenOn);
        offerLastSession();
        setTheme(chosen.theme);
        if (chosen.language != before.language) {
            m_settings.setLanguage(chosen.language);
            useLanguage(*qApp, chosen.language);
        }
        buildMenus();
    });
    dialog->open();
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    // Before any widget may use the key up, and over dialogs too, where shortcuts are dead. One press passes
    // several widgets: it counts once, until the key is let go.
    if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress ||
        event->type() == QEvent::KeyRelease) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool down = event->type() != QEvent::KeyRelease;
        if (key->key() == Qt::Key_Escape && !key->isAutoRepeat()) {
            onEscape(down);
        } else if (down && key->key() == Qt::Key_Period && key->modifiers() & Qt::ControlModifier) {
            engageStop(chrome::StopCause::keys);
            return true;
        } else if (down && openMenuBy(*static_cast<QKeyEvent*>(event))) {
            return true;
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

void MainWindow::onEscape(bool down) {
    if (down == m_escapeDown)
        return;
    m_escapeDown = down;
    if (!down)
        return;
    if (m_lastEscape.isValid() && m_lastEscape.elapsed() < kDoubleEscape_ms) {
        m_lastEscape.invalidate();
        engageStop(chrome::StopCause::escape);
    } else {
        m_lastEscape.start();
    }
}

} // namespace teleta::console
