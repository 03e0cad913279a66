// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_station.h"
#include "app/console/patterns/pattern_collection.h"
#include "app/console/patterns/pattern_playback.h"
#include "app/console/patterns/recovery_keeper.h"
#include "backend/pattern/motors/sampled_output.h"
#include "widgets/chrome/message_bar.h"

#include <QString>
#include <QThreadPool>
#include <QWidget>

#include <functional>
#include <optional>

class QFileDialog;
class QLabel;
class QPushButton;

namespace teleta::bracelet {
class BraceletView;
class StrengthPanel;
} // namespace teleta::bracelet
namespace teleta::editor {
class PatternEditor;
}

namespace teleta::console {

/// The Patterns page: the editor, which plays on the console's bracelet, with the user's own patterns, files
/// and what was not saved. Files are read and written on pool threads. Thread: GUI.
class PatternsPage : public QWidget {
    Q_OBJECT

public:
    /// recoveryFolder: empty: edits are not kept aside.
    PatternsPage(BraceletStation& station, PatternCollection& collection, const QString& recoveryFolder,
                 QWidget* parent = nullptr);

    [[nodiscard]] editor::PatternEditor& editor() { return *m_editor; }
    [[nodiscard]] chrome::MessageBar& messages() { return *m_messages; }
    [[nodiscard]] RecoveryKeeper& recovery() { return *m_keeper; }

    /// Opens a built-in pattern or a file; asks first when there are edits that are not saved.
    void open(const QString& idOrPath);
    void openNew();
    /// To its file; without one, as one of the user's own.
    void save();
    void saveAs(const QString& path);
    void exportTo(const QString& path, const pattern::SampleOptions& samples = {});
    void compareWith(const QString& idOrPath);
    /// Shows what the bracelet does.
    void tick();

    [[nodiscard]] bool hasUnsaved() const;
    /// Goes on at once when nothing is unsaved; else asks whether to save, and not at all when the user does
    /// not want to. The edits may be dropped then.
    void whenSettled(std::function<void()> goOn);
    /// Opens the edits that were found; offers the next ones.
    void recover();
    void discardRecovered();

signals:
    /// A file was opened or saved.
    void used(const QString& path);
    /// Edits were found that a program has left without saving.
    void recoveryOffered(const QString& text);

protected:
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void connectEditor();
    void connectCollection();
    void connectStrength();
    /// discarded: revision of the edits that may be lost when it has been read.
    void openNow(const QString& idOrPath, std::optional<quint64> discarded = std::nullopt);
    /// discard: what is done when the edits may be dropped, in place of dropping them and going on.
    void settle(std::function<void()> goOn, std::function<void()> discard);
    void showOpened(const pattern::Pattern& pattern, const QString& idOrPath);
    void takeAdded(const QString& path, quint64 revision);
    void showPattern(pattern::Pattern pattern, const QString& path, bool unsaved = false);
    void write(const QString& path);
    void load(const QString& idOrPath, std::function<void(std::shared_ptr<const pattern::Pattern>)> use);
    void showOwn();
    void showRecovery();
    void settled(bool saved);
    [[nodiscard]] QFileDialog* fileDialog(const QString& title, bool save);
    void askForFile(bool save);
    void askForExport();
    void report(const QString& what, const core::Error& error);
    void inform(const QString& what);

    BraceletStation& m_station;
    PatternCollection& m_collection;
    RecoveryKeeper* m_keeper;
    chrome::MessageBar* m_messages;
    QWidget* m_recovery;
    QLabel* m_recoveryText;
    QPushButton* m_recover;
    QPushButton* m_discard;
    editor::PatternEditor* m_editor;
    PatternPlayback* m_playback;
    bracelet::BraceletView* m_picture;
    bracelet::StrengthPanel* m_strength;
    QThreadPool m_writing;               ///< of one thread: the last save is the one that stays
    QMetaObject::Connection m_adding;    ///< to the end of a save as one of the user's own
    std::function<void()> m_afterSaving; ///< goes on when what is being saved is saved
    bool m_saveAgain = false;            ///< when the pattern that is being added has its file
    std::uint64_t m_shown = 0;           ///< counts the patterns that were shown
    std::uint64_t m_asked = 0;           ///< number of the newest one that was asked for
};

} // namespace teleta::console
