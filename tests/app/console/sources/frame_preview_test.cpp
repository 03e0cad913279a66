// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/frame_dialog.h"
#include "app/console/sources/frame_preview.h"
#include "app/console/sources/known_array.h"
#include "backend/frames/frame_reader.h"
#include "backend/frames/npz_writer.h"
#include "widgets/base/colour_maps.h"

#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSlider>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

using namespace teleta;
using console::FrameDialog;
using console::FramePreview;

namespace {

constexpr int kPatience_ms = 30'000;

} // namespace

/// The first frames of a file, while a person says how it is to be read.
class FramePreviewTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        QFile table(m_folder.filePath(QStringLiteral("other.csv")));
        QVERIFY(table.open(QIODevice::WriteOnly));
        table.write("stamp_s,a,b,c,d,e,f\n0,0,1,2,3,4,10\n0.5,10,1,2,3,4,nan\n");
    }

    void init() {
        m_preview = std::make_unique<FramePreview>();
        m_preview->resize(400, 400);
        m_preview->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_preview.get()));
    }

    void showsEachFrameInColours() {
        m_preview->setRequest(request(2));
        QTRY_COMPARE_WITH_TIMEOUT(text("about"), QStringLiteral("2 frame(s) of 2 \u00d7 3 taxels, 0 to 10"),
                                  kPatience_ms);
        QVERIFY(!m_preview->findChild<QLabel*>(QStringLiteral("problem"))->isVisible());
        QCOMPARE(taxel(0, 0), QColor(base::cividis().front()));
        QCOMPARE(taxel(1, 2), QColor(base::cividis().back()));
        auto* slider = m_preview->findChild<QSlider*>(QStringLiteral("frame"));
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(taxel(0, 0), QColor(base::cividis().back()));
        QCOMPARE(taxel(1, 2).rgb(), m_preview->palette().color(QPalette::Mid).rgb());
    }

    void theLastRequestIsShown() {
        m_preview->setRequest(request(2));
        m_preview->setRequest(request(3));
        QTRY_VERIFY_WITH_TIMEOUT(text("about").contains(QStringLiteral("of 3 \u00d7 2 taxels")),
                                 kPatience_ms);
    }

    void whatCannotBeReadSaysWhy() {
        frames::FrameRequest wrong = request(4);
        m_preview->setRequest(wrong);
        QTRY_COMPARE_WITH_TIMEOUT(text("about"), QStringLiteral("No frame to show."), kPatience_ms);
        QVERIFY2(text("problem").startsWith(QStringLiteral("other.csv")), qPrintable(text("problem")));
        // And is right again after a change.
        m_preview->setRequest(request(2));
        QTRY_VERIFY_WITH_TIMEOUT(text("about").startsWith(QStringLiteral("2 frame")), kPatience_ms);
        QVERIFY(!m_preview->findChild<QLabel*>(QStringLiteral("problem"))->isVisible());
    }

    void framesWithoutTimesAreShownAndTheTimesAskedFor() {
        frames::FrameRequest untimed = request(2);
        untimed.timeColumn.clear();
        m_preview->setRequest(untimed);
        QTRY_VERIFY_WITH_TIMEOUT(text("about").startsWith(QStringLiteral("2 frame")), kPatience_ms);
        QVERIFY(m_preview->findChild<QLabel*>(QStringLiteral("problem"))->isVisible());
        QVERIFY2(!text("problem").contains(QStringLiteral("--")), "options are of the command line");
        untimed.rate_Hz = 100.0;
        m_preview->setRequest(untimed);
        QTRY_VERIFY_WITH_TIMEOUT(!m_preview->findChild<QLabel*>(QStringLiteral("problem"))->isVisible(),
                                 kPatience_ms);
    }

    /// Every file below leaves something open that a field of the dialog asks for.
    void theDialogSpeaksOfItsFields_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("asks");
        QTest::newRow("shape") << QStringLiteral("flat.npz") << QStringLiteral("or others");
        QTest::newRow("grid or vectors")
            << QStringLiteral("ambiguous.npz") << QStringLiteral("for the grid, 4 rows and 3 columns");
        QTest::newRow("axis") << QStringLiteral("packed.mat")
                              << QStringLiteral(
                                     "the dimension that counts the frames, the first or the last");
        QTest::newRow("table") << QStringLiteral("other.csv")
                               << QStringLiteral("which columns are times and taxels");
    }

    void theDialogSpeaksOfItsFields() {
        QFETCH(const QString, file);
        QFETCH(const QString, asks);
        frames::FrameRequest open;
        open.path = file.endsWith(QStringLiteral(".mat"))
                        ? TELETA_SOURCE_DIR "/tests/data/frames/" + file.toStdString()
                        : m_folder.filePath(file).toStdString();
        if (!file.endsWith(QStringLiteral(".csv")))
            open.rate_Hz = 100.0;
        const std::vector<float> values(24, 1.0F);
        const std::array flat{frames::NpzArray("frames", {2, 12}, std::span(values))};
        const std::array ambiguous{frames::NpzArray("frames", {2, 4, 3}, std::span(values))};
        if (file == QStringLiteral("flat.npz"))
            QVERIFY(frames::writeNpz(open.path, flat));
        if (file == QStringLiteral("ambiguous.npz"))
            QVERIFY(frames::writeNpz(open.path, ambiguous));
        const auto refused = frames::readFrames(open);
        QVERIFY(!refused);
        const QString why = QString::fromStdString(describe(refused.error()));
        QVERIFY2(why.contains(QStringLiteral("--")), "the command line names its options");
        const FrameDialog dialog(open, why);
        const QString shown = dialog.findChild<QLabel*>(QStringLiteral("why"))->text();
        QVERIFY2(shown.contains(asks) && !shown.contains(QStringLiteral("--")), qPrintable(shown));
    }

    /// Of a translation with wide brackets, and of a column whose name has brackets.
    void optionsInBracketsAreLeftOut() {
        QCOMPARE(console::withoutOptions(
                     QString::fromUtf8("\xe6\x96\x87\xef\xbc\x88--layout FILE.toml\xef\xbc\x89\xe3\x80\x82")),
                 QString::fromUtf8("\xe6\x96\x87\xe3\x80\x82"));
        QCOMPARE(console::withoutOptions(QStringLiteral("columns (--columns 2..3 --time-column t(s)).")),
                 QStringLiteral("columns."));
    }

    void theDialogShowsWhatItsFieldsSay() {
        frames::FrameRequest open;
        open.path = request(2).path;
        FrameDialog dialog(open, QStringLiteral("why"));
        dialog.show();
        auto* about = dialog.findChild<QLabel*>(QStringLiteral("about"));
        QTRY_COMPARE_WITH_TIMEOUT(about->text(), QStringLiteral("No frame to show."), kPatience_ms);
        QTest::keyClicks(dialog.findChild<QLineEdit*>(QStringLiteral("taxelColumns")),
                         QStringLiteral("2..7"));
        dialog.findChild<QSpinBox*>(QStringLiteral("rows"))->setValue(3);
        QTest::keyClicks(dialog.findChild<QLineEdit*>(QStringLiteral("timeColumn")),
                         QStringLiteral("stamp_s"));
        QTRY_VERIFY_WITH_TIMEOUT(about->text().startsWith(QStringLiteral("2 frame(s) of 3 \u00d7 2")),
                                 kPatience_ms);
    }

    /// Frames x taxels x 3, which a file of the array explains; off a grid.
    void aFileOfTheArrayExplainsVectors() {
        frames::FrameRequest open;
        open.path = m_folder.filePath(QStringLiteral("vectors.npz")).toStdString();
        open.rate_Hz = 100.0;
        const std::vector<float> values{1, 2, -3, 4, 5, -6, 7, 8, -9, 0, 0, 0, 0, 0, 0, 0, 0, -12};
        const std::array arrays{frames::NpzArray("field", {2, 3, 3}, std::span(values))};
        QVERIFY(frames::writeNpz(open.path, arrays));
        QFile skin(m_folder.filePath(QStringLiteral("skin.toml")));
        QVERIFY(skin.open(QIODevice::WriteOnly));
        skin.write("threshold = 2.0\n[layout]\nunit = 'uT'\ncomponents = 3\n"
                   "positions_mm = [[0, 0], [7, 1], [2, 9]]\n");
        skin.close();
        FrameDialog dialog(open, QStringLiteral("why"));
        dialog.show();
        auto* about = dialog.findChild<QLabel*>(QStringLiteral("about"));
        QTRY_COMPARE_WITH_TIMEOUT(about->text(), QStringLiteral("No frame to show."), kPatience_ms);
        dialog.findChild<QLineEdit*>(QStringLiteral("layout"))->setText(skin.fileName());
        QTRY_COMPARE_WITH_TIMEOUT(about->text(),
                                  QStringLiteral("2 frame(s) of 1 \u00d7 3 taxels, 0 uT to 12 uT")
                                      .replace(QStringLiteral(" uT"), QStringLiteral("\u00a0uT")),
                                  kPatience_ms);
        QVERIFY(!dialog.findChild<QSpinBox*>(QStringLiteral("rows"))->isEnabled());
        QCOMPARE(dialog.request().knownPath, skin.fileName().toStdString());
        const auto known = console::withKnownArray(dialog.request());
        QVERIFY(known && known->known);
        QVERIFY(known->threshold == 2.0);
        dialog.findChild<QLineEdit*>(QStringLiteral("layout"))->setText(QStringLiteral("/none.toml"));
        QTRY_COMPARE_WITH_TIMEOUT(about->text(), QStringLiteral("No frame to show."), kPatience_ms);
    }

    void theArraysOfAFileAreOfferedAndNoneIsGuessed() {
        frames::FrameRequest open;
        open.path = m_folder.filePath(QStringLiteral("two.npz")).toStdString();
        const std::vector<float> values(12, 1.0F);
        const std::vector<double> other(4, 1.0);
        const std::array arrays{frames::NpzArray("left", {3, 2, 2}, std::span(values)),
                                frames::NpzArray("right", {2, 3, 2}, std::span(values)),
                                frames::NpzArray("weights", {4}, std::span(other))};
        QVERIFY(frames::writeNpz(open.path, arrays));
        FrameDialog dialog(open, QStringLiteral("two (expected the name of one (--array NAME))"));
        dialog.show();
        QCOMPARE(dialog.findChild<QLabel*>(QStringLiteral("why"))->text(),
                 QStringLiteral("two (expected the name of one)"));
        auto* array = dialog.findChild<QComboBox*>(QStringLiteral("array"));
        QTRY_COMPARE_WITH_TIMEOUT(array->count(), 2, kPatience_ms);
        QCOMPARE(array->currentText(), QString());
        QCOMPARE(dialog.request().array, std::string());
        array->setFocus();
        QTest::keyClick(array, Qt::Key_Down);
        QTest::keyClick(array, Qt::Key_Down);
        QCOMPARE(dialog.request().array, std::string("right"));
        auto* about = dialog.findChild<QLabel*>(QStringLiteral("about"));
        QTRY_VERIFY_WITH_TIMEOUT(about->text().startsWith(QStringLiteral("2 frame(s) of 3 \u00d7 2")),
                                 kPatience_ms);
    }

private:
    [[nodiscard]] frames::FrameRequest request(int rows) const {
        frames::FrameRequest request;
        request.path = m_folder.filePath(QStringLiteral("other.csv")).toStdString();
        request.taxelColumns = {{2, 7}};
        request.timeColumn = "stamp_s";
        request.rows = rows;
        return request;
    }
    [[nodiscard]] QString text(const char* name) const {
        return m_preview->findChild<QLabel*>(QLatin1String(name))->text();
    }
    /// Of the 2 x 3 array, as it is painted.
    [[nodiscard]] QColor taxel(int row, int column) const {
        auto* picture = m_preview->findChild<QWidget*>(QStringLiteral("framePicture"));
        const QImage shown = picture->grab().toImage();
        const double side = std::min(shown.width() / 3.0, shown.height() / 2.0);
        return shown.pixelColor(static_cast<int>(shown.width() / 2.0 + (column - 1.0) * side),
                                static_cast<int>(shown.height() / 2.0 + (row - 0.5) * side));
    }

    QTemporaryDir m_folder;
    std::unique_ptr<FramePreview> m_preview;
};

QTEST_MAIN(FramePreviewTest)
#include "frame_preview_test.moc"
