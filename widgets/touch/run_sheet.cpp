// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/run_sheet.h"

#include "widgets/base/on_change.h"
#include "widgets/base/redo_keys.h"
#include "widgets/base/text_colour.h"
#include "widgets/base/theme.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QTableView>
#include <QUndoStack>
#include <QVBoxLayout>

#include <algorithm>

namespace teleta::touch {

namespace {

constexpr double kTitle_em = 1.75;

} // namespace

RunSheet::RunSheet(QWidget* parent)
    : QWidget(parent)
    , m_model(new RunSheetModel(this))
    , m_view(new QTableView(this))
    , m_empty(new QLabel(m_view->viewport()))
    , m_export(new base::FigureExport(this, [this] {
        base::Figure figure;
        figure.name = tr("run-sheet", "name of a file");
        figure.csv = [text = csv()] { return text; };
        return figure;
    })) {
    m_view->setModel(m_model);
    m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_view->setAlternatingRowColors(true);
    m_view->setShowGrid(false);
    m_view->setWordWrap(false);
    m_view->setTabKeyNavigation(false);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->verticalHeader()->hide();
    m_view->horizontalHeader()->setHighlightSections(false);
    m_view->horizontalHeader()->setStretchLastSection(true);
    m_view->installEventFilter(this);
    m_view->viewport()->installEventFilter(this);
    setFocusProxy(m_view);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_view);
    connect(m_model, &QAbstractItemModel::modelReset, this, &RunSheet::showEmptiness);
    connect(m_model, &QAbstractItemModel::rowsInserted, this, &RunSheet::showEmptiness);
    connect(m_export, &base::FigureExport::saved, this, &RunSheet::exported);
    connect(m_export, &base::FigureExport::failed, this, &RunSheet::exportFailed);
    base::keepTranslated(this, &RunSheet::retranslate);
    base::onChange(this, &RunSheet::restyle,
                   {QEvent::LanguageChange, QEvent::PaletteChange, QEvent::FontChange});
    restyle();
}

void RunSheet::retranslate() {
    m_view->setAccessibleName(tr("Run sheet"));
    setWhatsThis(
        tr("<p>The objects that were found, told apart by their place. Stiffness is the median of "
           "their touches, with its 95 % interval.</p><p>F2 names an object, Delete takes it off the "
           "sheet, Ctrl+Z brings it back.</p>"));
    showHint();
    m_model->retranslate();
    update();
}

void RunSheet::showHint() {
    const bool isRecorded =
        m_provenance == base::Provenance::recorded || m_provenance == base::Provenance::recordedSimulation;
    m_empty->setText(isRecorded
                         ? tr("No object was found yet. Play the recording until the arm touches something.")
                         : tr("No object was found yet. Drive the arm until it touches something."));
}

void RunSheet::restyle() {
    layout()->setContentsMargins(0, base::em(this, kTitle_em), 0, 0);
    base::setTextColour(m_empty, palette().color(QPalette::PlaceholderText));
    m_view->verticalHeader()->setDefaultSectionSize(base::em(this, 1.8));
    const QFontMetrics metrics(font());
    const auto wide = [&](int column, const QString& sample) {
        const QString title = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const int text = std::max(metrics.horizontalAdvance(sample), metrics.horizontalAdvance(title));
        m_view->setColumnWidth(column, text + base::em(this, 1.2));
    };
    wide(RunSheetModel::number, QStringLiteral("888"));
    wide(RunSheetModel::name, QStringLiteral("the wooden box"));
    wide(RunSheetModel::time, QStringLiteral("88888.8 s"));
    wide(RunSheetModel::place, QStringLiteral("\u2212888, \u2212888 mm"));
    wide(RunSheetModel::touches, QStringLiteral("888"));
    wide(RunSheetModel::contact, QStringLiteral("point"));
    wide(RunSheetModel::force, QStringLiteral("888 mN"));
    wide(RunSheetModel::stiffness, QStringLiteral("8.88 kN/m (8.88 … 8.88 kN/m)"));
    wide(RunSheetModel::material, QStringLiteral("rubber sponge, DANGER"));
    showEmptiness();
}

