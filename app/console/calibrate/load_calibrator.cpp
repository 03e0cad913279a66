// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/load_calibrator.h"

#include "backend/core/data/csv_reader.h"
#include "backend/core/failure.h"
#include "backend/equilibration/load_calibration_file.h"
#include "widgets/base/background.h"
#include "widgets/base/file_dialog.h"

#include <QFileInfo>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace teleta::console {

namespace {

using calibrate::LoadsFound;
using calibrate::PressTable;
using equilibration::LoadCalibration;

core::Expected<PressTable> tableOf(const QString& path) {
    TELETA_TRY(const auto csv, core::CsvReader::open(path.toStdString()));
    PressTable table{.name = QFileInfo(path).fileName()};
    for (const std::string& column : csv.header()) {
        const bool isLoad =
            std::ranges::find(equilibration::kLoadColumns, column) != equilibration::kLoadColumns.end();
        (isLoad ? table.loads : table.columns) << QString::fromStdString(column);
    }
    if (table.loads.isEmpty())
        return core::failed(core::ErrorKind::badInput, LoadCalibrator::tr("the table has no load"),
                            LoadCalibrator::tr("a column force_n, shear_x_n, shear_y_n or moment_nm"),
                            {path.toStdString()});
    return table;
}

} // namespace

LoadCalibrator::LoadCalibrator(QWidget* parent)
    : QObject(parent)
    , m_view(new calibrate::LoadsView(parent)) {
    using calibrate::LoadsView;
    connect(m_view, &LoadsView::pressesRequested, this, [this] {
        base::askToOpen(m_view, {tr("Open presses with a known load"), {tr("Presses (*.csv)")}},
                        [this](const QString& path) { openPresses(path); });
    });
    connect(m_view, &LoadsView::fitRequested, this, &LoadCalibrator::fit);
    connect(m_view, &LoadsView::loadRequested, this, [this] {
        base::askToOpen(m_view, {tr("Load a calibration"), {tr("Calibrations (*.csv)")}},
                        [this](const QString& path) { load(path); });
    });
    connect(m_view, &LoadsView::saveRequested, this, [this] { askToSave(); });
}

void LoadCalibrator::showTrouble(const core::Error& error) {
    m_view->showTrouble(QString::fromStdString(core::describe(error)));
}

void LoadCalibrator::openPresses(const QString& path) {
    m_view->setBusy(true);
    base::runInBackground(
        this, [path] { return tableOf(path); },
        [this, path](const core::Expected<PressTable>& table) {
            m_view->setBusy(false);
            if (!table) {
                showTrouble(table.error());
                return;
            }
            m_path = path;
            m_view->setTable(*table);
        });
}

void LoadCalibrator::fit(const QStringList& columns) {
    std::vector<std::string> channels;
    for (const QString& column : columns)
        channels.push_back(column.toStdString());
    find(
        [path = m_path.toStdString(), channels]() -> core::Expected<LoadCalibration> {
            TELETA_TRY(const auto presses, equilibration::readKnownPresses(path, channels));
            return equilibration::findLoadCalibration(presses);
        },
        false);
}

void LoadCalibrator::load(const QString& path) {
    find([path] { return equilibration::readLoadCalibration(path.toStdString()); }, true);
}

void LoadCalibrator::find(std::function<core::Expected<LoadCalibration>()> work, bool isSaved) {
    m_view->setBusy(true);
    base::runInBackground(this, std::move(work),
                          [this, isSaved](const core::Expected<LoadCalibration>& found) {
                              m_view->setBusy(false);
                              if (!found) {
                                  showTrouble(found.error());
                                  return;
                              }
                              m_view->take(std::make_shared<const LoadCalibration>(*found));
                              if (isSaved)
                                  m_view->markSaved();
                          });
}

void LoadCalibrator::askToSave(std::function<void()> done) {
    base::askToSave(m_view,
                    {.title = tr("Save the calibration"),
                     .filters = {tr("Calibrations (*.csv)")},
                     .suffix = QStringLiteral("csv")},
                    [this, done = std::move(done)](const QString& path) { save(path, done); });
}

void LoadCalibrator::save(const QString& path, const std::function<void()>& done) {
    const LoadsFound found = m_view->found();
    if (!found)
        return;
    base::runInBackground(
        this, [found, path] { return equilibration::writeLoadCalibration(*found, path.toStdString()); },
        [this, path, done, found](const core::Expected<void>& written) {
            if (!written) {
                emit trouble(tr("%1 could not be saved.", "a file").arg(QFileInfo(path).fileName()),
                             QString::fromStdString(core::describe(written.error())));
                return;
            }
            if (found == m_view->found())
                m_view->markSaved();
            if (done)
                done();
        });
}

} // namespace teleta::console
