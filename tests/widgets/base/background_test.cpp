// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/background.h"

#include <QImage>
#include <QPainter>
#include <QTest>

#include <latch>

using namespace teleta;

class BackgroundTest : public QObject {
    Q_OBJECT

private slots:
    // Without an end where painting waits for the pool.
    void longWorkDoesNotHoldUpPainting() {
        QThreadPool& pool = base::backgroundPool();
        std::latch end(1);
        for (int i = 0; i < 2 * pool.maxThreadCount(); ++i)
            pool.start([&end] { end.wait(); });
        QImage image(2000, 2000, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.fillRect(image.rect(), QColor(0, 0, 0, 128));
        painter.end();
        const QRgb pixel = image.pixel(1999, 1999);
        end.count_down();
        QVERIFY(pool.waitForDone(60'000));
        QVERIFY(qRed(pixel) < 255);
    }

    void theResultComesToTheThreadOfTheReceiverAndIsDroppedWithIt() {
        int got = 0;
        base::runInBackground(
            this, [] { return 42; }, [&got](int result) { got = result; });
        QTRY_COMPARE(got, 42);
        bool told = false;
        {
            QObject receiver;
            base::runInBackground(
                &receiver, [] { return 1; }, [&told](int) { told = true; });
        }
        QVERIFY(base::backgroundPool().waitForDone(60'000));
        QCoreApplication::processEvents();
        QVERIFY(!told);
    }
};

static const test::Registration<BackgroundTest> registration;
#include "background_test.moc"
