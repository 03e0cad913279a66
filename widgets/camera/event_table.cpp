// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/event_table.h"

#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QTableView>
#include <QVBoxLayout>

namespace teleta::camera {

EventTable::EventTable(QWidget* parent)
    : QWidget(parent)
    , m_model(new EventModel(this))
    , m_table(new QTableView(this))
    , m_export(new base::FigureExport(this, [this] { return figure(); })) {
    m_table->setModel(m_model);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setAlternatingRowColors(true);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(base::em(this, 1.5));
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_table, 1);
    setFocusProxy(m_table);
    connect(m_export, &base::FigureExport::saved, this, &EventTable::exported);
    connect(m_export, &base::FigureExport::failed, this, &EventTable::exportFailed);
    retranslate();
    base::onChange(this, &EventTable::retranslate, {QEvent::LanguageChange, QEvent::PaletteChange});
}

void EventTable::setProvenance(base::Provenance provenance) {
    base::showProvenance(this, provenance);
}

base::Figure EventTable::figure() const {
    base::Figure figure;
    figure.name = tr("camera-events");
    figure.csv = [text = m_model->csv()] { return text; };
    return figure;
}

bool EventTable::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_table)
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        base::copyData(figure());
        return true;
    }
    if (event->type() == QEvent::ContextMenu) {
        auto* menu = new QMenu(this);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        m_export->addDataActions(*menu);
        menu->addSeparator();
        menu->addAction(tr("&Clear the list"), this, &EventTable::clear);
        menu->popup(static_cast<QContextMenuEvent*>(event)->globalPos());
        return true;
    }
    return false;
}

void EventTable::retranslate() {
    m_table->setAccessibleName(tr("Events"));
    m_table->setWhatsThis(
        tr("What happened to the tube, newest first. The context menu copies and saves the list."));
    m_model->retranslate();
}

} // namespace teleta::camera
