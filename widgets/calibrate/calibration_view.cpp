// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibrate/calibration_view.h"

#include "widgets/base/redo_keys.h"
#include "widgets/base/theme.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QShortcut>
#include <QUndoCommand>

#include <utility>

namespace teleta::calibrate {

namespace {

class Change : public QUndoCommand {
public:
    Change(std::function<void()> redo, std::function<void()> undo)
        : m_redo(std::move(redo))
        , m_undo(std::move(undo)) {}
    void redo() override { m_redo(); }
    void undo() override { m_undo(); }

private:
    std::function<void()> m_redo;
    std::function<void()> m_undo;
};

} // namespace

CalibrationView::CalibrationView(std::initializer_list<const char*> tools, QWidget* parent)
    : QWidget(parent) {
    m_title->setFont(base::bold(base::sized(font(), base::kLargeText)));
    m_verdict->setWordWrap(true);
    m_verdict->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_top->addWidget(m_title, 1);
    auto* row = new QHBoxLayout;
    for (const char* tool : tools)
        row->addWidget(addButton(tool, this));
    m_top->addLayout(row);
    const int margin = base::grid(this);
    m_page->setContentsMargins(margin, margin, margin, margin);
    m_page->addLayout(m_top);
    m_page->addWidget(m_state);

    connect(m_changes, &QUndoStack::indexChanged, this, &CalibrationView::refresh);
    connect(button("load"), &QPushButton::clicked, this, &CalibrationView::loadRequested);
    connect(button("save"), &QPushButton::clicked, this, &CalibrationView::saveRequested);
    const auto steps = [this](const char* name, const QList<QKeySequence>& keys, auto step) {
        connect(button(name), &QPushButton::clicked, this, step);
        auto* shortcut = new QShortcut(this);
        shortcut->setKeys(keys);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, this, step);
    };
    steps("undo", QKeySequence::keyBindings(QKeySequence::Undo), &CalibrationView::undo);
    steps("redo", base::redoKeys(), &CalibrationView::redo);
}

CalibrationView::~CalibrationView() {
    // An undo stack emits indexChanged when destroyed; the derived class no longer exists then.
    disconnect(m_changes, nullptr, this, nullptr);
}

void CalibrationView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_top->setDirection(isNarrow() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

bool CalibrationView::isNarrow() const {
    constexpr double kNarrow_em = 46.0;
    return width() < base::em(this, kNarrow_em);
}

bool CalibrationView::isSaved() const {
    return m_changes->isClean();
}

void CalibrationView::markSaved() {
    m_changes->setClean();
    refresh();
}

QPushButton* CalibrationView::addButton(const char* name, QWidget* parent) {
    auto* made = new QPushButton(parent);
    made->setObjectName(QLatin1String(name));
    made->setAutoDefault(false);
    return made;
}

QPushButton* CalibrationView::button(const char* name) const {
    return findChild<QPushButton*>(QLatin1String(name));
}

void CalibrationView::name(const char* which, const QString& text, const QString& toolTip) {
    QPushButton* named = button(which);
    named->setText(text);
    named->setToolTip(toolTip);
    // Where there is little room it keeps its text and gives up the room around it.
    named->setMinimumWidth(named->fontMetrics().size(Qt::TextShowMnemonic, text).width() +
                           base::grid(this, 2.0));
}

void CalibrationView::enable(const char* which, bool enabled) {
    button(which)->setEnabled(enabled);
}

void CalibrationView::showTitle(const QString& title) {
    m_title->setText(title);
}

void CalibrationView::showState(const QString& state, base::Provenance provenance, const QColor& colour) {
    const bool live = provenance == base::Provenance::live;
    m_state->setText(live ? state : base::provenanceText(provenance) + QStringLiteral(" \u00b7 ") + state);
    base::setTextColour(m_state, colour);
}

void CalibrationView::change(std::function<void()> redo, std::function<void()> undo) {
    m_changes->push(new Change(std::move(redo), std::move(undo)));
}

void CalibrationView::forgetChanges(bool isSaved) {
    m_changes->clear();
    // clear() does not change the clean state of an empty stack.
    if (isSaved)
        m_changes->setClean();
    else
        m_changes->resetClean();
}

} // namespace teleta::calibrate
