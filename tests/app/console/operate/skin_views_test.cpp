// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sources/recording_request.h"
#include "backend/recording/recorder.h"
#include "tests/app/console/operate/operate_bench.h"
#include "tests/support/peer_process.h"
#include "widgets/chrome/message_bar.h"
#include "widgets/tactile/heatmap_view.h"

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <memory>
#include <string>
#include <utility>

using namespace teleta;

/// A skin of magnetometers, played by the board in Python, on the Operate page.
class SkinViewsTest : public test::OperateBench {
    Q_OBJECT

    QTemporaryDir m_folder;
    test::PeerProcess m_board;

    std::string write(const char* name, const std::string& text) {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text.c_str()) < 0)
            qFatal("cannot write %s", name);
        return file.fileName().toStdString();
    }

private slots:
    void init() { makePage(); }
    void cleanup() { closePage(); }

    /// The board's chips warm up by 1 K in 64 frames, and the field at each falls by 1/8 uT a frame.
    void itsLoadsAreShownInNewtonsAndItIsToldThatItHasWarmedUp() {
        m_board.start(QStringLiteral("/usr/bin/python3"),
                      {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/taxels/board.py"), QStringLiteral("pty"),
                       QStringLiteral("skin"), m_folder.filePath("port")});
        QVERIFY2(m_board.waitFor("ready ").has_value(), m_board.errors().c_str());
        write("newtons.csv", "load,signal,gain,gain_se,rest,least,greatest,scatter\n"
                             "force_n,t4_z,-0.01,0.001,0,-30,30,0.05\n");
        const std::string path =
            write("skin.toml",
                  "kind = 'magnetometers'\nname = 'skin'\npath = 'port'\nchips = 5\nformat = 'binary'\n"
                  "positions_mm = [[0, 0], [7, 0], [-7, 0], [0, 7], [0, -7]]\n"
                  "axes = ['+x', '+y', '-z']\nthreshold_uT = 40.0\nloads = 'newtons.csv'\n");
        const auto key = m_sources->open(app::TaxelsRequest{path});
        // Again and again: what comes before the port is opened is not read.
        std::string line = "write";
        for (int i = 0; i < 20; ++i)
            line += " pause:200 0-49";
        m_board.say(line);
        const auto array = [&] {
            const auto* item = m_sources->find(key);
            return item != nullptr && item->isOpen() ? item->array() : nullptr;
        };
        QVERIFY(comes([&] { return array() != nullptr && array()->newestLoads().has_value(); }));
        const std::string recorded = m_folder.filePath("run.teleta").toStdString();
        auto started = recording::Recorder::start(recorded, {});
        QVERIFY(started.has_value());
        const std::shared_ptr<recording::Recorder> recorder = std::move(*started);
        array()->record(recorder, "skin");
        auto* heatmap = m_page->findChild<tactile::HeatmapView*>();
        QVERIFY(heatmap != nullptr);
        heatmap->resize(1600, 600);
        const auto header = [&] {
            heatmap->grab();
            return heatmap->headerText();
        };
        QVERIFY(comes([&] { return header().startsWith("load "); }));
        QVERIFY2(!header().contains("extrapolated"), qPrintable(header()));
        QCOMPARE(m_page->messages().count(), 0);

        m_board.say("write 400");
        QVERIFY(comes([&] { return m_page->messages().count() == 1; }));
        QVERIFY(comes([&] { return header().contains("extrapolated"); }));
        // 0.01 N/uT of 400/8 uT above the frames of the tare.
        const QRegularExpression expected(
            QStringLiteral("^load\\s+0\\.4[5-9]\\d? \u00b1 0\\.0[67]\\d\\s?N, extrapolated, "),
            QRegularExpression::UseUnicodePropertiesOption);
        QVERIFY2(expected.match(header()).hasMatch(), qPrintable(header()));
        for (int i = 0; i < 5; ++i)
            poll();
        QCOMPARE(m_page->messages().count(), 1);
        QCOMPARE(m_page->messages().repeats(), 1);
        array()->record(nullptr, {});
        QVERIFY(recorder->stop().has_value());
        m_sources->close(key);
        m_page->messages().clear();

        // A playback tells the same.
        const auto requests = app::recordingRequestsOf(recorded);
        QVERIFY(requests.has_value());
        const auto played = m_sources->open(requests->front());
        const auto playback = [&] {
            const auto* item = m_sources->find(played);
            return item != nullptr && item->isOpen() ? item->playback() : nullptr;
        };
        QVERIFY(comes([&] { return playback() != nullptr && header().startsWith("load "); }));
        QVERIFY2(!header().contains("extrapolated"), qPrintable(header()));
        playback()->seek(playback()->position().duration_s);
        QVERIFY(comes([&] { return expected.match(header()).hasMatch(); }));
        QVERIFY(comes([&] { return m_page->messages().count() == 1; }));
    }
};

QTEST_MAIN(SkinViewsTest)
#include "skin_views_test.moc"
