// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/camera_calibrator.h"

#include "app/console/calibrate/camera/camera_probing.h"
#include "app/console/calibrate/camera/live_probing_panel.h"
#include "app/console/calibrate/camera/pair_entry.h"
#include "app/console/calibrate/camera/probing_strip.h"
#include "app/console/calibrate/camera/tube_fields.h"
#include "backend/vision/calibration/camera_file.h"
#include "widgets/base/background.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/camera/pair_model.h"
#include "widgets/camera/residual_view.h"

#include <QAction>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QFontMetrics>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QTableWidget>
#include <QUndoCommand>
#include <QUndoStack>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::console {

namespace {

using vision::CalibrationMethod;
using vision::CalibrationPair;

QString pixels(double value_px) {
    return base::withUnit(base::threeDigits(value_px).trimmed(), QStringLiteral("px"));
}

QString remark(vision::CalibrationWarning warning) {
    switch (warning) {
    case vision::CalibrationWarning::offSurface:
        return CameraCalibrator::tr("points off the cylinder");
    case vision::CalibrationWarning::beyondEnds:
        return CameraCalibrator::tr("points beyond the ends");
    case vision::CalibrationWarning::swappedPixels:
        return CameraCalibrator::tr("u and v swapped?");
    case vision::CalibrationWarning::outsideImage:
        return CameraCalibrator::tr("pixels outside the image");
    case vision::CalibrationWarning::structured:
        return CameraCalibrator::tr("has a pattern");
    }
    return {};
}

QString remark(const vision::Calibration& calibration) {
    QStringList all;
    for (const vision::CalibrationWarning warning : calibration.warnings)
        all << remark(warning);
    return all.join(QStringLiteral(", "));
}

} // namespace

/// Undo step: one state of the work to another.
class CameraCalibrator::Edit : public QUndoCommand {
public:
    Edit(CameraCalibrator& calibrator, Work after, const QString& text, int run)
        : QUndoCommand(text)
        , m_calibrator(calibrator)
        , m_run(run)
        , m_before(calibrator.m_work)
        , m_after(std::move(after)) {}

    void redo() override { m_calibrator.apply(m_after); }
    void undo() override {
        // Undone edits are not merged with later ones.
        if (m_run != 0)
            m_calibrator.m_probing->cancel();
        m_calibrator.apply(m_before);
    }
    [[nodiscard]] int id() const override { return m_run == 0 ? -1 : m_run; }
    bool mergeWith(const QUndoCommand* next) override {
        m_after = static_cast<const Edit*>(next)->m_after;
        return true;
    }

private:
    CameraCalibrator& m_calibrator;
    int m_run;
    Work m_before;
    Work m_after;
};

CameraCalibrator::CameraCalibrator(QWidget* parent)
    : QWidget(parent)
    , m_undo(new QUndoStack(this)) {
    build();
    base::keepTranslated(this, &CameraCalibrator::retranslate);
    refresh();
    base::onChange(this, &CameraCalibrator::refresh, {QEvent::PaletteChange});
}

CameraCalibrator::~CameraCalibrator() = default;

