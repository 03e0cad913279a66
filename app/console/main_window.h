// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/console_settings.h"
#include "app/console/base/gui_clock.h"
#include "app/console/bracelet/bracelet_service.h"
#include "app/console/closing_questions.h"
#include "app/console/console_options.h"
#include "app/console/desktop/screen_keeper.h"
#include "app/console/operate/recording/recording_service.h"
#include "app/console/session_recorder.h"
#include "app/console/sources/source_manager.h"
#include "backend/core/threads/stop_switch.h"
#include "widgets/base/icons.h"

#include <QElapsedTimer>
#include <QMainWindow>

#include <cstdint>
#include <memory>
#include <vector>

namespace teleta::chrome {
class DeviceStrip;
class PageRail;
class StopBanner;
class StopButton;
class StopReach;
enum class StopCause;
} // namespace teleta::chrome

namespace teleta::console {

class BraceletMenu;
class CalibratePage;
class CostPage;
class FileOpener;
class HandStation;
class HelpMenu;
class LayoutsMenu;
class LiveViewService;
class OperatePage;
class PageStack;
class PatternCollection;
class PatternsPage;
class PlotPage;
class RecordingControls;
class RecentFileNames;
class RecordingFiles;
class StudyPage;

/// The console's window: rail of pages, status bar with the devices, STOP, menus. Composition only: what a
/// page shows is the page's business, what is open is the SourceManager's. Thread: GUI.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    MainWindow(const ConsoleOptions& options, ConsoleSettings& settings, core::StopSwitch& stop);
    ~MainWindow() override;

    /// Opens what the command line asks for, and, if it names nothing and that is preferred, what was open
    /// the last time.
    void openRequested(const ConsoleOptions& options);
    void openDemo();
    void openArm();
    void openSite();

    [[nodiscard]] GuiClock& clock() { return m_clock; }
    [[nodiscard]] BraceletService& bracelet() { return m_bracelet; }
    [[nodiscard]] SourceManager& sources() { return m_sources; }
    [[nodiscard]] RecordingService& recorder() { return m_recorder; }
    [[nodiscard]] PatternsPage& patternsPage() { return *m_patterns; }
    [[nodiscard]] StudyPage& studyPage() { return *m_study; }
    [[nodiscard]] CalibratePage& calibratePage() { return *m_calibrate; }
    [[nodiscard]] PlotPage& plotPage() { return *m_plot; }
    [[nodiscard]] OperatePage& operatePage() { return *m_operate; }
    [[nodiscard]] RecordingControls& recording() { return *m_recording; }
    /// Closes the window without questions, and ends the program. Edits that are not saved are offered again
    /// by the next start.
    void leave();
    /// Waits until the motors are off, the recording is complete and all answers are kept; touches no widget.
    /// STOP must be engaged.
    void secure();
    [[nodiscard]] LiveViewService& liveView() { return *m_live; }
    /// Whether a source failed to open since the start; decides the exit code of --screenshot.
    [[nodiscard]] bool anyFailure() const { return m_anyFailure; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Page {
        QString name; ///< as in pageNames()
        base::Icon icon;
        QString title;
        QString about;
        QWidget* content;
        QWidget* first = nullptr; ///< takes the keys when the page is chosen; null: the page
    };
    [[nodiscard]] std::vector<Page> pages() const;
    void retranslate();
    void buildMenus();
    /// Of a letter with Alt. The menus come before a field of the page with the same letter, which would only
    /// take the focus. Returns whether it is the letter of a menu.
    [[nodiscard]] bool openMenuBy(QKeyEvent& key);
    void buildArmMenu();
    void addSiteActions(QMenu& menu);
    void restoreFeedback();
    void saveFeedback();
    void takeOwnPatterns();
    void onTick();
    void onFailed(const QString& name, const core::Error& error);
    void onEscape(bool down);
    void engageStop(chrome::StopCause cause);
    /// Shows whether STOP is engaged, and logs each change.
    void showStop();
    void setTheme(const QString& theme);
    void addRecent(const QString& path);
    void askForFile(const QString& title, const QString& filter, void (FileOpener::*open)(const QString&),
                    const QString& folder = {});
    void openCamera();
    /// Asks first when something of the source would be lost.
    void closeSource(std::uint64_t key);
    void openLastSession();
    void offerLastSession();
    void connectStartPage();
    /// A card of the start page that is no scene, see startCards().
    void openCard(const QString& place);
    [[nodiscard]] QStringList session();
    void addRecentMenu(QMenu& file);
    void showRecent();
    void onImported(const QString& file, const QString& recording, const QString& missing);
    void editPreferences();
    /// Lets the desktop keep the screen on while something runs.
    void keepScreen();
    void beginRecording();
    void saveState();
    void showPage(const QString& name);
    void focusPage();
    void keepOnScreen();

    ConsoleSettings& m_settings;
    core::StopSwitch& m_stop;
    // What the pages share comes before them, so that it outlives them.
    BraceletService m_bracelet;
    SourceManager m_sources;
    RecordingService m_recorder;
    SessionRecorder m_sessionRecorder{m_recorder};
    GuiClock m_clock;
    ScreenKeeper m_screen;
    PatternCollection* m_collection;
    RecordingFiles* m_recordings;
    chrome::PageRail* m_rail;
    PageStack* m_pages;
    std::unique_ptr<OperatePage> m_operate;
    std::unique_ptr<PatternsPage> m_patterns;
    std::unique_ptr<StudyPage> m_study;
    std::unique_ptr<CalibratePage> m_calibrate;
    std::unique_ptr<CostPage> m_cost;
    std::unique_ptr<PlotPage> m_plot;
    RecentFileNames* m_recentNames;
    LayoutsMenu* m_layouts;
    BraceletMenu* m_braceletMenu;
    std::unique_ptr<RecordingControls> m_recording;
    std::unique_ptr<LiveViewService> m_live;
    HelpMenu* m_help;
    FileOpener* m_opener;
    std::unique_ptr<HandStation> m_hand;
    chrome::DeviceStrip* m_devices;
    chrome::StopButton* m_stopButton;
    std::unique_ptr<chrome::StopReach> m_stopReach;
    chrome::StopBanner* m_stopBanner;
    chrome::StopCause m_stopCause;
    std::int64_t m_stoppedSince_ns = 0; ///< as shown; 0: not stopped
    ClosingQuestions m_questions;
    QString m_record; ///< file to record into as soon as all that was asked for is open; empty: none
    QElapsedTimer m_lastEscape;
    bool m_escapeDown = false;
    bool m_anyFailure = false;
};

} // namespace teleta::console
