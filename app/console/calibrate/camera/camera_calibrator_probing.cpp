// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/camera_calibrator.h"
#include "app/console/calibrate/camera/camera_probing.h"
#include "app/console/calibrate/camera/live_probing_dialog.h"
#include "app/console/calibrate/camera/live_probing_panel.h"
#include "app/console/calibrate/camera/probing_strip.h"

#include <utility>
#include <vector>

namespace teleta::console {

void CameraCalibrator::buildProbing() {
    m_probing = new CameraProbing(this);
    m_strip = new ProbingStrip(*m_probing);
    connect(m_probing, &CameraProbing::begun, this, [this](const vision::CalibrationSettings& settings) {
        edit({{}, {}, settings, true}, tr("probing"), ++m_probingRun);
    });
    connect(m_probing, &CameraProbing::taken, this, [this](const vision::CalibrationPair& pair) {
        Work after = m_work;
        after.add(pair);
        edit(std::move(after), tr("probing"), m_probingRun);
    });
    connect(m_probing, &CameraProbing::failed, this,
            [this](const QString& trouble) { emit message(trouble, true); });
    connect(m_probing, &CameraProbing::progressed, this, [this](double share) { m_probedShare = share; });
    connect(m_probing, &CameraProbing::runningChanged, this, [this] {
        m_probedShare = 0.0;
        refresh();
    });
}

void CameraCalibrator::probe(std::uint64_t seed) {
    m_live->cancel();
    m_probing->start(seed);
}

void CameraCalibrator::buildLive() {
    m_live = new LiveProbingPanel;
    connect(m_live, &LiveProbingPanel::begun, this, [this](const vision::CalibrationSettings& settings) {
        m_probed = settings;
        // Pairs of another image or tube, or simulated ones, must not be mixed with the new ones.
        if (!m_work.isJoinedBy(settings))
            edit({{}, {}, settings}, tr("probing"));
    });
    connect(m_live, &LiveProbingPanel::taken, this, [this](const vision::CalibrationPair& pair) {
        Work after = m_work;
        after.put(pair);
        edit(std::move(after), tr("probed hole"));
    });
    connect(m_live, &LiveProbingPanel::failed, this, [this](const QString& why) { emit message(why, true); });
    connect(m_live, &LiveProbingPanel::ended, this,
            [this](const QString& what) { emit message(what, false); });
    connect(m_live, &LiveProbingPanel::holeChanged, this, &CameraCalibrator::refresh);
    connect(m_live, &LiveProbingPanel::runningChanged, this, &CameraCalibrator::refresh);
}

void CameraCalibrator::probeWith(
    const std::function<core::Expected<std::unique_ptr<core::CameraSource>>()>& opener,
    const vision::HoleGrid& grid) {
    m_probing->cancel();
    m_grid = grid;
    m_probed.reset();
    m_live->start(opener, m_work.settings.surface, grid);
    followProbing();
}

void CameraCalibrator::followProbing() {
    if (m_probed && m_live->isRunning() && !m_work.isJoinedBy(*m_probed))
        m_live->cancel();
    m_live->setPairs(m_work.isJoinedBy(m_work.settings) ? m_work.pairs
                                                        : std::vector<vision::CalibrationPair>());
}

void CameraCalibrator::askForCamera() {
    auto* dialog = new LiveProbingDialog(m_camera, m_grid, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        m_camera = dialog->source();
        probeWith(cameraOpener(m_camera, m_work.settings), dialog->grid());
    });
    dialog->open();
}

} // namespace teleta::console
