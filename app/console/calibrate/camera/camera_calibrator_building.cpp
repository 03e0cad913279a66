// SPDX-License-Identifier: GPL-3.0-or-later
// CameraCalibrator: builds its widgets.
#include "app/console/calibrate/camera/camera_calibrator.h"
#include "app/console/calibrate/camera/live_probing_panel.h"
#include "app/console/calibrate/camera/pair_entry.h"
#include "app/console/calibrate/camera/probing_strip.h"
#include "app/console/calibrate/camera/tube_fields.h"
#include "widgets/base/action_button.h"
#include "widgets/base/compose.h"
#include "widgets/base/controls/elided_label.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/redo_keys.h"
#include "widgets/base/theme.h"
#include "widgets/camera/pair_model.h"
#include "widgets/camera/residual_view.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTableView>
#include <QTableWidget>
#include <QUndoStack>
#include <QVBoxLayout>

namespace teleta::console {

namespace {
constexpr double kRow_em = 1.7;
} // namespace

void CameraCalibrator::buildTools() {
    const auto make = [this](auto run) {
        auto* made = new QAction(this);
        connect(made, &QAction::triggered, this, run);
        return made;
    };
    m_load = make([this] {
        base::askToOpen(this, {tr("Load pairs"), {tr("Pairs (*.csv)"), tr("All files (*)")}, m_file},
                        [this](const QString& path) { open(path); });
    });
    m_load->setShortcut(QKeySequence::Open);
    m_savePairs = make([this] {
        base::askToSave(this, {tr("Save the pairs"), {tr("Pairs (*.csv)")}, m_file, QStringLiteral("csv")},
                        [this](const QString& path) { savePairs(path); });
    });
    m_save = make([this] { askToSave(); });
    m_save->setShortcut(QKeySequence::Save);
    m_probe = make([this] { probe(); });
    m_probeWith = make([this] { askForCamera(); });
    m_methodLabel = new QLabel;
    m_methods = new QComboBox;
    for (std::size_t i = 0; i < vision::kCalibrationMethods.size(); ++i)
        m_methods->addItem(QString());
    m_methodLabel->setBuddy(m_methods);
    connect(m_methods, &QComboBox::activated, this,
            [this](int row) { chooseMethod(vision::kCalibrationMethods[static_cast<std::size_t>(row)]); });
    m_exclude = make([this] { excludeOutliers(); });
    // Not the actions of the undo stack: their texts stay in the language in which they were made.
    m_undoAction = new QAction(this);
    m_redoAction = new QAction(this);
    for (QAction* action : {m_undoAction, m_redoAction})
        action->setEnabled(false);
    connect(m_undoAction, &QAction::triggered, m_undo, &QUndoStack::undo);
    connect(m_redoAction, &QAction::triggered, m_undo, &QUndoStack::redo);
    connect(m_undo, &QUndoStack::canUndoChanged, m_undoAction, &QAction::setEnabled);
    connect(m_undo, &QUndoStack::canRedoChanged, m_redoAction, &QAction::setEnabled);
    connect(m_undo, &QUndoStack::undoTextChanged, m_undoAction, &QAction::setToolTip);
    connect(m_undo, &QUndoStack::redoTextChanged, m_redoAction, &QAction::setToolTip);
    m_undoAction->setShortcut(QKeySequence::Undo);
    m_redoAction->setShortcuts(base::redoKeys());
    for (QAction* action : {m_load, m_save, m_undoAction, m_redoAction})
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addActions({m_load, m_save, m_undoAction, m_redoAction});
    m_tube = new TubeFields;
    connect(m_tube, &TubeFields::changed, this, &CameraCalibrator::setSettings);
    connect(m_tube, &TubeFields::holeFactorChanged, this, &CameraCalibrator::setHoleFactor);
}

QWidget* CameraCalibrator::buildTables() {
    m_comparison = new QTableWidget(static_cast<int>(vision::kCalibrationMethods.size()), 6);
    m_comparison->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_comparison->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_comparison->setSelectionMode(QAbstractItemView::SingleSelection);
    m_comparison->verticalHeader()->hide();
    m_comparison->horizontalHeader()->setStretchLastSection(true);
    m_comparison->setWordWrap(false);
    connect(m_comparison, &QTableWidget::cellClicked, this, [this](int row, int) {
        chooseMethod(vision::kCalibrationMethods[static_cast<std::size_t>(row)]);
    });

    m_model = new camera::PairModel(this);
    connect(m_model, &camera::PairModel::useRequested, this,
            [this](std::size_t pair, bool use) { setUsed({pair}, use); });
    auto* sorted = new QSortFilterProxyModel(this);
    sorted->setSourceModel(m_model);
    sorted->setSortRole(camera::PairModel::kSortRole);
    m_table = base::named<QTableView>("pairs");
    m_table->setModel(sorted);
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(camera::PairModel::number, Qt::AscendingOrder);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setWordWrap(false);
    m_toggle = new QAction(m_table);
    connect(m_toggle, &QAction::triggered, this, [this] {
        const std::vector<std::size_t> pairs = selectedPairs();
        if (!pairs.empty())
            setUsed(pairs, !m_work.used[pairs.front()]);
    });
    m_remove = new QAction(m_table);
    m_remove->setShortcut(QKeySequence::Delete);
    m_remove->setShortcutContext(Qt::WidgetShortcut);
    connect(m_remove, &QAction::triggered, this, [this] { removePairs(selectedPairs()); });
    m_table->addActions({m_toggle, m_remove});
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this, sorted](const QModelIndex& current) {
                if (current.isValid())
                    selectPair(static_cast<std::size_t>(sorted->mapToSource(current).row()));
            });

    m_entry = new PairEntry;
    connect(m_entry, &PairEntry::entered, this, &CameraCalibrator::addPair);
    for (QTableView* each : {static_cast<QTableView*>(m_comparison), m_table})
        each->verticalHeader()->setDefaultSectionSize(base::em(this, kRow_em));
    m_comparison->setMinimumHeight(m_comparison->horizontalHeader()->sizeHint().height() +
                                   m_comparison->verticalHeader()->length() + 2 * m_comparison->frameWidth());
    auto* tables = new QSplitter(Qt::Vertical);
    tables->setChildrenCollapsible(false);
    tables->addWidget(m_comparison);
    tables->addWidget(m_table);
    tables->setStretchFactor(1, 1);
    tables->setSizes({m_comparison->minimumHeight(), 1000});
    auto* all = new QWidget;
    auto* layout = new QVBoxLayout(all);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(tables, 1);
    layout->addWidget(m_entry);
    return all;
}

