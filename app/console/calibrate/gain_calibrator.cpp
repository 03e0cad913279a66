// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/gain_calibrator.h"

#include "backend/core/data/frame_file.h"
#include "backend/equilibration/taxel_gain_file.h"
#include "backend/equilibration/unevenness.h"
#include "widgets/base/background.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/on_change.h"
#include "widgets/tactile/heatmap_view.h"
#include "widgets/tactile/tare_question.h"

#include <QAction>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::console {

namespace {

using calibrate::GainCalibration;
using calibrate::GainsView;
using calibrate::Press;
using equilibration::TaxelGains;

/// The gains that a channel already uses, from a file given when its source was opened.
GainCalibration calibrationOf(const pipeline::TouchChannel& channel) {
    const std::vector<float> values = channel.settings().conditioning.taxelGain;
    if (values.empty())
        return {};
    TaxelGains gains;
    gains.layout = channel.description().layout.grid();
    for (const float value : values) {
        const bool good = std::isfinite(value);
        gains.taxels.push_back(
            {.state = good ? equilibration::TaxelState::good : equilibration::TaxelState::dead,
             .gain = static_cast<double>(value),
             .error = good ? 0.0 : std::nan("")});
    }
    return {{}, std::make_shared<const TaxelGains>(std::move(gains))};
}

core::Expected<GainCalibration> withGains(std::vector<Press> presses, const core::ArrayLayout& layout) {
    std::vector<equilibration::GainPress> all;
    all.reserve(presses.size());
    for (const Press& press : presses)
        all.push_back({press->frames, press->conditioning});
    TELETA_TRY(auto gains, equilibration::findTaxelGains(layout, all));
    return GainCalibration{std::move(presses), std::make_shared<const TaxelGains>(std::move(gains))};
}

} // namespace

GainCalibrator::GainCalibrator(SourceManager& sources, QWidget* parent)
    : QObject(parent)
    , m_sources(sources)
    , m_view(new GainsView(parent))
    , m_live(new tactile::HeatmapView(m_view)) {
    m_live->setObjectName(QStringLiteral("liveLoads"));
    using tactile::Overlay;
    for (const Overlay of :
         {Overlay::contacts, Overlay::centreOfPressure, Overlay::centreOfContact, Overlay::principalAxis})
        m_live->overlayAction(of)->setChecked(false);
    m_live->overlayAction(Overlay::values)->setChecked(true);
    m_view->setLivePicture(m_live);
    retranslate();
    base::onChange(m_view, [this] { retranslate(); }, {QEvent::LanguageChange});
    connect(m_live, &tactile::HeatmapView::exportFailed, m_view, &GainsView::exportFailed);
    connect(&m_sources, &SourceManager::activeChanged, this, &GainCalibrator::onActiveChanged);
    connect(&m_sources, &SourceManager::itemsChanged, this, &GainCalibrator::onActiveChanged);
    connect(&m_sources, &SourceManager::closed, this,
            [this](pipeline::ChannelKey closed) { m_left.erase(closed); });
    connect(m_view, &GainsView::calibrationChanged, this, [this](const GainCalibration& calibration) {
        if (m_channel)
            m_channel->setTaxelGain(calibration.gains ? calibration.gains->values() : std::vector<float>());
    });
    connect(m_view, &GainsView::tareRequested, this, [this] {
        if (m_channel)
            tactile::askToTare(
                m_view,
                tactile::loadedTaxels(m_channel->snapshot(), m_channel->settings().features.threshold_N),
                [channel = m_channel] { channel->requestTare(); });
    });
    connect(m_view, &GainsView::collectRequested, this, &GainCalibrator::collect);
    connect(m_view, &GainsView::endRequested, this, &GainCalibrator::endCollecting);
    connect(m_view, &GainsView::pressFilesRequested, this, [this] {
        base::askToOpenSeveral(m_view, {tr("Open recorded presses"), {tr("Frames (*.csv)")}},
                               [this](const QStringList& paths) { openPresses(paths); });
    });
    connect(m_view, &GainsView::loadRequested, this, [this] {
        base::askToOpen(m_view, {tr("Load gains"), {tr("Gains (*.csv)")}},
                        [this](const QString& path) { load(path); });
    });
    connect(m_view, &GainsView::saveRequested, this, [this] { askToSave(); });
    connect(m_view, &GainsView::demoRequested, this, &GainCalibrator::demoRequested);
    connect(m_view, &GainsView::exportFailed, this, [this](const QString& message) {
        emit trouble(message, tr("Choose another folder or file name."));
    });
    onActiveChanged();
}

void GainCalibrator::onActiveChanged() {
    const SourceManager::Item* item = m_sources.active();
    auto channel = item != nullptr ? item->array() : nullptr;
    // The gains of taxels are those of a grid of loads.
    if (channel != nullptr &&
        (!channel->description().layout.isGrid() || channel->description().layout.isVector()))
        channel = nullptr;
    const bool isArray = channel != nullptr;
    const pipeline::ChannelKey key = isArray ? item->key : 0;
    if (key == m_key && (m_channel != nullptr) == isArray)
        return;
    m_collector.reset();
    m_view->setProgress(std::nullopt);
    m_view->setBusy(false);
    if (m_channel && m_sources.find(m_key) != nullptr)
        m_left.insert_or_assign(m_key, Left{m_view->calibration(), m_view->isSaved()});
    m_key = key;
    m_channel = std::move(channel);
    ++m_round;
    if (const auto left = m_left.find(m_key); m_channel && left != m_left.end())
        m_view->setCalibration(left->second.calibration, left->second.isSaved);
    else
        m_view->setCalibration(m_channel ? calibrationOf(*m_channel) : GainCalibration());
    tick();
}

