// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/pattern_editor.h"

#include "widgets/base/icons.h"
#include "widgets/base/on_change.h"
#include "widgets/base/redo_keys.h"
#include "widgets/base/theme.h"
#include "widgets/pattern/document/pattern_names.h"
#include "widgets/pattern/document/pattern_reference.h"
#include "widgets/pattern/timeline/timeline_painter.h"

#include <QAction>
#include <QApplication>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>
#include <memory>
#include <utility>

namespace teleta::pattern {

namespace {

constexpr double kLeastSnap_ms = 1.0;
constexpr double kMostSnap_ms = 1000.0;
constexpr double kMsPerS = 1e3;
/// Width of the editor in which laws and properties stand beside each other.
constexpr double kRoomForBoth_em = 80.0;
constexpr double kLibrary_em = 22.0;       ///< width of the library at first
constexpr double kNarrowLibrary_em = 15.0; ///< in a narrower editor

} // namespace

PatternEditor::PatternEditor(QWidget* parent)
    : QWidget(parent) {
    makeActions();
    connect(m_fileMenu, &QMenu::aboutToShow, this, &PatternEditor::fillFileMenu);
    m_recentMenu->setToolTipsVisible(true);
    fillFileMenu();
    makeBar();
    makeComparison();
    m_numbers->addWidget(m_laws);
    m_numbers->addWidget(m_inspector);
    m_numbers->setStretchFactor(1, 1);
    m_below->addWidget(m_stroke);
    m_below->addWidget(m_numbers);
    m_below->setStretchFactor(0, 2);
    m_below->setStretchFactor(1, 3);
    auto* above = new QWidget(this);
    auto* aboveLayout = new QVBoxLayout(above);
    aboveLayout->setContentsMargins(0, 0, 0, 0);
    aboveLayout->setSpacing(0);
    aboveLayout->addWidget(m_comparison);
    aboveLayout->addWidget(m_timeline, 1);
    auto* right = new QSplitter(Qt::Vertical, this);
    right->addWidget(above);
    right->addWidget(m_below);
    right->setStretchFactor(0, 3);
    right->setStretchFactor(1, 1);
    right->setSizes({base::em(this, 28), base::em(this, 15)});
    m_all->addWidget(m_library);
    m_all->addWidget(right);
    m_all->setStretchFactor(1, 1);
    m_all->setSizes({base::em(this, kLibrary_em), base::em(this, 57)});
    for (QSplitter* splitter : {m_numbers, m_below, right, m_all})
        splitter->setChildrenCollapsible(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(base::grid(this, 0.5));
    layout->addWidget(m_bar);
    layout->addWidget(m_all, 1);

    connect(m_library, &PatternLibrary::openRequested, this, &PatternEditor::openRequested);
    connect(m_library, &PatternLibrary::duplicateRequested, this, &PatternEditor::duplicateRequested);
    connect(m_library, &PatternLibrary::compareRequested, this, &PatternEditor::compareRequested);
    connect(m_timeline, &TimelineView::playheadMoved, this, [this](double time_s) {
        m_stroke->setStart(time_s);
        emit playheadMoved(time_s);
    });
    connect(m_stroke, &StrokePad::drawn, m_timeline, [this](double begin_s, double end_s) {
        m_timeline->reveal({begin_s, end_s});
    });
    connect(m_timeline, &TimelineView::playToggled, this, &PatternEditor::togglePlay);
    connect(m_timeline, &TimelineView::objectActivated, this, [this](std::size_t object) {
        m_document->select({{}, object});
        m_inspector->setFocus();
    });
    connect(m_timeline, &TimelineView::penChanged, m_pen, &QAction::setChecked);
    connect(m_timeline, &TimelineView::loopChanged, this, [this] {
        m_inspector->setLoop(m_timeline->loop());
        if (m_timeline->loop())
            m_loop->setChecked(true);
        emit loopingChanged();
    });
    connect(m_loop, &QAction::toggled, this, &PatternEditor::loopingChanged);
    connect(m_inspector, &PatternInspector::loopEdited, this, [this](double begin_s, double end_s) {
        m_timeline->setLoop(begin_s < end_s ? std::optional(Span{begin_s, end_s}) : std::nullopt);
    });
    connect(m_laws, &LawList::heightChanged, this, &PatternEditor::shareHeight);
    connect(m_laws, &LawList::shown, this, &PatternEditor::showFinding);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (now != nullptr && isAncestorOf(now))
            now->installEventFilter(this);
    });
    connect(m_document, &PatternDocument::patternChanged, this, &PatternEditor::updateTitle);
    connect(m_document, &PatternDocument::dirtyChanged, this, &PatternEditor::updateTitle);
    connect(m_document, &PatternDocument::pathChanged, this, &PatternEditor::updateTitle);
    connect(m_document, &PatternDocument::snappingChanged, this, [this] {
        m_snap->setChecked(m_document->snapping());
        m_snapStep->setEnabled(m_document->snapping());
    });
    connect(m_document, &PatternDocument::patternOpened, this, [this] { m_stroke->setStart(0.0); });
    base::keepTranslated(this, &PatternEditor::retranslate);
}

