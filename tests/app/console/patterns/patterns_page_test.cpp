// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/translation.h"
#include "app/console/patterns/export_dialog.h"
#include "app/console/patterns/import_dialog.h"
#include "app/console/patterns/patterns_page.h"
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/files/pattern_json.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "tests/app/console/bracelet/patient_bracelet.h"
#include "widgets/base/background.h"
#include "widgets/pattern/document/pattern_names.h"
#include "widgets/pattern/law_list.h"
#include "widgets/pattern/pattern_editor.h"
#include "widgets/pattern/pattern_library.h"
#include "widgets/pattern/stroke_pad.h"
#include "widgets/pattern/timeline/timeline_view.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QLockFile>
#include <QMessageBox>
#include <QMimeData>
#include <QMouseEvent>
#include <QProcess>
#include <QPushButton>
#include <QScopeGuard>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

using namespace teleta;
using namespace teleta::console;
using pattern::Pattern;

namespace {

constexpr int kPatience_ms = 60'000;
constexpr char kKeepArgument[] = "--keep-edits-in";

Pattern edited() {
    Pattern pattern;
    pattern.id = "mine.edited";
    pattern.name = "Edited";
    pattern.duration_s = 1.0;
    pattern.tracks[1] = {{0.0, 0.5}, {1.0, 0.5}};
    return pattern;
}

/// A console that backs up edits and is then killed.
int keepEdits(const QString& folder) {
    RecoveryKeeper keeper(folder);
    keeper.keep({edited(), "/home/somebody/wave.json", 1'790'000'000'000});
    return QCoreApplication::exec();
}

void draw(pattern::StrokePad& pad, const QPointF& from, const QPointF& to) {
    constexpr int kSteps = 20;
    const auto send = [&pad](QEvent::Type type, const QPointF& at, quint64 time_ms) {
        QMouseEvent event(type, at, pad.mapToGlobal(at), Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
        event.setTimestamp(time_ms);
        QApplication::sendEvent(&pad, &event);
    };
    send(QEvent::MouseButtonPress, from, 1000);
    for (int k = 1; k <= kSteps; ++k)
        send(QEvent::MouseMove, from + (to - from) * k / kSteps, 1000 + static_cast<quint64>(50 * k));
    send(QEvent::MouseButtonRelease, to, 1000 + 50 * kSteps);
}

/// Keeps the background pool busy, so that what it is given meanwhile waits until this object is gone.
class BusyPool {
public:
    BusyPool() {
        base::backgroundPool().setMaxThreadCount(1);
        base::backgroundPool().start([release = m_release] { release->acquire(); });
    }
    ~BusyPool() { m_release->release(); }
    BusyPool(const BusyPool&) = delete;
    BusyPool& operator=(const BusyPool&) = delete;

private:
    std::shared_ptr<QSemaphore> m_release = std::make_shared<QSemaphore>();
};

/// Types a path into the file dialog that is open.
bool typeInto(QWidget& parent, const QString& path) {
    auto* dialog = parent.findChild<QFileDialog*>();
    auto* line = dialog ? dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit")) : nullptr;
    if (!line)
        return false;
    line->setText(path);
    QTest::keyClick(line, Qt::Key_Return);
    return true;
}

} // namespace

/// The page with its files and a simulated bracelet.
class PatternsPageTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    core::StopSwitch m_stop;
    std::unique_ptr<BraceletService> m_station;
    std::unique_ptr<PatternCollection> m_collection;
    std::unique_ptr<PatternsPage> m_page;
    QTimer m_clock;

    [[nodiscard]] pattern::PatternDocument& document() const { return *m_page->editor().document(); }
    [[nodiscard]] QString recovery() const { return m_folder->filePath("recovery"); }
    [[nodiscard]] QTreeWidgetItem* mine() const {
        return m_page->editor().library()->findChild<QTreeWidget*>()->topLevelItem(2);
    }