void RunSheet::showEmptiness() {
    m_empty->setGeometry(m_view->viewport()->rect());
    m_empty->setVisible(m_model->rowCount() == 0);
    update();
}

void RunSheet::clear() {
    m_model->clear();
    showEmptiness();
}

void RunSheet::setProvenance(base::Provenance provenance) {
    m_provenance = provenance;
    showHint();
    update();
}

void RunSheet::removeSelected() {
    std::vector<std::uint64_t> numbers;
    for (const QModelIndex& index : m_view->selectionModel()->selectedRows())
        numbers.push_back(m_model->object(index.row()).number);
    m_model->remove(numbers);
}

void RunSheet::editName() {
    m_view->edit(m_model->index(m_view->currentIndex().row(), RunSheetModel::name));
}

void RunSheet::undo() {
    m_model->undoStack().undo();
    showEmptiness();
}

void RunSheet::redo() {
    m_model->undoStack().redo();
    showEmptiness();
}

void RunSheet::populateMenu(QMenu& menu) {
    const bool hasSelection = m_view->selectionModel()->hasSelection();
    QAction* rename = menu.addAction(tr("&Name…"), this, &RunSheet::editName);
    rename->setShortcut(Qt::Key_F2);
    rename->setEnabled(m_view->currentIndex().isValid());
    QAction* remove = menu.addAction(tr("&Delete"), this, &RunSheet::removeSelected);
    remove->setShortcut(QKeySequence::Delete);
    remove->setEnabled(hasSelection);
    menu.addSeparator();
    QAction* back =
        menu.addAction(tr("&Undo %1").arg(m_model->undoStack().undoText()), this, &RunSheet::undo);
    back->setShortcut(QKeySequence::Undo);
    back->setEnabled(m_model->undoStack().canUndo());
    QAction* again =
        menu.addAction(tr("&Redo %1").arg(m_model->undoStack().redoText()), this, &RunSheet::redo);
    again->setShortcuts(base::redoKeys());
    again->setEnabled(m_model->undoStack().canRedo());
    menu.addSeparator();
    m_export->addDataActions(menu);
}

QSize RunSheet::sizeHint() const {
    return {base::em(this, 60), base::em(this, 12)};
}

bool RunSheet::isOwnKey(const QKeyEvent& key) const {
    return key.matches(QKeySequence::Delete) || key.matches(QKeySequence::Undo) || base::isRedo(key) ||
           key.matches(QKeySequence::Copy);
}

bool RunSheet::onKey(const QKeyEvent& key) {
    if (key.key() == Qt::Key_F2 && m_view->currentIndex().isValid())
        editName();
    else if (key.matches(QKeySequence::Delete))
        removeSelected();
    else if (key.matches(QKeySequence::Undo))
        undo();
    else if (base::isRedo(key))
        redo();
    else if (key.matches(QKeySequence::Copy))
        QGuiApplication::clipboard()->setText(csv());
    else
        return false;
    return true;
}

bool RunSheet::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show)
        m_empty->setGeometry(m_view->viewport()->rect());
    if (watched != m_view)
        return false;
    if (event->type() == QEvent::ShortcutOverride && isOwnKey(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
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

void RunSheet::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF line(base::grid(this), 0, width() - 2 * base::grid(this), base::em(this, kTitle_em));
    const QString badge = base::provenanceText(m_provenance);
    if (!badge.isEmpty()) {
        const QSizeF size = base::badgeSize(font(), badge);
        base::paintBadge(
            painter,
            QRectF(QPointF(line.right() - size.width(), line.center().y() - 0.5 * size.height()), size),
            badge, base::statusColours(palette()).simulated);
    }
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     tr("%n object(s) found", nullptr, m_model->rowCount()));
}

} // namespace teleta::touch
