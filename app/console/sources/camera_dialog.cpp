// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/camera_dialog.h"

#include "devices/camera/camera_device.h"
#include "widgets/base/compose.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/theme.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace teleta::console {

CameraDialog::CameraDialog(const app::CameraRequest& last, QWidget* parent,
                           const CameraSourceField::Lister& cameras)
    : QDialog(parent)
    , m_source(new CameraSourceField(QString::fromStdString(last.source), cameras))
    , m_model(base::named<QLineEdit>("cameraModel", QString::fromStdString(last.modelPath)))
    , m_loop(new QCheckBox(tr("&Start again at the end"))) {
    setWindowTitle(tr("Open camera"));
    m_model->setToolTip(tr("The camera file that the page Calibrate or teleta calibrate has written; without "
                           "one the camera is only looked at"));
    m_model->setPlaceholderText(tr("none: only show the picture"));
    m_loop->setChecked(last.loop);
    m_model->setMinimumWidth(base::em(this, 24));

    auto* choose = new QToolButton;
    choose->setText(tr("\u2026"));
    choose->setToolTip(tr("Choose a camera file"));
    choose->setAccessibleName(choose->toolTip());
    connect(choose, &QToolButton::clicked, this, &CameraDialog::chooseModel);
    auto* model = new QHBoxLayout;
    model->addWidget(m_model, 1);
    model->addWidget(choose);
    auto* form = new QFormLayout;
    form->addRow(tr("Camera or &video:"), m_source);
    base::addFormRow(*form, tr("Ca&libration:"), model, m_model);
    form->addRow(QString(), m_loop);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    m_accept = buttons->button(QDialogButtonBox::Open);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addStretch(1);
    layout->addWidget(buttons);
    connect(m_source, &CameraSourceField::changed, this, &CameraDialog::check);
    connect(m_model, &QLineEdit::textChanged, this, &CameraDialog::check);
    check();
}

app::CameraRequest CameraDialog::request() const {
    return {.source = m_source->source().toStdString(),
            .modelPath = m_model->text().trimmed().toStdString(),
            .loop = m_loop->isChecked()};
}

app::SourceRequest CameraDialog::sourceRequest() const {
    app::CameraRequest asked = request();
    if (!asked.modelPath.empty())
        return asked;
    return app::SceneCameraRequest{.source = std::move(asked.source), .loop = asked.loop};
}

void CameraDialog::check() {
    const app::CameraRequest asked = request();
    m_accept->setEnabled(!asked.source.empty());
    m_loop->setEnabled(!camera::isCameraNumber(asked.source));
}

void CameraDialog::chooseModel() {
    base::askToOpen(this,
                    {.title = tr("Camera file"),
                     .filters = {tr("Camera files (*.json)")},
                     .folder = QFileInfo(m_model->text()).path()},
                    [this](const QString& path) { m_model->setText(path); });
}

} // namespace teleta::console
