// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/camera_source_field.h"

#include "widgets/base/background.h"
#include "widgets/base/compose.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/theme.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QToolButton>

namespace teleta::console {

CameraSourceField::CameraSourceField(const QString& last, const Lister& list, QWidget* parent)
    : QWidget(parent)
    , m_box(base::named<QComboBox>("cameraSource")) {
    m_box->setEditable(true);
    m_box->setCurrentText(last);
    m_box->setToolTip(tr("The number of a connected camera (0 is /dev/video0), or a video file"));
    m_box->setMinimumWidth(base::em(this, 12));
    m_box->setAccessibleName(tr("Camera or video"));
    setFocusProxy(m_box);
    // A label's letter leads only to what takes the focus itself.
    setFocusPolicy(m_box->focusPolicy());
    connect(m_box, &QComboBox::currentTextChanged, this, &CameraSourceField::changed);
    auto* choose = new QToolButton;
    choose->setText(tr("\u2026"));
    choose->setToolTip(tr("Choose a video"));
    choose->setAccessibleName(choose->toolTip());
    connect(choose, &QToolButton::clicked, this, &CameraSourceField::chooseVideo);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_box, 1);
    row->addWidget(choose);
    base::runInBackground(this, list,
                          [this](const std::vector<camera::CameraInfo>& cameras) { setCameras(cameras); });
}

QString CameraSourceField::source() const {
    return m_box->currentText().trimmed();
}

void CameraSourceField::setCameras(const std::vector<camera::CameraInfo>& cameras) {
    const QString wanted = m_box->currentText();
    for (const camera::CameraInfo& camera : cameras) {
        m_box->addItem(QString::number(camera.number));
        m_box->setItemData(m_box->count() - 1,
                           QString::fromStdString(camera.error ? core::describe(*camera.error) : camera.name),
                           Qt::ToolTipRole);
    }
    // What was taken the last time, or was typed in meanwhile, stays.
    if (!wanted.isEmpty())
        m_box->setCurrentText(wanted);
}

void CameraSourceField::chooseVideo() {
    const QFileInfo now(source());
    base::askToOpen(this,
                    {.title = tr("Video of a camera"),
                     .filters = {tr("Videos and pictures (*)")},
                     .folder = now.exists() ? now.path() : QString()},
                    [this](const QString& path) { m_box->setCurrentText(path); });
}

} // namespace teleta::console
