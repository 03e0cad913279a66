// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/study/results/confusion_view.h"

#include <QFile>
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>

using namespace teleta;
using study::ConfusionContent;
using study::ConfusionLayout;
using study::ConfusionView;

class ConfusionViewTest : public QObject {
    Q_OBJECT

    static ConfusionContent content() {
        ConfusionContent content;
        content.matrix = study::ConfusionMatrix(2);
        content.letters = {"A", "B"};
        content.matrix.add(0, 0, 3);
        content.matrix.add(0, std::nullopt, 1);
        content.matrix.add(1, 0, 2);
        return content;
    }

private slots:
    void itsDataHaveEveryCellWithTheTotalOfItsRow() {
        QCOMPARE(study::confusionCsv(content()), QStringLiteral("stimulus,response,count,row_total\n"
                                                                "A,A,3,4\nA,B,0,4\nA,NONE,1,4\n"
                                                                "B,A,2,2\nB,B,0,2\nB,NONE,0,2\n"));
    }

    void aCellIsFoundUnderThePointer() {
        const ConfusionLayout layout(QRectF(0, 0, 400, 400), 16.0, 2, 3);
        for (std::size_t row = 0; row < 2; ++row) {
            for (std::size_t column = 0; column < 3; ++column)
                QCOMPARE(layout.cellAt(layout.cell(row, column).center()),
                         std::optional(std::pair(row, column)));
        }
        QVERIFY(!layout.cellAt(QPointF(1, 1)));
        QVERIFY(QRectF(0, 0, 400, 400).contains(layout.grid));
    }

    void spaceAndADoubleClickChangeBetweenCountsAndPercent() {
        ConfusionView view;
        view.resize(400, 400);
        view.setContent(content());
        QTest::keyClick(&view, Qt::Key_Space);
        QVERIFY(view.content().percent);
        view.setContent(content());
        QVERIFY2(view.content().percent, "new trials leave it as it is");
        QTest::mouseDClick(&view, Qt::LeftButton);
        QVERIFY(!view.content().percent);
    }

    void isSavedInEveryFormat() {
        QTemporaryDir folder;
        ConfusionView view;
        view.setContent(content());
        const struct {
            const char* name;
            QByteArray begin;
        } files[] = {{"m.svg", "<?xml"}, {"m.pdf", "%PDF-"}, {"m.png", "\x89PNG"}, {"m.csv", "stimulus,"}};
        for (const auto& expected : files) {
            const QString path = folder.filePath(QLatin1String(expected.name));
            QVERIFY(base::saveFigure(view.figure(), path));
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            QVERIFY2(file.read(expected.begin.size()) == expected.begin, expected.name);
        }
    }

    void marksDataThatAreNotReal() {
        ConfusionView view;
        view.resize(400, 400);
        view.setContent(content());
        const QImage real = view.grab().toImage();
        ConfusionContent simulated = content();
        simulated.mode = study::Mode::simulated;
        view.setContent(simulated);
        QVERIFY(view.grab().toImage() != real);
    }

    void paintsEveryShapeOfMatrixAndSize() {
        for (const std::size_t patterns : {1U, 6U, 24U}) {
            ConfusionContent any;
            any.matrix = study::ConfusionMatrix(patterns);
            for (const QSize size : {QSize(1, 1), QSize(60, 400), QSize(900, 90)}) {
                QImage image(size, QImage::Format_ARGB32);
                QPainter painter(&image);
                study::paintConfusion(painter, image.rect(), any, QPalette());
            }
        }
    }
};

static const test::Registration<ConfusionViewTest> registration;
#include "confusion_view_test.moc"
