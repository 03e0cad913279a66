// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"
#include "app/console/patterns/pattern_collection.h"
#include "app/console/patterns/pattern_playback.h"
#include "app/console/patterns/recovery_keeper.h"
#include "backend/pattern/files/pattern_import.h"
#include "backend/pattern/motors/sampled_output.h"
#include "widgets/chrome/message_bar.h"

#include <QString>
#include <QThreadPool>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QPushButton;

namespace teleta::bracelet {
class BraceletView;
class StrengthPanel;
} // namespace teleta::bracelet
namespace teleta::pattern {
class PatternEditor;
}

namespace teleta::console {

/// The Patterns page: the editor, playing on the console's bracelet, the user's own patterns, files, and
/// recovery of unsaved edits. Files are read and written on pool threads. Thread: GUI.
class PatternsPage : public QWidget {
    Q_OBJECT

public:
    /// recoveryFolder: empty: unsaved edits are not backed up.
    PatternsPage(BraceletService& station, PatternCollection& collection, const QString& recoveryFolder,
                 QWidget* parent = nullptr);

    [[nodiscard]] pattern::PatternEditor& editor() { return *m_editor; }
    [[nodiscard]] chrome::MessageBar& messages() { return *m_messages; }
    [[nodiscard]] RecoveryKeeper& recovery() { return *m_keeper; }

    /// Opens a built-in pattern or a file; asks first when there are unsaved edits.
    void open(const QString& idOrPath);
    void openNew();
    /// Saves to the file of the pattern or, without a file, as one of the user's own.
    void save();
    void saveAs(const QString& path);
    void exportTo(const QString& path, const pattern::SampleOptions& samples = {});
    void compareWith(const QString& idOrPath);
    /// Updates the picture of the bracelet.
    void tick();

    [[nodiscard]] bool hasUnsaved() const;
    /// Calls goOn at once when nothing is unsaved; otherwise asks whether to save or discard first, and does
    /// not call it when the user cancels.
    void whenSettled(std::function<void()> goOn);
    /// Opens recovered edits and offers the next ones.
    void recover();
    void discardRecovered();

signals:
    /// A file was opened or saved.
    void used(const QString& path);
    /// Unsaved edits of a program that ended were found.
    void recoveryOffered(const QString& text);

protected:
    void showEvent(QShowEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void connectEditor();
    void connectCollection();
    void connectStrength();
    /// discarded: revision of the edits that may be discarded once the file has been read.
    void openNow(const QString& idOrPath, std::optional<quint64> discarded = std::nullopt);
    /// discard: called instead of goOn when the user discards the edits.
    void settle(std::function<void()> goOn, std::function<void()> discard);
    void showOpened(const pattern::Pattern& pattern, const QString& idOrPath);
    void takeAdded(const QString& path, quint64 revision);
    void showPattern(pattern::Pattern pattern, const QString& path, bool unsaved = false);
    void write(const QString& path);
    using Import = std::shared_ptr<const pattern::PatternImport>;
    void load(const QString& idOrPath, const pattern::ImportOptions& options,
              std::function<void(const Import&)> use);
    /// Lists the losses first; nothing happens when the user cancels.
    void askToImport(const QString& path, const Import& import, std::function<void(const Import&)> use);
    /// For what is not opened in the editor.
    void informOfLosses(const QString& path, const std::vector<pattern::Loss>& losses);
    void showOwn();
    void showRecovery();
    void settled(bool saved);
    void askForFile(bool save);
    void askForExport();
    void report(const QString& what, const core::Error& error);
    void inform(const QString& what);

    BraceletService& m_station;
    PatternCollection& m_collection;
    RecoveryKeeper* m_keeper;
    chrome::MessageBar* m_messages;
    QWidget* m_recovery;
    QLabel* m_recoveryText;
    QPushButton* m_recover;
    QPushButton* m_discard;
    pattern::PatternEditor* m_editor;
    PatternPlayback* m_playback;
    bracelet::BraceletView* m_picture;
    bracelet::StrengthPanel* m_strength;
    QThreadPool m_writing;               ///< one thread, so that the last save wins
    QMetaObject::Connection m_adding;    ///< to the end of saving an own pattern
    std::function<void()> m_afterSaving; ///< called when the running save has finished
    bool m_saveAgain = false;            ///< save again once the added pattern has its file
    std::uint64_t m_shown = 0;           ///< number of patterns shown so far
    std::uint64_t m_asked = 0;           ///< number of the latest request
};

} // namespace teleta::console
