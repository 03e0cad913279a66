// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera_calibrator.h"

#include "app/console/background.h"
#include "backend/vision/camera_file.h"
#include "widgets/base/number_format.h"
#include "widgets/base/theme.h"
#include "widgets/camera/pair_model.h"
#include "widgets/camera/residual_view.h"

#include <QAction>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTableView>
#include <QTableWidget>
#include <QToolBar>
#include <QUndoCommand>
#include <QUndoStack>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace teleta::console {

namespace {

using vision::CalibrationMethod;
using vision::CalibrationPair;

QString millimetres(double length_m) {
    return base::withUnit(base::threeDigits(1e3 * length_m).trimmed(), QStringLiteral("mm"));
}

QString pixels(double value_px) {
    return base::withUnit(base::threeDigits(value_px).trimmed(), QStringLiteral("px"));
}

/// Spreads the residuals over all pairs and adds those of the excluded ones.
void spreadResiduals(vision::Calibration& calibration, const std::vector<CalibrationPair>& pairs,
                     const std::vector<bool>& used) {
    std::vector<vision::PairResidual> all;
    std::size_t next = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        all.push_back(used[i] ? calibration.residuals[next++]
                              : vision::residualOf(calibration.camera, pairs[i]));
    }
    calibration.residuals = std::move(all);
}

CameraCalibrator::Answers fitAll(const std::vector<CalibrationPair>& pairs, const std::vector<bool>& used,
                                 const vision::CalibrationSettings& settings) {
    std::vector<CalibrationPair> chosen;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (used[i])
            chosen.push_back(pairs[i]);
    }
    CameraCalibrator::Answers answers;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        auto calibration = vision::calibrate(chosen, settings, vision::kCalibrationMethods[i]);
        if (!calibration) {
            const core::Error error = vision::describe(calibration.error(), chosen.size());
            answers[i].refusal = QString::fromStdString(error.message);
            continue;
        }
        spreadResiduals(*calibration, pairs, used);
        answers[i].calibration = std::move(*calibration);
    }
    return answers;
}

} // namespace

/// Uses pairs or leaves them out.
class UseCommand : public QUndoCommand {
public:
    UseCommand(CameraCalibrator& calibrator, std::vector<std::size_t> pairs, bool used, const QString& text)
        : QUndoCommand(text)
        , m_calibrator(calibrator)
        , m_pairs(std::move(pairs))
        , m_used(used) {}

    void redo() override { m_calibrator.applyUsed(m_pairs, m_used); }
    void undo() override { m_calibrator.applyUsed(m_pairs, !m_used); }

private:
    CameraCalibrator& m_calibrator;
    std::vector<std::size_t> m_pairs;
    bool m_used;
};

CameraCalibrator::CameraCalibrator(QWidget* parent)
    : QWidget(parent)
    , m_undo(new QUndoStack(this)) {
    build();
    retranslate();
    refresh();
}

CameraCalibrator::~CameraCalibrator() = default;

void CameraCalibrator::buildTools() {
    m_tools = new QToolBar;
    m_tools->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_load = m_tools->addAction(QString(), this, [this] { askForFile(false); });
    m_load->setShortcut(QKeySequence::Open);
    m_save = m_tools->addAction(QString(), this, [this] { askForFile(true); });
    m_save->setShortcut(QKeySequence::Save);
    m_tools->addSeparator();
    m_methodLabel = new QLabel;
    m_methods = new QComboBox;
    for (std::size_t i = 0; i < vision::kCalibrationMethods.size(); ++i)
        m_methods->addItem(QString());
    m_methodLabel->setBuddy(m_methods);
    m_tools->addWidget(m_methodLabel);
    m_tools->addWidget(m_methods);
    connect(m_methods, &QComboBox::activated, this,
            [this](int row) { chooseMethod(vision::kCalibrationMethods[static_cast<std::size_t>(row)]); });
    m_tools->addSeparator();
    m_exclude = m_tools->addAction(QString(), this, &CameraCalibrator::excludeOutliers);
    m_undoAction = m_undo->createUndoAction(this);
    m_undoAction->setShortcut(QKeySequence::Undo);
    m_redoAction = m_undo->createRedoAction(this);
    m_redoAction->setShortcut(QKeySequence::Redo);
    m_tools->addAction(m_undoAction);
    m_tools->addAction(m_redoAction);
    for (QAction* action : {m_load, m_save, m_undoAction, m_redoAction})
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addActions({m_load, m_save, m_undoAction, m_redoAction});
}

