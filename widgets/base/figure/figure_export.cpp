// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/figure/figure_export.h"

#include "widgets/base/file_dialog.h"

#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QMenu>
#include <QMimeData>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QStandardPaths>
#include <QSvgGenerator>
#include <QWidget>

namespace teleta::base {

namespace {

constexpr int kScreen_dpi = 96;

core::Unexpected writeError(const QString& path, const QString& reason) {
    const QString message =
        QCoreApplication::translate("FigureExport", "The file could not be written: %1").arg(reason);
    return core::Unexpected(
        core::Error{core::ErrorKind::ioFailed, message.toStdString(), {}, {path.toStdString()}});
}

void paintSvg(const Figure& figure, QIODevice& device) {
    if (!figure.svg.isEmpty()) {
        device.write(figure.svg);
        return;
    }
    QSvgGenerator svg;
    svg.setOutputDevice(&device);
    svg.setResolution(kScreen_dpi);
    svg.setTitle(figure.name);
    svg.setSize(figure.size_px.toSize());
    svg.setViewBox(QRectF(QPointF(), figure.size_px));
    QPainter painter(&svg);
    figure.paint(painter);
}

void paintPdf(const Figure& figure, QIODevice& device) {
    constexpr double kPointsPerPixel = 72.0 / kScreen_dpi;
    QPdfWriter pdf(&device);
    pdf.setTitle(figure.name);
    pdf.setCreator(QCoreApplication::applicationName());
    pdf.setResolution(kScreen_dpi);
    pdf.setPageLayout(
        QPageLayout(QPageSize(figure.size_px * kPointsPerPixel, QPageSize::Point, {}, QPageSize::ExactMatch),
                    QPageLayout::Portrait, QMarginsF()));
    QPainter painter(&pdf);
    figure.paint(painter);
}

QImage imageOf(const Figure& figure) {
    constexpr int kScale = 2;
    QImage image((figure.size_px * kScale).toSize(), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(kScale);
    image.setDotsPerMeterX(qRound(kScale * kScreen_dpi / 0.0254));
    image.setDotsPerMeterY(image.dotsPerMeterX());
    image.fill(Qt::white);
    QPainter painter(&image);
    figure.paint(painter);
    return image;
}

/// Calls write(device) on a temporary file, which is renamed once everything is written.
template <typename Write>
core::Expected<void> writeWhole(const QString& path, Write&& write) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return writeError(path, file.errorString());
    write(file);
    if (!file.commit())
        return writeError(path, file.errorString());
    return {};
}

} // namespace

core::Expected<void> saveFigure(const Figure& figure, const QString& path) {
    const QString extension = QFileInfo(path).suffix().toLower();
    if (extension == QLatin1String("svg"))
        return writeWhole(path, [&](QIODevice& device) { paintSvg(figure, device); });
    if (extension == QLatin1String("pdf"))
        return writeWhole(path, [&](QIODevice& device) { paintPdf(figure, device); });
    if (extension == QLatin1String("png"))
        return writeWhole(path, [&](QIODevice& device) { imageOf(figure).save(&device, "PNG"); });
    if (extension == QLatin1String("csv"))
        return writeWhole(path, [&](QIODevice& device) { device.write(figure.csv().toUtf8()); });
    const QString message =
        QCoreApplication::translate("FigureExport", "Unknown picture format \"%1\"").arg(extension);
    return core::Unexpected(core::Error{
        core::ErrorKind::badInput, message.toStdString(), "svg, pdf, png, csv", {path.toStdString()}});
}

void copyPicture(const Figure& figure) {
    QBuffer svg;
    svg.open(QIODevice::WriteOnly);
    paintSvg(figure, svg);
    auto* data = new QMimeData;
    data->setImageData(imageOf(figure));
    data->setData(QStringLiteral("image/svg+xml"), svg.data());
    QGuiApplication::clipboard()->setMimeData(data);
}

void copyData(const Figure& figure) {
    const QString csv = figure.csv();
    auto* data = new QMimeData;
    data->setText(csv);
    data->setData(QStringLiteral("text/csv"), csv.toUtf8());
    QGuiApplication::clipboard()->setMimeData(data);
}

FigureExport::FigureExport(QWidget* view, std::function<Figure()> make)
    : QObject(view)
    , m_view(view)
    , m_make(std::move(make)) {
}

void FigureExport::addActions(QMenu& menu) {
    menu.addAction(tr("&Copy picture"), this, [this] { copyPicture(m_make()); });
    menu.addAction(tr("Copy &data"), this, [this] { copyData(m_make()); });
    menu.addAction(tr("&Save picture…"), this, [this] { askAndSave(true); });
    menu.addAction(tr("Save da&ta…"), this, [this] { askAndSave(false); });
}

void FigureExport::addPictureActions(QMenu& menu) {
    menu.addAction(tr("&Copy picture"), this, [this] { copyPicture(m_make()); });
    menu.addAction(tr("&Save picture…"), this, [this] { askAndSave(true); });
}

void FigureExport::setContextMenu() {
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QWidget::customContextMenuRequested, this, [this](const QPoint& position) {
        auto* menu = new QMenu(m_view);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        addActions(*menu);
        menu->popup(m_view->mapToGlobal(position));
    });
}

void FigureExport::addDataActions(QMenu& menu) {
    menu.addAction(tr("Copy &data"), this, [this] { copyData(m_make()); });
    menu.addAction(tr("Save da&ta…"), this, [this] { askAndSave(false); });
}

void FigureExport::askAndSave(bool picture) {
    // Made before the dialog: what is saved is what was on the screen when the user asked.
    const Figure figure = m_make();
    const QStringList filters = picture ? QStringList{tr("SVG picture (*.svg)"), tr("PDF document (*.pdf)"),
                                                      tr("PNG picture (*.png)")}
                                        : QStringList{tr("Comma-separated values (*.csv)")};
    askToSave(m_view,
              {.title = picture ? tr("Save picture") : tr("Save data"),
               .filters = filters,
               .folder = QStandardPaths::writableLocation(picture ? QStandardPaths::PicturesLocation
                                                                  : QStandardPaths::DocumentsLocation),
               .suffix = picture ? QStringLiteral("svg") : QStringLiteral("csv"),
               .name = figure.name},
              [this, figure](const QString& path) {
                  if (const auto result = saveFigure(figure, path))
                      emit saved(QDir::toNativeSeparators(path));
                  else
                      emit failed(QString::fromStdString(core::describe(result.error())));
              });
}

} // namespace teleta::base
