// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/live_probing_panel.h"

#include "widgets/base/compose.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/camera/camera_view.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace teleta::console {

using Phase = vision::PairCollector::Phase;

LiveProbingPanel::LiveProbingPanel(QWidget* parent)
    : QWidget(parent)
    , m_picture(new camera::CameraView(this))
    , m_next(new QLabel(this))
    , m_state(new QLabel(this))
    , m_progress(new QProgressBar(this))
    , m_back(base::named<QPushButton>("back", this))
    , m_skip(base::named<QPushButton>("skip", this))
    , m_reference(new QPushButton(this))
    , m_stop(base::named<QPushButton>("stop", this)) {
    m_picture->setFixedSize(base::em(this, 26), base::em(this, 15));
    m_next->setFont(base::bold(base::sized(font(), base::kLargeText)));
    m_state->setWordWrap(true);
    m_progress->setRange(0, 100);
    m_progress->setTextVisible(false);
    m_progress->setMaximumWidth(base::em(this, 24));
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {m_back, m_skip, m_reference, m_stop}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    auto* words = new QVBoxLayout;
    words->addStretch(1);
    words->addWidget(m_next);
    words->addWidget(m_state);
    words->addWidget(m_progress);
    words->addLayout(buttons);
    words->addStretch(1);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(base::grid(this), 0, base::grid(this), 0);
    row->setSpacing(2 * base::grid(this));
    row->addWidget(m_picture);
    row->addLayout(words, 1);

    connect(m_back, &QPushButton::clicked, this, &LiveProbingPanel::back);
    connect(m_skip, &QPushButton::clicked, this, &LiveProbingPanel::skip);
    connect(m_reference, &QPushButton::clicked, &m_probing, &LiveProbing::renewReference);
    connect(m_stop, &QPushButton::clicked, &m_probing, &LiveProbing::cancel);
    connect(m_picture, &camera::CameraView::pauseRequested, m_picture, &camera::CameraView::setPaused);
    connect(&m_probing, &LiveProbing::begun, this, &LiveProbingPanel::begun);
    connect(&m_probing, &LiveProbing::failed, this, &LiveProbingPanel::failed);
    connect(&m_probing, &LiveProbing::touched, this, &LiveProbingPanel::take);
    connect(&m_probing, &LiveProbing::ended, this, [this] { emit ended(tr("The video is over.")); });
    connect(&m_probing, &LiveProbing::trouble, this, [this](const QString& why) {
        m_trouble = why;
        refresh();
    });
    connect(&m_probing, &LiveProbing::seen, this, [this](const ProbingView& view) {
        m_view = view;
        m_picture->setProvenance(view.recorded ? base::Provenance::recorded : base::Provenance::live);
        m_picture->setSnapshot(&m_view.snapshot);
        refresh();
    });
    connect(&m_probing, &LiveProbing::runningChanged, this, [this](bool running) {
        setVisible(running);
        refresh();
        emit runningChanged(running);
    });
    base::keepTranslated(this, &LiveProbingPanel::retranslate);
    hide();
}

void LiveProbingPanel::start(LiveProbing::Opener opener, const vision::CylinderSurface& surface,
                             const vision::HoleGrid& grid) {
    m_grid = grid;
    m_holes_m = holesOnSkin_m(grid, surface);
    m_probed.assign(m_holes_m.size(), false);
    m_hole = 0;
    m_view = {};
    m_trouble.clear();
    m_picture->setSnapshot(nullptr);
    m_picture->setPaused(false);
    m_probing.start(std::move(opener), surface);
    emit holeChanged();
}

void LiveProbingPanel::setPairs(std::span<const vision::CalibrationPair> pairs) {
    const std::size_t before = m_hole;
    std::optional<std::size_t> takenBack;
    bool filled = false; // the next hole
    for (std::size_t i = 0; i < m_holes_m.size(); ++i) {
        const bool probed = std::ranges::any_of(
            pairs, [&](const vision::CalibrationPair& pair) { return pair.p_Sensor_m == m_holes_m[i]; });
        if (m_probed[i] && !probed && !takenBack)
            takenBack = i;
        filled |= i == m_hole && probed && !m_probed[i];
        m_probed[i] = probed;
    }
    if (takenBack)
        m_hole = *takenBack;
    else if (filled)
        m_hole = unprobedFrom(m_hole);
    if (m_hole != before && !m_taking)
        m_probing.awaitLift();
    refresh();
    if (m_hole != before)
        emit holeChanged();
}

