// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/theme.h"
#include "widgets/view3d/scene_overlay.h"

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QTest>

#include <cstddef>

using namespace teleta;
using namespace teleta::view3d;

namespace {

constexpr int kContacts = 10;

QImage painted(const OverlayContent& content, const QSize& size) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(content.colours.backgroundTop);
    QPainter painter(&image);
    paintOverlay(painter, image.size(), content);
    return image;
}

/// Where two pictures of one size differ.
QRect difference(const QImage& a, const QImage& b) {
    QRect found;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            if (a.pixel(x, y) != b.pixel(x, y))
                found |= QRect(x, y, 1, 1);
    return found;
}

/// An array with axes, a colour bar and the longest legend of one on an arm.
OverlayContent array(bool dark) {
    OverlayContent content;
    content.font = QApplication::font();
    content.colours = SceneColours(base::designedPalette(dark));
    content.loadRange = 2.0;
    content.loadUnit = QStringLiteral("counts");
    content.array = QPointF(0.5, 0.6);
    content.orientationShown = true;
    content.orientation = {{{0.8, -0.3, 0.5}, {0.6, 0.4, -0.7}, {0.0, 0.9, 0.5}}};
    content.legend = {{QStringLiteral("Cylinder: radius 30 mm, length 220 mm")},
                      {QStringLiteral("Force, longest arrow: 80 counts"), LegendLine::Arrow::straight},
                      {QStringLiteral("Moment, longest arrow: 5 mNm"), LegendLine::Arrow::turned},
                      {QStringLiteral("Grid: 20 mm")}};
    return content;
}

void addContacts(OverlayContent& content, double lowest) {
    for (int i = 0; i < kContacts; ++i) {
        // In two rows, the lower one right above the legend.
        const QPointF place(0.25 + 0.13 * (i % 5), i < 5 ? lowest : lowest - 0.17);
        content.labels.push_back({place, QStringLiteral("%1: 35.%1 counts").arg(i),
                                  QColor::fromHsv(36 * i, 255, 200), true, true});
    }
}

} // namespace

/// At the sizes that the view has in a window of 1024 x 700: of an array alone, and of one on an arm.
class SceneOverlayTest : public QObject {
    Q_OBJECT

    static void sizes() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("dark");
        for (const QSize size : {QSize(313, 234), QSize(285, 240)})
            for (const bool dark : {false, true})
                QTest::addRow("%d, %s", size.width(), dark ? "dark" : "light") << size << dark;
    }

private slots:
    void tenContactsKeepTheirLabelsOffTheLegend_data() { sizes(); }
    void tenContactsKeepTheirLabelsOffTheLegend() {
        QFETCH(QSize, size);
        QFETCH(bool, dark);
        OverlayContent content = array(dark);
        const QImage without = painted(content, size);
        OverlayContent bare = content;
        bare.legend.clear();
        const QRect legend = difference(without, painted(bare, size));
        QVERIFY(legend.height() > 4 * QFontMetrics(content.font).height() / 2);
        QVERIFY(QRect(QPoint(), size).contains(legend));
        addContacts(content, (legend.top() - 2.0) / size.height());
        const QImage with = painted(content, size);
        QCOMPARE(with.copy(legend), without.copy(legend));
        // Each is there: another number is seen.
        for (std::size_t i = 0; i < content.labels.size(); ++i) {
            OverlayContent other = content;
            other.labels[i].text.replace(QStringLiteral("35"), QStringLiteral("53"));
            QVERIFY2(painted(other, size) != with, qPrintable(content.labels[i].text));
        }
    }

    void aLineOfTheLegendIsReadToItsEnd_data() { sizes(); }
    void aLineOfTheLegendIsReadToItsEnd() {
        QFETCH(QSize, size);
        QFETCH(bool, dark);
        const OverlayContent content = array(dark);
        const QImage whole = painted(content, size);
        for (std::size_t i = 0; i < content.legend.size(); ++i) {
            OverlayContent other = content;
            other.legend[i]
                .text.replace(QStringLiteral(" mm"), QStringLiteral(" cm"))
                .replace(QStringLiteral("mNm"), QStringLiteral("kNm"))
                .replace(QStringLiteral("counts"), QStringLiteral("county"));
            QVERIFY(other.legend[i].text != content.legend[i].text);
            QVERIFY2(painted(other, size) != whole, qPrintable(content.legend[i].text));
        }
    }
};

QTEST_MAIN(SceneOverlayTest)
#include "scene_overlay_test.moc"
