// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/live_probing_dialog.h"

#include "devices/camera/camera_device.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <numbers>

namespace teleta::console {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr int kMostHoles = 1000; ///< per ring; also the most rings

} // namespace

LiveProbingDialog::LiveProbingDialog(const QString& last, const vision::HoleGrid& grid, QWidget* parent,
                                     const CameraSourceField::Lister& cameras)
    : QDialog(parent)
    , m_source(new CameraSourceField(last, cameras))
    , m_around(new QSpinBox)
    , m_along(new QSpinBox)
    , m_first(new QDoubleSpinBox)
    , m_last(new QDoubleSpinBox)
    , m_angle(new QDoubleSpinBox) {
    setWindowTitle(tr("Probe with a camera"));
    for (QSpinBox* box : {m_around, m_along})
        box->setRange(1, kMostHoles);
    m_around->setValue(grid.around);
    m_along->setValue(grid.along);
    for (QDoubleSpinBox* box : {m_first, m_last}) {
        box->setRange(-1000.0, 1000.0);
        box->setDecimals(2);
        box->setSuffix(QStringLiteral("\u00a0mm"));
    }
    m_first->setValue(1e3 * grid.first_z_m);
    m_last->setValue(1e3 * grid.last_z_m);
    m_angle->setRange(-360.0, 360.0);
    m_angle->setDecimals(2);
    m_angle->setSuffix(QStringLiteral("\u00b0"));
    m_angle->setValue(kDegrees * grid.firstAngle_rad);
    m_angle->setToolTip(tr("Angle of the first hole of each ring, from the x axis towards y"));

    auto* form = new QFormLayout;
    form->addRow(tr("Camera or &video:"), m_source);
    form->addRow(tr("Holes per &ring:"), m_around);
    form->addRow(tr("Ri&ngs:"), m_along);
    form->addRow(tr("&First ring at z ="), m_first);
    form->addRow(tr("&Last ring at z ="), m_last);
    form->addRow(tr("An&gle of the first hole:"), m_angle);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    m_accept = buttons->button(QDialogButtonBox::Ok);
    m_accept->setText(tr("&Probe"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    const auto check = [this] { m_accept->setEnabled(!source().isEmpty()); };
    connect(m_source, &CameraSourceField::changed, this, check);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addStretch(1);
    layout->addWidget(buttons);
    check();
}

QString LiveProbingDialog::source() const {
    return m_source->source();
}

vision::HoleGrid LiveProbingDialog::grid() const {
    return {.around = m_around->value(),
            .along = m_along->value(),
            .first_z_m = 1e-3 * m_first->value(),
            .last_z_m = 1e-3 * m_last->value(),
            .firstAngle_rad = m_angle->value() / kDegrees};
}

camera::CameraConfig probingCamera(const QString& source, const vision::CalibrationSettings& settings) {
    camera::CameraConfig config;
    config.source = source.toStdString();
    config.width_px = settings.width_px;
    config.height_px = settings.height_px;
    return config;
}

LiveProbing::Opener cameraOpener(const QString& source, const vision::CalibrationSettings& settings) {
    return
        [config = probingCamera(source, settings)]() -> core::Expected<std::unique_ptr<core::CameraSource>> {
            TELETA_TRY(auto feed, camera::CameraDevice::open(config));
            return std::unique_ptr<core::CameraSource>(std::move(feed));
        };
}

} // namespace teleta::console
