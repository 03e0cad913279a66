// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/tube_fields.h"

#include "widgets/base/compose.h"
#include "widgets/base/theme.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

namespace teleta::console {

namespace {
/// Of a usual length; the longest would leave too little room in a narrow window.
constexpr double kLength_em = 6.0;
} // namespace

TubeFields::TubeFields(QWidget* parent)
    : QWidget(parent)
    , m_imageLabel(new QLabel(this))
    , m_radiusLabel(new QLabel(this))
    , m_lengthLabel(new QLabel(this))
    , m_holeLabel(new QLabel(this))
    , m_width(base::named<QSpinBox>("width", this))
    , m_height(base::named<QSpinBox>("height", this))
    , m_radius(base::named<QDoubleSpinBox>("radius", this))
    , m_length(base::named<QDoubleSpinBox>("length", this))
    , m_holeFactor(base::named<QDoubleSpinBox>("holeFactor", this)) {
    for (QSpinBox* box : {m_width, m_height}) {
        box->setRange(1, vision::kLargestSide_px);
        box->setSuffix(QStringLiteral("\u00a0px"));
        box->setKeyboardTracking(false);
        connect(box, &QSpinBox::valueChanged, this, &TubeFields::tell);
    }
    for (QDoubleSpinBox* box : {m_radius, m_length}) {
        box->setRange(0.1, 10'000.0);
        box->setMinimumWidth(base::em(this, kLength_em));
        box->setDecimals(2);
        box->setSuffix(QStringLiteral("\u00a0mm"));
        box->setKeyboardTracking(false);
        connect(box, &QDoubleSpinBox::valueChanged, this, &TubeFields::tell);
    }
    m_holeFactor->setRange(0.1, 10.0);
    m_holeFactor->setDecimals(4);
    m_holeFactor->setSingleStep(0.01);
    m_holeFactor->setKeyboardTracking(false);
    m_holeFactor->setValue(1.0);
    connect(m_holeFactor, &QDoubleSpinBox::valueChanged, this, &TubeFields::holeFactorChanged);
    m_holeLabel->setBuddy(m_holeFactor);
    m_imageLabel->setBuddy(m_width);
    m_radiusLabel->setBuddy(m_radius);
    m_lengthLabel->setBuddy(m_length);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_imageLabel);
    row->addWidget(m_width);
    row->addWidget(new QLabel(QStringLiteral("\u00d7"), this));
    row->addWidget(m_height);
    row->addSpacing(base::grid(this));
    row->addWidget(m_radiusLabel);
    row->addWidget(m_radius);
    row->addSpacing(base::grid(this));
    row->addWidget(m_lengthLabel);
    row->addWidget(m_length);
    row->addSpacing(base::grid(this));
    row->addWidget(m_holeLabel);
    row->addWidget(m_holeFactor);
    setSettings({});
    retranslate();
}

void TubeFields::setSettings(const vision::CalibrationSettings& settings) {
    m_settings = settings;
    const QSignalBlocker quiet(this);
    const QSignalBlocker width(m_width);
    const QSignalBlocker height(m_height);
    const QSignalBlocker radius(m_radius);
    const QSignalBlocker length(m_length);
    m_width->setValue(settings.width_px);
    m_height->setValue(settings.height_px);
    m_radius->setValue(1e3 * settings.surface.radius_m);
    m_length->setValue(1e3 * settings.surface.highest_z_m);
}

void TubeFields::setHoleFactor(double factor) {
    const QSignalBlocker quiet(m_holeFactor);
    m_holeFactor->setValue(factor);
}

void TubeFields::tell() {
    m_settings.width_px = m_width->value();
    m_settings.height_px = m_height->value();
    m_settings.surface.radius_m = 1e-3 * m_radius->value();
    m_settings.surface.highest_z_m = 1e-3 * m_length->value();
    emit changed(m_settings);
}

void TubeFields::retranslate() {
    m_imageLabel->setText(tr("&Image:"));
    m_radiusLabel->setText(tr("Ra&dius:"));
    m_lengthLabel->setText(tr("Len&gth:"));
    m_holeLabel->setText(tr("H&ole factor:"));
    m_width->setAccessibleName(tr("Width of the image"));
    m_height->setAccessibleName(tr("Height of the image"));
    m_width->setToolTip(tr("Width of the image that the pixels refer to"));
    m_height->setToolTip(tr("Height of the image that the pixels refer to"));
    m_radius->setAccessibleName(tr("Radius of the tactile cylinder"));
    m_length->setAccessibleName(tr("Length of the tactile cylinder"));
    m_radius->setToolTip(tr("Radius of the surface that the points lie on"));
    m_holeFactor->setAccessibleName(tr("Factor from the holes of a shell to the tactile cylinder"));
    m_holeFactor->setToolTip(tr("For points that are holes of a shell: x and y times this factor lie on the "
                                "elastomer (0.97 for the shell in the paper)"));
    m_length->setToolTip(tr("Length of the surface, from z = 0 of the sensor's frame"));
}

} // namespace teleta::console
