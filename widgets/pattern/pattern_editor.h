// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/pattern/document/pattern_document.h"

#include <QStringList>
#include <QWidget>

class QAction;
class QDoubleSpinBox;
class QLabel;
class QMenu;
class QPushButton;
class QSplitter;
class QToolBar;

namespace teleta::editor {

class LawList;
class PatternInspector;
class PatternLibrary;
class StrokePad;
class TimelineView;

/// The editor of patterns: library, timeline, unrolled forearm, laws and numbers, with a tool bar. It plays
/// nothing and does no file I/O: it asks for both. Thread: GUI.
class PatternEditor : public QWidget {
    Q_OBJECT
public:
    explicit PatternEditor(QWidget* parent = nullptr);

    [[nodiscard]] PatternDocument* document() const { return m_document; }
    [[nodiscard]] TimelineView* timeline() const { return m_timeline; }
    [[nodiscard]] PatternLibrary* library() const { return m_library; }
    [[nodiscard]] LawList* laws() const { return m_laws; }
    [[nodiscard]] StrokePad* strokePad() const { return m_stroke; }
    [[nodiscard]] PatternInspector* inspector() const { return m_inspector; }
    /// Beside the forearm there is room for a picture of the bracelet; takes ownership.
    void setBraceletPicture(QWidget* picture);

    /// Where the pattern plays. Emits nothing.
    void setPlayhead(double time_s);
    void setPlaying(bool playing);
    [[nodiscard]] bool isPlaying() const { return m_playing; }
    /// Whether play is to begin again at the end; the range is timeline()->loop() or, without it, all.
    [[nodiscard]] bool looping() const;
    /// Files for the menu, the newest first.
    void setRecent(const QStringList& paths);
    /// Shows another pattern behind this one, and how far they are apart; null: no more.
    void compareWith(std::shared_ptr<const pattern::Pattern> other);
    /// The difference as it is told above the timeline; empty while nothing is compared.
    [[nodiscard]] QString comparisonText() const;

signals:
    void playRequested(const teleta::pattern::Pattern& pattern);
    void stopRequested();
    void playheadMoved(double t_s);
    /// Whether it is to loop, or the range of the loop.
    void loopingChanged();
    void newRequested();
    /// A built-in id or a path from the library; empty: the user is to be asked for a file.
    void openRequested(const QString& idOrPath);
    /// Where it comes from; a pattern without a file of its own gets one.
    void saveRequested();
    /// The user is to be asked for a name.
    void saveAsRequested();
    void exportRequested();
    void duplicateRequested(const QString& idOrPath);
    void compareRequested(const QString& idOrPath);

protected:
    void changeEvent(QEvent* event) override;

private:
    void makeActions();
    void makeFileMenu();
    void makeBar();
    void makeComparison();
    void retranslate();
    void fillAddMenu();
    void fillFileMenu();
    void updateTitle();
    void updateComparison();
    void togglePlay();
    void addObject(const pattern::ObjectForm& form);
    void showFinding(int index);

    PatternDocument* m_document;
    PatternLibrary* m_library;
    TimelineView* m_timeline;
    StrokePad* m_stroke;
    LawList* m_laws;
    PatternInspector* m_inspector;
    QToolBar* m_bar;
    QLabel* m_title;
    QSplitter* m_below;
    QWidget* m_comparison;
    QLabel* m_comparisonText;
    QPushButton* m_endComparison;
    QDoubleSpinBox* m_snapStep;
    QMenu *m_fileMenu, *m_recentMenu, *m_addMenu;
    QStringList m_recent;
    QAction *m_file, *m_new, *m_open, *m_save, *m_saveAs, *m_exportTo, *m_play, *m_stop, *m_loop, *m_undo,
        *m_redo, *m_pen, *m_snap, *m_rotateBack, *m_rotate, *m_mirror, *m_swap, *m_fit, *m_add;
    bool m_playing = false;
};

} // namespace teleta::editor