/// In a text field of X11, Ctrl+E would go to the end of the line instead of exporting.
bool PatternEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->keyCombination() == m_exportTo->shortcut()[0]) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void PatternEditor::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    // Beside each other they would be too narrow for the fields.
    const auto wanted = width() < base::em(this, kRoomForBoth_em) ? Qt::Vertical : Qt::Horizontal;
    if (wanted == m_numbers->orientation())
        return;
    m_numbers->setOrientation(wanted);
    shareHeight();
    const int library = base::em(this, wanted == Qt::Vertical ? kNarrowLibrary_em : kLibrary_em);
    m_all->setSizes({library, width() - library});
    if (wanted == Qt::Horizontal)
        m_numbers->setSizes({1, 2});
}

/// The properties below the laws have what an empty list does not need. Beside each other a splitter would
/// make both as low as the lower one may be.
void PatternEditor::shareHeight() {
    const bool isBelow = m_numbers->orientation() == Qt::Vertical;
    m_laws->setMaximumHeight(isBelow ? m_laws->mostHeight() : QWIDGETSIZE_MAX);
    if (isBelow)
        m_numbers->setSizes({0, height()});
}

void PatternEditor::makeActions() {
    const auto action = [this](const QIcon& icon, const QKeySequence& keys, auto act) {
        auto* made = new QAction(icon, QString(), this);
        made->setShortcut(keys);
        made->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        addAction(made);
        connect(made, &QAction::triggered, this, act);
        return made;
    };
    m_new = action({}, QKeySequence::New, [this] { emit newRequested(); });
    m_open = action({}, QKeySequence::Open, [this] { emit openRequested({}); });
    m_save = action({}, QKeySequence::Save, [this] { emit saveRequested(); });
    m_saveAs = action({}, Qt::CTRL | Qt::SHIFT | Qt::Key_S, [this] { emit saveAsRequested(); });
    m_exportTo = action({}, Qt::CTRL | Qt::Key_E, [this] { emit exportRequested(); });
    m_play = action(base::themeIcon(base::Icon::play), {}, [this] { togglePlay(); });
    m_play->setObjectName(QStringLiteral("playPattern"));
    m_stop = action({}, {}, [this] { emit stopRequested(); });
    m_loop = action(base::themeIcon(base::Icon::loop), {}, [] {});
    m_loop->setObjectName(QStringLiteral("loop"));
    m_loop->setCheckable(true);
    QUndoStack* stack = m_document->undoStack();
    m_undo = action({}, QKeySequence::Undo, [stack] { stack->undo(); });
    m_redo = action({}, {}, [stack] { stack->redo(); });
    m_redo->setShortcuts(base::redoKeys());
    connect(stack, &QUndoStack::canUndoChanged, m_undo, &QAction::setEnabled);
    connect(stack, &QUndoStack::canRedoChanged, m_redo, &QAction::setEnabled);
    m_undo->setEnabled(false);
    m_redo->setEnabled(false);
    m_pen = action({}, {}, [this](bool on) { m_timeline->setPen(on); });
    m_pen->setCheckable(true);
    m_snap = action({}, {}, [this](bool on) { m_document->setSnapping(on); });
    m_snap->setCheckable(true);
    m_snap->setChecked(true);
    m_rotateBack =
        action({}, QKeySequence(Qt::CTRL | Qt::Key_BracketLeft), [this] { m_document->rotate(-1); });
    m_rotate = action({}, QKeySequence(Qt::CTRL | Qt::Key_BracketRight), [this] { m_document->rotate(1); });
    m_mirror = action({}, QKeySequence(Qt::CTRL | Qt::Key_M), [this] { m_document->mirror(); });
    m_swap = action({}, QKeySequence(Qt::CTRL | Qt::Key_L), [this] { m_document->swapArms(); });
    m_fit = action({}, {}, [this] { m_timeline->zoomToFit(); });
    m_file = new QAction(this);
    m_file->setMenu(m_fileMenu);
    m_add = new QAction(this);
    m_add->setMenu(m_addMenu);
    m_snapStep->setRange(kLeastSnap_ms, kMostSnap_ms);
    m_snapStep->setDecimals(0);
    m_snapStep->setSuffix(QStringLiteral(" ms"));
    m_snapStep->setValue(kMsPerS * m_document->snapStep_s());
    m_snapStep->setKeyboardTracking(false);
    connect(m_snapStep, &QDoubleSpinBox::valueChanged, m_document,
            [this](double step_ms) { m_document->setSnapStep(step_ms / kMsPerS); });
}

