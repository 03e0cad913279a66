// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/gel/gel_panel.h"

#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/camera/gel/gel_view.h"
#include "widgets/camera/reaction_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace teleta::camera {

GelPanel::GelPanel(QWidget* parent)
    : QWidget(parent)
    , m_arrows(new QCheckBox(this))
    , m_enlargementName(new QLabel(this))
    , m_enlargement(new QComboBox(this))
    , m_reference(new QPushButton(this))
    , m_pause(new QToolButton(this))
    , m_problem(new QLabel(this))
    , m_counts(new QLabel(this))
    , m_arm(new ReactionRow(this))
    , m_view(new GelView(this)) {
    m_arrows->setObjectName(QStringLiteral("gelArrows"));
    m_enlargement->setObjectName(QStringLiteral("gelEnlargement"));
    m_reference->setObjectName(QStringLiteral("gelReference"));
    m_pause->setObjectName(QStringLiteral("gelPause"));
    m_problem->setObjectName(QStringLiteral("problem"));
    m_counts->setObjectName(QStringLiteral("gelCounts"));
    m_arrows->setChecked(true);
    m_pause->setCheckable(true);
    m_problem->setWordWrap(true);
    m_counts->setWordWrap(true);
    for (const int factor : {1, 2, 4, 8, 16})
        m_enlargement->addItem(QStringLiteral("\u00d7 %1").arg(factor), factor);
    m_enlargement->setCurrentIndex(m_enlargement->findData(static_cast<int>(m_view->picture().enlargement)));
    m_enlargementName->setBuddy(m_enlargement);

    const int margin = base::grid(this);
    auto* tools = new QHBoxLayout;
    tools->setSpacing(margin);
    tools->addWidget(m_arrows);
    tools->addWidget(m_enlargementName);
    tools->addWidget(m_enlargement);
    tools->addStretch(1);
    tools->addWidget(m_reference);
    tools->addWidget(m_pause);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, margin / 2, margin, margin / 2);
    layout->setSpacing(margin / 2);
    layout->addLayout(tools);
    layout->addWidget(m_problem);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_arm);
    layout->addWidget(m_counts);
    setFocusProxy(m_view);

    connect(m_arrows, &QCheckBox::toggled, m_view, &GelView::setArrowsShown);
    connect(m_enlargement, &QComboBox::currentIndexChanged, this,
            [this] { m_view->setEnlargement(m_enlargement->currentData().toDouble()); });
    connect(m_arm, &ReactionRow::mayReactChanged, this, &GelPanel::mayReactChanged);
    connect(m_reference, &QPushButton::clicked, this, &GelPanel::referenceRequested);
    connect(m_view, &GelView::referenceRequested, this, &GelPanel::referenceRequested);
    connect(m_pause, &QToolButton::toggled, this, &GelPanel::setPaused);
    connect(m_view, &GelView::pauseRequested, this, &GelPanel::setPaused);
    connect(m_view, &GelView::exportFailed, this, &GelPanel::exportFailed);
    base::keepTranslated(this, &GelPanel::retranslate);
    setSnapshot(nullptr);
    base::onChange(this, &GelPanel::showTexts, {QEvent::PaletteChange});
}

void GelPanel::setSnapshot(const pipeline::GelSnapshot* snapshot) {
    m_view->setSnapshot(snapshot);
    m_hasGel = snapshot != nullptr;
    setEnabled(m_hasGel);
    m_arm->set(m_hasGel ? snapshot->carrier : std::nullopt, m_hasGel && snapshot->mayReact);
    if (snapshot == nullptr) {
        m_why.clear();
        m_work_ms.update(std::nullopt);
        m_rate_Hz.update(std::nullopt);
        setPaused(false);
    } else {
        m_why = QString::fromStdString(snapshot->problem);
        m_hasReference = snapshot->hasReference();
        m_usable = snapshot->usable;
        m_missing = snapshot->missing;
        m_markers = snapshot->markers.size();
        m_found = static_cast<std::size_t>(
            std::ranges::count_if(snapshot->motions, [](const auto& motion) { return motion.found; }));
        m_passedOver = snapshot->passedOver;
        m_unusable = snapshot->unusable;
        m_work_ms.update(1e-6 * static_cast<double>(snapshot->work_ns));
        m_rate_Hz.update(snapshot->processed_Hz);
    }
    showTexts();
}

void GelPanel::setProvenance(base::Provenance provenance) {
    m_view->setProvenance(provenance);
}

bool GelPanel::isPaused() const {
    return m_pause->isChecked();
}

void GelPanel::setPaused(bool paused) {
    const QSignalBlocker blocked(m_pause);
    m_pause->setChecked(paused);
    m_pause->setText(paused ? tr("Resume") : tr("Pause"));
    m_view->setPaused(paused);
}

QString GelPanel::counts() const {
    if (!m_hasGel || !m_hasReference)
        return {};
    QStringList parts;
    parts << tr("%1 of %2 markers").arg(m_found).arg(m_markers);
    parts << tr("%1 ms per frame, %2 frames/s").arg(m_work_ms.text().trimmed(), m_rate_Hz.text().trimmed());
    parts << tr("%n skipped", nullptr, static_cast<int>(m_passedOver));
    if (m_unusable > 0)
        parts << tr("%n unusable", nullptr, static_cast<int>(m_unusable));
    return parts.join(QStringLiteral(" \u00b7 "));
}

void GelPanel::showTexts() {
    const base::StatusColours& colours = base::statusColours(palette());
    QString problem;
    if (m_hasGel && !m_why.isEmpty())
        problem = m_why;
    else if (m_hasGel && m_missing > 0)
        problem = tr("Taking the gel at rest: nothing may touch it (%n more picture(s)).", nullptr,
                     static_cast<int>(m_missing));
    m_problem->setText(problem);
    m_problem->setToolTip(problem); // where a low dock cuts it
    m_problem->setVisible(!problem.isEmpty());
    base::setTextColour(m_problem, m_why.isEmpty() ? palette().color(QPalette::WindowText)
                                   : m_usable      ? colours.stale
                                                   : colours.lost);
    m_counts->setText(counts());
}

void GelPanel::retranslate() {
    m_arrows->setText(tr("&Displacement"));
    m_arrows->setToolTip(tr("Show how far each marker has moved from its place at rest"));
    m_enlargementName->setText(tr("&Enlarged"));
    m_enlargement->setAccessibleName(tr("Enlargement of the arrows"));
    m_enlargement->setToolTip(tr("How many times longer than the displacement the arrows are"));
    m_reference->setText(tr("Ne&w rest"));
    m_reference->setToolTip(tr("Take the next pictures as the gel at rest: nothing may touch it"));
    m_pause->setText(m_pause->isChecked() ? tr("Resume") : tr("Pause"));
    m_pause->setToolTip(tr("Freeze the picture; markers are still followed (Space)"));
    showTexts();
}

} // namespace teleta::camera
