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

namespace teleta::pattern {

class LawList;
class PatternInspector;
class PatternLibrary;
class StrokePad;
class TimelineView;

/// The pattern editor: library, timeline, unrolled forearm, laws and inspector, with a tool bar. It neither
/// plays nor does file I/O, but emits requests. Thread: GUI.
class PatternEditor : public QWidget {
    Q_OBJECT
public:
    explicit PatternEditor(QWidget* parent = nullptr);

    [[nodiscard]] PatternDocument* document() const { return m_document; }
    [[nodiscard]] TimelineView* timeline() const { return m_timeline; }
    [[nodiscard]] PatternLibrary* library() const { return m_library; }
    /// Shows a picture of the bracelet next to the forearm; takes ownership.
    void setBraceletPicture(QWidget* picture);

    /// Moves the playhead. Emits nothing.
    void setPlayhead(double time_s);
    void setPlaying(bool playing);
    [[nodiscard]] bool isPlaying() const { return m_playing; }
    /// Whether playing repeats; the range is timeline()->loop(), or the whole pattern without it.
    [[nodiscard]] bool looping() const;
    /// Recent files for the menu, newest first.
    void setRecent(const QStringList& paths);
    /// Shows another pattern behind this one and their difference; null: ends the comparison.
    void compareWith(std::shared_ptr<const Pattern> other);
    /// The difference as shown above the timeline; empty without a comparison.
    [[nodiscard]] QString comparisonText() const;

signals:
    void playRequested(const teleta::pattern::Pattern& pattern);
    void stopRequested();
    void playheadMoved(double t_s);
    /// Looping was switched or its range changed.
    void loopingChanged();
    void newRequested();
    /// idOrPath: a built-in id or a path from the library; empty: ask the user for a file.
    void openRequested(const QString& idOrPath);
    /// Save to the file of the pattern; a pattern without a file gets one.
    void saveRequested();
    /// Ask the user for a file name and save.
    void saveAsRequested();
    void exportRequested();
    void duplicateRequested(const QString& idOrPath);
    void compareRequested(const QString& idOrPath);

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
    void addObject(const ObjectForm& form);
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

} // namespace teleta::pattern