void CameraCalibrator::retranslate() {
    setWindowTitle(tr("Cylinder camera"));
    m_title->setText(tr("Cylinder camera"));
    m_load->setText(tr("&Load pairs\u2026"));
    m_load->setToolTip(tr("Pairs of pixels and points: CSV with u_px,v_px,x_m,y_m,z_m"));
    m_savePairs->setText(tr("Save pai&rs\u2026"));
    m_savePairs->setToolTip(tr("Save all pairs, including excluded ones, to load them again later"));
    m_save->setText(tr("&Save camera\u2026"));
    m_save->setToolTip(
        tr("Save the camera found by the chosen method, for teleta locate and the camera view"));
    m_probe->setText(tr("&Probe the simulated tube"));
    m_probe->setToolTip(tr("Collect pairs: a simulated person presses a stick on the marked places of a "
                           "simulated tube and mistakes one in ten for its neighbour"));
    m_probeWith->setText(tr("Probe with a &camera\u2026"));
    m_probeWith->setToolTip(tr("Collect pairs: press a stick through the holes of a shell while a camera "
                               "watches, live or in a video"));
    m_strip->retranslate();
    m_origin->setText(tr("SIMULATED"));
    m_methodLabel->setText(tr("&Method:"));
    m_methods->setAccessibleName(tr("Method of calibration"));
    const std::array<QString, vision::kCalibrationMethods.size()> names{
        tr("Linear (DLT)"), tr("As in the paper"), tr("Least squares"), tr("Robust")};
    for (std::size_t i = 0; i < names.size(); ++i)
        m_methods->setItemText(static_cast<int>(i), names[i]);
    m_exclude->setText(tr("&Exclude wrong pairs"));
    m_undoAction->setText(tr("&Undo"));
    m_redoAction->setText(tr("&Redo"));
    m_exclude->setToolTip(tr("Exclude the pairs marked as wrong, for every method"));
    m_comparison->setAccessibleName(tr("Methods side by side"));
    m_comparison->setHorizontalHeaderLabels(
        {tr("Method"), tr("Kept"), tr("Image, mean"), tr("Surface, mean"), tr("Uncertainty"), tr("Remark")});
    m_table->setAccessibleName(tr("Pairs"));
    m_toggle->setText(tr("&Exclude, or use again"));
    m_remove->setText(tr("&Remove"));
    m_model->retranslate();
    m_tube->retranslate();
    m_entry->retranslate();
    sizeColumns();
    setWhatsThis(tr(
        "<p>Finds the camera inside the tactile cylinder from pairs of a pixel and the surface point that "
        "was probed there.</p><p>Load a CSV file, drop it here, or type pairs in. Wrong pairs are detected "
        "and left out; you can exclude more, remove them (Delete in the table) and undo every step.</p>"));
    showComparison();
    m_verdict->setText(verdict());
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

void CameraCalibrator::askToSave(std::function<void()> done) {
    // The camera as it is now: probing may continue behind the dialog.
    base::askToSave(this, {tr("Save the camera"), {tr("Cameras (*.json)")}, m_file, QStringLiteral("json")},
                    [this, file = cameraFile(), changes = m_changes,
                     done = std::move(done)](const QString& path) { saveCamera(file, path, changes, done); });
}

void CameraCalibrator::open(const QString& path) {
    base::runInBackground(
        this, [path] { return vision::readPairs(path.toStdString()); },
        [this, path, number = ++m_opened](core::Expected<std::vector<CalibrationPair>> pairs) {
            if (!pairs) {
                emit message(QString::fromStdString(core::describe(pairs.error())), true);
                return;
            }
            // Only the last requested file counts, in whatever order they are read.
            if (number != m_opened)
                return;
            m_file = QFileInfo(path).absolutePath();
            setPairs(std::move(*pairs));
            m_undo->setClean();
        });
}

bool CameraCalibrator::isSaved() const {
    return m_undo->isClean() || m_work.pairs.empty();
}

void CameraCalibrator::write(const QString& path, std::uint64_t changes,
                             std::function<core::Expected<void>()> writer,
                             const std::function<void()>& done) {
    base::runInBackground(this, std::move(writer), [this, path, changes, done](core::Expected<void> written) {
        if (!written) {
            emit message(QString::fromStdString(core::describe(written.error())), true);
            return;
        }
        if (changes == m_changes)
            m_undo->setClean();
        emit message(tr("Saved %1").arg(path), false);
        if (done)
            done();
    });
}

std::optional<vision::CameraFile> CameraCalibrator::cameraFile() const {
    const Answer* chosen = answer();
    if (m_fitting || chosen == nullptr || !chosen->calibration)
        return std::nullopt;
    return vision::CameraFile{chosen->calibration->camera, vision::summaryOf(*chosen->calibration)};
}

void CameraCalibrator::save(const QString& path) {
    saveCamera(cameraFile(), path, m_changes);
}

void CameraCalibrator::saveCamera(const std::optional<vision::CameraFile>& file, const QString& path,
                                  std::uint64_t changes, const std::function<void()>& done) {
    if (!file) {
        emit message(tr("The camera was not saved. Wait until it is calibrated."), true);
        return;
    }
    write(
        path, changes, [file = *file, path] { return vision::writeCamera(file, path.toStdString()); }, done);
}

void CameraCalibrator::savePairs(const QString& path) {
    write(path, m_changes,
          [pairs = m_work.pairs, path] { return vision::writePairs(pairs, path.toStdString()); });
}

void CameraCalibrator::edit(Work after, const QString& text, int run) {
    m_undo->push(new Edit(*this, std::move(after), text, run));
}

void CameraCalibrator::apply(const Work& work) {
    ++m_changes;
    const Work before = std::exchange(m_work, work);
    if (m_answers)
        takeAnswers(std::move(*m_answers), before);
    m_tube->setSettings(m_work.settings);
    m_tube->setHoleFactor(m_work.holeFactor);
    followProbing();
    fit();
    refresh();
}

void CameraCalibrator::takeAnswers(Answers answers, const Work& fitted) {
    m_answers.reset();
    for (Answer& one : answers) {
        if (!one.calibration)
            continue;
        one.calibration->residuals = carriedOver(*one.calibration, fitted.onSurface(), m_work.onSurface());
        if (one.calibration->residuals.empty())
            return;
    }
    m_answers = std::move(answers);
}

void CameraCalibrator::setPairs(std::vector<CalibrationPair> pairs) {
    m_probing->cancel();
    m_live->cancel();
    Work after{{}, std::vector<bool>(pairs.size(), true), m_work.settings, false, m_work.holeFactor};
    after.pairs = std::move(pairs);
    edit(std::move(after), tr("loading"));
    sizeColumns();
}

void CameraCalibrator::addPair(const CalibrationPair& pair) {
    Work after = m_work;
    after.add(pair);
    edit(std::move(after), tr("added pair"));
    selectPair(m_work.pairs.size() - 1);
}

void CameraCalibrator::removePairs(const std::vector<std::size_t>& pairs) {
    Work after = m_work;
    if (const int count = after.remove(pairs); count > 0)
        edit(std::move(after), tr("removal of %n pair(s)", nullptr, count));
}

void CameraCalibrator::setUsed(const std::vector<std::size_t>& pairs, bool used) {
    Work after = m_work;
    if (const int count = after.setUsed(pairs, used); count > 0)
        edit(std::move(after),
             used ? tr("use of %n pair(s)", nullptr, count) : tr("exclusion of %n pair(s)", nullptr, count));
}

void CameraCalibrator::setSettings(const vision::CalibrationSettings& settings) {
    Work after = m_work;
    after.settings = settings;
    edit(std::move(after), tr("image and cylinder"));
}

void CameraCalibrator::setHoleFactor(double factor) {
    Work after = m_work;
    after.holeFactor = factor;
    edit(std::move(after), tr("image and cylinder"));
}

std::vector<std::size_t> CameraCalibrator::selectedPairs() const {
    const auto* sorted = static_cast<const QSortFilterProxyModel*>(m_table->model());
    std::vector<std::size_t> pairs;
    for (const QModelIndex& row : m_table->selectionModel()->selectedRows())
        pairs.push_back(static_cast<std::size_t>(sorted->mapToSource(row).row()));
    return pairs;
}

void CameraCalibrator::sizeColumns() {
    m_table->resizeColumnsToContents();
    // Reserves room: pairs are added one by one.
    const QFontMetrics metrics(m_table->font());
    const auto atLeast = [&](int column, const char* text) {
        const int width = metrics.horizontalAdvance(QLatin1String(text)) + base::em(this, 1);
        m_table->setColumnWidth(column, std::max(m_table->columnWidth(column), width));
    };
    atLeast(camera::PairModel::number, "[x] 8888");
    atLeast(camera::PairModel::pixel, "8888.8, 8888.8");
    atLeast(camera::PairModel::point, "-88.88, -88.88, 888.88");
}

void CameraCalibrator::toggle(std::size_t pair) {
    setUsed({pair}, !m_work.used[pair]);
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
    m_again = m_fitting;
    if (m_fitting)
        return;
    if (m_work.pairs.empty()) {
        m_answers.reset();
        return;
    }
    m_fitting = true;
    base::runInBackground(
        this, [work = m_work] { return std::pair(fitAll(work.onSurface(), work.used, work.settings), work); },
        [this](std::pair<Answers, Work> fitted) {
            m_fitting = false;
            takeAnswers(std::move(fitted.first), fitted.second);
            if (m_again)
                fit();
            refresh();
            if (!m_fitting)
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

calibrate::StepReading CameraCalibrator::step() const {
    using calibrate::StepState;
    if (m_probing->isRunning())
        return {.state = StepState::running, .share = m_probedShare};
    if (m_live->isRunning() || m_fitting)
        return {.state = StepState::running};
    const Answer* chosen = answer();
    if (m_work.pairs.empty() || chosen == nullptr)
        return {};
    if (!chosen->calibration)
        return {.state = StepState::failed};
    return {.state = isSaved() ? StepState::done : StepState::notSaved};
}

QString CameraCalibrator::verdict() const {
    if (m_shown.pairs.empty())
        return m_probing->isRunning() || m_live->isRunning()
                   ? tr("Waiting for the first touch.")
                   : tr("Load pairs of pixels and probed points, drop their file here, type them in "
                        "below, or probe a tube.");
    const Answer* chosen = answer();
    if (m_fitting || chosen == nullptr)
        return tr("Calibrating\u2026");
    if (!chosen->calibration)
        return tr("No calibration: %1.").arg(chosen->reason());
    const vision::Calibration& found = *chosen->calibration;
    const auto used = static_cast<int>(std::count(m_shown.used.begin(), m_shown.used.end(), true));
    QString text = tr("%1 of %n pair(s) kept; ", nullptr, used).arg(found.kept);
    text += tr("their points are located to within %1 on average; the camera's uncertainty is %2. ")
                .arg(base::millimetres(found.mean_error_m), base::millimetres(found.uncertainty_m));
    const double diagonal_px = std::hypot(m_work.settings.width_px, m_work.settings.height_px);
    const double valid_px = found.camera.camera().validRadius_px();
    text += valid_px < diagonal_px ? tr("It is valid within %1 of its axis. ").arg(pixels(valid_px))
                                   : tr("It is valid in the whole image. ");
    if (m_method == CalibrationMethod::dlt || m_method == CalibrationMethod::paper)
        return text + tr("This method ignores lens distortion: use it only for comparison.");
    if (found.isReliable())
        return text + tr("The residuals show no pattern, as they should.");
    QStringList cautions;
    for (const vision::CalibrationWarning warning : found.warnings)
        cautions << tr("Caution: %1.").arg(vision::describe(warning, found, m_work.holeFactor));
    return text + cautions.join(QStringLiteral(" "));
}

void CameraCalibrator::refresh() {
    m_shown = {m_work.onSurface(),
               m_work.used,
               {},
               {},
               m_work.settings.surface,
               m_work.settings.width_px,
               m_work.settings.height_px,
               m_live->nextPoint_m()};
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
    const bool settled = found && !m_fitting;
    m_save->setEnabled(settled);
    m_savePairs->setEnabled(!m_work.pairs.empty());
    m_probe->setEnabled(!m_probing->isRunning() && !m_live->isRunning());
    m_probeButton->setDefault(m_work.pairs.empty());
    m_probeWith->setEnabled(m_probe->isEnabled());
    m_tube->setEnabled(m_probe->isEnabled()); // a probing has its own tube and image
    m_origin->setVisible(m_work.simulated);
    base::setTextColour(m_origin, base::statusColours(palette()).simulated);
    const auto used = static_cast<std::size_t>(std::count(m_shown.used.begin(), m_shown.used.end(), true));
    m_exclude->setEnabled(settled && chosen->calibration->kept < used);
    m_verdict->setText(verdict());
    showComparison();
}

void CameraCalibrator::showComparison() {
    for (int row = 0; row < m_comparison->rowCount(); ++row) {
        QStringList cells{m_methods->itemText(row)};
        const Answer* found = m_answers ? &(*m_answers)[static_cast<std::size_t>(row)] : nullptr;
        if (found != nullptr && found->calibration) {
            const vision::Calibration& c = *found->calibration;
            cells << QString::number(c.kept) << pixels(c.mean_px) << base::millimetres(c.mean_error_m)
                  << base::millimetres(c.uncertainty_m) << remark(c);
        } else {
            const QString none = QStringLiteral("\u2014");
            cells << none << none << none << none << (found != nullptr ? found->reason() : QString());
        }
        for (int column = 0; column < cells.size(); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            item->setToolTip(cells[column]);
            if (column > 0 && column < 5)
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_comparison->setItem(row, column, item);
        }
    }
    // The remark takes what is left; its tool tip has all of it.
    for (int column = 0; column < m_comparison->columnCount() - 1; ++column)
        m_comparison->resizeColumnToContents(column);
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
