// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/sheet_view.h"

#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace teleta::touch {

namespace {

constexpr double kTitle_em = 1.75;
constexpr double kColumnGap_em = 0.8;

} // namespace

SheetView::SheetView(QWidget* parent)
    : QWidget(parent)
    , m_view(new QTableView(this))
    , m_empty(new QLabel(m_view->viewport()))
    , m_export(new base::FigureExport(this, [this] { return figure(); })) {
    m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setAlternatingRowColors(true);
    m_view->setShowGrid(false);
    m_view->setWordWrap(false);
    m_view->setTabKeyNavigation(false);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->verticalHeader()->hide();
    m_view->installEventFilter(this);
    m_view->viewport()->installEventFilter(this);
    setFocusProxy(m_view);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_view);
    connect(m_export, &base::FigureExport::saved, this, &SheetView::exported);
    connect(m_export, &base::FigureExport::failed, this, &SheetView::exportFailed);
}

void SheetView::start(QAbstractItemModel* model) {
    m_view->setModel(model);
    m_view->horizontalHeader()->setHighlightSections(false);
    m_view->horizontalHeader()->setStretchLastSection(true);
    m_view->horizontalHeader()->setResizeContentsPrecision(0); // what is in sight
    connect(model, &QAbstractItemModel::modelReset, this, &SheetView::fitColumns);
    connect(model, &QAbstractItemModel::rowsInserted, this, &SheetView::growColumns);
    connect(model, &QAbstractItemModel::dataChanged, this, &SheetView::growColumns);
    connect(model, &QAbstractItemModel::modelReset, this, &SheetView::showEmptiness);
    connect(model, &QAbstractItemModel::rowsInserted, this, &SheetView::showEmptiness);
    base::keepTranslated(this, &SheetView::retranslate);
    base::onChange(this, &SheetView::restyle,
                   {QEvent::LanguageChange, QEvent::PaletteChange, QEvent::FontChange});
    restyle();
}

void SheetView::setProvenance(base::Provenance provenance) {
    base::showProvenance(this, provenance);
    m_provenance = provenance;
    update();
}

void SheetView::setHint(const QString& text) {
    m_empty->setText(text);
}

void SheetView::restyle() {
    layout()->setContentsMargins(0, base::em(this, kTitle_em), 0, 0);
    base::setTextColour(m_empty, palette().color(QPalette::PlaceholderText));
    fitColumns();
    showEmptiness();
}

int SheetView::fittingWidth(int column) const {
    const QString title = m_view->model()->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    // Its own hint has the arrow of a sorted column, but not what is put around the title.
    const int head = std::max(QFontMetrics(m_view->horizontalHeader()->font()).horizontalAdvance(title) +
                                  base::em(this, 1),
                              m_view->horizontalHeader()->sectionSizeHint(column));
    return std::max(head, static_cast<QAbstractItemView*>(m_view)->sizeHintForColumn(column)) +
           base::em(this, kColumnGap_em);
}

void SheetView::fitColumns() {
    for (int column = 0; column + 1 < m_view->model()->columnCount(); ++column)
        m_view->setColumnWidth(column, fittingWidth(column));
}

/// Once for all the changes of a moment.
void SheetView::growColumns() {
    if (std::exchange(m_isFitDue, true))
        return;
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_isFitDue = false;
            for (int column = 0; column + 1 < m_view->model()->columnCount(); ++column)
                m_view->setColumnWidth(column, std::max(m_view->columnWidth(column), fittingWidth(column)));
        },
        Qt::QueuedConnection);
}

void SheetView::showEmptiness() {
    m_empty->setGeometry(m_view->viewport()->rect());
    m_empty->setVisible(m_view->model()->rowCount() == 0);
    update();
}

QSize SheetView::sizeHint() const {
    return {base::em(this, 60), base::em(this, 12)};
}

bool SheetView::onKey(const QKeyEvent& key) {
    if (!key.matches(QKeySequence::Copy))
        return false;
    copy();
    return true;
}

bool SheetView::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show)
        m_empty->setGeometry(m_view->viewport()->rect());
    if (watched != m_view)
        return false;
    if (event->type() == QEvent::KeyPress)
        return onKey(*static_cast<QKeyEvent*>(event));
    if (event->type() == QEvent::ContextMenu) {
        auto* menu = new QMenu(this);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        populateMenu(*menu);
        menu->popup(static_cast<QContextMenuEvent*>(event)->globalPos());
        return true;
    }
    return false;
}

void SheetView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const QRectF line(base::grid(this), 0, width() - 2 * base::grid(this), base::em(this, kTitle_em));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, title());
}

} // namespace teleta::touch
