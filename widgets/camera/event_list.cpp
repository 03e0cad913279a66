// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/event_list.h"

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

EventList::EventList(EventListModel& model, QWidget* parent)
    : QWidget(parent)
    , m_list(model)
    , m_table(new QTableView(this))
    , m_export(new base::FigureExport(this, [this] { return figure(); })) {
    m_table->setModel(&m_list);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setAlternatingRowColors(true);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(base::em(this, 1.5));
    m_table->setWordWrap(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setResizeContentsPrecision(0); // what is in sight
    m_table->horizontalHeader()->setMinimumSectionSize(base::em(this, 1));
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setHighlightSections(false);
    // Without rows there is nothing to fit.
    connect(
        &m_list, &QAbstractItemModel::rowsInserted, m_table->horizontalHeader(),
        [header = m_table->horizontalHeader()] { header->resizeSections(QHeaderView::ResizeToContents); });
    m_table->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_table, 1);
    setFocusProxy(m_table);
    connect(m_export, &base::FigureExport::saved, this, &EventList::exported);
    connect(m_export, &base::FigureExport::failed, this, &EventList::exportFailed);
    base::onChange(this, &EventList::retranslate, {QEvent::LanguageChange, QEvent::PaletteChange});
}

void EventList::setProvenance(base::Provenance provenance) {
    base::showProvenance(this, provenance);
}

base::Figure EventList::figure() const {
    base::Figure figure;
    figure.name = fileName();
    figure.csv = [text = m_list.csv()] { return text; };
    return figure;
}

bool EventList::eventFilter(QObject* watched, QEvent* event) {
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
        menu->addAction(tr("&Clear the list"), this, &EventList::clear);
        menu->popup(static_cast<QContextMenuEvent*>(event)->globalPos());
        return true;
    }
    return false;
}

void EventList::retranslate() {
    m_table->setAccessibleName(tr("Events"));
    m_table->setWhatsThis(explanation());
    m_list.retranslate();
}

} // namespace teleta::camera
