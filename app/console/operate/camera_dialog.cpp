// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/camera_dialog.h"

#include "devices/camera/camera_feed.h"
#include "widgets/base/form_row.h"
#include "widgets/base/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace teleta::console {

CameraDialog::CameraDialog(const CameraRequest& last, const QStringList& cameras, QWidget* parent)
    : QDialog(parent)
    , m_source(new QComboBox)
    , m_model(new QLineEdit(QString::fromStdString(last.modelPath)))
    , m_loop(new QCheckBox(tr("Start &again at the end"))) {
    setWindowTitle(tr("Open camera"));
    m_source->setObjectName(QStringLiteral("cameraSource"));
    m_model->setObjectName(QStringLiteral("cameraModel"));
    m_source->setEditable(true);
    m_source->addItems(cameras);
    m_source->setCurrentText(QString::fromStdString(last.source));
    if (last.source.empty() && !cameras.isEmpty())
        m_source->setCurrentIndex(0);
    m_source->setToolTip(tr("The number of a connected camera (0 is /dev/video0), or a video file"));
    m_model->setToolTip(tr("The camera file that the page Calibrate or teleta calibrate has written"));
    m_loop->setChecked(last.loop);
    m_model->setMinimumWidth(base::em(this, 24));

    auto* form = new QFormLayout;
    const auto addRow = [this, form](const QString& text, QWidget* field, const QString& toolTip,
                                     auto chosen) {
        auto* button = new QToolButton;
        button->setText(tr("\u2026"));
        button->setToolTip(toolTip);
        button->setAccessibleName(toolTip);
        connect(button, &QToolButton::clicked, this, chosen);
        auto* row = new QHBoxLayout;
        row->addWidget(field, 1);
        row->addWidget(button);
        base::addFormRow(*form, text, row, field);
    };
    addRow(tr("&Camera or video:"), m_source, tr("Choose a video"), [this] {
        choose(tr("Video of a camera"), tr("Videos and pictures (*)"),
               [this](const QString& path) { m_source->setCurrentText(path); });
    });
    addRow(tr("Ca&libration:"), m_model, tr("Choose a camera file"), [this] {
        choose(tr("Camera file"), tr("Camera files (*.json)"),
               [this](const QString& path) { m_model->setText(path); });
    });
    form->addRow(QString(), m_loop);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    m_accept = buttons->button(QDialogButtonBox::Open);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addStretch(1);
    layout->addWidget(buttons);
    connect(m_source, &QComboBox::currentTextChanged, this, &CameraDialog::check);
    connect(m_model, &QLineEdit::textChanged, this, &CameraDialog::check);
    check();
}

CameraRequest CameraDialog::request() const {
    return {.source = m_source->currentText().trimmed().toStdString(),
            .modelPath = m_model->text().trimmed().toStdString(),
            .loop = m_loop->isChecked()};
}

QStringList CameraDialog::connectedCameras() {
    constexpr qsizetype kPrefix = 5;
    std::vector<int> numbers;
    for (const QString& name :
         QDir(QStringLiteral("/dev")).entryList({QStringLiteral("video*")}, QDir::System | QDir::Files)) {
        bool ok = false;
        if (const int number = name.mid(kPrefix).toInt(&ok); ok)
            numbers.push_back(number);
    }
    std::ranges::sort(numbers);
    QStringList cameras;
    for (const int number : numbers)
        cameras << QString::number(number);
    return cameras;
}

void CameraDialog::check() {
    const CameraRequest asked = request();
    m_accept->setEnabled(!asked.source.empty() && !asked.modelPath.empty());
    m_loop->setEnabled(!camera::isCameraNumber(asked.source));
}

void CameraDialog::choose(const QString& title, const QString& filter,
                          const std::function<void(const QString&)>& take) {
    auto* dialog = new QFileDialog(this, title, QFileInfo(m_model->text()).path(), filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, take);
    dialog->open();
}

} // namespace teleta::console