void CameraCalibrator::build() {
    setAcceptDrops(true);
    buildTools();
    m_verdict = new QLabel;
    m_verdict->setWordWrap(true);
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
    m_comparison = new QTableWidget(static_cast<int>(vision::kCalibrationMethods.size()), 6);
    m_comparison->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_comparison->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_comparison->setSelectionMode(QAbstractItemView::SingleSelection);
    m_comparison->verticalHeader()->hide();
    m_comparison->horizontalHeader()->setStretchLastSection(true);
    connect(m_comparison, &QTableWidget::cellClicked, this, [this](int row, int) {
        chooseMethod(vision::kCalibrationMethods[static_cast<std::size_t>(row)]);
    });

    m_model = new camera::PairModel(this);
    connect(m_model, &camera::PairModel::useRequested, this,
            [this](std::size_t pair, bool use) { setUsed({pair}, use); });
    auto* sorted = new QSortFilterProxyModel(this);
    sorted->setSourceModel(m_model);
    sorted->setSortRole(camera::PairModel::kSortRole);
    m_table = new QTableView;
    m_table->setModel(sorted);
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(camera::PairModel::number, Qt::AscendingOrder);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this, sorted](const QModelIndex& current) {
                if (current.isValid())
                    selectPair(static_cast<std::size_t>(sorted->mapToSource(current).row()));
            });

    auto* pictures = new QSplitter(Qt::Vertical);
    pictures->addWidget(m_image);
    pictures->addWidget(m_cylinder);
    auto* tables = new QSplitter(Qt::Vertical);
    tables->addWidget(m_comparison);
    tables->addWidget(m_table);
    tables->setStretchFactor(0, 1);
    tables->setStretchFactor(1, 3);
    auto* halves = new QSplitter;
    halves->addWidget(pictures);
    halves->addWidget(tables);
    halves->setStretchFactor(0, 3);
    halves->setStretchFactor(1, 2);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_tools);
    layout->addWidget(m_verdict);
    layout->addWidget(halves, 1);
}

void CameraCalibrator::retranslate() {
    setWindowTitle(tr("Cylinder camera"));
    m_load->setText(tr("&Load pairs..."));
    m_load->setToolTip(tr("Pairs of pixels and points: CSV with u_px,v_px,x_m,y_m,z_m"));
    m_save->setText(tr("&Save camera..."));
    m_save->setToolTip(tr("The camera of the chosen method, for teleta locate and the camera view"));
    m_methodLabel->setText(tr("&Method:"));
    m_methods->setAccessibleName(tr("Method of calibration"));
    const std::array<QString, vision::kCalibrationMethods.size()> names{
        tr("Linear (DLT)"), tr("As in the paper"), tr("Least squares"), tr("Robust")};
    for (std::size_t i = 0; i < names.size(); ++i)
        m_methods->setItemText(static_cast<int>(i), names[i]);
    m_exclude->setText(tr("&Exclude wrong pairs"));
    m_exclude->setToolTip(tr("Leaves the pairs that are marked as wrong out for every method"));
    m_comparison->setAccessibleName(tr("Methods side by side"));
    m_comparison->setHorizontalHeaderLabels(
        {tr("Method"), tr("Kept"), tr("Image, mean"), tr("Surface, mean"), tr("Uncertainty"), tr("Remark")});
    m_table->setAccessibleName(tr("Pairs"));
    m_model->retranslate();
    setWhatsThis(
        tr("<p>Finds the camera inside the tactile cylinder from pairs: a pixel and the point of the surface "
           "that was probed there.</p><p>Load a CSV file or drop it here. Wrong pairs are found and "
           "left out; you may exclude more, and take every step back.</p>"));
    showComparison();
    m_verdict->setText(verdict());
}

