// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/source_manager.h"
#include "app/sources/source_list.h"
#include "tests/app/cli/gel_video.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <string>
#include <vector>

using namespace teleta;
using console::SourceManager;

/// A video of a flat gel, opened as the console opens it.
class GelSourceTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    std::string write(const char* name, const std::string& text) {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text.c_str()) < 0)
            qFatal("cannot write %s", name);
        return file.fileName().toStdString();
    }
    static void poll(SourceManager& sources, const auto& until) {
        QTRY_VERIFY_WITH_TIMEOUT((sources.poll(), until()), 120'000);
    }

private slots:
    void initTestCase() { QVERIFY(test::writeGelVideo(m_folder.filePath("press.avi").toStdString(), 25)); }

    void aSensorFileIsAListOfItself() {
        const std::string path = write("gel.toml", "source = \"press.avi\"\n" + std::string(test::kGelFile));
        QVERIFY(app::isSourceList(path));
        const auto alone = app::readSourceList(path);
        QVERIFY2(alone.has_value(), alone ? "" : describe(alone.error()).c_str());
        QCOMPARE(std::get<app::GelRequest>(alone->front()).path, path);
        const auto list =
            app::readSourceList(write("list.toml", "[[source]]\ngel = \"gel.toml\"\nloop = false\n"));
        QVERIFY(list.has_value());
        QCOMPARE(std::get<app::GelRequest>(list->front()).path, path);
        QVERIFY(!std::get<app::GelRequest>(list->front()).loop);
        const auto wrong =
            app::readSourceList(write("wrong.toml", "kind = \"marker_gel\"\ngrid = \"square\"\n"));
        QVERIFY(!wrong.has_value());
        QCOMPARE(wrong.error().where.line, 2);
    }

    void aVideoBecomesASourceThatShowsTheContact() {
        core::StopSwitch stop;
        SourceManager sources(stop);
        QSignalSpy failed(&sources, &SourceManager::failed);
        const std::string path = write("gel.toml", "source = \"press.avi\"\n" + std::string(test::kGelFile));
        const auto key = sources.open(app::GelRequest{path, false});
        QCOMPARE(sources.find(key)->name, QStringLiteral("gel"));
        poll(sources, [&] { return sources.find(key) == nullptr || sources.find(key)->isOpen(); });
        QCOMPARE(failed.count(), 0);
        const auto gel = sources.find(key)->gel();
        QVERIFY(gel != nullptr);
        QVERIFY(sources.find(key)->camera() == nullptr);
        QVERIFY(gel->description().recorded);
        QCOMPARE(gel->description().name, std::string("simulated"));
        QTRY_VERIFY_WITH_TIMEOUT((gel->update(), !gel->snapshot().contacts.empty()), 60'000);
        // The middle of the picture is dragged along u.
        const vision::GelContactState& contact = gel->snapshot().contacts.front();
        QVERIFY((contact.centre_m - Eigen::Vector2d(0.016, 0.012)).norm() < 0.003);
        QVERIFY(contact.shearProxy_m.x() > 0.0);
        QTRY_VERIFY_WITH_TIMEOUT(gel->status().state == core::DeviceState::finished, 60'000);
        sources.closeAll();
        QVERIFY(sources.items().empty());
    }

    void whatCannotBeOpenedIsToldWithItsFile() {
        core::StopSwitch stop;
        SourceManager sources(stop);
        std::vector<std::string> failed;
        connect(&sources, &SourceManager::failed, this, [&failed](const QString&, const core::Error& error) {
            failed.push_back(core::describe(error));
        });
        const std::string file = test::kGelFile;
        const std::array<std::string, 4> paths{write("none.toml", file),
                                               write("camera.toml", "source = \"9876\"\n" + file),
                                               write("missing.toml", "source = \"missing.avi\"\n" + file),
                                               m_folder.filePath("no.toml").toStdString()};
        const std::array<const char*, 4> told{"none.toml", "9876", "missing.avi", "no.toml"};
        for (std::size_t i = 0; i < paths.size(); ++i) {
            sources.open(app::GelRequest{paths[i]});
            poll(sources, [&] { return failed.size() == i + 1; });
            QVERIFY2(failed[i].find(told[i]) != std::string::npos, failed[i].c_str());
        }
        QVERIFY(sources.items().empty());
    }
};

QTEST_MAIN(GelSourceTest)
#include "gel_source_test.moc"