std::size_t LiveProbingPanel::unprobedFrom(std::size_t hole) const {
    for (std::size_t step = 0; step < m_probed.size(); ++step) {
        const std::size_t at = (hole + step) % m_probed.size();
        if (!m_probed[at])
            return at;
    }
    return m_probed.size();
}

void LiveProbingPanel::take(const Eigen::Vector2d& pixel) {
    if (m_hole >= m_holes_m.size())
        return;
    const std::size_t hole = m_hole;
    m_taking = true;
    emit taken({pixel, m_holes_m[hole]});
    m_taking = false;
    // A hole was probed again: setPairs() saw no change.
    if (m_hole == hole)
        goTo(unprobedFrom(hole + 1));
    if (m_hole >= m_holes_m.size()) {
        m_probing.cancel();
        emit ended(tr("All holes are probed."));
    }
}

void LiveProbingPanel::leaveFor(std::size_t hole) {
    if (hole != m_hole)
        m_probing.awaitLift();
    goTo(hole);
}

void LiveProbingPanel::goTo(std::size_t hole) {
    if (hole == m_hole)
        return;
    m_hole = hole;
    refresh();
    emit holeChanged();
}

void LiveProbingPanel::skip() {
    if (!m_holes_m.empty())
        leaveFor((m_hole + 1) % m_holes_m.size());
}

void LiveProbingPanel::back() {
    if (!m_holes_m.empty())
        leaveFor((std::min(m_hole, m_holes_m.size()) + m_holes_m.size() - 1) % m_holes_m.size());
}

std::optional<Eigen::Vector3d> LiveProbingPanel::nextPoint_m() const {
    return isRunning() && m_hole < m_holes_m.size() ? std::optional(m_holes_m[m_hole]) : std::nullopt;
}

QString LiveProbingPanel::holeText() const {
    if (m_hole >= m_holes_m.size())
        return tr("All holes are probed");
    const double angle_deg = m_grid.angle_rad(m_hole) * 180.0 / std::numbers::pi;
    return tr("Hole %1 of %2: ring %3, %4\u00a0mm, %5\u00b0")
        .arg(m_hole + 1)
        .arg(m_holes_m.size())
        .arg(m_grid.ring(m_hole) + 1)
        .arg(base::threeDigits(1e3 * m_grid.z_m(m_hole)).trimmed(), base::wholeNumber(angle_deg).trimmed());
}

QString LiveProbingPanel::stateText() const {
    if (!m_trouble.isEmpty())
        return tr("Waiting for the camera: %1").arg(m_trouble);
    if (m_view.snapshot.image.isEmpty())
        return tr("Waiting for the first frame. Nothing may touch the skin.");
    if (!m_view.snapshot.hasReference)
        return tr("Waiting for a frame in which nothing touches the skin: %1")
            .arg(QString::fromStdString(m_view.snapshot.problem));
    if (!m_view.snapshot.problem.empty())
        return QString::fromStdString(m_view.snapshot.problem);
    switch (m_view.phase) {
    case Phase::free:
        return tr("Press the stick into this hole.");
    case Phase::touching:
        return tr("Hold still.");
    case Phase::several:
        return tr("The skin is touched in several places. Remove everything but the stick.");
    case Phase::taken:
        return tr("Taken. Lift the stick.");
    case Phase::refused:
        return tr("Lift the stick first.");
    }
    return {};
}

void LiveProbingPanel::refresh() {
    m_next->setText(holeText());
    m_state->setText(stateText());
    m_progress->setValue(static_cast<int>(std::lround(100.0 * m_view.progress)));
}

void LiveProbingPanel::retranslate() {
    m_progress->setAccessibleName(tr("How long the stick has been held still"));
    m_picture->setAccessibleName(tr("What the camera sees"));
    m_back->setText(tr("Bac&k"));
    m_back->setToolTip(tr("Back to the previous hole. Probing it again replaces its pixel"));
    m_skip->setText(tr("Sk&ip"));
    m_skip->setToolTip(tr("Skip this hole for now"));
    m_reference->setText(tr("Ne&w reference"));
    m_reference->setToolTip(tr("Take the next frame as the reference: nothing may touch the skin"));
    m_stop->setText(tr("Sto&p probing"));
    m_stop->setToolTip(tr("Keep the pairs collected so far"));
    refresh();
}

} // namespace teleta::console