void CameraCalibrator::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

void CameraCalibrator::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().size() == 1 &&
        event->mimeData()->urls().front().isLocalFile())
        event->acceptProposedAction();
}

void CameraCalibrator::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    open(event->mimeData()->urls().front().toLocalFile());
}

void CameraCalibrator::askForFile(bool save) {
    auto* dialog = new QFileDialog(this, save ? tr("Save the camera") : tr("Load pairs"), m_file,
                                   save ? tr("Cameras (*.json)") : tr("Pairs (*.csv);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(save ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(save ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    if (save)
        dialog->setDefaultSuffix(QStringLiteral("json"));
    connect(dialog, &QFileDialog::fileSelected, this,
            save ? &CameraCalibrator::save : &CameraCalibrator::open);
    dialog->open();
}

void CameraCalibrator::open(const QString& path) {
    runInBackground(
        this, [path] { return vision::readPairs(path.toStdString()); },
        [this, path](core::Expected<std::vector<CalibrationPair>> pairs) {
            if (!pairs) {
                emit message(QString::fromStdString(core::describe(pairs.error())), true);
                return;
            }
            m_file = QFileInfo(path).absolutePath();
            setPairs(std::move(*pairs));
        });
}

void CameraCalibrator::save(const QString& path) {
    const Answer* chosen = answer();
    if (chosen == nullptr || !chosen->calibration)
        return;
    vision::CameraFile file{chosen->calibration->camera, vision::summaryOf(*chosen->calibration)};
    runInBackground(
        this, [file = std::move(file), path] { return vision::writeCamera(file, path.toStdString()); },
        [this, path](core::Expected<void> written) {
            if (written)
                emit message(tr("Saved %1").arg(path), false);
            else
                emit message(QString::fromStdString(core::describe(written.error())), true);
        });
}

void CameraCalibrator::setPairs(std::vector<CalibrationPair> pairs) {
    m_undo->clear();
    m_shown = {};
    m_shown.used.assign(pairs.size(), true);
    m_shown.pairs = std::move(pairs);
    m_answers.reset();
    refresh();
    fit();
}

void CameraCalibrator::setUsed(const std::vector<std::size_t>& pairs, bool used) {
    std::vector<std::size_t> changed;
    for (const std::size_t pair : pairs) {
        if (pair < m_shown.used.size() && m_shown.used[pair] != used)
            changed.push_back(pair);
    }
    if (changed.empty())
        return;
    const auto count = static_cast<int>(changed.size());
    m_undo->push(new UseCommand(*this, std::move(changed), used,
                                used ? tr("use of %n pair(s)", nullptr, count)
                                     : tr("exclusion of %n pair(s)", nullptr, count)));
}

void CameraCalibrator::applyUsed(const std::vector<std::size_t>& pairs, bool used) {
    for (const std::size_t pair : pairs)
        m_shown.used[pair] = used;
    refresh();
    fit();
}

void CameraCalibrator::toggle(std::size_t pair) {
    setUsed({pair}, !m_shown.used[pair]);
}

void CameraCalibrator::excludeOutliers() {
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < m_shown.pairs.size(); ++i) {
        if (m_shown.state(i) == camera::CalibratedPairs::State::outlier)
            wrong.push_back(i);
    }
    setUsed(wrong, false);
}

void CameraCalibrator::chooseMethod(CalibrationMethod method) {
    m_method = method;
    refresh();
}

void CameraCalibrator::fit() {
    if (m_fitting) {
        m_again = true;
        return;
    }
    m_fitting = true;
    m_again = false;
    m_verdict->setText(verdict());
    runInBackground(
        this,
        [pairs = m_shown.pairs, used = m_shown.used, settings = m_settings] {
            return fitAll(pairs, used, settings);
        },
        [this](Answers answers) {
            m_fitting = false;
            if (m_again) {
                fit();
                return;
            }
            m_answers = std::move(answers);
            refresh();
            emit calibrated();
        });
}

const CameraCalibrator::Answer* CameraCalibrator::answer() const {
    if (!m_answers)
        return nullptr;
    for (std::size_t i = 0; i < vision::kCalibrationMethods.size(); ++i) {
        if (vision::kCalibrationMethods[i] == m_method)
            return &(*m_answers)[i];
    }
    return nullptr;
}

QString CameraCalibrator::verdict() const {
    if (m_shown.pairs.empty())
        return tr("Load pairs of pixels and probed points, or drop their file here.");
    const Answer* chosen = answer();
    if (m_fitting || chosen == nullptr)
        return tr("Calibrating...");
    if (!chosen->calibration)
        return tr("No calibration: %1.").arg(chosen->refusal);
    const vision::Calibration& found = *chosen->calibration;
    const auto used = static_cast<int>(std::count(m_shown.used.begin(), m_shown.used.end(), true));
    QString text = tr("%1 of %n pair(s) kept; ", nullptr, used).arg(found.kept);
    text += tr("points are located with %1 on average, and the camera leaves them uncertain by %2. ")
                .arg(millimetres(found.mean_error_m), millimetres(found.uncertainty_m));
    if (m_method == CalibrationMethod::dlt || m_method == CalibrationMethod::paper)
        text += tr("This method knows no lens: use it to compare only.");
    else if (found.isStructured())
        text +=
            tr("Be careful: residuals of neighbours are alike, so the pairs hold something that this camera "
               "does not describe (a shell that has moved, a wrong radius).");
    else
        text += tr("The residuals have no pattern. Good.");
    return text;
}

void CameraCalibrator::refresh() {
    m_shown.residuals.clear();
    m_shown.camera.reset();
    m_shown.surface = m_settings.surface;
    m_shown.width_px = m_settings.width_px;
    m_shown.height_px = m_settings.height_px;
    const Answer* chosen = answer();
    const bool found = chosen != nullptr && chosen->calibration;
    if (found) {
        m_shown.residuals = chosen->calibration->residuals;
        m_shown.camera = chosen->calibration->camera.camera();
    }
    m_image->setPairs(m_shown);
    m_cylinder->setPairs(m_shown);
    m_model->setPairs(m_shown);
    for (std::size_t i = 0; i < vision::kCalibrationMethods.size(); ++i) {
        if (vision::kCalibrationMethods[i] == m_method) {
            m_methods->setCurrentIndex(static_cast<int>(i));
            m_comparison->selectRow(static_cast<int>(i));
        }
    }
    m_save->setEnabled(found);
    const auto used = static_cast<std::size_t>(std::count(m_shown.used.begin(), m_shown.used.end(), true));
    m_exclude->setEnabled(found && chosen->calibration->kept < used);
    m_verdict->setText(verdict());
    showComparison();
}

void CameraCalibrator::showComparison() {
    for (int row = 0; row < m_comparison->rowCount(); ++row) {
        QStringList cells{m_methods->itemText(row)};
        const Answer* found = m_answers ? &(*m_answers)[static_cast<std::size_t>(row)] : nullptr;
        if (found != nullptr && found->calibration) {
            const vision::Calibration& c = *found->calibration;
            cells << QString::number(c.kept) << pixels(c.mean_px) << millimetres(c.mean_error_m)
                  << millimetres(c.uncertainty_m) << (c.isStructured() ? tr("has a pattern") : QString());
        } else {
            const QString none = QStringLiteral("\u2014");
            cells << none << none << none << none << (found != nullptr ? found->refusal : QString());
        }
        for (int column = 0; column < cells.size(); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            item->setToolTip(cells[column]);
            if (column > 0 && column < 5)
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_comparison->setItem(row, column, item);
        }
    }
    m_comparison->resizeColumnsToContents();
}

void CameraCalibrator::selectPair(std::size_t pair) {
    m_image->select(pair);
    m_cylinder->select(pair);
    const auto* sorted = static_cast<QSortFilterProxyModel*>(m_table->model());
    const QModelIndex row = sorted->mapFromSource(m_model->index(static_cast<int>(pair), 0));
    if (m_table->currentIndex().row() != row.row())
        m_table->setCurrentIndex(row);
}

} // namespace teleta::console