    void openPage() {
        m_page.reset();
        m_collection = std::make_unique<PatternCollection>(m_folder->filePath("patterns"));
        m_page = std::make_unique<PatternsPage>(*m_station, *m_collection, recovery());
        m_page->resize(1500, 900);
        m_page->show();
        QTRY_VERIFY_WITH_TIMEOUT(m_collection->isRead(), kPatience_ms);
    }

private slots:
    void init() {
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        m_folder = std::make_unique<QTemporaryDir>();
        m_station = test::patientBracelet(m_stop);
        m_clock.disconnect();
        connect(&m_clock, &QTimer::timeout, this, [this] {
            m_station->tick();
            if (m_page)
                m_page->tick();
        });
        m_clock.start(10);
        openPage();
    }
    void builtInPatternsHaveNamesInEachLanguageAndOwnOnesKeepTheirs() {
        auto& application = *QCoreApplication::instance();
        const auto reset = qScopeGuard([&] { app::installTranslator(application, QLocale::c()); });
        for (const QLocale& language : app::availableLocales()) {
            app::installTranslator(application, language);
            for (const Pattern& pattern : pattern::builtInPatterns())
                QCOMPARE(pattern::displayName(pattern) == QString::fromStdString(pattern.name),
                         language.language() == QLocale::English);
            Pattern own = pattern::builtInPatterns().front();
            own.name = "Edited";
            QCOMPARE(pattern::displayName(own), QStringLiteral("Edited"));
        }
        app::installTranslator(application, QLocale(QLocale::French));
        QCOMPARE(pattern::displayName(*pattern::findBuiltIn("stiffness.C.dynamic")),
                 QStringLiteral("Caoutchouc, dynamique"));
    }

    void cleanup() {
        m_clock.stop();
        m_page.reset();
        m_collection.reset();
        m_station.reset();
    }

