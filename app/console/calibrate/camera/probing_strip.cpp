// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/probing_strip.h"

#include "widgets/base/compose.h"
#include "widgets/base/theme.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

namespace teleta::console {

ProbingStrip::ProbingStrip(CameraProbing& probing, QWidget* parent)
    : QWidget(parent)
    , m_probing(probing)
    , m_progress(new QProgressBar(this))
    , m_stop(base::named<QPushButton>("stop", this)) {
    m_progress->setRange(0, 1000);
    m_stop->setAutoDefault(false);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(base::grid(this), 0, base::grid(this), 0);
    row->addWidget(m_progress, 1);
    row->addWidget(m_stop);
    connect(m_stop, &QPushButton::clicked, &m_probing, &CameraProbing::cancel);
    connect(&m_probing, &CameraProbing::runningChanged, this, [this](bool running) {
        m_pairs = 0;
        m_progress->setValue(0);
        retranslate();
        setVisible(running);
    });
    connect(&m_probing, &CameraProbing::taken, this, [this] {
        ++m_pairs;
        retranslate();
    });
    connect(&m_probing, &CameraProbing::progressed, this,
            [this](double share) { m_progress->setValue(static_cast<int>(1000.0 * share)); });
    retranslate();
    hide();
}

void ProbingStrip::retranslate() {
    m_progress->setAccessibleName(tr("Progress of the probing"));
    m_progress->setFormat(tr("SIMULATED: a person probes the tube; pairs so far: %1").arg(m_pairs));
    m_stop->setText(tr("Sto&p probing"));
    m_stop->setToolTip(tr("Keep the pairs collected so far"));
}

} // namespace teleta::console