void PatternEditor::fillFileMenu() {
    m_fileMenu->clear();
    m_fileMenu->addActions({m_new, m_open});
    m_fileMenu->addMenu(m_recentMenu);
    m_recentMenu->clear();
    for (const QString& path : m_recent)
        m_recentMenu->addAction(QFileInfo(path).fileName(), this, [this, path] { emit openRequested(path); })
            ->setToolTip(path);
    m_recentMenu->setEnabled(!m_recent.isEmpty());
    m_fileMenu->addSeparator();
    m_fileMenu->addActions({m_save, m_saveAs, m_exportTo});
}

void PatternEditor::makeBar() {
    m_bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    for (const QList<QAction*>& group :
         {QList{m_file, m_save}, QList{m_play, m_stop, m_loop}, QList{m_undo, m_redo}}) {
        m_bar->addActions(group);
        m_bar->addSeparator();
    }
    m_bar->addActions({m_pen, m_snap});
    m_bar->addWidget(m_snapStep);
    m_bar->addAction(m_add);
    for (QAction* action : {m_file, m_add})
        qobject_cast<QToolButton*>(m_bar->widgetForAction(action))->setPopupMode(QToolButton::InstantPopup);
    m_bar->addSeparator();
    m_bar->addActions({m_rotateBack, m_rotate, m_mirror, m_swap, m_fit});
    auto* room = new QWidget(m_bar);
    room->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_bar->addWidget(room);
    m_bar->addWidget(m_title);
}

void PatternEditor::makeComparison() {
    m_endComparison->setAutoDefault(false);
    m_comparisonText->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* layout = new QHBoxLayout(m_comparison);
    layout->setContentsMargins(base::grid(this), 0, base::grid(this), base::grid(this, 0.5));
    layout->addWidget(m_comparisonText, 1);
    layout->addWidget(m_endComparison);
    m_comparison->hide();
    connect(m_endComparison, &QPushButton::clicked, this, [this] { compareWith(nullptr); });
    connect(m_timeline->reference(), &PatternReference::changed, this, &PatternEditor::updateComparison);
}

void PatternEditor::compareWith(std::shared_ptr<const Pattern> other) {
    m_timeline->reference()->setPattern(std::move(other));
}

void PatternEditor::updateComparison() {
    const PatternReference& reference = *m_timeline->reference();
    m_comparison->setVisible(reference.pattern() != nullptr);
    if (!reference.pattern())
        return;
    const QString name = displayName(*reference.pattern());
    if (!reference.comparison()) {
        m_comparisonText->setText(tr("Compared with %1\u2026").arg(name));
        return;
    }
    const Comparison& apart = *reference.comparison();
    const TactorDifference& largest = apart.tactors[static_cast<std::size_t>(apart.largestTactor)];
    const QLocale locale;
    const auto percent = [&locale](double share) { return locale.toString(100.0 * share, 'f', 1); };
    m_comparisonText->setText(
        largest.largest > 0.0 ? tr("Compared with %1: largest difference %2 % (motor %3 at %4 s), rms %5 %")
                                    .arg(name, percent(largest.largest))
                                    .arg(apart.largestTactor + 1)
                                    .arg(locale.toString(largest.largestAt_s, 'f', 3), percent(apart.rms))
                              : tr("Compared with %1: no difference").arg(name));
}

void PatternEditor::setRecent(const QStringList& paths) {
    m_recent = paths;
}

void PatternEditor::showFinding(int index) {
    if (index < 0 || index >= static_cast<int>(m_laws->findings().size()))
        return;
    const Finding& finding = m_laws->findings()[static_cast<std::size_t>(index)];
    if (finding.object)
        m_document->select({{}, *finding.object});
    m_timeline->reveal(finding.span);
}

