// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/compose.h"
#include "widgets/pattern/document/pattern_document.h"
#include "widgets/pattern/law_list.h"
#include "widgets/pattern/pattern_inspector.h"
#include "widgets/pattern/pattern_library.h"
#include "widgets/pattern/stroke_pad.h"
#include "widgets/pattern/timeline/timeline_view.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QStringList>
#include <QToolBar>
#include <QWidget>

class QAction;

namespace teleta::pattern {

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
    /// STOP is engaged: nothing can be played until it is released.
    void setStopped(bool stopped);
    [[nodiscard]] bool isPlaying() const { return m_playing; }
    /// Whether playing repeats; the range is timeline()->loop(), or the whole pattern without it.
    [[nodiscard]] bool looping() const;
    /// Recent files for the menu, newest first.
    void setRecent(const QStringList& paths);
    /// Shows another pattern behind this one and their difference; null: ends the comparison.
    void compareWith(std::shared_ptr<const Pattern> other);

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

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeActions();
    void shareHeight();
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

    PatternDocument* m_document = new PatternDocument(this);
    PatternLibrary* m_library = new PatternLibrary(this);
    TimelineView* m_timeline = new TimelineView(m_document, this);
    StrokePad* m_stroke = new StrokePad(m_document, this);
    LawList* m_laws = new LawList(m_document, this);
    PatternInspector* m_inspector = new PatternInspector(m_document, this);
    QToolBar* m_bar = new QToolBar(this);
    QLabel* m_title = new QLabel(this);
    QSplitter* m_all = new QSplitter(Qt::Horizontal, this); ///< library, and the rest
    QSplitter* m_below = new QSplitter(Qt::Horizontal, this);
    QSplitter* m_numbers = new QSplitter(Qt::Horizontal, this); ///< laws and properties
    QWidget* m_comparison = new QWidget(this);
    QLabel* m_comparisonText = base::named<QLabel>("comparison", m_comparison);
    QPushButton* m_endComparison = new QPushButton(m_comparison);
    QDoubleSpinBox* m_snapStep = new QDoubleSpinBox(this);
    QMenu* m_fileMenu = new QMenu(this);
    QMenu* m_recentMenu = new QMenu(this);
    QMenu* m_addMenu = new QMenu(this);
    QStringList m_recent;
    QAction* m_file;
    QAction* m_new;
    QAction* m_open;
    QAction* m_save;
    QAction* m_saveAs;
    QAction* m_exportTo;
    QAction* m_play;
    QAction* m_stop;
    QAction* m_loop;
    QAction* m_undo;
    QAction* m_redo;
    QAction* m_pen;
    QAction* m_snap;
    QAction* m_rotateBack;
    QAction* m_rotate;
    QAction* m_mirror;
    QAction* m_swap;
    QAction* m_fit;
    QAction* m_add;
    bool m_playing = false;
    bool m_stopped = false;
};

} // namespace teleta::pattern
