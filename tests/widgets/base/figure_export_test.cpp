// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/figure/figure_export.h"

#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QGuiApplication>
#include <QImage>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>

using namespace teleta::base;
namespace core = teleta::core;

namespace {

/// A red square in the upper left of a white picture of 200 x 100.
Figure redSquare() {
    Figure figure;
    figure.name = QStringLiteral("square");
    figure.size_px = QSizeF(200, 100);
    figure.paint = [](QPainter& painter) { painter.fillRect(QRectF(10, 10, 30, 30), Qt::red); };
    figure.csv = [] { return QStringLiteral("x,y\n1,2\n"); };
    return figure;
}

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class FigureExportTest : public QObject {
    Q_OBJECT
private slots:
    void init() { QVERIFY(m_directory.isValid()); }

    void svgIsAPictureOfTheSameSizeAndContent() {
        const QString path = m_directory.filePath(QStringLiteral("a.svg"));
        QVERIFY(saveFigure(redSquare(), path));
        QSvgRenderer renderer(path);
        QVERIFY(renderer.isValid());
        QCOMPARE(renderer.viewBoxF(), QRectF(0, 0, 200, 100));
        QImage image(200, 100, QImage::Format_ARGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        renderer.render(&painter);
        painter.end();
        QCOMPARE(image.pixelColor(20, 20), QColor(Qt::red));
        QCOMPARE(image.pixelColor(100, 50), QColor(Qt::white));
    }

    void pdfHasOnePageOfTheFigureSize() {
        const QString path = m_directory.filePath(QStringLiteral("a.pdf"));
        QVERIFY(saveFigure(redSquare(), path));
        const QByteArray content = contentOf(path);
        QVERIFY(content.startsWith("%PDF-"));
        const QRegularExpressionMatch box =
            QRegularExpression(QStringLiteral("/MediaBox \\[0 0 ([0-9.]+) ([0-9.]+)\\]"))
                .match(QString::fromLatin1(content));
        QVERIFY(box.hasMatch());
        QCOMPARE(box.captured(1).toDouble(), 150.0); // 200 px at 96 dots per inch
        QCOMPARE(box.captured(2).toDouble(), 75.0);
        QCOMPARE(content.count("/Type /Page\n"), qsizetype(1));
    }

    void pngIsSharpAtTwiceTheSize() {
        const QString path = m_directory.filePath(QStringLiteral("a.png"));
        QVERIFY(saveFigure(redSquare(), path));
        const QImage image(path);
        QCOMPARE(image.size(), QSize(400, 200));
        QCOMPARE(image.pixelColor(40, 40), QColor(Qt::red));
        QCOMPARE(image.pixelColor(300, 100), QColor(Qt::white));
    }

    void csvIsWhatTheFigureSays() {
        const QString path = m_directory.filePath(QStringLiteral("a.csv"));
        QVERIFY(saveFigure(redSquare(), path));
        QCOMPARE(contentOf(path), QByteArray("x,y\n1,2\n"));
    }

    void aFolderThatIsNotThereIsAnErrorWithThePath() {
        const QString path = m_directory.filePath(QStringLiteral("missing/a.svg"));
        const auto result = saveFigure(redSquare(), path);
        QVERIFY(!result);
        QCOMPARE(result.error().kind, core::ErrorKind::ioFailed);
        QCOMPARE(QString::fromStdString(result.error().where.file), path);
        QVERIFY(!QFile::exists(path));
    }

    void aFormatThatIsNotKnownIsRefused() {
        const auto result = saveFigure(redSquare(), m_directory.filePath(QStringLiteral("a.bmp")));
        QVERIFY(!result);
        QCOMPARE(result.error().kind, core::ErrorKind::badInput);
        QVERIFY(!QFile::exists(m_directory.filePath(QStringLiteral("a.bmp"))));
    }

    void copyingPutsPictureOrDataOnTheClipboard() {
        copyPicture(redSquare());
        const QMimeData* picture = QGuiApplication::clipboard()->mimeData();
        QVERIFY(picture->hasImage());
        QCOMPARE(qvariant_cast<QImage>(picture->imageData()).size(), QSize(400, 200));
        QVERIFY(picture->data(QStringLiteral("image/svg+xml")).contains("<svg"));
        copyData(redSquare());
        QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("x,y\n1,2\n"));
    }

    void theMenuHasTheFourActionsAndSavesWithoutBlocking() {
        QWidget view;
        FigureExport exporter(&view, redSquare);
        QMenu menu;
        exporter.addActions(menu);
        QCOMPARE(menu.actions().size(), qsizetype(4));
        QSignalSpy saved(&exporter, &FigureExport::saved);
        QSignalSpy failed(&exporter, &FigureExport::failed);
        menu.actions().at(2)->trigger();
        auto* dialog = view.findChild<QFileDialog*>();
        QVERIFY(dialog);
        const QString path = m_directory.filePath(QStringLiteral("chosen.svg"));
        emit dialog->fileSelected(path);
        QCOMPARE(saved.size(), qsizetype(1));
        QVERIFY(QSvgRenderer(path).isValid());
        emit dialog->fileSelected(m_directory.filePath(QStringLiteral("missing/chosen.svg")));
        QCOMPARE(failed.size(), qsizetype(1));
        dialog->close();
    }

private:
    QTemporaryDir m_directory;
};

static const teleta::test::Registration<FigureExportTest> registration;

#include "figure_export_test.moc"
