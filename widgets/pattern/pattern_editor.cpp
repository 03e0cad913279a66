// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/pattern_editor.h"

#include "widgets/base/icons.h"
#include "widgets/base/theme.h"
#include "widgets/pattern/law_list.h"
#include "widgets/pattern/pattern_inspector.h"
#include "widgets/pattern/pattern_library.h"
#include "widgets/pattern/stroke_pad.h"
#include "widgets/pattern/timeline_painter.h"
#include "widgets/pattern/timeline_view.h"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QSplitter>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace teleta::editor {

using namespace pattern;

PatternEditor::PatternEditor(QWidget* parent)
    : QWidget(parent)
    , m_document(new PatternDocument(this))
    , m_library(new PatternLibrary(this))
    , m_timeline(new TimelineView(m_document, this))
    , m_stroke(new StrokePad(m_document, this))
    , m_laws(new LawList(m_document, this))
    , m_inspector(new PatternInspector(m_document, this))
    , m_bar(new QToolBar(this))
    , m_title(new QLabel(this))
    , m_below(new QSplitter(Qt::Horizontal, this)) {
    makeActions();
    auto* numbers = new QSplitter(Qt::Horizontal, this);
    numbers->addWidget(m_laws);
    numbers->addWidget(m_inspector);
    m_below->addWidget(m_stroke);
    m_below->addWidget(numbers);
    m_below->setStretchFactor(0, 2);
    m_below->setStretchFactor(1, 3);
    auto* right = new QSplitter(Qt::Vertical, this);
    right->addWidget(m_timeline);
    right->addWidget(m_below);
    right->setStretchFactor(0, 3);
    right->setStretchFactor(1, 1);
    right->setSizes({base::em(this, 28), base::em(this, 15)});
    auto* all = new QSplitter(Qt::Horizontal, this);
    all->addWidget(m_library);
    all->addWidget(right);
    all->setStretchFactor(1, 1);
    all->setSizes({base::em(this, 15), base::em(this, 60)});
    for (QSplitter* splitter : {numbers, m_below, right, all})
        splitter->setChildrenCollapsible(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(base::grid(this, 0.5));
    layout->addWidget(m_bar);
    layout->addWidget(all, 1);

    connect(m_library, &PatternLibrary::openRequested, this, &PatternEditor::openRequested);
    connect(m_library, &PatternLibrary::duplicateRequested, this, &PatternEditor::duplicateRequested);
    connect(m_library, &PatternLibrary::compareRequested, this, &PatternEditor::compareRequested);
    connect(m_timeline, &TimelineView::playheadMoved, this, [this](double time_s) {
        m_stroke->setStart(time_s);
        emit playheadMoved(time_s);
    });
    connect(m_timeline, &TimelineView::playToggled, this, &PatternEditor::togglePlay);
    connect(m_timeline, &TimelineView::objectActivated, this, [this](std::size_t object) {
        m_document->select({{}, object});
        m_inspector->setFocus();
    });
    connect(m_timeline, &TimelineView::penChanged, m_pen, &QAction::setChecked);
    connect(m_document, &PatternDocument::patternChanged, this, &PatternEditor::updateTitle);
    connect(m_document, &PatternDocument::dirtyChanged, this, &PatternEditor::updateTitle);
    connect(m_document, &PatternDocument::pathChanged, this, &PatternEditor::updateTitle);
    connect(m_document, &PatternDocument::snappingChanged, this,
            [this] { m_snap->setChecked(m_document->snapping()); });
    connect(m_document, &PatternDocument::patternOpened, this, [this] { m_stroke->setStart(0.0); });
    retranslate();
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
    m_bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_open = action({}, QKeySequence::Open, [this] { emit openRequested({}); });
    m_save = action({}, QKeySequence::Save, [this] { emit saveRequested(m_document->path()); });
    m_play = action(base::themeIcon(base::Icon::play), {}, [this] { togglePlay(); });
    m_stop = action({}, {}, [this] { emit stopRequested(); });
    m_loop = action(base::themeIcon(base::Icon::loop), {}, [] {});
    m_loop->setCheckable(true);
    QUndoStack* stack = m_document->undoStack();
    m_undo = action({}, QKeySequence::Undo, [stack] { stack->undo(); });
    m_redo = action({}, QKeySequence::Redo, [stack] { stack->redo(); });
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
    m_add = new QAction(this);
    m_add->setMenu(new QMenu(this));

    m_bar->addAction(m_play);
    m_bar->addAction(m_stop);
    m_bar->addAction(m_loop);
    m_bar->addSeparator();
    m_bar->addAction(m_undo);
    m_bar->addAction(m_redo);
    m_bar->addSeparator();
    m_bar->addAction(m_pen);
    m_bar->addAction(m_snap);
    m_bar->addAction(m_add);
    qobject_cast<QToolButton*>(m_bar->widgetForAction(m_add))->setPopupMode(QToolButton::InstantPopup);
    m_bar->addSeparator();
    m_bar->addAction(m_rotateBack);
    m_bar->addAction(m_rotate);
    m_bar->addAction(m_mirror);
    m_bar->addAction(m_swap);
    m_bar->addAction(m_fit);
    m_bar->addSeparator();
    m_bar->addAction(m_open);
    m_bar->addAction(m_save);
    auto* room = new QWidget(m_bar);
    room->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_bar->addWidget(room);
    m_bar->addWidget(m_title);
}

void PatternEditor::retranslate() {
    setAccessibleName(tr("Editor of patterns"));
    const auto name = [](QAction* action, const QString& text, const QString& help) {
        action->setText(text);
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        action->setToolTip(keys.isEmpty() ? help : help + QStringLiteral(" (") + keys + QLatin1Char(')'));
    };
    name(m_open, tr("Open…"), tr("Open a pattern file"));
    name(m_save, tr("Save"), tr("Save the pattern"));
    name(m_play, m_playing ? tr("Pause") : tr("Play"), tr("Play from the playhead, or pause (Space)"));
    name(m_stop, tr("Stop"), tr("Stop playing"));
    name(m_loop, tr("Loop"), tr("Begin again at the end; Shift and a drag on the ruler set the range"));
    name(m_undo, tr("Undo"), tr("Undo the last edit"));
    name(m_redo, tr("Redo"), tr("Redo what was undone"));
    name(m_pen, tr("Pen"), tr("Every click adds a breakpoint (P)"));
    name(m_snap, tr("Snap"), tr("Times on a grid; Alt while dragging leaves it"));
    name(m_add, tr("Add"), tr("Add an object at the playhead"));
    name(m_rotateBack, tr("↺ 60°"), tr("Rotate around the ring: every motor does what the next one did"));
    name(m_rotate, tr("↻ 60°"), tr("Rotate around the ring: every motor does what the one before did"));
    name(m_mirror, tr("Mirror"), tr("The order of the motors the other way round"));
    name(m_swap, tr("Other arm"), tr("The pattern for the other arm"));
    name(m_fit, tr("Fit"), tr("Show the whole pattern (Ctrl+0 on the timeline)"));
    QMenu* menu = m_add->menu();
    menu->clear();
    const std::vector<int> all{0, 1, 2, 3, 4, 5};
    Sweep sweep;
    sweep.tactors = all;
    Ramp ramp;
    ramp.tactors = {0};
    PulseTrain train;
    train.tactors = {0};
    for (const ObjectForm& form : std::array<ObjectForm, 5>{sweep, Ring{}, Phantom{}, ramp, train})
        menu->addAction(formName(form), this, [this, form] { addObject(form); });
    updateTitle();
}

void PatternEditor::addObject(const ObjectForm& form) {
    ObjectForm placed = form;
    std::visit([this](auto& object) { object.start_s = m_timeline->playhead_s(); }, placed);
    m_document->addObject({{}, std::move(placed), {}});
}

void PatternEditor::updateTitle() {
    const QString name = QString::fromStdString(m_document->pattern().name);
    QString text = name.isEmpty() ? tr("Untitled") : name;
    if (m_document->isBuiltIn())
        text += QStringLiteral(" · ") + tr("built-in, edits make a copy");
    else if (m_document->isDirty())
        text += QStringLiteral(" · ") + tr("not saved");
    m_title->setText(text);
    m_title->setToolTip(m_document->path());
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
    if (playing == m_playing)
        return;
    m_playing = playing;
    m_play->setIcon(base::themeIcon(playing ? base::Icon::pause : base::Icon::play));
    retranslate();
}

bool PatternEditor::looping() const {
    return m_loop->isChecked();
}

void PatternEditor::togglePlay() {
    if (m_playing)
        emit stopRequested();
    else
        emit playRequested(m_document->pattern());
}

void PatternEditor::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace teleta::editor