/// Title and files, what was found, ways to get pairs and what is done with them.
QLayout* CameraCalibrator::buildHead() {
    m_title = new base::ElidedLabel(this);
    m_title->setFont(base::bold(base::sized(font(), base::kLargeText)));
    auto* top = new QHBoxLayout;
    top->addWidget(m_title, 1);
    for (QAction* each : {m_undoAction, m_redoAction, m_load, m_savePairs, m_save})
        top->addWidget(base::actionButton(*each, this));
    auto* found = new QHBoxLayout;
    found->addWidget(m_origin);
    found->addWidget(m_verdict, 1);
    auto* ways = new QHBoxLayout;
    m_probeButton = base::actionButton(*m_probe, this);
    ways->addWidget(m_probeButton);
    ways->addWidget(base::actionButton(*m_probeWith, this));
    ways->addSpacing(base::grid(this));
    ways->addWidget(m_methodLabel);
    ways->addWidget(m_methods);
    ways->addWidget(base::actionButton(*m_exclude, this));
    ways->addStretch(1);
    auto* head = new QVBoxLayout;
    head->addLayout(top);
    head->addLayout(found);
    head->addLayout(ways);
    return head;
}

void CameraCalibrator::build() {
    setAcceptDrops(true);
    buildTools();
    buildProbing();
    buildLive();
    m_origin = new QLabel;
    m_verdict = new QLabel;
    m_verdict->setWordWrap(true);
    m_verdict->setMinimumHeight(base::em(this, 1)); // else room for the lines of a much narrower page
    m_verdict->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_image = new camera::ResidualView(camera::ResidualPicture::Surface::image);
    m_cylinder = new camera::ResidualView(camera::ResidualPicture::Surface::cylinder);
    for (camera::ResidualView* view : {m_image, m_cylinder}) {
        connect(view, &camera::ResidualView::selected, this, &CameraCalibrator::selectPair);
        connect(view, &camera::ResidualView::toggleRequested, this, &CameraCalibrator::toggle);
        connect(view, &camera::ResidualView::exported, this,
                [this](const QString& path) { emit message(tr("Saved %1").arg(path), false); });
        connect(view, &camera::ResidualView::exportFailed, this,
                [this](const QString& text) { emit message(text, true); });
    }
    auto* pictures = new QSplitter(Qt::Vertical);
    pictures->addWidget(m_image);
    pictures->addWidget(m_cylinder);
    auto* halves = new QSplitter;
    halves->addWidget(pictures);
    halves->addWidget(buildTables());
    // The tables are wide, and the pictures need no more than they are high.
    halves->setSizes({840, 1160});
    halves->setStretchFactor(0, 1);
    halves->setStretchFactor(1, 1);
    auto* layout = new QVBoxLayout(this);
    const int margin = base::grid(this);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->addLayout(buildHead());
    // The fields have their own row: in French they would leave no room for the verdict.
    auto* tube = new QHBoxLayout;
    tube->addWidget(m_tube);
    tube->addStretch(1);
    layout->addLayout(tube);
    layout->addWidget(m_strip);
    layout->addWidget(m_live);
    layout->addWidget(halves, 1);
}

} // namespace teleta::console