bool GainCalibrator::isSaved() const {
    return m_view->isSaved() && std::ranges::all_of(m_left, [this](const auto& left) {
               return left.first == m_key || left.second.isSaved;
           });
}

bool GainCalibrator::isSaved(pipeline::ChannelKey key) const {
    if (isShown(key))
        return m_view->isSaved();
    const auto left = m_left.find(key);
    return left == m_left.end() || left->second.isSaved;
}

void GainCalibrator::tick() {
    if (m_collector) {
        m_collector->update();
        m_view->setProgress(calibrate::PressProgress{.waiting = m_collector->isWaiting(),
                                                     .collected_s = m_collector->collected_s(),
                                                     .wanted_s = PressCollector::kWanted_s});
        if (m_collector->isComplete())
            endCollecting();
    }
    calibrate::ArrayFacts facts;
    std::optional<equilibration::Unevenness> unevenness;
    const pipeline::TouchSnapshot* snapshot = nullptr; // of an array that is seen
    const SourceManager::Item* item = m_sources.find(m_key);
    if (m_channel && item != nullptr) {
        facts.name = item->name;
        facts.simulated = m_channel->description().simulated;
        facts.recorded = m_channel->description().recorded;
        if (m_view->isVisible()) {
            const pipeline::ChannelSettings settings = m_channel->settings();
            facts.tared = !settings.conditioning.tare.empty();
            snapshot = &m_channel->snapshot();
            const double threshold_N = settings.features.threshold_N;
            const tactile::LoadedTaxels taxels = tactile::loadedTaxels(*snapshot, threshold_N);
            facts.usable = taxels.usable;
            facts.loaded = taxels.loaded;
            if (2 * taxels.loaded > taxels.usable) // as for a press
                unevenness =
                    equilibration::unevenness(snapshot->load_N, settings.conditioning.taxelGain, threshold_N);
        }
    }
    m_view->setFacts(facts);
    m_view->setUnevenness(unevenness);
    m_live->setProvenance(facts.simulated  ? base::Provenance::simulated
                          : facts.recorded ? base::Provenance::recorded
                                           : base::Provenance::live);
    showFrame(snapshot);
}

void GainCalibrator::showFrame(const pipeline::TouchSnapshot* snapshot) {
    const std::pair shown(m_key, snapshot != nullptr ? snapshot->framesProcessed : 0);
    if (std::exchange(m_shown, shown) == shown)
        return;
    if (snapshot != nullptr)
        m_live->setSnapshot(*snapshot);
    else
        m_live->clear();
}

void GainCalibrator::retranslate() {
    m_live->setEmptyText(tr("The loads of the array will be shown here."));
}

void GainCalibrator::collect() {
    if (m_channel && !m_collector)
        m_collector = std::make_unique<PressCollector>(m_channel);
    tick();
}

void GainCalibrator::endCollecting() {
    if (!m_collector)
        return;
    m_collector->update();
    auto press = std::make_shared<const calibrate::RecordedPress>(
        calibrate::RecordedPress{m_collector->takeFrames(), m_collector->conditioning()});
    m_collector.reset();
    m_view->setProgress(std::nullopt);
    std::vector<Press> presses = m_view->calibration().presses;
    presses.push_back(std::move(press));
    find([presses = std::move(presses), layout = m_channel->description().layout.grid()]() mutable {
        return withGains(std::move(presses), layout);
    });
}

void GainCalibrator::openPresses(const QStringList& paths) {
    if (!m_channel)
        return;
    find([paths, presses = m_view->calibration().presses, layout = m_channel->description().layout.grid(),
          settings = m_channel->settings().conditioning]() mutable -> Found {
        for (const QString& path : paths) {
            TELETA_TRY(auto press, core::readFrames(path.toStdString(), layout));
            presses.push_back(std::make_shared<const calibrate::RecordedPress>(
                calibrate::RecordedPress{std::move(press), settings}));
        }
        return withGains(std::move(presses), layout);
    });
}

void GainCalibrator::load(const QString& path) {
    if (!m_channel)
        return;
    find([path, layout = m_channel->description().layout.grid()]() -> Found {
        TELETA_TRY(auto gains, equilibration::readTaxelGains(path.toStdString(), layout));
        return GainCalibration{{}, std::make_shared<const TaxelGains>(std::move(gains))};
    });
}

void GainCalibrator::find(std::function<Found()> work) {
    m_view->setBusy(true);
    base::runInBackground(this, std::move(work), [this, round = m_round](const Found& found) {
        // Another array may have been chosen meanwhile.
        if (round != m_round)
            return;
        m_view->setBusy(false);
        if (found)
            m_view->take(*found);
        else
            m_view->showTrouble(QString::fromStdString(core::describe(found.error())));
    });
}

void GainCalibrator::askToSave(std::function<void()> done) {
    base::askToSave(
        m_view,
        {.title = tr("Save the gains"), .filters = {tr("Gains (*.csv)")}, .suffix = QStringLiteral("csv")},
        [this, done = std::move(done)](const QString& path) { save(path, done); });
}

void GainCalibrator::save(const QString& path, const std::function<void()>& done) {
    const GainCalibration calibration = m_view->calibration();
    if (!calibration.gains)
        return;
    base::runInBackground(
        this,
        [gains = calibration.gains, path] {
            return equilibration::writeTaxelGains(*gains, path.toStdString());
        },
        [this, path, done, gains = calibration.gains](const core::Expected<void>& written) {
            if (!written) {
                emit trouble(tr("%1 could not be saved.", "a file").arg(QFileInfo(path).fileName()),
                             QString::fromStdString(core::describe(written.error())));
                return;
            }
            if (gains == m_view->calibration().gains)
                m_view->markSaved();
            if (done)
                done();
        });
}

} // namespace teleta::console