void PatternEditor::retranslate() {
    setAccessibleName(tr("Pattern editor"));
    const auto name = [](QAction* action, const QString& text, const QString& help) {
        action->setText(text);
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        action->setToolTip(keys.isEmpty() ? help : help + QStringLiteral(" (") + keys + QLatin1Char(')'));
    };
    m_recentMenu->setTitle(tr("&Recent"));
    name(m_file, tr("File"), tr("New, open, recent, save, export"));
    name(m_new, tr("New"), tr("An empty pattern"));
    name(m_open, tr("Open\u2026"), tr("Open a pattern file"));
    name(m_save, tr("Save"), tr("Save the pattern; a new one is added to your own patterns"));
    name(m_saveAs, tr("Save as\u2026"), tr("Save the pattern under another name"));
    name(m_exportTo, tr("Export\u2026"), tr("Write HJIF, .haptic, AHAP, .tact, CSV or WAV"));
    name(m_play, m_playing ? tr("Pause") : tr("Play"),
         m_stopped ? tr("STOP is engaged: release it to play")
                   : tr("Play from the playhead, or pause (Space)"));
    name(m_stop, tr("Stop"), tr("Stop playing"));
    name(m_loop, tr("Loop"), tr("Repeat from the beginning; Shift and dragging on the ruler set the range"));
    name(m_undo, tr("Undo"), tr("Undo the last edit"));
    name(m_redo, tr("Redo"), tr("Redo what was undone"));
    name(m_pen, tr("Pen"), tr("Every click adds a breakpoint (P)"));
    name(m_snap, tr("Snap"), tr("Snap times to a grid; hold Alt while dragging to ignore it"));
    m_snapStep->setToolTip(tr("Step of the grid, and of the arrow keys"));
    m_snapStep->setAccessibleName(tr("Step of the grid"));
    name(m_add, tr("Add"), tr("Add an object at the playhead"));
    name(m_rotateBack, tr("\u21ba 60\u00b0"),
         tr("Rotate around the ring: every motor does what the next one did"));
    name(m_rotate, tr("\u21bb 60\u00b0"),
         tr("Rotate around the ring: every motor does what the one before did"));
    name(m_mirror, tr("Mirror"), tr("Reverse the order of the motors"));
    name(m_swap, tr("Other arm"), tr("The pattern for the other arm"));
    name(m_fit, tr("Fit"), tr("Show the whole pattern (Ctrl+0 on the timeline)"));
    m_endComparison->setText(tr("Stop comparing"));
    fillAddMenu();
    updateTitle();
    updateComparison();
}

void PatternEditor::fillAddMenu() {
    for (QAction* action : m_addMenu->actions())
        delete action;
    const std::array<ObjectForm, 5> forms{Sweep{.onset_s = {}, .tactors = {0, 1, 2, 3, 4, 5}}, Ring{},
                                          Phantom{}, Ramp{.tactors = {0}}, PulseTrain{.tactors = {0}}};
    int key = Qt::Key_1;
    for (const ObjectForm& form : forms) {
        QAction* action = m_addMenu->addAction(formName(form), this, [this, form] { addObject(form); });
        action->setShortcut(QKeyCombination(Qt::CTRL | Qt::ALT, static_cast<Qt::Key>(key++)));
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        addAction(action);
    }
}

void PatternEditor::addObject(const ObjectForm& form) {
    ObjectForm placed = form;
    std::visit([this](auto& object) { object.start_s = m_timeline->playhead_s(); }, placed);
    m_document->addObject({{}, std::move(placed), {}});
}

void PatternEditor::updateTitle() {
    const QString name = displayName(m_document->pattern());
    QString text = name.isEmpty() ? tr("Untitled") : name;
    text +=
        QStringLiteral(" · ") + (m_document->pattern().arm == Arm::left ? tr("left arm") : tr("right arm"));
    if (m_document->isBuiltIn())
        text += QStringLiteral(" · ") + tr("built-in, edits create a copy");
    else if (m_document->isDirty())
        text += QStringLiteral(" · ") + tr("not saved");
    m_title->setText(text);
    m_title->setToolTip(m_document->path());
    m_save->setEnabled(m_document->isDirty() || (m_document->path().isEmpty() && !m_document->isBuiltIn()));
    m_library->setCurrent(m_document->path().isEmpty() ? QString::fromStdString(m_document->pattern().id)
                                                       : m_document->path());
}

void PatternEditor::setBraceletPicture(QWidget* picture) {
    m_below->insertWidget(0, picture);
}

void PatternEditor::setPlayhead(double time_s) {
    m_timeline->setPlayhead(time_s);
    m_stroke->setStart(m_timeline->playhead_s());
}

void PatternEditor::setPlaying(bool playing) {
    if (std::exchange(m_playing, playing) == playing)
        return;
    m_play->setIcon(base::themeIcon(playing ? base::Icon::pause : base::Icon::play));
    retranslate();
}

void PatternEditor::setStopped(bool stopped) {
    if (std::exchange(m_stopped, stopped) == stopped)
        return;
    m_play->setEnabled(!stopped);
    retranslate();
}

bool PatternEditor::looping() const {
    return m_loop->isChecked();
}

void PatternEditor::togglePlay() {
    if (m_playing)
        emit stopRequested();
    else if (!m_stopped)
        emit playRequested(m_document->pattern());
}

} // namespace teleta::pattern
