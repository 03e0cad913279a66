// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/live_probing_dialog.h"

#include "devices/camera/camera_feed.h"
#include "widgets/base/form_row.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <numbers>

namespace teleta::console {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr int kMostHoles = 1000; ///< a ring, and rings

} // namespace

LiveProbingDialog::LiveProbingDialog(const QString& last, const vision::HoleGrid& grid,
                                     const QStringList& cameras, QWidget* parent)
    : QDialog(parent)
    , m_source(new QComboBox)
    , m_around(new QSpinBox)
    , m_along(new QSpinBox)
    , m_first(new QDoubleSpinBox)
    , m_last(new QDoubleSpinBox)
    , m_angle(new QDoubleSpinBox) {
    setWindowTitle(tr("Probe with a camera"));
    m_source->setObjectName(QStringLiteral("probingSource"));
    m_source->setEditable(true);
    m_source->addItems(cameras);
    m_source->setCurrentText(last.isEmpty() && !cameras.isEmpty() ? cameras.front() : last);
    m_source->setToolTip(tr("The number of a connected camera (0 is /dev/video0), or a video file"));
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
    m_angle->setToolTip(tr("Of the first hole of each ring, from the x axis towards y"));

    auto* choose = new QToolButton;
    choose->setText(tr("\u2026"));
    choose->setToolTip(tr("Choose a video"));
    choose->setAccessibleName(choose->toolTip());
    connect(choose, &QToolButton::clicked, this, [this] {
        auto* dialog = new QFileDialog(this, tr("Video of a probing"), {}, tr("Videos and pictures (*)"));
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->setFileMode(QFileDialog::ExistingFile);
        connect(dialog, &QFileDialog::fileSelected, m_source, &QComboBox::setCurrentText);
        dialog->open();
    });
    auto* row = new QHBoxLayout;
    row->addWidget(m_source, 1);
    row->addWidget(choose);
    auto* form = new QFormLayout;
    base::addFormRow(*form, tr("&Camera or video:"), row, m_source);
    form->addRow(tr("Holes a &ring:"), m_around);
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
    connect(m_source, &QComboBox::currentTextChanged, this, check);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addStretch(1);
    layout->addWidget(buttons);
    check();
}

QString LiveProbingDialog::source() const {
    return m_source->currentText().trimmed();
}

vision::HoleGrid LiveProbingDialog::grid() const {
    return {.around = m_around->value(),
            .along = m_along->value(),
            .first_z_m = 1e-3 * m_first->value(),
            .last_z_m = 1e-3 * m_last->value(),
            .firstAngle_rad = m_angle->value() / kDegrees};
}

LiveProbing::Opener cameraOpener(const QString& source) {
    return [source]() -> core::Expected<std::unique_ptr<core::CameraSource>> {
        auto feed = camera::CameraFeed::open({.source = source.toStdString()});
        if (!feed)
            return core::Unexpected(feed.error());
        return std::unique_ptr<core::CameraSource>(std::move(*feed));
    };
}

} // namespace teleta::console