    void aStrokeIsDrawnMendedFeltExportedToHjifAndReadBack() {
        m_station->choose(BraceletChoice::simulated);
        QTRY_VERIFY_WITH_TIMEOUT(m_station->isReady(), kPatience_ms);
        pattern::PatternEditor& editor = m_page->editor();
        pattern::StrokePad& pad = *editor.findChild<pattern::StrokePad*>();
        m_page->openNew();
        // Two strokes at one time: both are points that are felt on the same motors.
        draw(pad, pad.placeOf(0.0, 0.0), pad.placeOf(2.0, 1.0));
        draw(pad, pad.placeOf(3.0, 1.0), pad.placeOf(0.5, 0.0));
        QCOMPARE(document().pattern().objects.size(), std::size_t(2));
        pattern::LawList& laws = *editor.findChild<pattern::LawList*>();
        QTRY_VERIFY_WITH_TIMEOUT(laws.isChecked() && !laws.findings().empty(), kPatience_ms);
        QVERIFY(laws.findings()[0].law == pattern::Law::sharedPhantoms);
        QVERIFY(laws.findChild<QPushButton*>("fix")->isEnabled());
        QTest::mouseClick(laws.findChild<QPushButton*>("fix"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(laws.isChecked(), kPatience_ms);
        QVERIFY(std::ranges::none_of(laws.findings(), [](const pattern::Finding& finding) {
            return finding.law == pattern::Law::sharedPhantoms;
        }));

        const Pattern drawn = document().pattern();
        QVERIFY(drawn.duration_s >= 2.0 - 1e-9);
        double strongest = 0.0;
        connect(&m_clock, &QTimer::timeout, m_page.get(), [&] {
            for (const double intensity : m_station->given())
                strongest = std::max(strongest, intensity);
        });
        QTest::keyClick(editor.timeline(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(editor.isPlaying(), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(strongest > 0.3, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!editor.isPlaying(), kPatience_ms);
        for (const double intensity : m_station->given())
            QCOMPARE(intensity, 0.0);

        const QString path = m_folder->filePath("stroke.hjif");
        QTest::keyClick(editor.timeline(), Qt::Key_E, Qt::ControlModifier);
        auto* dialog = m_page->findChild<ExportDialog*>();
        QVERIFY(dialog);
        dialog->choose(pattern::PatternFormat::hjif);
        auto* buttons = dialog->findChild<QDialogButtonBox*>();
        for (QAbstractButton* button : buttons->buttons())
            if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
                QTest::mouseClick(button, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(m_page->findChild<QFileDialog*>(), kPatience_ms);
        QVERIFY(typeInto(*m_page, path));
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), kPatience_ms);

        QTRY_VERIFY_WITH_TIMEOUT(!m_page->findChild<QDialog*>(), kPatience_ms);
        m_page->activateWindow();
        QTRY_VERIFY_WITH_TIMEOUT(m_page->isActiveWindow(), kPatience_ms);
        QTest::keyClick(editor.timeline(), Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!m_page->hasUnsaved(), kPatience_ms);
        QVERIFY(document().path().startsWith(m_folder->filePath("patterns")));
        QSignalSpy opened(&document(), &pattern::PatternDocument::patternOpened);
        m_page->open(path);
        QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 1, kPatience_ms);
        QVERIFY(document().path().isEmpty()); // edits do not go back into a format that holds less
        for (double t_s = 0.0125; t_s < drawn.duration_s; t_s += 0.025) {
            const core::Intensities before = pattern::evaluate(drawn, t_s);
            const core::Intensities after = pattern::evaluate(document().pattern(), t_s);
            // Whole milliseconds: where the intensity changes fastest, that is a few hundredths.
            for (std::size_t i = 0; i < before.size(); ++i)
                QVERIFY2(std::abs(before[i] - after[i]) < 0.05,
                         qPrintable(QStringLiteral("%1 s: %2, %3").arg(t_s).arg(before[i]).arg(after[i])));
        }
    }

    void savedPatternsAreAmongOnesOwnAndDeletedOnesComeBack() {
        m_page->openNew();
        document().setName("Slow wave");
        m_page->save();
        QTRY_COMPARE_WITH_TIMEOUT(document().path(), m_folder->filePath("patterns/slow-wave.json"),
                                  kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(mine()->childCount() == 1 && mine()->child(0)->text(0) == "Slow wave",
                                 kPatience_ms);
        const QString path = document().path();
        emit m_page->editor().library()->deleteRequested(path);
        QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(path), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(document().path().isEmpty(), kPatience_ms);
        QVERIFY(m_page->hasUnsaved()); // what is open lives on
        QTRY_VERIFY_WITH_TIMEOUT(m_collection->patterns().empty(), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(m_page->editor().library()->findChild<QPushButton*>("undo")->isVisible(),
                                 kPatience_ms);
        QTest::mouseClick(m_page->editor().library()->findChild<QPushButton*>("undo"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(m_collection->patterns().size(), std::size_t(1), kPatience_ms);
        emit m_page->editor().library()->renameRequested(path, "Fast wave");
        QTRY_VERIFY_WITH_TIMEOUT(
            m_collection->atPath(path) && m_collection->atPath(path)->name == "Fast wave", kPatience_ms);
        m_collection->undo();
        QTRY_VERIFY_WITH_TIMEOUT(m_collection->atPath(path)->name == "Slow wave", kPatience_ms);
    }

    void whatIsOpenedIsSelectedInTheLibrary() {
        auto* tree = m_page->editor().library()->findChild<QTreeWidget*>();
        const auto selected = [tree] {
            return tree->currentItem() ? tree->currentItem()->text(0) : QString();
        };
        QTreeWidgetItem* shapes = tree->topLevelItem(0);
        tree->setCurrentItem(shapes->child(0));
        const QString builtIn = shapes->child(2)->text(0);
        m_page->open(shapes->child(2)->toolTip(0)); // its id
        QTRY_COMPARE_WITH_TIMEOUT(selected(), builtIn, kPatience_ms);
        QVERIFY(tree->currentItem()->font(0).bold());

        // A file that the list comes to know later, as at the start of the program.
        pattern::Pattern own = edited();
        own.name = "Late wave";
        const QString path = m_folder->filePath("late.json");
        QVERIFY(pattern::savePattern(own, path.toStdString()));
        m_page->open(path);
        QTRY_COMPARE_WITH_TIMEOUT(document().path(), path, kPatience_ms);
        QVERIFY2(selected().isEmpty(), "no other one than what is open");
        pattern::OwnPattern listed;
        listed.path = path;
        listed.name = "Late wave";
        m_page->editor().library()->setOwn({listed});
        QCOMPARE(selected(), QStringLiteral("Late wave"));

        // A line selected meanwhile stays selected.
        tree->setCurrentItem(tree->topLevelItem(0)->child(1));
        const QString other = selected();
        m_page->editor().library()->setOwn({listed});
        QCOMPARE(selected(), other);
    }

    void aPatternIsSavedWhileItsFileIsOpenElsewhere() {
        const QString path = m_folder->filePath("patterns/wave.json");
        QVERIFY(pattern::savePattern(edited(), path.toStdString()));
        QFile reader(path);
        QVERIFY(reader.open(QIODevice::ReadOnly));
        PatternCollection collection(m_folder->filePath("patterns")); // of another console
        PatternsPage other(*m_station, collection, {});
        for (PatternsPage* page : {&other, m_page.get()}) {
            page->open(path);
            QTRY_COMPARE_WITH_TIMEOUT(page->editor().document()->path(), path, kPatience_ms);
        }
        pattern::StrokePad& pad = *m_page->editor().findChild<pattern::StrokePad*>();
        draw(pad, pad.placeOf(0.0, 0.0), pad.placeOf(2.0, 1.0));
        QTest::keyClick(m_page->editor().timeline(), Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!m_page->hasUnsaved(), kPatience_ms);
        const auto listed = [&] { return collection.atPath(path); };
        QTRY_VERIFY_WITH_TIMEOUT(listed() && listed()->objects.size() == 1, kPatience_ms);
        QVERIFY(!reader.readAll().contains("stroke")); // whole, as it was opened
        QCOMPARE(m_page->messages().count() + other.messages().count(), 0);
    }

    void filesThatAppearAreSeenAndDamagedOnesSayWhy() {
        QVERIFY(pattern::savePattern(edited(), m_folder->filePath("patterns/other.json").toStdString()));
        QTRY_COMPARE_WITH_TIMEOUT(m_collection->patterns().size(), std::size_t(1), kPatience_ms);
        QVERIFY(m_collection->program("mine.edited").evaluate);
        QVERIFY(!m_collection->program("nobody").evaluate);
        QVERIFY(m_collection->program("shape.A.static").evaluate);
        QFile damaged(m_folder->filePath("patterns/other.json"));
        QVERIFY(damaged.open(QIODevice::WriteOnly));
        damaged.write("{");
        damaged.close();
        QTRY_VERIFY_WITH_TIMEOUT(m_collection->patterns().size() == 1 && m_collection->patterns()[0].error,
                                 kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(mine()->child(0)->toolTip(0).contains("other.json"), kPatience_ms);
        QVERIFY(!m_collection->program("mine.edited").evaluate);
        QVERIFY(QFile::exists(damaged.fileName()));
    }

    void editsOfAKilledConsoleAreOfferedAndNoFileOfTheUserIsTouched() {
        m_page.reset();
        QProcess console;
        console.start(QCoreApplication::applicationFilePath(), {kKeepArgument, recovery()});
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(recovery()).entryList({"*.json"}).isEmpty(), kPatience_ms);
        openPage();
        // While it runs, its edits are its own.
        QSignalSpy found(&m_page->recovery(), &RecoveryKeeper::found);
        m_page->recovery().look();
        m_page.reset(); // ends its search, which would otherwise take what is to be found below
        QVERIFY(found.isEmpty());
        const QStringList left = QDir(recovery()).entryList({"*.json"});
        QCOMPARE(left.size(), 1);
        console.kill();
        QVERIFY(console.waitForFinished());
        QCOMPARE(console.exitStatus(), QProcess::CrashExit);
        openPage();
        auto* recover = m_page->findChild<QPushButton*>("recover");
        QTRY_VERIFY_WITH_TIMEOUT(recover->isVisible(), kPatience_ms);
        QTest::mouseClick(recover, Qt::LeftButton);
        QVERIFY(document().pattern() == edited());
        QCOMPARE(document().path(), QString("/home/somebody/wave.json"));
        QVERIFY(m_page->hasUnsaved());
        QVERIFY(!recover->isVisible());
        // The old file has gone when the edits are kept anew.
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(recovery()).exists(left.front()), kPatience_ms);
        QCOMPARE(QDir(recovery()).entryList({"*.json"}).size(), 1);
        document().markSaved("x.json");
        QTRY_VERIFY_WITH_TIMEOUT(QDir(recovery()).entryList({"*.json"}).isEmpty(), kPatience_ms);
    }

    void editsOfAConsoleThatRunsAreNotOffered() {
        RecoveryKeeper running(recovery());
        running.keep({edited(), "", 1});
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(recovery()).entryList({"*.json"}).isEmpty(), kPatience_ms);
        RecoveryKeeper other(recovery());
        QSignalSpy found(&other, &RecoveryKeeper::found);
        other.look();
        QVERIFY(!found.wait(200));
        QVERIFY(other.lost().empty());
    }

    /// In a sandbox each console has the name and process number of the previous one.
    void editsOfAKilledConsoleAreOfferedToOneOfItsNumber() {
        m_page.reset();
        QVERIFY(QDir().mkpath(recovery()));
        const QString left = QDir(recovery()).filePath("left.json");
        QVERIFY(pattern::writeRecovery(left.toStdString(), {edited(), "", 1}));
        const QString lockFile = m_folder->filePath("names-this-program.lock");
        QLockFile lock(lockFile);
        QVERIFY(lock.lock());
        QVERIFY(QFile::copy(lockFile, left + ".lock"));
        RecoveryKeeper keeper(recovery());
        QSignalSpy found(&keeper, &RecoveryKeeper::found);
        keeper.look();
        QTRY_COMPARE_WITH_TIMEOUT(found.size(), 1, kPatience_ms);
        QCOMPARE(keeper.lost().size(), std::size_t(1));
        QVERIFY(keeper.lost().front().recovered.pattern == edited());
        // Now this one has them.
        RecoveryKeeper other(recovery());
        QSignalSpy again(&other, &RecoveryKeeper::found);
        other.look();
        QVERIFY(!again.wait(200));
    }

    void unsavedEditsAreAskedAbout() {
        document().setName("Edited");
        QVERIFY(m_page->hasUnsaved());
        bool went = false;
        const auto answer = [this](QMessageBox::StandardButton button) {
            auto* box = m_page->findChild<QMessageBox*>();
            QVERIFY(box);
            QTest::mouseClick(box->button(button), Qt::LeftButton);
            QTRY_VERIFY_WITH_TIMEOUT(!m_page->findChild<QMessageBox*>(), kPatience_ms);
        };
        m_page->whenSettled([&went] { went = true; });
        answer(QMessageBox::Cancel);
        QVERIFY(!went && m_page->hasUnsaved());
        m_page->whenSettled([&went] { went = true; });
        answer(QMessageBox::Save);
        QTRY_VERIFY_WITH_TIMEOUT(went, kPatience_ms);
        QVERIFY(!m_page->hasUnsaved());
        QTRY_COMPARE_WITH_TIMEOUT(m_collection->patterns().size(), std::size_t(1), kPatience_ms);
        went = false;
        document().setName("Edited again");
        m_page->whenSettled([&went] { went = true; });
        answer(QMessageBox::Discard);
        QVERIFY(went);
        QTRY_VERIFY_WITH_TIMEOUT(QDir(recovery()).entryList({"*.json"}).isEmpty(), kPatience_ms);
    }

    void aFileThatIsReadForLongDoesNotReplaceEditsMadeMeanwhile() {
        const QString slow = m_folder->filePath("slow.json");
        QVERIFY(pattern::savePattern(edited(), slow.toStdString()));
        QSignalSpy opened(&document(), &pattern::PatternDocument::patternOpened);
        auto busy = std::make_unique<BusyPool>();
        m_page->open(slow);
        document().addPoint(0, {0.5, 0.7});
        document().setName("Mine");
        QVERIFY(m_page->hasUnsaved());
        busy.reset();
        QTRY_VERIFY_WITH_TIMEOUT(m_page->findChild<QMessageBox*>(), kPatience_ms);
        QVERIFY(opened.isEmpty());
        auto* box = m_page->findChild<QMessageBox*>();
        QTest::mouseClick(box->button(QMessageBox::Cancel), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!m_page->findChild<QMessageBox*>(), kPatience_ms);
        QVERIFY(opened.isEmpty());
        QCOMPARE(document().pattern().name, std::string("Mine"));
        QVERIFY(m_page->hasUnsaved());
        QVERIFY(document().undoStack()->canUndo());
        m_page->open(slow);
        QTRY_VERIFY_WITH_TIMEOUT(m_page->findChild<QMessageBox*>(), kPatience_ms);
        box = m_page->findChild<QMessageBox*>();
        QTest::mouseClick(box->button(QMessageBox::Discard), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(document().pattern().id, std::string("mine.edited"), kPatience_ms);
    }

    void editsThatAreDiscardedForAFileThatCannotBeOpenedAreStillThere() {
        document().addPoint(0, {0.5, 0.7});
        document().setName("Mine");
        QVERIFY(m_page->hasUnsaved());
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(recovery()).entryList({"*.json"}).isEmpty(), kPatience_ms);
        QSignalSpy opened(&document(), &pattern::PatternDocument::patternOpened);
        m_page->open(m_folder->filePath("missing.json"));
        auto* box = m_page->findChild<QMessageBox*>();
        QVERIFY(box);
        QTest::mouseClick(box->button(QMessageBox::Discard), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(m_page->messages().count(), 1, kPatience_ms);
        QVERIFY(opened.isEmpty());
        QVERIFY(m_page->hasUnsaved());
        QCOMPARE(document().pattern().name, std::string("Mine"));
        QVERIFY(!QDir(recovery()).entryList({"*.json"}).isEmpty());
    }

    void theFileThatWasAskedForLastIsTheOneThatIsShown() {
        const QString before = m_folder->filePath("before.json");
        QVERIFY(pattern::savePattern(edited(), before.toStdString()));
        Pattern other = edited();
        other.id = "mine.other";
        const QString last = m_folder->filePath("last.json");
        QVERIFY(pattern::savePattern(other, last.toStdString()));
        QSignalSpy opened(&document(), &pattern::PatternDocument::patternOpened);
        auto busy = std::make_unique<BusyPool>();
        m_page->open(before);
        m_page->open(last);
        busy.reset();
        QTRY_COMPARE_WITH_TIMEOUT(document().pattern().id, std::string("mine.other"), kPatience_ms);
        base::backgroundPool().waitForDone();
        QCoreApplication::processEvents();
        QCOMPARE(opened.size(), 1);
        QCOMPARE(document().path(), last);
    }

    void aNewPatternThatIsSavedTwiceAtOnceHasOneFileWithItsLastEdit() {
        m_page->openNew();
        document().setName("Twice");
        m_page->save();
        document().addPoint(2, {0.5, 0.25});
        m_page->save();
        QTRY_VERIFY_WITH_TIMEOUT(!m_page->hasUnsaved(), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(document().path(), m_folder->filePath("patterns/twice.json"), kPatience_ms);
        QCOMPARE(QDir(m_folder->filePath("patterns")).entryList({"*.json"}), QStringList("twice.json"));
        const auto saved = pattern::loadPattern(document().path().toStdString());
        QVERIFY(saved);
        QCOMPARE(saved->tracks[2].size(), std::size_t(1));
    }

    void aFileThatIsDroppedIsOpened() {
        const QString path = m_folder->filePath("dropped.tact");
        QVERIFY(pattern::savePattern(edited(), path.toStdString()));
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(m_page.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(m_page.get(), &drop);
        QTRY_COMPARE_WITH_TIMEOUT(pattern::evaluate(document().pattern(), 0.5)[1], 0.5, kPatience_ms);
        QMimeData other;
        other.setUrls({QUrl::fromLocalFile("/tmp/frames.csv")});
        QDragEnterEvent recording(QPoint(10, 10), Qt::CopyAction, &other, Qt::LeftButton, {});
        QApplication::sendEvent(m_page.get(), &recording);
        QVERIFY(!recording.isAccepted());
    }

    void lossesAreListedBeforeAFileIsOpened() {
        const QString path = m_folder->filePath("tap.ahap");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"Version": 1.0, "Pattern": [{"Event": {"Time": 0.5, "EventType": "HapticTransient",
            "EventParameters": [{"ParameterID": "HapticSharpness", "ParameterValue": 1.0}]}}]})");
        file.close();
        const pattern::Pattern before = document().pattern();
        m_page->open(path);
        QTRY_VERIFY_WITH_TIMEOUT(m_page->findChild<ImportDialog*>(), kPatience_ms);
        QCOMPARE(m_page->findChild<QListWidget*>("losses")->count(), 3);
        QTest::keyClick(m_page->findChild<ImportDialog*>(), Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(!m_page->findChild<ImportDialog*>(), kPatience_ms);
        QCOMPARE(document().pattern(), before);

        m_page->open(path);
        QTRY_VERIFY_WITH_TIMEOUT(m_page->findChild<ImportDialog*>(), kPatience_ms);
        auto* dialog = m_page->findChild<ImportDialog*>();
        QVERIFY(!dialog->isChanged());
        for (const char* unwanted : {"tactor1", "tactor3", "tactor4", "tactor6"})
            QTest::keyClick(dialog->findChild<QCheckBox*>(unwanted), Qt::Key_Space);
        QVERIFY(dialog->isChanged());
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open),
                          Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(pattern::evaluate(document().pattern(), 0.51),
                                  (core::Intensities{0, 1, 0, 0, 1, 0}), kPatience_ms);
        QVERIFY(document().path().isEmpty());
    }

    void aWavHoldsVibrationsUnlessBareIntensitiesAreChosen() {
        ExportDialog dialog(pattern::assumedMotors(), "x");
        QVERIFY(!dialog.samples().carrier_Hz);
        dialog.choose(pattern::PatternFormat::wav);
        QCOMPARE(dialog.samples().carrier_Hz.value_or(0.0), 250.0);
        dialog.findChild<QDoubleSpinBox*>("carrier")->setValue(100.0);
        QCOMPARE(dialog.samples().carrier_Hz.value_or(0.0), 100.0);
        QTest::keyClick(dialog.findChild<QComboBox*>("signal"), Qt::Key_Down);
        QVERIFY(!dialog.samples().carrier_Hz);
        QVERIFY(!dialog.findChild<QDoubleSpinBox*>("carrier")->isEnabled());
    }

    void samplesAreExportedWithTheRateThatWasChosen() {
        ExportDialog dialog(pattern::assumedMotors(), "x");
        dialog.choose(pattern::PatternFormat::hjif);
        QVERIFY(!dialog.findChild<QDoubleSpinBox*>("rate")->isEnabled());
        QVERIFY(!dialog.samples().rate_Hz);
        dialog.choose(pattern::PatternFormat::csv);
        QCOMPARE(dialog.ending(), QString(".csv"));
        QCOMPARE(*dialog.samples().rate_Hz, pattern::kCsvRate_Hz);
        dialog.findChild<QDoubleSpinBox*>("rate")->setValue(50.0);
        dialog.findChild<QComboBox*>("content")->setCurrentIndex(1);
        QVERIFY(dialog.samples().motors);
        const QString path = m_folder->filePath("a.csv");
        m_page->exportTo(path, dialog.samples());
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), kPatience_ms);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll().count('\n'), 101); // 2 s at 50 Hz and the header
    }
};

int main(int argc, char* argv[]) {
    QApplication application(argc, argv);
    if (argc == 3 && std::strcmp(argv[1], kKeepArgument) == 0)
        return keepEdits(QString::fromLocal8Bit(argv[2]));
    PatternsPageTest test;
    QTEST_SET_MAIN_SOURCE_PATH
    return QTest::qExec(&test, argc, argv);
}
#include "patterns_page_test.moc"
