// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/run_sheet.h"

#include "widgets/base/redo_keys.h"
#include "widgets/base/theme.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QMenu>
#include <QTableView>
#include <QUndoStack>

namespace teleta::touch {

RunSheet::RunSheet(QWidget* parent)
    : SheetView(parent)
    , m_model(new RunSheetModel(this)) {
    view()->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    start(m_model);
}

void RunSheet::retranslate() {
    view()->setAccessibleName(tr("Run sheet"));
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
        provenance() == base::Provenance::recorded || provenance() == base::Provenance::recordedSimulation;
    setHint(isRecorded ? tr("No object was found yet. Play the recording until the arm touches something.")
                       : tr("No object was found yet. Drive the arm until it touches something."));
}

void RunSheet::restyle() {
    view()->verticalHeader()->setDefaultSectionSize(base::em(this, 1.8));
    SheetView::restyle();
}

QString RunSheet::title() const {
    return tr("%n object(s) found", nullptr, m_model->rowCount());
}

base::Figure RunSheet::figure() const {
    base::Figure figure;
    figure.name = tr("run-sheet", "name of a file");
    figure.csv = [text = csv()] { return text; };
    return figure;
}

void RunSheet::copy() const {
    QGuiApplication::clipboard()->setText(csv());
}

void RunSheet::setProvenance(base::Provenance provenance) {
    SheetView::setProvenance(provenance);
    showHint();
}

void RunSheet::select(std::uint64_t object) {
    for (int row = 0; row < m_model->rowCount(); ++row) {
        if (m_model->object(row).number != object)
            continue;
        view()->selectRow(row);
        view()->scrollTo(m_model->index(row, RunSheetModel::name));
    }
}

void RunSheet::removeSelected() {
    std::vector<std::uint64_t> numbers;
    for (const QModelIndex& index : view()->selectionModel()->selectedRows())
        numbers.push_back(m_model->object(index.row()).number);
    m_model->remove(numbers);
}

void RunSheet::editName() {
    view()->edit(m_model->index(view()->currentIndex().row(), RunSheetModel::name));
}

void RunSheet::populateMenu(QMenu& menu) {
    const bool hasSelection = view()->selectionModel()->hasSelection();
    QAction* rename = menu.addAction(tr("&Name…"), this, &RunSheet::editName);
    rename->setShortcut(Qt::Key_F2);
    rename->setEnabled(view()->currentIndex().isValid());
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
    addDataActions(menu);
}

bool RunSheet::isOwnKey(const QKeyEvent& key) const {
    return key.matches(QKeySequence::Delete) || key.matches(QKeySequence::Undo) || base::isRedo(key) ||
           key.matches(QKeySequence::Copy);
}

bool RunSheet::onKey(const QKeyEvent& key) {
    if (key.key() == Qt::Key_F2 && view()->currentIndex().isValid())
        editName();
    else if (key.matches(QKeySequence::Delete))
        removeSelected();
    else if (key.matches(QKeySequence::Undo))
        undo();
    else if (base::isRedo(key))
        redo();
    else
        return SheetView::onKey(key);
    return true;
}

bool RunSheet::eventFilter(QObject* watched, QEvent* event) {
    if (watched == view() && event->type() == QEvent::ShortcutOverride &&
        isOwnKey(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return SheetView::eventFilter(watched, event);
}

} // namespace teleta::touch
