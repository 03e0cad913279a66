// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet_station.h"
#include "widgets/chrome/message_bar.h"

#include <QString>
#include <QWidget>

namespace teleta::bracelet {
class BraceletView;
}
namespace teleta::editor {
class PatternEditor;
}

namespace teleta::console {

/// The Patterns page: the editor, which plays on the console's bracelet. Files are read and written on pool
/// threads. Thread: GUI.
class PatternsPage : public QWidget {
    Q_OBJECT

public:
    explicit PatternsPage(BraceletStation& station, QWidget* parent = nullptr);

    [[nodiscard]] editor::PatternEditor& editor() { return *m_editor; }
    [[nodiscard]] chrome::MessageBar& messages() { return *m_messages; }

    /// Opens a built-in pattern or a file.
    void open(const QString& idOrPath);
    void save(const QString& path);
    /// Shows what the bracelet does.
    void tick();

private:
    void askForFile(bool save);
    void report(const QString& what, const core::Error& error);

    BraceletStation& m_station;
    chrome::MessageBar* m_messages;
    editor::PatternEditor* m_editor;
    bracelet::BraceletView* m_picture;
};

} // namespace teleta::console
